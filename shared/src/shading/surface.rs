//! From a hit to what shading needs of it.

use crate::camera;
use crate::effects::Effects;
use crate::geom::{ellipsoid, sphere};
use crate::layout::{BACK, Hit, NONE, Ray, Surface, Triangle};
use crate::math::{self, Offset, max, min, vector};
use crate::scene::SceneView;
use glam::{Vec2, Vec3};
use kernel_api::At;

/// Bound of the distance between [`Surface::position`] and the surface that traversal sees, over the sum of
/// the largest coordinate and the size of the primitive.
///
/// Positions are right within 4 half-ULPs of that sum. Traversal rounds each vertex once when it is moved to
/// the ray's origin and twice when it is sheared, and the edge functions once more each; seen from a point at
/// the surface that is another 6 half-ULPs of the primitive's size, all along the ray, which is how the error
/// of `t` shows where the ray grazes the surface. 16 half-ULPs cover both and the rounding of the moved
/// origin.
const ERROR: f32 = 8.0 * f32::EPSILON;

/// What a primary or secondary ray sees where nothing is.
#[inline(always)]
fn nothing(interaxial_px: f32) -> Surface {
    Surface {
        position: [0.0; 3],
        prim_id: NONE,
        normal: [0.0; 3],
        error: 0.0,
        shading_normal: [0.0; 3],
        material: 0,
        uv: [0.0; 2],
        disparity: interaxial_px,
        padding: 0,
    }
}

/// A point of a surface, before it is known from which side it is seen.
struct Point {
    position: Vec3,
    /// Unit geometric normal, outwards (of a triangle: to where its vertices run counter-clockwise).
    normal: Vec3,
    shading_normal: Vec3,
    uv: Vec2,
    material: u32,
    /// Largest extent of the primitive.
    size: f32,
}

/// What shading needs of `hit`, which must be what traversal found for `ray`. For the disparity, `ray` is
/// taken for a primary ray of a view with this
/// `interaxial_px`; pass 0 for other rays.
///
/// A function of the ray, the hit and the primitive. Normals face the ray's origin. Degenerate triangles have
/// a zero normal.
#[inline(always)]
pub fn reconstruct(scene: &SceneView<'_>, ray: &Ray, hit: Hit, interaxial_px: f32) -> Surface {
    let mut surface = nothing(interaxial_px);
    if hit.prim_id == NONE {
        return surface;
    }
    let point = point(scene, ray, hit);
    let back = point.normal.dot(Vec3::from_array(ray.dir)) > 0.0;
    let normal = if back { -point.normal } else { point.normal };
    // Models disagree about which way their normals point, so the geometric one decides.
    let shading_normal =
        if point.shading_normal.dot(normal) < 0.0 { -point.shading_normal } else { point.shading_normal };
    surface.position = point.position.to_array();
    surface.prim_id = hit.prim_id;
    surface.normal = normal.to_array();
    surface.error = (vector::max_abs(point.position) + point.size) * ERROR;
    surface.shading_normal = shading_normal.to_array();
    surface.material = point.material | if back { BACK } else { 0 };
    surface.uv = point.uv.to_array();
    surface.disparity = camera::disparity_px(interaxial_px, hit.t);
    surface
}

#[inline(always)]
fn point(scene: &SceneView<'_>, ray: &Ray, hit: Hit) -> Point {
    let info = scene.info;
    if scene.effects.has(Effects::TRIANGLES) && hit.prim_id < info.triangles {
        return on_triangle(scene.triangles.at_ref(hit.prim_id), ray, hit.t, scene.effects);
    }
    let number = hit.prim_id.wrapping_sub(info.triangles);
    if scene.effects.has(Effects::SPHERES) && number < info.spheres {
        return on_sphere(scene, number, ray, hit.t);
    }
    let number = number.wrapping_sub(info.spheres);
    if scene.effects.has(Effects::ELLIPSOIDS) && number < info.ellipsoids {
        return on_ellipsoid(scene, number, ray, hit.t);
    }
    Point {
        position: Vec3::ZERO,
        normal: Vec3::ZERO,
        shading_normal: Vec3::ZERO,
        uv: Vec2::ZERO,
        material: 0,
        size: 0.0,
    }
}

