//! Where instructions come from in the source, for messages.

use std::collections::HashMap;
use std::sync::Arc;

/// The debug information of a module, as far as it says which function and line an instruction was inlined from.
#[derive(Clone, Debug, Default)]
pub struct Locations {
    /// The records by the number of their metadata.
    pub records: HashMap<u32, Record>,
}

/// A record of debug information.
#[derive(Clone, PartialEq, Debug)]
pub enum Record {
    /// A line of a scope, which may have been inlined at another location.
    Line {
        /// The line.
        line: u32,
        /// The scope.
        scope: u32,
        /// The location of the call.
        inlined_at: Option<u32>,
    },
    /// A block of a scope.
    Block {
        /// The scope around it.
        scope: u32,
    },
    /// A function.
    Function {
        /// Its name as the user wrote it.
        name: Arc<str>,
        /// Its file.
        file: u32,
    },
    /// A file, relative to the crate if it belongs to it.
    File(Arc<str>),
}

/// A function and a line in it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Origin {
    /// The function's name.
    pub function: String,
    /// `file:line`.
    pub place: String,
}

impl Origin {
    /// Whether this says nothing about what is wrong in a kernel: its caller does.
    fn is_library(&self) -> bool {
        let standard = ["library/", "/rustc/"].iter().any(|folder| self.place.starts_with(folder));
        standard || self.function.contains("kernel_api::")
    }
}

impl Locations {
    /// The innermost function that the user can change, and the line in it.
    pub fn origin(&self, location: u32) -> Option<Origin> {
        let (mut next, mut innermost) = (Some(location), None);
        while let Some(location) = next {
            let Some(Record::Line { line, scope, inlined_at }) = self.records.get(&location) else { break };
            let origin = self.function(*scope, *line)?;
            if !origin.is_library() {
                return Some(origin);
            }
            innermost.get_or_insert(origin);
            next = *inlined_at;
        }
        innermost
    }

    fn function(&self, mut scope: u32, line: u32) -> Option<Origin> {
        loop {
            match self.records.get(&scope)? {
                Record::Block { scope: outer } => scope = *outer,
                Record::Function { name, file } => {
                    let Record::File(file) = self.records.get(file)? else { return None };
                    return Some(Origin { function: name.to_string(), place: format!("{file}:{line}") });
                }
                _ => return None,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_user_hears_of_his_own_function() {
        let function = |name: &str, file| Record::Function { name: name.into(), file };
        let records = [
            (1, Record::Line { line: 7, scope: 2, inlined_at: Some(4) }),
            (2, Record::Block { scope: 3 }),
            (3, function("<f32>::abs", 10)),
            (4, Record::Line { line: 30, scope: 5, inlined_at: Some(6) }),
            (5, function("mine::shade", 9)),
            (6, Record::Line { line: 40, scope: 5, inlined_at: None }),
            (9, Record::File("src/lib.rs".into())),
            (10, Record::File("library/core/src/num/f32.rs".into())),
        ];
        let locations = Locations { records: records.into() };
        let origin = Origin { function: "mine::shade".into(), place: "src/lib.rs:30".into() };
        assert_eq!(locations.origin(1), Some(origin));
        assert_eq!(locations.origin(8), None);
    }
}
