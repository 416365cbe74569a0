//! What the points of a pixel say together.

use super::refine::Cell;
use crate::layout::{Lattice, RayCounts};
use crate::math::div;
use glam::Vec3;

/// Columns of a lattice.
#[inline(always)]
pub fn columns(lattice: &Lattice) -> u32 {
    lattice.width * lattice.per_pixel + lattice.shares_edges
}

/// The colour of pixel (`x`, `y`) of the band from those of its points; `is_sampled` tells which of them have one.
///
/// Points of the pixel's own count alike. Where they are shared, each cell that is not divided has the mean colour of its corners and
/// counts as its area (Whitted 1980, 001): of nine points the middle counts 1/4, those on the edges 1/8 and those at the corners 1/16.
#[inline(always)]
pub fn colour(
    lattice: &Lattice,
    x: u32,
    y: u32,
    colour: impl Fn(u32) -> Vec3,
    is_sampled: impl Fn(u32) -> bool,
) -> Vec3 {
    if lattice.shares_edges == 0 {
        return div(1.0, (lattice.per_pixel * lattice.per_pixel) as f32) * sum(lattice, x, y, colour);
    }
    let (mut total, mut weight, mut side) = (Vec3::ZERO, 0.25, lattice.per_pixel);
    while side > 0 {
        total += cells(lattice, [x, y], side, &colour, &is_sampled) * weight;
        weight *= 0.25;
        side >>= 1;
    }
    total
}

/// The sum over the corners of those cells of a size that are there and not divided.
#[inline(always)]
fn cells(
    lattice: &Lattice,
    [x, y]: [u32; 2],
    side: u32,
    colour: impl Fn(u32) -> Vec3,
    is_sampled: impl Fn(u32) -> bool,
) -> Vec3 {
    let (width, n) = (columns(lattice), lattice.per_pixel);
    let (mut total, mut down) = (Vec3::ZERO, 0);
    while down < n {
        let mut right = 0;
        while right < n {
            let cell = Cell { column: x * n + right, row: y * n + down, side };
            let is_there = side == n || is_sampled(cell.middle_of_parent(width));
            if is_there && (side == 1 || !is_sampled(cell.middle(width))) {
                let [a, b, c, d] = cell.corners(width).map(&colour);
                total += (a + b) + (c + d);
            }
            right += side;
        }
        down += side;
    }
    total
}

/// The sum over the pixel's own points.
#[inline(always)]
fn sum(lattice: &Lattice, x: u32, y: u32, colour: impl Fn(u32) -> Vec3) -> Vec3 {
    let (n, width) = (lattice.per_pixel, columns(lattice));
    let (mut total, mut down) = (Vec3::ZERO, 0);
    while down < n {
        let mut right = 0;
        while right < n {
            total += colour((y * n + down) * width + x * n + right);
            right += 1;
        }
        down += 1;
    }
    total
}

/// The rays of the points that count as those of pixel (`x`, `y`): each point is some pixel's, those of a shared edge of the pixel
/// behind it.
#[inline(always)]
pub fn rays(
    lattice: &Lattice,
    x: u32,
    y: u32,
    rays: impl Fn(u32) -> RayCounts,
    is_sampled: impl Fn(u32) -> bool,
) -> RayCounts {
    let [columns_of_pixel, rows_of_pixel] = own_points(lattice, x, y);
    let first = (y * columns(lattice) + x) * lattice.per_pixel;
    let mut total = RayCounts::NONE;
    let mut down = 0;
    while down < rows_of_pixel {
        let mut right = 0;
        while right < columns_of_pixel {
            let point = first + down * columns(lattice) + right;
            if is_sampled(point) {
                let more = rays(point);
                total.primary += more.primary;
                total.shadow += more.shadow;
                total.reflected += more.reflected;
                total.refracted += more.refracted;
            }
            right += 1;
        }
        down += 1;
    }
    total
}

/// How many points to the right and down a pixel has for itself: the last one of a line has those of the far edge too.
#[inline(always)]
fn own_points(lattice: &Lattice, x: u32, y: u32) -> [u32; 2] {
    let points = |is_last: bool| lattice.per_pixel + if is_last { lattice.shares_edges } else { 0 };
    [points(x + 1 == lattice.width), points(y + 1 == lattice.rows)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(per_pixel: u32, shares_edges: u32) -> Lattice {
        Lattice { width: 2, rows: 2, per_pixel, shares_edges }
    }

    #[test]
    fn own_points_count_alike() {
        let lattice = lattice(3, 0);
        let seen = colour(&lattice, 1, 1, |point| Vec3::splat(point as f32), |_| true);
        // Rows 3 to 5 and columns 3 to 5 of six.
        assert_eq!(seen, Vec3::splat(28.0));
    }

    #[test]
    fn nine_points_have_the_weights_of_their_areas() {
        let lattice = lattice(2, 1);
        let weight = |point: u32| colour(&lattice, 0, 0, |p| Vec3::splat(f32::from(p == point)), |_| true).x;
        let weights: Vec<_> =
            (0..3).flat_map(|y| (0..3).map(move |x| (x, y))).map(|(x, y)| weight(y * 5 + x)).collect();
        let (edge, corner) = (0.125, 0.0625);
        assert_eq!(weights, [corner, edge, corner, edge, 0.25, edge, corner, edge, corner]);
        assert_eq!(weight(3), 0.0, "the neighbour's");
    }

    #[test]
    fn cells_count_as_their_area_however_they_are_divided() {
        let lattice = lattice(4, 1);
        let width = columns(&lattice);
        // Pixel (1, 0), divided; its lower right quarter too.
        let sampled = [2 * width + 6, 3 * width + 7];
        let is_sampled = |point| sampled.contains(&point);
        let plane = |point: u32| Vec3::new((point % width) as f32, (point / width) as f32, 1.0);
        assert_eq!(colour(&lattice, 1, 0, plane, is_sampled), Vec3::new(6.0, 2.0, 1.0));
        let at = |x: u32, y: u32| {
            colour(&lattice, 1, 0, |p| Vec3::splat(f32::from(p == y * width + x)), is_sampled).x
        };
        assert_eq!(at(7, 3), 4.0 / 64.0, "a corner of four sixteenths");
        assert_eq!(at(4, 0), 1.0 / 16.0, "a corner of one quarter");
        assert_eq!(at(5, 1), 0.0, "not sampled");
    }

    #[test]
    fn the_rays_of_every_point_count_once() {
        for lattice in [lattice(3, 0), lattice(4, 1)] {
            let points = columns(&lattice) * columns(&lattice);
            let one = |point: u32| RayCounts { primary: 1, shadow: point, reflected: 0, refracted: 2 };
            let pixels = [(0, 0), (1, 0), (0, 1), (1, 1)];
            let all = pixels.map(|(x, y)| rays(&lattice, x, y, one, |point| point != 5));
            let sum = |part: fn(&RayCounts) -> u32| all.iter().map(part).sum::<u32>();
            assert_eq!(sum(|r| r.primary), points - 1);
            assert_eq!(sum(|r| r.shadow), points * (points - 1) / 2 - 5);
            assert_eq!(sum(|r| r.refracted), 2 * (points - 1));
        }
    }
}
