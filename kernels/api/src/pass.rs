//! A pass: an entry point together with the arguments of one run of it. The attribute `#[spirv]` implements it; a backend runs it.

use crate::Out;
use bytemuck::Pod;
use core::marker::PhantomData;
use core::sync::atomic::AtomicU32;
use glam::UVec3;

/// A handle to a buffer of `len` elements that lives where its backend lives. Copying it copies no data.
pub struct Buffer<T> {
    /// Which buffer of its backend.
    pub id: u32,
    /// Which backend: backends refuse the buffers of others.
    pub owner: u32,
    /// Number of elements.
    pub len: u32,
    element: PhantomData<fn() -> T>,
}

impl<T> Clone for Buffer<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Buffer<T> {}

impl<T> core::fmt::Debug for Buffer<T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "buffer {} of backend {}, {} elements", self.id, self.owner, self.len)
    }
}

impl<T> Buffer<T> {
    /// For backends: the handle of buffer `id` of backend `owner`.
    pub const fn new(owner: u32, id: u32, len: u32) -> Self {
        Self { id, owner, len, element: PhantomData }
    }

    /// The same buffer as words without a sign; for the expansion of `#[spirv]`.
    #[doc(hidden)]
    pub const fn words(self) -> Buffer<u32> {
        assert!(size_of::<T>() == 4);
        Buffer::new(self.owner, self.id, self.len)
    }
}

/// How an entry point uses a binding.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Access {
    /// One value for all invocations.
    Uniform,
    /// A few bytes pushed with the dispatch.
    Push,
    /// A slice that is only read.
    Read,
    /// A slice of which each element is written by at most one invocation.
    Write,
    /// Words (`u32` or `i32`) that any invocation may change atomically.
    Atomic,
}

/// A binding as the entry point declares it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Binding {
    /// The parameter's name.
    pub name: &'static str,
    /// Descriptor set (0 for [`Access::Push`]).
    pub set: u32,
    /// Binding in the set (0 for [`Access::Push`]).
    pub binding: u32,
    /// What is done with it.
    pub access: Access,
    /// Size of one element in bytes.
    pub element_bytes: u32,
}

/// What is bound in one run.
#[derive(Clone, Copy, Debug)]
pub enum Bound<'a> {
    /// A buffer at a binding.
    Buffer {
        /// The declaration.
        binding: Binding,
        /// Which buffer of the backend.
        id: u32,
        /// Which backend.
        owner: u32,
    },
    /// Bytes of a uniform or push constant.
    Bytes {
        /// The declaration.
        binding: Binding,
        /// The value.
        bytes: &'a [u8],
    },
    /// The bits of a specialisation constant.
    Constant {
        /// Its number.
        id: u32,
        /// Its value.
        bits: u32,
    },
}

/// A CPU's view of buffers.
///
/// `write` hands out overlapping views if asked twice for one buffer: a backend refuses a pass that binds a buffer for writing and
/// again for anything else before it asks for [`Pass::views`] (see the contract of [`Out::new`]).
pub trait Memory {
    /// The elements of a buffer that is read.
    fn read<T: Pod>(&self, buffer: Buffer<T>) -> &[T];
    /// A view of a buffer that is written.
    fn write<T: Pod>(&self, buffer: Buffer<T>) -> Out<'_, T>;
    /// The words of a buffer that is changed atomically; signed ones are handed in and out as unsigned.
    fn atomic(&self, buffer: Buffer<u32>) -> &[AtomicU32];
}

/// Which invocation of a run.
#[derive(Clone, Copy, Debug)]
pub struct Invocation {
    /// The global invocation id.
    pub id: UVec3,
    /// Number of workgroups along each axis.
    pub groups: UVec3,
}

/// An entry point with the arguments of one run.
pub trait Pass: Sync {
    /// Name of the entry point.
    const NAME: &'static str;
    /// Invocations of a workgroup along x, y and z.
    const THREADS: [u32; 3];
    /// What is bound where.
    const BINDINGS: &'static [Binding];
    /// What one invocation can see, on the CPU.
    type Views<'v>: Copy + Sync
    where
        Self: 'v;

    /// Calls `visit` for everything that this run binds.
    fn bind(&self, visit: &mut dyn FnMut(Bound<'_>));
    /// The views of this run over a CPU's memory.
    fn views<'v, M: Memory>(&'v self, memory: &'v M) -> Self::Views<'v>;
    /// Runs one invocation.
    fn invoke(views: &Self::Views<'_>, invocation: Invocation);
}
