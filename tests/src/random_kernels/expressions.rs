//! Random expressions.

use super::generator::Generator;

impl Generator {
    /// An expression of type `u32`.
    pub fn integer(&mut self, depth: u32) -> String {
        if depth == 0 || self.chance(15) {
            return self.integer_leaf();
        }
        let (a, b) = (self.integer(depth - 1), self.integer(depth - 1));
        let number = self.numbers.below(31) + 1;
        match self.numbers.below(26) {
            0..=2 => format!("{a}.wrapping_add({b})"),
            3 => format!("{a}.wrapping_sub({b})"),
            4 | 5 => format!("{a}.wrapping_mul({b})"),
            6 | 7 => format!("({a} ^ {b})"),
            8 => format!("({a} & {b})"),
            9 => format!("({a} | {b})"),
            10 => format!("({a} << {number})"),
            11 => format!("({a} >> ({b} & 31))"),
            12 => format!("((({a} as i32) >> {number}) as u32)"),
            13 => format!("{a}.rotate_left({b} & 31)"),
            14 => format!("({a} / {})", number + 2),
            15 => format!("({a} % ({b} | 1))"),
            16 => format!("((({a} as i32) / {}) as u32)", number as i32 - 40),
            17 => format!("{a}.min({b})"),
            18 => format!("(({a} as i32).max({b} as i32) as u32)"),
            19 => format!("{a}.saturating_sub({b})"),
            20 => self.pick(&[
                format!("{a}.count_ones()"),
                format!("{a}.leading_zeros()"),
                format!("{a}.swap_bytes()"),
            ]),
            21 => format!("mul_high({a}, {b})"),
            22 => self.chosen(depth, &a, &b),
            23 => self.float_as_integer(depth),
            24 => self.call(a, b),
            _ => self.loaded(a),
        }
    }

    fn integer_leaf(&mut self) -> String {
        let variables: Vec<String> = self.integers.iter().chain(&self.counters).cloned().collect();
        match self.numbers.below(10) {
            0 => format!("{}u32", self.numbers.below(20)),
            1 => format!("{:#x}u32", self.numbers.word()),
            _ => self.pick(&variables),
        }
    }

    fn chosen(&mut self, depth: u32, a: &str, b: &str) -> String {
        let condition = self.condition(depth - 1);
        format!("(if {condition} {{ {a} }} else {{ {b} }})")
    }

    fn float_as_integer(&mut self, depth: u32) -> String {
        let x = self.float(depth - 1);
        match self.numbers.below(3) {
            0 => format!("({x} as u32)"),
            1 => format!("({x} as i32 as u32)"),
            // Of a variable, since the result of an operation may be NaN.
            _ => format!("bits({})", self.pick(&self.floats.clone())),
        }
    }

    fn call(&mut self, a: String, b: String) -> String {
        if self.helpers.is_empty() || !self.memory {
            return format!("{a}.abs_diff({b})");
        }
        let (helper, x) = (self.pick(&self.helpers.clone()), self.pick(&self.floats.clone()));
        format!("{helper}({a}, {b}, {x})")
    }

    fn loaded(&mut self, at: String) -> String {
        match self.numbers.below(2) {
            _ if !self.memory => format!("(!{at})"),
            0 => format!("words.at({at} & 255)"),
            _ => format!("own.at({at} & 7)"),
        }
    }

    /// An expression of type `f32`. Every factor of a product is 0 or between 10⁻³ and 10³, so that no product is denormal.
    pub fn float(&mut self, depth: u32) -> String {
        if depth == 0 || self.chance(20) {
            return self.float_leaf();
        }
        let (x, y) = (self.float(depth - 1), self.float(depth - 1));
        match self.numbers.below(10) {
            0 | 1 => format!("({x} + {y})"),
            2 | 3 => format!("({x} - {y})"),
            4 | 5 => format!("(tame({x}) * tame({y}))"),
            6 => format!("(-{x})"),
            7 => format!("{x}.abs()"),
            8 => format!("tame({x}).floor()"),
            _ => {
                let condition = self.condition(depth - 1);
                format!("(if {condition} {{ {x} }} else {{ {y} }})")
            }
        }
    }

    fn float_leaf(&mut self) -> String {
        match self.numbers.below(8) {
            0 => format!("{:?}f32", self.numbers.small()),
            1 => {
                let number = self.integer_leaf();
                format!("(({number} & 0xffff) as f32 / 256.0)")
            }
            2 => {
                let number = self.integer_leaf();
                format!("(({number} as i32 >> 20) as f32)")
            }
            3 if self.memory => {
                let at = self.integer_leaf();
                format!("row.at({at} & 3)")
            }
            _ => self.pick(&self.floats.clone()),
        }
    }

    /// An expression of type `bool`.
    pub fn condition(&mut self, depth: u32) -> String {
        let (a, b) = (self.integer(depth.min(1)), self.integer(depth.min(1)));
        let compare = self.pick(&["<", "<=", ">", ">=", "==", "!="]);
        match self.numbers.below(10) {
            0 | 1 => format!("({a} {compare} {b})"),
            2 => format!("(({a} as i32) {compare} ({b} as i32))"),
            3..=5 => {
                let mask = 1 << self.numbers.below(6);
                format!("({a} & {mask} != 0)")
            }
            6 | 7 => {
                let (x, y) = (self.float(depth.min(1)), self.float(depth.min(1)));
                format!("({x} {compare} {y})")
            }
            _ if depth == 0 => format!("({a} % 3 == 1)"),
            8 => {
                let (p, q) = (self.condition(depth - 1), self.condition(depth - 1));
                let both = self.pick(&["&&", "||"]);
                format!("({p} {both} {q})")
            }
            _ => format!("!{}", self.condition(depth - 1)),
        }
    }
}
