//! Where a study runs.

use crate::backend::{self, Backend, BackendError, Device, Profile, Selection};

/// A backend, in each arithmetic that it has.
pub struct Machine {
    strict: Device,
    /// None on a CPU: both profiles are the same code there, and measuring it twice would only show noise.
    fast: Option<Device>,
}

impl Machine {
    /// The backend that `selection` describes; which profile it asks for does not matter.
    ///
    /// # Errors
    /// When there is no such backend, or it lacks one of the profiles.
    pub fn open(selection: &Selection) -> Result<Self, BackendError> {
        let strict = backend::select(&Selection { profile: Profile::Strict, ..selection.clone() })?;
        let fast = match &strict {
            Device::Cpu(_) => None,
            // The same one, even if another one is better that has the fast profile alone.
            Device::Gpu(gpu) => Some(Device::Gpu(Box::new(gpu.in_profile(Profile::Fast)?))),
        };
        Ok(Self { strict, fast })
    }

    /// The backends that `selections` describe, in this order. One that several describe is there once.
    ///
    /// # Errors
    /// When one of them cannot be had.
    pub fn open_all(selections: &[Selection]) -> Result<Vec<Self>, BackendError> {
        let mut machines: Vec<Self> = Vec::new();
        for selection in selections {
            let machine = Self::open(selection)?;
            if machines.iter().all(|known| known.describe() != machine.describe()) {
                machines.push(machine);
            }
        }
        Ok(machines)
    }

    /// The backend in words, as points name it.
    pub fn describe(&self) -> String {
        self.strict.describe()
    }

    /// Whether both profiles are the same code.
    pub fn has_one_arithmetic(&self) -> bool {
        self.fast.is_none()
    }

    /// The device for a profile; that for the strict one where both are the same.
    pub fn device(&mut self, profile: Profile) -> &mut Device {
        match (profile, &mut self.fast) {
            (Profile::Fast, Some(fast)) => fast,
            _ => &mut self.strict,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::backend::Choice;

    #[test]
    fn a_backend_that_is_named_twice_is_studied_once() {
        let cpu = |threads| Selection { backend: Choice::Cpu, threads, ..Selection::default() };
        let machines = Machine::open_all(&[cpu(2), cpu(1), cpu(2)]).unwrap();
        let threads: Vec<_> = machines.iter().map(Machine::describe).collect();
        assert!(
            threads.len() == 2 && threads[0].ends_with("2 threads)") && threads[1].ends_with("1 thread)")
        );
        let named = Selection { adapter: Some("x".into()), ..cpu(1) };
        assert!(matches!(Machine::open_all(&[cpu(1), named]), Err(BackendError::AdapterOfCpu { .. })));
    }

    #[test]
    fn a_cpu_has_one_arithmetic() {
        let mut cpu =
            Machine::open(&Selection { backend: Choice::Cpu, threads: 1, ..Selection::default() }).unwrap();
        assert!(cpu.has_one_arithmetic());
        assert_eq!(cpu.device(Profile::Fast).describe(), cpu.describe());
    }
}
