//! What a driver does where specifications leave it free: asked, not assumed.

use super::input::meshes::Random;
use super::input::numbers::{ordinary, ulps};
use super::suite::values;
use crate::backend::{Backend, BackendError};
use parallax_kernels::arithmetic::{operation::*, rounds};
use serde::Serialize;

/// Numbers that each probe of accuracy asks for.
const COUNT: usize = 1 << 17;

/// By how many ULP the machine's own division and square root may be off: the correction of the strict profile is out of its depth
/// beyond (`shared::math::{division, root}`).
const CORRECTABLE: f64 = 12.0;

/// An answer.
#[derive(Clone, Debug, Serialize)]
pub struct Answer {
    /// In words.
    pub says: String,
    /// Whether the strict profile can be had with it.
    pub strict_can_do: bool,
}

/// What a machine answers to all probes.
#[derive(Clone, Debug, Serialize)]
pub struct Answers {
    /// Whose answers these are: "CPU", or the profile of a device.
    pub machine: &'static str,
    /// Contraction of a·a − b to one rounding.
    pub contraction: Answer,
    /// Fused multiply-add, where a kernel asks for it.
    pub fma: Answer,
    /// Rounding of sums.
    pub rounding: Answer,
    /// Denormal operands and results of products and sums.
    pub denormals: Answer,
    /// Signs of zeros.
    pub zeros: Answer,
    /// Division.
    pub division: Answer,
    /// Square root.
    pub square_root: Answer,
    /// How many rounds of its loops an invocation has.
    pub loops: Answer,
}

