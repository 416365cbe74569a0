//! Scene files: the shipped ones load, and what is wrong in one is told by line, column and expectation.

use std::path::{Path, PathBuf};

use parallax::rig::DISPLAY_WIDTH;
use parallax::scene::generate::MAX_PRIMITIVES;
use parallax::scene::{self, Scene, SceneError, Sky};
use parallax_tests::models;

const CAMERA: &str = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";

fn parse(text: &str) -> Result<Scene, SceneError> {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("test.toml");
    std::fs::write(&path, text).unwrap();
    scene::load(&path)
}

fn with_camera(text: &str) -> Result<Scene, SceneError> {
    parse(&format!("{CAMERA}{text}"))
}

/// The message of a scene file's error, without the directory.
fn message(text: &str) -> String {
    let message = parse(text).unwrap_err().to_string();
    message[message.find("test.toml").unwrap()..].to_string()
}

fn shipped() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(models::scenes()).unwrap().map(|e| e.unwrap().path());
    let mut scenes: Vec<_> = entries.filter(|path| path.extension().is_some_and(|s| s == "toml")).collect();
    scenes.sort();
    scenes
}

#[test]
fn every_shipped_scene_loads() {
    let models_are_there = models::models().is_some();
    let mut loaded = 0;
    for path in shipped() {
        let needs_models = std::fs::read_to_string(&path).unwrap().contains("$PARALLAX_MODELS");
        if needs_models && !models_are_there {
            println!("SKIPPED: {}", path.display());
            continue;
        }
        let scene = scene::load(&path).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(models::flaws(&scene), [""; 0], "{}", path.display());
        assert!(!scene.lights.is_empty() && scene.lights.len() <= 32, "{}", path.display());
        assert!(scene.triangles.len() + scene.spheres.len() + scene.ellipsoids.len() > 0);
        assert!(scene.rig.views(1.0).is_ok(), "{}", path.display());
        assert_eq!(scene.rig.guide_warning(DISPLAY_WIDTH), None, "{}", path.display());
        // Only Sponza has an oddity: a triangle of zero area and normals of zero length; the dragon has more
        // of the first kind.
        let odd = ["sponza", "dragon"].contains(&scene.name.as_str());
        assert!(odd || scene.warnings.is_empty(), "{:?}", scene.warnings);
        loaded += 1;
    }
    assert!(loaded >= 14, "{loaded}");
}

#[test]
fn the_shipped_scenes_hold_what_they_say() {
    let load = |name: &str| scene::load(&models::scenes().join(name)).unwrap();
    let counts = |scene: &Scene| [scene.triangles.len(), scene.spheres.len(), scene.ellipsoids.len()];
    assert_eq!(counts(&load("default.toml")), [5858, 2, 1]);
    assert_eq!(counts(&load("spheres.toml")), [0, 1000, 0]);
    assert_eq!(counts(&load("spheres_turned.toml")), [0, 1000, 0]);
    for (count, round) in [(20, 8), (100, 40), (125, 50), (1000, 400)] {
        assert_eq!(counts(&load(&format!("ellipsoids_{count}.toml"))), [2, round, count - round]);
    }
    assert_eq!(counts(&load("sphereflake.toml")), [2, 7381, 0]);
    assert_eq!(counts(&load("tree.toml")), [511 * 32 + 2, 511, 0]);
    assert_eq!(counts(&load("jacks.toml")), [219 * 32, 438, 0]);
    assert_eq!(counts(&load("lattice.toml")), [540 * 24, 216, 0]);
    assert_eq!(counts(&load("cornell.toml")), [36, 0, 0]);
    assert_eq!(load("cornell.toml").materials.len(), 9, "the default and eight of its own");
    let default = load("default.toml");
    assert!(
        default.materials.iter().any(|m| m.transmission > 0.0)
            && default.materials.iter().any(|m| m.reflection > 0.5)
    );
    assert!(default.materials.iter().any(|m| m.checker_scale > 0.0) && default.textures.len() == 1);
}

