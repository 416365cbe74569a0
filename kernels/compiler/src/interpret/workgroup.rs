//! The invocations of one workgroup, from one place where they wait for each other to the next.

use super::invocation::{Invocation, Position, Stop};
use super::memory::{Arrays, Memory};
use super::{Arguments, InterpretError};
use crate::ir::{Id, Kernel, Space, SubgroupOp};

/// Runs the workgroup number `group`.
pub fn run(
    kernel: &Kernel,
    group: [u32; 3],
    groups: [u32; 3],
    arguments: &mut Arguments,
) -> Result<(), InterpretError> {
    let threads: u32 = kernel.threads.iter().product();
    let subgroup_size = if arguments.subgroup_size == 0 { threads } else { arguments.subgroup_size };
    let shared = Arrays::new(kernel, |space| matches!(space, Space::Workgroup(_)));
    let mut memory = Memory { kernel, arguments, shared };
    let position = |index| Position { local: local_id(index, kernel.threads), group, groups, subgroup_size };
    let mut invocations: Vec<_> = (0..threads).map(|i| Invocation::new(kernel, position(i))).collect();
    loop {
        let stops: Vec<Stop> =
            invocations.iter_mut().map(|i| i.run(&mut memory)).collect::<Result<_, _>>()?;
        let Some(meeting) = meeting(&stops)? else { return Ok(()) };
        let values = match meeting {
            Meeting::Barrier(_) => vec![0; invocations.len()],
            Meeting::Subgroup(_, op) => over_subgroups(op, &stops, subgroup_size)?,
        };
        let (Meeting::Barrier(at) | Meeting::Subgroup(at, _)) = meeting;
        invocations.iter_mut().zip(values).for_each(|(invocation, value)| invocation.resume(at, value));
    }
}

fn local_id(index: u32, threads: [u32; 3]) -> [u32; 3] {
    [index % threads[0], index / threads[0] % threads[1], index / threads[0] / threads[1]]
}

/// Where the invocations of a workgroup wait for each other.
enum Meeting {
    Barrier(Id),
    Subgroup(Id, SubgroupOp),
}

/// Where all wait, or `None` if all are at their end.
fn meeting(stops: &[Stop]) -> Result<Option<Meeting>, InterpretError> {
    let same = |a: &Stop, b: &Stop| match (a, b) {
        (Stop::Subgroup(a, ..), Stop::Subgroup(b, ..)) => a == b,
        _ => a == b,
    };
    if stops.iter().any(|stop| !same(stop, &stops[0])) {
        return Err(InterpretError::Divergence);
    }
    Ok(match stops.first() {
        Some(Stop::Barrier(id)) => Some(Meeting::Barrier(*id)),
        Some(Stop::Subgroup(id, op, _)) => Some(Meeting::Subgroup(*id, *op)),
        Some(Stop::Finished) | None => None,
    })
}

/// The result of a subgroup operation in each invocation.
fn over_subgroups(op: SubgroupOp, stops: &[Stop], size: u32) -> Result<Vec<u128>, InterpretError> {
    let operands: Vec<&[u128]> = stops
        .iter()
        .map(|stop| match stop {
            Stop::Subgroup(_, _, operands) => operands.as_slice(),
            _ => &[],
        })
        .collect();
    let mut results = Vec::with_capacity(operands.len());
    for subgroup in operands.chunks(size as usize) {
        for operands in subgroup {
            results.push(over_subgroup(op, subgroup, operands)?);
        }
    }
    Ok(results)
}

/// The result in the invocation that brings the operands `own`.
fn over_subgroup(op: SubgroupOp, subgroup: &[&[u128]], own: &[u128]) -> Result<u128, InterpretError> {
    let words = subgroup.iter().filter_map(|operands| operands.first().copied());
    Ok(match op {
        SubgroupOp::Add => words.sum::<u128>() & 0xffff_ffff,
        SubgroupOp::UMin => words.min().unwrap_or_default(),
        SubgroupOp::UMax => words.max().unwrap_or_default(),
        SubgroupOp::Any => words.max().unwrap_or_default(),
        SubgroupOp::All => words.min().unwrap_or_default(),
        SubgroupOp::Count => words.sum(),
        SubgroupOp::Read => {
            let lane = own.get(1).map_or(0, |&lane| lane as u32);
            let there = subgroup.get(lane as usize).and_then(|operands| operands.first());
            *there.ok_or(InterpretError::NoSuchLane(lane))?
        }
    })
}
