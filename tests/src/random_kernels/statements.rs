//! Random statements.

use super::generator::{Generator, Label};

impl Generator {
    /// So many statements, nested at most `depth` deep.
    pub fn statements(&mut self, count: u32, depth: u32) {
        for _ in 0..count {
            if self.budget > 0 {
                self.budget -= 1;
                self.statement(depth);
            }
        }
    }

    fn statement(&mut self, depth: u32) {
        match self.numbers.below(20) {
            0..=3 => self.assign_integer(),
            4 | 5 => self.assign_float(),
            6 if self.memory => self.store(),
            7 if self.memory && self.chance(40) => self.change_cell(),
            8 | 9 => self.leave(),
            _ if depth == 0 => self.assign_integer(),
            10..=12 => self.branch(depth),
            13 | 14 => self.switch(depth),
            15 => self.labelled_block(depth),
            _ if self.loops == 0 => self.branch(depth),
            16 => self.counted_loop(depth),
            17 => self.state_machine(depth),
            18 => self.valued_loop(depth),
            _ => self.endless_loop(depth),
        }
    }

    fn assign_integer(&mut self) {
        let variable = self.pick(&self.integers.clone());
        let value = self.integer(3);
        self.line(format!("{variable} = {value};"));
    }

    fn assign_float(&mut self) {
        let variable = self.pick(&self.floats.clone());
        let value = self.float(3);
        self.line(format!("{variable} = tame({value});"));
    }

    fn store(&mut self) {
        let at = self.integer(1);
        if self.chance(70) {
            let value = self.integer(2);
            self.line(format!("let (at, value) = ({at} & 7, {value});"));
            self.line("own.put(at, value);");
        } else {
            let value = self.float(2);
            self.line(format!("let (at, value) = ({at} & 3, tame({value}));"));
            self.line("row.put(at, value);");
        }
    }

    /// Only operations whose order does not matter, and whose result is not used; each on cells of its own.
    fn change_cell(&mut self) {
        let (kind, at, value) = (self.numbers.below(5), self.integer(0), self.integer(1));
        let operation = ["add", "xor", "max", "or", "min"][kind as usize];
        self.line(format!("cells.at_ref({kind} * 4 + ({at} & 3)).fetch_{operation}({value}, Relaxed);"));
    }

    /// Out of a loop or block, on to the next round, or back to the caller; most of the time under a condition.
    fn leave(&mut self) {
        let mut ways: Vec<String> = vec![format!("return {};", self.result)];
        for label in self.labels.clone() {
            ways.push(format!("break '{};", label.name));
            if label.is_loop {
                ways.push(format!("continue '{};", label.name));
                ways.push(format!("continue '{};", label.name));
            }
        }
        // A return from everything is rare where there are other ways.
        let way = if ways.len() > 1 && self.chance(85) { self.pick(&ways[1..]) } else { ways[0].clone() };
        let condition = self.condition(2);
        self.line(format!("if {condition} {{ {way} }}"));
    }

    fn block(&mut self, depth: u32) {
        self.indent += 1;
        let count = 1 + self.numbers.below(3);
        self.statements(count, depth - 1);
        self.indent -= 1;
    }

    fn branch(&mut self, depth: u32) {
        let condition = self.condition(2);
        self.line(format!("if {condition} {{"));
        self.block(depth);
        while self.chance(25) {
            let condition = self.condition(1);
            self.line(format!("}} else if {condition} {{"));
            self.block(depth);
        }
        if self.chance(50) {
            self.line("} else {");
            self.block(depth);
        }
        self.line("}");
    }

    fn switch(&mut self, depth: u32) {
        let arms = 2 + self.numbers.below(5);
        let value = self.integer(2);
        self.line(format!("match {value} % {} {{", arms + 2));
        self.indent += 1;
        for arm in 0..arms {
            let pattern = match self.numbers.below(4) {
                0 if arm > 0 => format!("{arm} | {}", arm + 100),
                _ => format!("{arm}"),
            };
            self.line(format!("{pattern} => {{"));
            self.block(depth);
            self.line("}");
        }
        self.line("_ => {");
        self.block(depth);
        self.line("}");
        self.indent -= 1;
        self.line("}");
    }

