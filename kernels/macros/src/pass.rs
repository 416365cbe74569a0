//! Writes the pass of an entry point: the typed arguments that a host fills in, and the launcher of the CPU.

use crate::entry::Entry;
use crate::parameter::{Kind, Parameter};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::ItemFn;
use syn::ext::IdentExt;

/// The name of the pass of entry point `name`.
fn camel(name: &Ident) -> Ident {
    let text = name
        .unraw()
        .to_string()
        .split('_')
        .map(|word| {
            let mut letters = word.chars();
            letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
        })
        .collect::<Vec<String>>()
        .concat();
    Ident::new(&text, name.span())
}

/// The type of the argument with which a host fills the parameter, if it is one that a host fills.
fn field(parameter: &Parameter) -> Option<TokenStream> {
    Some(match &parameter.kind {
        Kind::Uniform { ty, .. } | Kind::Push { ty } => quote!(#ty),
        Kind::Read { element, .. } | Kind::Write { element, .. } => quote!(::kernel_api::Buffer<#element>),
        Kind::Atomic { signed: false, .. } => quote!(::kernel_api::Buffer<u32>),
        Kind::Atomic { signed: true, .. } => quote!(::kernel_api::Buffer<i32>),
        Kind::Constant { ty, .. } => quote!(#ty),
        Kind::Builtin(_) | Kind::Workgroup { .. } => return None,
    })
}

/// The type of the CPU's view of the parameter.
fn view(parameter: &Parameter) -> Option<TokenStream> {
    Some(match &parameter.kind {
        Kind::Uniform { ty, .. } | Kind::Push { ty } => quote!(&'v #ty),
        Kind::Read { element, .. } => quote!(&'v [#element]),
        Kind::Write { element, .. } => quote!(::kernel_api::Out<'v, #element>),
        Kind::Atomic { signed: false, .. } => quote!(&'v [::core::sync::atomic::AtomicU32]),
        Kind::Atomic { signed: true, .. } => quote!(&'v [::core::sync::atomic::AtomicI32]),
        Kind::Constant { ty, .. } => quote!(#ty),
        Kind::Builtin(_) | Kind::Workgroup { .. } => return None,
    })
}

fn make_view(parameter: &Parameter) -> Option<TokenStream> {
    let name = &parameter.name;
    Some(match &parameter.kind {
        Kind::Uniform { .. } | Kind::Push { .. } => quote!(&self.#name),
        Kind::Read { .. } => quote!(memory.read(self.#name)),
        Kind::Write { .. } => quote!(memory.write(self.#name)),
        Kind::Atomic { signed: false, .. } => quote!(memory.atomic(self.#name)),
        Kind::Atomic { signed: true, .. } => {
            quote!(::kernel_api::memory::signed(memory.atomic(self.#name.words())))
        }
        Kind::Constant { .. } => quote!(self.#name),
        Kind::Builtin(_) | Kind::Workgroup { .. } => return None,
    })
}

/// `Binding { … }` of a parameter that has one.
fn binding(parameter: &Parameter) -> Option<TokenStream> {
    let name = parameter.name.unraw().to_string();
    let (set, binding, access, bytes) = match &parameter.kind {
        Kind::Uniform { set, binding, ty } => (set, binding, quote!(Uniform), quote!(size_of::<#ty>())),
        Kind::Push { ty } => (&0, &0, quote!(Push), quote!(size_of::<#ty>())),
        Kind::Read { set, binding, element } => (set, binding, quote!(Read), quote!(size_of::<#element>())),
        Kind::Write { set, binding, element } => (set, binding, quote!(Write), quote!(size_of::<#element>())),
        Kind::Atomic { set, binding, .. } => (set, binding, quote!(Atomic), quote!(4)),
        Kind::Builtin(_) | Kind::Workgroup { .. } | Kind::Constant { .. } => return None,
    };
    Some(quote!(::kernel_api::Binding {
        name: #name, set: #set, binding: #binding, access: ::kernel_api::Access::#access, element_bytes: #bytes as u32,
    }))
}

/// What `Pass::bind` says of a parameter. `number` counts the bindings before it.
fn bind(parameter: &Parameter, number: usize) -> Option<TokenStream> {
    let name = &parameter.name;
    Some(match &parameter.kind {
        Kind::Uniform { .. } | Kind::Push { .. } => quote!(visit(::kernel_api::Bound::Bytes {
            binding: Self::BINDINGS[#number], bytes: ::kernel_api::rt::bytemuck::bytes_of(&self.#name),
        });),
        Kind::Read { .. } | Kind::Write { .. } | Kind::Atomic { .. } => {
            quote!(visit(::kernel_api::Bound::Buffer {
            binding: Self::BINDINGS[#number], id: self.#name.id, owner: self.#name.owner,
        });)
        }
        Kind::Constant { id, ty, .. } => {
            let bits = match ty.to_string().as_str() {
                "f32" => quote!(self.#name.to_bits()),
                _ => quote!(self.#name as u32),
            };
            quote!(visit(::kernel_api::Bound::Constant { id: #id, bits: #bits });)
        }
        Kind::Builtin(_) | Kind::Workgroup { .. } => return None,
    })
}

/// An argument of the call that the CPU makes.
fn cpu_argument(parameter: &Parameter, [x, y, z]: [u32; 3]) -> TokenStream {
    let threads = quote!(::kernel_api::rt::glam::UVec3::new(#x, #y, #z));
    let name = &parameter.name;
    match &parameter.kind {
        Kind::Builtin(builtin) => match builtin.to_string().as_str() {
            "global_invocation_id" => quote!(invocation.id),
            "local_invocation_id" => quote!((invocation.id % #threads)),
            "workgroup_id" => quote!((invocation.id / #threads)),
            "num_workgroups" => quote!(invocation.groups),
            _ => quote!({
                let local = invocation.id % #threads;
                (local.z * #y + local.y) * #x + local.x
            }),
        },
        _ => quote!(views.#name),
    }
}

/// The type that implements `Pass`. A kernel with workgroup memory has none: it runs on a device only.
pub fn pass(entry: &Entry, function: &ItemFn) -> TokenStream {
    if entry.parameters.iter().any(|p| matches!(p.kind, Kind::Workgroup { .. })) {
        return TokenStream::new();
    }
    let pass = camel(&function.sig.ident);
    let views = format_ident!("{}Views", pass);
    let types = types(entry, function, &pass, &views);
    let implementation = implementation(entry, function, &pass, &views);
    quote! {
        #types
        #implementation
    }
}

/// The arguments of a run, and what an invocation sees of them.
fn types(entry: &Entry, function: &ItemFn, pass: &Ident, views: &Ident) -> TokenStream {
    let visibility = &function.vis;
    let docs = function.attrs.iter().filter(|a| a.path().is_ident("doc"));
    let filled = entry.parameters.iter().filter_map(|p| field(p).map(|ty| (&p.name, ty)));
    let fields = filled.map(|(name, ty)| {
        let doc = format!("The argument `{name}` of [`{}`].", function.sig.ident.unraw());
        quote!(#[doc = #doc] pub #name: #ty)
    });
    let seen = entry.parameters.iter().filter_map(|p| view(p).map(|ty| (&p.name, ty)));
    let seen = seen.map(|(name, ty)| quote!(#name: #ty));
    let views_doc = format!("What one invocation of [`{pass}`] can see, on the CPU.");
    quote! {
        #(#docs)*
        #[derive(Clone, Copy)]
        #[cfg(not(target_arch = "spirv"))]
        #visibility struct #pass { #(#fields,)* }

        #[doc = #views_doc]
        #[derive(Clone, Copy)]
        #[cfg(not(target_arch = "spirv"))]
        #visibility struct #views<'v> { #(#seen,)* life: ::core::marker::PhantomData<&'v ()> }
    }
}

fn implementation(entry: &Entry, function: &ItemFn, pass: &Ident, views: &Ident) -> TokenStream {
    let name = &function.sig.ident;
    let text = name.unraw().to_string();
    let [x, y, z] = entry.threads;
    let made = entry.parameters.iter().filter_map(|p| make_view(p).map(|value| (&p.name, value)));
    let made = made.map(|(name, value)| quote!(#name: #value));
    let bindings = entry.parameters.iter().filter_map(binding);
    let mut number = 0;
    let binds = entry.parameters.iter().filter_map(|p| {
        let text = bind(p, number);
        number += binding(p).is_some() as usize;
        text
    });
    let arguments = entry.parameters.iter().map(|p| cpu_argument(p, entry.threads));
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        impl ::kernel_api::Pass for #pass {
            const NAME: &'static str = #text;
            const THREADS: [u32; 3] = [#x, #y, #z];
            const BINDINGS: &'static [::kernel_api::Binding] = &[#(#bindings),*];
            type Views<'v> = #views<'v>;

            fn bind(&self, visit: &mut dyn FnMut(::kernel_api::Bound<'_>)) {
                let _ = &visit;
                #(#binds)*
            }

            fn views<'v, M: ::kernel_api::Memory>(&'v self, memory: &'v M) -> #views<'v> {
                let _ = memory;
                #views { #(#made,)* life: ::core::marker::PhantomData }
            }

            #[inline(always)]
            fn invoke(views: &#views<'_>, invocation: ::kernel_api::Invocation) {
                let _ = (views, invocation);
                #name(#(#arguments),*)
            }
        }
    }
}
