//! Compiles random kernels and compares what they compute on every machine with what they compute natively.
//!
//! ```text
//! cargo run -p parallax-tests --bin random-kernels -- --seeds 0..200
//! cargo run -p parallax-tests --bin random-kernels -- --forever --driver swiftshader
//! ```

use anyhow::Context;
use clap::Parser;
use parallax_tests::gpu::Driver;
use parallax_tests::machines::Machine;
use parallax_tests::random_kernels::{Batch, check};
use std::ops::Range;

/// Random kernels, compared with a native run. Ends with 1 at the first batch in which a machine differs; its source stays under
/// target/random-kernels.
#[derive(Parser)]
struct Arguments {
    /// Which seeds: FIRST..END.
    #[arg(long, value_parser = range, default_value = "0..200")]
    seeds: Range<u32>,
    /// Go on with the seeds behind, in batches of the same size, until something differs.
    #[arg(long)]
    forever: bool,
    /// Only on these machines; all that there are, if none is named.
    #[arg(long = "driver", value_enum)]
    drivers: Vec<Name>,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Name {
    Interpreter,
    Lavapipe,
    #[value(name = "swiftshader")]
    SwiftShader,
}

fn range(text: &str) -> anyhow::Result<Range<u32>> {
    let (first, end) = text.split_once("..").context("expected FIRST..END")?;
    let range = first.parse()?..end.parse()?;
    anyhow::ensure!(!range.is_empty(), "there are no seeds in {text}");
    Ok(range)
}

fn machines(names: &[Name]) -> anyhow::Result<Vec<Machine>> {
    let open = |name: &Name| match name {
        Name::Interpreter => Some(Machine::Interpreter(0)),
        Name::Lavapipe => Machine::open(Driver::Lavapipe),
        Name::SwiftShader => Machine::open(Driver::SwiftShader),
    };
    let machines: Vec<Machine> = match names {
        [] => Machine::all(),
        names => names.iter().filter_map(open).collect(),
    };
    anyhow::ensure!(!machines.is_empty(), "none of the machines is there");
    Ok(machines)
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    let machines = machines(&arguments.drivers)?;
    let size = arguments.seeds.len() as u32;
    let mut seeds = arguments.seeds;
    loop {
        let batch = Batch::write("open-ended", seeds.clone())?.compile()?;
        let failures = check(&batch, &machines);
        for failure in &failures {
            println!("{failure}");
        }
        anyhow::ensure!(failures.is_empty(), "{} of {size} kernels and machines differ", failures.len());
        println!("seeds {seeds:?}: {} machines agree with the native program", machines.len());
        if !arguments.forever {
            return Ok(());
        }
        seeds = seeds.end..seeds.end.checked_add(size).context("all seeds have been tried")?;
    }
}
