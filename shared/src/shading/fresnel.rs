//! Directions and shares of reflected and refracted light.

use crate::math::{self, clamp, max};
use glam::Vec3;

/// The cosine of the refracted ray with the inner normal, or `None` when all light is reflected. `cos_i` > 0
/// is the incident one, `eta` the refractive index on the far side over that on the near one.
#[inline(always)]
pub fn refracted_cosine(cos_i: f32, eta: f32) -> Option<f32> {
    let sin_i_squared = max(1.0 - cos_i * cos_i, 0.0);
    let cos_t_squared = 1.0 - math::div(sin_i_squared, eta * eta);
    if cos_t_squared > 0.0 { Some(math::sqrt(cos_t_squared)) } else { None }
}

/// Fresnel's share of unpolarised light that a dielectric reflects, in 0 ..= 1: 1 when all is reflected, 0
/// for `eta` = 1.
///
/// Grazing incidence tends to 1; where the formula is 0/0 (`cos_i` = 0 with `eta` = 1) it is 1.
#[inline(always)]
pub fn reflectance(cos_i: f32, eta: f32) -> f32 {
    let Some(cos_t) = refracted_cosine(cos_i, eta) else {
        return 1.0;
    };
    let across = eta * cos_i + cos_t;
    let along = cos_i + eta * cos_t;
    if across <= 0.0 || along <= 0.0 {
        return 1.0;
    }
    let parallel = math::div(eta * cos_i - cos_t, across);
    let perpendicular = math::div(cos_i - eta * cos_t, along);
    clamp(0.5 * (parallel * parallel + perpendicular * perpendicular), 0.0, 1.0)
}

/// The refracted direction, of unit length but for rounding, for unit vectors `incident` and `normal`
/// (against `incident`), `cos_i` = −incident·normal and
/// `cos_t` of [`refracted_cosine`].
#[inline(always)]
pub fn refracted(incident: Vec3, normal: Vec3, cos_i: f32, cos_t: f32, eta: f32) -> Vec3 {
    let inverse = math::div(1.0, eta);
    incident * inverse + normal * (cos_i * inverse - cos_t)
}
