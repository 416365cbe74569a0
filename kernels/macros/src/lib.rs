//! `#[spirv(compute(threads(x, y, z)))]`, in spirv-std's spelling: one declaration of an entry point, three things made of it.
//!
//! See `kernel_api` for what they are. `entry` reads the declaration, `expand` writes the three things.

mod entry;
mod expand;

use proc_macro::TokenStream;

/// Declares a function as a kernel entry point; see the crate `kernel-api`.
#[proc_macro_attribute]
pub fn spirv(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let mut function = syn::parse_macro_input!(item as syn::ItemFn);
    match entry::Entry::read(attribute.into(), &mut function) {
        Ok(entry) => expand::expand(&entry, &function).into(),
        Err(error) => {
            let error = error.to_compile_error();
            quote::quote!(#function #error).into()
        }
    }
}
