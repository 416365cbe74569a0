//! Material libraries (MTL) of OBJ files, and what they become in Whitted's model.
//!
//! `Kd` is the colour, linear, with the ambient and diffuse weights 1 (many libraries have a zero `Ka` under
//! their own ambient light); the largest component of `Ks` is the specular weight, `Ns` the exponent. `illum`
//! 3, 5 and 8 reflect as much as they shine; `d` below 1 lets the rest through, bent by `Ni` where `illum` is
//! 4, 6, 7 or 9. `map_Kd` is the texture. A value that cannot be used leaves the default: these files are too
//! loose to refuse a model for.

use std::path::{Path, PathBuf};

use parallax_shared::layout::Material;

use super::lines::{Lines, number, words};
use super::obj::rest_of;
use crate::scene::{SceneError, files, material};

/// The largest library that is read: 16 MiB.
const MAX_BYTES: u64 = 1 << 24;

/// A material of a model file.
#[derive(Clone, Debug)]
pub(crate) struct FileMaterial {
    pub(crate) name: String,
    /// Its texture is not set.
    pub(crate) material: Material,
    /// The picture that `map_Kd` names, beside the library; an error text when it lies elsewhere.
    pub(crate) texture: Option<Result<PathBuf, String>>,
    illumination: u32,
    dissolve: f32,
    refraction: f32,
}

/// Reads a library.
pub(super) fn read(path: &Path) -> Result<Vec<FileMaterial>, SceneError> {
    let text = files::read(path, MAX_BYTES)?;
    let directory = path.parent().unwrap_or(Path::new(""));
    let mut materials: Vec<FileMaterial> = Vec::new();
    for line in Lines::new(&text) {
        match (words(line).next(), materials.last_mut()) {
            (Some(b"newmtl"), _) => materials.push(FileMaterial::new(rest_of(line))),
            (Some(key), Some(material)) => material.set(key, line, directory),
            _ => (),
        }
    }
    materials.iter_mut().for_each(FileMaterial::finish);
    Ok(materials)
}

impl FileMaterial {
    fn new(name: String) -> Self {
        let material = Material { ambient: 1.0, diffuse: 1.0, specular: 0.0, ..material::DEFAULT };
        Self { name, material, texture: None, illumination: 2, dissolve: 1.0, refraction: 1.0 }
    }

    fn set(&mut self, key: &[u8], line: &[u8], directory: &Path) {
        let mut numbers = words(line).skip(1).map_while(number).map(|x| x as f32).filter(|x| x.is_finite());
        let first = numbers.next();
        // One number stands for three alike.
        let colour = first.map(|r| {
            let g = numbers.next().unwrap_or(r);
            [r, g, numbers.next().unwrap_or(g)].map(|x| x.clamp(0.0, 1.0))
        });
        match (key, first, colour) {
            (b"Kd", _, Some(colour)) => self.material.colour = colour,
            (b"Ks", _, Some([r, g, b])) => self.material.specular = r.max(g).max(b),
            (b"Ns", Some(x), _) => self.material.shininess = x.clamp(0.0, material::MAX_SHININESS),
            (b"Ni", Some(x), _) if (0.1..=10.0).contains(&x) => self.refraction = x,
            (b"d", Some(x), _) => self.dissolve = x.clamp(0.0, 1.0),
            (b"illum", Some(x), _) => self.illumination = x as u32,
            (b"map_Kd", ..) => self.texture = texture(&rest_of(line), directory),
            _ => (),
        }
    }

    fn finish(&mut self) {
        if matches!(self.illumination, 3 | 5 | 8) {
            self.material.reflection = self.material.specular;
        }
        self.material.transmission = 1.0 - self.dissolve;
        self.material.diffuse *= self.dissolve;
        if matches!(self.illumination, 4 | 6 | 7 | 9) {
            self.material.eta = self.refraction;
        } else {
            self.material.eta = 1.0;
        }
    }
}

/// The picture that a `map_Kd` names, which options like `-s 1 1 1` may precede.
fn texture(text: &str, directory: &Path) -> Option<Result<PathBuf, String>> {
    let name = without_options(text);
    (!name.is_empty()).then(|| {
        files::beside(directory, name).ok_or_else(|| format!("`{name}` lies outside the model's directory"))
    })
}

fn without_options(mut text: &str) -> &str {
    while text.starts_with('-') {
        let Some((_, rest)) = text.split_once(char::is_whitespace) else { return "" };
        text = rest.trim_start();
        // The options take numbers or on/off.
        while let Some((word, rest)) = text.split_once(char::is_whitespace) {
            if word.parse::<f32>().is_err() && !matches!(word, "on" | "off") {
                break;
            }
            text = rest.trim_start();
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_in_whitteds_terms() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("a.mtl");
        let text = "Kd 9 9 9\nnewmtl my glass\n\tKd 0.5\n Ks .1 .9 .2\nNs 1e9\nNi 1.5\nd 0.25\nillum 7\n\
                    map_Kd -s 1 1 1 -clamp on a b.png\nKd spectral x\nnewmtl mirror\nKs 1 1 1\nillum 3\nmap_Kd ../x.png";
        std::fs::write(&path, text).unwrap();
        let [glass, mirror] = &read(&path).unwrap()[..] else { panic!() };
        assert_eq!(glass.name, "my glass");
        assert_eq!(glass.material.colour, [0.5; 3]);
        assert_eq!(
            (glass.material.specular, glass.material.transmission, glass.material.eta),
            (0.9, 0.75, 1.5)
        );
        assert_eq!(glass.material.shininess, material::MAX_SHININESS);
        assert_eq!(glass.texture, Some(Ok(directory.path().join("a b.png"))));
        assert_eq!((mirror.material.reflection, mirror.material.transmission), (1.0, 0.0));
        assert!(mirror.texture.as_ref().unwrap().is_err());
    }

    #[test]
    fn options_of_any_number_end() {
        assert_eq!(without_options("-bm 0.5 a.png"), "a.png");
        assert_eq!(without_options("-s"), "");
        assert_eq!(without_options("-o 1 2"), "2");
    }
}