impl Answers {
    /// The answers with the names of their probes.
    pub fn named(&self) -> [(&'static str, &Answer); 8] {
        [
            ("contraction", &self.contraction),
            ("fused multiply-add", &self.fma),
            ("rounding of sums", &self.rounding),
            ("denormals", &self.denormals),
            ("signs of zeros", &self.zeros),
            ("division", &self.division),
            ("square root", &self.square_root),
            ("loops", &self.loops),
        ]
    }
}

/// Probes `backend`, whose answers go under the name `machine`.
///
/// # Errors
/// When the backend fails.
pub fn probe<B: Backend>(backend: &mut B, machine: &'static str) -> Result<Answers, BackendError> {
    Ok(Answers {
        machine,
        contraction: contraction(backend)?,
        fma: fma(backend)?,
        rounding: rounding(backend)?,
        denormals: denormals(backend)?,
        zeros: zeros(backend)?,
        division: accuracy(backend, NATIVE_DIVIDE, |a, b| a / b)?,
        square_root: accuracy(backend, NATIVE_ROOT, |a, _| a.sqrt())?,
        loops: loops(backend)?,
    })
}

/// One operation on pairs of floats.
fn floats<B: Backend>(
    backend: &mut B,
    operation: u32,
    pairs: &[(f32, f32)],
) -> Result<Vec<f32>, BackendError> {
    let (a, b): (Vec<_>, Vec<_>) = pairs.iter().map(|(a, b)| (a.to_bits(), b.to_bits())).unzip();
    Ok(values(backend, operation, &a, &b)?.into_iter().map(f32::from_bits).collect())
}

/// Numbers with their squares, all of which are rounded: a² − fl(a²) is 0 by two roundings, and something else by one.
fn squares() -> Vec<(f32, f32)> {
    (1..4096u32).map(|i| f32::from_bits(0x3f80_0000 | (i << 11) | 1)).map(|a| (a, a * a)).collect()
}

fn contraction<B: Backend>(backend: &mut B) -> Result<Answer, BackendError> {
    let contracted =
        floats(backend, SQUARE_LESS, &squares())?.into_iter().filter(|rest| *rest != 0.0).count();
    Ok(match contracted {
        0 => Answer { says: "none: each operation is rounded".into(), strict_can_do: true },
        _ => Answer { says: "a·b + c is rounded once".into(), strict_can_do: false },
    })
}

fn fma<B: Backend>(backend: &mut B) -> Result<Answer, BackendError> {
    let pairs = squares();
    let rests = floats(backend, FUSED_SQUARE_LESS, &pairs)?;
    // The exact rest fits into f32: it is what rounding took from the square.
    let exact = |(a, b): &(f32, f32)| (f64::from(*a) * f64::from(*a) - f64::from(*b)) as f32;
    let count = pairs.iter().map(exact).zip(rests).filter(|(exact, rest)| exact == rest).count();
    let says = if count == pairs.len() { "fused" } else { "not fused: rounded twice" };
    Ok(Answer { says: says.into(), strict_can_do: true })
}

fn rounding<B: Backend>(backend: &mut B) -> Result<Answer, BackendError> {
    let ulp = f32::EPSILON;
    let pairs = [
        (1.0, ulp / 2.0),
        (1.0 + ulp, ulp / 2.0),
        (1.0, ulp * 0.75),
        (-1.0, -ulp / 2.0),
        (-1.0 - ulp, -ulp / 2.0),
        (1.0, ulp * 0.25),
    ];
    let expected = [1.0, 1.0 + 2.0 * ulp, 1.0 + ulp, -1.0, -1.0 - 2.0 * ulp, 1.0];
    let is_nearest = floats(backend, ADD, &pairs)? == expected;
    let says = if is_nearest { "to nearest, ties to even" } else { "NOT to nearest, ties to even" };
    Ok(Answer { says: says.into(), strict_can_do: is_nearest })
}

fn denormals<B: Backend>(backend: &mut B) -> Result<Answer, BackendError> {
    let tiny = f32::MIN_POSITIVE;
    let operands = floats(backend, MULTIPLY, &[(tiny / 2.0, 1e30), (tiny / 1024.0, -1e30)])?;
    let results = floats(backend, MULTIPLY, &[(tiny, 0.5), (-tiny, 0.125)])?;
    let sums = floats(backend, ADD, &[(tiny / 2.0, tiny / 4.0), (tiny * 1.5, -tiny)])?;
    let word = |values: &[f32]| if values.iter().all(|v| *v != 0.0) { "kept" } else { "flushed to zero" };
    let (operands, results, sums) = (word(&operands), word(&results), word(&sums));
    let says = if (operands, results) == (results, sums) {
        operands.into()
    } else {
        format!("operands {operands}, products {results}, sums {sums}")
    };
    // Division and square root keep them by integers; no other algorithm makes any out of ordinary numbers.
    Ok(Answer { says, strict_can_do: true })
}

fn zeros<B: Backend>(backend: &mut B) -> Result<Answer, BackendError> {
    let mut bits = floats(backend, ADD, &[(-0.0, -0.0), (1.0, -1.0)])?;
    bits.extend(floats(backend, MULTIPLY, &[(-1.0, 0.0), (-0.0, -2.0)])?);
    let is_kept = bits.into_iter().map(f32::to_bits).eq([-0.0f32, 0.0, -0.0, 0.0].map(f32::to_bits));
    let says = if is_kept { "kept" } else { "LOST" };
    Ok(Answer { says: says.into(), strict_can_do: is_kept })
}

/// How far the machine's own division or square root is off.
fn accuracy<B: Backend>(
    backend: &mut B,
    operation: u32,
    exact: impl Fn(f64, f64) -> f64,
) -> Result<Answer, BackendError> {
    let mut random = Random(9);
    let [a, b] = [(); 2].map(|()| ordinary(&mut random, COUNT, 0, 24));
    let [a, b] = [a, b].map(|words| words.into_iter().map(|word| word & 0x7fff_ffff).collect::<Vec<_>>());
    let results = values(backend, operation, &a, &b)?;
    let (mut worst, mut wrong) = (0f64, 0usize);
    for ((a, b), result) in a.into_iter().zip(b).zip(results) {
        let truth = exact(f32::from_bits(a).into(), f32::from_bits(b).into());
        worst = worst.max(ulps(result, truth));
        wrong += (result != (truth as f32).to_bits()) as usize;
    }
    let says = match wrong {
        0 => "correctly rounded".into(),
        _ => format!("up to {worst:.2} ULP off, {:.0} % not rounded", 100.0 * wrong as f64 / COUNT as f64),
    };
    Ok(Answer { says, strict_can_do: worst <= CORRECTABLE })
}

/// Rounds that are asked for; lavapipe has 65,535 in all loops of an invocation together.
const ROUNDS_ASKED: [u32; 6] = [1000, 65_000, 65_535, 65_600, 200_000, 1 << 20];

fn loops<B: Backend>(backend: &mut B) -> Result<Answer, BackendError> {
    let expected = ROUNDS_ASKED.map(|count| rounds(count, 1));
    let results = values(backend, ROUNDS, &ROUNDS_ASKED, &ROUNDS_ASKED.map(|_| 1))?;
    let right = results.iter().zip(&expected).take_while(|(result, expected)| result == expected).count();
    let says = match (right.checked_sub(1), ROUNDS_ASKED.get(right)) {
        (_, None) => "run to their end".into(),
        (Some(last), Some(next)) => {
            format!("run to their end for {} rounds, but not for {next}", ROUNDS_ASKED[last])
        }
        (None, Some(next)) => format!("do NOT run to their end for {next} rounds"),
    };
    // What renders needs a thousand rounds at most, but where there are thousands of lights.
    Ok(Answer { says, strict_can_do: right > 0 })
}
