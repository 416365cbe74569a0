//! The Fixed and Animated Spheres of 000 (table 4): 1000 randomly distributed spheres, at rest or rotating
//! about the y axis.

use serde::Deserialize;

use super::{Generate, Shapes, SplitMix64};
use crate::scene::file::value::{Angle, Point, Range};
use crate::scene::material;
use crate::scene::model::{rotation, times};

/// Spheres of random place, size and colour, each matt in its own material. The thesis gives neither sizes
/// nor places nor a seed: those here are ours. `turn` rotates all centres about the y axis: a frame of the
/// animated scene.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RandomSpheres {
    /// How many; default 1000.
    pub count: u32,
    /// Seed of the random numbers; default 1.
    pub seed: u64,
    /// Lowest corner of the box of the centres; default (-10, -10, -10).
    pub low: Point,
    /// Highest corner; default (10, 10, 10).
    pub high: Point,
    /// Smallest and largest radius; default 0.2 and 0.6.
    pub radius: Range,
    /// Rotation about the y axis, degrees; default 0.
    pub turn: Angle,
    /// By how much each further frame of an animation is rotated, degrees; default 0.
    pub turn_per_frame: Angle,
    /// Which frame; 0 unless [`load_frame`](crate::scene::load_frame) says otherwise.
    #[serde(skip)]
    pub frame: u32,
}

impl Default for RandomSpheres {
    fn default() -> Self {
        let (low, high) = (Point([-10.0; 3]), Point([10.0; 3]));
        let (turn, turn_per_frame) = (Angle(0.0), Angle(0.0));
        Self { count: 1000, seed: 1, low, high, radius: Range([0.2, 0.6]), turn, turn_per_frame, frame: 0 }
    }
}

impl RandomSpheres {
    /// Degrees about the y axis in this frame. From the frame's number and not from the frame before, so that
    /// nothing adds up however long an animation is.
    fn angle(&self) -> f32 {
        let turned = f64::from(self.frame) * f64::from(self.turn_per_frame.0) % 360.0;
        (f64::from(self.turn.0) + turned) as f32
    }
}

impl Generate for RandomSpheres {
    fn count(&self) -> u64 {
        self.count.into()
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        let mut random = SplitMix64::new(self.seed);
        let turn = rotation([0.0, self.angle(), 0.0]);
        for _ in 0..self.count {
            let centre = times(&turn, random.point(self.low.0, self.high.0).map(f64::from));
            let radius = random.uniform(self.radius.0[0], self.radius.0[1]);
            let material = shapes.material(material::matt(random.point([0.1; 3], [1.0; 3])));
            shapes.sphere(centre, radius.into(), material);
        }
        shapes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_thousand_turns_end_where_they_began() {
        let frame = |frame| RandomSpheres { turn_per_frame: Angle(1.5), frame, ..RandomSpheres::default() };
        assert_eq!(frame(2_400_000).shapes(), RandomSpheres::default().shapes());
        assert_eq!(
            frame(20).shapes(),
            RandomSpheres { turn: Angle(30.0), ..RandomSpheres::default() }.shapes()
        );
    }

    #[test]
    fn turning_keeps_height_and_distance() {
        let fixed = RandomSpheres::default().shapes();
        let turned = RandomSpheres { turn: Angle(30.0), ..RandomSpheres::default() }.shapes();
        assert_eq!(fixed.spheres.len(), 1000);
        assert_eq!(fixed, RandomSpheres::default().shapes());
        assert_ne!(fixed, RandomSpheres { seed: 2, ..RandomSpheres::default() }.shapes());
        for (a, b) in fixed.spheres.iter().zip(&turned.spheres) {
            let distance = |c: [f32; 3]| c[0].hypot(c[2]);
            assert_eq!((a.centre[1], a.radius), (b.centre[1], b.radius));
            assert!((distance(a.centre) - distance(b.centre)).abs() < 1e-5);
            assert_ne!(a.centre[0], b.centre[0]);
        }
    }
}
