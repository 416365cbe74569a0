//! A kernel that accesses every kind of memory and uses everything that invocations do together.

use super::{KernelBuilder, add, less, word};
use crate::interpret::Arguments;
use crate::ir::{
    AtomicOp, BinaryOp, BlockId, Builtin, IntPredicate, Kernel, Op, RootId, Space, SubgroupOp, Terminator,
    Type, Value,
};

/// Invocations of a workgroup.
const THREADS: u32 = 4;
/// Words that an invocation writes to the output.
const WRITTEN: u32 = 20;

/// A kernel with its arguments and the words that two workgroups of it leave at binding 0, in subgroups as
/// large as a workgroup.
pub struct Places {
    pub kernel: Kernel,
    pub arguments: Arguments,
    pub expected: Vec<u32>,
}

/// The kernel.
pub fn places() -> Places {
    let mut k = Builder::new();
    k.buffers();
    k.own_arrays();
    k.atomics();
    k.together();
    k.loop_with_a_value_that_leaves();
    k.finish()
}

struct Builder {
    k: KernelBuilder,
    roots: Roots,
    /// The current block.
    block: usize,
    /// The global id, the id in the workgroup, the first word of this invocation's output.
    id: Value,
    local: Value,
    base: Value,
    /// What invocation `(global id, local id)` writes, word by word.
    expected: Vec<fn(u32, u32) -> u32>,
}

struct Roots {
    output: RootId,
    records: RootId,
    written_records: RootId,
    uniform: RootId,
    push: RootId,
    shared: RootId,
    own: RootId,
    table: RootId,
    counters: RootId,
}

impl Builder {
    fn new() -> Self {
        let mut k = KernelBuilder::new(4);
        k.threads([THREADS, 1, 1]);
        let storage = |binding| Space::Storage { set: 0, binding };
        let roots = Roots {
            output: k.root(storage(0), true, 1),
            records: k.root(storage(1), false, 4),
            written_records: k.root(storage(2), true, 4),
            uniform: k.root(Space::Uniform { set: 0, binding: 3 }, false, 6),
            push: k.root(Space::Push, false, 3),
            shared: k.root(Space::Workgroup(0), true, THREADS),
            own: k.root(Space::Local, true, 8),
            table: k.root(Space::Constant([3, 1, 4, 1].into()), false, 4),
            counters: k.root(Space::Storage { set: 1, binding: 0 }, true, 1),
        };
        k.root_mut(roots.records).vec4 = true;
        k.root_mut(roots.written_records).vec4 = true;
        k.root_mut(roots.counters).atomic = true;
        let id = k.push(0, Op::Builtin(Builtin::GlobalInvocationId, 0), Type::I32);
        let local = k.push(0, Op::Builtin(Builtin::LocalInvocationIndex, 0), Type::I32);
        let base = k.push(0, Op::Binary(BinaryOp::Mul, id.clone(), word(WRITTEN)), Type::I32);
        Self { k, roots, block: 0, id, local, base, expected: Vec::new() }
    }

    fn make(&mut self, op: Op) -> Value {
        self.k.push(self.block, op, Type::I32)
    }

    fn perform(&mut self, op: Op) {
        self.k.push(self.block, op, Type::Void);
    }

    /// Writes the next word of this invocation's output.
    fn expect(&mut self, op: Op, expected: fn(u32, u32) -> u32) {
        let (value, offset) = (self.make(op), word(self.expected.len() as u32));
        let index = self.make(add(self.base.clone(), offset));
        self.perform(Op::StoreWord(self.roots.output, index, value));
        self.expected.push(expected);
    }

    fn buffers(&mut self) {
        let (id, local) = (self.id.clone(), self.local.clone());
        let record = Op::LoadVec4(self.roots.records, id.clone());
        let record = self.k.push(0, record, Type::vec4());
        self.expect(Op::Component(record.clone(), word(2)), |id, _| 40 * id + 2);
        self.expect(Op::Component(record, local.clone()), |id, local| 40 * id + local);
        let words = [1, 2, 3, 4].map(word);
        self.perform(Op::StoreVec4(self.roots.written_records, id.clone(), words));
        self.perform(Op::StoreComponent(self.roots.written_records, id.clone(), word(1), id.clone()));
        let record = Op::LoadVec4(self.roots.written_records, id);
        let record = self.k.push(0, record, Type::vec4());
        self.expect(Op::Component(record, word(1)), |id, _| id);
        self.expect(Op::LoadWord(self.roots.uniform, word(5)), |_, _| 105);
        self.expect(Op::LoadWord(self.roots.uniform, local), |_, local| 100 + local);
        self.expect(Op::LoadWord(self.roots.push, word(2)), |_, _| 202);
        self.expect(Op::WordCount(self.roots.records), |_, _| 32);
    }

