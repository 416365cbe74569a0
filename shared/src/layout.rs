//! Plain data in the form in which both backends read it: little-endian words, `repr(C)`, records that a
//! kernel reads whole aligned to 16 bytes (the kernel compiler then loads them 128 bits at a time).
//!
//! Primitives are numbered through: triangles first, then spheres, then ellipsoids ([`SceneInfo`] has the counts).
//!
//! A pass binds few buffers (eight storage buffers must do), so everything that is small lies in one buffer
//! of [`Record`]s, section after section: spheres, ellipsoids, materials, lights, textures.
//! `scene::SceneView` reads it.

use bytemuck::{Pod, Zeroable};

/// No primitive, no texture.
pub const NONE: u32 = u32::MAX;

/// A ray. `t` counts in lengths of `dir`; a hit satisfies `t_min <= t < t_max`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Ray {
    /// Origin, world space.
    pub origin: [f32; 3],
    /// Smallest accepted `t`, at least +0.
    pub t_min: f32,
    /// Direction, world space, any length but zero.
    pub dir: [f32; 3],
    /// Bound of `t`, not accepted itself.
    pub t_max: f32,
}

/// The nearest hit of a ray: `t` is +∞ and `prim_id` is [`NONE`] when there is none.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Hit {
    /// Distance in lengths of the ray's direction.
    pub t: f32,
    /// Number of the primitive.
    pub prim_id: u32,
}

/// One row of the acceleration structure: eight words, one for each lane.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(32))]
pub struct Row(pub [u32; 8]);

/// Sixteen bytes of a sphere, an ellipsoid, a material, a light or a texture.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Record(pub [u32; 4]);

/// What shading knows of the point that a ray hits.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Surface {
    /// The point, world space, closer to the surface than what origin + t · dir would give.
    pub position: [f32; 3],
    /// Number of the primitive, or [`NONE`]; then everything else but the disparity is zero.
    pub prim_id: u32,
    /// Unit geometric normal on the side that the ray came from; zero for a triangle of zero area.
    pub normal: [f32; 3],
    /// Bound of the distance between `position` and the surface as traversal sees it, for the origins of
    /// secondary rays.
    pub error: f32,
    /// Unit normal for shading, on the same side of the shading surface.
    pub shading_normal: [f32; 3],
    /// Index of the material; [`BACK`] is set when the ray came from inside (or from behind a triangle).
    pub material: u32,
    /// Texture coordinates; v points up.
    pub uv: [f32; 2],
    /// Position in the right view less that in the left one, in pixels (see `camera::disparity_px`).
    pub disparity: f32,
    /// Zero.
    pub padding: u32,
}

/// Bit of [`Surface::material`].
pub const BACK: u32 = 1 << 31;

/// Rays traced for one pixel, by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct RayCounts {
    /// From the eye.
    pub primary: u32,
    /// To a light.
    pub shadow: u32,
    /// In mirror direction.
    pub reflected: u32,
    /// Through a surface.
    pub refracted: u32,
}

impl RayCounts {
    /// No rays.
    pub const NONE: Self = Self { primary: 0, shadow: 0, reflected: 0, refracted: 0 };
}

/// A triangle as shading needs it (traversal has its own copy of the vertices in the rows).
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Triangle {
    /// Vertices, world space.
    pub vertices: [[f32; 3]; 3],
    /// Index into the materials.
    pub material: u32,
    /// Unit shading normals at the vertices; all zero when the face is flat.
    pub normals: [[f32; 3]; 3],
    /// 1 when `normals` are to be interpolated, 0 when the face is flat.
    pub smooth: u32,
    /// Texture coordinates at the vertices.
    pub uvs: [[f32; 2]; 3],
    /// Zero.
    pub padding: [u32; 2],
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Sphere {
    /// Centre, world space.
    pub centre: [f32; 3],
    /// Radius, greater than zero.
    pub radius: f32,
    /// Index into the materials.
    pub material: u32,
    /// Zero.
    pub padding: [u32; 3],
}

/// An ellipsoid: the points `p` with `|world_to_unit · (p − centre)| = 1`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Ellipsoid {
    /// Centre, world space.
    pub centre: [f32; 3],
    /// Index into the materials.
    pub material: u32,
    /// Rows of the matrix that takes the ellipsoid to the unit sphere; the fourth word of each is half the
    /// extent of its box along x, y, z.
    pub world_to_unit: [[f32; 4]; 3],
}

/// How a surface reflects light (Whitted 1980; Phong 1975). All colours are linear.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Material {
    /// Colour of the surface; multiplied by the texture where there is one.
    pub colour: [f32; 3],
    /// Index into the textures, or [`NONE`].
    pub texture: u32,
    /// Second colour of a checkerboard.
    pub checker_colour: [f32; 3],
    /// Squares of a checkerboard per world unit; zero for no checkerboard.
    pub checker_scale: f32,
    /// Weight of the ambient term.
    pub ambient: f32,
    /// Weight of the diffuse term.
    pub diffuse: f32,
    /// Weight of the specular term.
    pub specular: f32,
    /// Phong's exponent.
    pub shininess: f32,
    /// Weight of what is seen in mirror direction.
    pub reflection: f32,
    /// Weight of what is seen through the surface (with Fresnel's terms when it is not zero).
    pub transmission: f32,
    /// Index of refraction inside over that outside.
    pub eta: f32,
    /// Zero.
    pub padding: u32,
}