#[test]
fn what_is_left_out_has_a_default() {
    let scene = with_camera("[[object]]\nsphere = { centre = [1, 2, 3], radius = 4 }\n").unwrap();
    assert_eq!(scene.name, "test");
    assert_eq!((scene.max_depth, scene.ambient), (5, [0.15; 3]));
    assert!(matches!(scene.sky, Sky::Gradient { .. }));
    let rig = &scene.rig;
    assert_eq!((rig.width, rig.height, rig.interaxial_px, rig.zero_parallax), (800, 600, 20.0, 5.0));
    assert_eq!((rig.up, rig.vertical_fov_deg), ([0.0, 1.0, 0.0], 40.0));
    assert_eq!(scene.spheres[0].material, 0);
    let plain = scene.materials[0];
    assert_eq!((plain.colour, plain.diffuse, plain.eta, plain.texture), ([0.8; 3], 0.9, 1.5, u32::MAX));
}

#[test]
fn what_is_said_is_kept() {
    let scene = with_camera(
        "width = 640\nheight = 480\ninteraxial_px = 12.5\nzero_parallax = 3\nup = [0, 0.5, 0.1]\n\
         [sky]\nzenith = [0, 0, 1]\nhorizon = [1, 1, 1]\n[[light]]\nposition = [1, 2, 3]\ncolour = [2, 2, 2]\n\
         [material.a]\ncolour = [1, 0, 0]\nchecker = { colour = [0, 1, 0], scale = 2 }\neta = 1.1\nreflection = 0.25\n\
         [[object]]\nmaterial = \"a\"\ntriangle.vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n\
         [[object]]\nellipsoid = { centre = [0, 0, 0], radii = [1, 2, 4], rotate = [0, 0, 90] }\n\
         [[object]]\nmaterial = \"a\"\nsphereflake = { size_factor = 1, floor = false }\n",
    )
    .unwrap();
    assert_eq!((scene.rig.width, scene.rig.interaxial_px, scene.rig.zero_parallax), (640, 12.5, 3.0));
    assert_eq!(scene.sky, Sky::Gradient { zenith: [0.0, 0.0, 1.0], horizon: [1.0; 3] });
    assert_eq!((scene.lights[0].position, scene.lights[0].colour), ([1.0, 2.0, 3.0], [2.0; 3]));
    let a = scene.materials[1];
    assert_eq!((a.checker_colour, a.checker_scale, a.eta, a.reflection), ([0.0, 1.0, 0.0], 2.0, 1.1, 0.25));
    assert_eq!(scene.triangles[0].material, 1);
    assert_eq!(scene.spheres.len(), 10);
    assert!(
        scene.spheres.iter().all(|s| s.material == 1),
        "a named material takes the place of the generator's"
    );
    let half_extents = scene.ellipsoids[0].world_to_unit.map(|row| row[3]);
    assert!(half_extents.iter().zip([2.0, 1.0, 4.0]).all(|(a, b)| (a - b).abs() < 1e-5), "{half_extents:?}");
}

#[test]
fn an_unknown_key_is_an_error_in_its_place() {
    let text = format!("{CAMERA}\n[[light]]\nposition = [0, 0, 0]\ncolor = [1, 1, 1]\n");
    assert_eq!(message(&text), "test.toml:7:1: unknown field `color`, expected `position` or `colour`");
    let text = format!("{CAMERA}[[object]]\nsphere = {{ centre = [0, 0, 0], radius = 1, colour = 3 }}\n");
    assert!(
        message(&text).starts_with("test.toml:5:44: unknown field `colour`, expected `centre` or `radius`")
    );
    let text = format!("{CAMERA}[[object]]\ntree = {{ depth = 3 }}\n");
    assert!(
        message(&text).contains("unknown field `depth`, expected one of `size_factor`, `segments`, `floor`")
    );
}

