//! The header of a PLY file, and the checks that its counts must pass.

use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{DefaultElement, ElementDef, Encoding, Header, PropertyType, ScalarType};

use super::super::lines::{Lines, shown};
use super::Wrong;

/// The longest header that is read.
const MAX_HEADER: usize = 1 << 16;

/// The header, the bytes after it, and how many lines it takes.
pub(super) fn header(bytes: &[u8]) -> Result<(Header, &[u8], usize), Wrong> {
    let head = &bytes[..bytes.len().min(MAX_HEADER)];
    let mut text = String::new();
    let mut end = None;
    for line in Lines::new(head) {
        let trimmed = String::from_utf8_lossy(line).trim().to_string();
        if text.is_empty() && trimmed != "ply" {
            return Err((Some(1), format!("expected `ply`, found `{}`", shown(line))));
        }
        text.push_str(&trimmed);
        text.push('\n');
        if trimmed == "end_header" {
            end = Some(line.as_ptr() as usize - bytes.as_ptr() as usize + line.len());
            break;
        }
    }
    let end = end.ok_or_else(|| (None, "no line `end_header` in its first 64 KiB".to_string()))?;
    let body = &bytes[body_start(bytes, end)..];
    let header = Parser::<DefaultElement>::new()
        .read_header(&mut Reader::new(text.as_bytes()))
        .map_err(|e| (e.line(), header_message(&text, e.line())))?;
    header.elements.values().try_for_each(|e| check_count(e, header.encoding, body.len()))?;
    Ok((header, body, text.lines().count()))
}

/// Where the body begins, after the line `end_header` that ends at `end`. In a file whose lines end with `\r`
/// alone, a line feed there is the body's first byte.
fn body_start(bytes: &[u8], end: usize) -> usize {
    let mac = Lines::new(bytes).next().is_some_and(|first| {
        let line_end = &bytes[first.len()..];
        line_end.starts_with(b"\r") && !line_end.starts_with(b"\r\n")
    });
    let line_end = if !mac && bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
    (end + line_end).min(bytes.len())
}

fn header_message(text: &str, line: Option<usize>) -> String {
    let line = line.and_then(|l| text.lines().nth(l.saturating_sub(1))).unwrap_or("");
    format!(
        concat!(
            "`{}` is no line of a PLY header (expected `format ascii|binary_little_endian|binary_big_endian 1.0`, ",
            "`element NAME COUNT`, `property TYPE NAME`, `property list TYPE TYPE NAME`, `comment …`)"
        ),
        shown(line.as_bytes())
    )
}

/// Refuses a count that the rest of the file cannot hold.
fn check_count(element: &ElementDef, encoding: Encoding, bytes: usize) -> Result<(), Wrong> {
    let least = |kind: &PropertyType| match (encoding, kind) {
        // A digit and what separates it from the next.
        (Encoding::Ascii, _) => 2,
        (_, PropertyType::Scalar(kind) | PropertyType::List(kind, _)) => size(kind),
    };
    let row: usize = element.properties.values().map(|p| least(&p.data_type)).sum();
    // The last line of a text needs no end.
    if row > 0 && element.count > (bytes + 1) / row {
        let (name, count) = (shown(element.name.as_bytes()), element.count);
        return Err((
            None,
            format!("{count} elements `{name}` do not fit into the {bytes} bytes that follow"),
        ));
    }
    Ok(())
}

/// Bytes of a value in a binary file.
fn size(kind: &ScalarType) -> usize {
    match kind {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}
