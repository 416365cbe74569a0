//! Kernels in a few lines of IR, lowered, cleaned up and run by the interpreter.

mod memory;
mod pointers;
mod refused;
mod usize;

use crate::front::{Front, FrontOptions, kernels_of};
use crate::interpret::{Arguments, run};
use crate::ir::{Kernel, Op};

/// The module of a kernel `t` of one thread. Its body sees `%in`, `%out` (buffers 0 and 1 of words), `%rows` (buffer 2, records of 16
/// bytes) and `%x`, the first word of `%in`.
fn module(body: &str) -> String {
    format!(
        "@table = private constant [3 x i32] [i32 5, i32 6, i32 7], align 4
@counter = internal global [4 x i8] zeroinitializer, align 4
define internal i32 @_ZN1k4loop17h0000000000000000E(i32 %n) {{
  ret i32 %n
}}
define void @__kernel_t() {{
start:
  call void @__k_threads(i32 1, i32 1, i32 1)
  %in = call ptr @__k_root(i32 0, i32 0, i32 0, i32 4, i32 4)
  %out = call ptr @__k_root(i32 1, i32 0, i32 1, i32 4, i32 4)
  %rows = call ptr @__k_root(i32 1, i32 0, i32 2, i32 16, i32 16)
  %x = load i32, ptr %in, align 4
{body}
}}
"
    )
}

/// Compiles the kernel `t` with this body.
pub(crate) fn compile(body: &str) -> Front {
    kernels_of(&module(body), &FrontOptions::default())
}

/// The kernel `t` with this body, which must compile.
pub(crate) fn kernel(body: &str) -> Kernel {
    let mut front = compile(body);
    assert_eq!(front.refusals, []);
    front.kernels.remove(0)
}

/// Runs the kernel on the words `input`; yields the words of `%out`, of which there are 8, and of `%rows`.
pub(crate) fn output(kernel: &Kernel, input: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let buffers = [((0, 0), input.to_vec()), ((0, 1), vec![0; 8]), ((0, 2), (100..116).collect())];
    let mut arguments = Arguments { buffers: buffers.into(), ..Arguments::default() };
    assert_eq!(run(kernel, [1, 1, 1], &mut arguments), Ok(()));
    (arguments.buffers[&(0, 1)].clone(), arguments.buffers[&(0, 2)].clone())
}

/// How many operations of the kernel are as `wanted`.
pub(crate) fn count(kernel: &Kernel, wanted: impl Fn(&Op) -> bool) -> usize {
    kernel.function.placed().filter(|id| wanted(&kernel.function[*id].op)).count()
}
