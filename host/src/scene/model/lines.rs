//! Lines and words of text that may come from anywhere: line ends of Unix, Windows and old Macs, any bytes
//! between.

/// The lines of a text, each without its end (`\n`, `\r\n` or `\r`); a last line needs none.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
}

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self { rest: text }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(end);
        let skip = if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        self.rest = &rest[skip..];
        Some(line)
    }
}

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|b| b.is_ascii_whitespace()).filter(|word| !word.is_empty())
}

/// A word as a number: `nan`, `inf` and what overflows to it are numbers here.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A line or word for a message: at most 40 characters of it.
pub(super) fn shown(text: &[u8]) -> String {
    let text = String::from_utf8_lossy(&text[..text.len().min(160)]).replace(char::is_control, " ");
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_end() {
        let lines: Vec<_> = Lines::new(b"a\nb\r\n\rc\r\n\nd").collect();
        assert_eq!(lines, [b"a" as &[u8], b"b", b"", b"c", b"", b"d"]);
        assert_eq!(Lines::new(b"").count(), 0);
    }

    #[test]
    fn messages_are_short() {
        assert_eq!(shown(&[b'x'; 5000]).chars().count(), 41);
        assert_eq!(shown(b"a\xff\n"), "a\u{fffd} ");
    }
}
