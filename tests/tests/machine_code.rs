//! The machine code of the AVX2 instance: eight lanes at once, a mask in one instruction, nothing contracted. A changed shape of the
//! source costs a third of the speed without changing a bit, and only this test would tell.

use parallax::backend::cpu::instruction_set::{InstructionSet, Task};
use parallax::build::{Quality, build};
use parallax_shared::layout::{Hit, Ray, Row};
use parallax_shared::traversal::{closest_hit, occluded};
use std::process::Command;

struct NearestHits<'a>(&'a [Row], &'a [Ray], f32, &'a mut [Hit]);
struct Occlusion<'a>(&'a [Row], &'a [Ray], f32, &'a mut [bool]);

impl Task for NearestHits<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (ray, hit) in self.1.iter().zip(self.3) {
            *hit = closest_hit(self.0, ray, self.2);
        }
    }
}

impl Task for Occlusion<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (ray, occluded_) in self.1.iter().zip(self.3) {
            *occluded_ = occluded(self.0, ray, self.2);
        }
    }
}

/// What is wrong with the listing of one traversal.
fn complaints(listing: &str) -> Vec<String> {
    let mnemonics: Vec<&str> = listing.lines().filter_map(mnemonic).collect();
    let count =
        |names: &[&str]| mnemonics.iter().filter(|m| names.iter().any(|name| m.starts_with(name))).count();
    let wide = |name: &str| {
        listing.lines().filter(|line| mnemonic(line) == Some(name) && line.contains("ymm")).count()
    };
    let mut complaints = Vec::new();
    let mut expect = |holds: bool, complaint: String| {
        if !holds {
            complaints.push(complaint);
        }
    };
    let masks = count(&["vmovmskps"]);
    expect(masks == 2, format!("{masks} masks by vmovmskps, expected one for nodes and one for packs"));
    let packed = count(&["vpackss", "packss", "vpmovmskb"]);
    expect(packed == 0, format!("{packed} instructions pack lanes to a mask"));
    let contracted = count(&["vfmadd", "vfmsub", "vfnmadd"]);
    expect(contracted == 0, format!("{contracted} operations are contracted"));
    // Six differences and products for a node's boxes; 18 and 18 for a pack's vertices and edges.
    for (name, least) in [("vsubps", 24), ("vmulps", 22), ("vminps", 5), ("vmaxps", 5)] {
        let found = wide(name);
        expect(found >= least, format!("{found} {name} of eight lanes, expected {least}"));
    }
    complaints
}

/// The mnemonic in a line `address:<tab>mnemonic operands`.
fn mnemonic(line: &str) -> Option<&str> {
    line.split_once(":\t")?.1.split_whitespace().next()
}

/// The listings of the AVX2 instances in this very binary: one for each task, whose names symbols do not tell.
fn listings() -> Vec<String> {
    let binary = std::env::current_exe().unwrap();
    let run = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).arg(&binary).output();
        let output = output.unwrap_or_else(|error| panic!("{program} (binutils): {error}"));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let symbols = run("nm", &[]);
    let names = symbols.lines().filter_map(|line| line.split_whitespace().last());
    let instances = names.filter(|name| name.contains("instruction_set") && name.contains("avx2"));
    instances.map(|name| run("objdump", &["--no-show-raw-insn", &format!("--disassemble={name}")])).collect()
}

#[test]
#[cfg(target_arch = "x86_64")]
fn the_avx2_instance_has_its_vector_shape() {
    if cfg!(debug_assertions) {
        println!(
            "SKIPPED: the vector shape is that of a release build (cargo test --release --test machine_code)"
        );
        return;
    }
    // Called, so that they are there.
    let bvh = build(&[], &[], &[], Quality::Full).unwrap();
    let ray = Ray { origin: [0.0; 3], t_min: 0.0, dir: [1.0; 3], t_max: 1.0 };
    InstructionSet::best().run(NearestHits(&bvh.rows, &[ray], 1.0, &mut [Hit { t: 0.0, prim_id: 0 }]));
    InstructionSet::best().run(Occlusion(&bvh.rows, &[ray], 1.0, &mut [true]));
    let listings = listings();
    assert_eq!(listings.len(), 2, "one for the nearest hit, one for occlusion");
    for listing in listings {
        assert_eq!(complaints(&listing), Vec::<String>::new(), "{listing}");
    }
}

#[test]
fn a_listing_that_lost_its_shape_is_told_apart() {
    let line = |text: &str| format!("  4010:\t{text}\n");
    let good: String = [("vsubps", 24), ("vmulps", 22), ("vminps", 5), ("vmaxps", 5)]
        .iter()
        .map(|(name, count)| line(&format!("{name} %ymm1,%ymm2,%ymm3")).repeat(*count))
        .chain([line("vmovmskps %ymm0,%eax").repeat(2)])
        .collect();
    assert_eq!(complaints(&good), Vec::<String>::new());
    let narrow = good.replace("ymm", "xmm");
    assert_eq!(complaints(&narrow).len(), 4, "four kinds of instruction lost their lanes");
    let bad = [
        good.replacen("vmovmskps", "vpextrb", 1),
        good.clone() + &line("vpackssdw %ymm0,%ymm1,%ymm1"),
        good.clone() + &line("vfmadd213ps %ymm0,%ymm1,%ymm1"),
    ];
    for bad in bad {
        assert_eq!(complaints(&bad).len(), 1, "{:?}", complaints(&bad));
    }
    assert!(!complaints("").is_empty());
}
