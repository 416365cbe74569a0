//! Why a command ends early, and with which exit code.

use std::process::ExitCode;

/// An error and whose it is.
#[derive(Debug)]
pub enum Failure {
    /// Bad usage or a bad scene: exit code 2.
    Usage(anyhow::Error),
    /// The work itself failed: exit code 1.
    Work(anyhow::Error),
}

impl Failure {
    /// Prints the error with its causes on stderr and returns the exit code.
    pub fn tell(self) -> ExitCode {
        let (error, code) = match self {
            Self::Usage(error) => (error, 2),
            Self::Work(error) => (error, 1),
        };
        eprintln!("error: {}", chain(&error));
        ExitCode::from(code)
    }
}

/// The message and those of its causes that it does not already contain.
fn chain(error: &anyhow::Error) -> String {
    let mut text = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if text.is_empty() {
            text = cause;
        } else if !text.contains(&cause) {
            text = format!("{text}: {cause}");
        }
    }
    text
}

/// Says whose an error is.
pub trait Blame<T> {
    /// The user's: bad usage or a bad scene.
    fn usage(self) -> Result<T, Failure>;
    /// The work's.
    fn work(self) -> Result<T, Failure>;
}

impl<T, E: Into<anyhow::Error>> Blame<T> for Result<T, E> {
    fn usage(self) -> Result<T, Failure> {
        self.map_err(|error| Failure::Usage(error.into()))
    }

    fn work(self) -> Result<T, Failure> {
        self.map_err(|error| Failure::Work(error.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::anyhow;

    #[test]
    fn causes_are_told_once() {
        let error = anyhow!("no such file").context("cannot read a: no such file").context("bad scene");
        assert_eq!(chain(&error), "bad scene: cannot read a: no such file");
    }
}
