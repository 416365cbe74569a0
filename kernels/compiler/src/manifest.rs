//! `manifest.json`: what a host must know of each module to bind and dispatch it, and the hashes that tell
//! whether it is up to date.
//!
//! Its order is stable (entries by profile and name, bindings by set and number), so that the same sources
//! give the same bytes.

use crate::Profile;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The contents of `manifest.json`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Which compiler, in which version.
    pub compiler: String,
    /// SHA-256 of the kernel crate's sources and of those of its path dependencies, in hexadecimal.
    pub sources_sha256: String,
    /// Every module, by profile and name.
    pub entries: Vec<EntryRecord>,
}

/// One entry point in one profile.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EntryRecord {
    /// Name of the entry point.
    pub name: String,
    /// Arithmetic in which it was compiled.
    pub profile: Profile,
    /// The SPIR-V module, relative to the manifest, with `/`.
    pub module: String,
    /// SHA-256 of the module, in hexadecimal.
    pub module_sha256: String,
    /// The WGSL text, relative to the manifest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wgsl: Option<String>,
    /// Invocations of a workgroup along x, y and z.
    pub workgroup_size: [u32; 3],
    /// Buffers and uniforms, by set and number.
    pub bindings: Vec<BindingRecord>,
    /// Size of the push constant; 0 if there is none.
    pub push_constant_bytes: u32,
    /// Specialisation constants, by number.
    pub specialisation: Vec<SpecialisationRecord>,
    /// SPIR-V capabilities beyond `Shader`, by number.
    pub capabilities: Vec<String>,
}

/// A resource of an entry point.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BindingRecord {
    /// Descriptor set.
    pub set: u32,
    /// Number in the set.
    pub binding: u32,
    /// What is done with it.
    pub access: BindingAccess,
    /// Size of an element of a storage buffer, or of the whole uniform.
    pub element_bytes: u32,
}

/// How an entry point uses a binding.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BindingAccess {
    /// A uniform buffer.
    Uniform,
    /// A storage buffer that is only read.
    Read,
    /// A storage buffer that is read and written, or only written.
    Write,
    /// A storage buffer of words that are changed atomically.
    Atomic,
}

/// A specialisation constant, a word of bits (of a `u32`, `f32` or `bool`).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpecialisationRecord {
    /// Its `SpecId`.
    pub id: u32,
    /// Its bits when it is not set.
    pub default_bits: u32,
}

impl Manifest {
    /// The text of the file, which ends in a line feed.
    pub fn to_json(&self) -> String {
        // Only maps with keys that are not strings can fail, and there are none.
        serde_json::to_string_pretty(self).map(|text| text + "\n").unwrap_or_default()
    }

    /// Reads what [`Manifest::to_json`] wrote.
    ///
    /// # Errors
    /// When the text is no JSON, a field is missing, or one is not known.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }
}

/// SHA-256 of `bytes`, in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(Sha256::digest(bytes).as_slice())
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn manifest() -> Manifest {
        let entry = EntryRecord {
            name: "trace".into(),
            profile: Profile::Fast,
            module: "fast/trace.spv".into(),
            module_sha256: sha256(b"abc"),
            wgsl: Some("fast/trace.wgsl".into()),
            workgroup_size: [8, 8, 1],
            bindings: vec![BindingRecord {
                set: 0,
                binding: 3,
                access: BindingAccess::Atomic,
                element_bytes: 4,
            }],
            push_constant_bytes: 16,
            specialisation: vec![SpecialisationRecord { id: 1, default_bits: 0x3f80_0000 }],
            capabilities: vec!["GroupNonUniform".into()],
        };
        Manifest {
            compiler: "kernel-compiler 0.1.0".into(),
            sources_sha256: sha256(b""),
            entries: vec![entry],
        }
    }

    #[test]
    fn survives_the_way_through_json() {
        let text = manifest().to_json();
        assert_eq!(Manifest::from_json(&text).unwrap(), manifest());
        assert!(text.ends_with("}\n") && text.contains("\"access\": \"atomic\""), "{text}");
    }

    #[test]
    fn an_unknown_field_is_an_error() {
        let text = manifest().to_json().replace("\"compiler\"", "\"complier\"");
        let message = Manifest::from_json(&text).unwrap_err().to_string();
        assert!(message.contains("complier"), "{message}");
    }

    /// FIPS 180-2, appendix B.1.
    #[test]
    fn the_hash_is_sha_256() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
