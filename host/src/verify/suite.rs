//! What every case needs: both backends, a comparison of their bits, and a tally of what held.

use crate::backend::{Backend, BackendError, Cpu, Gpu, Profile};
use crate::build::{Bvh, Quality, build};
use crate::compare::StageReport;
use crate::diff;
use crate::render::band::{Band, Pair};
use crate::render::stereo::Plan;
use crate::render::{RenderError, Renderer, SceneData, StereoOptions};
use crate::verify::input::numbers::is_same;
use crate::verify::input::reference::Reference;
use crate::verify::input::stage::{Stage, Stages};
use bytemuck::Pod;
use kernel_api::Buffer;
use parallax_kernels::arithmetic::Arithmetic;
use parallax_kernels::rays::{OccludedRays, TraceRays};
use parallax_shared::layout::{Ellipsoid, Hit, NONE, Ray, Sphere, Triangle};

/// Numbers that one run of [`Suite::values`] takes at most.
pub const CHUNK: usize = 1 << 20;

/// What came of a case.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// How many rays, pixels or numbers were tried.
    pub tried: u64,
    /// How many checks did not hold.
    pub failures: u64,
    /// What the first of them says.
    pub first_failure: Option<String>,
    /// Whether a device took part.
    pub on_device: bool,
}

impl Tally {
    /// Notes a failure, told by `failure`, unless `holds`.
    pub fn check(&mut self, holds: bool, failure: impl FnOnce() -> String) {
        if !holds {
            self.failures += 1;
            self.first_failure.get_or_insert_with(failure);
        }
    }
}

/// What is told while a case runs: how much of how much is done.
pub type Progress<'a> = &'a mut dyn FnMut(u64, u64);

/// A case's backends and its tally.
pub struct Suite<'a> {
    /// The processor, which every result is compared with.
    pub cpu: &'a mut Cpu,
    gpu: Option<&'a mut Gpu>,
    /// Whether cases that have a range try all of it.
    pub full: bool,
    tally: Tally,
    progress: Progress<'a>,
}

impl<'a> Suite<'a> {
    /// A suite on the processor, and on `gpu` if there is one, whose profile is the strict one.
    pub fn new(cpu: &'a mut Cpu, gpu: Option<&'a mut Gpu>, full: bool, progress: Progress<'a>) -> Self {
        Self { cpu, gpu, full, tally: Tally::default(), progress }
    }

    /// What came of it all.
    pub fn into_tally(self) -> Tally {
        self.tally
    }

    /// Notes a failure, told by `failure`, unless `holds`.
    pub fn check(&mut self, holds: bool, failure: impl FnOnce() -> String) {
        self.tally.check(holds, failure);
    }

    /// Counts cases.
    pub fn tried(&mut self, cases: usize) {
        self.tally.tried += cases as u64;
    }

    /// Tells that `done` of `total` parts of this case are done.
    pub fn done(&mut self, done: u64, total: u64) {
        (self.progress)(done, total);
    }

    /// Does the same on the processor and on the device.
    pub fn both<T>(
        &mut self,
        on_cpu: impl FnOnce(&mut Cpu) -> Result<T, RenderError>,
        on_gpu: impl FnOnce(&mut Gpu) -> Result<T, RenderError>,
    ) -> Result<(T, Option<T>), RenderError> {
        let made = on_cpu(self.cpu)?;
        let Some(gpu) = self.gpu.as_deref_mut() else { return Ok((made, None)) };
        self.tally.on_device = true;
        Ok((made, Some(on_gpu(gpu)?)))
    }

    /// The nearest hits, whose bits are compared, as is what is occluded.
    pub fn hits(&mut self, bvh: &Bvh, rays: &[Ray]) -> Result<Vec<Hit>, RenderError> {
        let ((hits, occluded), other) =
            self.both(|cpu| Ok(trace(cpu, bvh, rays)?), |gpu| Ok(trace(gpu, bvh, rays)?))?;
        for ((hit, hidden), ray) in hits.iter().zip(&occluded).zip(rays) {
            self.check((hit.prim_id != NONE) == (*hidden == 1), || format!("{ray:?}: {hit:?}, not occluded"));
        }
        if let Some((others, other_occluded)) = other {
            for ((a, b), ray) in hits.iter().zip(&others).zip(rays) {
                let is_same = (a.t.to_bits(), a.prim_id) == (b.t.to_bits(), b.prim_id);
                self.check(is_same, || format!("CPU and GPU: {ray:?}: {a:?} and {b:?}"));
            }
            for ((a, b), ray) in occluded.iter().zip(&other_occluded).zip(rays) {
                self.check(a == b, || format!("CPU and GPU: {ray:?}: occluded {a} and {b}"));
            }
        }
        Ok(hits)
    }

    /// The nearest hits, compared with brute force, whose edge signs are exact; +0 and −0 are one `t`.
    pub fn brute_force(&mut self, triangles: &[Triangle], rays: &[Ray]) -> Result<Vec<Hit>, RenderError> {
        let bvh = structure(triangles, &[], &[])?;
        let found = self.hits(&bvh, rays)?;
        for (ray, hit) in rays.iter().zip(&found) {
            let expected = Reference::new(*ray, bvh.extent).brute_force(triangles).0;
            let bits = |hit: &Hit| ((hit.t + 0.0).to_bits(), hit.prim_id);
            self.check(bits(hit) == bits(&expected), || format!("{ray:?}: {hit:?}, not {expected:?}"));
        }
        Ok(found)
    }

