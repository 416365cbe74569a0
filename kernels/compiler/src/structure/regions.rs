//! The walk over the regions of the control flow graph.

use super::Statement;
use super::dominators::Dominators;
use crate::ir::{BlockId, Function, Id, Op, Terminator, Value};
use crate::refusal::Reason;

/// The statements of a function.
pub fn statements(function: &Function) -> Result<Vec<Statement>, Reason> {
    let successors = successors(function);
    let dominators = Dominators::new(&successors, 0);
    let mut walk = Walk {
        function,
        latch: latches(function, &successors, &dominators)?,
        join: joins(function, &successors, &dominators),
        seen: vec![false; function.blocks.len()],
        loops: 0,
    };
    let mut statements = Vec::new();
    walk.region(Some(BlockId(0)), None, &mut statements)?;
    let missed = function.block_ids().find(|b| dominators.reaches(b.index()) && !walk.seen[b.index()]);
    match missed {
        Some(block) => Err(refused(function, block, "is not reached by nested control flow")),
        None => Ok(statements),
    }
}

fn refused(function: &Function, block: BlockId, what: &str) -> Reason {
    Reason::ControlFlow(format!("the control flow is not nested: block `{}` {what}", function[block].name))
}

fn successors(function: &Function) -> Vec<Vec<usize>> {
    let indices = |blocks: Vec<BlockId>| blocks.into_iter().map(BlockId::index).collect();
    function.blocks.iter().map(|block| indices(block.terminator.successors())).collect()
}

/// For each loop header its latch, the one block that goes back to it.
fn latches(
    function: &Function,
    successors: &[Vec<usize>],
    dominators: &Dominators,
) -> Result<Vec<Option<BlockId>>, Reason> {
    let mut latch = vec![None; successors.len()];
    for &from in &dominators.reverse_postorder {
        for &to in successors[from].iter().filter(|&&to| dominators.dominates(to, from)) {
            if latch[to].replace(BlockId::new(from)).is_some() {
                return Err(refused(function, BlockId::new(to), "begins a loop with two ends"));
            }
        }
    }
    Ok(latch)
}

/// For each block the one where all ways from it meet again: its immediate post-dominator. Ways to
/// `unreachable` do not count.
fn joins(function: &Function, successors: &[Vec<usize>], dominators: &Dominators) -> Vec<Option<BlockId>> {
    let exit = successors.len();
    let mut reversed = vec![Vec::new(); exit + 1];
    for from in (0..exit).filter(|&block| dominators.reaches(block)) {
        successors[from].iter().for_each(|&to| reversed[to].push(from));
        if function.blocks[from].terminator == Terminator::Return {
            reversed[exit].push(from);
        }
    }
    let post = Dominators::new(&reversed, exit);
    let join = |block| post.immediate(block).filter(|&join| join != exit).map(BlockId::new);
    (0..exit).map(join).collect()
}

struct Walk<'a> {
    function: &'a Function,
    latch: Vec<Option<BlockId>>,
    join: Vec<Option<BlockId>>,
    seen: Vec<bool>,
    /// How many loops there are around the current block.
    loops: u32,
}

impl Walk<'_> {
    /// From the block `next` up to, but not including, `stop`.
    fn region(
        &mut self,
        mut next: Option<BlockId>,
        stop: Option<BlockId>,
        out: &mut Vec<Statement>,
    ) -> Result<(), Reason> {
        while let Some(block) = next.filter(|_| next != stop) {
            next = match self.latch[block.index()] {
                Some(latch) => Some(self.whole_loop(block, latch, out)?),
                None => self.block(block, out)?,
            };
        }
        Ok(())
    }

    /// The loop that begins at `header`; the result is where it is left to.
    fn whole_loop(
        &mut self,
        header: BlockId,
        latch: BlockId,
        out: &mut Vec<Statement>,
    ) -> Result<BlockId, Reason> {
        let mut body = Vec::new();
        self.loops += 1;
        let next = self.block(header, &mut body)?;
        self.region(next, None, &mut body)?;
        self.loops -= 1;
        let (condition, leaves_when, exit) = match &self.function[latch].terminator {
            Terminator::Condition(c, then, exit) if *then == header && *exit != header => (c, false, *exit),
            Terminator::Condition(c, exit, other) if *other == header => (c, true, *exit),
            _ => return Err(refused(self.function, header, "begins a loop that is never left at its end")),
        };
        self.edge(latch, header, &mut body);
        self.edge(latch, exit, &mut body);
        out.push(Statement::Loop { body, condition: condition.clone(), leaves_when });
        Ok(exit)
    }

    /// One block and, if it decides something, both sides; the result is where it goes on. A latch goes
    /// nowhere: its loop does.
    fn block(&mut self, block: BlockId, out: &mut Vec<Statement>) -> Result<Option<BlockId>, Reason> {
        if std::mem::replace(&mut self.seen[block.index()], true) {
            return Err(refused(self.function, block, "is reached along two ways"));
        }
        let function = self.function;
        out.extend(function[block].instructions.iter().map(|&id| match function[id].op {
            Op::Phi(_) => Statement::Phi(id),
            _ => Statement::Instruction(id),
        }));
        match &function[block].terminator {
            _ if self.latch.contains(&Some(block)) => Ok(None),
            Terminator::Return if self.loops > 0 => {
                Err(refused(function, block, "returns from inside a loop"))
            }
            Terminator::Return => {
                out.push(Statement::Return);
                Ok(None)
            }
            Terminator::Unreachable => {
                out.push(Statement::Unreachable);
                Ok(None)
            }
            Terminator::Branch(to) => Ok(Some(self.edge(block, *to, out))),
            Terminator::Condition(_, to, same) if to == same => Ok(Some(self.edge(block, *to, out))),
            Terminator::Condition(condition, then, otherwise) => {
                self.condition(block, condition, [*then, *otherwise], out)
            }
            Terminator::Switch(..) => Err(refused(function, block, "ends in a switch")),
        }
    }

    fn condition(
        &mut self,
        block: BlockId,
        condition: &Value,
        sides: [BlockId; 2],
        out: &mut Vec<Statement>,
    ) -> Result<Option<BlockId>, Reason> {
        let join = self.join[block.index()];
        let mut side = |to: BlockId| {
            let mut statements = Vec::new();
            self.edge(block, to, &mut statements);
            self.region(Some(to), join, &mut statements).map(|()| statements)
        };
        let (then, otherwise) = (side(sides[0])?, side(sides[1])?);
        out.push(Statement::If { condition: condition.clone(), then, otherwise });
        Ok(join)
    }

    /// Sets the phis of `to` as the edge from `from` does; returns `to`.
    fn edge(&self, from: BlockId, to: BlockId, out: &mut Vec<Statement>) -> BlockId {
        let value = |id: Id| match &self.function[id].op {
            Op::Phi(edges) => edges.iter().find(|edge| edge.1 == from).map(|edge| (id, edge.0.clone())),
            _ => None,
        };
        // An undefined value may as well be the variable's old one.
        let defined = |set: &(_, Value)| !set.1.is_undef();
        let sets: Vec<_> =
            self.function[to].instructions.iter().filter_map(|&id| value(id)).filter(defined).collect();
        if !sets.is_empty() {
            out.push(Statement::Set(sets));
        }
        to
    }
}
