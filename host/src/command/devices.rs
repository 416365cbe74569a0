//! `parallax devices`.

use super::failure::{Blame, Failure};
use super::report::{JsonOption, grouped};
use parallax::backend::{AdapterReport, Backend, Cpu, Profile, adapters};
use serde::Serialize;
use std::fmt;
use std::process::ExitCode;

/// Options of `parallax devices`.
#[derive(clap::Args)]
pub struct Options {
    /// The profile that adapters are judged for.
    #[arg(long, value_enum, default_value_t)]
    profile: Profile,
    #[command(flatten)]
    json: JsonOption,
}

/// What there is to render on.
#[derive(Serialize)]
struct Report {
    profile: &'static str,
    cpu: String,
    adapters: Vec<AdapterReport>,
    /// What `--backend auto` takes.
    used: String,
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let cpu = Cpu::new(0).work()?.describe();
    let adapters = adapters(options.profile);
    let used = adapters.iter().find(|adapter| adapter.used).map(|adapter| adapter.name.clone());
    options.json.publish(&Report {
        profile: options.profile.name(),
        used: used.unwrap_or_else(|| cpu.clone()),
        cpu,
        adapters,
    })?;
    Ok(ExitCode::SUCCESS)
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "{}", self.cpu)?;
        for adapter in &self.adapters {
            writeln!(f, "{} ({})", adapter.name, adapter.driver)?;
            writeln!(f, "  {}", adapter.why)?;
            writeln!(f, "  supports    {}", supported(adapter))?;
            writeln!(
                f,
                "  limits      {} bytes a buffer, {} buffers a pass, {} invocations a workgroup",
                grouped(adapter.max_buffer_bytes),
                adapter.max_buffers,
                adapter.max_workgroup_invocations
            )?;
        }
        if self.adapters.is_empty() {
            writeln!(f, "No Vulkan adapter was found.")?;
        }
        writeln!(f, "`--backend auto` in the {} profile takes {}.", self.profile, self.used)
    }
}

fn supported(adapter: &AdapterReport) -> String {
    let features = [
        ("SPIR-V as it is", adapter.spirv),
        ("push constants", adapter.push_constants),
        ("subgroups", adapter.subgroup),
        ("64 bit integers", adapter.int64),
    ];
    let held: Vec<_> = features.iter().filter(|(_, has)| *has).map(|(name, _)| *name).collect();
    if held.is_empty() { "none of what is asked for".into() } else { held.join(", ") }
}