#[test]
fn a_wrong_type_is_an_error_in_its_place() {
    let text = "[camera]\neye = [0, 0]\ntarget = [0, 0, 0]\n";
    assert_eq!(message(text), "test.toml:2:7: invalid length 2, expected an array of length 3");
    let text = format!("{CAMERA}vertical_fov_deg = \"wide\"\n");
    assert_eq!(message(&text), "test.toml:4:20: invalid type: string \"wide\", expected f32");
    assert_eq!(message("[camera]\neye = [0, 0, 1]\n"), "test.toml:1:1: missing field `target`");
    assert!(message("[camera\n").starts_with("test.toml:1:8: "));
    assert!(
        message(&format!("max_depth = 1\nmax_depth = 2\n{CAMERA}"))
            .starts_with("test.toml:2:1: duplicate key")
    );
}

#[test]
fn a_value_out_of_range_is_an_error_in_its_place() {
    for (text, expected) in [
        ("width = 0\n", "4:9: expected a number of pixels between 1 and 16384, found 0"),
        ("vertical_fov_deg = 180.0\n", "4:20: expected an angle between 1 and 170 degrees, found 180.0"),
        ("interaxial_px = nan\n", "4:17: expected a number of pixels between 0 and 10000, found NaN"),
        ("up = [inf, 0, 0]\n", "4:6: expected three numbers between -1e12 and 1e12, found [inf, 0.0, 0.0]"),
        ("[material.a]\neta = 0\n", "5:7: expected an index of refraction between 0.1 and 10, found 0.0"),
        ("[material.a]\ncolour = [1, 2, 0]\n", "5:10: expected a colour: three numbers between 0 and 1"),
        ("[[object]]\nsphere = { centre = [0, 0, 0], radius = -1 }\n", "5:41: expected a length between"),
        ("[[object]]\nrandom_spheres.count = -1\n", "5:24: invalid value: integer `-1`, expected u32"),
        ("[[object]]\nrandom_spheres.radius = [2, 1]\n", "5:25: expected two lengths between"),
    ] {
        let message = message(&format!("{CAMERA}{text}"));
        assert!(message.starts_with(&format!("test.toml:{expected}")), "{message}");
    }
    assert!(
        message(&format!("max_depth = 17\n{CAMERA}"))
            .starts_with("test.toml:1:13: expected a depth between 0 and 16")
    );
}

#[test]
fn what_does_not_fit_together_is_an_error_in_its_place() {
    let eye_at_target = "[camera]\neye = [1, 1, 1]\ntarget = [1, 1, 1]\n";
    assert_eq!(message(eye_at_target), "test.toml:1:1: expected `target` at another place than `eye`");
    let along = format!("{CAMERA}up = [0, 0, 2]\n");
    assert_eq!(message(&along), "test.toml:1:1: expected an `up` that is not along the line of sight");
    for (text, expected) in [
        ("[sky]\nzenith = [0, 0, 0]\n", "4:1: expected either `zenith` and `horizon`, or `map`"),
        ("[[object]]\n", "4:1: expected exactly one of `sphere`"),
        ("[[object]]\ntree = {}\njacks = {}\n", "4:1: expected exactly one of `sphere`"),
        (
            "[[object]]\nmaterial = \"x\"\ntree = {}\n",
            "5:12: expected one of the materials (there is none), found `x`",
        ),
        (
            "[material.a]\n[[object]]\nmaterial = \"x\"\ntree = {}\n",
            "6:12: expected one of the materials `a`, found `x`",
        ),
        ("[[object]]\nmodel.file = \"../a.obj\"\n", "5:14: expected a file in the scene's own directory or"),
        ("[[object]]\nmodel.file = \"/a.obj\"\n", "5:14: expected a file in the scene's own directory or"),
        ("[material.a]\ntexture = \"none.png\"\n", "5:11: "),
    ] {
        let message = message(&format!("{CAMERA}{text}"));
        assert!(message.starts_with(&format!("test.toml:{expected}")), "{message}");
    }
}

