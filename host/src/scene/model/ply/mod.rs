//! PLY, ASCII and binary in both orders.
//!
//! The header is read by `ply-rs-bw`, behind checks of its own: it is cut out first, at most 64 KiB, its line
//! ends and indents are put in order, and each element's count is held against the bytes that follow. The
//! body is read here, straight into flat arrays: the crate's ASCII numbers know neither `nan`, `inf`, `.5`
//! nor `1.`, and it makes an element of its own of each row.
//!
//! Understood: `vertex` with x y z, nx ny nz and texture coordinates (s t, u v, texture_u texture_v or
//! texture_s texture_t); `face` with the list vertex_indices or vertex_index and, for each corner, texcoord;
//! `tristrips` with the list vertex_indices, -1 between strips. Everything else is passed over.

mod body;
mod header;

use std::path::Path;

use parallax_shared::layout::NONE;
use ply_rs_bw::ply::{Encoding, Header, PropertyType};

use super::{Corner, Face, Model, Polygons};
use crate::scene::SceneError;
use crate::scene::model::lines::shown;
use crate::scene::warning::Tally;
use body::{Ascii, Binary, Body};

/// An index that no array has.
const MISSING: u32 = NONE - 1;

/// Reads the model at `path`, whose content is `bytes`.
pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Model, SceneError> {
    let wrong = |(line, message)| SceneError::Model { path: path.into(), line, message };
    let (header, body, lines) = header::header(bytes).map_err(wrong)?;
    let mut polygons = Polygons::default();
    match header.encoding {
        Encoding::Ascii => elements(&header, &mut Ascii::new(body, lines), &mut polygons),
        Encoding::BinaryLittleEndian => elements(&header, &mut Binary { body, big: false }, &mut polygons),
        Encoding::BinaryBigEndian => elements(&header, &mut Binary { body, big: true }, &mut polygons),
    }
    .map_err(wrong)?;
    Ok(Model { path: path.into(), polygons, materials: Vec::new(), tally: Tally::default() })
}

/// A line, where there are lines, and what is wrong there.
type Wrong = (Option<usize>, String);

/// What a property means.
#[derive(Clone, Copy)]
enum Role {
    /// Index into [`Row::values`].
    Value(usize),
    Indices,
    CornerUvs,
    Nothing,
}

/// One element's values: position, normal, texture coordinates; indices and texture coordinates of corners.
#[derive(Default)]
struct Row {
    values: [f32; 8],
    indices: Vec<u32>,
    corner_uvs: Vec<f32>,
}

fn role(name: &str) -> Role {
    let value = ["x", "y", "z", "nx", "ny", "nz"].iter().position(|n| *n == name);
    match name {
        "s" | "u" | "texture_u" | "texture_s" => Role::Value(6),
        "t" | "v" | "texture_v" | "texture_t" => Role::Value(7),
        "vertex_indices" | "vertex_index" => Role::Indices,
        "texcoord" => Role::CornerUvs,
        _ => value.map_or(Role::Nothing, Role::Value),
    }
}

fn elements(header: &Header, body: &mut impl Body, polygons: &mut Polygons) -> Result<(), Wrong> {
    let given = Given::by(header);
    if !given.positions {
        return Err((None, "no element `vertex` with properties x, y and z".into()));
    }
    // An element without properties takes no bytes at all, however many there are.
    for element in header.elements.values().filter(|e| !e.properties.is_empty()) {
        let properties: Vec<_> =
            element.properties.values().map(|p| (p.data_type.clone(), role(&p.name))).collect();
        let mut row = Row::default();
        for number in 0..element.count {
            read_row(&properties, body, &mut row).ok_or_else(|| {
                let (name, of) = (shown(element.name.as_bytes()), element.count);
                (body.line(), format!("element `{name}` {} of {of} is cut short or no number", number + 1))
            })?;
            match element.name.as_str() {
                "vertex" => polygons.add_vertex(&row, &given),
                "face" => polygons.add_face(&row, body.line()),
                "tristrips" => polygons.add_strips(&row),
                _ => (),
            }
        }
    }
    for corner in &mut polygons.corners {
        corner.normal = if given.normals { corner.position } else { NONE };
        if given.vertex_uvs {
            corner.uv = corner.position;
        }
    }
    Ok(())
}

