//! From a seed to the source text of a kernel.

use crate::machines::Numbers;
use std::fmt::Write;

/// The source of kernel `k_SEED` and of the functions that only it calls.
///
/// Besides `kernel_api` it needs the functions `tame` and `bits` of [`super::Batch`]'s crate.
pub fn kernel(seed: u32) -> String {
    let mut generator = Generator::new(seed);
    let helpers = 1 + generator.numbers.below(2);
    for helper in 0..helpers {
        generator.helper(seed, helper);
    }
    generator.body(seed);
    generator.entry(seed);
    generator.text
}

/// Something that can be left by its name.
#[derive(Clone)]
pub(super) struct Label {
    pub name: String,
    /// Whether it can be continued too.
    pub is_loop: bool,
}

/// The text so far, and what can be named where it ends.
pub(super) struct Generator {
    pub numbers: Numbers,
    pub text: String,
    pub indent: usize,
    /// Variables of type `u32` that can be assigned.
    pub integers: Vec<String>,
    /// Variables of type `u32` that cannot, such as loop counters.
    pub counters: Vec<String>,
    /// Variables of type `f32`, always tame.
    pub floats: Vec<String>,
    /// Labels around this place, the outermost first.
    pub labels: Vec<Label>,
    /// Functions `fn(u32, u32, f32) -> u32` that can be called.
    pub helpers: Vec<String>,
    /// Whether the arrays, the table and the cells are in scope.
    pub memory: bool,
    /// What a `return` returns.
    pub result: String,
    /// How many more loops there may be in this function: nested ones multiply.
    pub loops: u32,
    /// How many more statements there may be in it.
    pub budget: u32,
    fresh: u32,
}

impl Generator {
    fn new(seed: u32) -> Self {
        Self {
            numbers: Numbers::new(seed),
            text: String::new(),
            indent: 0,
            integers: Vec::new(),
            counters: Vec::new(),
            floats: Vec::new(),
            labels: Vec::new(),
            helpers: Vec::new(),
            memory: false,
            result: String::new(),
            loops: 0,
            budget: 0,
            fresh: 0,
        }
    }

    /// Appends a line.
    pub fn line(&mut self, line: impl AsRef<str>) {
        let indent = 4 * self.indent;
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{:indent$}{}", "", line.as_ref());
    }

    /// A name that nothing else has.
    pub fn name(&mut self, kind: &str) -> String {
        self.fresh += 1;
        format!("{kind}{}", self.fresh)
    }

    /// One of the items.
    pub fn pick<T: Clone>(&mut self, items: &[T]) -> T {
        items[self.numbers.below(items.len() as u32) as usize].clone()
    }

    /// Whether something that happens `percent` times in a hundred happens.
    pub fn chance(&mut self, percent: u32) -> bool {
        self.numbers.below(100) < percent
    }

    /// A function of numbers alone, with returns from inside.
    fn helper(&mut self, seed: u32, number: u32) {
        let name = format!("h_{seed}_{number}");
        self.line("#[inline(always)]");
        self.line(format!("fn {name}(a: u32, b: u32, x: f32) -> u32 {{"));
        self.indent += 1;
        self.line("let (mut a, mut b, mut x) = (a, b, x);");
        self.integers = vec!["a".into(), "b".into()];
        self.floats = vec!["x".into()];
        self.result = "a ^ b.rotate_left(9) ^ bits(x)".into();
        (self.loops, self.budget) = (1, 8);
        let count = 3 + self.numbers.below(3);
        self.statements(count, 2);
        self.line(self.result.clone());
        self.indent -= 1;
        self.line("}\n");
        self.helpers.push(name);
    }

    /// The function that the kernel calls.
    fn body(&mut self, seed: u32) {
        self.line("#[inline(always)]");
        self.line(format!("fn f_{seed}(i: u32, words: &[u32], cells: &[AtomicU32]) -> [u32; 4] {{"));
        self.indent += 1;
        self.line("let (mut a, mut b, mut c) = (words.at(i & 255), i, 7u32);");
        self.line("let (mut x, mut y) = ((a & 0xfff) as f32 / 64.0, 0.5f32);");
        self.line("let (mut own, mut row) = ([i; 8], [1.5f32; 4]);");
        self.integers = vec!["a".into(), "b".into(), "c".into()];
        self.counters = vec!["i".into()];
        self.floats = vec!["x".into(), "y".into()];
        self.memory = true;
        self.result =
            "[a, b ^ c.rotate_left(13), own.at(a & 7) ^ own.at(3u32), bits(x) ^ bits(y).rotate_left(7) ^ \
                       bits(row.at(b & 3))]"
                .into();
        (self.loops, self.budget) = (4, 10 + self.numbers.below(20));
        let count = 6 + self.numbers.below(7);
        self.statements(count, 3);
        self.line(self.result.clone());
        self.indent -= 1;
        self.line("}\n");
    }

    fn entry(&mut self, seed: u32) {
        self.line(format!(
            "#[spirv(compute(threads(64)))]
pub fn k_{seed}(
    #[spirv(global_invocation_id)] id: UVec3,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] cells: &[AtomicU32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: Out<[u32; 4]>,
) {{
    if id.x < out.len() {{
        out.put(id.x, f_{seed}(id.x, words, cells));
    }}
}}
"
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::kernel;

    #[test]
    fn a_seed_always_gives_the_same_kernel_and_another_one_another() {
        assert_eq!(kernel(7), kernel(7));
        assert_ne!(kernel(7).replace("_7", ""), kernel(8).replace("_8", ""));
    }

    #[test]
    fn all_kinds_of_control_flow_turn_up() {
        let text: String = (0..40).map(kernel).collect();
        let wanted =
            ["match ", "while ", "loop {", "for ", "break '", "continue '", "return ", "else {", "fetch_"];
        for word in wanted {
            assert!(text.contains(word), "no `{word}`");
        }
        assert!(text.lines().any(|line| line.trim().starts_with("'block") && line.ends_with(": {")));
    }
}
