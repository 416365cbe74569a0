//! Which backend a user gets.

use parallax::backend::gpu::AdapterKind;
use parallax::backend::{Backend, BackendError, Choice, Device, Profile, Selection, adapters, select};
use parallax_tests::gpu::{Driver, open};

fn chosen(backend: Choice, adapter: Option<&str>) -> Result<Device, BackendError> {
    select(&Selection { backend, adapter: adapter.map(String::from), profile: Profile::Strict, threads: 1 })
}

fn is_software(device: &Device) -> bool {
    matches!(device, Device::Gpu(gpu) if gpu.report().kind == AdapterKind::Software)
}

#[test]
fn nothing_asked_for_is_never_software() {
    assert!(!is_software(&chosen(Choice::Auto, None).unwrap()));
}

#[test]
fn the_cpu_is_always_there() {
    let cpu = chosen(Choice::Cpu, None).unwrap();
    assert!(cpu.describe().starts_with("CPU (") && cpu.describe().ends_with(", 1 thread)"));
    let text = chosen(Choice::Cpu, Some("llvmpipe")).err().unwrap().to_string();
    assert!(text.starts_with("an adapter (`llvmpipe`) is no CPU"), "{text}");
}

#[test]
fn software_is_used_when_it_is_asked_for() {
    if open(Driver::Lavapipe, Profile::Strict).is_none() {
        return;
    }
    for choice in [Choice::Auto, Choice::Gpu] {
        let device = chosen(choice, Some("LLVMpipe")).unwrap();
        assert!(device.describe().starts_with("llvmpipe") && is_software(&device), "{}", device.describe());
    }
    let has_hardware = adapters(Profile::Strict).iter().any(|a| a.kind != AdapterKind::Software);
    assert_eq!(is_software(&chosen(Choice::Gpu, None).unwrap()), !has_hardware);
}

#[test]
fn an_unknown_adapter_is_an_error_that_lists_all() {
    if open(Driver::Lavapipe, Profile::Strict).is_none() {
        return;
    }
    let text = chosen(Choice::Auto, Some("Voodoo 2")).err().unwrap().to_string();
    assert!(text.starts_with("no adapter is called `Voodoo 2`; there are `"), "{text}");
    assert!(text.contains("llvmpipe"), "{text}");
}

#[test]
fn a_report_says_why() {
    for report in adapters(Profile::Strict) {
        assert!(report.why.starts_with(if report.used { "used" } else { "not us" }), "{}", report.why);
        assert!(report.kind != AdapterKind::Software || !report.used);
        assert!(report.max_buffer_bytes >= 1 << 20 && report.max_workgroups >= 65535, "{report:?}");
    }
}