/// What the header says that there is. Texture coordinates of corners take the place of those of vertices.
struct Given {
    positions: bool,
    normals: bool,
    vertex_uvs: bool,
}

impl Given {
    fn by(header: &Header) -> Self {
        let has = |element: &str, property: &str| {
            header.elements.get(element).is_some_and(|e| e.properties.contains_key(property))
        };
        let is_value = |property: &str, i: usize| matches!(role(property), Role::Value(j) if i == j);
        let vertex = header.elements.get("vertex").map(|e| &e.properties);
        let uv = [6, 7].iter().all(|i| vertex.is_some_and(|v| v.keys().any(|name| is_value(name, *i))));
        Self {
            positions: ["x", "y", "z"].iter().all(|name| has("vertex", name)),
            normals: ["nx", "ny", "nz"].iter().all(|name| has("vertex", name)),
            vertex_uvs: uv && !has("face", "texcoord"),
        }
    }
}

fn read_row(properties: &[(PropertyType, Role)], body: &mut impl Body, row: &mut Row) -> Option<()> {
    body.next_element()?;
    row.indices.clear();
    row.corner_uvs.clear();
    for (kind, role) in properties {
        match kind {
            PropertyType::Scalar(kind) => {
                let value = body.value(kind)?;
                if let Role::Value(i) = role {
                    row.values[*i] = value as f32;
                }
            }
            PropertyType::List(count, kind) => {
                // Checked item by item: nothing is set aside for a count that may be a lie.
                for _ in 0..whole(body.count(count)?)? {
                    let value = body.value(kind)?;
                    match role {
                        Role::Indices => row.indices.push(whole(value).unwrap_or(MISSING)),
                        Role::CornerUvs => row.corner_uvs.push(value as f32),
                        Role::Value(_) | Role::Nothing => (),
                    }
                }
            }
        }
    }
    Some(())
}

/// A number that is a whole one, at least zero and less than [`MISSING`].
fn whole(value: f64) -> Option<u32> {
    (value.fract() == 0.0 && (0.0..f64::from(MISSING)).contains(&value)).then_some(value as u32)
}

impl Polygons {
    fn add_vertex(&mut self, row: &Row, given: &Given) {
        let [x, y, z, nx, ny, nz, u, v] = row.values;
        self.positions.push([x, y, z]);
        if given.normals {
            self.normals.push([nx, ny, nz]);
        }
        if given.vertex_uvs {
            self.uvs.push([u, v]);
        }
    }

    fn add_face(&mut self, row: &Row, line: Option<usize>) {
        let first = self.corners.len() as u32;
        let mut uvs = row.corner_uvs.chunks_exact(2);
        for position in &row.indices {
            let mut corner = Corner { position: *position, uv: NONE, normal: NONE };
            if let Some([u, v]) = uvs.next() {
                corner.uv = self.uvs.len() as u32;
                self.uvs.push([*u, *v]);
            }
            self.corners.push(corner);
        }
        let corners = row.indices.len() as u32;
        self.faces.push(Face { first, corners, material: NONE, line: line.unwrap_or(0) as u32 });
    }

