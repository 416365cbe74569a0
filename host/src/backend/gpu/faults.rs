//! What wgpu reports on its own time: errors and the loss of the device, kept until the next call can tell
//! them.

use crate::backend::BackendError;
use std::sync::{Arc, Mutex, PoisonError};

/// The first error since the last call that asked, and whether the device is lost for good.
#[derive(Clone, Default)]
pub(super) struct Faults(Arc<Mutex<State>>);

#[derive(Default)]
struct State {
    error: Option<Fault>,
    lost: Option<String>,
}

enum Fault {
    OutOfMemory,
    Other(String),
}

impl Faults {
    /// Listens to `device`.
    pub fn listen(device: &wgpu::Device) -> Self {
        let faults = Self::default();
        let errors = faults.clone();
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| errors.note(error)));
        let losses = faults.clone();
        device.set_device_lost_callback(move |reason, message| {
            losses.state(|state| state.lost = Some(format!("{reason:?}: {message}")));
        });
        faults
    }

    fn state<R>(&self, act: impl FnOnce(&mut State) -> R) -> R {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Notes an error, unless there is an earlier one that nobody has asked for yet.
    fn note(&self, error: wgpu::Error) {
        let fault = match error {
            wgpu::Error::OutOfMemory { .. } => Fault::OutOfMemory,
            other => Fault::Other(other.to_string()),
        };
        self.state(|state| state.error = state.error.take().or(Some(fault)));
    }

    /// Notes that the device is gone.
    pub fn lose(&self, message: String) {
        self.state(|state| state.lost = state.lost.take().or(Some(message)));
    }

    /// The error that came up since the last call, told as one of `what` on the adapter `place`.
    pub fn check(&self, place: &str, what: impl FnOnce() -> String) -> Result<(), BackendError> {
        let (error, lost) = self.state(|state| (state.error.take(), state.lost.clone()));
        if let Some(reason) = lost {
            return Err(BackendError::DeviceLost { adapter: place.into(), reason });
        }
        match error {
            None => Ok(()),
            Some(Fault::OutOfMemory) => Err(BackendError::OutOfMemory { place: place.into(), what: what() }),
            Some(Fault::Other(message)) => Err(BackendError::Rejected { what: what(), message }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(faults: &Faults) -> String {
        faults.check("llvmpipe", || "buffer `rows`".into()).unwrap_err().to_string()
    }

    #[test]
    fn too_little_memory_is_told_once_and_a_lost_device_always() {
        let faults = Faults::default();
        assert!(faults.check("llvmpipe", String::new).is_ok());
        faults.note(wgpu::Error::OutOfMemory { source: "full".into() });
        faults.note(wgpu::Error::Internal { source: "x".into(), description: "a later error".into() });
        assert!(told(&faults).starts_with("not enough memory on llvmpipe for buffer `rows`; use a smaller"));
        assert!(faults.check("llvmpipe", String::new).is_ok());
        faults.note(wgpu::Error::Validation { source: "x".into(), description: "no such binding".into() });
        assert_eq!(told(&faults), "buffer `rows` was refused by the device: no such binding");
        faults.lose("a reset".into());
        faults.lose("another one".into());
        for _ in 0..2 {
            assert!(
                told(&faults).starts_with("`llvmpipe` was lost (a reset); drivers do that when a run takes")
            );
        }
    }
}
