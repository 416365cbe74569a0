//! The memory of a kernel: what its entry point binds, and its own arrays.

use super::origins::Origin;
use super::{Lowering, Result};
use crate::ir::{Id, Op, Root, RootId, SourceOp, Space, Type, Value};
use crate::refusal::Reason;

/// The first argument of `__k_root`.
const READ: u32 = 0;
const WRITTEN: u32 = 1;
const UNIFORM: u32 = 2;
const PUSH: u32 = 3;
const WORKGROUP: u32 = 4;

impl Lowering<'_> {
    /// Finds the workgroup size and all roots but the tables of constants.
    pub(super) fn find_roots(&mut self) -> Result<()> {
        for id in self.source.placed() {
            match &self.source[id].op {
                Op::Source(SourceOp::Alloca(ty)) => self.add_local(id, ty),
                Op::Source(SourceOp::Call(name, arguments)) => match &**name {
                    "__k_threads" => self.threads = constants(name, arguments)?,
                    "__k_root" => self.add_bound(id, constants(name, arguments)?)?,
                    _ => {}
                },
                _ => {}
            }
        }
        self.find_atomics();
        Ok(())
    }

    fn add_local(&mut self, id: Id, ty: &Type) {
        let words = ty.size().div_ceil(4).max(1) as u32;
        let name = match &*self.source[id].name {
            "" => "a local array".to_string(),
            name => format!("the local `{name}`"),
        };
        let root = root(Space::Local, name, words, 4);
        self.made.insert(id, RootId::new(self.roots.len()));
        self.roots.push(Root { written: true, ..root });
    }

    fn add_bound(&mut self, id: Id, [kind, set, binding, size, align]: [u32; 5]) -> Result<()> {
        let space = match kind {
            READ | WRITTEN => Space::Storage { set, binding },
            UNIFORM => Space::Uniform { set, binding },
            PUSH => Space::Push,
            WORKGROUP => Space::Workgroup(binding),
            _ => return Err(Reason::Unknown(format!("the kind {kind} of `__k_root`"))),
        };
        let number = match self.roots.iter().position(|root| root.space == space) {
            Some(number) => number,
            None => {
                let name = space_name(&space);
                self.roots.push(root(space, name, size.div_ceil(4).max(1), size));
                self.roots.len() - 1
            }
        };
        self.roots[number].written |= kind == WRITTEN;
        self.roots[number].vec4 |= self.options.vec4 && kind <= WRITTEN && align % 16 == 0;
        self.made.insert(id, RootId::new(number));
        Ok(())
    }

    /// What is accessed atomically is an array of words.
    fn find_atomics(&mut self) {
        for id in self.source.placed() {
            let pointer = match &self.source[id].op {
                Op::Source(SourceOp::Atomic(_, pointer, _) | SourceOp::CompareExchange(pointer, ..)) => {
                    pointer
                }
                Op::Source(SourceOp::Load { pointer, atomic: true, .. }) => pointer,
                Op::Source(SourceOp::Store { pointer, atomic: true, .. }) => pointer,
                _ => continue,
            };
            for origin in self.origins.of(pointer) {
                // What has no root is told where it is accessed.
                let Ok(root) = self.root_of(&origin) else { continue };
                let root = &mut self.roots[root.index()];
                (root.atomic, root.vec4) = (true, false);
            }
        }
    }

    /// The root that an origin stands for.
    pub(super) fn root_of(&mut self, origin: &Origin) -> Result<RootId> {
        match origin {
            Origin::Made(id) => self.made.get(id).copied().ok_or_else(|| Reason::Unknown("a root".into())),
            Origin::Global(name) => self.table(name),
        }
    }

    /// The storage buffer at a binding.
    pub(super) fn storage(&self, set: u32, binding: u32) -> Result<RootId> {
        let found = self.roots.iter().position(|root| root.space == Space::Storage { set, binding });
        found
            .map(RootId::new)
            .ok_or_else(|| Reason::Unknown(format!("the buffer at set {set}, binding {binding}")))
    }
}

/// A root that is neither written nor atomic nor made of 128-bit elements.
pub(super) fn root(space: Space, name: String, words: u32, element_bytes: u32) -> Root {
    Root { space, name, written: false, atomic: false, vec4: false, words, element_bytes }
}

fn space_name(space: &Space) -> String {
    match space {
        Space::Storage { set, binding } => format!("the buffer at set {set}, binding {binding}"),
        Space::Uniform { set, binding } => format!("the uniform at set {set}, binding {binding}"),
        Space::Push => "the push constants".into(),
        Space::Workgroup(number) => format!("the workgroup memory {number}"),
        Space::Local | Space::Constant(_) => "memory".into(),
    }
}

/// Constant arguments of one of the functions that an entry point is made of.
pub(super) fn constants<const N: usize>(name: &str, arguments: &[Value]) -> Result<[u32; N]> {
    let words: Option<Vec<u32>> = arguments.iter().map(Value::as_u32).collect();
    words
        .and_then(|words| words.try_into().ok())
        .ok_or_else(|| Reason::Unknown(format!("a call of `{name}` with other than {N} constant arguments")))
}
