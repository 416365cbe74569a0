//! What `parallax bench stereo` measures: the benchmarks of 000 (tables 5 and 6), 001 and 003, and our own aim.

use super::setting::{ANIMATED, Materials, Setting};
use crate::render::sampling::TOLERANCE;
use crate::render::{Method, Samples, Shadows, StereoOptions, Verify, value_name};
use clap::ValueEnum;

/// A series of measurements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Part {
    /// Our aim: at most 7 % of the first view at e = 15, 11 % at e = 50.
    Target,
    /// 000 table 5: sizes of the picture, five scenes.
    Dimensions,
    /// 000 table 5: distances of the eyes.
    Interaxial,
    /// 000 table 5: numbers of lights.
    Lights,
    /// 000 table 6: the error at sizes of the picture.
    ErrorDimensions,
    /// 000 table 6: the error at distances of the eyes.
    ErrorInteraxial,
    /// 001: 20 ellipsoids, one ray per pixel.
    Single,
    /// 001 table 1: mirrors, glass and both among 125 ellipsoids.
    Table1,
    /// 001: 20 ellipsoids, nine rays per pixel.
    Nine,
    /// 001 table 2: 100 and 1000 ellipsoids, one and several rays per pixel.
    Table2,
    /// 001 table 3: adaptive sampling.
    Table3,
    /// 003 table 5.1: gather tables, with and without reflections.
    #[value(name = "003")]
    Gather,
}

/// The scenes of 000, table 4.
const SCENES: [&str; 5] = ["spheres", ANIMATED, "sponza", "buddha", "dragon"];

impl Part {
    /// Its name on the command line.
    pub fn name(self) -> String {
        value_name(&self)
    }

