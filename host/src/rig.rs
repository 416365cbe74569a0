//! The off-axis stereo rig (Al-Hagri 2012, §2.3.2; Adelson and Hodges 1993): two eyes that look the same way,
//! each through the same window in one common plane.
//!
//! With the picture plane at distance d, W world units wide and w pixels across, a pixel is s = W/w wide. The
//! eyes stand e·s apart (e in pixels), e·s/2 to either side of the point between them, and both see the
//! window around the axis through that point. From similar triangles, a point at depth z behind the plane is
//! seen at x_left = (x·d − z·e/2) / (d + z) and x_right = (x·d + z·e/2) / (d + z) (001 eq. (3) and (5); 000
//! eq. (2) and (4) have lost the factor d), so x_right − x_left = e·z / (d + z), in pixels.

use parallax_shared::layout::View;
use thiserror::Error;

/// Width in metres of the display that the guide of eq. (12) is checked for unless another one is named: 24
/// inches, 16:9.
pub const DISPLAY_WIDTH: f32 = 0.531;

/// Distance in metres between a viewer's eyes, on average (000 §2.3.2).
pub const INTEROCULAR: f32 = 0.065;

/// Largest number of columns or rows.
pub const MAX_SIDE: u32 = 32_768;

/// Two eyes side by side that look the same way at one common picture plane.
#[derive(Clone, Debug, PartialEq)]
pub struct StereoRig {
    /// The point midway between the eyes, world space.
    pub eye: [f32; 3],
    /// The point looked at, world space.
    pub target: [f32; 3],
    /// A direction that is up in the picture, any length, not parallel to the line of sight.
    pub up: [f32; 3],
    /// Full vertical angle of view, degrees.
    pub vertical_fov_deg: f32,
    /// Columns of each picture.
    pub width: u32,
    /// Rows of each picture.
    pub height: u32,
    /// Distance between the eyes in pixels of the zero-parallax plane (e of the papers).
    pub interaxial_px: f32,
    /// Distance to the zero-parallax plane in world units (d of the papers).
    pub zero_parallax: f32,
}

/// What is wrong with a rig.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RigError {
    /// A number that is NaN or infinite.
    #[error("camera: `{0}` is not a finite number")]
    NotFinite(&'static str),
    /// Nothing to look at.
    #[error("camera: `eye` and `target` are the same point")]
    NoDirection,
    /// No idea what is up.
    #[error("camera: `up` is zero or parallel to the line of sight")]
    NoUp,
    /// An angle of view that no plane picture has.
    #[error("camera: the vertical angle of view is {0}°, expected more than 0° and less than 180°")]
    FieldOfView(f32),
    /// A picture without pixels or with too many.
    #[error("camera: a picture of {0} × {1} pixels, expected 1 to {MAX_SIDE} either way")]
    Size(u32, u32),
    /// Eyes that would be swapped.
    #[error("camera: the interaxial distance is {0} pixels, expected zero or more")]
    Interaxial(f32),
    /// No plane to look at.
    #[error("camera: the zero-parallax distance is {0}, expected more than zero")]
    ZeroParallax(f32),
    /// A rig so large or small beside the scene that a view's numbers leave the range of f32.
    #[error("camera: its numbers leave the range of 32-bit floats")]
    Range,
}

type Vector = [f64; 3];

fn wide(v: [f32; 3]) -> Vector {
    v.map(f64::from)
}

/// `a` + `b`·`t`.
fn add(a: Vector, b: Vector, t: f64) -> Vector {
    std::array::from_fn(|i| a[i] + b[i] * t)
}

fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

/// `v` with length 1, if it has a length that is more than rounding left over from a vector of length `scale`.
fn unit(v: Vector, scale: f64) -> Option<Vector> {
    let length = length(v);
    (length > scale * 1e-7).then(|| v.map(|c| c / length))
}

fn length(v: Vector) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// Axes of the picture.
struct Frame {
    right: Vector,
    up: Vector,
    forward: Vector,
}

impl StereoRig {
    /// The left and the right eye's view of a scene that has been scaled by `scale` (a power of two, so that
    /// it changes no digit); each with the whole picture as its band.
    ///
    /// With e = 0 both are the same, bit for bit, as the view from the point between them.
    ///
    /// # Errors
    /// When the rig describes no picture; see [`RigError`].
    pub fn views(&self, scale: f32) -> Result<[View; 2], RigError> {
        self.check()?;
        let frame = self.frame()?;
        let views = [-0.5, 0.5].map(|side| self.view(&frame, side, f64::from(scale)));
        let numbers = |v: &View| [v.eye, v.corner, v.step_x, v.step_y, [v.distance, v.interaxial_px, 0.0]];
        if views.iter().flat_map(numbers).flatten().any(|x| !x.is_finite())
            || views[0].distance < f32::MIN_POSITIVE
        {
            return Err(RigError::Range);
        }
        Ok(views)
    }

