//! The same code compiled once for each instruction set, the best one chosen at run time.
//!
//! A function that carries `#[target_feature]` passes its features on to whatever is inlined into it, so the
//! code itself stays portable: a [`Task`] whose body is `#[inline(always)]` all the way down. Nothing is
//! contracted or reassociated by any of the sets, so that the choice changes speed and no bit. AVX-512 is
//! left out: its mask registers make eight-lane traversal slower.

/// A piece of work that gains from being compiled for the machine it runs on.
pub trait Task {
    /// What it results in.
    type Output;

    /// Does the work. Implementations must be `#[inline(always)]`, and so must everything hot that they call:
    /// what stays a call is compiled for the baseline.
    fn run(self) -> Self::Output;
}

/// An instruction set that this machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InstructionSet(Kind);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
}

impl InstructionSet {
    /// What every machine of the target has.
    pub const BASELINE: Self = Self(Kind::Baseline);

    /// The sets that this machine has, the best one last.
    pub fn available() -> Vec<Self> {
        let mut sets = vec![Self::BASELINE];
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("popcnt")
        {
            sets.push(Self(Kind::Avx2));
        }
        sets
    }

    /// The best set that this machine has.
    pub fn best() -> Self {
        Self::available().pop().unwrap_or(Self::BASELINE)
    }

    /// Its name, for reports.
    pub fn name(self) -> &'static str {
        match self.0 {
            Kind::Baseline if cfg!(target_arch = "x86_64") => "SSE2",
            Kind::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            Kind::Avx2 => "AVX2",
        }
    }

    /// Runs the instance of `task` for this set.
    #[inline]
    pub fn run<T: Task>(self, task: T) -> T::Output {
        match self.0 {
            Kind::Baseline => baseline(task),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: a value with this kind is only made by `available`, which has asked the machine for
            // these features.
            Kind::Avx2 => unsafe { avx2(task) },
        }
    }
}

/// A function of its own, so that the baseline instance is one too.
#[inline(never)]
fn baseline<T: Task>(task: T) -> T::Output {
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi1,bmi2,lzcnt,popcnt")]
#[inline(never)]
fn avx2<T: Task>(task: T) -> T::Output {
    task.run()
}

#[cfg(test)]
mod tests {
    use super::{InstructionSet, Task};

    struct Sum<'a>(&'a [f32]);

    impl Task for Sum<'_> {
        type Output = f32;

        #[inline(always)]
        fn run(self) -> f32 {
            let mut lanes = [0.0_f32; 8];
            for chunk in self.0.chunks_exact(8) {
                for (lane, value) in lanes.iter_mut().zip(chunk) {
                    *lane += value * value + 0.1;
                }
            }
            lanes.iter().sum()
        }
    }

    #[test]
    fn every_set_gives_the_same_bits() {
        let values: Vec<f32> = (0..4096).map(|i| (i as f32).sin()).collect();
        let expected = InstructionSet::BASELINE.run(Sum(&values)).to_bits();
        for set in InstructionSet::available() {
            assert_eq!(set.run(Sum(&values)).to_bits(), expected, "{}", set.name());
        }
    }
}
