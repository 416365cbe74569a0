//! What wgpu reports on its own time: errors and the loss of the device, kept until the next call can tell them.

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
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let fault = match error {
                wgpu::Error::OutOfMemory { .. } => Fault::OutOfMemory,
                other => Fault::Other(other.to_string()),
            };
            errors.state(|state| state.error = state.error.take().or(Some(fault)));
        }));
        let losses = faults.clone();
        device.set_device_lost_callback(move |reason, message| {
            losses.state(|state| state.lost = Some(format!("{reason:?}: {message}")));
        });
        faults
    }

    fn state<R>(&self, act: impl FnOnce(&mut State) -> R) -> R {
        act(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
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
