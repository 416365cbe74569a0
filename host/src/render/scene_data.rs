//! A scene as the passes see it: scaled, with its acceleration structure, packed into the records of
//! `shared::layout`.

use super::RenderError;
use super::overrides::check_limits;
use super::scale::{self, Scaled};
use crate::build::{self, Quality, Stats};
use crate::scene::{Scene, Sky};
use bytemuck::Pod;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{NONE, Record, Row, SceneInfo, Texture, Triangle, View};
use rayon::prelude::*;

/// How much farther away than the geometry and the eyes a light may be: beyond this its squared distance
/// could overflow.
const FARTHEST_LIGHT: f32 = 1e12;

/// Everything that a backend needs of a scene. All coordinates are scaled by [`SceneData::scale`].
#[derive(Clone, Debug)]
pub struct SceneData {
    /// Counts, offsets, ambient light and sky.
    pub info: SceneInfo,
    /// The acceleration structure.
    pub rows: Vec<Row>,
    /// Triangles, for shading.
    pub triangles: Vec<Triangle>,
    /// Spheres, ellipsoids, materials, lights and textures.
    pub records: Vec<Record>,
    /// Texels of all textures.
    pub texels: Vec<[f32; 4]>,
    /// The left and the right eye; the band of rows is the whole picture.
    pub views: [View; 2],
    /// What the scene calls for.
    pub effects: Effects,
    /// The power of two that takes world units to those of the data.
    pub scale: f32,
    /// What the acceleration structure is like.
    pub stats: Stats,
}

impl SceneData {
    /// Scales and packs `scene` and builds its acceleration structure.
    ///
    /// # Errors
    /// When the picture is too large, the camera makes no picture, or coordinates are too far apart for 32
    /// bit floats.
    pub fn new(scene: &Scene, quality: Quality) -> Result<Self, RenderError> {
        check_limits(scene)?;
        let extent = scale::extent(scene);
        check_distances(scene, extent)?;
        let factor = scale::factor(extent);
        let views = scene.rig.views(factor)?;
        let triangles: Vec<_> = scaled(&scene.triangles, factor);
        let (spheres, ellipsoids) = (scaled(&scene.spheres, factor), scaled(&scene.ellipsoids, factor));
        let bvh = build::build(&triangles, &spheres, &ellipsoids, quality)?;

        let materials = scaled(&scene.materials, factor);
        let (textures, texels) = pack_textures(scene);
        let mut records = Vec::new();
        append(&mut records, &spheres);
        let first_ellipsoid = append(&mut records, &ellipsoids);
        let first_material = append(&mut records, &materials);
        let first_light = append(&mut records, &scaled(&scene.lights, factor));
        let first_texture = append(&mut records, &textures);
        let (sky_zenith, sky_horizon, sky_texture) = match scene.sky {
            Sky::Gradient { zenith, horizon } => (zenith, horizon, NONE),
            Sky::Map(texture) => ([0.0; 3], [0.0; 3], texture),
        };
        let info = SceneInfo {
            ambient: scene.ambient,
            triangles: triangles.len() as u32,
            sky_zenith,
            spheres: spheres.len() as u32,
            sky_horizon,
            ellipsoids: ellipsoids.len() as u32,
            sky_texture,
            lights: scene.lights.len() as u32,
            max_depth: scene.max_depth,
            extent: bvh.extent,
            first_ellipsoid,
            first_material,
            first_light,
            first_texture,
        };
        let effects = Effects::of_scene(&info, &materials, &triangles);
        Ok(Self {
            info,
            rows: bvh.rows,
            triangles,
            records,
            texels,
            views,
            effects,
            scale: factor,
            stats: bvh.stats,
        })
    }

    /// Number of triangles, spheres and ellipsoids.
    pub fn primitives(&self) -> u64 {
        [self.info.triangles, self.info.spheres, self.info.ellipsoids].map(u64::from).iter().sum()
    }

    /// Names of the effects that the scene calls for.
    pub fn effect_names(&self) -> Vec<&'static str> {
        Effects::NAMES.iter().filter(|(effect, _)| self.effects.has(*effect)).map(|(_, name)| *name).collect()
    }
}

fn check_distances(scene: &Scene, extent: f32) -> Result<(), RenderError> {
    let too_far = |what: String, distance| RenderError::TooFar { what, distance, extent };
    if !extent.is_finite() {
        return Err(too_far("a primitive".into(), extent));
    }
    for (number, light) in scene.lights.iter().enumerate() {
        let distance = scale::largest(&light.position);
        if distance > extent * FARTHEST_LIGHT {
            return Err(too_far(format!("light {number}"), distance));
        }
    }
    Ok(())
}

fn scaled<T: Scaled + Sync + Send>(items: &[T], factor: f32) -> Vec<T> {
    items.par_iter().map(|item| item.scaled(factor)).collect()
}

/// Appends `items` and returns the number of the first of their records.
fn append<T: Pod>(records: &mut Vec<Record>, items: &[T]) -> u32 {
    let first = records.len() as u32;
    records.extend_from_slice(bytemuck::cast_slice(items));
    first
}

fn pack_textures(scene: &Scene) -> (Vec<Texture>, Vec<[f32; 4]>) {
    let mut texels = Vec::new();
    let textures = scene.textures.iter().map(|picture| {
        let first = texels.len() as u32;
        texels.extend_from_slice(&picture.texels);
        Texture { first, width: picture.width, height: picture.height, padding: 0 }
    });
    (textures.collect(), texels)
}
