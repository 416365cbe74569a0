//! Kernels made by hand, for the tests of each stage.

pub mod operations;
pub mod places;

use crate::ir::{
    BinaryOp, Block, BlockId, Function, Id, IntPredicate, Kernel, Op, Root, RootId, Space, Terminator, Type,
    Value,
};

/// Builds a kernel block by block.
pub struct KernelBuilder {
    kernel: Kernel,
}

impl KernelBuilder {
    /// A kernel `made` of one invocation per workgroup, with so many empty blocks.
    pub fn new(blocks: usize) -> Self {
        let empty = |k| Block {
            name: format!("block{k}"),
            instructions: Vec::new(),
            terminator: Terminator::Unreachable,
        };
        let function =
            Function { name: "made".into(), blocks: (0..blocks).map(empty).collect(), ..Function::default() };
        Self { kernel: Kernel { name: "made".into(), threads: [1, 1, 1], function, roots: Vec::new() } }
    }

    /// Sets the size of a workgroup.
    pub fn threads(&mut self, threads: [u32; 3]) -> &mut Self {
        self.kernel.threads = threads;
        self
    }

    /// Adds a root of so many words.
    pub fn root(&mut self, space: Space, written: bool, words: u32) -> RootId {
        let root = Root {
            space,
            name: format!("root{}", self.kernel.roots.len()),
            written,
            atomic: false,
            vec4: false,
            words,
            element_bytes: 4 * words,
        };
        self.kernel.roots.push(root);
        RootId::new(self.kernel.roots.len() - 1)
    }

    /// Adds a storage buffer of words in set 0.
    pub fn buffer(&mut self, binding: u32, written: bool) -> RootId {
        self.root(Space::Storage { set: 0, binding }, written, 1)
    }

    /// A root, to be changed.
    pub fn root_mut(&mut self, root: RootId) -> &mut Root {
        &mut self.kernel.roots[root.index()]
    }

    /// Adds an instruction at the end of a block.
    pub fn push(&mut self, block: usize, op: Op, ty: Type) -> Value {
        let id = self.kernel.function.push(op, ty);
        self.kernel.function.instructions[id.index()].name = format!("v{}", id.0).as_str().into();
        self.kernel.function.blocks[block].instructions.push(id);
        Value::Inst(id)
    }

    /// Adds `i = phi [0, before], [i + 1, block]` and `i + 1` to a block that is a loop; both values.
    pub fn counter(&mut self, block: usize, before: usize) -> (Value, Value) {
        let (phi, next) = (Id::new(self.kernel.function.instructions.len()), Value::Inst);
        let next = next(Id(phi.0 + 1));
        let edges = vec![(word(0), BlockId::new(before)), (next.clone(), BlockId::new(block))];
        let phi = self.push(block, Op::Phi(edges), Type::I32);
        let next = self.push(block, add(phi.clone(), word(1)), Type::I32);
        (phi, next)
    }

    /// Says how a block ends.
    pub fn end(&mut self, block: usize, terminator: Terminator) -> &mut Self {
        self.kernel.function.blocks[block].terminator = terminator;
        self
    }

    /// The kernel.
    pub fn build(self) -> Kernel {
        self.kernel
    }
}

/// A constant word.
pub fn word(value: u32) -> Value {
    Value::u32(value)
}

/// `a + b` of words.
pub fn add(a: Value, b: Value) -> Op {
    Op::Binary(BinaryOp::Add, a, b)
}

/// `a < b` of unsigned words.
pub fn less(a: Value, b: Value) -> Op {
    Op::IntCompare(IntPredicate::Ult, a, b)
}

/// What `spirv-val` says of a module: nothing if it is valid, and nothing, but loudly, if there is no
/// `spirv-val`.
pub fn spirv_problems(words: &[u32]) -> Option<String> {
    let file = tempfile::NamedTempFile::new().expect("a temporary file");
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    std::fs::write(file.path(), bytes).expect("a temporary file can be written");
    let validator = std::process::Command::new("spirv-val");
    match { validator }.args(["--target-env", "vulkan1.1"]).arg(file.path()).output() {
        Ok(output) if output.status.success() => None,
        Ok(output) => Some(String::from_utf8_lossy(&output.stderr).into_owned()),
        Err(_) => {
            eprintln!(
                "SKIPPED: a module was not validated, since spirv-val (Debian: spirv-tools) is not installed"
            );
            None
        }
    }
}

/// What naga's validator says of a text: nothing if it is valid.
pub fn wgsl_problems(text: &str) -> Option<String> {
    let module = match naga::front::wgsl::parse_str(text) {
        Ok(module) => module,
        Err(error) => return Some(error.emit_to_string(text)),
    };
    let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::all());
    let validated = naga::valid::Validator::new(flags, capabilities)
        .subgroup_stages(naga::valid::ShaderStages::COMPUTE)
        .subgroup_operations(naga::valid::SubgroupOperationSet::all())
        .validate(&module);
    validated.err().map(|error| error.emit_to_string(text))
}