    /// What it shows, in one sentence.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Target => {
                "Diffuse scenes at 600×600 with 5 lights: what a reprojected second view costs, in per cent of the first, and \
                 what that is made of."
            }
            Self::Dimensions => {
                "The cost of the second view against the size of the picture (000, table 5; e = 15, 5 lights)."
            }
            Self::Interaxial => {
                "The cost of the second view against the distance of the eyes (000, table 5; 600×600, 5 lights): wider holes."
            }
            Self::Lights => {
                "The cost of the second view against the number of lights (000, table 5; 600×600, e = 15): light is reused too."
            }
            Self::ErrorDimensions => {
                "Mean squared error against a traced second view, by size (000, table 6 and figure 36, where it falls). Errors at \
                 the same depth, and by what is nearer, are those of rounding to whole pixels: within surfaces, and of silhouettes."
            }
            Self::ErrorInteraxial => {
                "Mean squared error against a traced second view, by distance of the eyes (000, table 6 and figure 37, where \
                 it rises). Errors at the same depth, and by what is nearer, are those of rounding to whole pixels."
            }
            Self::Single => {
                "001's single-ray method on 20 ellipsoids, whose averages over thirty pictures stand beside it."
            }
            Self::Table1 => {
                "Mirrors and glass, whose further rays are traced for each eye, take away from what is saved (001, table 1)."
            }
            Self::Nine => {
                "001's nine rays per pixel, of which the middle one is reprojected for all, on 20 ellipsoids; its averages over thirty \
                 pictures stand beside ours."
            }
            Self::Table2 => {
                "Crowded scenes with a tenth of mirrors and a tenth of glass (001, table 2), with one ray per pixel and with jittered \
                 ones: time and traced points grow with their number."
            }
            Self::Table3 => {
                "Adaptive sampling: up to 3 × 3 and 5 × 5 rays per pixel, and 9 × 9 on the simplest picture (001, table 3). M is the share \
                 of the second view's points that are traced: many of the first view's land where none is needed."
            }
            Self::Gather => {
                "003's table 5.1: 100 spheres, 46 of them mirrors, 4 lights; without reflections and with two levels of them."
            }
        }
    }

    /// Whether only errors are looked at, so that nothing need be timed.
    pub const fn is_error(self) -> bool {
        matches!(self, Self::ErrorDimensions | Self::ErrorInteraxial)
    }

    /// What changes from setting to setting of a scene, and the number that says how much of it; nothing in parts that are tables.
    pub fn axis(self, setting: &Setting) -> Option<(&'static str, f64)> {
        match self {
            Self::Dimensions | Self::ErrorDimensions => {
                Some(("side of the picture, px", f64::from(setting.size[0])))
            }
            Self::Interaxial | Self::ErrorInteraxial => {
                Some(("interaxial distance e, px", f64::from(setting.interaxial_px)))
            }
            Self::Lights => Some(("lights", setting.lights.unwrap_or(0).into())),
            Self::Target
            | Self::Single
            | Self::Table1
            | Self::Nine
            | Self::Table2
            | Self::Table3
            | Self::Gather => None,
        }
    }

    /// How pairs of a setting are rendered; the first is the reference.
    pub fn methods(self, setting: &Setting) -> Vec<StereoOptions> {
        let samples = setting.samples;
        self.methods_of_one_ray().into_iter().map(|options| StereoOptions { samples, ..options }).collect()
    }

    fn methods_of_one_ray(self) -> Vec<StereoOptions> {
        let edges = StereoOptions { verify: Some(Verify::Edges), ..Method::Atomic.into() };
        let methods: &[Method] = match self {
            Self::Target => {
                let proving =
                    |method| StereoOptions { shadows: Shadows::Prove, ..StereoOptions::from(method) };
                let naive = [Method::Naive, Method::Ideal].map(StereoOptions::from);
                let exact = [Method::Guided.into(), proving(Method::Guided), proving(Method::Naive)];
                return naive.into_iter().chain(exact).chain([edges]).collect();
            }
            Self::Dimensions | Self::Interaxial | Self::Lights => {
                &[Method::Naive, Method::Ideal, Method::EsIsler, Method::Buffer, Method::Atomic]
            }
            Self::ErrorDimensions | Self::ErrorInteraxial => {
                return Method::value_variants().iter().map(|&method| method.into()).chain([edges]).collect();
            }
            Self::Single | Self::Table1 | Self::Nine | Self::Table2 | Self::Table3 => {
                &[Method::Naive, Method::Scanline]
            }
            Self::Gather => &[Method::Naive, Method::Scanline, Method::Gather1, Method::Gather2],
        };
        methods.iter().map(|&method| method.into()).chain([edges]).collect()
    }

    /// The scenes as they are measured; fewer and smaller ones if it has to be quick.
    pub fn settings(self, quick: bool) -> Vec<Setting> {
        let every = |full: Vec<u32>, few: &[u32]| if quick { few.to_vec() } else { full };
        let dragon = Setting::matt("dragon", 600, 15.0);
        let tens = || every((1..=10).map(|i| 10 * i).collect(), &[20, 50]);
        match self {
            Self::Target => {
                let far: &[&'static str] = if quick { &["dragon"] } else { &SCENES };
                let near = SCENES.iter().map(|scene| Setting::matt(scene, 600, 15.0));
                let far = far.iter().map(|scene| Setting::matt(scene, 600, 50.0));
                near.chain(far).map(|setting| setting.animated(quick)).collect()
            }
            Self::Dimensions => SCENES
                .iter()
                .filter(|scene| !quick || ![ANIMATED, "buddha"].contains(scene))
                .flat_map(|scene| {
                    let sides = every((4..=30).map(|i| 50 * i).collect(), &[200, 400]);
                    sides.into_iter().map(|side| Setting::matt(scene, side, 15.0).animated(quick))
                })
                .collect(),
            Self::Interaxial | Self::ErrorInteraxial => {
                tens().into_iter().map(|e| Setting { interaxial_px: e as f32, ..dragon.clone() }).collect()
            }
            Self::Lights => every((1..=10).collect(), &[1, 5])
                .into_iter()
                .map(|lights| Setting { lights: Some(lights), ..dragon.clone() })
                .collect(),
            Self::ErrorDimensions => every((1..=8).map(|i| 200 * i).collect(), &[200, 400])
                .into_iter()
                .map(|side| Setting::matt("dragon", side, 15.0))
                .collect(),
            Self::Single => vec![Setting::adelson("ellipsoids_20", Materials::Own)],
            Self::Table1 => [Materials::Opaque, Materials::Mirrors, Materials::Glass, Materials::Own]
                .map(|materials| Setting::adelson("ellipsoids_125", materials))
                .into(),
            Self::Nine => {
                vec![Setting { samples: Samples::Nine, ..Setting::adelson("ellipsoids_20", Materials::Own) }]
            }
            Self::Table2 => {
                let samples = every(vec![1, 2, 3, 4], &[1, 2]);
                ["ellipsoids_100", "ellipsoids_1000"]
                    .into_iter()
                    .take(if quick { 1 } else { 2 })
                    .flat_map(|scene| samples.iter().map(move |&n| jittered(scene, n, quick)))
                    .collect()
            }
            Self::Table3 => adaptive_settings(quick),
            Self::Gather if quick => gather_settings().split_off(4),
            Self::Gather => gather_settings(),
        }
    }
}