#[test]
fn generators_are_bounded_one_by_one_and_together() {
    for hostile in [
        "sphereflake.size_factor = 4000000000",
        "random_spheres.count = 4294967295",
        "random_ellipsoids.count = 4194305",
        "tree = { size_factor = 20, segments = 1024 }",
        "jacks.size_factor = 9",
        "lattice.size_factor = 4000000000",
        "icosphere = { centre = [0, 0, 0], radius = 1, subdivisions = 4000000000 }",
    ] {
        let error = with_camera(&format!("[[object]]\n{hostile}\n")).unwrap_err().to_string();
        assert!(
            error.contains(&format!(":4:1: expected at most {MAX_PRIMITIVES} generated primitives")),
            "{error}"
        );
    }
    let many = "[[object]]\nrandom_spheres.count = 3000000\n".repeat(2);
    assert!(with_camera(&many).unwrap_err().to_string().contains(":6:1: expected at most"));
}

#[test]
fn a_missing_model_says_where_it_was_looked_for() {
    let error =
        with_camera("[[object]]\nmodel.file = \"$PARALLAX_MODELS/no/such.ply\"\n").unwrap_err().to_string();
    assert!(error.contains(":5:14: the model `no/such.ply` is not in "), "{error}");
    assert!(error.contains("set PARALLAX_MODELS"), "{error}");
    let error = with_camera("[[object]]\nmodel.file = \"none.ply\"\n").unwrap_err().to_string();
    assert!(error.contains("none.ply: "), "{error}");
    assert!(matches!(scene::load(Path::new("none.toml")), Err(SceneError::Unreadable { .. })));
    assert!(matches!(scene::load(Path::new("none")), Err(SceneError::UnknownFormat { .. })));
}

#[test]
fn a_bare_model_is_framed_and_lit() {
    let scene = scene::load(&models::scenes().join("models/teapot.obj")).unwrap();
    assert_eq!((scene.name.as_str(), scene.triangles.len(), scene.lights.len()), ("teapot", 992, 2));
    let rig = &scene.rig;
    let [view, _] = rig.views(1.0).unwrap();
    let sight: Vec<f32> = (0..3).map(|i| rig.target[i] - rig.eye[i]).collect();
    let distance = sight.iter().map(|x| x * x).sum::<f32>().sqrt();
    assert!((rig.zero_parallax / distance - 1.0).abs() < 1e-5, "zero parallax is at the model's middle");
    assert_eq!(rig.guide_warning(DISPLAY_WIDTH), None);
    let half_height = (rig.vertical_fov_deg.to_radians() / 2.0).tan();
    for vertex in scene.triangles.iter().flat_map(|t| t.vertices) {
        let from_eye: Vec<f32> = (0..3).map(|i| vertex[i] - rig.eye[i]).collect();
        let depth: f32 = (0..3).map(|i| from_eye[i] * sight[i] / distance).sum();
        assert!(depth > distance / 2.0, "nothing is nearer than half way");
        let off_axis = (from_eye.iter().map(|x| x * x).sum::<f32>() - depth * depth).max(0.0).sqrt();
        assert!(off_axis / depth <= half_height, "all of it is in the picture");
    }
    assert_eq!((view.width, view.height), (800, 600));
}

#[test]
fn a_placed_model_stands_where_it_should() {
    let scene = scene::load(&models::scenes().join("spot.toml")).unwrap();
    let spot: Vec<_> = scene.triangles.iter().filter(|t| t.material == scene.triangles[2].material).collect();
    let extent = |axis: usize| {
        let values = spot.iter().flat_map(|t| t.vertices).map(|v| v[axis]);
        (values.clone().fold(f32::MAX, f32::min), values.fold(f32::MIN, f32::max))
    };
    assert_eq!(extent(1).0, 0.0);
    let longest = (0..3).map(|i| extent(i).1 - extent(i).0).fold(0.0, f32::max);
    assert!((longest - 2.0).abs() < 1e-6);
}
