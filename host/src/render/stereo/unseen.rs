//! What only one eye can see, and how near the scene comes: by the boxes of the acceleration structure.
//!
//! In front of the zero-parallax plane the second eye sees beyond the last column of the source (001 fig. 14, 003 §5.5.1). What is
//! there may hide candidates that nothing else makes questionable. The tables cannot know: a strip of columns has to be verified.
//!
//! A box alone says little of a floor that runs below the eye. So the part of space in question is cut into slices of depth, and the
//! nearest slice counts that something may meet: a triangle of which something is left when it is clipped to the slice, or another
//! primitive's pack whose box meets the slice's own and lies behind none of its six planes.

use crate::render::SceneData;
use glam::DVec3;
use parallax_shared::layout::{Row, Triangle, View};
use parallax_shared::traversal::rows::{KIND, Kind, LANES, LEAF, LINKS, NUMBERS, ROW};

/// Where the first slice begins, as a share of the distance to the zero-parallax plane. What is nearer than this has disparities of
/// more than 63 times the distance between the eyes.
const NEAREST: f64 = 1.0 / 64.0;

/// Where the last slice ends.
const FARTHEST: f64 = 64.0;

/// A slice is so many times as far away at its end as at its beginning: the fourth root of 2.
const STEP: f64 = 1.189_207_115_002_721;

/// By how much boxes are grown, of the scene's extent: the traversal pads them too.
const PADDING: f64 = 32.0 * f32::EPSILON as f64;

/// A box.
#[derive(Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
}

