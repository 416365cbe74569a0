//! What a pass binds in one run, checked alike for all backends.

use crate::backend::BackendError;
use kernel_api::{Access, Binding, Bound, Pass};

/// A bound buffer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundBuffer {
    pub binding: Binding,
    pub id: u32,
    owner: u32,
}

/// Everything that one run of a pass binds.
#[derive(Debug, Default)]
pub(crate) struct Arguments {
    pub buffers: Vec<BoundBuffer>,
    /// Uniforms and the push constant.
    pub bytes: Vec<(Binding, Vec<u8>)>,
    /// Number and bits of each specialisation constant.
    pub constants: Vec<(u32, u32)>,
}

impl Arguments {
    /// What `pass` binds.
    pub fn of<P: Pass>(pass: &P) -> Self {
        let mut arguments = Self::default();
        pass.bind(&mut |bound| match bound {
            Bound::Buffer { binding, id, owner } => {
                arguments.buffers.push(BoundBuffer { binding, id, owner })
            }
            Bound::Bytes { binding, bytes } => arguments.bytes.push((binding, bytes.to_vec())),
            Bound::Constant { id, bits } => arguments.constants.push((id, bits)),
        });
        arguments
    }

    /// Refuses buffers of other backends than `owner`, buffers that are no more, and a written buffer that is
    /// bound twice.
    pub fn check<P: Pass>(&self, owner: u32, exists: impl Fn(u32) -> bool) -> Result<(), BackendError> {
        for bound in &self.buffers {
            let what = || format!("pass `{}`, `{}`", P::NAME, bound.binding.name);
            if bound.owner != owner {
                return Err(BackendError::WrongOwner { what: what() });
            }
            if !exists(bound.id) {
                return Err(BackendError::StaleBuffer { what: what() });
            }
        }
        self.check_aliases::<P>()
    }

    fn check_aliases<P: Pass>(&self) -> Result<(), BackendError> {
        for (i, first) in self.buffers.iter().enumerate() {
            for second in &self.buffers[i + 1..] {
                let shared =
                    first.binding.access == second.binding.access && first.binding.access != Access::Write;
                if first.id == second.id && !shared {
                    let (first, second) = (first.binding.name, second.binding.name);
                    return Err(BackendError::Aliased { pass: P::NAME, first, second });
                }
            }
        }
        Ok(())
    }
}
