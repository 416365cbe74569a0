//! Wavefront OBJ, written here because no kept-up crate can be made safe from outside (`tobj` 4.0.5 panics on
//! a colour of fewer than three numbers, knows no line continuation nor concave polygons, reads UTF-8 only
//! and gives no line numbers).
//!
//! Understood: `v` (x y z; weights and vertex colours are passed over), `vt` (u v), `vn`, `f` (any number of
//! corners, each `v`, `v/vt`, `v//vn` or `v/vt/vn`, counted from 1 or back from the last one so far),
//! `usemtl`, `mtllib`, `\` at the end of a line. Everything else (groups, smoothing groups, lines, points,
//! curves) is passed over. A face may name vertices that follow it.

use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;

use parallax_shared::layout::NONE;

use super::lines::{Lines, number, shown, words};
use super::{Corner, Face, FileMaterial, Model, Polygons, mtl};
use crate::scene::warning::Tally;
use crate::scene::{Problem, SceneError, files};

/// An index that no array has: what a face names and a file lacks.
const MISSING: u32 = NONE - 1;

/// Material libraries that one model may name.
const MAX_LIBRARIES: usize = 64;

/// Reads the model at `path`, whose content is `text`.
pub(super) fn read(path: &Path, text: &[u8]) -> Result<Model, SceneError> {
    if text.starts_with(b"\xfe\xff") || text.starts_with(b"\xff\xfe") || text.contains(&0) {
        let message = "not text in UTF-8 or another superset of ASCII (UTF-16?)".into();
        return Err(SceneError::Model { path: path.into(), line: None, message });
    }
    let mut reader = Reader { path, ..Reader::default() };
    for (line, text) in (Logical { lines: Lines::new(text), line: 0 }) {
        reader.line = line;
        reader.read(&text)?;
    }
    Ok(Model {
        path: path.into(),
        polygons: reader.polygons,
        materials: reader.materials,
        tally: reader.tally,
    })
}

/// Logical lines, each with the number of its first physical line: a `\` at the end joins the next one.
struct Logical<'a> {
    lines: Lines<'a>,
    line: usize,
}

impl<'a> Iterator for Logical<'a> {
    type Item = (usize, Cow<'a, [u8]>);

    fn next(&mut self) -> Option<Self::Item> {
        let mut text = Cow::Borrowed(self.lines.next()?);
        self.line += 1;
        let first = self.line;
        while text.last() == Some(&b'\\') {
            let joined = text.to_mut();
            joined.pop();
            joined.push(b' ');
            let Some(next) = self.lines.next() else { break };
            joined.extend_from_slice(next);
            self.line += 1;
        }
        Some((first, text))
    }
}

struct Reader<'a> {
    path: &'a Path,
    line: usize,
    polygons: Polygons,
    materials: Vec<FileMaterial>,
    by_name: HashMap<String, u32>,
    libraries: usize,
    material: u32,
    tally: Tally,
}

impl Default for Reader<'_> {
    fn default() -> Self {
        Self {
            path: Path::new(""),
            line: 0,
            polygons: Polygons::default(),
            materials: Vec::new(),
            by_name: HashMap::new(),
            libraries: 0,
            material: NONE,
            tally: Tally::default(),
        }
    }
}

