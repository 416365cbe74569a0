//! The module: named types, globals, and the functions that are wanted.

use super::cursor::{Cursor, Locals, Names};
use super::debug::locations;
use super::function::function;
use super::lexer::{Token, tokens};
use crate::ir::{Function, Global, Module, Type};
use crate::refusal::Reason;
use std::collections::HashMap;

/// A function that could not be read.
#[derive(Debug, PartialEq)]
pub struct Unread {
    /// The symbol.
    pub name: String,
    /// All that is not known in it.
    pub problems: Vec<Problem>,
}

/// Something that is not known.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// What.
    pub reason: Reason,
    /// Where it comes from, for [`Locations`](crate::ir::Locations).
    pub location: Option<u32>,
}

/// What was read, and what could not be.
#[derive(Debug, Default)]
pub struct Parsed {
    /// The module with the functions that could be read.
    pub module: Module,
    /// The others.
    pub unread: Vec<Unread>,
}

/// Reads `text`; of its functions those that are `wanted` by name.
pub fn parse(text: &str, wanted: impl Fn(&str) -> bool) -> Parsed {
    let lines: Vec<&str> = text.lines().collect();
    let aliases: Vec<(String, String)> = lines.iter().filter_map(|line| alias(line)).collect();
    let is_needed =
        |name: &str| wanted(name) || aliases.iter().any(|(alias, of)| of == name && wanted(alias));
    let mut parsed = definitions(&lines, is_needed);
    for (alias, of) in aliases.iter().filter(|(alias, _)| wanted(alias)) {
        parsed.repeat(of, alias);
    }
    parsed.module.functions.retain(|function| wanted(&function.name));
    parsed.unread.retain(|unread| wanted(&unread.name));
    parsed
}

impl Parsed {
    /// What is known of the function `of` holds of `alias` too.
    fn repeat(&mut self, of: &str, alias: &str) {
        let function = self.module.functions.iter().find(|function| function.name == of).cloned();
        self.module.functions.extend(function.map(|function| Function { name: alias.into(), ..function }));
        let problems =
            self.unread.iter().find(|unread| unread.name == of).map(|unread| unread.problems.clone());
        self.unread.extend(problems.map(|problems| Unread { name: alias.into(), problems }));
        self.module.defined.insert(alias.into());
    }
}

/// The alias of a line `@A = unnamed_addr alias void (), ptr @B`, and what it stands for: LLVM keeps one of several functions with
/// the same code.
fn alias(line: &str) -> Option<(String, String)> {
    let (alias, of) = line.split_once(" = ").filter(|(_, rest)| rest.contains("alias void (), ptr @"))?;
    Some((alias.strip_prefix('@')?.into(), of.rsplit_once('@')?.1.into()))
}

fn definitions(lines: &[&str], wanted: impl Fn(&str) -> bool) -> Parsed {
    let names = Names { types: named_types(lines) };
    let mut parsed = Parsed::default();
    parsed.module.locations = locations(lines);
    let mut at = 0;
    while at < lines.len() {
        let line = lines[at];
        at += 1;
        if line.starts_with('@') {
            global(line, &names, &mut parsed.module);
        } else if line.starts_with("define ") {
            let end = lines[at..].iter().position(|l| *l == "}").map_or(lines.len(), |n| at + n);
            if let Some(name) = symbol(line) {
                define(name, &lines[at..end], &names, &wanted, &mut parsed);
            }
            at = end;
        }
    }
    parsed
}

fn define(name: String, body: &[&str], names: &Names, wanted: impl Fn(&str) -> bool, parsed: &mut Parsed) {
    if wanted(&name) {
        match function(&name, body, names) {
            Ok(function) => parsed.module.functions.push(function),
            Err(problems) => parsed.unread.push(Unread { name: name.clone(), problems }),
        }
    }
    parsed.module.defined.insert(name);
}

/// The name of the function that a line defines.
fn symbol(line: &str) -> Option<String> {
    tokens(line).ok()?.into_iter().find_map(|token| match token {
        Token::Global(name) => Some(name),
        _ => None,
    })
}

