//! Reads the declaration of an entry point.

use proc_macro2::{Ident, TokenStream};
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::{Error, Expr, ExprLit, FnArg, ItemFn, Lit, LitInt, Meta, Pat, PatType, Result, Token, Type};

/// An entry point as declared.
pub struct Entry {
    pub threads: [u32; 3],
    pub parameters: Vec<Parameter>,
}

/// One parameter of an entry point.
pub struct Parameter {
    pub name: Ident,
    pub kind: Kind,
}

/// What a parameter is made from.
pub enum Kind {
    /// `global_invocation_id` and its like, by name.
    Builtin(Ident),
    /// The type behind the reference.
    Uniform {
        set: u32,
        binding: u32,
        ty: Type,
    },
    Push {
        ty: Type,
    },
    /// The element type.
    Read {
        set: u32,
        binding: u32,
        element: Type,
    },
    Write {
        set: u32,
        binding: u32,
        element: Type,
    },
    Atomic {
        set: u32,
        binding: u32,
    },
    Workgroup {
        number: u32,
    },
    /// A specialisation constant; `ty` is `u32`, `f32` or `bool`.
    Constant {
        id: u32,
        default: u32,
        ty: Ident,
    },
}

const BUILTINS: [&str; 5] = [
    "global_invocation_id",
    "local_invocation_id",
    "workgroup_id",
    "num_workgroups",
    "local_invocation_index",
];

impl Entry {
    /// Reads `#[spirv(attribute)]` and removes the `#[spirv]` of each parameter from `function`.
    pub fn read(attribute: TokenStream, function: &mut ItemFn) -> Result<Entry> {
        let threads = threads(attribute, function)?;
        let mut parameters = Vec::new();
        for input in &mut function.sig.inputs {
            let FnArg::Typed(argument) = input else {
                return Err(Error::new_spanned(input, "an entry point cannot take `self`"));
            };
            parameters.push(parameter(argument, parameters.len() as u32)?);
        }
        Ok(Entry { threads, parameters })
    }
}

fn metas(tokens: TokenStream) -> Result<Vec<Meta>> {
    Ok(Punctuated::<Meta, Token![,]>::parse_terminated.parse2(tokens)?.into_iter().collect())
}

fn threads(attribute: TokenStream, function: &ItemFn) -> Result<[u32; 3]> {
    const EXPECTED: &str = "expected #[spirv(compute(threads(x, y, z)))]";
    for meta in metas(attribute)? {
        let list = meta.require_list()?;
        if !list.path.is_ident("compute") {
            return Err(Error::new_spanned(list, EXPECTED));
        }
        for meta in metas(list.tokens.clone())? {
            let list = meta.require_list()?;
            if !list.path.is_ident("threads") {
                return Err(Error::new_spanned(list, EXPECTED));
            }
            let counts = Punctuated::<LitInt, Token![,]>::parse_terminated.parse2(list.tokens.clone())?;
            if counts.is_empty() || counts.len() > 3 {
                return Err(Error::new_spanned(list, "one to three numbers of threads"));
            }
            let mut threads = [1; 3];
            for (slot, count) in threads.iter_mut().zip(&counts) {
                *slot = count.base10_parse()?;
            }
            return Ok(threads);
        }
    }
    Err(Error::new_spanned(&function.sig.ident, EXPECTED))
}

fn parameter(argument: &mut PatType, number: u32) -> Result<Parameter> {
    let Pat::Ident(name) = &*argument.pat else {
        return Err(Error::new_spanned(&argument.pat, "a parameter of an entry point needs a plain name"));
    };
    let name = name.ident.clone();
    let Some(at) = argument.attrs.iter().position(|a| a.path().is_ident("spirv")) else {
        return Err(Error::new_spanned(&argument.pat, "this parameter needs #[spirv(...)]"));
    };
    let attribute = argument.attrs.remove(at);
    let (mut class, mut set, mut binding) = (None, 0, None);
    for meta in metas(attribute.meta.require_list()?.tokens.clone())? {
        match meta {
            Meta::Path(path) => class = path.get_ident().cloned(),
            Meta::NameValue(pair) if pair.path.is_ident("descriptor_set") => set = number_of(&pair.value)?,
            Meta::NameValue(pair) if pair.path.is_ident("binding") => binding = Some(number_of(&pair.value)?),
            Meta::List(list) if list.path.is_ident("spec_constant") => {
                return Ok(Parameter { name, kind: constant(list.tokens, &argument.ty)? });
            }
            other => return Err(Error::new_spanned(other, "unknown attribute of a parameter")),
        }
    }
    let Some(class) = class else {
        return Err(Error::new_spanned(&argument.pat, "missing storage class or builtin"));
    };
    let bound = || binding.ok_or_else(|| Error::new_spanned(&argument.pat, "missing `binding = n`"));
    let kind = match class.to_string().as_str() {
        "uniform" => Kind::Uniform { set, binding: bound()?, ty: referent(&argument.ty)? },
        "push_constant" => Kind::Push { ty: referent(&argument.ty)? },
        "storage_buffer" => storage(set, bound()?, &argument.ty)?,
        "workgroup" => Kind::Workgroup { number },
        builtin if BUILTINS.contains(&builtin) => Kind::Builtin(class),
        _ => return Err(Error::new_spanned(class, "unknown storage class or builtin")),
    };
    Ok(Parameter { name, kind })
}