/// A picture among the texels.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Texture {
    /// Index of its first texel; rows from top to bottom.
    pub first: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Zero.
    pub padding: u32,
}

/// A point light.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Light {
    /// Position, world space.
    pub position: [f32; 3],
    /// Zero.
    pub padding: u32,
    /// Linear colour, including its strength.
    pub colour: [f32; 3],
    /// Zero.
    pub padding1: u32,
}

/// What holds for a whole scene.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct SceneInfo {
    /// Linear colour of the ambient light.
    pub ambient: [f32; 3],
    /// Number of triangles.
    pub triangles: u32,
    /// Linear colour of the sky straight up.
    pub sky_zenith: [f32; 3],
    /// Number of spheres.
    pub spheres: u32,
    /// Linear colour of the sky at the horizon.
    pub sky_horizon: [f32; 3],
    /// Number of ellipsoids.
    pub ellipsoids: u32,
    /// Equirectangular sky among the textures, or [`NONE`] for the gradient.
    pub sky_texture: u32,
    /// Number of lights.
    pub lights: u32,
    /// Levels of reflection and refraction behind the primary hit.
    pub max_depth: u32,
    /// Largest absolute coordinate of any primitive: sets the padding of boxes.
    pub extent: f32,
    /// First [`Record`] of the ellipsoids; the spheres begin at 0.
    pub first_ellipsoid: u32,
    /// First record of the materials.
    pub first_material: u32,
    /// First record of the lights.
    pub first_light: u32,
    /// First record of the textures.
    pub first_texture: u32,
}

/// One eye's camera and the band of rows that a run renders.
///
/// The direction through the centre of pixel `(x, y)`, not normalised, is `corner + x·step_x + y·step_y`;
/// rows go from top to bottom.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct View {
    /// The eye, world space.
    pub eye: [f32; 3],
    /// Columns of the picture.
    pub width: u32,
    /// From the eye to the centre of pixel (0, 0) on the zero-parallax plane.
    pub corner: [f32; 3],
    /// Rows of the picture.
    pub height: u32,
    /// From a pixel to the next one in its row.
    pub step_x: [f32; 3],
    /// First row of the band.
    pub first_row: u32,
    /// From a pixel to the one below.
    pub step_y: [f32; 3],
    /// Rows in the band; the band's buffers have `width · rows` elements.
    pub rows: u32,
    /// Unit vector into the scene, orthogonal to the picture.
    pub forward: [f32; 3],
    /// Distance from the eye to the zero-parallax plane (d of the papers, in world units).
    pub distance: f32,
    /// Disparity in pixels of a point at infinity (see `camera::disparity`).
    pub interaxial_px: f32,
    /// Seed of the places of rays within their pixels; 0 when they go through the centres.
    pub jitter_seed: u32,
    /// A pass visits each 2ˢ-th pixel of each 2ˢ-th row of the band (a level of `sampling::lattice`).
    pub spacing_log2: u32,
    /// 1 when it leaves out those that it would visit with twice the spacing.
    pub refines: u32,
}

/// How a band is reprojected from one view, the source, to the other one.
///
/// Columns of a reprojection are mirrored ones when the right eye is the source, so that every source moves to the right behind the
/// zero-parallax plane; `stereo::reprojection::pixel` takes them to memory.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Reprojection {
    /// Columns of the picture.
    pub width: u32,
    /// Rows in the band.
    pub rows: u32,
    /// Disparity in pixels of a point at infinity (e of the papers).
    pub interaxial_px: f32,
    /// 1 when the right eye is the source, else 0.
    pub mirrored: u32,
    /// Which candidates a ray verifies.
    pub verify: u32,
    /// From this column on every candidate is verified; the width for none.
    pub checked_from: u32,
    /// Slots per pixel of a 3D buffer, else 0.
    pub depth: u32,
    /// 1 when no two sources share a slot.
    pub exclusive: u32,
    /// 1 when a gap has its right end too.
    pub inclusive: u32,
    /// 1 when the hits of reused pixels are written too.
    pub keep_hits: u32,
    /// 1 when the colours of reused pixels are copied.
    pub copies: u32,
    /// 1 when not every column of the source was sampled.
    pub sparse: u32,
}

/// The points of a band at which a pixel is sampled (see `sampling::lattice`).
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Lattice {
    /// Columns of pixels.
    pub width: u32,
    /// Rows of pixels in the band.
    pub rows: u32,
    /// Points from a pixel to the next one: a power of two where neighbours share points.
    pub per_pixel: u32,
    /// 1 when neighbours share the points of their common edge, 0 when each pixel has its own.
    pub shares_edges: u32,
}

/// Which cells of a lattice are divided.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Refinement {
    /// Those of whose corners two differ by more in a colour.
    pub tolerance: f32,
    /// 1 when it was planned where points come from, 0 when all are traced.
    pub plans: u32,
}

/// What one point of a lattice sees, and the rays that it took.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(16))]
pub struct Sample {
    /// Linear colour.
    pub colour: [f32; 3],
    /// Zero.
    pub padding: u32,
    /// Rays of every kind.
    pub rays: RayCounts,
}