    /// The warning of 000 §2.3.2, eq. (12), e / w < e_real / w_display, when this rig breaks it on a display
    /// that is `display_width` metres wide: points far away would be further apart on it than a viewer's
    /// eyes, which cannot diverge.
    pub fn guide_warning(&self, display_width: f32) -> Option<String> {
        let (share, allowed) = (self.interaxial_px / self.width as f32, INTEROCULAR / display_width);
        (share >= allowed).then(|| {
            format!(
                "an interaxial distance of {} pixels is {:.1} % of the picture's width; on a display {display_width} m wide it must stay \
                 below {:.1} % ({:.0} pixels) for eyes {INTEROCULAR} m apart",
                self.interaxial_px,
                100.0 * share,
                100.0 * allowed,
                (allowed * self.width as f32).floor(),
            )
        })
    }

    fn check(&self) -> Result<(), RigError> {
        let points = [("eye", self.eye), ("target", self.target), ("up", self.up)];
        if let Some((name, _)) = points.iter().find(|(_, v)| v.iter().any(|c| !c.is_finite())) {
            return Err(RigError::NotFinite(name));
        }
        if !(self.vertical_fov_deg > 0.0 && self.vertical_fov_deg < 180.0) {
            return Err(RigError::FieldOfView(self.vertical_fov_deg));
        }
        if !(1..=MAX_SIDE).contains(&self.width) || !(1..=MAX_SIDE).contains(&self.height) {
            return Err(RigError::Size(self.width, self.height));
        }
        if !(self.interaxial_px >= 0.0 && self.interaxial_px.is_finite()) {
            return Err(RigError::Interaxial(self.interaxial_px));
        }
        if !(self.zero_parallax > 0.0 && self.zero_parallax.is_finite()) {
            return Err(RigError::ZeroParallax(self.zero_parallax));
        }
        Ok(())
    }

    fn frame(&self) -> Result<Frame, RigError> {
        let forward = add(wide(self.target), wide(self.eye), -1.0);
        let forward = unit(forward, 0.0).ok_or(RigError::NoDirection)?;
        let up = wide(self.up);
        let right = unit(cross(forward, up), length(up)).ok_or(RigError::NoUp)?;
        Ok(Frame { right, up: cross(right, forward), forward })
    }

