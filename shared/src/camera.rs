//! The cameras of the off-axis stereo rig (Adelson and Hodges 1993, eq. 3–7; Al-Hagri 2012, §2.3.2).
//!
//! Both eyes look the same way, orthogonally to one common picture plane at distance d (the zero-parallax
//! plane), and see the same window of it. The rig itself is derived in `parallax::rig`; here is what a pass
//! needs of it.

use crate::layout::{Ray, View};
use crate::math;
use crate::sampling::jitter;
use glam::{Vec2, Vec3};

/// The direction from the eye through pixel (`x`, `y`) of the picture (rows counted from the top of the picture, not of the band):
/// through its centre, or through a place of its own where the view is jittered. Its component along the view's axis is d: it ends on
/// the zero-parallax plane.
#[inline(always)]
pub fn pixel_direction(view: &View, x: u32, y: u32) -> Vec3 {
    let mut place = Vec2::new(x as f32, y as f32);
    if view.jitter_seed != 0 {
        place += jitter::offset(view.jitter_seed, x, y);
    }
    let across = Vec3::from_array(view.step_x) * place.x;
    let down = Vec3::from_array(view.step_y) * place.y;
    (Vec3::from_array(view.corner) + across) + down
}

/// The ray through pixel (`x`, `y`); `t` = 1 on the zero-parallax plane.
#[inline(always)]
pub fn primary_ray(view: &View, x: u32, y: u32) -> Ray {
    Ray { origin: view.eye, t_min: 0.0, dir: pixel_direction(view, x, y).to_array(), t_max: f32::INFINITY }
}

/// Disparity of the point at parameter `t` > 0 of a primary ray: its x in the right view less that in the
/// left one, in pixels.
///
/// This is the one place where the sign is decided: positive behind the zero-parallax plane (e at infinity),
/// 0 on it, negative in front of it (−e at half its distance). From 001 eq. (7), x_r − x_l = e·z / (d + z),
/// with z = (t − 1)·d, as directions end on the plane: d cancels, and near the plane nothing does. −∞ for `t`
/// = 0 unless e is 0.
#[inline(always)]
pub fn disparity_px(interaxial_px: f32, t: f32) -> f32 {
    if t == f32::INFINITY { interaxial_px } else { interaxial_px * math::div(t - 1.0, t) }
}
