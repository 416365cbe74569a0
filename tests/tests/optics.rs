//! The functions of light at a surface: Fresnel, Snell, Phong, bilinear filtering.

use glam::{Vec2, Vec3};
use parallax_shared::layout::Texture;
use parallax_shared::shading::texture::{Edge, sample};
use parallax_shared::shading::{fresnel, phong};
use parallax_tests::small_scenes::picture;

#[test]
fn fresnels_reflectance_has_its_limits() {
    for eta in [1.0f32, 1.0001, 1.33, 1.5, 2.4, 1.0 / 1.5, 0.9999, 1e-3, 1e3] {
        for step in 0..=1000 {
            let share = fresnel::reflectance(step as f32 / 1000.0, eta);
            assert!((0.0..=1.0).contains(&share), "{eta} {step}: {share}");
        }
        let head_on = ((eta as f64 - 1.0) / (eta as f64 + 1.0)).powi(2);
        assert!((fresnel::reflectance(1.0, eta) as f64 - head_on).abs() < 1e-6, "{eta}");
        assert!(fresnel::reflectance(1e-6, eta) > 0.99 || eta == 1.0, "{eta}: grazing light is reflected");
        assert!(eta != 1.0 || fresnel::reflectance(0.3, eta) < 1e-10, "no surface, no reflection");
    }
}

/// A ray that grazes a surface may have a cosine that rounding took below zero, for which the formula gives a little more than 1.
#[test]
fn a_cosine_that_rounding_made_negative_has_a_share() {
    for eta in [1.1f32, 1.5, 2.4] {
        for ulps in 1..=64 {
            let share = fresnel::reflectance(ulps as f32 * -f32::EPSILON, eta);
            assert!((0.0..=1.0).contains(&share), "{eta}, {ulps} ULP of 1 below zero: {share}");
        }
    }
}

#[test]
fn light_is_reflected_alike_from_both_sides_and_totally_beyond_the_critical_angle() {
    for eta in [1.1f32, 1.5, 2.4] {
        let critical = (1.0 - 1.0 / (eta as f64 * eta as f64)).sqrt() as f32;
        for step in 1..=1000 {
            let cos_i = step as f32 / 1000.0;
            let cos_t = fresnel::refracted_cosine(cos_i, eta).expect("light always enters the denser side");
            let (out, back) = (fresnel::reflectance(cos_i, eta), fresnel::reflectance(cos_t, 1.0 / eta));
            // The smaller the cosine, the less of it is left in that of the other side.
            assert!((out - back).abs() < 2e-6 / cos_i, "{eta} {cos_i}: {out} {back}");
            if (cos_i - critical).abs() > 1e-4 {
                let total = fresnel::reflectance(cos_i, 1.0 / eta) == 1.0;
                assert_eq!(total, cos_i < critical, "{eta} {cos_i}");
                assert_eq!(fresnel::refracted_cosine(cos_i, 1.0 / eta).is_none(), cos_i < critical);
            }
        }
    }
}

#[test]
fn refraction_follows_snell() {
    for step in 1..100 {
        let angle = step as f32 * 0.015;
        let (incident, eta) = (Vec3::new(angle.sin(), -angle.cos(), 0.0), 1.5);
        let cos_t = fresnel::refracted_cosine(angle.cos(), eta).unwrap();
        let through = fresnel::refracted(incident, Vec3::Y, angle.cos(), cos_t, eta);
        assert!((through.x * eta - angle.sin()).abs() < 1e-6 && through.y < 0.0);
        assert!((through.length() - 1.0).abs() < 1e-6);
    }
}

#[test]
fn phongs_highlight_is_where_the_light_is_mirrored() {
    let (normal, light) = (Vec3::Y, Vec3::new(0.6, 0.8, 0.0));
    assert_eq!(phong::diffuse(normal, light), 0.8);
    assert_eq!(phong::diffuse(normal, -light), 0.0);
    let mirrored = Vec3::new(-0.6, 0.8, 0.0);
    assert!((phong::specular(normal, light, mirrored, 50.0) - 1.0).abs() < 1e-5);
    let aside = Vec3::new(-0.6 * 0.8 + 0.8 * 0.6, 0.8 * 0.8 + 0.6 * 0.6, 0.0);
    let cosine = mirrored.dot(aside) as f64;
    for exponent in [1.0f32, 10.0, 12.5, 80.0] {
        let want = cosine.powf(exponent as f64);
        assert!((phong::specular(normal, light, aside, exponent) as f64 - want).abs() < 1e-5);
    }
}

#[test]
fn bilinear_filtering_is_exact_at_texels_and_even_between_them() {
    let (texture, texels) = picture();
    let at = |u: f32, v: f32, vertical| sample(&texels, &texture, Vec2::new(u, v), vertical).x;
    for vertical in [Edge::Repeat, Edge::Clamp] {
        for (row, v) in [(0, 0.75), (1, 0.25)] {
            for column in 0..3 {
                let u = (column as f32 + 0.5) / 3.0;
                assert!((at(u, v, vertical) - (row * 3 + column) as f32).abs() < 1e-5, "{row} {column}");
            }
        }
        assert!((at(1.0 / 3.0, 0.75, vertical) - 0.5).abs() < 1e-5);
        assert!((at(0.5, 0.5, vertical) - 2.5).abs() < 1e-5);
    }
}

#[test]
fn textures_repeat_and_the_sky_ends_at_its_poles() {
    let (texture, texels) = picture();
    let at = |u: f32, v: f32, vertical| sample(&texels, &texture, Vec2::new(u, v), vertical).x;
    for whole in [-3.0, 1.0, 7.0] {
        assert!((at(0.3 + whole, 0.6 - whole, Edge::Repeat) - at(0.3, 0.6, Edge::Repeat)).abs() < 1e-4);
        assert!((at(0.3 + whole, 0.6, Edge::Clamp) - at(0.3, 0.6, Edge::Clamp)).abs() < 1e-4);
    }
    assert!((at(0.0, 0.75, Edge::Repeat) - 1.0).abs() < 1e-5, "between the last column and the first");
    assert!((at(0.5, 1.0, Edge::Repeat) - 2.5).abs() < 1e-5, "between the last row and the first");
    for v in [0.75, 0.8, 0.9, 1.0, 2.0] {
        assert!((at(0.5, v, Edge::Clamp) - 1.0).abs() < 1e-5, "above the centre of the first row");
    }
    for v in [0.25, 0.1, 0.0, -1.0] {
        assert!((at(0.5, v, Edge::Clamp) - 4.0).abs() < 1e-5, "below the centre of the last row");
    }
    let single = Texture { first: 5, width: 1, height: 1, padding: 0 };
    assert_eq!(sample(&texels, &single, Vec2::new(0.2, 0.9), Edge::Clamp).x, 5.0);
    assert_eq!(sample(&texels, &single, Vec2::new(0.2, 0.9), Edge::Repeat).x, 5.0);
}
