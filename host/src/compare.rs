//! The comparator of the differential contract: two backends' outputs, stage by stage, as words.
//!
//! In the strict profile bits are equal or the stage fails; there is no list of exceptions. What would make a
//! comparison pass for the wrong reason fails too: a NaN (on both sides as well), an infinity where none is
//! due, an output that nobody wrote, lengths that differ, nothing to compare, and a buffer compared with
//! itself.

use crate::backend::Profile;
use serde::Serialize;

/// The words of an output that no pass has written (see
/// [`Backend::create`](crate::backend::Backend::create)).
const UNWRITTEN: u32 = u32::MAX;

/// What the words of a stage are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Numbers or bits, of which all ones mean that nothing was written.
    Word,
    /// Numbers or bits that may be all ones (no primitive; 32 lights that are all seen).
    AnyWord,
    /// Finite floats.
    Float,
    /// Finite floats or +∞ (the distance of a ray that hits nothing).
    FloatOrInfinity,
}

impl Kind {
    fn is_float(self) -> bool {
        matches!(self, Kind::Float | Kind::FloatOrInfinity)
    }

    /// What is wrong with `word`, whatever the other side has.
    fn fault(self, word: u32) -> Option<Fault> {
        let value = f32::from_bits(word);
        match self {
            Kind::AnyWord => None,
            _ if word == UNWRITTEN => Some(Fault::Unwritten),
            Kind::Word => None,
            Kind::FloatOrInfinity if value == f32::INFINITY => None,
            Kind::Float | Kind::FloatOrInfinity => (!value.is_finite()).then_some(Fault::NotFinite),
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Fault {
    Unwritten,
    NotFinite,
}

/// How far apart two values may be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bound {
    /// Floats may be as many representable values apart…
    pub ulps: u32,
    /// … or differ by as much.
    pub absolute: f32,
    /// The share of all elements that may be further apart, or be other words. Where rounding moves a ray
    /// across an edge it hits another primitive, and all that follows from that is another value.
    pub share: f64,
}

impl Bound {
    /// The same bits.
    pub const EXACT: Self = Self { ulps: 0, absolute: 0.0, share: 0.0 };

    /// Whether two floats whose bits differ are close enough. The exact bound allows none, also not +0 beside
    /// −0, which are no ULP apart; no bound allows an infinity beside something else.
    fn allows(&self, ulps: u32, absolute: f32) -> bool {
        let close = ulps <= self.ulps || absolute <= self.absolute;
        absolute.is_finite() && close && *self != Self::EXACT
    }

    /// The bound of `profile` for a stage whose words are `kind`.
    ///
    /// Fast: Vulkan lets a division be 2.5 ULP off and a square root some more, contraction removes
    /// roundings, and a dozen such operations lie between a ray and a colour: 256 ULP, or 10⁻⁴ where terms
    /// cancel, except in 2 ‰ of the elements.
    pub const fn of(profile: Profile, kind: Kind) -> Self {
        match (profile, kind) {
            (Profile::Strict, _) => Self::EXACT,
            (Profile::Fast, Kind::Word | Kind::AnyWord) => Self { ulps: 0, absolute: 0.0, share: 2e-3 },
            (Profile::Fast, Kind::Float | Kind::FloatOrInfinity) => {
                Self { ulps: 256, absolute: 1e-4, share: 2e-3 }
            }
        }
    }
}

/// A stage to compare.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// Which view: "left".
    pub view: &'a str,
    /// Which output: "colour".
    pub stage: &'a str,
    /// What its words are.
    pub kind: Kind,
    /// Words of an element: 3 for a normal.
    pub components: usize,
    /// How far apart values may be.
    pub bound: Bound,
}

/// The first element that differs, or is invalid.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// Index of the element.
    pub index: usize,
    /// Which of its components.
    pub component: usize,
    /// The left side's bits and value.
    pub left: String,
    /// The right side's.
    pub right: String,
}

/// What comparing a stage has shown.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StageReport {
    /// Which view.
    pub view: String,
    /// Which output.
    pub stage: String,
    /// Whether the stage passes: the one thing to go by.
    pub equal: bool,
    /// Elements of the left side.
    pub elements: usize,
    /// Elements that are further apart than the bound, or invalid on a side.
    pub differing: usize,
    /// The first of them.
    pub first_differing: Option<Difference>,
    /// Elements with a word that nobody wrote, on a side.
    pub unwritten: usize,
    /// Elements with a NaN or an infinity where none is due, on a side.
    pub not_finite: usize,
    /// The largest distance of two floats in representable values.
    pub max_ulps: u32,
    /// The largest difference of two finite floats.
    pub max_absolute: f32,
    /// Mean of the squared differences of all finite floats.
    pub mean_squared_error: f64,
    /// Why the two sides cannot be compared at all.
    pub problem: Option<String>,
}

