//! Debug information: numbered metadata such as `!9 = !DILocation(line: 3, scope: !7, inlinedAt: !8)`.

use crate::demangle::demangle;
use crate::ir::{Locations, Record};

/// Reads what is there of lines, scopes, functions and files; everything else is left out.
pub fn locations(lines: &[&str]) -> Locations {
    Locations { records: lines.iter().filter_map(|line| record(line)).collect() }
}

fn record(line: &str) -> Option<(u32, Record)> {
    let (number, rest) = line.strip_prefix('!')?.split_once(" = ")?;
    let rest = rest.trim_start_matches("distinct ");
    let (kind, fields) = rest.strip_prefix("!DI")?.split_once('(')?;
    let number_of = |name: &str| field(fields, name)?.trim_start_matches('!').parse::<u32>().ok();
    let record = match kind {
        "Location" => Record::Line {
            line: number_of("line")?,
            scope: number_of("scope")?,
            inlined_at: number_of("inlinedAt"),
        },
        "LexicalBlock" | "LexicalBlockFile" => Record::Block { scope: number_of("scope")? },
        "Subprogram" => {
            let name = text(fields, "linkageName").map(demangle);
            let name = name.or_else(|| text(fields, "name").map(str::to_string))?;
            Record::Function { name: name.into(), file: number_of("file")? }
        }
        "File" => Record::File(text(fields, "filename")?.into()),
        _ => return None,
    };
    Some((number.parse().ok()?, record))
}

/// The value of a field that holds no comma.
fn field<'a>(fields: &'a str, name: &str) -> Option<&'a str> {
    let start = format!("{name}: ");
    let at = match fields.starts_with(&start) {
        true => 0,
        false => fields.find(&format!(", {start}"))? + 2,
    };
    fields[at + start.len()..].split([',', ')']).next()
}

/// The value of a field in quotation marks.
fn text<'a>(fields: &'a str, name: &str) -> Option<&'a str> {
    field(fields, name)?.strip_prefix('"')?.strip_suffix('"')
}

/// The number of the location that an instruction's line names.
pub fn location(line: &str) -> Option<u32> {
    let (_, rest) = line.rsplit_once("!dbg !")?;
    rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_of_each_kind() {
        let lines = [
            r#"!8 = !DIFile(filename: "src/lib.rs", directory: "/x", checksumkind: CSK_MD5, checksum: "4")"#,
            r#"!9 = distinct !DISubprogram(name: "f", linkageName: "_ZN3neg3fib17h85167a6d54f5f1deE", scope: !10, file: !8, line: 6)"#,
            "!13 = !DILocation(line: 12, column: 50, scope: !14, inlinedAt: !15)",
            "!14 = distinct !DILexicalBlock(scope: !9, file: !8, line: 3)",
            "!16 = !{}",
        ];
        let origin = locations(&lines).origin(13).map(|origin| (origin.function, origin.place));
        assert_eq!(origin, Some(("neg::fib".into(), "src/lib.rs:12".into())));
        assert_eq!(location("  %a = add i32 %b, 1, !dbg !123, !noundef !4"), Some(123));
        assert_eq!(location("  %a = add i32 %b, 1"), None);
    }
}