impl Bounds {
    fn meets(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    fn grown(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }
}

/// The part of a view's columns between two values of `t`.
struct Slice {
    bounds: Bounds,
    /// Normals and offsets; inside is where no `normal · p` is below its offset.
    planes: [(DVec3, f64); 6],
}

impl Slice {
    fn new(view: &View, [near, far]: [f64; 2], columns: [f64; 2]) -> Self {
        let rows = [-0.5, f64::from(view.height) - 0.5];
        let none = Bounds { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
        let ends = [near, far].into_iter().flat_map(|t| columns.map(|x| (t, x)));
        let bounds = ends
            .flat_map(|(t, x)| rows.map(|y| point(view, t, x, y)))
            .fold(none, |all, p| Bounds { low: all.low.min(p), high: all.high.max(p) });
        let eye = vector(view.eye);
        let forward = vector(view.forward) / f64::from(view.distance);
        // A point at `t` has the coordinate (p · step / t − corner · step) / step², and t is p · forward.
        let beyond = |step: [f32; 3], least: f64| {
            let step = vector(step);
            step - forward * (vector(view.corner).dot(step) + least * step.length_squared())
        };
        let through_eye = |normal: DVec3| (normal, normal.dot(eye));
        let planes = [
            through_eye(beyond(view.step_x, columns[0])),
            through_eye(-beyond(view.step_x, columns[1])),
            through_eye(beyond(view.step_y, rows[0])),
            through_eye(-beyond(view.step_y, rows[1])),
            (forward, forward.dot(eye) + near),
            (-forward, -forward.dot(eye) - far),
        ];
        Self { bounds, planes }
    }

    /// Whether a box, grown by `padding`, may meet it.
    fn may_meet(&self, other: &Bounds, padding: f64) -> bool {
        let other = other.grown(padding);
        let behind = |&(normal, offset): &(DVec3, f64)| {
            let farthest = DVec3::select(normal.cmpge(DVec3::ZERO), other.high, other.low);
            normal.dot(farthest) < offset
        };
        self.bounds.meets(&other) && !self.planes.iter().any(behind)
    }

    /// Whether a triangle meets it, grown by `padding` (Sutherland and Hodgman 1974).
    fn meets(&self, triangle: &Triangle, padding: f64) -> bool {
        let whole = triangle.vertices.map(vector).to_vec();
        let left = self.planes.iter().fold(whole, |polygon, &(normal, offset)| {
            clipped(&polygon, normal, offset - padding * normal.length())
        });
        !left.is_empty()
    }
}

/// The part of a convex polygon that is in front of a plane.
fn clipped(polygon: &[DVec3], normal: DVec3, offset: f64) -> Vec<DVec3> {
    let height = |p: &DVec3| normal.dot(*p) - offset;
    let next = polygon.iter().cycle().skip(1);
    let mut inside = Vec::with_capacity(polygon.len() + 1);
    for (p, q) in polygon.iter().zip(next) {
        let (a, b) = (height(p), height(q));
        if a >= 0.0 {
            inside.push(*p);
        }
        if (a >= 0.0) != (b >= 0.0) {
            inside.push(p.lerp(*q, a / (a - b)));
        }
    }
    inside
}

/// The point at `t` of the ray through a place of the picture.
fn point(view: &View, t: f64, x: f64, y: f64) -> DVec3 {
    vector(view.eye) + (vector(view.corner) + vector(view.step_x) * x + vector(view.step_y) * y) * t
}

fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

/// The smallest `t` below `end` at which something may be, within the columns that `columns` gives for a `t`: the beginning of a
/// slice. Columns must be widest where `t` is smallest.
fn nearest_within(
    data: &SceneData,
    view: &View,
    end: f64,
    columns: impl Fn(f64) -> Option<[f64; 2]>,
) -> Option<f64> {
    let mut slices = std::iter::successors(Some(NEAREST), |t| Some(t * STEP)).take_while(|t| *t < end);
    slices.find(|&near| {
        columns(near).is_some_and(|columns| {
            meets_a_pack(data, view, &Slice::new(view, [near, (near * STEP).min(end)], columns))
        })
    })
}

/// Whether the box of a pack may meet the slice.
fn meets_a_pack(data: &SceneData, view: &View, slice: &Slice) -> bool {
    let padding = PADDING * (f64::from(data.info.extent) + vector(view.eye).abs().max_element());
    let mut todo = vec![0];
    while let Some(node) = todo.pop() {
        for (child, link) in children(&data.rows, node) {
            match (slice.may_meet(&child, padding), link & LEAF) {
                (false, _) => {}
                (true, 0) => todo.push(link),
                (true, _) if pack_meets(data, link, slice, padding) => return true,
                (true, _) => {}
            }
        }
    }
    false
}

/// Whether a primitive of a pack may meet the slice.
fn pack_meets(data: &SceneData, link: u32, slice: &Slice, padding: f64) -> bool {
    if link & KIND != Kind::Triangles as u32 {
        return true;
    }
    let numbers = data.rows[(link & ROW) as usize + NUMBERS].0;
    let mut triangles = numbers.iter().filter_map(|&number| data.triangles.get(number as usize));
    triangles.any(|triangle| slice.meets(triangle, padding))
}

/// The boxes and links of the children of a node.
fn children(rows: &[Row], node: u32) -> impl Iterator<Item = (Bounds, u32)> {
    let at = move |row: usize, lane: usize| rows[node as usize + row].0[lane];
    let float = move |row, lane| f64::from(f32::from_bits(at(row, lane)));
    let corner = move |row, lane| DVec3::new(float(row, lane), float(row + 1, lane), float(row + 2, lane));
    // A lane without a child has a box that meets nothing.
    (0..LANES)
        .map(move |lane| (Bounds { low: corner(0, lane), high: corner(3, lane) }, at(LINKS, lane)))
        .filter(|(bounds, _)| bounds.low.cmple(bounds.high).all())
}

/// A `t` that nothing which the eye `eye` sees is in front of: 1 / r of Lemma 1. None without anything.
pub fn nearest(data: &SceneData, eye: usize) -> Option<f32> {
    let view = &data.views[eye];
    let columns = [-0.5, f64::from(view.width) - 0.5];
    if meets_a_pack(data, view, &Slice::new(view, [0.0, NEAREST], columns)) {
        // Nearer than the first slice: there is no bound worth having.
        return Some(0.0);
    }
    match nearest_within(data, view, FARTHEST, |_| Some(columns)) {
        Some(t) => Some(t as f32),
        None => (data.primitives() > 0).then_some(FARTHEST as f32),
    }
}

/// From which column on (mirrored if the right eye is the source) candidates are verified whatever the options say; the width if
/// nothing lies where only the second eye sees it, in front of the plane.
pub fn checked_from(data: &SceneData, source: usize) -> u32 {
    let view = &data.views[1 - source];
    let interaxial_px = f64::from(view.interaxial_px).abs();
    let last = f64::from(view.width) - 1.0;
    // Beyond the source's last column: as many columns as the disparity there has pixels.
    let strip = |t: f64| interaxial_px * (1.0 / t - 1.0);
    let columns = |t: f64| {
        let seen = (last - strip(t)).max(-0.5);
        (seen < last + 0.5).then_some(match source {
            0 => [seen, last + 0.5],
            _ => [-0.5, last - seen],
        })
    };
    let found = (interaxial_px > 0.0).then(|| nearest_within(data, view, 1.0, columns)).flatten();
    found.map_or(view.width, |t| (f64::from(view.width) - strip(t).ceil() - 2.0).max(0.0) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_is_clipped_to_what_is_in_front() {
        let triangle = [DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 2.0];
        let left = clipped(&triangle, DVec3::X, 1.0);
        assert_eq!(left, [DVec3::X, DVec3::X * 2.0, DVec3::new(1.0, 1.0, 0.0)]);
        assert_eq!(clipped(&triangle, DVec3::X, -1.0), triangle);
        assert!(clipped(&triangle, DVec3::X, 3.0).is_empty());
    }
}
