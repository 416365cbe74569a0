//! Writes what an entry point stands for: the function itself, the pass, and the parameterless entry of the device.

use crate::entry::{Entry, Kind, Parameter};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::ItemFn;

/// The whole expansion.
pub fn expand(entry: &Entry, function: &ItemFn) -> TokenStream {
    let mut function = function.clone();
    // So that the CPU's instance per instruction set contains it.
    function.attrs.push(syn::parse_quote!(#[inline(always)]));
    function.attrs.push(syn::parse_quote!(#[allow(clippy::too_many_arguments)]));
    let pass = pass(entry, &function);
    let shim = device_entry(entry, &function);
    quote!(#function #pass #shim)
}

fn camel(name: &Ident) -> Ident {
    let text: String = name
        .to_string()
        .split('_')
        .map(|word| word[..1.min(word.len())].to_uppercase() + &word[1.min(word.len())..])
        .collect();
    Ident::new(&text, name.span())
}

/// The type of the argument with which a host fills the parameter, if it is one that a host fills.
fn field(parameter: &Parameter) -> Option<TokenStream> {
    Some(match &parameter.kind {
        Kind::Uniform { ty, .. } | Kind::Push { ty } => quote!(#ty),
        Kind::Read { element, .. } | Kind::Write { element, .. } => quote!(::kernel_api::Buffer<#element>),
        Kind::Atomic { .. } => quote!(::kernel_api::Buffer<u32>),
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
        Kind::Atomic { .. } => quote!(&'v [::core::sync::atomic::AtomicU32]),
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
        Kind::Atomic { .. } => quote!(memory.atomic(self.#name)),
        Kind::Constant { .. } => quote!(self.#name),
        Kind::Builtin(_) | Kind::Workgroup { .. } => return None,
    })
}

/// `Binding { … }` of a parameter that has one.
fn binding(parameter: &Parameter) -> Option<TokenStream> {
    let name = parameter.name.to_string();
    let (set, binding, access, bytes) = match &parameter.kind {
        Kind::Uniform { set, binding, ty } => (set, binding, quote!(Uniform), quote!(size_of::<#ty>())),
        Kind::Push { ty } => (&0, &0, quote!(Push), quote!(size_of::<#ty>())),
        Kind::Read { set, binding, element } => (set, binding, quote!(Read), quote!(size_of::<#element>())),
        Kind::Write { set, binding, element } => (set, binding, quote!(Write), quote!(size_of::<#element>())),
        Kind::Atomic { set, binding } => (set, binding, quote!(Atomic), quote!(4)),
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
fn pass(entry: &Entry, function: &ItemFn) -> TokenStream {
    if entry.parameters.iter().any(|p| matches!(p.kind, Kind::Workgroup { .. })) {
        return TokenStream::new();
    }
    let name = &function.sig.ident;
    let visibility = &function.vis;
    let text = name.to_string();
    let (pass, views) = (camel(name), format_ident!("{}Views", camel(name)));
    let docs: Vec<_> = function.attrs.iter().filter(|a| a.path().is_ident("doc")).collect();
    let [x, y, z] = entry.threads;

    let filled: Vec<_> = entry.parameters.iter().filter_map(|p| field(p).map(|f| (&p.name, f))).collect();
    let fields = filled.iter().map(|(name, ty)| {
        let doc = format!("The argument `{name}` of [`{text}`].");
        quote!(#[doc = #doc] pub #name: #ty)
    });
    let view_fields = entry.parameters.iter().filter_map(|p| view(p).map(|v| (&p.name, v)));
    let view_fields = view_fields.map(|(name, ty)| quote!(#name: #ty));
    let made = entry.parameters.iter().filter_map(|p| make_view(p).map(|v| (&p.name, v)));
    let made = made.map(|(name, value)| quote!(#name: #value));
    let bindings = entry.parameters.iter().filter_map(binding);
    let mut number = 0;
    let binds = entry.parameters.iter().filter_map(|p| {
        let text = bind(p, number);
        number += binding(p).is_some() as usize;
        text
    });
    let arguments = entry.parameters.iter().map(|p| cpu_argument(p, entry.threads));
    let views_doc = format!("What one invocation of [`{pass}`] can see, on the CPU.");

    quote! {
        #(#docs)*
        #[derive(Clone, Copy)]
        #visibility struct #pass { #(#fields,)* }

        #[doc = #views_doc]
        #[derive(Clone, Copy)]
        #visibility struct #views<'v> { #(#view_fields,)* life: ::core::marker::PhantomData<&'v ()> }

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

/// The parameterless function that the kernel compiler starts from: it makes each argument by a call that the compiler knows.
fn device_entry(entry: &Entry, function: &ItemFn) -> TokenStream {
    let name = &function.sig.ident;
    let shim = format_ident!("__kernel_{}", name);
    let [x, y, z] = entry.threads;
    let arguments = entry.parameters.iter().map(|p| match &p.kind {
        Kind::Builtin(builtin) => quote!(::kernel_api::rt::#builtin()),
        Kind::Uniform { set, binding, .. } => quote!(::kernel_api::rt::uniform(#set, #binding)),
        Kind::Push { .. } => quote!(::kernel_api::rt::push_constant()),
        Kind::Read { set, binding, .. } => quote!(::kernel_api::rt::slice(#set, #binding)),
        // Atomics are written, through a shared slice.
        Kind::Atomic { set, binding } => quote!(::kernel_api::rt::slice(#set, #binding)),
        Kind::Write { set, binding, .. } => quote!(::kernel_api::rt::out(#set, #binding)),
        Kind::Workgroup { number } => quote!(::kernel_api::rt::workgroup(#number)),
        Kind::Constant { id, default, ty } => match ty.to_string().as_str() {
            "f32" => quote!(f32::from_bits(::kernel_api::rt::__k_spec(#id, #default))),
            "bool" => quote!(::kernel_api::rt::__k_spec(#id, #default) != 0),
            _ => quote!(::kernel_api::rt::__k_spec(#id, #default)),
        },
    });
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
