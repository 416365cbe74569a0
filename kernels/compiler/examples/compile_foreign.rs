//! Compiles a kernel crate of somebody else's through the library, runs one of its kernels by the interpreter, and writes the modules
//! to a folder.
//!
//! ```text
//! cargo run -p kernel-compiler --example compile_foreign -- [DIR]
//! ```

use kernel_compiler::interpret::{self, Arguments};
use kernel_compiler::{CrateSource, Options, Profile, compile};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Pixels of a row and of a column.
const SIZE: u32 = 48;

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::args_os()
        .nth(1)
        .map_or_else(|| std::env::temp_dir().join("foreign-kernels"), PathBuf::from);
    let source = CrateSource::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/foreign"));
    let options = Options { profiles: Profile::ALL.to_vec(), wgsl: true, ..Options::default() };
    let compiled = compile(&source, &options)?;
    for entry in &compiled.entries {
        println!("{} ({}): {} bytes", entry.name, entry.profile, 4 * entry.spirv.len());
    }
    compiled.write(&out)?;
    println!("written to {}", out.display());

    let mandelbrot =
        compiled.entries.iter().find(|entry| entry.name == "mandelbrot").ok_or("no such kernel")?;
    // The record that the kernel declares: corner, step, width.
    let frame = [(-2.2f32).to_bits(), (-1.2f32).to_bits(), 0.05f32.to_bits(), SIZE];
    let rounds = vec![u32::MAX; (SIZE * SIZE) as usize];
    let mut arguments =
        Arguments { buffers: [((0, 0), rounds)].into(), push: frame.to_vec(), ..Arguments::default() };
    interpret::run(&mandelbrot.kernel, [SIZE / 8, SIZE / 8, 1], &mut arguments)?;
    for row in arguments.buffers[&(0, 0)].chunks(SIZE as usize) {
        println!("{}", row.iter().map(|&rounds| shade(rounds)).collect::<String>());
    }
    Ok(())
}

/// Lighter the sooner a point escapes.
fn shade(rounds: u32) -> char {
    match rounds {
        0..3 => ' ',
        3..6 => '.',
        6..12 => '+',
        12..100 => '*',
        _ => '#',
    }
}