    /// Strips of triangles, each wound alike: every second one is turned.
    fn add_strips(&mut self, row: &Row) {
        for strip in row.indices.split(|i| *i == MISSING) {
            for (number, window) in strip.windows(3).enumerate() {
                let [a, b, c] = [window[number % 2], window[1 - number % 2], window[2]];
                let first = self.corners.len() as u32;
                let corner = |position| Corner { position, uv: NONE, normal: NONE };
                self.corners.extend([a, b, c].map(corner));
                self.faces.push(Face { first, corners: 3, material: NONE, line: 0 });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "element vertex 3\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\n\
                          element face 1\nproperty list uchar short vertex_index\nend_header\n";
    const POSITIONS: [[f32; 3]; 3] = [[0.0, 0.5, 1.0], [-1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];

    fn check(bytes: &[u8]) {
        let polygons = read(Path::new("a.ply"), bytes).unwrap().polygons;
        assert_eq!(polygons.positions, POSITIONS);
        assert_eq!(polygons.corners.iter().map(|c| c.position).collect::<Vec<_>>(), [0, 2, 1]);
        assert_eq!(polygons.faces.len(), 1);
    }

    fn binary(format: &str, bytes: impl Fn(&mut Vec<u8>, &[u8])) -> Vec<u8> {
        let mut file = format!("ply\nformat {format} 1.0\n{HEADER}").into_bytes();
        for [x, y, z] in POSITIONS {
            bytes(&mut file, &x.to_le_bytes());
            bytes(&mut file, &y.to_le_bytes());
            bytes(&mut file, &f64::from(z).to_le_bytes());
            file.push(255);
        }
        file.push(3);
        [0_i16, 2, 1].iter().for_each(|i| bytes(&mut file, &i.to_le_bytes()));
        file
    }

    #[test]
    fn text_and_both_orders_of_bytes_say_the_same() {
        let text =
            format!("ply\nformat ascii 1.0\n{HEADER}0 .5 1.\t255 extra\n\n-1 2 3 0\r\n4e0 5 6 0\n 3 0 2 1");
        check(text.as_bytes());
        check(text.replace('\n', "\r").as_bytes());
        check(&binary("binary_little_endian", |file, bytes| file.extend(bytes)));
        check(&binary("binary_big_endian", |file, bytes| file.extend(bytes.iter().rev())));
    }

    #[test]
    fn every_cut_is_noticed() {
        let file = binary("binary_little_endian", |file, bytes| file.extend(bytes));
        for length in 0..file.len() {
            assert!(read(Path::new("a.ply"), &file[..length]).is_err(), "{length}");
        }
    }

    #[test]
    fn a_count_is_held_against_the_file() {
        let file = |count: &str, property: &str| {
            format!(
                "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n\
                     element other {count}\n{property}end_header\n1 2\n"
            )
        };
        let read =
            |text: String| read(Path::new("a.ply"), text.as_bytes()).map(|_| ()).map_err(|e| e.to_string());
        let huge = "18446744073709551615";
        let error = read(file(huge, "property float a\nproperty list uchar int b\n")).unwrap_err();
        assert_eq!(error, format!("a.ply: {huge} elements `other` do not fit into the 4 bytes that follow"));
        assert_eq!(read(file(huge, "")), Ok(()));
        assert!(
            read(file("-1", "property float a\n")).unwrap_err().starts_with("a.ply:7: `element other -1`")
        );
    }

    #[test]
    fn strips_are_wound_alike() {
        let text = "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n\
                    element tristrips 1\nproperty list int int vertex_indices\nend_header\n8 0 1 2 3 -1 4 5 6\n";
        let polygons = read(Path::new("a.ply"), text.as_bytes()).unwrap().polygons;
        let corners: Vec<_> = polygons.corners.iter().map(|c| c.position).collect();
        assert_eq!(corners, [0, 1, 2, 2, 1, 3, 4, 5, 6]);
    }

    #[test]
    fn corners_may_have_their_own_texture_coordinates() {
        let text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
                    property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_indices\n\
                    property list uchar float texcoord\nend_header\n0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n3 0 1 2 6 0 0 1 0 0 1\n";
        let polygons = read(Path::new("a.ply"), text.as_bytes()).unwrap().polygons;
        assert_eq!(polygons.uvs, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    }
}
