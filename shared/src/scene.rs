//! What a pass sees of a scene: a bundle of slices, which disappears when it is inlined.

use crate::effects::Effects;
use crate::layout::{Ellipsoid, Light, Material, Record, Row, SceneInfo, Sphere, Texture, Triangle};
use bytemuck::must_cast;
use kernel_api::At;

/// A scene as its buffers hold it.
#[derive(Clone, Copy)]
pub struct SceneView<'a> {
    /// Counts, offsets, ambient light and sky.
    pub info: &'a SceneInfo,
    /// The acceleration structure.
    pub rows: &'a [Row],
    /// Triangles, for shading.
    pub triangles: &'a [Triangle],
    /// Everything small; see [`Record`].
    pub records: &'a [Record],
    /// Linear texels of all textures.
    pub texels: &'a [[f32; 4]],
    /// Which effects are on.
    pub effects: Effects,
}

/// `N` records from `first` on.
#[inline(always)]
fn block<const N: usize>(records: &[Record], first: u32) -> [Record; N] {
    core::array::from_fn(|i| records.at(first + i as u32))
}

impl SceneView<'_> {
    /// Sphere `i`, counted from the first sphere.
    #[inline(always)]
    pub fn sphere(&self, i: u32) -> Sphere {
        must_cast(block::<2>(self.records, i * 2))
    }

    /// Ellipsoid `i`, counted from the first ellipsoid.
    #[inline(always)]
    pub fn ellipsoid(&self, i: u32) -> Ellipsoid {
        must_cast(block::<4>(self.records, self.info.first_ellipsoid + i * 4))
    }

    /// Material `i`.
    #[inline(always)]
    pub fn material(&self, i: u32) -> Material {
        must_cast(block::<4>(self.records, self.info.first_material + i * 4))
    }

    /// Light `i`.
    #[inline(always)]
    pub fn light(&self, i: u32) -> Light {
        must_cast(block::<2>(self.records, self.info.first_light + i * 2))
    }

    /// Texture `i`.
    #[inline(always)]
    pub fn texture(&self, i: u32) -> Texture {
        must_cast(block::<1>(self.records, self.info.first_texture + i))
    }
}
