//! Scene files: TOML. An unknown key, a wrong type or a value out of range is an error with its line and
//! column.
//!
//! World units are the scene's own; angles are degrees; colours are linear red, green, blue. Points,
//! directions and colours are arrays of three numbers. The world is right-handed with y up (the sky's
//! zenith).
//!
//! | key | meaning | default |
//! |---|---|---|
//! | `name` | what to call the scene | the file's stem |
//! | `ambient` | colour of the ambient light | `[0.15, 0.15, 0.15]` |
//! | `max_depth` | levels of reflection and refraction, 0 … 16 | 5 |
//! | `[camera]` | the stereo rig: | |
//! | `eye`, `target` | midway between the eyes; the point looked at | required |
//! | `up` | what is up in the picture | `[0, 1, 0]` |
//! | `vertical_fov_deg` | full vertical angle of view, 1 … 170 | 40 |
//! | `width`, `height` | pixels of each picture, 1 … 16384 | 800, 600 |
//! | `interaxial_px` | distance between the eyes, pixels of the zero-parallax plane | `width / 40` |
//! | `zero_parallax` | distance to that plane | that of `target` |
//! | `[sky]` | what rays see that leave the scene: | a blue gradient |
//! | `zenith`, `horizon` | colours of a gradient (both) | |
//! | `map` | or an equirectangular picture (Radiance HDR, or any texture format) | |
//! | `[[light]]` | a point light: | none |
//! | `position`, `colour` | its place; its colour, strength included, 0 … 10⁶ | required; white |
//! | `[material.NAME]` | a material: | |
//! | `colour` | of the surface, 0 … 1 | `[0.8, 0.8, 0.8]` |
//! | `texture` | a picture (PNG, JPEG, TGA, BMP; sRGB) that multiplies the colour | none |
//! | `checker` | `{ colour, scale }`: second colour; squares per world unit | none |
//! | `ambient`, `diffuse`, `specular` | weights, 0 … 1 | 1, 0.9, 0.1 |
//! | `shininess` | Phong's exponent, 0 … 10000 | 20 |
//! | `reflection`, `transmission` | weights of what is mirrored and what is seen through, 0 … 1 | 0, 0 |
//! | `eta` | index of refraction inside over outside, 0.1 … 10 | 1.5 |
//! | `[[object]]` | a `material` (its name; a plain grey, the model's or the generator's own ones without) and exactly one of: | |
//! | `sphere` | `{ centre, radius }` | |
//! | `ellipsoid` | `{ centre, radii, rotate }`: half axes; degrees about x, then y, then z | `rotate` none |
//! | `triangle` | `{ vertices, uvs }`: three each | `uvs` (0,0) (1,0) (0,1) |
//! | `quad` | `{ corner, u, v }`: see [`Quad`](super::generate::Quad) | |
//! | `cube` | `{ centre, size }`: see [`Cube`](super::generate::Cube) | |
//! | `icosphere` | `{ centre, radius, subdivisions, smooth }`: see [`Icosphere`](super::generate::Icosphere) | |
//! | `model` | a model file, `.obj` or `.ply`: | |
//! | `model.file` | its name | required |
//! | `model.rotate` | first: degrees about x, then y, then z | none |
//! | `model.fit` | then: length of its longest side; it stands centred on the origin of y = 0 | as it is |
//! | `model.scale` | then: a factor, 10⁻⁶ … 10⁶ | 1 |
//! | `model.translate` | then: moved by | none |
//! | `model.crease_deg` | where the file has no normals, edges look round up to this angle, 0 … 180 | 40 |
//! | `random_spheres` | [`RandomSpheres`](super::generate::RandomSpheres) | `{}` |
//! | `random_ellipsoids` | [`RandomEllipsoids`](super::generate::RandomEllipsoids) | `{}` |
//! | `sphereflake`, `tree` | [`Sphereflake`](super::generate::Sphereflake), [`Tree`](super::generate::Tree); z is up | `{}` |
//! | `jacks`, `lattice` | [`Jacks`](super::generate::Jacks), [`Lattice`](super::generate::Lattice) | `{}` |
//!
//! The names of files are relative to the scene file's directory and may not leave it; `$PARALLAX_MODELS/…`
//! names a file in the directory that the environment variable `PARALLAX_MODELS` says, `../shared/scenes`
//! without it. The generated objects of a scene may have 4 Mi primitives together.

mod assemble;
mod schema;
pub mod value;

use std::ops::Range;
use std::path::Path;

use super::{Scene, SceneError, files};
use assemble::Assembly;
use schema::Document;

/// The largest scene file that is read: 16 MiB.
const MAX_BYTES: u64 = 1 << 24;

/// Reads a scene file and all that it names, as it is in a frame of an animation.
pub(super) fn load(path: &Path, frame: u32) -> Result<Scene, SceneError> {
    let bytes = files::read(path, MAX_BYTES)?;
    let text = std::str::from_utf8(&bytes)
        .map_err(|e| error(path, &bytes, e.valid_up_to()..e.valid_up_to(), "not UTF-8".into()))?;
    let source = Source { path, text };
    let mut document: Document = toml::from_str(text)
        .map_err(|e| source.error(e.span().unwrap_or_default(), e.message().trim().to_string()))?;
    let spheres = document.object.iter_mut().filter_map(|object| object.as_mut().random_spheres.as_mut());
    spheres.for_each(|spheres| spheres.frame = frame);
    Assembly::new(&source).scene(document)
}

/// A scene file's text.
struct Source<'a> {
    path: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    /// What is wrong at a range of bytes.
    fn error(&self, span: Range<usize>, message: String) -> SceneError {
        error(self.path, self.text.as_bytes(), span, message)
    }
}

fn error(path: &Path, text: &[u8], span: Range<usize>, message: String) -> SceneError {
    let before = String::from_utf8_lossy(&text[..span.start.min(text.len())]).into_owned();
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
    SceneError::File { path: path.into(), line, column, message }
}