fn jittered(scene: &'static str, n: u32, quick: bool) -> Setting {
    let samples = if n == 1 { Samples::One } else { Samples::Jittered(n) };
    Setting { samples, ..Setting::adelson(scene, Materials::Own) }.shrunk(quick)
}

/// 001 says levels where the corners are one of them. Its mascot is not to be had.
fn adaptive_settings(quick: bool) -> Vec<Setting> {
    let with = |scene, materials, levels| {
        let samples = Samples::Adaptive { levels, tolerance: TOLERANCE };
        // Nine columns of points for each pixel: a smaller picture does.
        Setting { samples, ..Setting::adelson(scene, materials) }.shrunk(quick || levels > 2)
    };
    let of_table_1 = [Materials::Opaque, Materials::Mirrors, Materials::Glass, Materials::Own]
        .map(|materials| ("ellipsoids_125", materials));
    let pictures = [("ellipsoids_20", Materials::Own), ("ellipsoids_1000", Materials::Own)];
    let pictures = pictures.into_iter().chain(of_table_1).take(if quick { 1 } else { 6 });
    pictures
        .flat_map(|(scene, materials)| [1, 2].map(|levels| with(scene, materials, levels)))
        .chain((!quick).then(|| with("ellipsoids_20", Materials::Own, 3)))
        .collect()
}

pub(super) fn gather_settings() -> Vec<Setting> {
    let sizes = [[1024, 768], [800, 600], [640, 480]];
    let setting = |size: [u32; 2], levels| Setting {
        scene: "spheres",
        size,
        interaxial_px: size[0] as f32 / 40.0,
        lights: Some(4),
        materials: Materials::Es,
        levels: Some(levels),
        samples: Samples::One,
        frames: 1,
    };
    sizes.into_iter().flat_map(|size| [0, 2].map(|levels| setting(size, levels))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::stereo::setting::ANIMATED;

    #[test]
    fn sizes_of_the_benchmarks_are_those_of_tables_5_and_6() {
        let count = |part: Part| part.settings(false).len();
        assert_eq!(count(Part::Dimensions), 5 * 27);
        assert_eq!((count(Part::Interaxial), count(Part::ErrorInteraxial)), (10, 10));
        assert_eq!(count(Part::ErrorDimensions), 8);
        let sides: Vec<_> = Part::Dimensions.settings(false).iter().map(|s| s.size[0]).collect();
        assert_eq!((sides[0], sides[1], sides[26]), (200, 250, 1500));
        for part in Part::value_variants() {
            let (few, all) = (part.settings(true), part.settings(false));
            assert!(!few.is_empty() && few.len() <= all.len(), "{part:?}");
            assert_eq!(part.methods(&all[0])[0].method, Method::Naive);
        }
    }

    #[test]
    fn labels_tell_settings_apart() {
        for part in Part::value_variants() {
            let mut labels: Vec<_> = part.settings(false).iter().map(Setting::label).collect();
            let count = labels.len();
            labels.sort();
            labels.dedup();
            assert_eq!(labels.len(), count, "{part:?}");
        }
    }

    #[test]
    fn animations_are_means_over_a_turn() {
        let settings = Part::Target.settings(false);
        let turned = settings.iter().find(|setting| setting.scene == ANIMATED).unwrap();
        assert_eq!(turned.frame_numbers().collect::<Vec<_>>(), [0, 60, 120, 180]);
        assert_eq!(settings[0].frame_numbers().collect::<Vec<_>>(), [0]);
    }
}
