//! Places of rays within their pixels that look random and depend on nothing but the pixel and a seed.

use glam::Vec2;

/// How far from the centre of pixel (`x`, `y`) its ray goes, in pixels: each coordinate a multiple of 2⁻¹⁷ in (−½, ½). All operations
/// are exact.
#[inline(always)]
pub fn offset(seed: u32, x: u32, y: u32) -> Vec2 {
    let bits = mixed(x ^ mixed(y ^ mixed(seed)));
    let coordinate = |bits: u32| (bits & 0xffff) as f32 * (1.0 / 65_536.0) - (0.5 - 1.0 / 131_072.0);
    Vec2::new(coordinate(bits), coordinate(bits >> 16))
}

/// A bijection of words in which each bit depends on all (the "lowbias32" of Wellons' search for hash functions, 2018).
#[inline(always)]
fn mixed(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x7feb_352d);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(0x846c_a68b);
    bits ^ (bits >> 16)
}

#[cfg(test)]
mod tests {
    use super::offset;
    use glam::Vec2;

    #[test]
    fn places_are_within_the_pixel_and_everywhere_in_it() {
        let places: Vec<Vec2> = (0..64).flat_map(|y| (0..64).map(move |x| offset(7, x, y))).collect();
        let mut cells = [0_u32; 16];
        for place in &places {
            assert!(place.abs().max_element() < 0.5, "{place}");
            cells[((place.x + 0.5) * 4.0) as usize + 4 * ((place.y + 0.5) * 4.0) as usize] += 1;
        }
        // 256 are expected in each; six standard deviations are 93.
        assert!(cells.iter().all(|count| (163..349).contains(count)), "{cells:?}");
        let mean = places.iter().sum::<Vec2>() / 4096.0;
        assert!(mean.abs().max_element() < 0.03, "{mean}");
    }

    #[test]
    fn neighbours_and_seeds_differ() {
        assert_ne!(offset(1, 5, 6), offset(1, 6, 5));
        assert_ne!(offset(1, 5, 6), offset(2, 5, 6));
    }
}
