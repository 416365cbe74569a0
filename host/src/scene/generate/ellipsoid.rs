//! Ellipsoids from their axes.

use parallax_shared::layout::Ellipsoid;

/// The ellipsoid with half axes of lengths `radii` (each greater than zero) along the columns of `rotation`
/// (given as rows).
pub fn ellipsoid(centre: [f32; 3], radii: [f32; 3], rotation: [[f64; 3]; 3], material: u32) -> Ellipsoid {
    let radii = radii.map(f64::from);
    let world_to_unit = std::array::from_fn(|row| {
        let scaled = |column: usize| (rotation[column][row] / radii[row]) as f32;
        [scaled(0), scaled(1), scaled(2), half_extent(rotation[row], radii)]
    });
    Ellipsoid { centre, material, world_to_unit }
}

/// Half the extent of the box along one world axis, rounded up.
fn half_extent(row: [f64; 3], radii: [f64; 3]) -> f32 {
    let square: f64 = (0..3).map(|i| (row[i] * radii[i]).powi(2)).sum();
    (square.sqrt() as f32).next_up()
}

#[cfg(test)]
mod tests {
    use super::super::SplitMix64;
    use super::*;

    #[test]
    fn points_of_the_surface_map_to_the_unit_sphere_and_lie_in_the_box() {
        let mut random = SplitMix64::new(3);
        let (radii, rotation) = ([0.5, 2.0, 7.0], random.rotation());
        let made = ellipsoid([1.0, -2.0, 3.0], radii, rotation, 4);
        let mut reached = [0.0_f32; 3];
        for _ in 0..20_000 {
            // A point of the unit sphere: the first column of a random rotation.
            let unit = random.rotation().map(|row| row[0]);
            let point = rotation
                .map(|row| (0..3).map(|i| row[i] * f64::from(radii[i]) * unit[i]).sum::<f64>() as f32);
            let back = made.world_to_unit.map(|r| r[0] * point[0] + r[1] * point[1] + r[2] * point[2]);
            assert!((back.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-4);
            for axis in 0..3 {
                assert!(point[axis].abs() <= made.world_to_unit[axis][3]);
                reached[axis] = reached[axis].max(point[axis].abs() / made.world_to_unit[axis][3]);
            }
        }
        assert!(reached.iter().all(|r| *r > 0.99), "the box is not loose: {reached:?}");
    }
}
