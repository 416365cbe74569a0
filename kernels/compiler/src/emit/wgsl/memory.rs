//! Memory: loads, stores and atomics.

use super::{EmitError, Writer};
use crate::ir::{AtomicOp, Kernel, Op, RootId, Space, Value};
use std::collections::BTreeSet;

impl Writer<'_> {
    /// A word of a root that is not `vec4`, as a place.
    fn place(&mut self, root: RootId, index: &Value) -> Result<String, EmitError> {
        let number = root.0;
        match (&self.kernel.root(root).space, index.as_u32()) {
            (Space::Push, Some(word)) => Ok(format!("r{number}.w{word}")),
            (Space::Push, None) => Err(EmitError::Unsupported(
                "a push constant that is indexed with a variable, in WGSL,".into(),
            )),
            (Space::Uniform { .. }, Some(word)) => Ok(format!("r{number}[{}u][{}u]", word / 4, word % 4)),
            (Space::Uniform { .. }, None) => {
                let word = self.value(index)?;
                Ok(format!("r{number}[{word} >> 2u][{word} & 3u]"))
            }
            _ => Ok(format!("r{number}[{}]", self.value(index)?)),
        }
    }

    pub fn load_word(&mut self, root: RootId, index: &Value) -> Result<String, EmitError> {
        // WGSL's atomics can be accessed in no other way.
        if self.kernel.root(root).atomic { self.atomic_load(root, index) } else { self.place(root, index) }
    }

    pub fn store_word(&mut self, root: RootId, index: &Value, word: &Value) -> Result<(), EmitError> {
        if self.kernel.root(root).atomic {
            return self.atomic_store(root, index, word);
        }
        let (place, word) = (self.place(root, index)?, self.value(word)?);
        self.line(&format!("{place} = {word};"));
        Ok(())
    }

    pub fn load_vec4(&mut self, root: RootId, element: &Value) -> Result<String, EmitError> {
        Ok(format!("r{}[{}]", root.0, self.value(element)?))
    }

    pub fn store_vec4(&mut self, root: RootId, element: &Value, words: &[Value; 4]) -> Result<(), EmitError> {
        let (element, words) = (self.value(element)?, self.values(words)?.join(", "));
        self.line(&format!("r{}[{element}] = vec4<u32>({words});", root.0));
        Ok(())
    }

    pub fn store_component(
        &mut self,
        root: RootId,
        element: &Value,
        component: &Value,
        word: &Value,
    ) -> Result<(), EmitError> {
        let (element, component, word) = (self.value(element)?, self.value(component)?, self.value(word)?);
        self.line(&format!("r{}[{element}][{component}] = {word};", root.0));
        Ok(())
    }

    pub fn atomic_load(&mut self, root: RootId, index: &Value) -> Result<String, EmitError> {
        let load = format!("atomicLoad(&{})", self.place(root, index)?);
        Ok(self.atomic_result(root, load))
    }

    pub fn atomic_store(&mut self, root: RootId, index: &Value, word: &Value) -> Result<(), EmitError> {
        let (place, word) = (self.place(root, index)?, self.atomic_operand(root, word)?);
        self.line(&format!("atomicStore(&{place}, {word});"));
        Ok(())
    }

    pub fn atomic(
        &mut self,
        op: AtomicOp,
        root: RootId,
        index: &Value,
        operand: &Value,
    ) -> Result<String, EmitError> {
        let name = match op {
            AtomicOp::Add => "Add",
            AtomicOp::Sub => "Sub",
            AtomicOp::And => "And",
            AtomicOp::Or => "Or",
            AtomicOp::Xor => "Xor",
            AtomicOp::UMin | AtomicOp::UMax if self.signed.contains(&root) => {
                let what = "a buffer with signed and unsigned atomic minima or maxima in WGSL";
                return Err(EmitError::Unsupported(what.into()));
            }
            AtomicOp::UMin | AtomicOp::SMin => "Min",
            AtomicOp::UMax | AtomicOp::SMax => "Max",
            AtomicOp::Exchange => "Exchange",
        };
        let (place, operand) = (self.place(root, index)?, self.atomic_operand(root, operand)?);
        Ok(self.atomic_result(root, format!("atomic{name}(&{place}, {operand})")))
    }

    pub fn compare_exchange(
        &mut self,
        root: RootId,
        index: &Value,
        expected: &Value,
        new: &Value,
    ) -> Result<String, EmitError> {
        let place = self.place(root, index)?;
        let (expected, new) = (self.atomic_operand(root, expected)?, self.atomic_operand(root, new)?);
        let old = format!("atomicCompareExchangeWeak(&{place}, {expected}, {new}).old_value");
        Ok(self.atomic_result(root, old))
    }

    /// A word as an atomic root has it.
    fn atomic_operand(&mut self, root: RootId, word: &Value) -> Result<String, EmitError> {
        let word = self.value(word)?;
        Ok(if self.signed.contains(&root) { format!("bitcast<i32>({word})") } else { word })
    }

    /// A word of an atomic root as all others are.
    fn atomic_result(&self, root: RootId, word: String) -> String {
        if self.signed.contains(&root) { format!("bitcast<u32>({word})") } else { word }
    }

    pub fn word_count(&self, root: RootId) -> String {
        let words = if self.kernel.root(root).vec4 { 4 } else { 1 };
        format!("(arrayLength(&r{}) * {words}u)", root.0)
    }
}

/// The roots with signed minima or maxima: the words of an `atomic<u32>` have only unsigned ones.
pub fn signed_roots(kernel: &Kernel) -> BTreeSet<RootId> {
    let signed = |op: &Op| match op {
        Op::AtomicWord(AtomicOp::SMin | AtomicOp::SMax, root, ..) => Some(*root),
        _ => None,
    };
    kernel.function.placed().filter_map(|id| signed(&kernel.function[id].op)).collect()
}
