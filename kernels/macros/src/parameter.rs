//! Reads the declaration of one parameter.

use crate::entry::metas;
use proc_macro2::{Ident, TokenStream};
use syn::{
    Attribute, Error, Expr, ExprLit, GenericArgument, Lit, Meta, Pat, PatType, PathArguments, Result, Type,
};

/// One parameter of an entry point.
pub struct Parameter {
    pub name: Ident,
    pub kind: Kind,
    /// Its `#[spirv(…)]`.
    pub attribute: Attribute,
    /// Its type as declared.
    pub ty: Type,
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
    /// Words; `signed` ones are `AtomicI32`.
    Atomic {
        set: u32,
        binding: u32,
        signed: bool,
    },
    /// The type behind the reference.
    Workgroup {
        number: u32,
        ty: Type,
    },
    /// A specialisation constant; `ty` is `u32`, `f32` or `bool`.
    Constant {
        id: u32,
        default: u32,
        ty: Ident,
    },
}

impl Kind {
    /// Descriptor set and binding, if it is bound to one.
    pub fn place(&self) -> Option<(u32, u32)> {
        match *self {
            Kind::Uniform { set, binding, .. }
            | Kind::Read { set, binding, .. }
            | Kind::Write { set, binding, .. }
            | Kind::Atomic { set, binding, .. } => Some((set, binding)),
            Kind::Builtin(_) | Kind::Push { .. } | Kind::Workgroup { .. } | Kind::Constant { .. } => None,
        }
    }
}

const BUILTINS: [&str; 5] = [
    "global_invocation_id",
    "local_invocation_id",
    "workgroup_id",
    "num_workgroups",
    "local_invocation_index",
];

impl Parameter {
    /// Reads parameter `number` and removes its `#[spirv]`.
    pub fn read(argument: &mut PatType, number: u32) -> Result<Parameter> {
        let Pat::Ident(name) = &*argument.pat else {
            return Err(Error::new_spanned(
                &argument.pat,
                "a parameter of an entry point needs a plain name",
            ));
        };
        let name = name.ident.clone();
        let Some(at) = argument.attrs.iter().position(|a| a.path().is_ident("spirv")) else {
            return Err(Error::new_spanned(&name, "this parameter needs #[spirv(...)]"));
        };
        let attribute = argument.attrs.remove(at);
        let kind = Declared::read(&name, &attribute)?.kind(&argument.ty, number)?;
        Ok(Parameter { name, kind, attribute, ty: (*argument.ty).clone() })
    }
}

/// What stands in a parameter's `#[spirv(…)]`.
struct Declared {
    /// The storage class or built-in.
    class: Ident,
    /// What stands in its parentheses, for a specialisation constant.
    constant: Option<TokenStream>,
    set: u32,
    binding: Option<u32>,
}

impl Declared {
    fn read(name: &Ident, attribute: &Attribute) -> Result<Declared> {
        let (mut class, mut constant, mut set, mut binding) = (None, None, 0, None);
        for meta in metas(attribute.meta.require_list()?.tokens.clone())? {
            let first = match meta {
                Meta::Path(path) => class.replace(path.require_ident()?.clone()).is_none(),
                Meta::List(list) if list.path.is_ident("spec_constant") => {
                    constant = Some(list.tokens);
                    class.replace(list.path.require_ident()?.clone()).is_none()
                }
                Meta::NameValue(pair) if pair.path.is_ident("descriptor_set") => {
                    set = number_of(&pair.value)?;
                    true
                }
                Meta::NameValue(pair) if pair.path.is_ident("binding") => {
                    binding.replace(number_of(&pair.value)?).is_none()
                }
                other => return Err(Error::new_spanned(other, "unknown attribute of a parameter")),
            };
            if !first {
                return Err(Error::new_spanned(attribute, "declared twice"));
            }
        }
        let missing = || Error::new_spanned(name, "missing storage class or builtin");
        Ok(Declared { class: class.ok_or_else(missing)?, constant, set, binding })
    }

    fn bound(&self) -> Result<(u32, u32)> {
        let missing = || Error::new_spanned(&self.class, "missing `binding = n`");
        Ok((self.set, self.binding.ok_or_else(missing)?))
    }

    fn unknown(&self) -> Error {
        const KNOWN: &str = "storage_buffer, uniform, push_constant, workgroup, spec_constant(…)";
        let message = format!("unknown storage class or builtin: known are {KNOWN}, {}", BUILTINS.join(", "));
        Error::new_spanned(&self.class, message)
    }