#[inline(always)]
fn on_triangle(triangle: &Triangle, ray: &Ray, t: f32, effects: Effects) -> Point {
    let [a, b, c] = triangle.vertices.map(Vec3::from_array);
    let (ab, ac) = (b - a, c - a);
    // Where the ray is at `t`, seen from `a`: exact to rounding of its distance from there, however far the eye is.
    let from_a = Offset::new(Vec3::from_array(ray.origin), a).along(Vec3::from_array(ray.dir), t);
    let across = ab.cross(ac);
    let square = across.dot(across);
    let has_area = square >= f32::MIN_POSITIVE;
    let inverse = if has_area { math::div(1.0, square) } else { 0.0 };
    let (v, w) = inside(from_a.cross(ac).dot(across) * inverse, ab.cross(from_a).dot(across) * inverse);
    let normal = if has_area { vector::normalize(across) } else { Vec3::ZERO };
    let [uv_a, uv_b, uv_c] = triangle.uvs.map(Vec2::from_array);
    Point {
        position: a + (ab * v + ac * w),
        normal,
        shading_normal: if effects.has(Effects::SMOOTH_NORMALS) {
            smooth_normal(triangle, v, w, normal)
        } else {
            normal
        },
        uv: uv_a + ((uv_b - uv_a) * v + (uv_c - uv_a) * w),
        material: triangle.material,
        size: max(vector::max_abs(ab), vector::max_abs(ac)),
    }
}

/// The weights of the second and third vertex, moved into the triangle.
#[inline(always)]
fn inside(v: f32, w: f32) -> (f32, f32) {
    let v = math::clamp(v, 0.0, 1.0);
    (v, min(max(w, 0.0), 1.0 - v))
}

#[inline(always)]
fn smooth_normal(triangle: &Triangle, v: f32, w: f32, flat: Vec3) -> Vec3 {
    let [a, b, c] = triangle.normals.map(Vec3::from_array);
    let normal = vector::normalize(a + ((b - a) * v + (c - a) * w));
    if triangle.smooth == 0 || normal == Vec3::ZERO { flat } else { normal }
}

#[inline(always)]
fn on_sphere(scene: &SceneView<'_>, number: u32, ray: &Ray, t: f32) -> Point {
    let sphere = scene.sphere(number);
    let (position, normal) = sphere::point_and_normal(sphere.centre, sphere.radius, ray, t);
    let uv = if scene.effects.has(Effects::TEXTURES) { sphere::uv(normal) } else { Vec2::ZERO };
    Point { position, normal, shading_normal: normal, uv, material: sphere.material, size: sphere.radius }
}

#[inline(always)]
fn on_ellipsoid(scene: &SceneView<'_>, number: u32, ray: &Ray, t: f32) -> Point {
    let ellipsoid = scene.ellipsoid(number);
    let ellipsoid::Point { position, normal, on_unit_sphere } = ellipsoid::point(&ellipsoid, ray, t);
    let uv = if scene.effects.has(Effects::TEXTURES) { sphere::uv(on_unit_sphere) } else { Vec2::ZERO };
    let half = Vec3::new(
        ellipsoid.world_to_unit[0][3],
        ellipsoid.world_to_unit[1][3],
        ellipsoid.world_to_unit[2][3],
    );
    Point {
        position,
        normal,
        shading_normal: normal,
        uv,
        material: ellipsoid.material,
        size: vector::max_abs(half),
    }
}

/// The origin of a ray that leaves the surface on the side to which `direction` goes: moved along the
/// geometric normal by the error bound, so that the ray does not meet the surface that it leaves.
///
/// Wächter and Binder (*A Fast and Reliable Method for Avoiding Self-Intersection*, 2019) move by a fixed
/// number of ULPs of each coordinate, which is too little for large triangles near the origin of the world
/// and far too much elsewhere; here the bound of what was really computed sets the distance (as in Pharr et
/// al., *Physically Based Rendering*, §6.8.6).
#[inline(always)]
pub fn leave(surface: &Surface, direction: Vec3) -> Vec3 {
    let normal = Vec3::from_array(surface.normal);
    let distance = if normal.dot(direction) < 0.0 { -surface.error } else { surface.error };
    Vec3::from_array(surface.position) + normal * distance
}
