//! The body of a PLY file as a sequence of numbers.

use ply_rs_bw::ply::ScalarType;

use super::super::lines::{Lines, number};

/// The values of a file's body, one after the other.
pub(super) trait Body {
    /// Goes to the next element.
    fn next_element(&mut self) -> Option<()>;
    /// The next value; `None` when there is none or it is no number.
    fn value(&mut self, kind: &ScalarType) -> Option<f64>;
    /// The number of items of a list.
    fn count(&mut self, kind: &ScalarType) -> Option<f64> {
        self.value(kind)
    }
    /// The line, where there are lines.
    fn line(&self) -> Option<usize>;
}

/// A text: an element a line, empty lines do not count.
pub(super) struct Ascii<'a> {
    lines: Lines<'a>,
    rest: &'a [u8],
    line: usize,
}

impl<'a> Ascii<'a> {
    pub(super) fn new(body: &'a [u8], line: usize) -> Self {
        Self { lines: Lines::new(body), rest: &[], line }
    }
}

impl Body for Ascii<'_> {
    fn next_element(&mut self) -> Option<()> {
        loop {
            let line = self.lines.next()?;
            self.line += 1;
            self.rest = line.trim_ascii_start();
            if !self.rest.is_empty() {
                return Some(());
            }
        }
    }

    fn value(&mut self, _: &ScalarType) -> Option<f64> {
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_ascii_start();
        number(word)
    }

    /// A list that the line does not reach is empty: files with such lines are about.
    fn count(&mut self, kind: &ScalarType) -> Option<f64> {
        if self.rest.is_empty() { Some(0.0) } else { self.value(kind) }
    }

    fn line(&self) -> Option<usize> {
        Some(self.line)
    }
}

pub(super) struct Binary<'a> {
    pub(super) body: &'a [u8],
    /// Whether the most significant byte comes first.
    pub(super) big: bool,
}

impl Binary<'_> {
    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (bytes, rest) = self.body.split_first_chunk::<N>()?;
        self.body = rest;
        let mut bytes = *bytes;
        if self.big {
            bytes.reverse();
        }
        Some(bytes)
    }
}

impl Body for Binary<'_> {
    fn next_element(&mut self) -> Option<()> {
        Some(())
    }

    fn value(&mut self, kind: &ScalarType) -> Option<f64> {
        Some(match kind {
            ScalarType::Char => i8::from_le_bytes(self.bytes()?).into(),
            ScalarType::UChar => u8::from_le_bytes(self.bytes()?).into(),
            ScalarType::Short => i16::from_le_bytes(self.bytes()?).into(),
            ScalarType::UShort => u16::from_le_bytes(self.bytes()?).into(),
            ScalarType::Int => i32::from_le_bytes(self.bytes()?).into(),
            ScalarType::UInt => u32::from_le_bytes(self.bytes()?).into(),
            ScalarType::Float => f32::from_le_bytes(self.bytes()?).into(),
            ScalarType::Double => f64::from_le_bytes(self.bytes()?),
        })
    }

    fn line(&self) -> Option<usize> {
        None
    }
}
