//! Every scene that ships with all its models against what it looked like when somebody last looked at it and
//! found it good.
//!
//! `golden/hashes.json` has the SHA-256 of every stage's bits (strict profile, so they are the same on every
//! machine), `golden/NAME.png` both views to look at. When a change is meant to change pictures, look at the
//! new ones and bless them: `PARALLAX_BLESS=1 cargo test -p parallax-tests --test golden`.

use parallax::backend::Cpu;
use parallax::render::band::{Band, EYES};
use parallax::render::{Method, Renderer, SceneData, render};
use parallax_tests::scenes;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Small, and no multiple of a workgroup's 8 × 8.
const SIZE: [u32; 2] = [150, 100];

/// Scene, then view and stage, then hash.
type Hashes = BTreeMap<String, BTreeMap<String, String>>;

fn folder() -> PathBuf {
    scenes::root().join("tests/golden")
}

fn hash<T: bytemuck::NoUninit>(values: &[T]) -> String {
    let digest = Sha256::digest(bytemuck::cast_slice::<T, u8>(values));
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn hashes_of(data: &SceneData) -> BTreeMap<String, String> {
    let mut cpu = Cpu::new(0).unwrap();
    let mut renderer = Renderer::new(&mut cpu, data).unwrap();
    let whole = Band { first_row: 0, rows: SIZE[1] };
    let mut hashes = BTreeMap::new();
    for (eye, view) in EYES.iter().enumerate() {
        let values = renderer.band(eye, whole).unwrap();
        let rays: Vec<_> = values.rays().flatten().copied().collect();
        let stages = [
            ("hits", hash(&values.hits)),
            ("surfaces", hash(&values.surfaces)),
            ("shadow", hash(&values.shadow)),
            ("colour", hash(values.colour())),
            ("rays", hash(&rays)),
        ];
        hashes.extend(stages.map(|(stage, hash)| (format!("{view} {stage}"), hash)));
    }
    hashes
}

/// Writes what the scene looks like now and returns how many pixels differ from the golden picture, if there
/// is one.
fn picture(data: &SceneData, name: &str, path: &Path) -> Option<usize> {
    let frame = render(&mut Cpu::new(0).unwrap(), data, &Method::Naive.into(), &mut |_, _| {}).unwrap();
    let golden = image::open(path).ok().map(|image| image.to_rgb8());
    let written = tempfile::tempdir().unwrap();
    let format = parallax::output::Format::SideBySide;
    let files = parallax::output::write(&frame.images, written.path(), name, format, false).unwrap();
    let now = image::open(&files[0]).unwrap().to_rgb8();
    if std::env::var_os("PARALLAX_BLESS").is_some() {
        std::fs::create_dir_all(folder()).unwrap();
        std::fs::copy(&files[0], path).unwrap();
    }
    let golden = golden.filter(|golden| golden.dimensions() == now.dimensions())?;
    Some(golden.pixels().zip(now.pixels()).filter(|(a, b)| a != b).count())
}

#[test]
fn shipped_scenes_look_as_they_did() {
    let path = folder().join("hashes.json");
    let golden = std::fs::read(&path).unwrap_or_default();
    let golden: Hashes = serde_json::from_slice(&golden).unwrap_or_default();
    let mut now = golden.clone();
    let mut wrong = Vec::new();
    for scene in scenes::shipped().into_iter().filter(|scene| !scenes::wants_models(scene)) {
        let name = scenes::name(&scene);
        let Some(data) = scenes::data_at(&scene, SIZE) else { continue };
        let hashes = hashes_of(&data);
        let changed = golden.get(name) != Some(&hashes);
        let pixels = changed.then(|| picture(&data, name, &folder().join(format!("{name}.png"))));
        if let Some(pixels) = pixels {
            let known = golden.get(name).cloned().unwrap_or_default();
            let stages: Vec<_> =
                hashes.keys().filter(|stage| known.get(*stage) != hashes.get(*stage)).collect();
            wrong.push(format!("{name}: {stages:?} changed, pixels that look different: {pixels:?}"));
        }
        now.insert(name.to_owned(), hashes);
    }
    if std::env::var_os("PARALLAX_BLESS").is_some() {
        std::fs::write(&path, serde_json::to_string_pretty(&now).unwrap() + "\n").unwrap();
        println!("blessed: {wrong:#?}");
    } else {
        assert!(wrong.is_empty(), "look at the pictures, then bless them (see this file's head): {wrong:#?}");
    }
}

#[test]
fn a_hash_tells_bits_apart() {
    assert_ne!(hash(&[0.0_f32, 1.0]), hash(&[-0.0_f32, 1.0]));
    assert_ne!(hash(&[1.0_f32, 2.0]), hash(&[2.0_f32, 1.0]));
}
