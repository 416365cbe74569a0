//! `parallax info`.

use super::failure::{Blame, Failure};
use super::options::{Loaded, MethodOptions, SceneOptions};
use super::report::{self, JsonOption, grouped};
use parallax::build::{Quality, Stats};
use parallax::render::SceneData;
use parallax::render::stereo::Plan;
use parallax::render::stereo::plan_report::PlanReport;
use parallax::scene::{Scene, Sky};
use parallax_shared::layout::View;
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;
use std::process::ExitCode;

/// Options of `parallax info`.
#[derive(clap::Args)]
pub struct Options {
    #[command(flatten)]
    scene: SceneOptions,
    #[command(flatten)]
    method: MethodOptions,
    #[command(flatten)]
    json: JsonOption,
}

/// What there is to know of a scene.
#[derive(Serialize)]
struct Report {
    scene: String,
    scene_file: PathBuf,
    contents: Contents,
    effects: Vec<&'static str>,
    camera: Camera,
    method: PlanReport,
    bvh: Stats,
    scale: f32,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct Contents {
    triangles: usize,
    spheres: usize,
    ellipsoids: usize,
    materials: usize,
    lights: usize,
    textures: usize,
    texels: usize,
    sky: &'static str,
    max_depth: u32,
}

#[derive(Serialize)]
struct Camera {
    width: u32,
    height: u32,
    vertical_fov_deg: f32,
    interaxial_px: f32,
    zero_parallax: f32,
    left: Eye,
    right: Eye,
}

/// The matrices of an eye; they act on columns.
#[derive(Serialize)]
struct Eye {
    eye: [f64; 3],
    world_to_view: [[f64; 4]; 4],
    view_to_px: [[f64; 4]; 3],
}

/// Runs the command.
pub fn run(options: &Options) -> Result<ExitCode, Failure> {
    let stereo = options.method.stereo()?;
    let Loaded { scene, path, warnings, .. } = options.scene.load()?;
    report::warn(&warnings);
    let data = SceneData::new(&scene, Quality::Full).usage()?;
    let plan = Plan::new(&data, &stereo, true).usage()?;
    options.json.publish(&Report {
        contents: Contents::of(&scene),
        effects: data.effect_names(),
        camera: Camera::of(&scene, &data),
        method: PlanReport::new(&data, &plan),
        bvh: data.stats,
        scale: data.scale,
        scene: scene.name,
        scene_file: path,
        warnings,
    })?;
    Ok(ExitCode::SUCCESS)
}

impl Contents {
    fn of(scene: &Scene) -> Self {
        Self {
            triangles: scene.triangles.len(),
            spheres: scene.spheres.len(),
            ellipsoids: scene.ellipsoids.len(),
            materials: scene.materials.len(),
            lights: scene.lights.len(),
            textures: scene.textures.len(),
            texels: scene.textures.iter().map(|picture| picture.texels.len()).sum(),
            sky: if matches!(scene.sky, Sky::Map(_)) { "map" } else { "gradient" },
            max_depth: scene.max_depth,
        }
    }
}

impl Camera {
    fn of(scene: &Scene, data: &SceneData) -> Self {
        let [left, right] = data.views.each_ref().map(|view| Eye::of(view, f64::from(data.scale)));
        let rig = &scene.rig;
        Self {
            width: rig.width,
            height: rig.height,
            vertical_fov_deg: rig.vertical_fov_deg,
            interaxial_px: rig.interaxial_px,
            zero_parallax: rig.zero_parallax,
            left,
            right,
        }
    }
}

impl Eye {
    /// The view's axes are x to the right, y down and z into the scene, in world units; `scale` is that of
    /// the data. A pixel's centre has whole coordinates.
    fn of(view: &View, scale: f64) -> Self {
        let [right, down, forward] = [view.step_x, view.step_y, view.forward].map(unit);
        let eye = wide(view.eye).map(|c| c / scale);
        let row = |axis: [f64; 3]| [axis[0], axis[1], axis[2], -dot(axis, eye)];
        let world_to_view = [row(right), row(down), row(forward), [0.0, 0.0, 0.0, 1.0]];
        // A point at view coordinates (X, Y, Z) meets the picture's plane at (X, Y)·d/Z; pixel (0, 0) is at
        // `corner`.
        let focal = f64::from(view.distance) / dot(right, wide(view.step_x));
        let centre = [right, down].map(|axis| -dot(axis, wide(view.corner)) / dot(right, wide(view.step_x)));
        let view_to_px = [[focal, 0.0, centre[0], 0.0], [0.0, focal, centre[1], 0.0], [0.0, 0.0, 1.0, 0.0]];
        Self { eye, world_to_view, view_to_px }
    }
}

fn wide(v: [f32; 3]) -> [f64; 3] {
    v.map(f64::from)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn unit(v: [f32; 3]) -> [f64; 3] {
    let v = wide(v);
    v.map(|c| c / dot(v, v).sqrt())
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "{} ({})", self.scene, self.scene_file.display())?;
        let Contents { triangles, spheres, ellipsoids, materials, lights, textures, texels, sky, max_depth } =
            &self.contents;
        writeln!(
            f,
            "  contents    {} triangles, {} spheres, {} ellipsoids, {materials} materials, {lights} lights",
            grouped(*triangles as u64),
            grouped(*spheres as u64),
            grouped(*ellipsoids as u64)
        )?;
        writeln!(f, "  textures    {textures} with {} texels; sky: {sky}", grouped(*texels as u64))?;
        let effects = if self.effects.is_empty() { "none".into() } else { self.effects.join(", ") };
        writeln!(f, "  effects     {effects}; up to {max_depth} reflections and refractions in a row")?;
        writeln!(f, "  scale       all coordinates times {:e}", self.scale)?;
        self.camera.fmt(f)?;
        writeln!(f, "  method      {}", self.method)?;
        let Stats { nodes, packs, fill, depth, stack, bytes, sah_cost } = self.bvh;
        writeln!(f, "  bvh         {} nodes, {} packs", grouped(nodes as u64), grouped(packs as u64))?;
        writeln!(f, "              {:.1} % full, depth {depth}, stack {stack}", 100.0 * fill)?;
        writeln!(f, "              {} bytes, SAH cost {sah_cost:.2}", grouped(bytes as u64))
    }
}

impl fmt::Display for Camera {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            f,
            "  camera      2 × {}×{}, {}° vertically, eyes {} px apart, zero parallax at {}",
            self.width, self.height, self.vertical_fov_deg, self.interaxial_px, self.zero_parallax
        )?;
        for (name, eye) in [("left", &self.left), ("right", &self.right)] {
            let [x, y, z] = eye.eye;
            writeln!(f, "    {name} eye at ({x:.6}, {y:.6}, {z:.6})")?;
            matrix(f, "world to view", &eye.world_to_view)?;
            matrix(f, "view to px", &eye.view_to_px)?;
        }
        Ok(())
    }
}

fn matrix(f: &mut fmt::Formatter, name: &str, rows: &[[f64; 4]]) -> fmt::Result {
    for (i, row) in rows.iter().enumerate() {
        let name = if i == 0 { name } else { "" };
        let [a, b, c, d] = row;
        writeln!(f, "      {name:<14}{a:>14.6}{b:>14.6}{c:>14.6}{d:>14.6}")?;
    }
    Ok(())
}
