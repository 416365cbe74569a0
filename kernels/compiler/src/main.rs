//! The command `kernel-compiler`.

fn main() {}