impl Reader<'_> {
    fn read(&mut self, text: &[u8]) -> Result<(), SceneError> {
        let mut words = words(text);
        match words.next() {
            Some(b"v") => {
                let position = self.numbers(text, words)?;
                self.polygons.positions.push(position);
            }
            Some(b"vn") => {
                let normal = self.numbers(text, words)?;
                self.polygons.normals.push(normal);
            }
            Some(b"vt") => {
                let uv = self.numbers(text, words)?;
                self.polygons.uvs.push(uv);
            }
            Some(b"f") => self.face(words)?,
            Some(b"usemtl") => self.use_material(&rest_of(text)),
            Some(b"mtllib") => self.library(&rest_of(text)),
            _ => (),
        }
        Ok(())
    }

    fn wrong(&self, message: String) -> SceneError {
        SceneError::Model { path: self.path.into(), line: Some(self.line), message }
    }

    /// The first `N` words as numbers; a texture coordinate without its second has zero there.
    fn numbers<'w, const N: usize>(
        &self,
        text: &[u8],
        mut words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<[f32; N], SceneError> {
        let mut values = [0.0; N];
        for (i, value) in values.iter_mut().enumerate() {
            *value = match words.next() {
                None if N == 2 && i == 1 => 0.0,
                word => word
                    .and_then(number)
                    .ok_or_else(|| self.wrong(format!("expected {N} numbers, found `{}`", shown(text))))?
                    as f32,
            };
        }
        Ok(values)
    }

    fn face<'w>(&mut self, words: impl Iterator<Item = &'w [u8]>) -> Result<(), SceneError> {
        let first = self.polygons.corners.len();
        for word in words.take_while(|word| word[0] != b'#') {
            let corner = self.corner(word)?;
            self.polygons.corners.push(corner);
        }
        let corners = self.polygons.corners.len() - first;
        self.polygons.faces.push(Face {
            first: first as u32,
            corners: corners as u32,
            material: self.material,
            line: self.line as u32,
        });
        Ok(())
    }

    fn corner(&self, word: &[u8]) -> Result<Corner, SceneError> {
        let mut parts = word.split(|b| *b == b'/');
        let mut index = |count: usize| match parts.next() {
            None | Some(b"") => Ok(NONE),
            Some(part) => index(part, count).ok_or_else(|| {
                self.wrong(format!(
                    "expected a corner (v, v/vt or v/vt/vn, from 1 or below 0), found `{}`",
                    shown(word)
                ))
            }),
        };
        let position = index(self.polygons.positions.len())?;
        let uv = index(self.polygons.uvs.len())?;
        let normal = index(self.polygons.normals.len())?;
        Ok(Corner { position, uv, normal })
    }

    fn use_material(&mut self, name: &str) {
        self.material = match self.by_name.get(name) {
            Some(number) => *number,
            None => {
                self.tally.add(Problem::MaterialMissing(shown(name.as_bytes())), Some(self.line));
                NONE
            }
        };
    }

    /// Reads the materials of a library, or of several when its name is no file and its words are.
    fn library(&mut self, names: &str) {
        let directory = self.path.parent().unwrap_or(Path::new(""));
        let whole = files::beside(directory, names).filter(|path| path.is_file());
        let listed: Vec<&str> = match whole {
            Some(_) => vec![names],
            None => names.split_ascii_whitespace().collect(),
        };
        for name in listed {
            self.libraries += 1;
            if self.libraries > MAX_LIBRARIES {
                break;
            }
            if let Err(reason) = self.add_library(directory, name) {
                self.tally.add(Problem::FileMissing(reason), Some(self.line));
            }
        }
    }

    fn add_library(&mut self, directory: &Path, name: &str) -> Result<(), String> {
        let path = files::beside(directory, name)
            .ok_or_else(|| format!("`{}` lies outside the model's directory", shown(name.as_bytes())))?;
        for material in mtl::read(&path).map_err(|e| e.to_string())? {
            self.by_name.insert(material.name.clone(), self.materials.len() as u32);
            self.materials.push(material);
        }
        Ok(())
    }
}

/// What follows the first word: a name may have blanks in it.
pub(super) fn rest_of(text: &[u8]) -> String {
    let text = String::from_utf8_lossy(text);
    text.trim().split_once(char::is_whitespace).map_or(String::new(), |(_, rest)| rest.trim().to_string())
}

/// An index of OBJ, from 1 or back from the end, as one from 0; [`MISSING`] when there is no such element;
/// `None` when it is not a whole number.
fn index(text: &[u8], count: usize) -> Option<u32> {
    let digits = text.strip_prefix(b"-").or(text.strip_prefix(b"+")).unwrap_or(text);
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    // What overflows names no element either.
    let value: i64 = std::str::from_utf8(text).ok()?.parse().unwrap_or(0);
    let from_zero = if value < 0 { value + count as i64 } else { value - 1 };
    Some(u32::try_from(from_zero).unwrap_or(MISSING).min(MISSING))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model(text: &str) -> Model {
        read(Path::new("a.obj"), text.as_bytes()).unwrap()
    }

    #[test]
    fn indices_count_from_one_or_from_the_end() {
        assert_eq!(index(b"1", 5), Some(0));
        assert_eq!(index(b"-1", 5), Some(4));
        assert_eq!(index(b"7", 5), Some(6));
        for missing in [&b"0"[..], b"-6", b"99999999999999999999", b"-99999999999999999999", b"4294967296"] {
            assert_eq!(index(missing, 5), Some(MISSING));
        }
        for wrong in [&b""[..], b"-", b"a", b"1.5", b"--1", b"0x1"] {
            assert_eq!(index(wrong, 5), None);
        }
    }

    #[test]
    fn lines_are_joined_and_counted() {
        let model = model("v 0 0 0\\\n\n  v 1 0 0\nv 0 1 \\\r\n0\nf 1 \\\n 2 3 # 4 5\n");
        assert_eq!(model.polygons.positions, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!((model.polygons.faces[0].corners, model.polygons.faces[0].line), (3, 6));
    }

    #[test]
    fn corners_with_and_without_attributes() {
        let model = model("v 0 0 0\nvt .5 1.\nvn 0 0 1\nf 1 1/1 1//1 1/1/1 -1/-1/-1 1/ 1//\n");
        let attributes: Vec<_> = model.polygons.corners.iter().map(|c| (c.uv, c.normal)).collect();
        let none = (NONE, NONE);
        assert_eq!(attributes, [none, (0, NONE), (NONE, 0), (0, 0), (0, 0), none, none]);
        assert_eq!(model.polygons.uvs, [[0.5, 1.0]]);
    }

    #[test]
    fn errors_say_the_line() {
        let error = read(Path::new("a.obj"), b"v 0 0 0\nv 1 x 0\n").err().unwrap().to_string();
        assert_eq!(error, "a.obj:2: expected 3 numbers, found `v 1 x 0`");
        let error = read(Path::new("a.obj"), b"\n\nf 1/a 2 3").err().unwrap().to_string();
        assert_eq!(error, "a.obj:3: expected a corner (v, v/vt or v/vt/vn, from 1 or below 0), found `1/a`");
    }
}
