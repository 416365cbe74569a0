//! The words of SPIR-V modules, for tests that change some.

/// Where each instruction of a module begins, and which one it is.
pub fn instructions(words: &[u32]) -> impl Iterator<Item = (usize, u32)> + '_ {
    // A header of five words comes first; the length of an instruction is the upper half of its first word.
    let first = (words.len() > 5).then_some(5);
    let next = |at: &usize| Some(at + (words[*at] >> 16).max(1) as usize).filter(|next| *next < words.len());
    std::iter::successors(first, next).map(|at| (at, words[at] & 0xffff))
}
