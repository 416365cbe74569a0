//! The workgroups of a run.

use crate::backend::BackendError;
use kernel_api::Pass;

/// Workgroups of a run along x, y and z, and the invocations in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Grid {
    pub groups: [u32; 3],
    pub threads: [u32; 3],
}

impl Grid {
    /// `invocations` rounded up to whole workgroups of `P`.
    pub fn of<P: Pass>(invocations: [u32; 3]) -> Result<Self, BackendError> {
        let threads = P::THREADS;
        let groups = std::array::from_fn(|axis| invocations[axis].div_ceil(threads[axis]));
        let reachable = (0..3).all(|axis| u32::checked_mul(groups[axis], threads[axis]).is_some());
        if reachable {
            Ok(Self { groups, threads })
        } else {
            Err(BackendError::TooManyInvocations { pass: P::NAME, invocations })
        }
    }

    /// Number of workgroups; saturates.
    pub fn count(&self) -> u64 {
        self.groups.iter().fold(1, |product: u64, &groups| product.saturating_mul(groups as u64))
    }

    /// Number of invocations; saturates.
    pub fn invocations(&self) -> u64 {
        self.threads.iter().fold(self.count(), |product, &threads| product.saturating_mul(threads.into()))
    }

    /// The workgroup with number `index`, x fastest.
    #[inline(always)]
    pub fn group(&self, index: u64) -> [u32; 3] {
        let [x, y] = [self.groups[0] as u64, self.groups[1] as u64];
        [(index % x) as u32, (index / x % y) as u32, (index / x / y) as u32]
    }
}
