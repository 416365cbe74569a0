//! Anaglyphs by least squares (Dubois 2001): the picture whose light, behind a red and a cyan filter, comes
//! closest to what the left and the right view would show without filters.
//!
//! With `C` the display's primaries in CIE XYZ, `A_L` and `A_R` the same behind the filters, `R = [A_L; A_R]`
//! and `D = diag(C, C)`, the projection is `(RᵀR)⁻¹RᵀD`, its rows divided by their sums, so that white stays
//! white. Neither depends on the picture, so that one 3 × 6 matrix is all there is to it. The tests compute
//! it anew from `C`, `A_L` and `A_R`.

/// What the left view adds to red, green and blue.
const LEFT: [[f32; 3]; 3] = [
    [0.456_100_04, 0.500_483_8, 0.176_380_87],
    [-0.040_082_16, -0.037_824_58, -0.015_758_95],
    [-0.015_216_07, -0.020_597_14, -0.005_468_56],
];

/// What the right view adds to red, green and blue.
const RIGHT: [[f32; 3]; 3] = [
    [-0.043_470_6, -0.087_938_82, -0.001_555_29],
    [0.378_476_03, 0.733_639_98, -0.018_450_32],
    [-0.072_152_68, -0.112_960_65, 1.226_395_1],
];

/// The colour of the red/cyan anaglyph (red for the left eye) where the views have the linear colours `left`
/// and `right`.
///
/// All colours are linear; those given are clamped to [0, 1], which is what a screen can show and what the
/// method is about, and so is the result. NaN counts as 0. (Dubois 2001, section 3.)
#[inline]
pub fn red_cyan(left: [f32; 3], right: [f32; 3]) -> [f32; 3] {
    let (left, right) = (left.map(clamp_to_unit), right.map(clamp_to_unit));
    let channel = |l: [f32; 3], r: [f32; 3]| clamp_to_unit(weigh(l, left) + weigh(r, right));
    let ([l0, l1, l2], [r0, r1, r2]) = (LEFT, RIGHT);
    [channel(l0, r0), channel(l1, r1), channel(l2, r2)]
}

#[inline]
fn weigh([a, b, c]: [f32; 3], [red, green, blue]: [f32; 3]) -> f32 {
    a * red + b * green + c * blue
}

/// Comparisons instead of `clamp`, which leaves the sign of zero and NaN open.
#[inline]
fn clamp_to_unit(value: f32) -> f32 {
    if value >= 1.0 {
        1.0
    } else if value > 0.0 {
        value
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE XYZ (rows) of the CRT primaries (columns), without a filter and behind the left and the right one:
    /// the spectral data of Dubois 2001 as Sanders and McAllister 2003 print them.
    const DISPLAY: [[f64; 3]; 3] =
        [[11.6638, 8.3959, 4.65843], [7.10807, 16.6845, 2.45008], [0.527874, 3.79124, 24.0604]];
    const BEHIND_LEFT: [[f64; 3]; 3] = [
        [5.42327, 0.807004, 0.047325],
        [2.70972, 0.50201, 0.0250529],
        [0.0000550941, 0.000411221, 0.00240686],
    ];
    const BEHIND_RIGHT: [[f64; 3]; 3] =
        [[0.180431, 1.6395, 2.00309], [0.448214, 6.31551, 1.35757], [0.289201, 2.3925, 11.062]];

    type Matrix = [[f64; 3]; 3];

    fn product_of_transposed(a: &Matrix, b: &Matrix) -> Matrix {
        core::array::from_fn(|i| core::array::from_fn(|j| (0..3).map(|k| a[k][i] * b[k][j]).sum()))
    }

    fn product(a: &Matrix, b: &Matrix) -> Matrix {
        core::array::from_fn(|i| core::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    }

    fn inverse(m: &Matrix) -> Matrix {
        let minor = |i: usize, j: usize| {
            let (a, b, c, d) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
            m[a][c] * m[b][d] - m[a][d] * m[b][c]
        };
        let determinant: f64 = (0..3).map(|j| m[0][j] * minor(0, j)).sum();
        core::array::from_fn(|i| core::array::from_fn(|j| minor(j, i) / determinant))
    }

    #[test]
    fn the_coefficients_are_the_least_squares_projection() {
        let (l, r) = (
            product_of_transposed(&BEHIND_LEFT, &BEHIND_LEFT),
            product_of_transposed(&BEHIND_RIGHT, &BEHIND_RIGHT),
        );
        let gram: Matrix = core::array::from_fn(|i| core::array::from_fn(|j| l[i][j] + r[i][j]));
        let solve = |behind| product(&inverse(&gram), &product_of_transposed(behind, &DISPLAY));
        let (left, right) = (solve(&BEHIND_LEFT), solve(&BEHIND_RIGHT));
        for row in 0..3 {
            let sum: f64 = left[row].iter().chain(&right[row]).sum();
            for column in 0..3 {
                let pairs =
                    [(LEFT[row][column], left[row][column]), (RIGHT[row][column], right[row][column])];
                for (constant, derived) in pairs {
                    assert!((f64::from(constant) - derived / sum).abs() < 1e-7, "row {row} column {column}");
                }
            }
        }
    }

    /// The three digits in which the matrices are usually printed.
    #[test]
    fn the_coefficients_are_the_published_ones() {
        let thousandths = |m: [[f32; 3]; 3]| m.map(|row| row.map(|c| (c * 1000.0).round() as i32));
        assert_eq!(thousandths(LEFT), [[456, 500, 176], [-40, -38, -16], [-15, -21, -5]]);
        assert_eq!(thousandths(RIGHT), [[-43, -88, -2], [378, 734, -18], [-72, -113, 1226]]);
    }

    #[test]
    fn white_and_black_stay_what_they_are() {
        assert_eq!(red_cyan([0.0; 3], [0.0; 3]), [0.0; 3]);
        for channel in red_cyan([1.0; 3], [1.0; 3]) {
            assert!((channel - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn the_left_view_is_seen_in_red_and_the_right_one_in_green_and_blue() {
        let [red, green, blue] = red_cyan([1.0; 3], [0.0; 3]);
        assert!(red > 0.99 && green == 0.0 && blue == 0.0);
        let [red, green, blue] = red_cyan([0.0; 3], [1.0; 3]);
        assert!(red == 0.0 && green > 0.99 && blue > 0.99);
        assert_eq!(red_cyan([f32::NAN; 3], [9.0; 3]), red_cyan([0.0; 3], [1.0; 3]));
    }
}