fn number_of(value: &Expr) -> Result<u32> {
    match value {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse(),
        other => Err(Error::new_spanned(other, "expected a number")),
    }
}

/// The `T` of `&T`.
fn referent(ty: &Type) -> Result<Type> {
    match ty {
        Type::Reference(reference) if reference.mutability.is_none() => Ok((*reference.elem).clone()),
        other => Err(Error::new_spanned(other, "expected a shared reference")),
    }
}

/// `&[T]`, `&[AtomicU32]` or `Out<T>`.
fn storage(set: u32, binding: u32, ty: &Type) -> Result<Kind> {
    const EXPECTED: &str = "a storage buffer is `&[T]` (read), `Out<T>` (written) or `&[AtomicU32]`";
    match ty {
        Type::Reference(reference) if reference.mutability.is_none() => {
            let Type::Slice(slice) = &*reference.elem else {
                return Err(Error::new_spanned(ty, EXPECTED));
            };
            if last_segment(&slice.elem).is_some_and(|s| s.ident == "AtomicU32") {
                return Ok(Kind::Atomic { set, binding });
            }
            Ok(Kind::Read { set, binding, element: (*slice.elem).clone() })
        }
        _ => {
            let segment = last_segment(ty).filter(|s| s.ident == "Out");
            let syn::PathArguments::AngleBracketed(arguments) =
                &segment.ok_or_else(|| Error::new_spanned(ty, EXPECTED))?.arguments
            else {
                return Err(Error::new_spanned(ty, EXPECTED));
            };
            let element = arguments.args.iter().find_map(|a| match a {
                syn::GenericArgument::Type(ty) => Some(ty.clone()),
                _ => None,
            });
            let element = element.ok_or_else(|| Error::new_spanned(ty, EXPECTED))?;
            Ok(Kind::Write { set, binding, element })
        }
    }
}

fn last_segment(ty: &Type) -> Option<&syn::PathSegment> {
    match ty {
        Type::Path(path) => path.path.segments.last(),
        _ => None,
    }
}

fn constant(tokens: TokenStream, ty: &Type) -> Result<Kind> {
    let ty = last_segment(ty).map(|s| s.ident.clone()).filter(|t| t == "u32" || t == "f32" || t == "bool");
    let (mut id, mut default) = (None, 0);
    for meta in metas(tokens.clone())? {
        let pair = meta.require_name_value()?;
        if pair.path.is_ident("id") {
            id = Some(number_of(&pair.value)?);
        } else if pair.path.is_ident("default") {
            default = default_bits(&pair.value)?;
        } else {
            return Err(Error::new_spanned(pair, "expected `id` or `default`"));
        }
    }
    match (id, ty) {
        (Some(id), Some(ty)) => Ok(Kind::Constant { id, default, ty }),
        (None, _) => Err(Error::new_spanned(tokens, "missing `id = n`")),
        (_, None) => Err(Error::new_spanned(tokens, "a specialisation constant is a u32, f32 or bool")),
    }
}

fn default_bits(value: &Expr) -> Result<u32> {
    match value {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse(),
        Expr::Lit(ExprLit { lit: Lit::Float(number), .. }) => Ok(number.base10_parse::<f32>()?.to_bits()),
        Expr::Lit(ExprLit { lit: Lit::Bool(flag), .. }) => Ok(flag.value as u32),
        other => Err(Error::new_spanned(other, "expected a literal")),
    }
}
