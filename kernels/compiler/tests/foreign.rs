//! A crate outside of this workspace compiles, and its kernels do what they should.

use kernel_compiler::interpret::{self, Arguments};
use kernel_compiler::manifest::BindingAccess;
use kernel_compiler::{Compiled, CrateSource, Entry, Options, Profile, compile};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

fn compiled() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| {
        let source = CrateSource::new(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/foreign"));
        // Into this workspace's target folder, not into the crate's own.
        let target_dir = Some(Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign"));
        let options =
            Options { profiles: Profile::ALL.to_vec(), wgsl: true, target_dir, ..Options::default() };
        compile(&source, &options).unwrap_or_else(|error| panic!("{error}"))
    })
}

fn entry(name: &str) -> &'static Entry {
    compiled().entries.iter().find(|entry| entry.name == name).expect("the kernel")
}

#[test]
fn the_manifest_says_what_a_host_must_know() {
    let manifest = &compiled().manifest;
    let names: Vec<_> = manifest.entries.iter().map(|entry| (entry.profile, entry.name.as_str())).collect();
    let expected = Profile::ALL.map(|profile| [(profile, "histogram"), (profile, "mandelbrot")]).concat();
    assert_eq!(names, expected);
    let mandelbrot = &manifest.entries[1];
    assert_eq!((mandelbrot.workgroup_size, mandelbrot.push_constant_bytes), ([8, 8, 1], 16));
    assert_eq!((mandelbrot.specialisation[0].id, mandelbrot.specialisation[0].default_bits), (0, 100));
    let histogram: Vec<_> = manifest.entries[0].bindings.iter().map(|binding| binding.access).collect();
    assert_eq!(histogram, [BindingAccess::Read, BindingAccess::Atomic]);
}

#[test]
fn the_kernels_compute_what_plain_code_does() {
    let (size, step, limit) = (24u32, 0.1f32, 50);
    let frame = [(-2.0f32).to_bits(), (-1.2f32).to_bits(), step.to_bits(), size];
    let mut arguments = Arguments {
        buffers: BTreeMap::from([((0, 0), vec![u32::MAX; (size * size) as usize])]),
        push: frame.to_vec(),
        specialisation: BTreeMap::from([(0, limit)]),
        ..Arguments::default()
    };
    interpret::run(&entry("mandelbrot").kernel, [3, 3, 1], &mut arguments).unwrap();
    let rounds = arguments.buffers.remove(&(0, 0)).unwrap();
    let expected: Vec<u32> = (0..size * size)
        .map(|at| escape(-2.0 + (at % size) as f32 * step, -1.2 + (at / size) as f32 * step, limit))
        .collect();
    assert_eq!(rounds, expected);

    let counts =
        (0..=limit).map(|round| rounds.iter().filter(|&&r| r == round).count() as u32).collect::<Vec<_>>();
    let buffers = BTreeMap::from([((0, 0), rounds), ((0, 1), vec![0; limit as usize + 1])]);
    let mut arguments = Arguments { buffers, ..Arguments::default() };
    interpret::run(&entry("histogram").kernel, [size * size / 64, 1, 1], &mut arguments).unwrap();
    assert_eq!(arguments.buffers[&(0, 1)], counts);
}

/// After how many rounds the point (x, y) escapes.
fn escape(x: f32, y: f32, limit: u32) -> u32 {
    let (mut a, mut b) = (0.0f32, 0.0f32);
    (0..limit)
        .find(|_| {
            let escaped = a * a + b * b > 4.0;
            (a, b) = (a * a - b * b + x, 2.0 * a * b + y);
            escaped
        })
        .unwrap_or(limit)
}
