//! A scene made by hand, rendered by the passes themselves on any backend: for tests that must know what is in it.

use crate::backend::Backend;
use crate::build::{self, Quality};
use crate::render::band::Bounced;
use crate::render::{RenderError, SceneBuffers};
use parallax_kernels::{
    bounce::Bounce, primary::Primary, shade::Shade, shadow::Shadow, surface::Surface as SurfacePass,
};
use parallax_shared::effects::Effects;
use parallax_shared::layout::*;
use parallax_shared::shading::shadow;

/// A scene and a view of it.
#[derive(Clone)]
pub struct Stage {
    /// The eye.
    pub view: View,
    /// Ambient light.
    pub ambient: [f32; 3],
    /// Sky straight up.
    pub zenith: [f32; 3],
    /// Sky at the horizon.
    pub horizon: [f32; 3],
    /// Picture in the sky.
    pub sky_texture: u32,
    /// Levels of reflection and refraction.
    pub max_depth: u32,
    /// Triangles.
    pub triangles: Vec<Triangle>,
    /// Spheres.
    pub spheres: Vec<Sphere>,
    /// Ellipsoids.
    pub ellipsoids: Vec<Ellipsoid>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Lights.
    pub lights: Vec<Light>,
    /// Textures.
    pub textures: Vec<Texture>,
    /// Their texels.
    pub texels: Vec<[f32; 4]>,
}

/// What the passes have made of a stage, pixel by pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Stages {
    /// Primary hits.
    pub hits: Vec<Hit>,
    /// What shading knows of them.
    pub surfaces: Vec<Surface>,
    /// Words of lights seen.
    pub seen: Vec<u32>,
    /// Colour without reflection and refraction.
    pub local: Vec<[f32; 4]>,
    /// Final colour.
    pub colours: Vec<[f32; 4]>,
    /// Rays of the passes `primary`, `shadow` and `bounce`.
    pub counts: [Vec<RayCounts>; 3],
}

