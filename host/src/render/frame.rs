//! A whole frame.

use super::band::{Band, Values};
use super::stereo::Plan;
use super::stereo::maps::PixelMaps;
use super::stereo::statistics::{StereoReport, StereoStatistics};
use super::{
    RayTotals, RenderError, Renderer, SceneData, StageTime, StereoImages, StereoOptions, ViewImages,
};
use crate::backend::Backend;
use parallax_shared::camera;
use parallax_shared::layout::{NONE, View};

/// The images of a scene, and what they took.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Both views.
    pub images: StereoImages,
    /// Rays that were traced.
    pub rays: RayTotals,
    /// What the second view was made of, if it was made from the first.
    pub stereo: Option<StereoReport>,
    /// What became of each pixel.
    pub maps: PixelMaps,
    /// Time of each stage, the upload of the scene included.
    pub times: Vec<StageTime>,
}

/// Renders the scene on `backend`, band by band. `progress` is told after each band how many of how many rows
/// are done.
///
/// # Errors
/// When options do not go together, the backend fails, or there is not enough memory for the images.
pub fn render<B: Backend>(
    backend: &mut B,
    data: &SceneData,
    options: &StereoOptions,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Frame, RenderError> {
    let plan = Plan::new(data, options, true)?;
    let mut images = allocate(data)?;
    let (mut rays, mut maps) = (RayTotals::default(), PixelMaps::default());
    let mut statistics = None;
    let mut renderer = Renderer::new(backend, data)?;
    let [width, height] = [images.width, images.height];
    let bands: Vec<_> = Band::of_picture(height, renderer.suggested_rows(&plan)).collect();
    let total = u64::from(height);
    let [first, other] = options.first.eyes();
    for band in bands {
        let pair = renderer.pair(&plan, band)?;
        if let Some(band) = StereoStatistics::of_band(&pair) {
            *statistics.get_or_insert_default() += band;
        }
        let (source, second) = (&pair.source, &pair.second);
        maps.append(&plan, &pair);
        source.rays().chain(second.rays()).for_each(|stage| rays += stage);
        append(&mut images.views[first], source, &data.views[first], band, data.scale);
        append(&mut images.views[other], second, &data.views[other], band, data.scale);
        progress(u64::from(band.first_row + band.rows), total);
    }
    debug_assert_eq!(images.views[0].t.len(), width as usize * height as usize);
    let stereo = statistics.map(|statistics| StereoReport::new(data, &plan, &statistics));
    Ok(Frame { images, rays, stereo, maps, times: renderer.finish() })
}

fn allocate(data: &SceneData) -> Result<StereoImages, RenderError> {
    let View { width, height, .. } = data.views[0];
    let pixels = width as usize * height as usize;
    let mut images = StereoImages { width, height, ..StereoImages::default() };
    for view in &mut images.views {
        view.reserve(pixels).map_err(|_| RenderError::Memory { width, height })?;
    }
    Ok(images)
}

/// Puts the values of a band, the next one, behind those that the images have. Distances become world units.
fn append(image: &mut ViewImages, values: &Values, view: &View, band: Band, scale: f32) {
    image.colour.extend(values.colour().iter().map(|[red, green, blue, _]| [*red, *green, *blue]));
    image.prim_id.extend(values.hits.iter().map(|hit| hit.prim_id));
    image.normal.extend(values.surfaces.iter().map(|surface| surface.shading_normal));
    image.disparity.extend(values.surfaces.iter().map(|surface| surface.disparity));
    let columns = view.width;
    for (index, hit) in (0_u32..).zip(&values.hits) {
        let (x, y) = (index % columns, band.first_row + index / columns);
        image.t.push(if hit.prim_id == NONE { f32::INFINITY } else { distance(view, x, y, hit.t, scale) });
    }
}

/// `t` counts in lengths of the ray's direction, which ends on the zero-parallax plane; this is the way in
/// world units.
fn distance(view: &View, x: u32, y: u32, t: f32, scale: f32) -> f32 {
    let direction = camera::pixel_direction(view, x, y).as_dvec3();
    (f64::from(t) * direction.length() / f64::from(scale)) as f32
}
