//! The CPU backend: a pass is a parallel loop over its workgroups.

pub mod instruction_set;
pub(crate) mod memory;

use crate::backend::arguments::Arguments;
use crate::backend::grid::Grid;
use crate::backend::usage::Usage;
use crate::backend::{Backend, BackendError, check_handle, new_owner};
use bytemuck::Pod;
use instruction_set::{InstructionSet, Task};
use kernel_api::{Buffer, Invocation, Pass};
use memory::{Lent, Storage};
use rayon::prelude::*;
use std::any::Any;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Invocations per run after which a caller that shows its progress wants control back.
const INVOCATIONS_HINT: u32 = 1 << 21;

/// Parts of a run per thread: enough to even out workgroups of unequal cost.
const CHUNKS_PER_THREAD: u64 = 32;

/// Runs passes natively, in a thread pool of its own.
pub struct Cpu {
    owner: u32,
    next_id: u32,
    buffers: BTreeMap<u32, Storage>,
    usage: Usage,
    pool: rayon::ThreadPool,
    instruction_set: InstructionSet,
}

impl Cpu {
    /// A backend with `threads` threads (0: one per core) that uses the machine's best instruction set.
    pub fn new(threads: usize) -> Result<Self, BackendError> {
        Self::with_instruction_set(threads, InstructionSet::best())
    }

    /// As [`new`](Self::new), with a given instruction set: results are the same, only the speed differs.
    pub fn with_instruction_set(
        threads: usize,
        instruction_set: InstructionSet,
    ) -> Result<Self, BackendError> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| BackendError::Threads { threads, message: error.to_string() })?;
        Ok(Self {
            owner: new_owner(),
            next_id: 0,
            buffers: BTreeMap::new(),
            usage: Usage::default(),
            pool,
            instruction_set,
        })
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// The instruction set in use.
    pub fn instruction_set(&self) -> InstructionSet {
        self.instruction_set
    }

    fn storage<T: Pod>(&self, what: &str, buffer: Buffer<T>) -> Result<&Storage, BackendError> {
        check_handle(what, self.owner, buffer, self.buffers.get(&buffer.id), |storage| storage.bytes().len())
    }

    /// Takes `storage` for a new buffer of `len` elements; without it there was too little memory.
    fn insert<T: Pod>(
        &mut self,
        label: &'static str,
        len: usize,
        storage: Option<Storage>,
    ) -> Result<Buffer<T>, BackendError> {
        const { assert!(size_of::<T>() > 0 && size_of::<T>().is_multiple_of(4), "elements are whole words") };
        let count = u32::try_from(len).map_err(|_| BackendError::TooLong { label, len })?;
        let out_of_memory = || BackendError::OutOfMemory {
            place: "the CPU".into(),
            what: format!("buffer `{label}` of {len} × {} bytes", size_of::<T>()),
        };
        let storage = storage.ok_or_else(out_of_memory)?;
        self.next_id += 1;
        self.usage.add(storage.bytes().len() as u64);
        self.buffers.insert(self.next_id, storage);
        Ok(Buffer::new(self.owner, self.next_id, count))
    }
}

impl Backend for Cpu {
    fn describe(&self) -> String {
        let threads = self.threads();
        let plural = if threads == 1 { "" } else { "s" };
        format!("CPU ({}, {threads} thread{plural})", self.instruction_set.name())
    }

    fn create<T: Pod>(&mut self, label: &'static str, len: usize) -> Result<Buffer<T>, BackendError> {
        self.insert(label, len, len.checked_mul(size_of::<T>()).and_then(Storage::poisoned))
    }

    fn upload<T: Pod>(&mut self, label: &'static str, data: &[T]) -> Result<Buffer<T>, BackendError> {
        self.insert(label, data.len(), Storage::holding(bytemuck::cast_slice(data)))
    }

    fn read<T: Pod>(&mut self, buffer: Buffer<T>) -> Result<Vec<T>, BackendError> {
        Ok(bytemuck::cast_slice(self.storage("read", buffer)?.bytes()).to_vec())
    }

    fn release<T: Pod>(&mut self, buffer: Buffer<T>) {
        if buffer.owner == self.owner
            && let Some(storage) = self.buffers.remove(&buffer.id)
        {
            self.usage.remove(storage.bytes().len() as u64);
        }
    }

    fn run<P: Pass>(&mut self, pass: &P, invocations: [u32; 3]) -> Result<(), BackendError> {
        let arguments = Arguments::of(pass);
        arguments.check::<P>(self.owner, |id| self.buffers.contains_key(&id))?;
        let grid = Grid::of::<P>(invocations)?;
        let marks = memory::marks(&self.buffers, &arguments);
        let lent = Lent::new(&mut self.buffers, &arguments, &marks);
        let (pool, set) = (&self.pool, self.instruction_set);
        catch_unwind(AssertUnwindSafe(|| dispatch(pass, &lent, grid, pool, set)))
            .map_err(|payload| BackendError::Panicked { pass: P::NAME, message: message(payload) })
    }

    fn finish(&mut self) -> Result<(), BackendError> {
        Ok(())
    }

    fn max_invocations_hint(&self) -> u32 {
        INVOCATIONS_HINT
    }

    fn max_buffer_bytes(&self) -> u64 {
        isize::MAX as u64
    }

    fn take_peak_bytes(&mut self) -> u64 {
        self.usage.take_peak()
    }
}

fn dispatch<P: Pass>(pass: &P, lent: &Lent<'_>, grid: Grid, pool: &rayon::ThreadPool, set: InstructionSet) {
    let views = pass.views(lent);
    let parts = pool.current_num_threads() as u64 * CHUNKS_PER_THREAD;
    let chunk = grid.count().div_ceil(parts).max(1);
    pool.install(|| {
        (0..grid.count().div_ceil(chunk)).into_par_iter().for_each(|part| {
            let (first, end) = (part * chunk, ((part + 1) * chunk).min(grid.count()));
            set.run(Workgroups::<P> { views: &views, grid, first, end });
        });
    });
}

/// Consecutive workgroups of a run: what one thread does at a time.
struct Workgroups<'a, 'v, P: Pass + 'v> {
    views: &'a P::Views<'v>,
    grid: Grid,
    first: u64,
    end: u64,
}

impl<'v, P: Pass + 'v> Task for Workgroups<'_, 'v, P> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let [threads_x, threads_y, threads_z] = self.grid.threads;
        let groups = self.grid.groups.into();
        for index in self.first..self.end {
            let [x0, y0, z0] = self.grid.group(index);
            for z in z0 * threads_z..(z0 + 1) * threads_z {
                for y in y0 * threads_y..(y0 + 1) * threads_y {
                    for x in x0 * threads_x..(x0 + 1) * threads_x {
                        P::invoke(self.views, Invocation { id: glam::UVec3::new(x, y, z), groups });
                    }
                }
            }
        }
    }
}

/// The text of a panic.
fn message(payload: Box<dyn Any + Send>) -> String {
    match payload.downcast::<String>() {
        Ok(text) => *text,
        Err(payload) => payload.downcast_ref::<&str>().copied().unwrap_or("no message").to_string(),
    }
}