/// Types may refer to later ones: those whose parts are known are read until no more can be. The others stay unknown, and whoever
/// uses one is refused.
fn named_types(lines: &[&str]) -> HashMap<String, Type> {
    let mut names = Names::default();
    let mut open: Vec<&str> =
        lines.iter().copied().filter(|l| l.starts_with('%') && l.contains(" = type ")).collect();
    loop {
        let before = open.len();
        open.retain(|line| match named_type(line, &names) {
            Some((name, ty)) => {
                names.types.insert(name, ty);
                false
            }
            None => true,
        });
        if open.len() == before {
            return names.types;
        }
    }
}

fn named_type(line: &str, names: &Names) -> Option<(String, Type)> {
    let tokens = tokens(line).ok()?;
    let [Token::Local(name), ..] = &tokens[..] else {
        return None;
    };
    let locals = Locals::default();
    let ty = Cursor::new(line, tokens.get(3..)?, names, &locals).ty().ok()?;
    Some((name.clone(), ty))
}

/// A global, with its value if that is plain data. One that cannot be read is not known, and whoever uses it is refused.
fn global(line: &str, names: &Names, module: &mut Module) {
    let Ok(tokens) = tokens(line) else { return };
    let [Token::Global(name), ..] = &tokens[..] else { return };
    let is = |word: &str| tokens.iter().position(|t| matches!(t, Token::Word(w) if w == word));
    let (Some(start), constant) = (match is("constant") {
        Some(at) => (Some(at), true),
        None => (is("global"), false),
    }) else {
        return;
    };
    let locals = Locals::default();
    let mut cursor = Cursor::new(line, &tokens[start + 1..], names, &locals);
    let Ok(ty) = cursor.ty() else { return };
    let initializer = cursor.value(&ty).ok();
    module.globals.insert(name.as_str().into(), Global { ty, initializer, constant });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::Value;

    const TEXT: &str = "\
%A = type { %B, i32 }
%B = type { float }
@t = private unnamed_addr constant <{ [4 x i8], i32 }> <{ [4 x i8] c\"\\01\\00\\00\\00\", i32 -1 }>, align 4
@s = internal global [4 x i8] zeroinitializer, align 4
@r = private constant <{ ptr }> <{ ptr @t }>, align 8
define void @__kernel_a() unnamed_addr #1 {
  ret void
}
define internal i32 @other(i32 %x) {
  %y = nonsense i32 %x
  ret i32 %y
}
define void @__kernel_b() {
  nonsense
}
";

    #[test]
    fn only_what_is_wanted_is_read() {
        let parsed = parse(TEXT, |name| name.starts_with("__kernel_"));
        let module = &parsed.module;
        assert_eq!(module.functions.iter().map(|f| f.name.as_str()).collect::<Vec<_>>(), ["__kernel_a"]);
        assert_eq!(parsed.unread.len(), 1);
        assert_eq!(parsed.unread[0].name, "__kernel_b");
        assert!(module.defined.contains("other"));
        assert!(module.globals["t"].constant && !module.globals["s"].constant);
        assert_eq!(module.globals["t"].ty.size(), 8);
        assert!(
            matches!(&module.globals["t"].initializer, Some(Value::Aggregate(_, parts)) if parts.len() == 2)
        );
    }

    #[test]
    fn an_alias_is_a_function_of_its_own() {
        let text = TEXT.to_string()
            + "@__kernel_c = unnamed_addr alias void (), ptr @__kernel_a\n\
               @__kernel_d = unnamed_addr alias void (), ptr @__kernel_b\n";
        let parsed = parse(&text, |name| name == "__kernel_c" || name == "__kernel_d");
        let names: Vec<_> = parsed.module.functions.iter().map(|function| &*function.name).collect();
        assert_eq!(names, ["__kernel_c"]);
        assert_eq!(parsed.unread.iter().map(|unread| &*unread.name).collect::<Vec<_>>(), ["__kernel_d"]);
    }

    #[test]
    fn types_may_refer_to_later_ones() {
        let lines: Vec<&str> = TEXT.lines().collect();
        assert_eq!(named_types(&lines)["A"], Type::Struct(vec![Type::Struct(vec![Type::F32]), Type::I32]));
    }
}