impl Stages {
    /// The same bits as another backend made? By what they are of.
    pub fn compare(&self, other: &Self) -> [(&'static str, bool); 6] {
        let words = |colours: &[[f32; 4]]| bytemuck::cast_slice::<_, u32>(colours).to_vec();
        [
            ("hits", self.hits == other.hits),
            ("surfaces", self.surfaces == other.surfaces),
            ("lights seen", self.seen == other.seen),
            ("local colours", words(&self.local) == words(&other.local)),
            ("colours", words(&self.colours) == words(&other.colours)),
            ("counts of rays", self.counts == other.counts),
        ]
    }
}

/// A matt white material that other ones are made of.
pub fn white() -> Material {
    Material {
        colour: [1.0; 3],
        texture: NONE,
        checker_colour: [0.0; 3],
        checker_scale: 0.0,
        ambient: 0.0,
        diffuse: 1.0,
        specular: 0.0,
        shininess: 0.0,
        reflection: 0.0,
        transmission: 0.0,
        eta: 1.0,
        padding: 0,
    }
}

/// A light.
pub fn light(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light { position, padding: 0, colour, padding1: 0 }
}

/// A sphere.
pub fn sphere(centre: [f32; 3], radius: f32, material: u32) -> Sphere {
    Sphere { centre, radius, material, padding: [0; 3] }
}

/// An ellipsoid with these half axes, turned about y by `angle`.
pub fn ellipsoid(centre: [f32; 3], half: [f64; 3], angle: f64, material: u32) -> Ellipsoid {
    let (sin, cos) = angle.sin_cos();
    let axes = [[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]];
    let extent = |axis: usize| (0..3).map(|i| (half[i] * axes[i][axis]).powi(2)).sum::<f64>().sqrt();
    let row = |i: usize| {
        let [x, y, z] = axes[i].map(|c| (c / half[i]) as f32);
        [x, y, z, extent(i) as f32]
    };
    Ellipsoid { centre, material, world_to_unit: [row(0), row(1), row(2)] }
}

/// A flat triangle with texture coordinates (0,0), (1,0), (0,1).
pub fn triangle(vertices: [[f32; 3]; 3], material: u32) -> Triangle {
    Triangle {
        vertices,
        material,
        normals: [[0.0; 3]; 3],
        smooth: 0,
        uvs: [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        padding: [0; 2],
    }
}

/// The parallelogram `corner`, `corner + a`, `corner + b`, `corner + a + b`, as two triangles; u runs along
/// `a`, v along `b`.
pub fn quad(corner: [f32; 3], a: [f32; 3], b: [f32; 3], material: u32) -> [Triangle; 2] {
    let add = |p: [f32; 3], q: [f32; 3]| [p[0] + q[0], p[1] + q[1], p[2] + q[2]];
    let (right, above) = (add(corner, a), add(corner, b));
    let mut second = triangle([add(right, b), above, right], material);
    second.uvs = [[1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    [triangle([corner, right, above], material), second]
}

impl Stage {
    /// Nothing, under a black sky.
    pub fn new(view: View) -> Self {
        Self {
            view,
            ambient: [0.0; 3],
            zenith: [0.0; 3],
            horizon: [0.0; 3],
            sky_texture: NONE,
            max_depth: 5,
            triangles: Vec::new(),
            spheres: Vec::new(),
            ellipsoids: Vec::new(),
            materials: Vec::new(),
            lights: Vec::new(),
            textures: Vec::new(),
            texels: Vec::new(),
        }
    }

    /// Counts and offsets, for an acceleration structure of this extent.
    pub fn info(&self, extent: f32) -> SceneInfo {
        let first_ellipsoid = 2 * self.spheres.len() as u32;
        let first_material = first_ellipsoid + 4 * self.ellipsoids.len() as u32;
        let first_light = first_material + 4 * self.materials.len() as u32;
        SceneInfo {
            ambient: self.ambient,
            triangles: self.triangles.len() as u32,
            sky_zenith: self.zenith,
            spheres: self.spheres.len() as u32,
            sky_horizon: self.horizon,
            ellipsoids: self.ellipsoids.len() as u32,
            sky_texture: self.sky_texture,
            lights: self.lights.len() as u32,
            max_depth: self.max_depth,
            extent,
            first_ellipsoid,
            first_material,
            first_light,
            first_texture: first_light + 2 * self.lights.len() as u32,
        }
    }

    /// Spheres, ellipsoids, materials, lights and textures.
    pub fn records(&self) -> Vec<Record> {
        let mut records: Vec<Record> = bytemuck::cast_slice(&self.spheres).to_vec();
        records.extend_from_slice(bytemuck::cast_slice(&self.ellipsoids));
        records.extend_from_slice(bytemuck::cast_slice(&self.materials));
        records.extend_from_slice(bytemuck::cast_slice(&self.lights));
        records.extend_from_slice(bytemuck::cast_slice(&self.textures));
        records
    }

    /// What the scene calls for.
    pub fn effects(&self) -> Effects {
        Effects::of_scene(&self.info(0.0), &self.materials, &self.triangles)
    }

    /// Builds its structure and uploads what the passes read of it.
    ///
    /// # Errors
    /// When it cannot be built, or the backend fails.
    pub fn upload<B: Backend>(&self, backend: &mut B) -> Result<(SceneInfo, SceneBuffers), RenderError> {
        let bvh = build::build(&self.triangles, &self.spheres, &self.ellipsoids, Quality::default())?;
        let buffers = SceneBuffers {
            rows: backend.upload("rows", &bvh.rows)?,
            triangles: backend.upload("triangles", &self.triangles)?,
            records: backend.upload("records", &self.records())?,
            texels: backend.upload("texels", &self.texels)?,
        };
        Ok((self.info(bvh.extent), buffers))
    }

    /// Runs all passes with the effects that the scene calls for.
    pub fn render<B: Backend>(&self, backend: &mut B) -> Result<Stages, RenderError> {
        self.render_with(backend, self.effects())
    }

    /// Runs all passes with `effects`.
    pub fn render_with<B: Backend>(
        &self,
        backend: &mut B,
        Effects(effects): Effects,
    ) -> Result<Stages, RenderError> {
        let (info, scene) = self.upload(backend)?;
        let SceneBuffers { rows, triangles, records, texels } = scene;
        let view = self.view;
        let pixels = (view.width * view.rows) as usize;
        let hits = backend.create("hits", pixels)?;
        let surfaces = backend.create("surfaces", pixels)?;
        let seen = backend.create("seen", pixels * shadow::words(info.lights) as usize)?;
        let local = backend.create("local", pixels)?;
        let colours = backend.create("colours", pixels)?;
        let counts =
            [backend.create("0", pixels)?, backend.create("1", pixels)?, backend.create("2", pixels)?];
        let extent = [view.width, view.rows, 1];
        backend.run(&Primary { view, info, rows, hits, counts: counts[0] }, extent)?;
        backend.run(&SurfacePass { view, info, triangles, records, hits, surfaces, effects }, extent)?;
        backend
            .run(&Shadow { view, info, rows, records, surfaces, seen, counts: counts[1], effects }, extent)?;
        backend
            .run(&Shade { view, info, records, texels, surfaces, seen, colours: local, effects }, extent)?;
        let bounce = Bounce {
            view,
            info,
            rows,
            triangles,
            records,
            texels,
            surfaces,
            local,
            colours,
            counts: counts[2],
            effects,
        };
        backend.run(&bounce, extent)?;
        let local = backend.read(local)?;
        let bounced = Bounced::to(&local, backend.read(colours)?, backend.read(counts[2])?);
        Ok(Stages {
            hits: backend.read(hits)?,
            surfaces: backend.read(surfaces)?,
            seen: backend.read(seen)?,
            local,
            colours: bounced.colour,
            counts: [backend.read(counts[0])?, backend.read(counts[1])?, bounced.rays],
        })
    }
}
