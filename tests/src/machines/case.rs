//! One run of one kernel, and what it must write.

use kernel_api::Access;
use parallax::backend::gpu::RawBinding;
use std::fmt;

/// A run of a kernel.
#[derive(Clone, Debug)]
pub struct Case {
    /// Which run, for messages: the entry point and what is special about it.
    pub name: String,
    /// The entry point.
    pub entry: String,
    /// Invocations of a workgroup.
    pub threads: [u32; 3],
    /// Number of workgroups.
    pub groups: [u32; 3],
    /// What is bound, as it is before the run.
    pub bindings: Vec<RawBinding>,
    /// The push constant.
    pub push: Vec<u8>,
    /// Specialisation constants: number and bits.
    pub constants: Vec<(u32, u32)>,
    /// The words of each binding behind the run.
    pub expected: Vec<Vec<u32>>,
}

/// The first word that is not what it must be.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Which binding.
    pub binding: u32,
    /// Which word of it.
    pub word: usize,
    /// What it must be; nothing if the binding has fewer words.
    pub expected: Option<u32>,
    /// What it is; nothing if it has fewer words.
    pub found: Option<u32>,
    /// How many words differ in all bindings.
    pub count: usize,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |word: Option<u32>| match word {
            Some(word) => format!("{word:#010x} ({})", f32::from_bits(word)),
            None => "no word".into(),
        };
        let (expected, found) = (text(self.expected), text(self.found));
        write!(f, "binding {}, word {}: expected {expected}, found {found}; ", self.binding, self.word)?;
        write!(f, "{} words differ", self.count)
    }
}

impl std::error::Error for Difference {}

impl Case {
    /// Compares what the bindings hold behind a run with what they must hold.
    ///
    /// # Errors
    /// The first difference. Bindings that are only read are not looked at.
    pub fn compare(&self, found: &[RawBinding]) -> Result<(), Difference> {
        let mut first = None;
        let mut count = 0;
        for (binding, expected) in found.iter().zip(&self.expected) {
            if !matches!(binding.access, Access::Write | Access::Atomic) {
                continue;
            }
            for word in 0..expected.len().max(binding.words.len()) {
                let (expected, found) = (expected.get(word).copied(), binding.words.get(word).copied());
                if expected != found {
                    count += 1;
                    first.get_or_insert(Difference {
                        binding: binding.binding,
                        word,
                        expected,
                        found,
                        count: 0,
                    });
                }
            }
        }
        match first {
            Some(difference) => Err(Difference { count, ..difference }),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case() -> Case {
        let binding = |binding, access, words| RawBinding { set: 0, binding, access, words };
        Case {
            name: "made".into(),
            entry: "made".into(),
            threads: [1; 3],
            groups: [1; 3],
            bindings: vec![binding(0, Access::Read, vec![1, 2]), binding(3, Access::Write, vec![7, 8, 9])],
            push: Vec::new(),
            constants: Vec::new(),
            expected: vec![vec![1, 2], vec![7, 8, 9]],
        }
    }

    #[test]
    fn what_is_equal_is_equal() {
        let case = case();
        assert_eq!(case.compare(&case.bindings), Ok(()));
    }

    #[test]
    fn one_flipped_bit_is_a_difference() {
        let (case, mut found) = (case(), case().bindings);
        found[1].words[2] ^= 1 << 31;
        let difference = case.compare(&found).unwrap_err();
        assert_eq!((difference.binding, difference.word, difference.count), (3, 2, 1));
        assert!(difference.to_string().starts_with("binding 3, word 2: expected 0x00000009"), "{difference}");
    }

    #[test]
    fn fewer_and_more_words_are_differences() {
        let (case, mut found) = (case(), case().bindings);
        found[1].words.pop();
        assert_eq!(case.compare(&found).unwrap_err().found, None);
        found[1].words.extend([9, 10]);
        assert_eq!(case.compare(&found).unwrap_err().expected, None);
    }

    #[test]
    fn equal_nans_are_equal_and_others_are_not() {
        let (mut case, mut found) = (case(), case().bindings);
        (case.expected[1][0], found[1].words[0]) = (0x7fc0_0000, 0x7fc0_0000);
        assert_eq!(case.compare(&found), Ok(()));
        found[1].words[0] = 0x7fc0_0001;
        assert_eq!(case.compare(&found).unwrap_err().word, 0);
    }
}
