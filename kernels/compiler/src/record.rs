//! What the manifest says of a compiled kernel.

use crate::compile::Entry;
use crate::ir::{Kernel, Op, Root, Space};
use crate::manifest::{BindingAccess, BindingRecord, EntryRecord, Manifest, SpecialisationRecord, sha256};
use rspirv::spirv::{Capability, Op as SpirvOp};

/// The manifest of `entries`, which come from sources of that hash.
pub fn manifest(entries: &[Entry], sources_sha256: String) -> Manifest {
    Manifest {
        compiler: concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION")).to_owned(),
        sources_sha256,
        entries: entries.iter().map(record).collect(),
    }
}

fn record(entry: &Entry) -> EntryRecord {
    let Entry { name, profile, kernel, .. } = entry;
    let push = kernel.roots.iter().find(|root| root.space == Space::Push);
    EntryRecord {
        name: name.clone(),
        profile: *profile,
        module: entry.module_path(),
        module_sha256: sha256(&entry.module_bytes()),
        wgsl: entry.wgsl.as_ref().map(|_| entry.wgsl_path()),
        workgroup_size: kernel.threads,
        bindings: bindings(kernel),
        push_constant_bytes: push.map_or(0, |root| root.element_bytes),
        specialisation: specialisation(kernel),
        capabilities: capabilities(&entry.spirv),
    }
}

impl Entry {
    /// Where the module lies, relative to the manifest.
    pub fn module_path(&self) -> String {
        format!("{}/{}.spv", self.profile, self.name)
    }

    /// Where the WGSL text lies, relative to the manifest.
    pub fn wgsl_path(&self) -> String {
        format!("{}/{}.wgsl", self.profile, self.name)
    }

    /// The module as bytes: its words, the lowest byte first.
    pub fn module_bytes(&self) -> Vec<u8> {
        self.spirv.iter().flat_map(|word| word.to_le_bytes()).collect()
    }
}

fn bindings(kernel: &Kernel) -> Vec<BindingRecord> {
    let mut bindings: Vec<_> = kernel.roots.iter().filter_map(binding).collect();
    bindings.sort_by_key(|binding| (binding.set, binding.binding));
    bindings
}

fn binding(root: &Root) -> Option<BindingRecord> {
    let (set, binding, access) = match root.space {
        Space::Uniform { set, binding } => (set, binding, BindingAccess::Uniform),
        Space::Storage { set, binding } if root.atomic => (set, binding, BindingAccess::Atomic),
        Space::Storage { set, binding } if root.written => (set, binding, BindingAccess::Write),
        Space::Storage { set, binding } => (set, binding, BindingAccess::Read),
        _ => return None,
    };
    Some(BindingRecord { set, binding, access, element_bytes: root.element_bytes })
}

fn specialisation(kernel: &Kernel) -> Vec<SpecialisationRecord> {
    let function = &kernel.function;
    let mut constants: Vec<_> = function
        .placed()
        .filter_map(|id| match function[id].op {
            Op::SpecConstant { id, default } => Some(SpecialisationRecord { id, default_bits: default }),
            _ => None,
        })
        .collect();
    constants.sort();
    constants.dedup();
    constants
}

/// The capabilities of a module beyond `Shader`. They come first in it, each an instruction of two words.
fn capabilities(words: &[u32]) -> Vec<String> {
    let instruction = |pair: &[u32]| match pair {
        &[head, capability] if head == 2 << 16 | SpirvOp::Capability as u32 => {
            Capability::from_u32(capability)
        }
        _ => None,
    };
    let declared = words[5.min(words.len())..].chunks_exact(2).map_while(instruction);
    declared.filter(|&c| c != Capability::Shader).map(|c| format!("{c:?}")).collect()
}
