//! The entry point as rust-gpu's compiler takes it: spirv-std's own attribute, plain references, and the views of `kernel-api` made
//! from them before the body.

use crate::entry::Entry;
use crate::parameter::{Kind, Parameter, last_segment};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{ItemFn, Type};

/// The function for the target `spirv`. `attribute` is what stands in its `#[spirv(…)]`.
pub fn entry(entry: &Entry, attribute: &TokenStream, function: &ItemFn) -> TokenStream {
    let ItemFn { attrs, vis, sig, block } = function;
    let name = &sig.ident;
    let parameters = entry.parameters.iter().map(parameter);
    let views = entry.parameters.iter().filter_map(view);
    quote! {
        #[cfg(target_arch = "spirv")]
        #(#attrs)*
        #[allow(clippy::too_many_arguments)]
        #[::kernel_api::rt::spirv_std::spirv(#attribute)]
        #vis fn #name(#(#parameters),*) {
            #(#views)*
            #block
        }
    }
}

fn parameter(Parameter { name, kind, attribute, ty }: &Parameter) -> TokenStream {
    match kind {
        Kind::Write { element, .. } => quote!(#attribute #name: &mut [#element]),
        Kind::Workgroup { ty, .. } => {
            let array = elements(ty).unwrap_or(quote!(#ty));
            quote!(#attribute #name: &mut #array)
        }
        Kind::Constant { id, default, .. } => {
            quote!(#[spirv(spec_constant(id = #id, default = #default))] #name: u32)
        }
        _ => quote!(#attribute #name: #ty),
    }
}

/// What makes the declared parameter from the one that rust-gpu has.
fn view(Parameter { name, kind, .. }: &Parameter) -> Option<TokenStream> {
    Some(match kind {
        // SAFETY of the expansion: what the kernel promises of its output holds here as on the CPU.
        Kind::Write { .. } => quote!(let #name = unsafe { ::kernel_api::Out::new(#name, &[]) };),
        Kind::Workgroup { ty, .. } if elements(ty).is_some() => {
            quote!(let #name = ::kernel_api::Workgroup::over(#name);)
        }
        Kind::Workgroup { .. } => quote!(let #name = &*#name;),
        Kind::Constant { ty, .. } if ty == "f32" => quote!(let #name = f32::from_bits(#name);),
        Kind::Constant { ty, .. } if ty == "bool" => quote!(let #name = #name != 0;),
        _ => return None,
    })
}

/// The array type `[T; N]` of a `Workgroup<T, N>`.
fn elements(ty: &Type) -> Option<TokenStream> {
    let segment = last_segment(ty).filter(|segment| segment.ident == "Workgroup")?;
    let syn::PathArguments::AngleBracketed(arguments) = &segment.arguments else {
        return None;
    };
    let mut arguments = arguments.args.iter();
    let (element, count) = (arguments.next()?, arguments.next()?);
    Some(quote!([#element; #count]))
}
