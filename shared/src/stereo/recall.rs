//! Reflections and refractions of the source, for points that both eyes see from nearly the same side (003 §5.5.2).

use crate::math::vector;
use glam::Vec3;

/// Whether the angle between two directions (of any length) has at least the cosine `cos_limit`.
///
/// At one point and normal the mirrored rays of two eyes are as far apart as the rays themselves, so that these tell what 003 asks of
/// the mirrored ones. Refracted rays are nearer to each other where the ray enters the denser medium.
#[inline(always)]
pub fn is_near(a: Vec3, b: Vec3, cos_limit: f32) -> bool {
    vector::normalize(a).dot(vector::normalize(b)) >= cos_limit
}

#[cfg(test)]
mod tests {
    use super::is_near;
    use glam::Vec3;

    #[test]
    fn the_angle_decides_and_not_the_length() {
        let (a, b) = (Vec3::new(0.0, 0.0, -2.0), Vec3::new(0.1, 0.0, -1.0));
        let cos = 1.0 / (1.01_f32).sqrt();
        assert!(is_near(a, b, cos - 1e-5) && !is_near(a, b, cos + 1e-5));
        assert!(is_near(a, a * 7.0, 1.0 - 1e-6));
    }
}
