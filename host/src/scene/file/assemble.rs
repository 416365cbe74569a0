//! From a scene file's tables to a [`Scene`].

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use parallax_shared::layout;
use toml::Spanned;

use super::schema::{Camera, Document, Material, Model, Object, Sky};
use super::{Source, schema};
use crate::rig::StereoRig;
use crate::scene::generate::{self, Generate, MAX_PRIMITIVES, Shapes};
use crate::scene::model::{self, DEFAULT_CREASE_DEG, Placement, rotation};
use crate::scene::textures::Textures;
use crate::scene::{Scene, SceneError, bare, files, material};

/// Vertical angle of view where none is said, degrees.
const FOV_DEG: f32 = 40.0;

/// The largest coordinate that a model may have once it is placed, world units.
const MAX_COORDINATE: f32 = 1e15;

/// A scene on its way.
pub(super) struct Assembly<'a> {
    source: &'a Source<'a>,
    directory: &'a Path,
    textures: Textures,
    materials: Vec<layout::Material>,
    by_name: BTreeMap<String, u32>,
    shapes: Shapes,
    /// Primitives that generators have made.
    generated: u64,
    warnings: Vec<crate::scene::Warning>,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(source: &'a Source<'a>) -> Self {
        Self {
            source,
            directory: source.path.parent().unwrap_or(Path::new("")),
            textures: Textures::default(),
            materials: vec![material::DEFAULT],
            by_name: BTreeMap::new(),
            shapes: Shapes::default(),
            generated: 0,
            warnings: Vec::new(),
        }
    }

    pub(super) fn scene(mut self, document: Document) -> Result<Scene, SceneError> {
        let rig = self.rig(&document.camera)?;
        let sky = document.sky.as_ref().map_or(Ok(bare::SKY), |sky| self.sky(sky))?;
        for (name, material) in &document.material {
            let material = self.material(material)?;
            self.by_name.insert(name.clone(), self.materials.len() as u32);
            self.materials.push(material);
        }
        document.object.iter().try_for_each(|object| self.object(object))?;
        let stem = || self.source.path.file_stem().map(|s| s.to_string_lossy().into_owned());
        Ok(Scene {
            name: document.name.or_else(stem).unwrap_or_default(),
            rig,
            ambient: document.ambient.map_or(bare::AMBIENT, |c| c.0),
            lights: document.light.iter().map(light).collect(),
            sky,
            max_depth: document.max_depth.map_or(bare::MAX_DEPTH, |d| d.0),
            materials: self.materials,
            textures: self.textures.pictures,
            triangles: self.shapes.triangles,
            spheres: self.shapes.spheres,
            ellipsoids: self.shapes.ellipsoids,
            warnings: self.warnings,
        })
    }

    fn error<T>(&self, span: Range<usize>, message: impl Into<String>) -> Result<T, SceneError> {
        Err(self.source.error(span, message.into()))
    }

    fn rig(&self, camera: &Spanned<Camera>) -> Result<StereoRig, SceneError> {
        let c = camera.as_ref();
        let up = c.up.map_or([0.0, 1.0, 0.0], |up| up.0);
        let sight: [f64; 3] = std::array::from_fn(|i| f64::from(c.target.0[i]) - f64::from(c.eye.0[i]));
        let distance = length(sight);
        if distance == 0.0 {
            return self.error(camera.span(), "expected `target` at another place than `eye`");
        }
        let up_wide = up.map(f64::from);
        if length(cross(sight, up_wide)) <= 1e-6 * distance * length(up_wide) {
            return self.error(camera.span(), "expected an `up` that is not along the line of sight");
        }
        let width = c.width.map_or(bare::SIZE[0], |w| w.0);
        Ok(StereoRig {
            eye: c.eye.0,
            target: c.target.0,
            up,
            vertical_fov_deg: c.vertical_fov_deg.map_or(FOV_DEG, |f| f.0),
            width,
            height: c.height.map_or(bare::SIZE[1], |h| h.0),
            interaxial_px: c.interaxial_px.map_or(width as f32 / bare::COLUMNS_PER_INTERAXIAL, |e| e.0),
            zero_parallax: c.zero_parallax.map_or(distance as f32, |d| d.0),
        })
    }

    fn sky(&mut self, sky: &Spanned<Sky>) -> Result<crate::scene::Sky, SceneError> {
        match sky.as_ref() {
            Sky { zenith: Some(zenith), horizon: Some(horizon), map: None } => {
                Ok(crate::scene::Sky::Gradient { zenith: zenith.0, horizon: horizon.0 })
            }
            Sky { zenith: None, horizon: None, map: Some(map) } => {
                Ok(crate::scene::Sky::Map(self.picture(map)?))
            }
            _ => self.error(sky.span(), "expected either `zenith` and `horizon`, or `map`"),
        }
    }

    fn file(&self, name: &Spanned<String>) -> Result<PathBuf, SceneError> {
        let path = files::named(self.directory, name.as_ref());
        path.or_else(|message| self.error(name.span(), message))
    }

    fn picture(&mut self, name: &Spanned<String>) -> Result<u32, SceneError> {
        let path = self.file(name)?;
        self.textures.number(&path).or_else(|e| self.error(name.span(), e.to_string()))
    }

    fn material(&mut self, from: &Material) -> Result<layout::Material, SceneError> {
        let mut to = material::DEFAULT;
        let set = |to: &mut f32, from: Option<f32>| *to = from.unwrap_or(*to);
        to.colour = from.colour.map_or(to.colour, |c| c.0);
        set(&mut to.ambient, from.ambient.map(|w| w.0));
        set(&mut to.diffuse, from.diffuse.map(|w| w.0));
        set(&mut to.specular, from.specular.map(|w| w.0));
        set(&mut to.shininess, from.shininess.map(|s| s.0));
        set(&mut to.reflection, from.reflection.map(|w| w.0));
        set(&mut to.transmission, from.transmission.map(|w| w.0));
        set(&mut to.eta, from.eta.map(|e| e.0));
        if let Some(checker) = &from.checker {
            (to.checker_colour, to.checker_scale) = (checker.colour.0, checker.scale.0);
        }
        if let Some(name) = &from.texture {
            to.texture = self.picture(name)?;
        }
        Ok(to)
    }

    fn object(&mut self, object: &Spanned<Object>) -> Result<(), SceneError> {
        let material = match &object.as_ref().material {
            None => None,
            Some(name) => Some(self.named_material(name)?),
        };
        match kinds(object.as_ref()).as_slice() {
            [Kind::Inline(shapes)] => {
                self.append(shapes.clone(), Some(material.unwrap_or(0)));
                Ok(())
            }
            [Kind::Generated(generate)] => self.generate(*generate, material, object.span()),
            [Kind::Model(model)] => self.model(model, material),
            found => self.error(
                object.span(),
                format!(
                    concat!(
                        "expected exactly one of `sphere`, `ellipsoid`, `triangle`, `quad`, `cube`, `icosphere`, ",
                        "`model`, `random_spheres`, `random_ellipsoids`, `sphereflake`, `tree`, `jacks`, `lattice`; ",
                        "found {}"
                    ),
                    found.len()
                ),
            ),
        }
    }

    fn named_material(&self, name: &Spanned<String>) -> Result<u32, SceneError> {
        match self.by_name.get(name.as_ref()) {
            Some(number) => Ok(*number),
            None => {
                let known: Vec<_> = self.by_name.keys().map(|n| format!("`{n}`")).collect();
                let known = if known.is_empty() { "(there is none)".into() } else { known.join(", ") };
                self.error(
                    name.span(),
                    format!("expected one of the materials {known}, found `{}`", name.as_ref()),
                )
            }
        }
    }

    fn generate(
        &mut self,
        generate: &dyn Generate,
        material: Option<u32>,
        span: Range<usize>,
    ) -> Result<(), SceneError> {
        self.generated = self.generated.saturating_add(generate.count());
        if self.generated > MAX_PRIMITIVES {
            return self
                .error(span, format!("expected at most {MAX_PRIMITIVES} generated primitives in a scene"));
        }
        let shapes = generate.shapes();
        // What brings no materials of its own gets the plain one.
        let plain = shapes.materials.is_empty().then_some(0);
        self.append(shapes, material.or(plain));
        Ok(())
    }

    /// Adds shapes, all of one material of the scene or each of its own.
    fn append(&mut self, mut shapes: Shapes, material: Option<u32>) {
        let first = self.materials.len() as u32;
        if material.is_none() {
            self.materials.append(&mut shapes.materials);
        }
        let of = |own: u32| material.unwrap_or(first + own);
        shapes.triangles.iter_mut().for_each(|t| t.material = of(t.material));
        shapes.spheres.iter_mut().for_each(|s| s.material = of(s.material));
        shapes.ellipsoids.iter_mut().for_each(|e| e.material = of(e.material));
        self.shapes.triangles.append(&mut shapes.triangles);
        self.shapes.spheres.append(&mut shapes.spheres);
        self.shapes.ellipsoids.append(&mut shapes.ellipsoids);
    }

    fn model(&mut self, entry: &Model, material: Option<u32>) -> Result<(), SceneError> {
        let path = self.file(&entry.file)?;
        let model = model::read(&path)?;
        let numbers = match material {
            Some(number) => vec![number],
            None => self.own_materials(&path, &model)?,
        };
        let placement = Placement {
            rotate: entry.rotate.map_or([0.0; 3], |r| r.0),
            fit: entry.fit.map(|f| f.0),
            scale: entry.scale.map(|s| s.0),
            translate: entry.translate.map_or([0.0; 3], |t| t.0),
        };
        let crease_deg = entry.crease_deg.map_or(DEFAULT_CREASE_DEG, |c| c.0);
        let (mut triangles, warnings) = model.triangles(&placement, crease_deg, &numbers);
        if let Some(number) = material {
            triangles.iter_mut().for_each(|t| t.material = number);
        }
        if triangles.iter().flat_map(|t| t.vertices).flatten().any(|x| x.is_nan() || x.abs() > MAX_COORDINATE)
        {
            return self.error(entry.file.span(), format!("placed so, it reaches beyond {MAX_COORDINATE:e}"));
        }
        self.shapes.triangles.append(&mut triangles);
        self.warnings.extend(warnings);
        Ok(())
    }

    /// Adds a model's own materials; their numbers, and last that of the plain one.
    fn own_materials(&mut self, path: &Path, model: &model::Model) -> Result<Vec<u32>, SceneError> {
        let (materials, warnings) = self.textures.materials(path, &model.materials)?;
        let first = self.materials.len() as u32;
        let numbers = (first..first + materials.len() as u32).chain([0]).collect();
        self.materials.extend(materials);
        self.warnings.extend(warnings);
        Ok(numbers)
    }
}