    /// The view of the eye at `side` (−½ left, ½ right) of the distance between the eyes.
    fn view(&self, frame: &Frame, side: f64, scale: f64) -> View {
        let distance = f64::from(self.zero_parallax);
        let rows = f64::from(self.height);
        let pixel = 2.0 * distance * (0.5 * f64::from(self.vertical_fov_deg).to_radians()).tan() / rows;
        let aside = side * f64::from(self.interaxial_px) * pixel;
        let eye = add(wide(self.eye), frame.right, aside);
        // The centre of pixel (0, 0) as seen from this eye: the window stays where it is when the eye moves aside.
        let corner = add(
            frame.forward.map(|c| c * distance),
            frame.right,
            pixel * (0.5 - 0.5 * f64::from(self.width)) - aside,
        );
        let corner = add(corner, frame.up, pixel * (0.5 * rows - 0.5));
        // Adding zero turns −0 to +0, so that e = 0 gives the same bits on both sides.
        let narrow = |v: Vector| v.map(|c| (c * scale) as f32 + 0.0);
        View {
            eye: narrow(eye),
            width: self.width,
            corner: narrow(corner),
            height: self.height,
            step_x: narrow(frame.right.map(|c| c * pixel)),
            first_row: 0,
            step_y: narrow(frame.up.map(|c| -c * pixel)),
            rows: self.height,
            forward: frame.forward.map(|c| c as f32 + 0.0),
            distance: (distance * scale) as f32,
            interaxial_px: self.interaxial_px,
            jitter_seed: 0,
            spacing_log2: 0,
            refines: 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rig() -> StereoRig {
        StereoRig {
            eye: [1.0, 2.0, 5.0],
            target: [0.0, 1.0, -3.0],
            up: [0.0, 2.0, 0.1],
            vertical_fov_deg: 40.0,
            width: 320,
            height: 200,
            interaxial_px: 12.0,
            zero_parallax: 6.0,
        }
    }

    /// Where `view` sees the point, in pixels.
    fn project(view: &View, point: Vector) -> [f64; 2] {
        let to = add(point, wide(view.eye), -1.0);
        let dot = |a: Vector, b: Vector| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let to = to.map(|c| c * f64::from(view.distance) / dot(to, wide(view.forward)));
        let (from_corner, x, y) = (add(to, wide(view.corner), -1.0), wide(view.step_x), wide(view.step_y));
        [dot(from_corner, x) / dot(x, x), dot(from_corner, y) / dot(y, y)]
    }

    #[test]
    fn both_eyes_see_the_window_in_the_same_place_and_infinity_e_pixels_apart() {
        let [left, right] = rig().views(1.0).unwrap();
        let ahead = |x: f64, y: f64, t: f64| {
            let across = add(add(wide(left.corner), wide(left.step_x), x), wide(left.step_y), y);
            add(wide(left.eye), across, t)
        };
        for (x, y) in [(0.0, 0.0), (319.0, 0.0), (17.0, 199.0)] {
            for (t, disparity) in [(1.0, 0.0), (0.5, -12.0), (2.0, 6.0), (1e9, 12.0)] {
                let (l, r) = (project(&left, ahead(x, y, t)), project(&right, ahead(x, y, t)));
                assert!((l[0] - x).abs() < 1e-3 && (l[1] - y).abs() < 1e-3, "{l:?}");
                assert!((r[0] - l[0] - disparity).abs() < 1e-3, "t {t}: {l:?} {r:?}");
                assert!((r[1] - l[1]).abs() < 1e-3, "a point keeps its row");
                let computed = parallax_shared::camera::disparity_px(left.interaxial_px, t as f32);
                assert!((f64::from(computed) - disparity).abs() < 1e-4, "{computed}");
            }
        }
    }

    #[test]
    fn no_interaxial_distance_gives_the_view_between_the_eyes_bit_for_bit() {
        let mut mono = rig();
        mono.eye = [-0.0, 0.0, 4.0];
        mono.target = [-0.0, 0.0, 0.0];
        mono.up = [0.0, 1.0, 0.0];
        mono.interaxial_px = 0.0;
        let [left, right] = mono.views(0.25).unwrap();
        assert_eq!(bytemuck::bytes_of(&left), bytemuck::bytes_of(&right));
        assert_eq!(left.eye.map(f32::to_bits), [0.0, 0.0, 1.0].map(f32::to_bits));
    }

    #[test]
    fn scaling_by_a_power_of_two_changes_no_digit() {
        let ([one, _], [eighth, _]) = (rig().views(1.0).unwrap(), rig().views(0.125).unwrap());
        assert_eq!(eighth.corner, one.corner.map(|c| c * 0.125));
        assert_eq!(eighth.step_x, one.step_x.map(|c| c * 0.125));
        assert_eq!(eighth.eye, one.eye.map(|c| c * 0.125));
    }

    #[test]
    fn the_guide_warns_exactly_when_it_is_broken() {
        let mut rig = rig();
        assert_eq!(rig.guide_warning(DISPLAY_WIDTH), None, "12 of 320 pixels are 3.8 %, allowed 12.2 %");
        rig.interaxial_px = 39.0;
        assert_eq!(rig.guide_warning(DISPLAY_WIDTH), None);
        rig.interaxial_px = 40.0;
        assert!(rig.guide_warning(DISPLAY_WIDTH).unwrap().contains("39 pixels"));
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        let refuse = |change: fn(&mut StereoRig)| {
            let mut rig = rig();
            change(&mut rig);
            rig.views(1.0).unwrap_err()
        };
        assert_eq!(refuse(|r| r.target = r.eye), RigError::NoDirection);
        assert_eq!(refuse(|r| r.up = [-1.0, -1.0, -8.0]), RigError::NoUp);
        assert_eq!(refuse(|r| r.up = [0.0; 3]), RigError::NoUp);
        assert_eq!(refuse(|r| r.vertical_fov_deg = 180.0), RigError::FieldOfView(180.0));
        assert!(matches!(refuse(|r| r.vertical_fov_deg = f32::NAN), RigError::FieldOfView(_)));
        assert_eq!(refuse(|r| r.width = 0), RigError::Size(0, 200));
        assert_eq!(refuse(|r| r.interaxial_px = -1.0), RigError::Interaxial(-1.0));
        assert_eq!(refuse(|r| r.zero_parallax = 0.0), RigError::ZeroParallax(0.0));
        assert_eq!(refuse(|r| r.eye[1] = f32::INFINITY), RigError::NotFinite("eye"));
        assert_eq!(refuse(|r| (r.zero_parallax, r.vertical_fov_deg) = (3e38, 170.0)), RigError::Range);
        assert_eq!(refuse(|r| r.zero_parallax = 1e-40), RigError::Range);
    }
}
