//! What the attribute refuses, with which words, and what it makes of a declaration.

use crate::entry::Entry;
use crate::{expand, pass};
use proc_macro2::TokenStream;
use quote::quote;
use syn::ItemFn;

fn read(attribute: TokenStream, function: TokenStream) -> syn::Result<(Entry, ItemFn)> {
    let mut function = syn::parse2::<ItemFn>(function)?;
    Ok((Entry::read(attribute, &mut function)?, function))
}

/// The message for a function with these parameters.
fn refused(parameters: TokenStream) -> String {
    let result = read(quote!(compute(threads(64))), quote!(pub fn kernel(#parameters) {}));
    result.err().expect("it is accepted").to_string()
}

fn refused_function(function: TokenStream) -> String {
    read(quote!(compute(threads(64))), function).err().expect("it is accepted").to_string()
}

fn refused_attribute(attribute: TokenStream) -> String {
    read(
        attribute,
        quote!(
            pub fn kernel() {}
        ),
    )
    .err()
    .expect("it is accepted")
    .to_string()
}

#[test]
fn a_wrong_attribute_is_told_the_right_one() {
    let expected = "expected #[spirv(compute(threads(x, y, z)))]";
    for attribute in [quote!(), quote!(fragment), quote!(vertex(threads(1))), quote!(compute(entry = "x"))] {
        assert_eq!(refused_attribute(attribute.clone()), expected, "{attribute}");
    }
    assert_eq!(refused_attribute(quote!(compute(threads()))), "one to three numbers of threads");
    assert_eq!(refused_attribute(quote!(compute(threads(1, 2, 3, 4)))), "one to three numbers of threads");
}

#[test]
fn a_workgroup_of_no_or_too_many_invocations_is_refused() {
    let zero = refused_attribute(quote!(compute(threads(8, 0))));
    assert_eq!(zero, "a workgroup has 1 to 1024 invocations, not 0");
    let many = refused_attribute(quote!(compute(threads(64, 64))));
    assert_eq!(many, "a workgroup has 1 to 1024 invocations, not 4096");
}

#[test]
fn what_a_device_cannot_start_is_refused() {
    let result = refused_function(quote!(
        pub fn kernel() -> u32 {
            1
        }
    ));
    assert_eq!(result, "an entry point returns nothing: put results into an `Out<T>`");
    let generic = refused_function(quote!(
        pub fn kernel<T>() {}
    ));
    assert!(generic.starts_with("an entry point cannot be generic: write one for each type"), "{generic}");
    assert_eq!(
        refused_function(quote!(
            pub async fn kernel() {}
        )),
        "an entry point cannot be `async`"
    );
    assert_eq!(
        refused_function(quote!(
            pub unsafe fn kernel() {}
        )),
        "an entry point cannot be `unsafe`"
    );
    assert_eq!(
        refused_function(quote!(
            pub const fn kernel() {}
        )),
        "an entry point cannot be `const`"
    );
    assert_eq!(
        refused_function(quote!(
            pub fn kernel(&self) {}
        )),
        "an entry point cannot take `self`"
    );
}

#[test]
fn a_parameter_says_where_it_comes_from() {
    assert_eq!(refused(quote!(x: u32)), "this parameter needs #[spirv(...)]");
    assert_eq!(refused(quote!(#[spirv(binding = 0)] x: &[u32])), "missing storage class or builtin");
    assert_eq!(refused(quote!(#[spirv(storage_buffer)] x: &[u32])), "missing `binding = n`");
    assert_eq!(
        refused(quote!(#[spirv(global_invocation_id)] (x, y): (u32, u32))),
        "a parameter of an entry point needs a plain name"
    );
    assert_eq!(refused(quote!(#[spirv(uniform, uniform, binding = 0)] x: &u32)), "declared twice");
    assert_eq!(
        refused(quote!(#[spirv(uniform, set = 1, binding = 0)] x: &u32)),
        "unknown attribute of a parameter"
    );
    assert_eq!(refused(quote!(#[spirv(uniform, binding = "0")] x: &u32)), "expected a number");
    let unknown = refused(quote!(#[spirv(position)] x: Vec4));
    assert!(
        unknown.starts_with("unknown storage class or builtin: known are storage_buffer, uniform"),
        "{unknown}"
    );
    assert!(unknown.ends_with("num_workgroups, local_invocation_index"), "{unknown}");
}

#[test]
fn a_storage_buffer_has_one_of_four_types() {
    let expected =
        "a storage buffer is `&[T]` (read), `Out<T>` (written) or `&[AtomicU32]` or `&[AtomicI32]` (shared)";
    for ty in [quote!(&mut [u32]), quote!(&u32), quote!(Vec<u32>), quote!(Out), quote!([u32; 4])] {
        assert_eq!(refused(quote!(#[spirv(storage_buffer, binding = 0)] x: #ty)), expected, "{ty}");
    }
    assert_eq!(refused(quote!(#[spirv(uniform, binding = 0)] x: &mut u32)), "expected a shared reference");
    assert_eq!(refused(quote!(#[spirv(push_constant)] x: u32)), "expected a shared reference");
    assert_eq!(refused(quote!(#[spirv(workgroup)] x: &mut [u32; 4])), "expected a shared reference");
}

#[test]
fn a_constant_has_an_id_and_a_default_of_its_type() {
    let constant = |meta: TokenStream, ty: TokenStream| refused(quote!(#[spirv(#meta)] x: #ty));
    assert_eq!(constant(quote!(spec_constant(default = 1)), quote!(u32)), "missing `id = n`");
    assert_eq!(
        constant(quote!(spec_constant(id = 1)), quote!(i64)),
        "a specialisation constant is a u32, f32 or bool"
    );
    assert_eq!(constant(quote!(spec_constant(id = 1, name = 2)), quote!(u32)), "expected `id` or `default`");
    assert_eq!(
        constant(quote!(spec_constant(id = 1, default = 1)), quote!(f32)),
        "expected a literal of type f32"
    );
    assert_eq!(
        constant(quote!(spec_constant(id = 1, default = -1)), quote!(u32)),
        "expected a literal of type u32"
    );
    assert_eq!(
        constant(quote!(spec_constant(id = 1, default = 1)), quote!(bool)),
        "expected a literal of type bool"
    );
    assert_eq!(
        constant(quote!(spec_constant), quote!(u32)),
        "expected spec_constant(id = n, default = value)"
    );
}

#[test]
fn bindings_have_no_gaps() {
    let gap = quote!(#[spirv(uniform, binding = 0)] a: &u32, #[spirv(uniform, binding = 2)] b: &u32);
    assert_eq!(refused(gap), "descriptor set 0 has no binding 1: bindings count from 0 without gaps");
}

#[test]
fn nothing_is_declared_twice() {
    let twice =
        quote!(#[spirv(storage_buffer, binding = 1)] a: &[u32], #[spirv(uniform, binding = 1)] b: &u32);
    assert_eq!(refused(twice), "binding 1 of descriptor set 0 is declared twice");
    let push = quote!(#[spirv(push_constant)] a: &u32, #[spirv(push_constant)] b: &u32);
    assert_eq!(refused(push), "the push constant is declared twice");
    let constants = quote!(#[spirv(spec_constant(id = 3))] a: u32, #[spirv(spec_constant(id = 3))] b: bool);
    assert_eq!(refused(constants), "specialisation constant 3 is declared twice");
}

/// One parameter of each kind.
fn everything() -> (Entry, ItemFn) {
    let function = quote! {
        pub fn all_of_it(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 1, binding = 0)] p: &P,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] a: &[T],
            #[spirv(storage_buffer, binding = 1)] o: Out<T>,
            #[spirv(storage_buffer, binding = 2)] c: &[AtomicI32],
            #[spirv(push_constant)] q: &Q,
            #[spirv(workgroup)] w: &Workgroup<u32, 64>,
            #[spirv(spec_constant(id = 1, default = -0.5))] s: f32,
            #[spirv(spec_constant(id = 2, default = true))] b: bool,
        ) { body() }
    };
    read(quote!(compute(threads(8, 4))), function).unwrap()
}

#[test]
fn the_expansion_for_rust_gpu_is_spirv_stds() {
    let (entry, function) = everything();
    let text = crate::rust_gpu::entry(&entry, &quote!(compute(threads(8, 4))), &function).to_string();
    let expected = quote! {
        #[cfg(target_arch = "spirv")]
        #[allow(clippy::too_many_arguments)]
        #[::kernel_api::rt::spirv_std::spirv(compute(threads(8, 4)))]
        pub fn all_of_it(
            #[spirv(global_invocation_id)] id: UVec3,
            #[spirv(uniform, descriptor_set = 1, binding = 0)] p: &P,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] a: &[T],
            #[spirv(storage_buffer, binding = 1)] o: &mut [T],
            #[spirv(storage_buffer, binding = 2)] c: &[AtomicI32],
            #[spirv(push_constant)] q: &Q,
            #[spirv(workgroup)] w: &mut [u32; 64],
            #[spirv(spec_constant(id = 1u32, default = 3204448256u32))] s: u32,
            #[spirv(spec_constant(id = 2u32, default = 1u32))] b: u32
        ) {
            let o = unsafe { ::kernel_api::Out::new(o, &[]) };
            let w = ::kernel_api::Workgroup::over(w);
            let s = f32::from_bits(s);
            let b = b != 0;
            { body() }
        }
    };
    assert_eq!(text, expected.to_string());
}

#[test]
fn the_device_entry_asks_for_each_argument() {
    let (entry, function) = everything();
    let text = expand::expand(&entry, &quote!(compute(threads(8, 4))), &function).to_string();
    let shim = quote! {
        ::kernel_api::rt::__k_threads(8u32, 4u32, 1u32);
        all_of_it(
            ::kernel_api::rt::global_invocation_id(),
            ::kernel_api::rt::uniform(1u32, 0u32),
            ::kernel_api::rt::slice(0u32, 0u32),
            ::kernel_api::rt::out(0u32, 1u32),
            ::kernel_api::rt::slice(0u32, 2u32),
            ::kernel_api::rt::push_constant(),
            ::kernel_api::rt::workgroup(6u32),
            f32::from_bits(::kernel_api::rt::__k_spec(1u32, 3204448256u32)),
            ::kernel_api::rt::__k_spec(2u32, 1u32) != 0
        )
    };
    assert!(text.contains(&shim.to_string()), "{text}");
}

#[test]
fn a_kernel_with_workgroup_memory_is_no_pass() {
    let (mut entry, function) = everything();
    assert!(pass::pass(&entry, &function).is_empty());
    entry.parameters.retain(|p| p.name != "w");
    let text = pass::pass(&entry, &function).to_string();
    assert!(text.contains("struct AllOfIt {"), "{text}");
    assert!(text.contains("pub c : :: kernel_api :: Buffer < i32 >"), "{text}");
}