/// What an object may be.
enum Kind<'a> {
    Inline(Shapes),
    Generated(&'a dyn Generate),
    Model(&'a Model),
}

/// All that an object says that it is.
fn kinds(object: &Object) -> Vec<Kind<'_>> {
    fn generated<G: Generate>(generate: &Option<G>) -> Option<Kind<'_>> {
        generate.as_ref().map(|g| Kind::Generated(g))
    }
    let inline = [
        object.sphere.as_ref().map(sphere),
        object.ellipsoid.as_ref().map(ellipsoid),
        object.triangle.as_ref().map(triangle),
    ];
    let others = [
        object.model.as_ref().map(Kind::Model),
        generated(&object.quad),
        generated(&object.cube),
        generated(&object.icosphere),
        generated(&object.random_spheres),
        generated(&object.random_ellipsoids),
        generated(&object.sphereflake),
        generated(&object.tree),
        generated(&object.jacks),
        generated(&object.lattice),
    ];
    inline.into_iter().flatten().map(Kind::Inline).chain(others.into_iter().flatten()).collect()
}

fn sphere(s: &schema::Sphere) -> Shapes {
    let sphere = layout::Sphere { centre: s.centre.0, radius: s.radius.0, material: 0, padding: [0; 3] };
    Shapes { spheres: vec![sphere], ..Shapes::default() }
}

fn ellipsoid(e: &schema::Ellipsoid) -> Shapes {
    let rotation = rotation(e.rotate.map_or([0.0; 3], |r| r.0));
    let ellipsoid = generate::ellipsoid(e.centre.0, e.radii.0, rotation, 0);
    Shapes { ellipsoids: vec![ellipsoid], ..Shapes::default() }
}

fn triangle(t: &schema::Triangle) -> Shapes {
    let triangle = layout::Triangle {
        vertices: t.vertices.map(|v| v.0),
        material: 0,
        normals: [[0.0; 3]; 3],
        smooth: 0,
        uvs: t.uvs.map_or([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], |uvs| uvs.map(|uv| uv.0)),
        padding: [0; 2],
    };
    Shapes { triangles: vec![triangle], ..Shapes::default() }
}

fn light(light: &schema::Light) -> layout::Light {
    let colour = light.colour.map_or([1.0; 3], |c| c.0);
    layout::Light { position: light.position.0, padding: 0, colour, padding1: 0 }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
