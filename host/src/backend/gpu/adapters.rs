//! The adapters of this machine, what each supports, and which one is used.

use crate::backend::{BackendError, Profile};
use serde::Serialize;

/// What kind of thing an adapter is, the preferred one first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AdapterKind {
    /// A graphics card.
    Discrete,
    /// A GPU that shares the processor's memory.
    Integrated,
    /// A part of a GPU that a host lends out.
    Virtual,
    /// Its driver does not say.
    Other,
    /// A program that runs on the processor.
    Software,
}

/// What an adapter is and supports, as far as it matters here.
#[derive(Clone, Debug, Serialize)]
pub struct AdapterReport {
    /// Its name.
    pub name: String,
    /// Its driver and the driver's version.
    pub driver: String,
    /// What kind of thing it is.
    pub kind: AdapterKind,
    /// Whether it takes SPIR-V as it is, without which there is no strict profile.
    pub spirv: bool,
    /// Whether it has push constants.
    pub push_constants: bool,
    /// Whether it has subgroup operations.
    pub subgroup: bool,
    /// Whether it has 64-bit integers.
    pub int64: bool,
    /// Size in bytes of the largest buffer that a pass can bind.
    pub max_buffer_bytes: u64,
    /// Most storage buffers that a pass can bind.
    pub max_buffers: u32,
    /// Most workgroups along an axis of one run.
    pub max_workgroups: u32,
    /// Most invocations of a workgroup.
    pub max_workgroup_invocations: u32,
    /// Bytes of push constants.
    pub max_push_bytes: u32,
    /// What keeps it from being used in the profile that was asked for.
    pub problem: Option<String>,
    /// Whether it would be used when nothing is asked for.
    pub used: bool,
    /// Why it would be used, or why not.
    pub why: String,
}

/// Everything that a Vulkan driver offers on this machine.
pub(super) fn enumerate(profile: Profile) -> Vec<(wgpu::Adapter, AdapterReport)> {
    let descriptor = wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        flags: wgpu::InstanceFlags::empty().with_env(),
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    };
    let instance = wgpu::Instance::new(descriptor);
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::VULKAN));
    adapters.into_iter().map(|adapter| (report(&adapter, profile), adapter)).map(|(r, a)| (a, r)).collect()
}

/// The adapters of this machine; `used` and `why` tell which one an automatic choice would take for
/// `profile`.
pub fn adapters(profile: Profile) -> Vec<AdapterReport> {
    let mut reports: Vec<_> = enumerate(profile).into_iter().map(|(_, report)| report).collect();
    let used = choose(&reports, None, false).ok();
    for (index, report) in reports.iter_mut().enumerate() {
        report.used = used == Some(index);
        report.why = why(report);
    }
    reports
}

fn why(report: &AdapterReport) -> String {
    match &report.problem {
        Some(problem) => format!("not usable: {problem}"),
        None if report.used => "used: the best hardware".into(),
        None if report.kind == AdapterKind::Software => {
            "not used: software, which is used only when asked for by `--backend gpu` or `--adapter`".into()
        }
        None => "not used: another one is better; ask for it by `--adapter`".into(),
    }
}

fn report(adapter: &wgpu::Adapter, profile: Profile) -> AdapterReport {
    let (info, features, limits) = (adapter.get_info(), adapter.features(), adapter.limits());
    let spirv = features.contains(wgpu::Features::PASSTHROUGH_SHADERS);
    AdapterReport {
        name: info.name,
        driver: format!("{} {}", info.driver, info.driver_info).trim().to_string(),
        kind: match info.device_type {
            wgpu::DeviceType::DiscreteGpu => AdapterKind::Discrete,
            wgpu::DeviceType::IntegratedGpu => AdapterKind::Integrated,
            wgpu::DeviceType::VirtualGpu => AdapterKind::Virtual,
            wgpu::DeviceType::Cpu => AdapterKind::Software,
            wgpu::DeviceType::Other => AdapterKind::Other,
        },
        spirv,
        push_constants: features.contains(wgpu::Features::IMMEDIATES),
        subgroup: features.contains(wgpu::Features::SUBGROUP),
        int64: features.contains(wgpu::Features::SHADER_INT64),
        max_buffer_bytes: limits.max_buffer_size.min(limits.max_storage_buffer_binding_size),
        max_buffers: limits.max_storage_buffers_per_shader_stage,
        max_workgroups: limits.max_compute_workgroups_per_dimension,
        max_workgroup_invocations: limits.max_compute_invocations_per_workgroup,
        max_push_bytes: limits.max_immediate_size,
        problem: problem(spirv, profile),
        used: false,
        why: String::new(),
    }
}