    fn own_arrays(&mut self) {
        self.perform(Op::StoreWord(self.roots.own, self.local.clone(), self.id.clone()));
        self.expect(Op::LoadWord(self.roots.own, self.local.clone()), |id, _| id);
        let table = |_, local| [3, 1, 4, 1][local as usize];
        self.expect(Op::LoadWord(self.roots.table, self.local.clone()), table);
    }

    /// Each invocation adds its id + 1 to counter 0 and takes the signed minimum of −id in counter 1; it has
    /// counter 2 + id for itself.
    fn atomics(&mut self) {
        let (counters, id) = (self.roots.counters, self.id.clone());
        let one_more = self.make(add(id.clone(), word(1)));
        self.make(Op::AtomicWord(AtomicOp::Add, counters, word(0), one_more));
        let negative = self.make(Op::Binary(BinaryOp::Sub, word(0), id.clone()));
        self.make(Op::AtomicWord(AtomicOp::SMin, counters, word(1), negative));
        let own = self.make(add(id.clone(), word(2)));
        self.perform(Op::AtomicStoreWord(counters, own.clone(), word(5)));
        let cas = |expected, new| Op::CompareExchangeWord(counters, own.clone(), word(expected), new);
        self.expect(cas(6, word(9)), |_, _| 5);
        self.expect(cas(5, id), |_, _| 5);
        self.expect(Op::AtomicLoadWord(counters, own), |id, _| id);
    }

    /// The next invocation's word, through workgroup memory and through the subgroup.
    fn together(&mut self) {
        let shared = self.roots.shared;
        self.perform(Op::StoreWord(shared, self.local.clone(), self.id.clone()));
        self.perform(Op::Barrier);
        let next = self.make(add(self.local.clone(), word(1)));
        let next = self.make(Op::Binary(BinaryOp::And, next, word(THREADS - 1)));
        let next_id = |id, local| id - local + (local + 1) % THREADS;
        self.expect(Op::LoadWord(shared, next.clone()), next_id);
        self.expect(Op::Subgroup(SubgroupOp::Read, vec![self.id.clone(), next]), next_id);
        self.expect(Op::Subgroup(SubgroupOp::Add, vec![self.local.clone()]), |_, _| 6);
        let few = less(self.local.clone(), word(3));
        let few = self.k.push(0, few, Type::BOOL);
        self.expect(Op::Subgroup(SubgroupOp::Count, vec![few]), |_, _| 3);
    }

    /// `i = 0; do { i += 1 } while i < id; expect i`, and the specialisation constant 3 of default 7 where
    /// `id` is odd.
    fn loop_with_a_value_that_leaves(&mut self) {
        let (i, next) = self.k.counter(1, 0);
        let again = self.k.push(1, less(next.clone(), self.id.clone()), Type::BOOL);
        self.k.end(0, Terminator::Branch(BlockId(1)));
        self.k.end(1, Terminator::Condition(again, BlockId(1), BlockId(2)));
        self.block = 2;
        let sum = add(i, next);
        let odd = self.make(Op::Binary(BinaryOp::And, self.id.clone(), word(1)));
        let odd = self.k.push(2, Op::IntCompare(IntPredicate::Ne, odd, word(0)), Type::BOOL);
        let constant = self.make(Op::SpecConstant { id: 3, default: 7 });
        let sum = self.make(sum);
        self.expect(Op::Select(odd, constant, sum), |id, _| if id % 2 == 1 { 9 } else { 2 * id.max(1) - 1 });
        self.k.end(2, Terminator::Branch(BlockId(3))).end(3, Terminator::Return);
    }

    fn finish(self) -> Places {
        let invocations = 2 * THREADS;
        let mut arguments = Arguments { subgroup_size: THREADS, ..Arguments::default() };
        let records = (0..invocations).flat_map(|id| (0..4).map(move |k| 40 * id + k)).collect();
        arguments.buffers.insert((0, 0), vec![0; (WRITTEN * invocations) as usize]);
        arguments.buffers.insert((0, 1), records);
        arguments.buffers.insert((0, 2), vec![0; 4 * invocations as usize]);
        arguments.buffers.insert((0, 3), (100..106).collect());
        arguments.buffers.insert((1, 0), vec![0; 2 + invocations as usize]);
        arguments.push = vec![200, 201, 202];
        arguments.specialisation.insert(3, 9);
        let written = |id| {
            let words: Vec<u32> = self.expected.iter().map(|word| word(id, id % THREADS)).collect();
            words.into_iter().chain(std::iter::repeat(0)).take(WRITTEN as usize)
        };
        let expected = (0..invocations).flat_map(written).collect();
        assert!(self.expected.len() <= WRITTEN as usize, "{} words", self.expected.len());
        Places { kernel: self.k.build(), arguments, expected }
    }
}
