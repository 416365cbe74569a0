//! A compiled entry point and how resources are bound to it.

use super::connection::Connection;
use super::specialise::specialise;
use super::spirv::Facts;
use crate::backend::BackendError;
use kernel_api::Access;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// A resource that an entry point declares.
#[derive(Clone, Copy)]
pub(super) struct Slot {
    pub set: u32,
    pub binding: u32,
    pub access: Access,
}

/// The code of an entry point.
pub(super) enum Code<'a> {
    Spirv(&'a [u32]),
    Wgsl(&'a str),
}

/// An entry point as its declaration says.
pub(super) struct Declaration<'a> {
    pub entry: &'a str,
    /// Workgroup size.
    pub threads: [u32; 3],
    pub slots: Vec<Slot>,
    pub push_bytes: u32,
}

pub(super) struct Pipeline {
    compute: wgpu::ComputePipeline,
    /// By descriptor set.
    layouts: Vec<Option<wgpu::BindGroupLayout>>,
}

impl Pipeline {
    /// Compiles `code`, which must fit `declaration`, with the constants (number, bits) frozen to their
    /// values.
    pub fn new(
        connection: &Connection,
        declaration: &Declaration<'_>,
        code: Code<'_>,
        constants: &[(u32, u32)],
    ) -> Result<Self, BackendError> {
        let what = || format!("the pipeline of `{}`", declaration.entry);
        let module = match code {
            Code::Spirv(words) => spirv_module(connection, declaration, words, constants)?,
            Code::Wgsl(text) => wgsl_module(connection, declaration.entry, text),
        };
        connection.check(what)?;
        let push_limit = connection.limits.max_immediate_size.into();
        connection.check_limit(what_push(declaration), declaration.push_bytes.into(), push_limit)?;
        let layouts = set_layouts(connection, &declaration.slots);
        let references: Vec<_> = layouts.iter().map(Option::as_ref).collect();
        let layout = connection.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(declaration.entry),
            bind_group_layouts: &references,
            immediate_size: declaration.push_bytes,
        });
        let named: Vec<(String, f64)> = match code {
            Code::Spirv(_) => Vec::new(),
            Code::Wgsl(_) => constants.iter().map(|&(id, bits)| (id.to_string(), bits.into())).collect(),
        };
        let named: Vec<(&str, f64)> = named.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let compute = connection.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(declaration.entry),
            layout: Some(&layout),
            module: &module,
            entry_point: Some(declaration.entry),
            compilation_options: wgpu::PipelineCompilationOptions { constants: &named, ..Default::default() },
            cache: None,
        });
        connection.check(what)?;
        Ok(Self { compute, layouts })
    }

    /// Records a dispatch of `groups` workgroups over `resources` (set, binding, buffer).
    pub fn record(
        &self,
        connection: &Connection,
        encoder: &mut wgpu::CommandEncoder,
        resources: &[(u32, u32, &wgpu::Buffer)],
        push: &[u8],
        groups: [u32; 3],
    ) {
        let bind_groups = self.bind_groups(connection, resources);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&self.compute);
        for (set, group) in &bind_groups {
            pass.set_bind_group(*set, group, &[]);
        }
        if !push.is_empty() {
            pass.set_immediates(0, push);
        }
        let [x, y, z] = groups;
        pass.dispatch_workgroups(x, y, z);
    }

    fn bind_groups(
        &self,
        connection: &Connection,
        resources: &[(u32, u32, &wgpu::Buffer)],
    ) -> Vec<(u32, wgpu::BindGroup)> {
        let sets =
            self.layouts.iter().enumerate().filter_map(|(set, layout)| Some((set as u32, layout.as_ref()?)));
        let make = |(set, layout)| {
            let entries: Vec<_> = resources
                .iter()
                .filter(|resource| resource.0 == set)
                .map(|&(_, binding, buffer)| wgpu::BindGroupEntry {
                    binding,
                    resource: buffer.as_entire_binding(),
                })
                .collect();
            let descriptor = wgpu::BindGroupDescriptor { label: None, layout, entries: &entries };
            (set, connection.device.create_bind_group(&descriptor))
        };
        sets.map(make).collect()
    }
}

fn what_push<'a>(declaration: &'a Declaration<'_>) -> impl FnOnce() -> String + 'a {
    || format!("the push constant of `{}`, in bytes,", declaration.entry)
}

