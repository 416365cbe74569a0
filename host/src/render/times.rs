//! How long the stages of a frame take.

use serde::Serialize;
use std::time::Instant;

/// The time that a stage has taken, over all bands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StageTime {
    /// Which eye; none for what is done once for both.
    pub view: Option<&'static str>,
    /// Which stage.
    pub stage: &'static str,
    /// Seconds.
    pub seconds: f64,
}

/// Times by view and stage, in the order in which they first occurred.
#[derive(Clone, Debug, Default)]
pub struct Times(Vec<StageTime>);

impl Times {
    /// Runs `work` and adds its time to that of `stage`.
    pub fn measure<T>(
        &mut self,
        view: Option<&'static str>,
        stage: &'static str,
        work: impl FnOnce() -> T,
    ) -> T {
        let started = Instant::now();
        let result = work();
        self.add(view, stage, started.elapsed().as_secs_f64());
        result
    }

    fn add(&mut self, view: Option<&'static str>, stage: &'static str, seconds: f64) {
        match self.0.iter_mut().find(|time| time.view == view && time.stage == stage) {
            Some(time) => time.seconds += seconds,
            None => self.0.push(StageTime { view, stage, seconds }),
        }
    }

    /// All of them.
    pub fn into_vec(self) -> Vec<StageTime> {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_add_up() {
        let mut times = Times::default();
        for (view, stage) in [("left", "a"), ("left", "b"), ("right", "a"), ("left", "a")] {
            times.add(Some(view), stage, 1.0);
        }
        let told: Vec<_> = times.into_vec().iter().map(|t| (t.view.unwrap(), t.stage, t.seconds)).collect();
        assert_eq!(told, [("left", "a", 2.0), ("left", "b", 1.0), ("right", "a", 1.0)]);
    }
}
