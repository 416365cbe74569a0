//! Which effects a scene calls for, as bits: a specialisation constant on a GPU, where the code of what is
//! off disappears, and a value to branch on for a CPU (DESIGN §5).

use crate::layout::{Material, NONE, SceneInfo, Triangle};

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effects(pub u32);

impl Effects {
    /// None of them: everything is flat and black but for the sky's gradient and ambient light.
    pub const NONE: Self = Self(0);
    /// Point lights: diffuse reflection and shadow rays.
    pub const LIGHTS: Self = Self(1);
    /// Phong's specular term.
    pub const SPECULAR: Self = Self(1 << 1);
    /// Rays in mirror direction.
    pub const REFLECTION: Self = Self(1 << 2);
    /// Rays through surfaces. Implies [`Self::REFLECTION`], which total reflection needs.
    pub const REFRACTION: Self = Self(1 << 3);
    /// Bitmap textures on surfaces.
    pub const TEXTURES: Self = Self(1 << 4);
    /// Checkerboards.
    pub const CHECKERBOARD: Self = Self(1 << 5);
    /// An equirectangular sky instead of the gradient.
    pub const SKY_MAP: Self = Self(1 << 6);
    /// Triangles.
    pub const TRIANGLES: Self = Self(1 << 7);
    /// Normals interpolated across triangles.
    pub const SMOOTH_NORMALS: Self = Self(1 << 8);
    /// Spheres.
    pub const SPHERES: Self = Self(1 << 9);
    /// Ellipsoids.
    pub const ELLIPSOIDS: Self = Self(1 << 10);
    /// All of them; what a module is before it is specialised.
    pub const ALL: Self = Self((1 << 11) - 1);

    /// Each effect with its name.
    pub const NAMES: [(Self, &'static str); 11] = [
        (Self::LIGHTS, "lights"),
        (Self::SPECULAR, "specular"),
        (Self::REFLECTION, "reflection"),
        (Self::REFRACTION, "refraction"),
        (Self::TEXTURES, "textures"),
        (Self::CHECKERBOARD, "checkerboard"),
        (Self::SKY_MAP, "sky map"),
        (Self::TRIANGLES, "triangles"),
        (Self::SMOOTH_NORMALS, "smooth normals"),
        (Self::SPHERES, "spheres"),
        (Self::ELLIPSOIDS, "ellipsoids"),
    ];

    /// Whether all of `other` are in this set.
    #[inline(always)]
    pub fn has(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Both sets together.
    #[inline(always)]
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// `other` if `condition` holds, nothing otherwise, added to this set.
    #[inline]
    #[must_use]
    fn with_if(self, condition: bool, other: Self) -> Self {
        if condition { self.with(other) } else { self }
    }

    /// What a scene calls for: what can add something to some pixel. Materials that no primitive uses count too.
    #[inline]
    pub fn of_scene(info: &SceneInfo, materials: &[Material], triangles: &[Triangle]) -> Self {
        let seen =
            materials.iter().fold(Self::NONE, |seen, material| seen.with(Self::of_material(material, info)));
        seen.with_if(info.sky_texture != NONE, Self::SKY_MAP)
            .with_if(info.triangles > 0, Self::TRIANGLES)
            .with_if(triangles.iter().any(|triangle| triangle.smooth != 0), Self::SMOOTH_NORMALS)
            .with_if(info.spheres > 0, Self::SPHERES)
            .with_if(info.ellipsoids > 0, Self::ELLIPSOIDS)
    }

    #[inline]
    fn of_material(material: &Material, info: &SceneInfo) -> Self {
        let (lit, bounces) = (info.lights > 0, info.max_depth > 0);
        let transmits = bounces && material.transmission > 0.0;
        Self::NONE
            .with_if(lit && (material.diffuse > 0.0 || material.specular > 0.0), Self::LIGHTS)
            .with_if(lit && material.specular > 0.0, Self::SPECULAR)
            .with_if(transmits || (bounces && material.reflection > 0.0), Self::REFLECTION)
            .with_if(transmits, Self::REFRACTION)
            .with_if(material.texture != NONE, Self::TEXTURES)
            .with_if(material.checker_scale > 0.0, Self::CHECKERBOARD)
    }
}
