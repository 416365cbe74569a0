//! The drivers that tests run on, and what happens when there is none.
//!
//! `PARALLAX_ADAPTER=NAME` puts the adapter whose name contains NAME in lavapipe's place: the same tests on a
//! GPU of one's own.
//!
//! `tests/run.sh` offers lavapipe and SwiftShader side by side (`VK_DRIVER_FILES`). A test asks for one by
//! [`open`]; where it is missing the test says SKIPPED, on the terminal and not into cargo's captured output,
//! or fails if `PARALLAX_REQUIRE_GPU=1`.

use crate::terminal::tell;
use parallax::backend::{BackendError, Gpu, Profile};

/// A driver that tests run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driver {
    /// Whatever an engine would get that asks for a GPU: hardware if there is some.
    Any,
    /// Mesa's software driver, or what `PARALLAX_ADAPTER` names.
    Lavapipe,
    /// The software driver of Chromium.
    SwiftShader,
}

impl Driver {
    /// The two independent software drivers.
    pub const SOFTWARE: [Driver; 2] = [Driver::Lavapipe, Driver::SwiftShader];

    /// Part of the adapter's name.
    fn adapter(self) -> Option<String> {
        match self {
            Driver::Any => None,
            Driver::Lavapipe => Some(std::env::var("PARALLAX_ADAPTER").unwrap_or_else(|_| "llvmpipe".into())),
            Driver::SwiftShader => Some("swiftshader".into()),
        }
    }

    /// Whether a test fails when this driver is missing. SwiftShader comes from a package that a machine may
    /// not offer, and is required where `PARALLAX_SWIFTSHADER` names it.
    fn is_required(self) -> bool {
        let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty() && value != "0");
        set("PARALLAX_REQUIRE_GPU") && (self != Driver::SwiftShader || set("PARALLAX_SWIFTSHADER"))
    }
}

/// A GPU backend on `driver`, or `None`, with a word about it, when there is no such driver.
///
/// # Panics
/// When the driver is required, or is there and cannot be opened.
pub fn open(driver: Driver, profile: Profile) -> Option<Gpu> {
    let missing = |error: &BackendError| {
        matches!(error, BackendError::NoAdapter { .. } | BackendError::UnknownAdapter { .. })
    };
    match Gpu::open(profile, driver.adapter().as_deref()) {
        Err(error) if !missing(&error) => panic!("{driver:?} cannot be opened: {error}"),
        opened => require(opened.map_err(|error| format!("{driver:?}: {error}")), driver.is_required()),
    }
}

/// What there is; without it `None` and a word about the skipped test, or a panic if it is `required`.
///
/// # Panics
/// When it is required and missing.
pub fn require<T>(found: Result<T, String>, required: bool) -> Option<T> {
    match found {
        Ok(found) => Some(found),
        Err(reason) if required => panic!("PARALLAX_REQUIRE_GPU is set, and there is no {reason}"),
        Err(reason) => {
            say_skipped(&reason);
            None
        }
    }
}

/// Says that the calling test is skipped.
pub fn say_skipped(reason: &str) {
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("a test");
    tell(&format!("SKIPPED: {test}: {reason}"));
}

#[cfg(test)]
mod tests {
    use super::require;

    #[test]
    fn what_is_there_is_used_and_what_is_missing_is_skipped() {
        assert_eq!(require(Ok(1), true), Some(1));
        assert_eq!(require::<u32>(Err("driver (this is a test of SKIPPED)".into()), false), None);
    }

    #[test]
    #[should_panic(expected = "PARALLAX_REQUIRE_GPU is set, and there is no Lavapipe")]
    fn what_is_required_and_missing_fails() {
        require::<u32>(Err("Lavapipe".into()), true);
    }
}
