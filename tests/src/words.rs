//! The words of SPIR-V modules, for tests that count or change some.

/// The instructions of a module, each with the place of its first word.
pub fn instructions(words: &[u32]) -> impl Iterator<Item = (usize, &[u32])> {
    // A header of five words comes first; the length of an instruction is the upper half of its first word.
    let end = |at: usize| at + (words[at] >> 16).max(1) as usize;
    let first = (words.len() > 5).then_some(5);
    let places = std::iter::successors(first, move |at| Some(end(*at)).filter(|next| *next < words.len()));
    places.map(move |at| (at, &words[at..end(at)]))
}
