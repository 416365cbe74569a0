//! The random ellipsoids of Adelson and Hodges: 20, 100, 125 or 1000 "of random size, positioning, and
//! color", 40 % of them spheres, in some scenes 10 % reflective and 10 % refractive.

use serde::Deserialize;

use super::{Generate, Shapes, SplitMix64, ellipsoid};
use crate::scene::file::value::{Point, Range, Weight};
use crate::scene::material;
use parallax_shared::layout::Material;

/// Ellipsoids of random place, size, orientation and colour with Phong highlights. The paper gives neither
/// sizes nor places nor a seed: those here are ours.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RandomEllipsoids {
    /// How many; default 20.
    pub count: u32,
    /// Seed of the random numbers; default 1.
    pub seed: u64,
    /// Fraction of spheres among them; default 0.4.
    pub spheres: Weight,
    /// Fraction of mirrors; default 0.
    pub reflective: Weight,
    /// Fraction of glass; default 0. What `reflective` leaves is the most there can be.
    pub refractive: Weight,
    /// Lowest corner of the box of the centres; default (-10, -10, -10).
    pub low: Point,
    /// Highest corner; default (10, 10, 10).
    pub high: Point,
    /// Smallest and largest half axis; default 0.5 and 2.5.
    pub radius: Range,
}

impl Default for RandomEllipsoids {
    fn default() -> Self {
        Self {
            count: 20,
            seed: 1,
            spheres: Weight(0.4),
            reflective: Weight(0.0),
            refractive: Weight(0.0),
            low: Point([-10.0; 3]),
            high: Point([10.0; 3]),
            radius: Range([0.5, 2.5]),
        }
    }
}

impl RandomEllipsoids {
    /// Exactly the nearest number to `fraction` of all, at random places in the order; places marked before
    /// stay so.
    fn mark<T: Copy + PartialEq>(&self, kinds: &mut [T], free: T, kind: T, fraction: f32) {
        let count = (f64::from(fraction) * kinds.len() as f64).round() as usize;
        kinds.iter_mut().filter(|k| **k == free).take(count).for_each(|k| *k = kind);
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Surface {
    Phong,
    Mirror,
    Glass,
}

impl Surface {
    fn material(self, colour: [f32; 3]) -> Material {
        let phong = Material { colour, diffuse: 0.8, specular: 0.4, shininess: 40.0, ..material::DEFAULT };
        match self {
            Self::Phong => phong,
            Self::Mirror => Material { ambient: 0.2, diffuse: 0.2, reflection: 0.8, ..phong },
            Self::Glass => Material { ambient: 0.0, diffuse: 0.0, transmission: 1.0, eta: 1.5, ..phong },
        }
    }
}

impl Generate for RandomEllipsoids {
    fn count(&self) -> u64 {
        self.count.into()
    }

    fn shapes(&self) -> Shapes {
        let mut shapes = Shapes::default();
        let mut random = SplitMix64::new(self.seed);
        let mut round = vec![false; self.count as usize];
        self.mark(&mut round, false, true, self.spheres.0);
        random.shuffle(&mut round);
        let mut surfaces = vec![Surface::Phong; self.count as usize];
        self.mark(&mut surfaces, Surface::Phong, Surface::Mirror, self.reflective.0);
        self.mark(&mut surfaces, Surface::Phong, Surface::Glass, self.refractive.0);
        random.shuffle(&mut surfaces);
        for (round, surface) in round.into_iter().zip(surfaces) {
            let centre = random.point(self.low.0, self.high.0);
            let [low, high] = self.radius.0;
            let radii = random.point([low; 3], [high; 3]);
            let material = shapes.material(surface.material(random.point([0.1; 3], [1.0; 3])));
            let rotation = random.rotation();
            if round {
                shapes.sphere(centre.map(f64::from), radii[0].into(), material);
            } else {
                shapes.ellipsoids.push(ellipsoid(centre, radii, rotation, material));
            }
        }
        shapes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_of_each_kind_as_asked_for() {
        for count in [20, 100, 125, 1000] {
            let tenth = Weight(0.1);
            let made = RandomEllipsoids { count, reflective: tenth, refractive: tenth, ..Default::default() }
                .shapes();
            assert_eq!(made.spheres.len(), (0.4 * f64::from(count)) as usize);
            assert_eq!(made.spheres.len() + made.ellipsoids.len(), count as usize);
            let with = |test: fn(&Material) -> bool| made.materials.iter().filter(|m| test(m)).count();
            let expected = (f64::from(count) / 10.0).round() as usize;
            assert_eq!(with(|m| m.reflection > 0.0), expected);
            assert_eq!(with(|m| m.transmission > 0.0), expected);
        }
    }
}
