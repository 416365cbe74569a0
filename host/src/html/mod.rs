//! What the pages of `bench stereo` and `study` share: the looks, and texts and numbers as they stand there.

/// The style sheet, in place of `{{style}}`.
pub const STYLE: &str = include_str!("style.css");

/// Text as it may stand in HTML.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Half the distance of the quartiles behind a value; nothing where there is none.
pub fn half_spread(spread: f64) -> String {
    if spread > 0.0 { format!("± {}", number(spread / 2.0)) } else { String::new() }
}

/// A number as a tick has it.
pub fn number(value: f64) -> String {
    let digits = if value.abs() >= 100.0 || value == 0.0 { 0 } else { 2 };
    let text =
        if value != 0.0 && value.abs() < 0.01 { format!("{value:.1e}") } else { format!("{value:.digits$}") };
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').into(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, 1500.0, 7.5, 0.25, 20.0, 0.001, -3.0].map(number);
        assert_eq!(texts, ["0", "1500", "7.5", "0.25", "20", "1.0e-3", "-3"]);
    }
}
