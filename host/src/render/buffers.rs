//! A scene on a backend.

use super::{RenderError, SceneData};
use crate::backend::Backend;
use kernel_api::Buffer;
use parallax_shared::layout::{Record, Row, Triangle};

/// The buffers of a scene, uploaded once and read by every pass.
#[derive(Clone, Copy)]
pub struct SceneBuffers {
    /// The acceleration structure.
    pub rows: Buffer<Row>,
    /// Triangles, for shading.
    pub triangles: Buffer<Triangle>,
    /// Spheres, ellipsoids, materials, lights and textures.
    pub records: Buffer<Record>,
    /// Texels of all textures.
    pub texels: Buffer<[f32; 4]>,
}

impl SceneBuffers {
    /// Uploads `data`.
    ///
    /// # Errors
    /// When there is not enough memory or a buffer is larger than the backend supports.
    pub fn upload<B: Backend>(backend: &mut B, data: &SceneData) -> Result<Self, RenderError> {
        Ok(Self {
            rows: backend.upload("acceleration structure", &data.rows)?,
            triangles: backend.upload("triangles", &data.triangles)?,
            records: backend.upload("spheres, materials and lights", &data.records)?,
            texels: backend.upload("textures", &data.texels)?,
        })
    }

    /// Gives the memory back.
    pub fn release<B: Backend>(self, backend: &mut B) {
        backend.release(self.rows);
        backend.release(self.triangles);
        backend.release(self.records);
        backend.release(self.texels);
    }
}