fn problem(spirv: bool, profile: Profile) -> Option<String> {
    (!spirv && profile == Profile::Strict)
        .then(|| "it takes no SPIR-V as it is, which the strict profile needs; use `--profile fast`".into())
}

/// Which of `adapters` to use.
///
/// One that is named (a part of its name or driver, in any case) is taken whatever it is. Else the best
/// hardware: discrete before integrated before virtual. A software driver, the first one listed, only if a
/// GPU is `forced` and there is no hardware.
pub(super) fn choose(
    adapters: &[AdapterReport],
    name: Option<&str>,
    forced: bool,
) -> Result<usize, BackendError> {
    let usable = |index: &usize| adapters[*index].problem.is_none();
    let named: Vec<usize> =
        (0..adapters.len()).filter(|&i| name.is_none_or(|n| matches(&adapters[i], n))).collect();
    let allowed = named
        .iter()
        .copied()
        .filter(usable)
        .filter(|&index| name.is_some() || forced || adapters[index].kind != AdapterKind::Software);
    match allowed.min_by_key(|&index| adapters[index].kind) {
        Some(index) => Ok(index),
        None => Err(refusal(adapters, &named, name)),
    }
}

fn matches(adapter: &AdapterReport, name: &str) -> bool {
    let name = name.to_lowercase();
    adapter.name.to_lowercase().contains(&name) || adapter.driver.to_lowercase().contains(&name)
}

/// Why there is nothing to choose.
fn refusal(adapters: &[AdapterReport], named: &[usize], name: Option<&str>) -> BackendError {
    if let Some(report) = named.iter().map(|&index| &adapters[index]).find(|report| report.problem.is_some())
    {
        let reason = report.problem.clone().unwrap_or_default();
        return BackendError::Unusable { adapter: report.name.clone(), reason };
    }
    match name {
        Some(name) if !adapters.is_empty() => BackendError::UnknownAdapter {
            name: name.into(),
            available: adapters.iter().map(|a| format!("`{}`", a.name)).collect::<Vec<_>>().join(", "),
        },
        _ => BackendError::NoAdapter {
            reason: match adapters.is_empty() {
                true => "no Vulkan driver was found; install one, or use `--backend cpu`".into(),
                false => "there are software drivers only; ask for one by `--backend gpu`".into(),
            },
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn adapter(name: &str, kind: AdapterKind) -> AdapterReport {
        AdapterReport {
            name: name.into(),
            driver: String::new(),
            kind,
            spirv: true,
            push_constants: true,
            subgroup: true,
            int64: true,
            max_buffer_bytes: 0,
            max_buffers: 0,
            max_workgroups: 0,
            max_workgroup_invocations: 0,
            max_push_bytes: 0,
            problem: None,
            used: false,
            why: String::new(),
        }
    }

    fn all() -> Vec<AdapterReport> {
        use AdapterKind::*;
        [("llvmpipe", Software), ("Iris", Integrated), ("Arc", Discrete), ("Virtio", Virtual)]
            .map(|(name, kind)| adapter(name, kind))
            .to_vec()
    }

    #[test]
    fn hardware_is_chosen_by_its_kind() {
        let mut adapters = all();
        assert_eq!(choose(&adapters, None, false).unwrap(), 2);
        adapters.remove(2);
        assert_eq!(choose(&adapters, None, true).unwrap(), 1);
        adapters.remove(1);
        assert_eq!(choose(&adapters, None, false).unwrap(), 1);
    }

    #[test]
    fn software_is_chosen_only_when_asked_for() {
        let adapters = &all()[..1];
        let text = choose(adapters, None, false).unwrap_err().to_string();
        assert!(text.contains("software drivers only"), "{text}");
        assert_eq!(choose(adapters, None, true).unwrap(), 0);
        assert_eq!(choose(&all(), Some("LLVM"), false).unwrap(), 0);
    }

    #[test]
    fn an_unknown_name_lists_what_there_is() {
        let text = choose(&all(), Some("GeForce"), true).unwrap_err().to_string();
        assert_eq!(text, "no adapter is called `GeForce`; there are `llvmpipe`, `Iris`, `Arc`, `Virtio`");
        let text = choose(&[], Some("GeForce"), true).unwrap_err().to_string();
        assert!(text.contains("no Vulkan driver was found"), "{text}");
    }

    #[test]
    fn what_lacks_a_feature_is_passed_over_or_refused_by_name() {
        let mut adapters = all();
        adapters[2].problem = problem(false, Profile::Strict);
        assert_eq!(choose(&adapters, None, false).unwrap(), 1);
        let text = choose(&adapters, Some("arc"), false).unwrap_err().to_string();
        assert!(text.starts_with("`Arc` cannot be used: it takes no SPIR-V"), "{text}");
        assert_eq!(problem(false, Profile::Fast), None);
    }
}
