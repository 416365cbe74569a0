//! What only one eye can see, and how near the scene comes: by the boxes of the acceleration structure.
//!
//! In front of the zero-parallax plane the second eye sees beyond the last column of the source (001 fig. 14, 003 §5.5.1). What is
//! there may hide candidates that nothing else makes questionable. The tables cannot know: a strip of columns has to be verified.

use crate::render::SceneData;
use glam::DVec3;
use parallax_shared::layout::{Row, View};
use parallax_shared::traversal::rows::{LANES, LEAF, LINKS};

/// Nothing is nearer than this share of the distance to the zero-parallax plane, for the width of the strip: beyond it the whole
/// picture is verified anyway.
const NEAREST: f64 = 1.0 / 64.0;

/// By how much boxes are grown, of the scene's extent: the traversal pads them too.
const PADDING: f64 = 32.0 * f32::EPSILON as f64;

/// A half-space: where `normal · (p − eye) ≥ 0`.
#[derive(Clone, Copy)]
struct HalfSpace {
    eye: DVec3,
    normal: DVec3,
}

impl HalfSpace {
    /// Where columns are at least `x`.
    fn right_of(view: &View, x: f64) -> Self {
        Self::beyond(view, vector(view.step_x), x)
    }

    /// Where rows are at least `y`.
    fn below(view: &View, y: f64) -> Self {
        Self::beyond(view, vector(view.step_y), y)
    }

    /// A point at `t` has the coordinate (p · step / t − corner · step) / step², and t is p · forward / d: for t > 0 it is at least
    /// `least` where p · (step − forward / d (corner · step + least · step²)) ≥ 0.
    fn beyond(view: &View, step: DVec3, least: f64) -> Self {
        let offset = vector(view.corner).dot(step) + least * step.length_squared();
        let normal = step - vector(view.forward) * (offset / f64::from(view.distance));
        Self { eye: vector(view.eye), normal }
    }

    fn opposite(self) -> Self {
        Self { normal: -self.normal, ..self }
    }

    /// Whether a point of the box may lie in it.
    fn meets(&self, low: DVec3, high: DVec3) -> bool {
        let farthest = DVec3::select(self.normal.cmpge(DVec3::ZERO), high, low);
        self.normal.dot(farthest - self.eye) >= 0.0
    }
}

fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

/// The picture of a view.
fn frustum(view: &View) -> [HalfSpace; 4] {
    let (width, height) = (f64::from(view.width), f64::from(view.height));
    [
        HalfSpace::right_of(view, -0.5),
        HalfSpace::right_of(view, width - 0.5).opposite(),
        HalfSpace::below(view, -0.5),
        HalfSpace::below(view, height - 0.5).opposite(),
    ]
}

/// The smallest `t` that any primitive in front of the eye and within the half-spaces may have, by the boxes of packs.
fn nearest_within(data: &SceneData, view: &View, spaces: &[HalfSpace]) -> Option<f64> {
    let eye = vector(view.eye);
    let forward = vector(view.forward) / f64::from(view.distance);
    let padding = DVec3::splat(PADDING * (f64::from(data.info.extent) + eye.abs().max_element()));
    let (mut todo, mut nearest) = (vec![0], None::<f64>);
    while let Some(node) = todo.pop() {
        for (low, high, link) in children(&data.rows, node) {
            let (low, high) = (low - padding, high + padding);
            let (near, far) = (
                DVec3::select(forward.cmpge(DVec3::ZERO), low, high),
                DVec3::select(forward.cmpge(DVec3::ZERO), high, low),
            );
            let (t, end) = (forward.dot(near - eye), forward.dot(far - eye));
            let better = nearest.is_none_or(|nearest| t < nearest);
            if end <= 0.0 || !better || !spaces.iter().all(|space| space.meets(low, high)) {
                continue;
            }
            match link & LEAF {
                0 => todo.push(link),
                _ => nearest = Some(t.max(0.0)),
            }
        }
    }
    nearest
}

/// The boxes and links of the children of a node.
fn children(rows: &[Row], node: u32) -> impl Iterator<Item = (DVec3, DVec3, u32)> {
    let at = move |row: usize, lane: usize| rows[node as usize + row].0[lane];
    let float = move |row, lane| f64::from(f32::from_bits(at(row, lane)));
    let corner =
        move |first, lane| DVec3::new(float(first, lane), float(first + 1, lane), float(first + 2, lane));
    let child = move |lane| (corner(0, lane), corner(3, lane), at(LINKS, lane));
    // A lane without a child has its smallest corner at +∞.
    (0..LANES).map(child).filter(|(low, high, _)| low.cmple(*high).all())
}

/// The `t` of the nearest box that the eye `eye` may see: 1 / r of Lemma 1.
pub fn nearest(data: &SceneData, eye: usize) -> Option<f32> {
    let view = &data.views[eye];
    nearest_within(data, view, &frustum(view)).map(|t| t as f32)
}

/// From which column on (mirrored if the right eye is the source) candidates are verified whatever the options say; the width if
/// nothing lies where only the second eye sees it, in front of the plane.
pub fn checked_from(data: &SceneData, source: usize) -> u32 {
    let (from, to) = (&data.views[source], &data.views[1 - source]);
    let interaxial_px = f64::from(from.interaxial_px).abs();
    let last = f64::from(from.width) - 1.0;
    let beyond = match source {
        0 => HalfSpace::right_of(from, last),
        _ => HalfSpace::right_of(from, 0.0).opposite(),
    };
    let [left, right, above, below] = frustum(to);
    match nearest_within(data, to, &[left, right, above, below, beyond]) {
        Some(t) if t < 1.0 => {
            let strip = (interaxial_px * (1.0 / t.max(NEAREST) - 1.0)).ceil() + 2.0;
            (f64::from(from.width) - strip).max(0.0) as u32
        }
        _ => from.width,
    }
}
