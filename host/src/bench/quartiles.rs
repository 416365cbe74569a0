//! What is told of repeated measurements.

/// Lower quartile, median and upper quartile; zeros of nothing.
pub fn quartiles(values: impl IntoIterator<Item = f64>) -> [f64; 3] {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| sorted.get((sorted.len().max(1) - 1) * quarter / 4).copied().unwrap_or(0.0))
}

#[cfg(test)]
mod tests {
    use super::quartiles;

    #[test]
    fn quartiles_of_few_and_of_none() {
        assert_eq!(quartiles([4.0, 0.0, 3.0, 1.0, 2.0]), [1.0, 2.0, 3.0]);
        assert_eq!((quartiles([7.0]), quartiles([])), ([7.0; 3], [0.0; 3]));
    }
}
