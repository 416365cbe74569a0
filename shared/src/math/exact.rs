//! Products and differences with their rounding errors, without fma.

use glam::Vec3;

/// The upper half of `x`'s digits and the rest (Dekker 1971).
#[inline(always)]
fn split(x: f32) -> (f32, f32) {
    let c = 4097.0 * x;
    let high = c - (c - x);
    (high, x - high)
}

/// `a·b − product` for `product` = fl(`a·b`), exactly, unless something over- or underflows (factors and product from 2⁻⁷⁸ to 2¹⁰⁰ are
/// safe).
#[inline(always)]
pub fn product_error(a: f32, b: f32, product: f32) -> f32 {
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
}

/// A point as seen from another one: the difference and its rounding error, together exact.
#[derive(Clone, Copy, Debug)]
pub struct Offset {
    /// The difference, rounded.
    pub rounded: Vec3,
    /// What rounding took from it.
    pub error: Vec3,
}

impl Offset {
    /// `point` − `from` (Knuth's two-sum).
    #[inline(always)]
    pub fn new(point: Vec3, from: Vec3) -> Self {
        let rounded = point - from;
        let taken = rounded - point;
        Self { rounded, error: (point - (rounded - taken)) - (from + taken) }
    }

    /// `self` + `dir`·`t` with an error of 1 ULP of the *result*, however much cancels: a ray seen from something that it comes near.
    #[inline(always)]
    pub fn along(self, dir: Vec3, t: f32) -> Vec3 {
        let product = dir * t;
        let error = Vec3::new(
            product_error(dir.x, t, product.x),
            product_error(dir.y, t, product.y),
            product_error(dir.z, t, product.z),
        );
        (self.rounded + product) + (self.error + error)
    }
}
