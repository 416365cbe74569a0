//! Where passes run. A frame is a list of passes over buffers that live where the backend lives; no pass
//! knows on which backend it runs, and no backend knows what a pass computes.
//!
//! ```
//! use glam::UVec3;
//! use kernel_api::{At, Out, spirv};
//! use parallax::backend::{Backend, BackendError, Cpu};
//!
//! /// Squares numbers.
//! #[spirv(compute(threads(64)))]
//! pub fn square(
//!     #[spirv(global_invocation_id)] id: UVec3,
//!     #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] numbers: &[f32],
//!     #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] squares: Out<f32>,
//! ) {
//!     if id.x < squares.len() {
//!         squares.put(id.x, numbers.at(id.x) * numbers.at(id.x));
//!     }
//! }
//!
//! fn main() -> Result<(), BackendError> {
//!     let mut cpu = Cpu::new(0)?;
//!     let numbers = cpu.upload("numbers", &[1.0, 2.0, 3.0])?;
//!     let squares = cpu.create("squares", 3)?;
//!     cpu.run(&Square { numbers, squares }, [3, 1, 1])?;
//!     assert_eq!(cpu.read(squares)?, [1.0, 4.0, 9.0]);
//!     Ok(())
//! }
//! ```

mod arguments;
pub mod cpu;
mod device;
mod error;
pub mod gpu;
mod grid;
mod selection;
mod usage;

pub use cpu::Cpu;
pub use device::Device;
pub use error::BackendError;
pub use gpu::{AdapterReport, Gpu, adapters};
pub use selection::{Choice, Profile, Selection, select};

use bytemuck::Pod;
use kernel_api::{Buffer, Pass};
use std::sync::atomic::{AtomicU32, Ordering};

/// Something that holds buffers and runs passes over them, in the order in which they are asked for.
pub trait Backend {
    /// What this is, in words: "CPU (AVX2, 2 threads)", or the adapter and its driver.
    fn describe(&self) -> String;

    /// A buffer of `len` elements, all words of which are `0xFFFF_FFFF` (as a float: NaN) until a pass writes
    /// them.
    ///
    /// Elements are whole words (checked at compile time). `label` names the buffer in errors.
    fn create<T: Pod>(&mut self, label: &'static str, len: usize) -> Result<Buffer<T>, BackendError>;

    /// A buffer with a copy of `data`.
    fn upload<T: Pod>(&mut self, label: &'static str, data: &[T]) -> Result<Buffer<T>, BackendError>;

    /// The elements of a buffer, behind all passes that were asked for before.
    fn read<T: Pod>(&mut self, buffer: Buffer<T>) -> Result<Vec<T>, BackendError>;

    /// Gives the memory of a buffer back. Handles to it are refused from now on; releasing twice does
    /// nothing.
    fn release<T: Pod>(&mut self, buffer: Buffer<T>);

    /// Runs `pass` for `invocations` along x, y and z, rounded up to whole workgroups (so a pass guards its
    /// own extent).
    ///
    /// A buffer that the pass writes may be bound to it only once. A device may still be at it when this
    /// returns: an error of the run may be told by a later call, at the latest by [`finish`](Self::finish).
    fn run<P: Pass>(&mut self, pass: &P, invocations: [u32; 3]) -> Result<(), BackendError>;

    /// Waits until everything that was asked for is done.
    fn finish(&mut self) -> Result<(), BackendError>;

    /// How many invocations of a heavy pass one run should have at most, so that no driver's watchdog takes
    /// it for hung and the caller can show its progress.
    fn max_invocations_hint(&self) -> u32;

    /// Size in bytes of the largest buffer that a pass can bind.
    fn max_buffer_bytes(&self) -> u64;

    /// The most bytes that buffers have held at once since this was last asked, or at the first time, since the backend was made. Counted
    /// are the elements of what [`create`](Self::create) and [`upload`](Self::upload) made and [`release`](Self::release) has not given
    /// back, the same on every backend; a driver may keep more, and keep it longer.
    fn take_peak_bytes(&mut self) -> u64;

    /// Into how many rows at most a picture of `width` × `height` pixels should be cut for this backend: at
    /// least one, at most `height`, a multiple of 8 (the height of a workgroup) where possible.
    /// `bytes_per_pixel` is the element size of the largest buffer that has an element per pixel.
    fn suggested_rows(&self, width: u32, height: u32, bytes_per_pixel: u32) -> u32 {
        let fitting = self.max_buffer_bytes() / bytes_per_pixel.max(1) as u64;
        let pixels = fitting.min(self.max_invocations_hint() as u64);
        let rows = (pixels / width.max(1) as u64).clamp(1, height.max(1) as u64) as u32;
        if rows < height && rows > 8 { rows - rows % 8 } else { rows }
    }
}

/// A number that no other backend of this process has.
fn new_owner() -> u32 {
    static NEXT: AtomicU32 = AtomicU32::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// What is behind a handle, if it is a handle of `owner` to a buffer that still exists and is as large as the
/// handle says.
fn check_handle<'a, T, S>(
    what: &str,
    owner: u32,
    buffer: Buffer<T>,
    storage: Option<&'a S>,
    bytes: impl Fn(&S) -> usize,
) -> Result<&'a S, BackendError> {
    if buffer.owner != owner {
        return Err(BackendError::WrongOwner { what: what.into() });
    }
    let expected = buffer.len as usize * size_of::<T>();
    storage.filter(|s| bytes(s) == expected).ok_or_else(|| BackendError::StaleBuffer { what: what.into() })
}
