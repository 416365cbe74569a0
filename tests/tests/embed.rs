//! The example `embed`, as an engine would run it, on each software driver.

use parallax::backend::{Cpu, Profile};
use parallax::build::{Quality, build};
use parallax_tests::gpu::{Driver, open};

#[allow(dead_code)]
#[path = "../../host/examples/embed.rs"]
mod embed;

#[test]
fn another_engine_gets_the_same_bits_from_every_backend() {
    let structure = build(&embed::level(), &[], &[], Quality::Full).unwrap();
    let expected = embed::ask(&mut Cpu::new(2).unwrap(), &structure).unwrap();
    assert!(expected.histogram.iter().filter(|&&cells| cells > 0).count() > 4, "{:?}", expected.histogram);
    assert_eq!(expected.histogram.iter().sum::<u32>() as usize, expected.exposure.len());
    for driver in Driver::SOFTWARE {
        let Some(gpu) = open(driver, Profile::Strict) else { continue };
        let report = embed::check(gpu, &structure, &expected).unwrap();
        assert!(report.equal, "{driver:?}: {report:?}");
    }
}
