//! Hostile and odd model files: each loads or is refused as it should, within two seconds and a gigabyte, and
//! never panics.

use std::alloc::{GlobalAlloc, Layout, System};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::{Duration, Instant};

use parallax::scene::{self, Picture, SceneError};
use parallax_tests::models;
use proptest::prelude::*;

/// Counts what is allocated.
struct Counting;

static LIVE: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call goes to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let live = LIVE.fetch_add(layout.size(), Relaxed) + layout.size();
        PEAK.fetch_max(live, Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        LIVE.fetch_sub(layout.size(), Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// One at a time: the peak is the process's.
static MEASURED: Mutex<()> = Mutex::new(());

enum Expected {
    /// Loads with so many triangles.
    Loads(usize),
    /// Loads as a picture of this size.
    Picture(u32, u32),
    /// Is refused with a message that holds this.
    Refused(&'static str),
}

use Expected::{Loads, Refused};

/// Every OBJ, PLY and HDR file of `malformed` and `hard_meshes`, and what a loader should do with it.
#[rustfmt::skip]
const FILES: &[(&str, Expected)] = &[
    ("malformed/assimp_malformed2.obj", Loads(10)),
    ("malformed/box_UTF16BE.obj", Refused("not text in UTF-8")),
    ("malformed/draco_delim_test.ply", Loads(12)),
    ("malformed/draco_eof_test.obj", Loads(1)),
    ("malformed/draco_inf_nan.obj", Loads(0)),
    ("malformed/empty.obj", Loads(0)),
    ("malformed/made_bad_format.ply", Refused(":2: `format binary_middle_endian 1.0` is no line of a PLY header")),
    ("malformed/made_big_endian_valid.ply", Loads(200)),
    ("malformed/made_huge_size.hdr", Refused("2000000000×2000000000 texels")),
    ("malformed/made_index_huge.obj", Loads(992)),
    ("malformed/made_index_negative_out_of_range.obj", Loads(992)),
    ("malformed/made_index_out_of_range.ply", Loads(199)),
    ("malformed/made_index_zero.obj", Loads(992)),
    ("malformed/made_list_of_0_1_2.ply", Loads(1)),
    ("malformed/made_list_of_255.ply", Refused("element `face` 1 of 1 is cut short")),
    ("malformed/made_mtllib_missing.obj", Loads(992)),
    ("malformed/made_mtllib_traversal.obj", Loads(992)),
    ("malformed/made_nan.obj", Loads(990)),
    ("malformed/made_nan_inf_vertices_binary.ply", Loads(198)),
    ("malformed/made_negative_count.ply", Refused(":3: `element vertex -602` is no line of a PLY header")),
    ("malformed/made_no_end_header.ply", Refused("no line `end_header`")),
    ("malformed/made_truncated.hdr", Refused("malformed/made_truncated.hdr: ")),
    ("malformed/made_truncated.obj", Loads(172)),
    ("malformed/made_truncated_ascii.ply", Refused(":715: element `face` 104 of 200 is cut short")),
    ("malformed/made_truncated_vertices_ascii.ply", Refused(":312: element `vertex` 303 of 602 is cut short")),
    ("malformed/regr_3429812.obj", Loads(4)),
    ("malformed/trimesh_empty.ply", Loads(0)),
    ("malformed/trimesh_face_in_group_name.obj", Loads(0)),
    ("malformed/trimesh_nancolor.obj", Loads(12)),
    ("malformed/trimesh_obj_points.obj", Loads(0)),
    ("malformed/trimesh_ply_empty_bin.ply", Loads(0)),
    ("malformed/trimesh_ply_empty_header.ply", Refused("no element `vertex`")),
    ("hard_meshes/box_longline.obj", Loads(944)),
    ("hard_meshes/box_without_lineending.obj", Loads(12)),
    ("hard_meshes/bunny.ply", Loads(16301)),
    ("hard_meshes/capsule.obj", Loads(10200)),
    ("hard_meshes/concave_polygon.obj", Loads(64)),
    ("hard_meshes/cube.OBJ", Loads(12)),
    ("hard_meshes/cube_att.obj", Loads(12)),
    ("hard_meshes/cube_binary_header_with_RN_newline.ply", Loads(12)),
    ("hard_meshes/cube_binary_starts_with_nl.ply", Loads(12)),
    ("hard_meshes/cube_quads.ply", Loads(12)),
    ("hard_meshes/cube_with_vertexcolors.obj", Loads(12)),
    ("hard_meshes/deg_faces.obj", Loads(4)),
    ("hard_meshes/degenerate_mesh.obj", Loads(1)),
    ("hard_meshes/empty_name.obj", Loads(1)),
    ("hard_meshes/extra_vertex.obj", Loads(3)),
    ("hard_meshes/float-color.ply", Loads(1)),
    ("hard_meshes/float_inf_point_cloud.ply", Loads(0)),
    ("hard_meshes/groups.obj", Loads(2308)),
    ("hard_meshes/int_point_cloud.ply", Loads(0)),
    ("hard_meshes/issue623.ply", Loads(0)),
    ("hard_meshes/joined_tetrahedra.obj", Loads(8)),
    ("hard_meshes/mat_test.obj", Loads(1300)),
    ("hard_meshes/multi.ply", Loads(2)),
    ("hard_meshes/multiple_isolated_triangles.obj", Loads(5)),
    ("hard_meshes/multiple_spaces.obj", Loads(1)),
    ("hard_meshes/negative_indices.obj", Loads(12)),
    ("hard_meshes/non_manifold_wrap.obj", Loads(12)),
    ("hard_meshes/not_convex.obj", Loads(96)),
    ("hard_meshes/octagon.obj", Loads(6)),
    ("hard_meshes/octagonal_pocket.ply", Loads(3262)),
    ("hard_meshes/point_cloud.obj", Loads(0)),
    ("hard_meshes/points_ascii_with_lists.ply", Loads(0)),
    ("hard_meshes/points_emptyface.ply", Loads(0)),
    ("hard_meshes/polygonfaces.obj", Loads(3)),
    ("hard_meshes/reference.ply", Loads(1610)),
    ("hard_meshes/spider.obj", Loads(1368)),
    ("hard_meshes/suzanne.ply", Loads(968)),
    ("hard_meshes/test_extra_whitespace.ply", Loads(1)),
    ("hard_meshes/test_more_datatypes.ply", Loads(1)),
    ("hard_meshes/test_pos_color.ply", Loads(224)),
    ("hard_meshes/testmixed.obj", Loads(12)),
    ("hard_meshes/triangle_with_degenerate_tex_coords.obj", Loads(1)),
    ("hard_meshes/two_objects.obj", Loads(16)),
    ("hard_meshes/wallhole.obj", Loads(66)),
    ("envmap/kiara_1_dawn_1k.hdr", Expected::Picture(1024, 512)),
];

/// What came of a file.
fn outcome(path: &Path) -> Result<Expected, SceneError> {
    if path.extension().is_some_and(|s| s == "hdr") {
        return Picture::load(path).map(|p| Expected::Picture(p.width, p.height));
    }
    let scene = scene::load(path)?;
    assert_eq!(models::flaws(&scene), [""; 0], "{}", path.display());
    Ok(Loads(scene.triangles.len()))
}

fn check(path: &Path, expected: &Expected) {
    match (outcome(path), expected) {
        (Ok(Loads(found)), Loads(expected)) => assert_eq!(found, *expected, "{}", path.display()),
        (Ok(Expected::Picture(w, h)), Expected::Picture(width, height)) => {
            assert_eq!((w, h), (*width, *height))
        }
        (Err(error), Refused(part)) => assert!(error.to_string().contains(part), "{error}"),
        (Err(error), _) => panic!("{error}"),
        (Ok(_), _) => panic!("{}: loaded", path.display()),
    }
}

/// All files below a directory.
fn files(directory: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

#[test]
fn every_file_loads_or_is_refused_in_time_and_memory() {
    let Some(models) = models::models() else { return };
    let _alone = MEASURED.lock().unwrap();
    for (name, expected) in FILES {
        PEAK.store(LIVE.load(Relaxed), Relaxed);
        let (before, start) = (LIVE.load(Relaxed), Instant::now());
        check(&models.join(name), expected);
        let (time, memory) = (start.elapsed(), PEAK.load(Relaxed).saturating_sub(before));
        assert!(time < Duration::from_secs(2), "{name}: {time:?}");
        assert!(memory < 1 << 30, "{name}: {memory} bytes");
    }
}

#[test]
fn the_table_names_every_file_and_other_formats_are_refused() {
    let Some(models) = models::models() else { return };
    for folder in ["malformed", "hard_meshes"] {
        for path in files(&models.join(folder)) {
            let name = path.strip_prefix(&models).unwrap().to_str().unwrap();
            match path.extension().unwrap().to_str().unwrap().to_lowercase().as_str() {
                "obj" | "ply" | "hdr" => assert!(FILES.iter().any(|(known, _)| *known == name), "{name}"),
                _ => {
                    let error = scene::load(&path).unwrap_err();
                    assert!(matches!(error, SceneError::UnknownFormat { .. }), "{name}");
                    assert!(
                        error.to_string().ends_with("unknown format, supported: .toml, .obj, .ply"),
                        "{error}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_counting_allocator_counts() {
    let _alone = MEASURED.lock().unwrap();
    let before = LIVE.load(Relaxed);
    let block = std::hint::black_box(vec![0_u8; 1 << 26]);
    // Tests that measure nothing run at the same time and may give a little back.
    let counted = before + block.len() / 2;
    assert!(LIVE.load(Relaxed) >= counted);
    assert!(PEAK.load(Relaxed) >= counted);
}

#[test]
fn large_models_load_whole() {
    let Some(models) = models::models() else { return };
    let _alone = MEASURED.lock().unwrap();
    for (name, triangles) in [
        ("stanford_dragon/dragon_vrip.ply", 871_414),
        ("stanford_buddha/happy_buddha_113k.obj", 112_876),
        ("stanford_bunny/bun_zipper.ply", 69_451),
        ("dabrovic_sponza/sponza.obj", 66_454),
    ] {
        check(&models.join(name), &Loads(triangles));
    }
}

/// A file of nothing but a claim: tiny, and what it claims would fill any memory.
#[test]
fn claims_are_not_believed() {
    let directory = tempfile::tempdir().unwrap();
    let _alone = MEASURED.lock().unwrap();
    let vertex = "property float x\nproperty float y\nproperty float z\n";
    let face = "element face 1\nproperty list uint int vertex_indices\nend_header\n";
    let mut list =
        format!("ply\nformat binary_little_endian 1.0\nelement vertex 0\n{vertex}{face}").into_bytes();
    list.extend(u32::MAX.to_le_bytes());
    let many_vertices =
        format!("ply\nformat ascii 1.0\nelement vertex 4000000000\n{vertex}end_header\n0 0 0\n");
    let picture = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 5000 +X 6000\n";
    for (name, bytes) in [
        ("list.ply", &list[..]),
        ("vertices.ply", many_vertices.as_bytes()),
        ("picture.hdr", picture.as_bytes()),
        (
            "generated.toml",
            b"camera = { eye = [0,0,1], target = [0,0,0] }\n[[object]]\nsphereflake.size_factor = 9",
        ),
    ] {
        let path = directory.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        PEAK.store(LIVE.load(Relaxed), Relaxed);
        let before = LIVE.load(Relaxed);
        assert!(outcome(&path).is_err(), "{name}");
        let memory = PEAK.load(Relaxed).saturating_sub(before);
        assert!(memory < 1 << 29, "{name}: {memory} bytes");
    }
}

/// Small valid files of every kind, which the test below damages.
fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 1 0 0\nv 0 1 0\nv .2 .2 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nusemtl a\n\
               f 1/1/1 2/2/1 3//1 4\nf -5 -4 -3 \\\n-2 -1\nf 1 2 3\n";
    let header = "element vertex 3\nproperty float x\nproperty float y\nproperty double z\nproperty float nx\n\
                  property float ny\nproperty float nz\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    let ascii =
        format!("ply\nformat ascii 1.0\n{header}0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n4 0 1 2 0\n");
    let mut binary = format!("ply\nformat binary_big_endian 1.0\n{header}").into_bytes();
    for i in 0..3_u8 {
        binary.extend([i; 12 + 4]);
        binary.extend(1_f32.to_be_bytes().repeat(3));
    }
    for list in [&[0, 1, 2][..], &[2, 1, 0, 1]] {
        binary.push(list.len() as u8);
        list.iter().for_each(|i: &i32| binary.extend(i.to_be_bytes()));
    }
    let toml = "max_depth = 3\n[camera]\neye = [0.0, 1, 5]\ntarget = [0, 0, 0]\n[[light]]\nposition = [1, 2, 3]\n\
                [material.a]\ncolour = [0.5, 0.5, 0.5]\n[[object]]\nmaterial = \"a\"\nsphere = { centre = [0, 0, 0], radius = 1 }\n\
                [[object]]\nrandom_ellipsoids = { count = 7, seed = 3 }\n[[object]]\nlattice = { size_factor = 2 }\n";
    let mut hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n".to_vec();
    (0..2).for_each(|_| hdr.extend([2, 2, 0, 9, 137, 5, 9, 1, 2, 3, 4, 5, 6, 7, 8, 9, 137, 7, 137, 128]));
    let mut png = std::io::Cursor::new(Vec::new());
    image::RgbImage::from_pixel(3, 2, image::Rgb([9, 99, 199]))
        .write_to(&mut png, image::ImageFormat::Png)
        .unwrap();
    vec![
        ("a.obj", obj.into()),
        ("a.ply", ascii.into()),
        ("b.ply", binary),
        ("a.toml", toml.into()),
        ("a.hdr", hdr),
        ("a.png", png.into_inner()),
    ]
}

/// Loads a file as what its suffix says, and its content as it may be.
fn survives(path: &Path) {
    match path.extension().and_then(|s| s.to_str()) {
        Some("hdr" | "png") => drop(Picture::load(path)),
        _ => {
            if let Ok(scene) = scene::load(path) {
                assert_eq!(models::flaws(&scene), [""; 0]);
            }
        }
    }
}

#[test]
fn the_seeds_are_valid() {
    let directory = tempfile::tempdir().unwrap();
    for (name, bytes) in seeds() {
        let path = directory.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        if name.ends_with("hdr") || name.ends_with("png") {
            Picture::load(&path).unwrap();
        } else {
            scene::load(&path).unwrap();
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    /// Bytes replaced, parts cut out or doubled: whatever comes of it, no panic, and nothing unusable gets
    /// through.
    #[test]
    fn damaged_files_do_no_harm(
        seed in 0..6_usize,
        bytes in prop::collection::vec((any::<prop::sample::Index>(), damage()), 1..6),
        cut in prop::option::of((any::<prop::sample::Index>(), 0..20_usize)),
        length in prop::option::weighted(0.2, any::<prop::sample::Index>()),
    ) {
        let (name, mut file) = seeds().swap_remove(seed);
        for (at, byte) in bytes {
            let at = at.index(file.len());
            file[at] = byte;
        }
        if let Some((from, count)) = cut {
            let from = from.index(file.len());
            let to = (from + count).min(file.len());
            let part: Vec<u8> = file.drain(from..to).collect();
            if count % 2 == 0 {
                file.splice(0..0, part);
            }
        }
        if let Some(length) = length {
            file.truncate(length.index(file.len() + 1));
        }
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join(name);
        std::fs::write(&path, file).unwrap();
        survives(&path);
    }
}

/// A byte, often one that means something in a text.
fn damage() -> impl Strategy<Value = u8> {
    prop_oneof![any::<u8>(), prop::sample::select(b"0123456789-+.eE \n\r\t/\\#[]{}=\",".to_vec())]
}
