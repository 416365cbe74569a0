//! The body of a function.

use super::Result;
use super::cursor::{Cursor, Locals, Names};
use super::debug::location;
use super::instructions::Line;
use super::lexer::{Token, tokens};
use super::module::Problem;
use crate::ir::{Block, BlockId, Function, Id, Op, Terminator, Type, Value};

/// Reads the lines between `define … {` and `}`.
///
/// # Errors
/// All that is not known, line by line.
pub fn function(name: &str, lines: &[&str], names: &Names) -> std::result::Result<Function, Vec<Problem>> {
    let logical = logical_lines(lines);
    let tokens: Result<Vec<Vec<Token>>> = logical.iter().map(|line| tokens(line)).collect();
    let tokens = tokens.map_err(|reason| vec![Problem { reason, location: None }])?;
    let mut body = Body::declare(name, &tokens);
    for (text, tokens) in logical.iter().zip(&tokens) {
        if let Err(reason) = body.line(text, tokens, names) {
            body.problems.push(Problem { reason, location: location(text) });
        }
    }
    if body.problems.is_empty() { Ok(body.function) } else { Err(body.problems) }
}

/// Lines without blank ones and comments; a `switch` is one line.
fn logical_lines(lines: &[&str]) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let mut open = false;
    for line in lines.iter().map(|line| line.trim_end()) {
        let text = line.trim_start();
        if text.is_empty() || text.starts_with(';') {
            continue;
        }
        match out.last_mut() {
            Some(last) if open => {
                last.push(' ');
                last.push_str(text);
            }
            _ => out.push(line.to_string()),
        }
        open =
            if open { !text.starts_with(']') } else { text.starts_with("switch ") && !text.ends_with(']') };
    }
    out
}

/// The label, if the line is one.
fn label(tokens: &[Token]) -> Option<String> {
    match tokens {
        [Token::Word(name) | Token::Number(name), Token::Mark(':')] => Some(name.clone()),
        [Token::Text(name), Token::Mark(':')] => Some(String::from_utf8_lossy(name).into_owned()),
        _ => None,
    }
}

/// The name of the result, if the line has one.
fn result(tokens: &[Token]) -> Option<&str> {
    match tokens {
        [Token::Local(name), Token::Mark('='), ..] => Some(name),
        _ => None,
    }
}

struct Body {
    function: Function,
    locals: Locals,
    current: BlockId,
    problems: Vec<Problem>,
}

impl Body {
    /// Numbers all blocks and results, since lines refer to later ones.
    fn declare(name: &str, lines: &[Vec<Token>]) -> Self {
        let function = Function { name: name.into(), ..Function::default() };
        let mut body = Self { function, locals: Locals::default(), current: BlockId(0), problems: vec![] };
        if lines.first().is_none_or(|line| label(line).is_none()) {
            body.add_block("entry".into());
        }
        for line in lines {
            if let Some(name) = label(line) {
                body.add_block(name);
            } else if let Some(name) = result(line) {
                let id = body.reserve(name);
                body.locals.values.insert(name.into(), id);
            }
        }
        body
    }

    fn add_block(&mut self, name: String) {
        self.locals.blocks.insert(name.clone(), BlockId::new(self.function.blocks.len()));
        self.function.blocks.push(Block { name, instructions: vec![], terminator: Terminator::Unreachable });
    }

    fn reserve(&mut self, name: &str) -> Id {
        let id = self.function.push(Op::Copy(Value::Undef(Type::Void)), Type::Void);
        self.function[id].name = name.into();
        id
    }

    fn line(&mut self, text: &str, tokens: &[Token], names: &Names) -> Result<()> {
        if let Some(block) = label(tokens).and_then(|name| self.locals.blocks.get(&name)) {
            self.current = *block;
            return Ok(());
        }
        let name = result(tokens);
        let start = if name.is_some() { 2 } else { 0 };
        let line = Cursor::new(text, &tokens[start..], names, &self.locals).line()?;
        match line {
            Line::Terminator(terminator) => self.function[self.current].terminator = terminator,
            Line::Instruction { op, ty, exact } => {
                let id = name.and_then(|name| self.locals.values.get(name).copied());
                let id = id.unwrap_or_else(|| self.reserve(""));
                let instruction = &mut self.function[id];
                (instruction.op, instruction.ty, instruction.exact) = (op, ty, exact);
                instruction.location = location(text);
                self.function[self.current].instructions.push(id);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{BinaryOp, IntPredicate};

    fn read(text: &str) -> std::result::Result<Function, Vec<Problem>> {
        function("f", &text.lines().collect::<Vec<_>>(), &Names::default())
    }

    #[test]
    fn a_loop() {
        let f = read(
            "start:
  br label %head

head:                            ; preds = %head, %start
  %i = phi i32 [ 0, %start ], [ %n, %head ], !dbg !3
  %n = add nuw i32 %i, 1
  %c = icmp samesign ult i32 %n, 10
  br i1 %c, label %head, label %\"the end\"

\"the end\":
  ret void",
        )
        .expect("a function");
        let head = &f[BlockId(1)];
        let ops: Vec<_> = head.instructions.iter().map(|id| f[*id].op.clone()).collect();
        let (i, n) = (Value::Inst(head.instructions[0]), Value::Inst(head.instructions[1]));
        assert_eq!(ops[0], Op::Phi(vec![(Value::u32(0), BlockId(0)), (n.clone(), BlockId(1))]));
        assert_eq!(ops[1], Op::Binary(BinaryOp::Add, i, Value::u32(1)));
        assert!(f[head.instructions[1]].exact);
        assert_eq!(ops[2], Op::IntCompare(IntPredicate::Ult, n, Value::u32(10)));
        assert_eq!(head.terminator.successors(), [BlockId(1), BlockId(2)]);
        assert_eq!(f[BlockId(2)].terminator, Terminator::Return);
    }

    #[test]
    fn a_switch_over_several_lines() {
        let f = read(
            "  switch i32 0, label %a [\n    i32 1, label %b\n    i32 -1, label %a\n  ]\na:\n  ret void\nb:\n  ret void",
        );
        let terminator = f.expect("a function").blocks[0].terminator.clone();
        let cases = vec![(1, BlockId(2)), (0xffff_ffff, BlockId(1))];
        assert_eq!(terminator, Terminator::Switch(Value::u32(0), BlockId(1), cases));
    }

    #[test]
    fn all_problems_are_named() {
        let problems = read(
            "  %a = fadd contract float 0.0, 0.0
  %b = va_arg ptr null, i32
  %c = load atomic i32, ptr %p acquire, align 4
  call void %a(i32 1)
  fence seq_cst
  ret void",
        )
        .expect_err("nothing of this is known");
        let text: Vec<String> = problems.iter().map(|problem| problem.reason.to_string()).collect();
        for (text, part) in text.iter().zip(["`contract`", "`va_arg`", "%p", "function pointer", "fence"]) {
            assert!(text.contains(part), "{text}");
        }
        assert_eq!(problems.len(), 5);
    }
}