    /// What the passes make of a stage, compared bit by bit.
    pub fn stages(&mut self, stage: &Stage) -> Result<Stages, RenderError> {
        let (made, other) = self.both(|cpu| stage.render(cpu), |gpu| stage.render(gpu))?;
        if let Some(other) = other {
            for (what, is_same) in made.compare(&other) {
                self.check(is_same, || format!("{what} on CPU and GPU"));
            }
        }
        Ok(made)
    }

    /// Both views of a scene on the processor, as one band.
    pub fn pair(&mut self, data: &SceneData, options: &StereoOptions) -> Result<Pair, RenderError> {
        pair(self.cpu, data, options)
    }

    /// Compares every stage of both views of a scene on both backends. Counts the elements; without a device nothing.
    pub fn compare_pair(
        &mut self,
        name: &str,
        data: &SceneData,
        options: &StereoOptions,
    ) -> Result<(), RenderError> {
        let Some(gpu) = self.gpu.as_deref_mut() else { return Ok(()) };
        self.tally.on_device = true;
        let stages = diff::stages(self.cpu, gpu, data, options, Profile::Strict, &mut |_, _| {})?;
        for StageReport { view, stage, elements, differing, equal, .. } in stages {
            self.tried(elements);
            let method = options.method.name();
            self.check(equal, || format!("{name}, {method}, {view} view, {stage}: {differing} differ"));
        }
        Ok(())
    }

    /// An operation of [`parallax_kernels::arithmetic`] on each pair of words: on the processor, and on the device.
    pub fn values(
        &mut self,
        operation: u32,
        a: &[u32],
        b: &[u32],
    ) -> Result<(Vec<u32>, Option<Vec<u32>>), RenderError> {
        self.both(|cpu| Ok(values(cpu, operation, a, b)?), |gpu| Ok(values(gpu, operation, a, b)?))
    }

    /// The same, compared bit by bit; all NaN are one. Counts the pairs and returns the processor's results.
    pub fn same_values(
        &mut self,
        name: &str,
        operation: u32,
        a: &[u32],
        b: &[u32],
    ) -> Result<Vec<u32>, RenderError> {
        let (results, others) = self.values(operation, a, b)?;
        for (i, (result, other)) in results.iter().zip(others.iter().flatten()).enumerate() {
            self.check(is_same(*result, *other), || {
                format!("{name} of {:08x} and {:08x}: CPU {result:08x}, GPU {other:08x}", a[i], b[i])
            });
        }
        self.tried(a.len());
        Ok(results)
    }
}

/// A structure over primitives.
pub fn structure(
    triangles: &[Triangle],
    spheres: &[Sphere],
    ellipsoids: &[Ellipsoid],
) -> Result<Bvh, RenderError> {
    Ok(build(triangles, spheres, ellipsoids, Quality::Full)?)
}

/// Both views of a scene, as one band.
///
/// # Errors
/// When the options do not go together, or the backend fails.
pub fn pair<B: Backend>(
    backend: &mut B,
    data: &SceneData,
    options: &StereoOptions,
) -> Result<Pair, RenderError> {
    let plan = Plan::new(data, options, true)?;
    let band = Band { first_row: 0, rows: data.views[0].height };
    Renderer::new(backend, data)?.pair(&plan, band)
}

/// The nearest hit of each ray, and 1 for each that hits anything, by the passes for rays.
///
/// # Errors
/// When the backend fails.
pub fn trace<B: Backend>(
    backend: &mut B,
    bvh: &Bvh,
    rays: &[Ray],
) -> Result<(Vec<Hit>, Vec<u32>), BackendError> {
    let given = backend.upload("rays", rays)?;
    let rows = backend.upload("rows", &bvh.rows)?;
    let hits = backend.create("hits", rays.len())?;
    let occluded = backend.create("occluded", rays.len())?;
    let (extent, groups) = (bvh.extent, [rays.len() as u32, 1, 1]);
    backend.run(&TraceRays { rays: given, rows, extent, hits }, groups)?;
    backend.run(&OccludedRays { rays: given, rows, extent, occluded }, groups)?;
    backend.release(given);
    backend.release(rows);
    Ok((take(backend, hits)?, take(backend, occluded)?))
}

/// An operation of [`parallax_kernels::arithmetic`] on each pair of words, on one backend.
///
/// # Errors
/// When the backend fails.
pub fn values<B: Backend>(
    backend: &mut B,
    operation: u32,
    a: &[u32],
    b: &[u32],
) -> Result<Vec<u32>, BackendError> {
    let (words_a, words_b) = (backend.upload("a", a)?, backend.upload("b", b)?);
    let results = backend.create("results", a.len())?;
    backend.run(&Arithmetic { a: words_a, b: words_b, results, operation }, [a.len() as u32, 1, 1])?;
    let read = take(backend, results);
    backend.release(words_a);
    backend.release(words_b);
    read
}

/// Reads a buffer and gives it back.
fn take<B: Backend, T: Pod>(backend: &mut B, buffer: Buffer<T>) -> Result<Vec<T>, BackendError> {
    let read = backend.read(buffer);
    backend.release(buffer);
    read
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_hold_is_counted_and_the_first_is_told() {
        let mut tally = Tally::default();
        tally.check(true, || unreachable!("what holds is not told"));
        assert_eq!(tally.failures, 0);
        tally.check(false, || "one".into());
        tally.check(false, || "two".into());
        assert_eq!((tally.failures, tally.first_failure.as_deref()), (2, Some("one")));
    }
}
