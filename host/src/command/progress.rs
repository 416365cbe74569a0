//! A progress bar on stderr, for what takes longer than a second, when somebody is watching.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Work shorter than this shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// The bar of one piece of work.
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    watched: bool,
}

impl Progress {
    /// A bar that shows itself after a second, if stderr is a terminal.
    pub fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        if let Ok(style) =
            ProgressStyle::with_template("{msg:>16} [{bar:40}] {percent}% {elapsed} left {eta}")
        {
            bar.set_style(style.progress_chars("=> "));
        }
        Self { bar, started: Instant::now(), watched: std::io::stderr().is_terminal() }
    }

    /// `done` of `total` is done; `what` is being done.
    pub fn update(&mut self, what: &str, done: u64, total: u64) {
        if self.watched && self.started.elapsed() > PATIENCE {
            self.watched = false;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_length(total);
        self.bar.set_message(what.to_owned());
        self.bar.set_position(done);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
