//! The command as a user sees it: help, exit codes, JSON, and the files it leaves behind.

use exr::prelude::{FlatSamples, Text, read_first_flat_layer_from_file};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

/// A tetrahedron: the smallest model that has an inside.
const MODEL: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A folder with the model in it.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.obj"), MODEL).unwrap();
    folder
}

/// What the command says and which exit code it has.
struct Run {
    code: i32,
    stdout: String,
    stderr: String,
}

/// Runs the command with `arguments` in `folder`.
fn parallax(folder: &Path, arguments: &[&str]) -> Run {
    told(Command::new(env!("CARGO_BIN_EXE_parallax")), folder, arguments)
}

/// The same without the models that scenes may name.
fn parallax_without_models(folder: &Path, arguments: &[&str]) -> Run {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parallax"));
    command.env("PARALLAX_MODELS", folder.join("nowhere"));
    told(command, folder, arguments)
}

fn told(mut command: Command, folder: &Path, arguments: &[&str]) -> Run {
    let Output { status, stdout, stderr } = command.args(arguments).current_dir(folder).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Run { code: status.code().expect("no signal"), stdout: text(stdout), stderr: text(stderr) }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error} in {text}"))
}

#[track_caller]
fn assert_refused(run: &Run, code: i32, expected: &str) {
    assert_eq!(run.code, code, "{}", run.stderr);
    assert!(run.stderr.contains(expected), "expected `{expected}` in: {}", run.stderr);
    assert!(!run.stderr.contains("panicked"), "{}", run.stderr);
}

#[test]
fn help_is_there_and_has_examples() {
    let folder = folder();
    for arguments in [
        &["--help"][..],
        &["render", "--help"],
        &["diff", "--help"],
        &["bench", "--help"],
        &["verify", "--help"],
    ] {
        let run = parallax(folder.path(), arguments);
        assert_eq!(run.code, 0);
        assert!(run.stdout.contains("Usage: parallax"), "{}", run.stdout);
    }
    for arguments in [&["--help"][..], &["render", "--help"], &["diff", "--help"], &["verify", "--help"]] {
        assert!(parallax(folder.path(), arguments).stdout.contains("Examples:"));
    }
    assert!(parallax(folder.path(), &["--version"]).stdout.starts_with("parallax "));
}

#[test]
fn bad_usage_is_code_2() {
    let folder = folder();
    let cases: [(&[&str], &str); 15] = [
        (&["bench", "stereo", "model.obj", "--part", "target"], "cannot be used with"),
        (&["bench", "stereo", "--size", "8x8"], "required arguments were not provided"),
        (&["paint"], "unrecognized subcommand"),
        (&["render", "--colour"], "unexpected argument"),
        (&["render", "model.obj", "--backend", "tpu"], "[possible values: auto, cpu, gpu]"),
        (&["render", "model.obj", "--method", "magic"], "[possible values: naive"),
        (&["render", "model.obj", "--samples", "9x9"], "adaptive-1 to adaptive-4"),
        (&["render", "model.obj", "--tolerance", "0.1"], "--tolerance is for adaptive --samples"),
        (&["info", "model.obj", "--method", "guided", "--samples", "nine"], "`guided` has one ray per pixel"),
        (
            &["render", "model.obj", "--size", "9000x9", "--samples", "4x4"],
            "4 × 4 points each is not supported",
        ),
        (&["render", "model.obj", "--size", "0x5"], "for example 800x600"),
        (&["render", "model.obj", "--size", "40000x4"], "a picture of 40000x4 is not supported"),
        (&["render", "model.obj", "--size", "32768x32768"], "at most 268435456"),
        (&["render", "model.obj", "--lights", "5000"], "lights are too many"),
        (&["render", "model.obj", "--interaxial", "-3"], "interaxial distance is -3"),
    ];
    for (arguments, expected) in cases {
        assert_refused(&parallax(folder.path(), arguments), 2, expected);
    }
    assert_eq!(names(folder.path()), ["model.obj"]);
}