/// Checks that `words` fit the declaration and hands them to the driver.
fn spirv_module(
    connection: &Connection,
    declaration: &Declaration<'_>,
    words: &[u32],
    constants: &[(u32, u32)],
) -> Result<wgpu::ShaderModule, BackendError> {
    let entry = declaration.entry;
    let bad = |source| BackendError::BadModule { entry: entry.into(), source };
    check_fit(connection, declaration, &Facts::of(words).map_err(bad)?)?;
    let words = specialise(words, constants).map_err(bad)?;
    let point = wgpu::PassthroughShaderEntryPoint {
        name: entry.into(),
        workgroup_size: into_tuple(declaration.threads),
    };
    let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
        label: Some(entry),
        entry_points: Cow::Owned(vec![point]),
        spirv: Some(words.into()),
        ..Default::default()
    };
    // SAFETY: the words are a module of the kernel compiler, which makes valid SPIR-V (tests put all of it
    // through spirv-val), or one for whose validity the caller of `with_modules` or `run_module` answers.
    Ok(unsafe { connection.device.create_shader_module_passthrough(descriptor) })
}

fn into_tuple([x, y, z]: [u32; 3]) -> (u32, u32, u32) {
    (x, y, z)
}

/// Refuses a module that is not the one of the declaration, or needs what the device lacks.
fn check_fit(
    connection: &Connection,
    declaration: &Declaration<'_>,
    facts: &Facts,
) -> Result<(), BackendError> {
    let entry = declaration.entry;
    let stale = |what: String| Err(BackendError::StaleModule { entry: entry.into(), what });
    match facts.workgroup_size(entry) {
        None => return stale("it has no such entry point".into()),
        Some(size) if size != declaration.threads => {
            return stale(format!("its workgroups are {size:?} and not {:?}", declaration.threads));
        }
        Some(_) => {}
    }
    for &(set, binding) in &facts.bindings {
        if !declaration.slots.iter().any(|slot| (slot.set, slot.binding) == (set, binding)) {
            return stale(format!("it uses set {set}, binding {binding}, which is not declared"));
        }
    }
    let needs = [
        (true, wgpu::Features::PASSTHROUGH_SHADERS, "SPIR-V modules as they are"),
        (facts.int64, wgpu::Features::SHADER_INT64, "64-bit integers"),
        (facts.subgroup, wgpu::Features::SUBGROUP, "subgroup operations"),
        (declaration.push_bytes > 0, wgpu::Features::IMMEDIATES, "push constants"),
    ];
    match needs.into_iter().find(|&(needed, feature, _)| needed && !connection.has(feature)) {
        None => Ok(()),
        Some((_, _, feature)) => Err(BackendError::MissingFeature {
            adapter: connection.report.name.clone(),
            entry: entry.into(),
            feature,
        }),
    }
}

fn wgsl_module(connection: &Connection, entry: &str, text: &str) -> wgpu::ShaderModule {
    let descriptor =
        wgpu::ShaderModuleDescriptor { label: Some(entry), source: wgpu::ShaderSource::Wgsl(text.into()) };
    // SAFETY: what naga's run-time checks guard against (indices out of range, endless loops) the kernels
    // themselves exclude, and buffers are created with robust access.
    unsafe {
        connection.device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked())
    }
}

/// The layout of each descriptor set; sets without resources have none.
fn set_layouts(connection: &Connection, slots: &[Slot]) -> Vec<Option<wgpu::BindGroupLayout>> {
    let mut sets: BTreeMap<u32, Vec<wgpu::BindGroupLayoutEntry>> = BTreeMap::new();
    for slot in slots {
        sets.entry(slot.set).or_default().push(layout_entry(slot));
    }
    let count = sets.keys().next_back().map_or(0, |last| last + 1);
    let layout = |entries: &Vec<_>| {
        connection.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries })
    };
    (0..count).map(|set| sets.get(&set).map(layout)).collect()
}

fn layout_entry(slot: &Slot) -> wgpu::BindGroupLayoutEntry {
    let ty = match slot.access {
        Access::Uniform | Access::Push => wgpu::BufferBindingType::Uniform,
        Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
        Access::Write | Access::Atomic => wgpu::BufferBindingType::Storage { read_only: false },
    };
    wgpu::BindGroupLayoutEntry {
        binding: slot.binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
        count: None,
    }
}