/// Compares the two sides of `stage`, given as words.
pub fn compare(stage: &Stage<'_>, left: &[u32], right: &[u32]) -> StageReport {
    let mut tally = Tally::default();
    let problem = problem(stage, left, right);
    if problem.is_none() {
        let components = stage.components;
        let elements = left.chunks_exact(components).zip(right.chunks_exact(components));
        for (index, (left, right)) in elements.enumerate() {
            tally.add(stage, index, left, right);
        }
    }
    let elements = left.len() / stage.components.max(1);
    let tolerated = (stage.bound.share * elements as f64) as usize;
    let valid = tally.unwritten == 0 && tally.not_finite == 0;
    StageReport {
        view: stage.view.into(),
        stage: stage.stage.into(),
        equal: problem.is_none() && valid && tally.differing <= tolerated,
        elements,
        differing: tally.differing,
        first_differing: tally.first,
        unwritten: tally.unwritten,
        not_finite: tally.not_finite,
        max_ulps: tally.max_ulps,
        max_absolute: tally.max_absolute,
        mean_squared_error: tally.squares / tally.floats.max(1) as f64,
        problem,
    }
}

/// Why two sides cannot be compared, or why it would say nothing.
fn problem(stage: &Stage<'_>, left: &[u32], right: &[u32]) -> Option<String> {
    if left.len() != right.len() {
        return Some(format!("the sides have {} and {} words", left.len(), right.len()));
    }
    if left.is_empty() {
        return Some("there is nothing to compare".into());
    }
    if left.as_ptr() == right.as_ptr() {
        return Some("both sides are the same memory".into());
    }
    let whole = stage.components > 0 && left.len().is_multiple_of(stage.components);
    (!whole).then(|| format!("{} words are no whole elements of {}", left.len(), stage.components))
}

/// What is counted over a stage.
#[derive(Default)]
struct Tally {
    differing: usize,
    first: Option<Difference>,
    unwritten: usize,
    not_finite: usize,
    max_ulps: u32,
    max_absolute: f32,
    squares: f64,
    floats: usize,
}

impl Tally {
    fn add(&mut self, stage: &Stage<'_>, index: usize, left: &[u32], right: &[u32]) {
        let has = |fault| left.iter().chain(right).any(|&word| stage.kind.fault(word) == Some(fault));
        self.unwritten += has(Fault::Unwritten) as usize;
        self.not_finite += has(Fault::NotFinite) as usize;
        let mut differing = None;
        for (component, (&left, &right)) in left.iter().zip(right).enumerate() {
            let close = self.measure(stage, left, right);
            if !close && differing.is_none() {
                differing = Some((component, left, right));
            }
        }
        let Some((component, left, right)) = differing else { return };
        self.differing += 1;
        self.first.get_or_insert_with(|| {
            let kind = stage.kind;
            Difference { index, component, left: describe(kind, left), right: describe(kind, right) }
        });
    }

    /// Whether two words are valid and close enough; notes how far apart they are.
    fn measure(&mut self, stage: &Stage<'_>, left: u32, right: u32) -> bool {
        if stage.kind.fault(left).or(stage.kind.fault(right)).is_some() {
            return false;
        }
        if !stage.kind.is_float() {
            return left == right;
        }
        let ulps = ulps_between(left, right);
        let absolute = (f32::from_bits(left) - f32::from_bits(right)).abs();
        // Not so beside an infinity.
        if absolute.is_finite() {
            self.max_ulps = self.max_ulps.max(ulps);
            self.max_absolute = self.max_absolute.max(absolute);
            self.squares += f64::from(absolute) * f64::from(absolute);
            self.floats += 1;
        }
        left == right || stage.bound.allows(ulps, absolute)
    }
}

/// How many representable floats lie between two, both zeros being one.
fn ulps_between(left: u32, right: u32) -> u32 {
    let ordered = |bits: u32| {
        let magnitude = i64::from(bits & 0x7fff_ffff);
        if bits >> 31 == 1 { -magnitude } else { magnitude }
    };
    ordered(left).abs_diff(ordered(right)) as u32
}

fn describe(kind: Kind, word: u32) -> String {
    match kind.is_float() {
        _ if kind.fault(word) == Some(Fault::Unwritten) => "unwritten".into(),
        true => format!("{:e} (0x{word:08x})", f32::from_bits(word)),
        false => format!("{word} (0x{word:08x})"),
    }
}
