//! Shadow answers against f64: no acne and no leak on a mesh of many small triangles, on many spheres, and in rooms that lie askew.
//!
//! A point is where f64 puts the primary ray's hit on the same primitive, and what it sees is decided by every primitive that could
//! hide the light. Guard: secondary rays begin off the surface by the error bound of what was computed (`surface::leave`).

use glam::{DQuat, DVec3};
use parallax::backend::{Backend, Cpu, Profile};
use parallax::render::band::Values;
use parallax::render::{Overrides, SceneData};
use parallax_shared::camera;
use parallax_shared::layout::{BACK, NONE, Surface};
use parallax_shared::scene::SceneView;
use parallax_tests::gpu::{Driver, open};
use parallax_tests::meshes::cube;
use parallax_tests::oracle::{meet_triangle, unit_sphere};
use parallax_tests::reference::wide;
use parallax_tests::scenes::{file, load_at};
use parallax_tests::small_scenes::room;
use parallax_tests::stage::Stage;
use parallax_tests::stereo::left;
use parallax_tests::terminal::tried;
use rayon::prelude::*;
use std::collections::HashMap;

/// How far points are moved to see whether an answer is decided, in error bounds of the surface.
const MOVED: f64 = 3.0;

/// A point of a surface as f64 sees it.
#[derive(Clone, Copy)]
struct Point {
    position: DVec3,
    normal: DVec3,
    shading_normal: DVec3,
}

/// A scene in f64.
#[derive(Clone, Copy)]
struct Exact<'a>(SceneView<'a>);

impl<'a> Exact<'a> {
    fn new(data: &'a SceneData) -> Self {
        let SceneData { info, rows, triangles, records, texels, effects, .. } = data;
        assert_eq!(info.ellipsoids, 0, "triangles and spheres alone are asked");
        Self(SceneView { info, rows, triangles, records, texels, effects: *effects })
    }

    fn sphere(&self, prim_id: u32) -> Option<(DVec3, f64)> {
        let number = prim_id.checked_sub(self.0.info.triangles)?;
        let sphere = self.0.sphere(number);
        Some((wide(sphere.centre), f64::from(sphere.radius)))
    }

    /// A sphere around a primitive.
    fn bounds(&self, prim_id: u32) -> (DVec3, f64) {
        self.sphere(prim_id).unwrap_or_else(|| {
            let corners = self.0.triangles[prim_id as usize].vertices.map(wide);
            let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
            (centre, corners.map(|corner| corner.distance(centre)).into_iter().fold(0.0, f64::max))
        })
    }

    /// Where the ray meets the primitive, first of all.
    fn meet(&self, prim_id: u32, origin: DVec3, dir: DVec3) -> Option<Point> {
        if let Some((centre, radius)) = self.sphere(prim_id) {
            let [near, _] = unit_sphere((origin - centre) / radius, dir / radius)?;
            let position = origin + dir * near;
            let normal = (position - centre) / radius;
            return Some(Point { position, normal, shading_normal: normal });
        }
        let found = meet_triangle(prim_id, &self.0.triangles[prim_id as usize], origin, dir)?;
        let position = origin + dir * found.t;
        Some(Point { position, normal: found.normal, shading_normal: found.shading_normal })
    }

    /// Whether the primitive is met before `t` = 1.
    fn hides(&self, prim_id: u32, origin: DVec3, dir: DVec3) -> bool {
        let between = |t: f64| 0.0 < t && t < 1.0;
        if let Some((centre, radius)) = self.sphere(prim_id) {
            let roots = unit_sphere((origin - centre) / radius, dir / radius);
            return roots.is_some_and(|roots| roots.into_iter().any(between));
        }
        let triangle = &self.0.triangles[prim_id as usize];
        meet_triangle(prim_id, triangle, origin, dir).is_some_and(|found| between(found.t))
    }

    /// The point above which `moved` lies; none beside a triangle.
    fn below(&self, prim_id: u32, at: &Point, moved: DVec3) -> Option<Point> {
        let normal = match self.sphere(prim_id) {
            Some((centre, _)) => (moved - centre).normalize(),
            None => at.normal,
        };
        let shading_normal = match self.sphere(prim_id) {
            Some(_) => normal,
            None => self.meet(prim_id, moved + normal, -normal)?.shading_normal,
        };
        Some(Point { position: moved, normal, shading_normal })
    }
}

