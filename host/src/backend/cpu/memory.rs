//! The CPU's buffers, and what a pass may see of them during one run.

use crate::backend::arguments::Arguments;
use kernel_api::{Access, Buffer, Memory, Out};
use memmap2::MmapMut;
use std::cell::Cell;
use std::collections::{BTreeMap, HashMap};
use std::sync::atomic::{AtomicU8, AtomicU32};

/// What an output holds until it is written: a NaN, and no valid index.
const POISON: u8 = 0xff;

/// Owned memory of a buffer: whole pages, which satisfies every alignment that a record may ask for.
///
/// On Linux large ones where there are some: the walk of a ray touches a node here and a node there, and with small pages
/// each of them costs a walk through the page table, too.
pub(crate) struct Storage {
    pages: MmapMut,
    bytes: usize,
}

impl Storage {
    /// Poisoned memory of `bytes` bytes, or `None` when there is not enough.
    pub fn poisoned(bytes: usize) -> Option<Self> {
        let mut storage = Self::zeroed(bytes)?;
        storage.pages.fill(POISON);
        Some(storage)
    }

    /// Memory that holds `data`, or `None` when there is not enough.
    pub fn holding(data: &[u8]) -> Option<Self> {
        let mut storage = Self::zeroed(data.len())?;
        storage.bytes_mut().copy_from_slice(data);
        Some(storage)
    }

    fn zeroed(bytes: usize) -> Option<Self> {
        let pages = MmapMut::map_anon(bytes.max(1)).ok()?;
        #[cfg(target_os = "linux")]
        // A wish: a kernel without large pages refuses, and small ones will do.
        let _ = pages.advise(memmap2::Advice::HugePage);
        Some(Self { pages, bytes })
    }

    pub fn bytes(&self) -> &[u8] {
        &self.pages[..self.bytes]
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.pages[..self.bytes]
    }
}

/// A buffer as it is lent to a run.
enum Loan<'a> {
    Read(&'a [u8]),
    /// Taken by the one view that there may be.
    Write(Cell<Option<&'a mut [u8]>>),
    Atomic(&'a [AtomicU32]),
}

/// The buffers that one run binds.
///
/// Each was borrowed exclusively from its owner and is lent in one way only, so that views cannot overlap
/// whatever a pass asks for: what it has not declared makes it panic, which the backend reports.
pub(super) struct Lent<'a> {
    loans: HashMap<u32, Loan<'a>>,
    marks: &'a HashMap<u32, Vec<AtomicU8>>,
}

impl<'a> Lent<'a> {
    /// Lends what `arguments` (already checked) name.
    pub fn new(
        buffers: &'a mut BTreeMap<u32, Storage>,
        arguments: &Arguments,
        marks: &'a HashMap<u32, Vec<AtomicU8>>,
    ) -> Self {
        let accesses: HashMap<u32, Access> =
            arguments.buffers.iter().map(|bound| (bound.id, bound.binding.access)).collect();
        let lend = |(id, storage): (&u32, &'a mut Storage)| {
            let loan = match accesses.get(id)? {
                Access::Write => Loan::Write(Cell::new(Some(storage.bytes_mut()))),
                Access::Atomic => Loan::Atomic(atomic_words(storage.bytes_mut())),
                _ => Loan::Read(storage.bytes()),
            };
            Some((*id, loan))
        };
        Self { loans: buffers.iter_mut().filter_map(lend).collect(), marks }
    }
}

/// One mark per element of each buffer that the run writes: with them `Out` finds an element that is written
/// twice. Debug builds only, as `Out` looks at marks in debug builds only.
pub(super) fn marks(buffers: &BTreeMap<u32, Storage>, arguments: &Arguments) -> HashMap<u32, Vec<AtomicU8>> {
    let written =
        arguments.buffers.iter().filter(|b| cfg!(debug_assertions) && b.binding.access == Access::Write);
    let elements = written.filter_map(|bound| {
        let bytes = buffers.get(&bound.id)?.bytes;
        Some((bound.id, bytes / bound.binding.element_bytes.max(1) as usize))
    });
    elements
        .map(|(id, count)| (id, std::iter::repeat_with(|| AtomicU8::new(0)).take(count).collect()))
        .collect()
}

fn atomic_words(bytes: &mut [u8]) -> &[AtomicU32] {
    let words: &mut [u32] = bytemuck::cast_slice_mut(bytes);
    // SAFETY: `AtomicU32` has the size and alignment of `u32`, and the words are borrowed exclusively, so
    // that for the life of the borrow they are reached as atomics alone.
    unsafe { std::slice::from_raw_parts(words.as_mut_ptr().cast::<AtomicU32>(), words.len()) }
}

impl Memory for Lent<'_> {
    fn read<T: bytemuck::Pod>(&self, buffer: Buffer<T>) -> &[T] {
        match self.loans.get(&buffer.id) {
            Some(Loan::Read(bytes)) => bytemuck::cast_slice(bytes),
            _ => panic!("the pass reads a buffer that it does not bind for reading"),
        }
    }

    fn write<T: bytemuck::Pod>(&self, buffer: Buffer<T>) -> Out<'_, T> {
        let Some(Loan::Write(slot)) = self.loans.get(&buffer.id) else {
            panic!("the pass writes a buffer that it does not bind for writing");
        };
        let Some(bytes) = slot.take() else {
            panic!("the pass asks twice for the view of a buffer that it writes")
        };
        let marks = self.marks.get(&buffer.id).map_or(&[][..], |marks| marks);
        // SAFETY: the buffer is borrowed exclusively and its view asked for once; that invocations write
        // different elements is the contract of a pass, which debug builds check by the marks.
        unsafe { Out::new(bytemuck::cast_slice_mut(bytes), marks) }
    }

    fn atomic(&self, buffer: Buffer<u32>) -> &[AtomicU32] {
        match self.loans.get(&buffer.id) {
            Some(Loan::Atomic(words)) => words,
            _ => panic!("the pass changes a buffer that it does not bind as atomic"),
        }
    }
}