#[test]
fn verifying_needs_a_device_or_is_about_the_processor() {
    let folder = folder();
    assert_refused(
        &parallax(folder.path(), &["verify", "--adapter", "no such"]),
        1,
        "`--cpu` verifies the processor",
    );
    assert_refused(
        &parallax(folder.path(), &["verify", "--cpu", "--adapter", "any"]),
        2,
        "cannot be used with",
    );
    let run = parallax(folder.path(), &["verify", "--cpu", "--json", "verification.json"]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("NO DEVICE"), "{}", run.stdout);
    let report = json(&std::fs::read_to_string(folder.path().join("verification.json")).unwrap());
    assert!(report["device"].is_null() && report["fast"].is_null());
    assert_eq!(report["strict"]["is_safe"], true);
    let cases = report["cases"].as_array().unwrap();
    assert!(cases.iter().map(|case| case["cases"].as_u64().unwrap()).sum::<u64>() > 1_000_000);
}

#[test]
fn a_bad_scene_is_code_2() {
    let folder = folder();
    std::fs::write(folder.path().join("broken.toml"), "this is = not [a scene").unwrap();
    std::fs::write(folder.path().join("model.xyz"), MODEL).unwrap();
    for (scene, expected) in
        [("nowhere.toml", "no such file"), ("broken.toml", "broken.toml"), ("model.xyz", "model.xyz")]
    {
        for command in ["render", "info", "diff"] {
            assert_refused(&parallax(folder.path(), &[command, scene]), 2, expected);
        }
    }
    assert!(!folder.path().join("out").exists());
}