/// What may hide a light, sorted by the direction in which the light sees it.
struct Lamp<'a> {
    exact: Exact<'a>,
    position: DVec3,
    /// Cells of a unit direction's components.
    cells: HashMap<[i32; 3], Vec<u32>>,
    /// What has too many cells.
    large: Vec<u32>,
    /// Cells along a component, from 0 to 1.
    resolution: f64,
}

impl<'a> Lamp<'a> {
    fn new(exact: Exact<'a>, position: [f32; 3]) -> Self {
        let count = exact.0.info.triangles + exact.0.info.spheres;
        let (cells, large, resolution) = (HashMap::new(), Vec::new(), 0.5 * f64::from(count).sqrt());
        let mut lamp = Self { exact, position: wide(position), cells, large, resolution };
        (0..count).for_each(|prim_id| lamp.sort(prim_id));
        lamp
    }

    fn sort(&mut self, prim_id: u32) {
        let (centre, radius) = self.exact.bounds(prim_id);
        let away = centre - self.position;
        // The chord of the angle that it spans, and more.
        let reach = 1.1 * radius / away.length() + 1e-9;
        if reach * self.resolution > 4.0 || reach > 0.1 {
            return self.large.push(prim_id);
        }
        let ends = [-reach, reach].map(|reach| self.cell(away.normalize() + reach));
        for x in ends[0][0]..=ends[1][0] {
            for y in ends[0][1]..=ends[1][1] {
                for z in ends[0][2]..=ends[1][2] {
                    self.cells.entry([x, y, z]).or_default().push(prim_id);
                }
            }
        }
    }

    fn cell(&self, direction: DVec3) -> [i32; 3] {
        (direction * self.resolution).floor().to_array().map(|x| x as i32)
    }

    /// Whether a point of primitive `own` sees the light.
    fn is_seen(&self, own: u32, point: &Point) -> bool {
        let towards = self.position - point.position;
        let cell = self.cells.get(&self.cell(-towards.normalize())).into_iter().flatten();
        let mut others = cell.chain(&self.large).filter(|prim_id| **prim_id != own);
        point.normal.dot(towards) > 0.0
            && point.shading_normal.dot(towards) > 0.0
            && !others.any(|prim_id| self.exact.hides(*prim_id, point.position, towards))
    }

    /// Whether a surface sees the light, if that is decided: the same for all points around.
    fn answer(&self, surface: &Surface, at: &Point) -> Option<bool> {
        let reach = MOVED * f64::from(surface.error);
        let seen = |moved: DVec3| {
            let point = self.exact.below(surface.prim_id, at, at.position + moved * reach)?;
            Some(self.is_seen(surface.prim_id, &point))
        };
        let answer = seen(DVec3::ZERO);
        let around = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
        answer.filter(|_| around.into_iter().all(|moved| seen(moved) == answer))
    }
}

/// A decided answer.
#[derive(Clone, Copy)]
struct Case {
    word: usize,
    bit: u32,
    seen: bool,
}

/// How many answers there are of a picture, and those that are decided.
fn truth(data: &SceneData, values: &Values) -> (usize, Vec<Case>) {
    let exact = Exact::new(data);
    let view = &data.views[0];
    let seen: Vec<_> = (values.surfaces.iter().enumerate())
        .filter(|(_, surface)| surface.prim_id != NONE && surface.material & BACK == 0)
        .collect();
    let mut cases = Vec::new();
    for number in 0..data.info.lights {
        let lamp = Lamp::new(exact, exact.0.light(number).position);
        let case = |(pixel, surface): &(usize, &Surface)| {
            let dir = camera::pixel_direction(view, *pixel as u32 % view.width, *pixel as u32 / view.width);
            let at = exact.meet(surface.prim_id, wide(view.eye), dir.as_dvec3())?;
            let word = pixel * values.shadow_words + number as usize / 32;
            Some(Case { word, bit: number % 32, seen: lamp.answer(surface, &at)? })
        };
        cases.par_extend(seen.par_iter().filter_map(case));
    }
    (seen.len() * data.info.lights as usize, cases)
}

