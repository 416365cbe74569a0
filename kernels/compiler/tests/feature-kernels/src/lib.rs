//! One kernel per feature of the kernel compiler. Most are functions from an invocation's number and a table of words to one word,
//! declared by `word_kernels!`; those with bindings of their own are declared in full.
//!
//! Results are the same bits everywhere: sums wrap, a NaN is written as one pattern, and no value is denormal (SwiftShader flushes
//! those to zero).

/// Declares a kernel for each function `fn(i: u32, words: &[u32]) -> u32`, which writes its result for each invocation `i`.
macro_rules! word_kernels {
    ($($(#[$doc:meta])* $name:ident = $function:ident;)*) => {$(
        $(#[$doc])*
        #[kernel_api::spirv(compute(threads(64)))]
        pub fn $name(
            #[spirv(global_invocation_id)] id: glam::UVec3,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: kernel_api::Out<u32>,
        ) {
            if id.x < out.len() {
                out.put(id.x, $function(id.x, words));
            }
        }
    )*};
}

pub mod arrays;
pub mod atomics;
pub mod bindings;
pub mod constants;
pub mod control;
pub mod floats;
pub mod ids;
pub mod integers;
pub mod loops;
pub mod pointers;
pub mod records;
pub mod subgroups;
pub mod workgroups;
