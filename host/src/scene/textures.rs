//! The pictures of a scene, each read once, and materials that refer to them.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::model::FileMaterial;
use super::warning::Tally;
use super::{Material, Picture, Problem, SceneError, Warning};

/// The most texels of all pictures of a scene together: 1 GiB once decoded.
const MAX_TEXELS: usize = 1 << 26;

/// Pictures by the order in which they were asked for.
#[derive(Default)]
pub(super) struct Textures {
    pub(super) pictures: Vec<Picture>,
    numbers: HashMap<PathBuf, u32>,
    texels: usize,
}

impl Textures {
    /// The number of the picture at `path`.
    pub(super) fn number(&mut self, path: &Path) -> Result<u32, SceneError> {
        if let Some(number) = self.numbers.get(path) {
            return Ok(*number);
        }
        let picture = Picture::load(path)?;
        self.texels += picture.texels.len();
        if self.texels > MAX_TEXELS {
            let message = format!("the scene's pictures have more than {MAX_TEXELS} texels together");
            return Err(SceneError::Picture { path: path.into(), message });
        }
        let number = self.pictures.len() as u32;
        self.pictures.push(picture);
        self.numbers.insert(path.into(), number);
        Ok(number)
    }

    /// The materials of the model file at `path`, with their textures; those that are missing are done
    /// without.
    pub(super) fn materials(
        &mut self,
        path: &Path,
        from: &[FileMaterial],
    ) -> Result<(Vec<Material>, Vec<Warning>), SceneError> {
        let mut tally = Tally::default();
        let mut materials = Vec::with_capacity(from.len());
        for FileMaterial { material, texture, .. } in from {
            let mut material = *material;
            let number = match texture {
                None => None,
                Some(Err(reason)) => Some(Err(reason.clone())),
                Some(Ok(picture)) => Some(self.number(picture).map_err(|e| e.to_string())),
            };
            match number {
                None => (),
                Some(Ok(number)) => material.texture = number,
                Some(Err(reason)) => tally.add(Problem::FileMissing(reason), None),
            }
            materials.push(material);
        }
        Ok((materials, tally.warnings(path)))
    }
}
