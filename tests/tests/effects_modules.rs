//! What a scene does not call for is not in the code that a device runs (DESIGN §5): instructions of modules whose effects are frozen, as
//! an optimiser leaves them that does what every driver's compiler does (constants, branches, unused values). It is `spirv-opt`.

use parallax::backend::Profile;
use parallax::backend::gpu::{Modules, specialise};
use parallax_shared::effects::Effects;
use parallax_tests::{gpu, words};
use std::collections::BTreeSet;
use std::io::Write;
use std::process::Command;

/// Passes, the effects that they have code of, and how much of the code may be left without any.
const PASSES: [(&str, &[Effects], f64); 5] = [
    (
        "surface",
        &[
            Effects::TRIANGLES,
            Effects::SMOOTH_NORMALS,
            Effects::TEXTURES,
            Effects::SPHERES,
            Effects::ELLIPSOIDS,
        ],
        0.25,
    ),
    ("shadow", &[Effects::LIGHTS], 0.1),
    ("shade", &SHADING, 0.6),
    ("gloss", &SHADING, 0.6),
    (
        "bounce",
        &[
            Effects::LIGHTS,
            Effects::SPECULAR,
            Effects::REFLECTION,
            Effects::REFRACTION,
            Effects::TEXTURES,
            Effects::CHECKERBOARD,
            Effects::SKY_MAP,
            Effects::TRIANGLES,
            Effects::SMOOTH_NORMALS,
            Effects::SPHERES,
            Effects::ELLIPSOIDS,
        ],
        0.05,
    ),
];

/// Reflection: whether the pass `bounce` has something to add.
const SHADING: [Effects; 6] = [
    Effects::LIGHTS,
    Effects::SPECULAR,
    Effects::REFLECTION,
    Effects::TEXTURES,
    Effects::CHECKERBOARD,
    Effects::SKY_MAP,
];

/// Twice, as what one round folds decides branches of the next.
const ROUND: [&str; 4] =
    ["--simplify-instructions", "--ccp", "--eliminate-dead-branches", "--eliminate-dead-code-aggressive"];

/// The words of a pass with these effects, optimised.
fn optimised(profile: Profile, pass: &str, effects: Effects) -> Vec<u32> {
    let modules = Modules::embedded(profile);
    let words = specialise(&modules.get(pass).expect("a pass").spirv, &[(0, effects.0)]).unwrap();
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(bytemuck::cast_slice(&words)).unwrap();
    let out = tempfile::NamedTempFile::new().unwrap();
    let mut command = Command::new("spirv-opt");
    command.arg("--ssa-rewrite").args(ROUND).args(ROUND).arg(file.path()).arg("-o").arg(out.path());
    let run = command.output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let module = std::fs::read(out.path()).unwrap();
    module.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect()
}

/// How many instructions are left of a pass with these effects; in the fast profile, whose arithmetic is short.
fn instructions(pass: &str, effects: Effects) -> usize {
    words::instructions(&optimised(Profile::Fast, pass, effects)).count()
}

/// The 32-bit constants that a pass with these effects has.
fn constants(pass: &str, effects: Effects) -> BTreeSet<u32> {
    const CONSTANT: u32 = 43;
    let module = optimised(Profile::Strict, pass, effects);
    let of_32_bits = words::instructions(&module).filter(|(_, i)| i[0] == 4 << 16 | CONSTANT);
    of_32_bits.map(|(_, instruction)| instruction[3]).collect()
}

fn optimiser_is_there() -> bool {
    let there =
        Command::new("spirv-opt").arg("--version").output().is_ok_and(|output| output.status.success());
    let required = std::env::var_os("PARALLAX_REQUIRE_GPU").is_some_and(|value| value == "1");
    let found = if there { Ok(()) } else { Err("spirv-opt: instructions are not counted".to_string()) };
    gpu::require(found, required).is_some()
}

#[test]
fn an_effect_that_is_off_leaves_no_instruction() {
    if !optimiser_is_there() {
        return;
    }
    for (pass, effects, rest) in PASSES {
        let all = instructions(pass, Effects::ALL);
        println!("{pass}: {all} instructions with all effects");
        for (effect, name) in Effects::NAMES {
            let without = instructions(pass, Effects(Effects::ALL.0 & !effect.0));
            println!("  {:>6} fewer without {name}", all - without);
            assert_eq!(without < all, effects.contains(&effect), "{pass} without {name}: {without} of {all}");
        }
        let none = instructions(pass, Effects::NONE);
        println!("  {none} without any");
        assert!(none as f64 <= rest * all as f64, "{pass}: {none} of {all} are left without effects");
    }
}

/// The numbers that only highlights need, those of the power function, are in no module without them.
#[test]
fn a_module_without_highlights_has_none_of_their_numbers() {
    if !optimiser_is_there() {
        return;
    }
    let matt = Effects(Effects::ALL.0 & !Effects::SPECULAR.0);
    for pass in ["shade", "gloss"] {
        let (with, without) = (constants(pass, Effects::ALL), constants(pass, matt));
        assert!(without.is_subset(&with), "{pass}");
        let own: Vec<_> = with.difference(&without).map(|bits| f32::from_bits(*bits)).collect();
        assert!(own.len() >= 4, "{pass}: only {own:?} are theirs");
    }
}