/// How many decided answers are wrong.
fn wrong(cases: &[Case], values: &Values) -> usize {
    cases.iter().filter(|case| (values.shadow[case.word] >> case.bit & 1 == 1) != case.seen).count()
}

/// A shipped scene with five lights, and what its left eye sees.
fn picture(name: &str, size: [u32; 2]) -> Option<(SceneData, Values)> {
    let mut scene = load_at(&file(name), size)?;
    Overrides { lights: Some(5), ..Overrides::default() }.apply(&mut scene).unwrap();
    let data = SceneData::new(&scene, Default::default()).expect("a scene that renders");
    let values = left(&data);
    Some((data, values))
}

fn assert_right(name: &str, size: [u32; 2]) {
    let Some((data, values)) = picture(name, size) else { return };
    let (asked, decided) = truth(&data, &values);
    tried(&format!("shadows/{name}"), asked as u64, &format!(", {} decided", decided.len()));
    let hidden = decided.iter().filter(|case| !case.seen).count();
    assert!(hidden > asked / 20 && hidden < asked * 19 / 20, "{hidden} of {asked} are hidden");
    assert!(100 * decided.len() >= 99 * asked, "{} of {asked} answers are decided", decided.len());
    assert_eq!(wrong(&decided, &values), 0, "of {} answers", decided.len());
}

/// 871,414 triangles, a pixel or less in size.
#[test]
fn no_shadow_on_the_dragon_is_wrong() {
    assert_right("dragon", [160, 160]);
}

/// A thousand spheres that shadow each other.
#[test]
fn no_shadow_on_many_spheres_is_wrong() {
    assert_right("spheres", [160, 160]);
}

/// The comparison can fail: one flipped answer is one wrong answer.
#[test]
fn a_flipped_answer_is_found() {
    let (data, mut values) = picture("spheres", [40, 40]).expect("a scene that ships whole");
    let (_, decided) = truth(&data, &values);
    for case in decided.iter().step_by(100) {
        values.shadow[case.word] ^= 1 << case.bit;
        assert_eq!(wrong(&decided, &values), 1);
        values.shadow[case.word] ^= 1 << case.bit;
    }
}

/// A closed cube from `low`, of the width `size`, turned about its middle.
fn askew(turn: DQuat, low: f64, size: f64) -> Stage {
    let middle = DVec3::splat(low + 0.5 * size);
    let at = |p: [f32; 3]| (middle + turn * (wide(p) - 0.5) * size).as_vec3().to_array();
    let mut walls = cube(0.5, [0.5; 3]).triangles;
    walls.iter_mut().for_each(|wall| wall.vertices = wall.vertices.map(at));
    room(walls, at)
}

/// In a convex room every wall faces and sees every light within, from its corners too, and none without, whichever way it lies.
#[test]
fn rooms_that_lie_askew_have_no_acne_and_no_leak() {
    let mut cases = 0;
    let mut gpu = open(Driver::Lavapipe, Profile::Strict);
    for (number, (low, size)) in
        [(-0.5, 1.0), (0.0, 1e-3), (100.0, 8.0), (1e5, 256.0)].into_iter().enumerate()
    {
        let turn = DQuat::from_axis_angle(DVec3::new(1.0, -2.0, 0.5).normalize(), 0.3 + number as f64);
        let stage = askew(turn, low, size);
        let check = |seen: &[u32]| {
            let wrong = seen.iter().filter(|seen| **seen != 0x5555_5555).count();
            assert_eq!(wrong, 0, "size {size} at {low}");
        };
        check(&seen_by(&mut Cpu::new(0).unwrap(), &stage));
        gpu.iter_mut().for_each(|gpu| check(&seen_by(gpu, &stage)));
        cases += 32 * u64::from(stage.view.width * stage.view.rows);
    }
    tried("shadows/rooms", cases, "");
}

fn seen_by<B: Backend>(backend: &mut B, stage: &Stage) -> Vec<u32> {
    stage.render(backend).unwrap().seen
}
