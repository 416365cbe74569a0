//! Reflection and refraction.

use glam::{UVec3, Vec4};
use kernel_api::{At, Out, spirv};
use parallax_shared::camera;
use parallax_shared::effects::Effects;
use parallax_shared::layout::{RayCounts, Record, Row, SceneInfo, Surface, Triangle, View};
use parallax_shared::scene::SceneView;
use parallax_shared::shading::bounce::{is_whole, light_from};

/// Adds what surfaces reflect and refract to the colours that are not whole (`local`, of the pass `shade`); `counts` has the rays for it.
/// Pixels whose colours are whole get neither, and cost no more than the look at their colours.
#[spirv(compute(threads(8, 8, 1)))]
pub fn bounce(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] view: &View,
    #[spirv(uniform, descriptor_set = 0, binding = 1)] info: &SceneInfo,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] rows: &[Row],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] records: &[Record],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] texels: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] surfaces: &[Surface],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] local: &[[f32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 8)] colours: Out<[f32; 4]>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 9)] counts: Out<RayCounts>,
    #[spirv(spec_constant(id = 0, default = 0x7ff))] effects: u32,
) {
    if id.x < view.width && id.y < view.rows {
        let pixel = id.y * view.width + id.x;
        let own = local.at(pixel);
        if !is_whole(&own) {
            let scene = SceneView { info, rows, triangles, records, texels, effects: Effects(effects) };
            let dir = camera::pixel_direction(view, id.x, view.first_row + id.y);
            let (added, rays) = light_from(&scene, &surfaces.at(pixel), dir);
            colours.put(pixel, (Vec4::from_array(own) + added.extend(1.0)).to_array());
            counts.put(pixel, rays);
        }
    }
}
