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
