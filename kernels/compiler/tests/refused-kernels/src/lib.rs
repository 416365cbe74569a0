//! Kernels that no device can run as they are. Each must be refused, by name, with what to write instead: see
//! `kernels/compiler/tests/refusals.rs`.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::UVec3;
use kernel_api::{At, Out, Workgroup, barrier, spirv, subgroup};

/// Declares kernels from two tables of words to one word for each invocation.
macro_rules! kernels {
    ($($(#[$doc:meta])* $name:ident($i:ident, $a:ident, $b:ident) $body:block)*) => {$(
        $(#[$doc])*
        #[spirv(compute(threads(64)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] a: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] b: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: Out<u32>,
        ) {
            let ($i, $a, $b) = (id.x, a, b);
            let _ = ($a, $b);
            out.put($i, $body);
        }
    )*};
}

trait Step {
    fn step(&self, x: u32) -> u32;
}

struct Plus(u32);
struct Times(u32);

impl Step for Plus {
    fn step(&self, x: u32) -> u32 {
        x + self.0
    }
}

impl Step for Times {
    fn step(&self, x: u32) -> u32 {
        x * self.0
    }
}

fn fibonacci(n: u32) -> u32 {
    if n < 2 { n } else { fibonacci(n - 1).wrapping_add(fibonacci(n.wrapping_sub(2))) }
}

#[inline(never)]
fn apart(x: u32) -> u32 {
    x.wrapping_mul(77) ^ (x >> 3)
}

fn one_more(x: u32) -> u32 {
    x.wrapping_add(1)
}

fn three_times(x: u32) -> u32 {
    x.wrapping_mul(3)
}

static COUNTER: AtomicU32 = AtomicU32::new(0);
static STEPS: [fn(u32) -> u32; 2] = [one_more, three_times];

kernels! {
    /// An index that may be out of range.
    index(i, a, b) {
        a[b.at(i) as usize]
    }
    /// A divisor that may be zero.
    division(i, a, b) {
        a.at(i) / b.at(i)
    }
    /// A remainder whose divisor may be zero, and a quotient that may overflow.
    signed_division(i, a, b) {
        (a.at(i) as i32 / b.at(i) as i32) as u32
    }
    /// An option that may be none.
    unwrap(i, a, b) {
        a.at(i).checked_sub(b.at(i)).unwrap()
    }
    /// The same with a message.
    expect(i, a, b) {
        a.at(i).checked_add(b.at(i)).expect("no overflow")
    }
    /// A slice that may reach beyond the end.
    slice(i, a, _b) {
        a[i as usize..i as usize + 4].iter().fold(0, |sum, word| sum ^ word)
    }
    /// A panic on purpose.
    panic(i, a, _b) {
        if a.at(i) == 7 {
            panic!("seven");
        }
        1
    }
    /// An assertion.
    assertion(i, a, b) {
        assert!(a.at(i) < b.at(i));
        1
    }
    /// A function that calls itself.
    recursion(i, a, _b) {
        fibonacci(a.at(i) & 7)
    }
    /// A function that is not inlined.
    not_inlined(i, a, _b) {
        apart(a.at(i)) ^ apart(i)
    }
    /// A trait object.
    trait_object(i, a, _b) {
        let (plus, times) = (Plus(3), Times(5));
        let step: &dyn Step = if a.at(i) & 1 == 0 { &plus } else { &times };
        step.step(i)
    }
    /// A function pointer.
    function_pointer(i, a, _b) {
        STEPS.at(a.at(i) & 1)(i)
    }
    /// Memory from an allocator.
    allocation(i, a, _b) {
        let words: Vec<u32> = (0..a.at(i)).collect();
        words.iter().fold(0, |sum, word| sum ^ word)
    }
    /// A double.
    double(i, a, _b) {
        (a.at(i) as f64 * 1e3 + 0.1) as u32
    }
    /// Numbers of 64 bits.
    wide(i, a, b) {
        (((a.at(i) as u64) << 32 | b.at(i) as u64) / 1_000_003) as u32
    }
    /// A static that is written.
    written_static(i, _a, _b) {
        COUNTER.fetch_add(i, Relaxed)
    }
    /// Output to a terminal.
    print(i, a, _b) {
        println!("{}", a.at(i));
        1
    }
    /// A function of the C library.
    sine(i, a, _b) {
        f32::from_bits(a.at(i)).tan().to_bits()
    }
}

/// A store of fewer bits than a word has.
#[spirv(compute(threads(64)))]
pub fn byte_store(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] out: Out<u8>,
) {
    out.put(id.x, id.x as u8);
}

/// A barrier that only some invocations reach.
#[spirv(compute(threads(64)))]
pub fn divergent_barrier(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] memory: &Workgroup<u32, 64>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] out: Out<u32>,
) {
    memory.set(lane, lane);
    if lane < 32 {
        barrier!();
        out.put(lane, memory.get(63 - lane));
    }
}

/// A subgroup operation that only some invocations reach.
#[spirv(compute(threads(64)))]
pub fn divergent_subgroup(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: Out<u32>,
) {
    if words.at(id.x) & 1 == 0 {
        out.put(id.x, subgroup!(add(id.x)));
    }
}
