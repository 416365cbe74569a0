//! The command line. One file per subcommand; each returns a report, which is printed and written as JSON by
//! [`report`].
//!
//! Exit codes: 0 for success, 1 for a difference between backends or a failed render, 2 for bad usage or a
//! bad scene.

mod bench;
mod choice;
mod devices;
mod diff;
mod failure;
mod frames;
mod info;
mod locate;
mod options;
mod progress;
mod render;
mod report;
mod study;
mod verify;

use clap::Parser;
use failure::Failure;
use std::ffi::OsString;
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  parallax                                     renders the default scene into the folder `out`
  parallax render scenes/spot.toml --size 1200x900 --format anaglyph
  parallax render model.ply --backend gpu --interaxial 20 --aov --out pictures
  parallax diff scenes/spot.toml               are both backends the same, bit for bit?
  parallax devices                             which GPUs are there, and which would be used?
  parallax verify                              is the strict profile safe on this machine and its driver?

Exit codes: 0 success; 1 a difference or a failed render; 2 bad usage or a bad scene.";

/// Stereo pictures by ray tracing, with the same bits on CPU and GPU.
///
/// Without a subcommand, `render` renders the default scene.
#[derive(Parser)]
#[command(name = "parallax", version, after_help = EXAMPLES, subcommand_required = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    /// Render a stereo pair and write it as PNG and EXR.
    Render(render::Options),
    /// Render on both backends and compare every stage bit by bit.
    Diff(diff::Options),
    /// List the graphics adapters, what each supports, and which would be used.
    Devices(devices::Options),
    /// Tell what is in a scene, without rendering it.
    Info(info::Options),
    /// Measure parts of Parallax against other libraries.
    Bench(bench::Options),
    /// Show what accuracy costs in time: each knob's gain and price, on a page with plots.
    Study(study::Options),
    /// Try hard cases on this machine: what its driver does, and which profile is safe here.
    Verify(verify::Options),
}

/// Runs the command with the arguments of this process.
pub fn main() -> ExitCode {
    match Arguments::try_parse_from(arguments()) {
        Ok(arguments) => run(arguments.command).unwrap_or_else(|failure| failure.tell()),
        Err(error) => {
            // Help and version are errors too, for clap: printed on stdout, exit code 0.
            let _ = error.print();
            ExitCode::from(error.exit_code() as u8)
        }
    }
}

/// The arguments of this process; `render` when there are none.
fn arguments() -> Vec<OsString> {
    let mut arguments: Vec<_> = std::env::args_os().collect();
    if arguments.len() < 2 {
        arguments.resize(1, "parallax".into());
        arguments.push("render".into());
    }
    arguments
}

fn run(command: Command) -> Result<ExitCode, Failure> {
    match command {
        Command::Render(options) => render::run(&options),
        Command::Diff(options) => diff::run(&options),
        Command::Devices(options) => devices::run(&options),
        Command::Info(options) => info::run(&options),
        Command::Bench(options) => bench::run(&options),
        Command::Study(options) => study::run(&options),
        Command::Verify(options) => verify::run(&options),
    }
}
