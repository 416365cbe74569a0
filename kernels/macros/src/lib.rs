//! `#[spirv(compute(threads(x, y, z)))]`, in spirv-std's spelling: one declaration of an entry point, three things made of it.
//!
//! See `kernel_api` for what they are. `entry` and `parameter` read the declaration; `expand`, `pass` and `rust_gpu` write what is
//! made of it.

mod entry;
mod expand;
mod parameter;
mod pass;
mod rust_gpu;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Declares a function as a kernel entry point; see the crate `kernel-api`.
#[proc_macro_attribute]
pub fn spirv(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let mut function = syn::parse_macro_input!(item as syn::ItemFn);
    let attribute = attribute.into();
    match entry::Entry::read(proc_macro2::TokenStream::clone(&attribute), &mut function) {
        Ok(entry) => expand::expand(&entry, &attribute, &function).into(),
        Err(error) => {
            let error = error.to_compile_error();
            quote::quote!(#function #error).into()
        }
    }
}

/// For a function that is rarely called from a hot loop: out of line on a CPU, where it would cost registers and code, and inlined
/// on a device, where a kernel must be one function.
#[proc_macro_attribute]
pub fn rare(_: TokenStream, item: TokenStream) -> TokenStream {
    let function = proc_macro2::TokenStream::from(item);
    quote::quote! {
        #[cfg_attr(not(kernel_ir), cold, inline(never))]
        #[cfg_attr(kernel_ir, inline(always))]
        #function
    }
    .into()
}
