//! Haines' "balls", the sphereflake (SPD 3.6, balls.c; parameters only).

use serde::Deserialize;

use super::{Generate, Shapes, powers, spd};
use crate::scene::model::times;

/// Every sphere but the smallest carries nine of a third of its radius. The root has radius 0.5 and its axis
/// along +z; the floor is a square at z = -0.5.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Sphereflake {
    /// Levels below the root; default 4: 7381 spheres.
    pub size_factor: u32,
    /// Whether there is a floor; default true.
    pub floor: bool,
}

impl Default for Sphereflake {
    fn default() -> Self {
        Self { size_factor: 4, floor: true }
    }
}

impl Generate for Sphereflake {
    fn count(&self) -> u64 {
        powers(9, self.size_factor).saturating_add(2)
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        let material = shapes.material(spd([1.0, 0.9, 0.7], [0.0, 0.5, 0.5, 37.0]));
        let directions = directions();
        let root = Ball { centre: [0.0; 3], radius: 0.5, axis: [0.0, 0.0, 1.0] };
        grow(&root, self.size_factor, &directions, &mut |ball| {
            shapes.sphere(ball.centre, ball.radius, material)
        });
        if self.floor {
            let material = shapes.material(spd([1.0, 0.75, 0.33], [0.2, 0.8, 0.0, 0.0]));
            shapes.parallelogram([-12.0, -12.0, -0.5], [24.0, 0.0, 0.0], [0.0, 24.0, 0.0], material);
        }
        shapes
    }
}

struct Ball {
    centre: [f64; 3],
    radius: f64,
    axis: [f64; 3],
}

fn grow(ball: &Ball, levels: u32, directions: &[[f64; 3]; 9], emit: &mut dyn FnMut(&Ball)) {
    emit(ball);
    if levels == 0 {
        return;
    }
    let frame = frame(ball.axis);
    for direction in directions {
        let axis = times(&frame, *direction);
        let distance = ball.radius * (1.0 + 1.0 / 3.0);
        let centre = std::array::from_fn(|i| ball.centre[i] + distance * axis[i]);
        grow(&Ball { centre, radius: ball.radius / 3.0, axis }, levels - 1, directions, emit);
    }
}

/// Where the children sit around a sphere whose axis is +z: six on the equator, three above.
fn directions() -> [[f64; 3]; 9] {
    std::array::from_fn(|i| {
        let (azimuth, z) = if i < 6 {
            (15.0 + 60.0 * i as f64, 0.0)
        } else {
            (45.0 + 120.0 * (i - 6) as f64, (2.0_f64 / 3.0).sqrt())
        };
        let (s, c) = azimuth.to_radians().sin_cos();
        let out = (1.0 - z * z).sqrt();
        [out * c, out * s, z]
    })
}

/// The shortest rotation from +z to `axis`, as rows; the half turn about y for -z.
fn frame([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    if z < -0.999_999 {
        return [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
    }
    let k = 1.0 / (1.0 + z);
    [[1.0 - k * x * x, -k * x * y, x], [-k * x * y, 1.0 - k * y * y, y], [-x, -y, z]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_spheres_as_the_spd_has() {
        for (size_factor, spheres) in [(1, 10), (2, 91), (3, 820), (4, 7381)] {
            let made = Sphereflake { size_factor, floor: true };
            assert_eq!(made.shapes().spheres.len(), spheres);
            assert_eq!(made.count(), spheres as u64 + 2);
        }
        assert_eq!(Sphereflake { size_factor: 6, floor: false }.count(), 597_873);
        assert_eq!(Sphereflake { size_factor: u32::MAX, floor: false }.count(), u64::MAX);
    }

    #[test]
    fn every_child_touches_its_parent() {
        let spheres = Sphereflake { size_factor: 1, floor: false }.shapes().spheres;
        for child in &spheres[1..] {
            let distance = child.centre.iter().map(|x| x * x).sum::<f32>().sqrt();
            assert!((distance - 0.5 - child.radius).abs() < 1e-6);
            assert!(child.centre[2] > -1e-6, "none below the equator");
        }
    }
}