    fn labelled_block(&mut self, depth: u32) {
        let name = self.name("block");
        self.line(format!("'{name}: {{"));
        self.labels.push(Label { name, is_loop: false });
        self.block(depth);
        self.indent += 1;
        self.leave();
        self.indent -= 1;
        self.block(depth);
        self.labels.pop();
        self.line("}");
    }

    /// Writes `'NAME: HEAD {`, the first lines of the body, a body of statements, and `}`.
    fn looped(&mut self, depth: u32, head: &str, first: &[String], tail: &str) {
        self.loops -= 1;
        let name = self.name("loop");
        self.line(head.replace("LOOP", &format!("'{name}")));
        self.indent += 1;
        first.iter().for_each(|line| self.line(line));
        self.indent -= 1;
        self.labels.push(Label { name, is_loop: true });
        self.block(depth);
        self.indent += 1;
        self.leave();
        self.indent -= 1;
        self.block(depth);
        self.labels.pop();
        self.line(tail);
    }

    fn counted_loop(&mut self, depth: u32) {
        let counter = self.name("k");
        let end = self.integer(1);
        let range = match self.numbers.below(3) {
            0 => format!("0..({end} % 9)"),
            1 => format!("(0..({end} & 7)).rev()"),
            _ => format!("({end} & 3)..6"),
        };
        self.counters.push(counter.clone());
        self.looped(depth, &format!("LOOP: for {counter} in {range} {{"), &[], "}");
        self.counters.pop();
    }

    fn endless_loop(&mut self, depth: u32) {
        let fuel = self.name("fuel");
        let most = 3 + self.numbers.below(9);
        self.line(format!("let mut {fuel} = 0u32;"));
        self.counters.push(fuel.clone());
        if self.chance(50) {
            let condition = self.condition(1);
            let head = format!("LOOP: while {fuel} < {most} && {condition} {{");
            self.looped(depth, &head, &[format!("{fuel} += 1;")], "}");
        } else {
            let first = [format!("{fuel} += 1;"), format!("if {fuel} > {most} {{ break; }}")];
            self.looped(depth, "LOOP: loop {", &first, "}");
        }
        self.counters.pop();
    }

    /// A loop that yields a value, another one on each way out.
    fn valued_loop(&mut self, depth: u32) {
        let (fuel, variable) = (self.name("fuel"), self.pick(&self.integers.clone()));
        let (condition, early, late) = (self.condition(2), self.integer(2), self.integer(1));
        let most = 2 + self.numbers.below(7);
        self.line(format!("let mut {fuel} = 0u32;"));
        self.loops -= 1;
        self.line(format!("{variable} = loop {{"));
        self.indent += 1;
        self.line(format!("{fuel} += 1;"));
        self.line(format!("if {condition} {{ break {early}; }}"));
        self.indent -= 1;
        // The loop has no name: what stands in it leaves outer ones, or goes on.
        self.block(depth);
        self.indent += 1;
        self.line(format!("if {fuel} >= {most} {{ break {late}; }}"));
        self.assign_integer();
        self.indent -= 1;
        self.line("};");
    }

    /// A loop around a switch over its state.
    fn state_machine(&mut self, depth: u32) {
        let (state, fuel) = (self.name("state"), self.name("fuel"));
        let states = 2 + self.numbers.below(4);
        self.loops -= 1;
        let name = self.name("loop");
        self.line(format!("let (mut {state}, mut {fuel}) = (0u32, 0u32);"));
        self.line(format!("'{name}: while {fuel} < {} {{", 4 + self.numbers.clone().below(20)));
        self.indent += 1;
        self.line(format!("{fuel} += 1;"));
        self.labels.push(Label { name, is_loop: true });
        self.counters.push(state.clone());
        self.line(format!("{state} = match {state} {{"));
        self.indent += 1;
        for number in 0..states {
            let pattern = if number + 1 == states { "_".into() } else { number.to_string() };
            self.line(format!("{pattern} => {{"));
            self.block(depth);
            let (condition, next, other) =
                (self.condition(1), self.numbers.below(states), self.numbers.below(states));
            self.line(format!("    if {condition} {{ {next} }} else {{ {other} }}"));
            self.line("}");
        }
        self.indent -= 1;
        self.line("};");
        self.counters.pop();
        self.labels.pop();
        self.indent -= 1;
        self.line("}");
    }
}
