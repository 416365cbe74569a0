//! Grazing and critical angles, indices near 1, nested media, a furnace of them.

use crate::verify::Outcome;
use crate::verify::input::small_scenes::{glass, view};
use crate::verify::input::stage::{Stage, sphere};
use crate::verify::suite::Suite;
use parallax_kernels::arithmetic::operation::REFLECTANCE;
use parallax_shared::layout::Material;
use parallax_shared::shading::bounce::MAX_DEPTH;
use parallax_shared::shading::fresnel::{reflectance, refracted_cosine};

/// Fresnel's share in f64, 1 where all is reflected.
fn exact(cos_i: f64, eta: f64) -> f64 {
    let sin_t_squared = (1.0 - cos_i * cos_i) / (eta * eta);
    if sin_t_squared >= 1.0 {
        return 1.0;
    }
    let cos_t = (1.0 - sin_t_squared).sqrt();
    let part = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
    0.5 * (part(eta * cos_i, cos_t) + part(cos_i, eta * cos_t))
}

/// Cosines of every exponent and around the critical angle, indices down to one ULP from 1.
///
/// Guard: total reflection is decided before the root (`fresnel::refracted_cosine`).
pub fn fresnels_share_is_a_share(suite: &mut Suite) -> Outcome {
    let near = |x: f32, ulps: i32| f32::from_bits((x.to_bits() as i32 + ulps) as u32);
    let mut etas = vec![1.0f32, 1.33, 1.5, 2.4, 1.0 / 1.33, 1.0 / 1.5, 1.0 / 2.4, 1e-3, 1e3];
    etas.extend([-64, -8, -2, -1, 1, 2, 8, 64, 1024, 65536].map(|ulps| near(1.0, ulps)));
    let (mut cosines, mut indices) = (Vec::new(), Vec::new());
    for eta in etas {
        let critical = (1.0 - f64::from(eta).powi(2)).max(0.0).sqrt() as f32;
        let around = (-2000..=2000).map(|ulps| near(critical.max(1e-3), ulps));
        let small = (1..5000).map(|i| 2f32.powf(-0.02 * i as f32));
        let large = (0..2000).map(|ulps| near(1.0, -ulps));
        for cos_i in around.chain(small).chain(large).chain([0.0, -0.0]).filter(|cos| *cos <= 1.0) {
            let share = reflectance(cos_i, eta);
            suite.check((0.0..=1.0).contains(&share), || format!("{cos_i} {eta}: {share}"));
            if let Some(cos_t) = refracted_cosine(cos_i, eta) {
                suite.check(cos_t > 0.0 && cos_t <= 1.0, || format!("{cos_i} {eta}: {cos_t}"));
            } else {
                suite.check(share == 1.0, || format!("{cos_i} {eta}: {share}, not 1"));
            }
            // At the critical angle the share rises like a square root of what 1 − cos² is rounded by.
            let away = (f64::from(cos_i) - f64::from(critical)).abs();
            if away > 1e-3 && cos_i > 1e-2 {
                let want = exact(cos_i.into(), eta.into());
                suite.check((f64::from(share) - want).abs() < 2e-4, || {
                    format!("{cos_i} {eta}: {share}, not {want}")
                });
            }
            cosines.push(cos_i.to_bits());
            indices.push(eta.to_bits());
        }
    }
    suite.same_values("reflectance", REFLECTANCE, &cosines, &indices)?;
    Ok(())
}

/// Balls of glass in balls of other glass, some a hair apart, in a furnace: no pixel is brighter than the sky, and the bits are the same.
///
/// Guard: what is reflected is not refracted, too (`bounce::spawn`).
pub fn nested_media_in_a_furnace_make_no_light(suite: &mut Suite) -> Outcome {
    let mut cases = 0;
    for etas in [[1.5, 1.33, 1.0], [1.000_001, 1.0, 0.999_999], [2.4, 1.0 / 2.4, 1.5], [1.5, 1.5, 1.5]] {
        let mut stage = Stage::new(view([0.0, 0.5, 4.0], [0.0, 0.0, 0.0]));
        (stage.zenith, stage.horizon, stage.max_depth) = ([1.0; 3], [1.0; 3], MAX_DEPTH.min(8));
        stage.materials = etas.map(|eta| Material { eta, ..glass() }).into();
        stage.spheres =
            vec![sphere([0.0; 3], 1.0, 0), sphere([0.0; 3], 0.999, 1), sphere([0.2, 0.0, 0.0], 0.5, 2)];
        let stages = suite.stages(&stage)?;
        for colour in &stages.colours {
            suite.check(colour[..3].iter().all(|c| (0.0..=1.0 + 1e-5).contains(c)), || {
                format!("{etas:?}: {colour:?}")
            });
        }
        cases += stages.colours.len();
    }
    suite.tried(cases);
    Ok(())
}