#[test]
fn rendering_writes_what_it_says() {
    let folder = folder();
    let arguments = ["render", "model.obj", "--size", "32x24", "--out", "a", "--backend", "cpu", "--aov"];
    let run = parallax(folder.path(), &[&arguments[..], &["--json", "report.json"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let files =
        ["model.exr", "model_anaglyph.png", "model_left.png", "model_right.png", "model_side-by-side.png"];
    assert_eq!(names(&folder.path().join("a")), files);

    let report = json(&std::fs::read_to_string(folder.path().join("report.json")).unwrap());
    assert_eq!((&report["width"], &report["height"]), (&32.into(), &24.into()));
    assert_eq!((report["profile"].as_str(), report["method"].as_str()), (Some("strict"), Some("naive")));
    assert!(report["backend"].as_str().unwrap().starts_with("CPU"));
    assert_eq!(report["rays"]["primary"], 2 * 32 * 24);
    assert_eq!(report["files"].as_array().unwrap().len(), files.len());
    let stages = report["stages"].as_array().unwrap();
    for (view, stage) in [(Value::Null, "load"), ("left".into(), "primary"), ("right".into(), "shade")] {
        let of_stage = |time: &&Value| time["view"] == view && time["stage"] == stage;
        assert!(stages.iter().find(of_stage).unwrap()["seconds"].as_f64().unwrap() >= 0.0);
    }
    for file in files {
        assert!(run.stdout.contains(file), "{}", run.stdout);
    }
    assert!(run.stdout.contains("1,536"), "the number of rays is told: {}", run.stdout);
}

#[test]
fn pictures_can_be_read_back() {
    let folder = folder();
    let run = parallax(folder.path(), &["render", "model.obj", "--size", "32x24", "--aov", "--out", "."]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let read = |name: &str| image::open(folder.path().join(name)).unwrap().to_rgb8();
    let (left, right, both) =
        (read("model_left.png"), read("model_right.png"), read("model_side-by-side.png"));
    assert_eq!((left.dimensions(), both.dimensions()), ((32, 24), (64, 24)));
    assert_eq!(
        (both.get_pixel(16, 12), both.get_pixel(48, 12)),
        (left.get_pixel(16, 12), right.get_pixel(16, 12))
    );
    assert_ne!(left, right, "the eyes see the same");

    let layer = read_first_flat_layer_from_file(folder.path().join("model.exr")).unwrap().layer_data;
    assert_eq!(layer.attributes.multi_view_names, Some(vec![Text::from("left"), Text::from("right")]));
    let channels = layer.channel_data.list;
    let samples = |name: &str| &channels.iter().find(|c| c.name.eq(name)).expect(name).sample_data;
    for name in ["R", "right.B", "t", "right.disparity", "normal.left.Z"] {
        assert!(matches!(samples(name), FlatSamples::F32(values) if values.len() == 32 * 24), "{name}");
    }
    let FlatSamples::U32(primitives) = samples("right.prim_id") else { panic!("prim_id is a UINT channel") };
    assert!(primitives.contains(&u32::MAX) && primitives.iter().any(|id| *id < 4));
}

#[test]
fn json_on_stdout_comes_alone() {
    let folder = folder();
    let size = ["--size", "16x12"];
    let info = parallax(folder.path(), &[&["info", "model.obj", "--json", "-"][..], &size].concat());
    let report = json(&info.stdout);
    assert_eq!(report["contents"]["triangles"], 4);
    assert_eq!(report["camera"]["left"]["world_to_view"].as_array().unwrap().len(), 4);
    assert!(report["bvh"]["nodes"].as_u64().unwrap() >= 1);

    let render = parallax(folder.path(), &[&["render", "model.obj", "--json", "-"][..], &size].concat());
    assert_eq!(json(&render.stdout)["width"], 16);
    let devices = json(&parallax(folder.path(), &["devices", "--json", "-"]).stdout);
    assert!(devices["adapters"].is_array() && devices["used"].is_string());
}

#[test]
fn second_views_are_measured_by_every_method() {
    let folder = folder();
    let (bench, options) = (["bench", "stereo", "model.obj", "--json", "-"], ["--repetitions", "1"]);
    let sizes = ["--size", "16x12,8x8", "--interaxial", "4"];
    let run = parallax(folder.path(), &[&bench[..], &options, &sizes].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let lines: Vec<_> = run.stdout.lines().map(json).collect();
    let costs: Vec<_> = lines.iter().filter(|line| line["metric"] == "second view / mono").collect();
    for case in ["model 16x12 e=4 lights=5", "model 8x8 e=4 lights=5"] {
        for method in ["naive", "ideal", "scanline", "gather-2", "buffer", "atomic verify=edges"] {
            let found = costs.iter().filter(|line| line["case"] == case && line["method"] == method);
            assert_eq!(found.count(), 1, "{case} {method}");
        }
    }
    assert!(costs.iter().all(|line| line["value"].as_f64().is_some_and(|cost| cost > 0.0)));
    assert!(lines.iter().any(|line| line["metric"] == "mse" && line["bench"] == "stereo"));
}

#[test]
fn a_study_tells_each_backend_by_itself() {
    let folder = folder();
    let study = ["study", "model.obj", "--knob", "method,profile", "--size", "16x12", "--repetitions", "1"];
    let run = parallax(folder.path(), &[&study[..], &["--backend", "cpu,cpu", "--threads", "1"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let file = |name: &str| std::fs::read_to_string(folder.path().join("study").join(name)).unwrap();
    let points: Vec<_> = file("study.jsonl").lines().map(json).collect();
    assert_eq!(points.len(), 10, "methods, once on a backend that is named twice");
    for point in &points {
        assert!(
            point["backend"].as_str().unwrap().starts_with("CPU (") && point["gain"].as_f64() > Some(0.0)
        );
        assert!(point["peak_bytes"].as_u64() > point["scene_bytes"].as_u64(), "{point}");
    }
    let prices: Vec<_> = file("strict.jsonl").lines().map(json).collect();
    assert_eq!(
        (prices.len(), &prices[0]["same_code"], &prices[0]["fast_ms"]),
        (1, &true.into(), &Value::Null)
    );
    assert!(
        run.stdout.contains("For model on CPU (") && run.stdout.contains("so it costs nothing"),
        "{}",
        run.stdout
    );
    assert!(file("study.html").contains("0, by construction"));

    let chosen = parallax(
        folder.path(),
        &["render", "model.obj", "--budget-ms", "1e9", "--backend", "cpu", "--threads", "1"],
    );
    assert!(chosen.code == 0 && chosen.stderr.contains("chosen: "), "{}", chosen.stderr);
    let of_another = ["render", "model.obj", "--budget-ms", "1e9", "--backend", "cpu", "--threads", "2"];
    assert_refused(
        &parallax(folder.path(), &of_another),
        2,
        "the study has nothing of the scene `model` on CPU (",
    );
    let both = ["--tolerance", "0.1", "--samples", "adaptive-1"];
    assert_refused(&parallax(folder.path(), &[&of_another[..], &both].concat()), 2, "cannot be used with");
    assert_refused(
        &parallax(folder.path(), &[&study[..], &["--backend", "cpu,tpu"]].concat()),
        2,
        "auto, cpu, gpu",
    );
}

#[test]
fn default_scenes_without_their_models_are_left_out() {
    let folder = folder();
    for study in [&["study", "--effects"][..], &["study", "--knob", "bvh"]] {
        let small = ["--size", "8x6", "--repetitions", "1", "--backend", "cpu"];
        let run = parallax_without_models(folder.path(), &[study, &small[..]].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(
            run.stderr.contains("warning: left out: ") && run.stderr.contains("dragon"),
            "{}",
            run.stderr
        );
        assert!(run.stdout.contains("cornell") && !run.stdout.contains("dragon"), "{}", run.stdout);
        let named = parallax_without_models(folder.path(), &[study, &small[..], &["dragon"]].concat());
        assert_refused(&named, 2, "dragon");
    }
}

#[test]
fn maps_show_how_the_second_view_was_made_and_how_far_it_is_from_the_truth() {
    let folder = folder();
    let render = |options: &[&str]| {
        let common = ["render", "model.obj", "--size", "32x24", "--backend", "cpu", "--maps", "--json", "-"];
        let run = parallax(folder.path(), &[&common[..], &["--format", "anaglyph"], options].concat());
        assert_eq!(run.code, 0, "{}", run.stderr);
        let report = json(&run.stdout);
        let names = report["files"].as_array().unwrap().iter().map(|file| file.as_str().unwrap().to_owned());
        let names: Vec<_> = names.map(|name| name.rsplit(['/', '\\']).next().unwrap().to_owned()).collect();
        (report, names)
    };
    let (report, names) = render(&["--method", "atomic", "--reference"]);
    let maps = ["map", "disparity", "rays", "time", "error"].map(|what| format!("model_{what}.png"));
    assert_eq!(names[..5], maps);
    for number in ["mse", "differing_percent", "distance", "wrong_depth_percent"] {
        assert!(report["error"][number].is_f64(), "{number} in {report}");
    }
    assert!(report["maps"]["time_us"].as_f64().unwrap() > 0.0);
    let (report, names) = render(&["--samples", "2x2"]);
    assert_eq!(names[..2], ["model_disparity.png", "model_rays.png"], "nothing was inferred");
    assert!(report["error"].is_null() && report["maps"]["rays"].as_u64().unwrap() >= 4);
    let (_, names) = render(&["--method", "scanline", "--samples", "adaptive-1"]);
    assert_eq!(names[0], "model_map.png");
}

#[test]
fn what_a_method_will_do_is_told_without_rendering() {
    let folder = folder();
    let info = |options: &[&str]| {
        let arguments =
            [&["info", "model.obj", "--size", "32x24", "--interaxial", "4", "--json", "-"], options];
        json(&parallax(folder.path(), &arguments.concat()).stdout)["method"].clone()
    };
    let naive = info(&[]);
    assert_eq!((&naive["method"], &naive["verify"]), (&"naive".into(), &Value::Null));
    let buffer = info(&["--method", "buffer", "--depth", "3", "--first", "right", "--samples", "2x2"]);
    assert_eq!((&buffer["slots"], &buffer["first"]), (&3.into(), &"right".into()));
    assert_eq!((&buffer["columns"], &buffer["verify"]), (&64.into(), &"all".into()));
    assert_eq!(buffer["interaxial"], 8.0);
}

#[test]
fn a_render_that_fails_leaves_nothing_half_written() {
    let folder = folder();
    let render =
        |out: &str| parallax(folder.path(), &["render", "model.obj", "--size", "16x12", "--out", out]);
    // A file where the folder should be, and a folder where a file should be.
    assert_refused(&render("model.obj"), 1, "cannot make the folder");
    std::fs::create_dir_all(folder.path().join("a/model_left.png/x")).unwrap();
    assert_refused(&render("a"), 1, "cannot replace");
    assert_eq!(names(&folder.path().join("a")), ["model_left.png"]);
    assert_eq!(std::fs::read_to_string(folder.path().join("model.obj")).unwrap(), MODEL);
}

#[test]
fn an_adapter_that_does_not_exist_is_code_1() {
    let folder = folder();
    let run =
        parallax(folder.path(), &["render", "model.obj", "--backend", "gpu", "--adapter", "no such thing"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(run.stderr.starts_with("error: "), "{}", run.stderr);
    assert!(!folder.path().join("out").exists());
}

#[test]
fn a_broken_guide_is_a_warning() {
    let folder = folder();
    let run = |interaxial: &str| {
        let size = ["--size", "32x24", "--interaxial", interaxial, "--json", "-"];
        parallax(folder.path(), &[&["info", "model.obj"][..], &size].concat())
    };
    let wide = run("16");
    assert_eq!(wide.code, 0);
    assert!(wide.stderr.starts_with("warning: "), "{}", wide.stderr);
    assert_eq!(json(&wide.stdout)["warnings"].as_array().unwrap().len(), 1);
    assert_eq!(run("1").stderr, "");
}

#[test]
fn an_animation_goes_on_where_it_was() {
    let folder = folder();
    std::fs::write(
        folder.path().join("balls.toml"),
        "[camera]\neye = [0, 0, 28]\ntarget = [0, 0, 0]\nwidth = 24\nheight = 16\n\
         [[object]]\nrandom_spheres = { count = 9, turn_per_frame = 15 }\n",
    )
    .unwrap();
    let render = |arguments: &[&str]| {
        let common = ["render", "balls.toml", "--backend", "cpu", "--format", "anaglyph"];
        parallax(folder.path(), &[&common[..], arguments].concat())
    };
    let whole = render(&["--frames", "0..3", "--out", "whole"]);
    assert_eq!(whole.code, 0, "{}", whole.stderr);
    assert_eq!(render(&["--frames", "0..1", "--out", "parts"]).code, 0);
    let rest = render(&["--frames", "0..3", "--out", "parts"]);
    assert!(rest.stdout.contains("balls_000001.exr is there"), "{}", rest.stdout);
    let (parts, whole) = (folder.path().join("parts"), folder.path().join("whole"));
    assert_eq!(names(&parts), names(&whole));
    assert_eq!(names(&parts).len(), 9, "two files a frame, and how they were made");
    let bytes =
        |folder: &Path, frame: u32| std::fs::read(folder.join(format!("balls_{frame:06}.exr"))).unwrap();
    for frame in 0..4 {
        assert!(bytes(&parts, frame) == bytes(&whole, frame), "frame {frame}");
    }
    assert!(bytes(&whole, 0) != bytes(&whole, 1), "nothing turns");
    let other = render(&["--frames", "0..3", "--out", "parts", "--aov"]);
    assert_refused(&other, 2, "another `aov` (false instead of true)");
    let maps = ["--method", "atomic", "--maps", "--reference"];
    let shown = render(&[&["--frames", "0..1", "--out", "shown"], &maps[..]].concat());
    assert_eq!(shown.code, 0, "{}", shown.stderr);
    for file in ["balls_000000_map.png", "balls_000001_map.png", "balls_000001_error.png"] {
        assert!(names(&folder.path().join("shown")).contains(&file.into()), "{file}");
    }
    let without = render(&["--frames", "0..1", "--out", "shown", "--method", "atomic", "--maps"]);
    assert_refused(&without, 2, "another `reference` (true instead of false)");
    assert_refused(&render(&["--frames", "3..1"]), 2, "expected the first and the last frame");
}