    fn kind(self, ty: &Type, number: u32) -> Result<Kind> {
        let class = self.class.to_string();
        Ok(match class.as_str() {
            "storage_buffer" => {
                let (set, binding) = self.bound()?;
                storage(set, binding, ty)?
            }
            "uniform" => {
                let (set, binding) = self.bound()?;
                Kind::Uniform { set, binding, ty: referent(ty)? }
            }
            "push_constant" => Kind::Push { ty: referent(ty)? },
            "workgroup" => Kind::Workgroup { number, ty: referent(ty)? },
            "spec_constant" => {
                let missing =
                    || Error::new_spanned(&self.class, "expected spec_constant(id = n, default = value)");
                constant(self.constant.ok_or_else(missing)?, ty)?
            }
            name if BUILTINS.contains(&name) => Kind::Builtin(self.class),
            _ => return Err(self.unknown()),
        })
    }
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

/// `&[T]`, `&[AtomicU32]`, `&[AtomicI32]` or `Out<T>`.
fn storage(set: u32, binding: u32, ty: &Type) -> Result<Kind> {
    const EXPECTED: &str =
        "a storage buffer is `&[T]` (read), `Out<T>` (written) or `&[AtomicU32]` or `&[AtomicI32]` (shared)";
    let unexpected = || Error::new_spanned(ty, EXPECTED);
    if let Type::Reference(reference) = ty {
        let (None, Type::Slice(slice)) = (reference.mutability, &*reference.elem) else {
            return Err(unexpected());
        };
        let element = (*slice.elem).clone();
        return Ok(match last_segment(&element).map(|s| s.ident.to_string()).as_deref() {
            Some("AtomicU32") => Kind::Atomic { set, binding, signed: false },
            Some("AtomicI32") => Kind::Atomic { set, binding, signed: true },
            _ => Kind::Read { set, binding, element },
        });
    }
    match last_segment(ty) {
        Some(segment) if segment.ident == "Out" => {
            let element = type_arguments(segment).into_iter().next().ok_or_else(unexpected)?;
            Ok(Kind::Write { set, binding, element })
        }
        _ => Err(unexpected()),
    }
}

/// The last part of a type's path.
pub fn last_segment(ty: &Type) -> Option<&syn::PathSegment> {
    match ty {
        Type::Path(path) => path.path.segments.last(),
        _ => None,
    }
}

/// The types among the `<…>` of a path's part.
fn type_arguments(segment: &syn::PathSegment) -> Vec<Type> {
    let PathArguments::AngleBracketed(arguments) = &segment.arguments else {
        return Vec::new();
    };
    let types = arguments.args.iter().filter_map(|argument| match argument {
        GenericArgument::Type(ty) => Some(ty.clone()),
        _ => None,
    });
    types.collect()
}

fn constant(tokens: TokenStream, ty: &Type) -> Result<Kind> {
    let word = last_segment(ty).map(|s| s.ident.clone()).filter(|t| t == "u32" || t == "f32" || t == "bool");
    let word =
        word.ok_or_else(|| Error::new_spanned(ty, "a specialisation constant is a u32, f32 or bool"))?;
    let (mut id, mut default) = (None, 0);
    for meta in metas(tokens.clone())? {
        let pair = meta.require_name_value()?;
        if pair.path.is_ident("id") {
            id = Some(number_of(&pair.value)?);
        } else if pair.path.is_ident("default") {
            default = default_bits(&pair.value, &word)?;
        } else {
            return Err(Error::new_spanned(pair, "expected `id` or `default`"));
        }
    }
    let id = id.ok_or_else(|| Error::new_spanned(tokens, "missing `id = n`"))?;
    Ok(Kind::Constant { id, default, ty: word })
}

/// The bits of a default value, which must be a literal of the constant's type.
fn default_bits(value: &Expr, ty: &Ident) -> Result<u32> {
    let (literal, negative) = match value {
        Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Neg(_)) => (&*unary.expr, true),
        other => (other, false),
    };
    let literal = match literal {
        Expr::Lit(literal) => Some(&literal.lit),
        _ => None,
    };
    let other = || Error::new_spanned(value, format!("expected a literal of type {ty}"));
    match (literal, ty.to_string().as_str(), negative) {
        (Some(Lit::Int(number)), "u32", false) => number.base10_parse().map_err(|_| other()),
        (Some(Lit::Bool(flag)), "bool", false) => Ok(flag.value as u32),
        (Some(Lit::Float(number)), "f32", _) => {
            let magnitude = number.base10_parse::<f32>()?;
            Ok(if negative { -magnitude } else { magnitude }.to_bits())
        }
        _ => Err(other()),
    }
}
