//! Reads the declaration of an entry point.

use crate::parameter::{Kind, Parameter};
use proc_macro2::TokenStream;
use quote::ToTokens;
use std::collections::{BTreeMap, HashSet};
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::{Error, FnArg, Ident, ItemFn, LitInt, Meta, Result, ReturnType, Token};

/// An entry point as declared.
pub struct Entry {
    pub threads: [u32; 3],
    pub parameters: Vec<Parameter>,
}

/// The most invocations of a workgroup that common devices run.
const MOST_THREADS: u64 = 1024;

impl Entry {
    /// Reads `#[spirv(attribute)]` and removes the `#[spirv]` of each parameter from `function`.
    pub fn read(attribute: TokenStream, function: &mut ItemFn) -> Result<Entry> {
        let threads = threads(attribute, function)?;
        plain(function)?;
        let mut parameters = Vec::new();
        for input in &mut function.sig.inputs {
            let FnArg::Typed(argument) = input else {
                return Err(Error::new_spanned(input, "an entry point cannot take `self`"));
            };
            parameters.push(Parameter::read(argument, parameters.len() as u32)?);
        }
        distinct(&parameters)?;
        without_gaps(&parameters)?;
        Ok(Entry { threads, parameters })
    }
}

/// The comma-separated parts of an attribute.
pub fn metas(tokens: TokenStream) -> Result<Vec<Meta>> {
    Ok(Punctuated::<Meta, Token![,]>::parse_terminated.parse2(tokens)?.into_iter().collect())
}

/// The workgroup size.
fn threads(attribute: TokenStream, function: &ItemFn) -> Result<[u32; 3]> {
    const EXPECTED: &str = "expected #[spirv(compute(threads(x, y, z)))]";
    let expected = |tokens: &dyn ToTokens| Error::new_spanned(tokens.to_token_stream(), EXPECTED);
    let [Meta::List(compute)] = &metas(attribute)?[..] else {
        return Err(expected(&function.sig.ident));
    };
    let [Meta::List(threads)] = &metas(compute.tokens.clone())?[..] else {
        return Err(expected(compute));
    };
    if !compute.path.is_ident("compute") || !threads.path.is_ident("threads") {
        return Err(expected(compute));
    }
    let counts = Punctuated::<LitInt, Token![,]>::parse_terminated.parse2(threads.tokens.clone())?;
    if counts.is_empty() || counts.len() > 3 {
        return Err(Error::new_spanned(threads, "one to three numbers of threads"));
    }
    let mut sizes = [1u32; 3];
    for (size, count) in sizes.iter_mut().zip(&counts) {
        *size = count.base10_parse()?;
    }
    let all = sizes.iter().try_fold(1u64, |all, &size| all.checked_mul(size as u64)).unwrap_or(u64::MAX);
    if !(1..=MOST_THREADS).contains(&all) {
        return Err(Error::new_spanned(
            threads,
            format!("a workgroup has 1 to {MOST_THREADS} invocations, not {all}"),
        ));
    }
    Ok(sizes)
}

/// An entry point is a function that a device can start.
fn plain(function: &ItemFn) -> Result<()> {
    let signature = &function.sig;
    if let ReturnType::Type(_, ty) = &signature.output {
        return Err(Error::new_spanned(ty, "an entry point returns nothing: put results into an `Out<T>`"));
    }
    if !signature.generics.params.is_empty() {
        let message =
            "an entry point cannot be generic: write one for each type that calls the generic function";
        return Err(Error::new_spanned(&signature.generics, message));
    }
    let word = match (&signature.asyncness, &signature.unsafety, &signature.constness) {
        (Some(word), ..) => word.to_token_stream(),
        (_, Some(word), _) => word.to_token_stream(),
        (.., Some(word)) => word.to_token_stream(),
        _ => return Ok(()),
    };
    Err(Error::new_spanned(&word, format!("an entry point cannot be `{word}`")))
}

/// The bindings of each descriptor set count from 0: with a gap (seen with wgpu 30 on lavapipe) the buffers behind it stay unwritten.
fn without_gaps(parameters: &[Parameter]) -> Result<()> {
    let mut sets = BTreeMap::<u32, BTreeMap<u32, &Ident>>::new();
    for parameter in parameters {
        if let Some((set, binding)) = parameter.kind.place() {
            sets.entry(set).or_default().insert(binding, &parameter.name);
        }
    }
    for (set, bindings) in sets {
        for (expected, (binding, name)) in (0..).zip(bindings) {
            if binding != expected {
                let message = format!(
                    "descriptor set {set} has no binding {expected}: bindings count from 0 without gaps"
                );
                return Err(Error::new_spanned(name, message));
            }
        }
    }
    Ok(())
}

/// No two parameters may claim one binding, the push constant or one specialisation constant.
fn distinct(parameters: &[Parameter]) -> Result<()> {
    let mut seen = HashSet::new();
    for parameter in parameters {
        let what = match &parameter.kind {
            Kind::Push { .. } => "the push constant".to_string(),
            Kind::Constant { id, .. } => format!("specialisation constant {id}"),
            kind => match kind.place() {
                Some((set, binding)) => format!("binding {binding} of descriptor set {set}"),
                None => continue,
            },
        };
        if !seen.insert(what.clone()) {
            return Err(Error::new_spanned(&parameter.name, format!("{what} is declared twice")));
        }
    }
    Ok(())
}
