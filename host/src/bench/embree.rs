//! Embree 3.13 (Debian: libembree-dev), robust, at medium quality: the few functions that a comparison needs.

use super::BenchError;
use super::contender::{Contender, either};
use parallax_shared::layout::{Hit, NONE, Ray, Triangle};
use std::ffi::c_void;
use std::ptr::{NonNull, null};

#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct RtcRay {
    origin: [f32; 3],
    t_near: f32,
    dir: [f32; 3],
    time: f32,
    t_far: f32,
    mask: u32,
    id: u32,
    flags: u32,
}

#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct RtcHit {
    normal: [f32; 3],
    u: f32,
    v: f32,
    prim_id: u32,
    geom_id: u32,
    instance_id: u32,
}

#[repr(C, align(16))]
struct RtcRayHit {
    ray: RtcRay,
    hit: RtcHit,
}

/// `RTCIntersectContext`, with room for what a version may add.
#[repr(C)]
struct Context {
    flags: u32,
    filter: *const c_void,
    instance: u32,
    min_width: f32,
    room: [u32; 8],
}

const TRIANGLES: u32 = 0;
const ROBUST: u32 = 4;
const MEDIUM: u32 = 1;
const INDICES: u32 = 0;
const VERTICES: u32 = 1;
const FLOAT3: u32 = 0x9003;
const UINT3: u32 = 0x5003;

type Handle = *mut c_void;

// SAFETY: as `embree3/rtcore.h` declares them.
unsafe extern "C" {
    fn rtcNewDevice(config: *const i8) -> Handle;
    fn rtcReleaseDevice(device: Handle);
    fn rtcNewScene(device: Handle) -> Handle;
    fn rtcReleaseScene(scene: Handle);
    fn rtcSetSceneFlags(scene: Handle, flags: u32);
    fn rtcSetSceneBuildQuality(scene: Handle, quality: u32);
    fn rtcNewGeometry(device: Handle, kind: u32) -> Handle;
    fn rtcReleaseGeometry(geometry: Handle);
    fn rtcSetNewGeometryBuffer(
        geometry: Handle,
        kind: u32,
        slot: u32,
        format: u32,
        stride: usize,
        count: usize,
    ) -> Handle;
    fn rtcCommitGeometry(geometry: Handle);
    fn rtcAttachGeometry(scene: Handle, geometry: Handle) -> u32;
    fn rtcCommitScene(scene: Handle);
    fn rtcIntersect1(scene: Handle, context: *mut Context, ray: *mut RtcRayHit);
    fn rtcOccluded1(scene: Handle, context: *mut Context, ray: *mut RtcRay);
}

/// A scene of one mesh.
pub struct Scene {
    device: NonNull<c_void>,
    scene: NonNull<c_void>,
}

fn made(handle: Handle, what: &str) -> Result<NonNull<c_void>, BenchError> {
    NonNull::new(handle).ok_or_else(|| BenchError::Embree(format!("it makes no {what}")))
}

impl Scene {
    /// Builds it.
    ///
    /// # Errors
    /// If Embree makes nothing.
    pub fn new(triangles: &[Triangle]) -> Result<Self, BenchError> {
        // SAFETY: handles are used in the order that Embree documents; the buffers that it makes have the sizes that were asked for.
        unsafe {
            let device = made(rtcNewDevice(null()), "device")?;
            let this = Self { device, scene: made(rtcNewScene(device.as_ptr()), "scene")? };
            let scene = this.scene.as_ptr();
            rtcSetSceneFlags(scene, ROBUST);
            rtcSetSceneBuildQuality(scene, MEDIUM);
            let geometry = made(rtcNewGeometry(device.as_ptr(), TRIANGLES), "geometry")?.as_ptr();
            let buffer = |kind, format, count| rtcSetNewGeometryBuffer(geometry, kind, 0, format, 12, count);
            let vertices =
                made(buffer(VERTICES, FLOAT3, 3 * triangles.len()), "buffer")?.cast::<[[f32; 3]; 3]>();
            let indices = made(buffer(INDICES, UINT3, triangles.len()), "buffer")?.cast::<[u32; 3]>();
            for (i, triangle) in triangles.iter().enumerate() {
                let first = 3 * i as u32;
                vertices.add(i).write(triangle.vertices);
                indices.add(i).write([first, first + 1, first + 2]);
            }
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(scene, geometry);
            rtcReleaseGeometry(geometry);
            rtcCommitScene(scene);
            Ok(this)
        }
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        // SAFETY: both were made by `new` and are released once.
        unsafe {
            rtcReleaseScene(self.scene.as_ptr());
            rtcReleaseDevice(self.device.as_ptr());
        }
    }
}

fn rtc_ray(ray: &Ray) -> RtcRay {
    let Ray { origin, t_min, dir, t_max } = *ray;
    RtcRay { origin, t_near: t_min, dir, time: 0.0, t_far: t_max, mask: !0, id: 0, flags: 0 }
}

impl Contender for Scene {
    fn name(&self) -> String {
        "Embree robust".into()
    }

    fn instruction_set(&self) -> &'static str {
        "Embree's choice"
    }

    fn trace(&self, rays: &[Ray], any: bool, hits: &mut [Hit]) {
        let mut context = Context { flags: 0, filter: null(), instance: NONE, min_width: 0.0, room: [0; 8] };
        let scene = self.scene.as_ptr();
        for (ray, hit) in rays.iter().zip(hits) {
            let mut ray = rtc_ray(ray);
            if any {
                // SAFETY: the scene is committed, ray and context are as Embree lays them out.
                unsafe { rtcOccluded1(scene, &mut context, &mut ray) };
                *hit = either(ray.t_far < 0.0);
                continue;
            }
            let none =
                RtcHit { normal: [0.0; 3], u: 0.0, v: 0.0, prim_id: NONE, geom_id: NONE, instance_id: NONE };
            let mut query = RtcRayHit { ray, hit: none };
            // SAFETY: as above.
            unsafe { rtcIntersect1(scene, &mut context, &mut query) };
            *hit = Hit { t: query.ray.t_far, prim_id: query.hit.prim_id };
        }
    }
}
