//! What a command tells: as text on stdout, and the same as JSON where it is asked for.

use super::failure::{Blame, Failure};
use anyhow::Context;
use parallax::output::Batch;
use serde::Serialize;
use std::fmt::Display;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The option `--json`.
#[derive(clap::Args)]
pub struct JsonOption {
    /// Write everything that is printed as JSON to FILE, too; `-` prints the JSON instead of the text.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl JsonOption {
    /// Whether stdout is for JSON alone.
    pub fn replaces_text(&self) -> bool {
        self.json.as_deref() == Some(Path::new("-"))
    }

    /// Prints `report` and writes it as JSON where that is asked for.
    pub fn publish(&self, report: &(impl Serialize + Display)) -> Result<(), Failure> {
        self.publish_text(&report.to_string(), || serde_json::to_string_pretty(report))
    }

    /// Prints `text` and writes what `json` makes where that is asked for.
    pub fn publish_text(
        &self,
        text: &str,
        json: impl FnOnce() -> serde_json::Result<String>,
    ) -> Result<(), Failure> {
        if self.replaces_text() {
            return print(&json().work()?);
        }
        if let Some(path) = &self.json {
            save(path, "--json", &json().work()?)?;
        }
        print(text)
    }
}

/// Prints a text that may be cut short by whoever reads it (`parallax … | head`).
fn print(text: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{}", text.trim_end()) {
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        result => result.context("cannot print").work(),
    }
}

/// Writes `text` to the file that `option` names.
pub fn save(path: &Path, option: &str, text: &str) -> Result<(), Failure> {
    let (folder, name) = (path.parent().unwrap_or(Path::new("")), path.file_name());
    let name =
        name.with_context(|| format!("{option} names a folder, not a file")).usage()?.to_string_lossy();
    let mut batch = Batch::new(if folder.as_os_str().is_empty() { Path::new(".") } else { folder }).work()?;
    batch.write_text(&name, text).work()?;
    batch.commit().work()?;
    Ok(())
}

/// Prints warnings on stderr.
pub fn warn(warnings: &[String]) {
    for warning in warnings {
        eprintln!("warning: {warning}");
    }
}

/// A count with thousands separated.
pub fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A time in the unit that suits it.
pub fn duration(seconds: f64) -> String {
    if seconds < 0.9995 { format!("{:.1} ms", seconds * 1e3) } else { format!("{seconds:.2} s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
        assert_eq!([0.0123, 0.9999, 61.0].map(duration), ["12.3 ms", "1.00 s", "61.00 s"]);
    }
}
