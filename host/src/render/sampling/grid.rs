//! The points of a lattice over a picture, as a picture of their own.

use crate::render::RenderError;
use crate::rig::MAX_SIDE;
use glam::DVec3;
use parallax_shared::layout::{Lattice, View};

/// Seed of the jitter. A constant: each picture is the same whenever it is rendered.
const SEED: u32 = 0x9e37_79b9;

/// Where the points of a pixel are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Points from a pixel to the next one.
    pub per_pixel: u32,
    /// Whether pixels share the points of their edges; otherwise they have points of their own, jittered.
    pub shares_edges: bool,
    /// Whether the middle point of a pixel is reprojected for all of them.
    pub aims: bool,
    /// Levels beyond the first.
    pub levels: u32,
}

impl Grid {
    /// For the passes.
    pub fn lattice(&self, view: &View) -> Lattice {
        let shares_edges = self.shares_edges.into();
        Lattice { width: view.width, rows: view.rows, per_pixel: self.per_pixel, shares_edges }
    }

    /// The points of the band of `view` on a level: a view of theirs.
    pub fn view(&self, view: &View, level: u32) -> View {
        let n = self.per_pixel;
        let points = |pixels: u32| n * pixels + u32::from(self.shares_edges);
        let first = if self.shares_edges { -0.5 } else { 0.5 / f64::from(n) - 0.5 };
        let step = |step: [f32; 3]| (vector(step) / f64::from(n)).as_vec3().to_array();
        let corner = vector(view.corner) + (vector(view.step_x) + vector(view.step_y)) * first;
        View {
            width: points(view.width),
            height: points(view.height),
            rows: points(view.rows),
            first_row: n * view.first_row,
            corner: corner.as_vec3().to_array(),
            step_x: step(view.step_x),
            step_y: step(view.step_y),
            interaxial_px: view.interaxial_px * n as f32,
            jitter_seed: if self.shares_edges { 0 } else { SEED },
            spacing_log2: self.levels - level,
            refines: (level > 0).into(),
            ..*view
        }
    }

    /// The points of a whole picture.
    ///
    /// # Errors
    /// When they are too many.
    pub fn checked_view(&self, view: &View) -> Result<View, RenderError> {
        let (width, height) = (view.width, view.height);
        if self.per_pixel * width.max(height) >= MAX_SIDE {
            return Err(RenderError::Points { width, height, per_pixel: self.per_pixel });
        }
        Ok(self.view(view, 0))
    }

    /// The column of points that is not behind the pixels from `column` on; behind the last one if there are none.
    pub fn column_of(&self, column: u32, view: &View) -> u32 {
        if column < view.width { self.per_pixel * column.saturating_sub(1) } else { self.view(view, 0).width }
    }

    /// Invocations of a pass over the points of a level.
    pub fn invocations(points: &View) -> [u32; 3] {
        let steps = |points: u32, log2: u32| ((points - 1) >> log2) + 1;
        [steps(points.width, points.spacing_log2), steps(points.rows, points.spacing_log2), 1]
    }
}

fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::sampling::Samples;
    use bytemuck::Zeroable;
    use parallax_shared::camera::pixel_direction;

    const PICTURE: View = View {
        eye: [0.0; 3],
        width: 6,
        corner: [-2.5, 2.0, -4.0],
        height: 5,
        step_x: [1.0, 0.0, 0.0],
        first_row: 2,
        step_y: [0.0, -1.0, 0.0],
        rows: 3,
        forward: [0.0, 0.0, -1.0],
        distance: 4.0,
        interaxial_px: 3.0,
        jitter_seed: 0,
        spacing_log2: 0,
        refines: 0,
    };

    fn grid(samples: &str) -> Grid {
        samples.parse::<Samples>().unwrap().grid().unwrap()
    }

    #[test]
    fn the_middle_of_nine_is_the_pixels_centre_and_the_others_are_half_a_pixel_away() {
        let points = grid("nine").view(&PICTURE, 0);
        assert_eq!((points.width, points.height, points.rows, points.first_row), (13, 11, 7, 4));
        assert_eq!(pixel_direction(&points, 7, 5), pixel_direction(&PICTURE, 3, 2));
        assert_eq!(pixel_direction(&points, 0, 0).to_array(), [-3.0, 2.5, -4.0]);
        assert_eq!(pixel_direction(&points, 12, 10).to_array(), [3.0, -2.5, -4.0]);
    }

    #[test]
    fn jittered_points_stay_in_their_part() {
        let points = grid("4x4").view(&PICTURE, 0);
        assert_eq!((points.width, points.rows, points.interaxial_px), (24, 12, 12.0));
        for (x, y) in [(0, 0), (23, 19), (9, 4)] {
            let [px, py, _] = pixel_direction(&points, x, y).to_array();
            let (left, top) = (-3.0 + 0.25 * x as f32, 2.5 - 0.25 * y as f32);
            assert!(px > left && px < left + 0.25 && py < top && py > top - 0.25, "{x} {y}");
        }
    }

    #[test]
    fn levels_go_from_corners_to_every_point() {
        let grid = grid("adaptive-2");
        let [corners, halves, all] = [0, 1, 2].map(|level| grid.view(&PICTURE, level));
        assert_eq!(Grid::invocations(&corners), [7, 4, 1]);
        assert_eq!(Grid::invocations(&halves), [13, 7, 1]);
        assert_eq!(Grid::invocations(&all), [25, 13, 1]);
        assert_eq!((corners.refines, halves.refines, all.spacing_log2), (0, 1, 0));
    }

    #[test]
    fn too_many_points_are_refused() {
        let view = View { width: 8192, height: 10, ..Zeroable::zeroed() };
        assert!(grid("3x3").checked_view(&view).is_ok());
        let told = grid("4x4").checked_view(&view).unwrap_err().to_string();
        assert!(told.contains("8192 × 10"), "{told}");
    }

    #[test]
    fn strips_that_are_verified_are_not_cut() {
        let grid = grid("adaptive-1");
        assert_eq!([0, 3, 6].map(|column| grid.column_of(column, &PICTURE)), [0, 4, 13]);
    }
}
