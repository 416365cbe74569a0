//! The committed modules: the manifest describes what is there, and the validators accept it. (That they are
//! what the compiler makes is checked by `kernel-compiler --check`.)

use kernel_compiler::Manifest;
use kernel_compiler::manifest::{EntryRecord, sha256};
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../spirv")
}

fn entries() -> Vec<EntryRecord> {
    let text = std::fs::read_to_string(folder().join("manifest.json")).expect("the manifest is committed");
    Manifest::from_json(&text).expect("the manifest can be read").entries
}

#[test]
fn modules_have_the_hashes_of_the_manifest() {
    let entries = entries();
    assert!(!entries.is_empty());
    for entry in entries {
        let module = std::fs::read(folder().join(&entry.module)).expect("the module is committed");
        assert_eq!(sha256(&module), entry.module_sha256, "{}", entry.module);
        assert!(entry.workgroup_size.iter().product::<u32>() > 0, "{}", entry.name);
    }
}

#[test]
fn spirv_val_accepts_every_module() {
    for entry in entries() {
        let mut validator = Command::new("spirv-val");
        let validator = validator.args(["--target-env", "vulkan1.1"]).arg(folder().join(&entry.module));
        let Ok(output) = validator.output() else {
            eprintln!("SKIPPED: modules are not validated: spirv-val (Debian: spirv-tools) is not installed");
            return;
        };
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {message}", entry.module);
    }
}

#[test]
fn naga_accepts_every_text() {
    let entries = entries();
    let texts: Vec<&String> = entries.iter().filter_map(|entry| entry.wgsl.as_ref()).collect();
    assert!(!texts.is_empty());
    for path in texts {
        let text = std::fs::read_to_string(folder().join(path)).expect("the text is committed");
        let module = naga::front::wgsl::parse_str(&text);
        let module = module.unwrap_or_else(|error| panic!("{path}: {}", error.emit_to_string(&text)));
        let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::all());
        let validated = naga::valid::Validator::new(flags, capabilities)
            .subgroup_stages(naga::valid::ShaderStages::COMPUTE)
            .subgroup_operations(naga::valid::SubgroupOperationSet::all())
            .validate(&module);
        validated.unwrap_or_else(|error| panic!("{path}: {}", error.emit_to_string(&text)));
    }
}
