//! Effects of a scene, and the passes with them on the CPU and on devices.

use parallax::backend::{Cpu, Profile};
use parallax_shared::effects::Effects;
use parallax_tests::gpu::{Driver, open};
use parallax_tests::small_scenes::{ball_under_lamp, everything, floor, mirror};
use parallax_tests::stage::{light, white};

#[test]
fn effects_are_what_the_scene_calls_for() {
    let stage = everything();
    let missing = Effects::SMOOTH_NORMALS;
    assert_eq!(stage.effects().0, Effects::ALL.0 & !missing.0);
    assert_eq!(floor(mirror()).effects(), Effects::TRIANGLES.with(Effects::REFLECTION));
    assert_eq!(floor(white()).effects(), Effects::TRIANGLES, "no lights, so nothing is lit");
    assert_eq!(ball_under_lamp().effects(), Effects::TRIANGLES.with(Effects::SPHERES).with(Effects::LIGHTS));
    let named = Effects::NAMES.iter().fold(Effects::NONE, |all, (effect, _)| all.with(*effect));
    assert_eq!(named, Effects::ALL);
    assert_eq!(Effects::ALL.0, 0x7ff, "the default of the passes' specialisation constant");
}

#[test]
fn the_effects_of_a_scene_give_the_picture_of_all_effects() {
    for stage in [everything(), floor(mirror()), ball_under_lamp(), floor(white())] {
        let mut cpu = Cpu::new(1).unwrap();
        let all = stage.render_with(&mut cpu, Effects::ALL).unwrap();
        let own = stage.render_with(&mut cpu, stage.effects()).unwrap();
        assert_eq!(
            bytemuck::cast_slice::<_, u32>(&own.colours),
            bytemuck::cast_slice::<_, u32>(&all.colours)
        );
    }
}

/// The guard above can fail: without an effect that the scene has, the picture differs.
#[test]
fn leaving_an_effect_out_changes_the_picture() {
    let stage = everything();
    let mut cpu = Cpu::new(1).unwrap();
    let full = stage.render(&mut cpu).unwrap().colours;
    for (effect, name) in Effects::NAMES {
        if effect != Effects::SMOOTH_NORMALS {
            let without = stage.render_with(&mut cpu, Effects(Effects::ALL.0 & !effect.0)).unwrap().colours;
            assert!(without != full, "{name}");
        }
    }
}

/// Every stage of a scene with every effect and two words of lights has the CPU's bits on both drivers; and
/// so has a scene with few effects.
#[test]
fn the_passes_give_the_cpus_bits_on_devices() {
    let mut full = everything();
    full.lights = (0..33).map(|i| light([i as f32 - 16.0, 4.0, 0.5], [0.02; 3])).collect();
    for driver in Driver::SOFTWARE {
        let Some(mut gpu) = open(driver, Profile::Strict) else { continue };
        for (stage, effects) in [(&full, Effects::ALL), (&floor(mirror()), floor(mirror()).effects())] {
            let want = stage.render_with(&mut Cpu::new(1).unwrap(), effects).unwrap();
            let got = stage.render_with(&mut gpu, effects).unwrap();
            let what = format!("{driver:?}, {effects:?}");
            assert_same(&got.hits, &want.hits, &what);
            assert_same(&got.surfaces, &want.surfaces, &what);
            assert_same(&got.seen, &want.seen, &what);
            assert_same(&got.local, &want.local, &what);
            assert_same(&got.colours, &want.colours, &what);
            (0..3).for_each(|i| assert_same(&got.counts[i], &want.counts[i], &what));
        }
    }
}

fn assert_same<T: bytemuck::Pod + std::fmt::Debug>(got: &[T], want: &[T], what: &str) {
    let bits = |values: &[T]| bytemuck::cast_slice::<T, u32>(values).to_vec();
    let differing = (0..want.len()).find(|&i| bits(&got[i..=i]) != bits(&want[i..=i]));
    if let Some(i) = differing {
        panic!("{what}: element {i} is {:?} instead of {:?}", got[i], want[i]);
    }
    assert_eq!(got.len(), want.len(), "{what}");
}
