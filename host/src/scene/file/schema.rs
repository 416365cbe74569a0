//! The tables of a scene file; [the module](super) tells what each key means.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use super::value::*;
use crate::scene::generate::{
    Cube, Icosphere, Jacks, Lattice, Quad, RandomEllipsoids, RandomSpheres, Sphereflake, Tree,
};

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document {
    pub(super) name: Option<String>,
    pub(super) camera: Spanned<Camera>,
    pub(super) ambient: Option<Radiance>,
    pub(super) max_depth: Option<Depth>,
    pub(super) sky: Option<Spanned<Sky>>,
    #[serde(default)]
    pub(super) light: Vec<Light>,
    #[serde(default)]
    pub(super) material: BTreeMap<String, Material>,
    #[serde(default)]
    pub(super) object: Vec<Spanned<Object>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Camera {
    pub(super) eye: Point,
    pub(super) target: Point,
    pub(super) up: Option<Point>,
    pub(super) vertical_fov_deg: Option<Fov>,
    pub(super) width: Option<Pixels>,
    pub(super) height: Option<Pixels>,
    pub(super) interaxial_px: Option<Interaxial>,
    pub(super) zero_parallax: Option<Length>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Light {
    pub(super) position: Point,
    pub(super) colour: Option<Radiance>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sky {
    pub(super) zenith: Option<Radiance>,
    pub(super) horizon: Option<Radiance>,
    pub(super) map: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub(super) colour: Option<Colour>,
    pub(super) texture: Option<Spanned<String>>,
    pub(super) checker: Option<Checker>,
    pub(super) ambient: Option<Weight>,
    pub(super) diffuse: Option<Weight>,
    pub(super) specular: Option<Weight>,
    pub(super) shininess: Option<Shininess>,
    pub(super) reflection: Option<Weight>,
    pub(super) transmission: Option<Weight>,
    pub(super) eta: Option<Eta>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Checker {
    pub(super) colour: Colour,
    pub(super) scale: Frequency,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Object {
    pub(super) material: Option<Spanned<String>>,
    pub(super) sphere: Option<Sphere>,
    pub(super) ellipsoid: Option<Ellipsoid>,
    pub(super) triangle: Option<Triangle>,
    pub(super) quad: Option<Quad>,
    pub(super) cube: Option<Cube>,
    pub(super) icosphere: Option<Icosphere>,
    pub(super) model: Option<Model>,
    pub(super) random_spheres: Option<RandomSpheres>,
    pub(super) random_ellipsoids: Option<RandomEllipsoids>,
    pub(super) sphereflake: Option<Sphereflake>,
    pub(super) tree: Option<Tree>,
    pub(super) jacks: Option<Jacks>,
    pub(super) lattice: Option<Lattice>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sphere {
    pub(super) centre: Point,
    pub(super) radius: Length,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Ellipsoid {
    pub(super) centre: Point,
    pub(super) radii: Lengths,
    pub(super) rotate: Option<Angles>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Triangle {
    pub(super) vertices: [Point; 3],
    pub(super) uvs: Option<[Uv; 3]>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Model {
    pub(super) file: Spanned<String>,
    pub(super) rotate: Option<Angles>,
    pub(super) fit: Option<Length>,
    pub(super) scale: Option<Factor>,
    pub(super) translate: Option<Point>,
    pub(super) crease_deg: Option<Crease>,
}
