//! Writes what an entry point stands for: the function itself, the pass, and the parameterless entry of the device.

use crate::entry::Entry;
use crate::parameter::Kind;
use crate::{pass, rust_gpu};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::ItemFn;

/// The whole expansion. `attribute` is what stands in the entry point's own `#[spirv(…)]`.
pub fn expand(entry: &Entry, attribute: &TokenStream, function: &ItemFn) -> TokenStream {
    let rust_gpu = rust_gpu::entry(entry, attribute, function);
    let pass = pass::pass(entry, function);
    let device = device_entry(entry, function);
    let mut function = function.clone();
    // So that the CPU's instance per instruction set contains it.
    function.attrs.push(syn::parse_quote!(#[inline(always)]));
    // One parameter per binding: their number is not a matter of style.
    function.attrs.push(syn::parse_quote!(#[allow(clippy::too_many_arguments)]));
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        #function
        #pass
        #device
        #rust_gpu
    }
}

/// The parameterless function that the kernel compiler starts from: it makes each argument by a call that the compiler knows.
fn device_entry(entry: &Entry, function: &ItemFn) -> TokenStream {
    let name = &function.sig.ident;
    let shim = format_ident!("__kernel_{}", name);
    let [x, y, z] = entry.threads;
    let arguments = entry.parameters.iter().map(|parameter| device_argument(&parameter.kind));
    quote! {
        #[cfg(kernel_ir)]
        #[doc(hidden)]
        #[unsafe(no_mangle)]
        pub extern "C" fn #shim() {
            // SAFETY: the kernel compiler replaces each of these calls by the binding that it names.
            unsafe {
                ::kernel_api::rt::__k_threads(#x, #y, #z);
                #name(#(#arguments),*)
            }
        }
    }
}

fn device_argument(kind: &Kind) -> TokenStream {
    match kind {
        Kind::Builtin(builtin) => quote!(::kernel_api::rt::#builtin()),
        Kind::Uniform { set, binding, .. } => quote!(::kernel_api::rt::uniform(#set, #binding)),
        Kind::Push { .. } => quote!(::kernel_api::rt::push_constant()),
        // Atomics are written, through a shared slice.
        Kind::Read { set, binding, .. } | Kind::Atomic { set, binding, .. } => {
            quote!(::kernel_api::rt::slice(#set, #binding))
        }
        Kind::Write { set, binding, .. } => quote!(::kernel_api::rt::out(#set, #binding)),
        Kind::Workgroup { number, .. } => quote!(::kernel_api::rt::workgroup(#number)),
        Kind::Constant { id, default, ty } => match ty.to_string().as_str() {
            "f32" => quote!(f32::from_bits(::kernel_api::rt::__k_spec(#id, #default))),
            "bool" => quote!(::kernel_api::rt::__k_spec(#id, #default) != 0),
            _ => quote!(::kernel_api::rt::__k_spec(#id, #default)),
        },
    }
}
