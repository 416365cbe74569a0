//! An open device: how it is reached, what it can do, and how its errors are told.

use super::adapters::{AdapterKind, AdapterReport};
use super::faults::Faults;
use crate::backend::BackendError;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What is used where the adapter has it.
const WANTED: wgpu::Features = wgpu::Features::PASSTHROUGH_SHADERS
    .union(wgpu::Features::IMMEDIATES)
    .union(wgpu::Features::SUBGROUP)
    .union(wgpu::Features::SHADER_INT64);

pub(super) struct Connection {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
    pub limits: wgpu::Limits,
    pub report: AdapterReport,
    faults: Faults,
}

impl Connection {
    /// Opens `adapter` with all that it offers of what kernels use.
    pub fn open(adapter: &wgpu::Adapter, report: AdapterReport) -> Result<Self, BackendError> {
        let limits = adapter.limits();
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("parallax"),
            required_features: adapter.features() & WANTED,
            required_limits: limits.clone(),
            // SAFETY: the one experimental feature in use is the passthrough of modules, which come from the
            // kernel compiler.
            experimental_features: unsafe { wgpu::ExperimentalFeatures::enabled() },
            ..Default::default()
        };
        let opened = pollster::block_on(adapter.request_device(&descriptor));
        let (device, queue) = opened.map_err(|error| BackendError::Unusable {
            adapter: report.name.clone(),
            reason: format!("its driver refuses to open it ({error})"),
        })?;
        let faults = Faults::listen(&device);
        Ok(Self { device, queue, limits, report, faults })
    }

    pub fn has(&self, feature: wgpu::Features) -> bool {
        self.device.features().contains(feature)
    }

    /// Whether this is a program and no hardware.
    pub fn is_software(&self) -> bool {
        self.report.kind == AdapterKind::Software
    }

    /// What wgpu has reported since the last call, told as an error of `what`.
    pub fn check(&self, what: impl FnOnce() -> String) -> Result<(), BackendError> {
        self.faults.check(&self.report.name, what)
    }

    /// Refuses more of something than the adapter has.
    pub fn check_limit(
        &self,
        what: impl FnOnce() -> String,
        wanted: u64,
        limit: u64,
    ) -> Result<(), BackendError> {
        if wanted <= limit {
            return Ok(());
        }
        Err(BackendError::Limit { adapter: self.report.name.clone(), what: what(), wanted, limit })
    }

    /// Size of the largest buffer that can be bound.
    pub fn max_buffer_bytes(&self) -> u64 {
        self.limits.max_buffer_size.min(self.limits.max_storage_buffer_binding_size)
    }

    pub fn buffer(&self, label: &str, bytes: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        let descriptor =
            wgpu::BufferDescriptor { label: Some(label), size: bytes, usage, mapped_at_creation: false };
        self.device.create_buffer(&descriptor)
    }

    pub fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("parallax") })
    }

    /// Waits until the device has done everything that was submitted. wgpu panics here when the device is
    /// lost.
    pub fn wait(&self) {
        let waited = catch_unwind(AssertUnwindSafe(|| self.device.poll(wgpu::PollType::wait_indefinitely())));
        match waited {
            Ok(Ok(_)) => {}
            Ok(Err(error)) => self.faults.lose(error.to_string()),
            Err(_) => self.faults.lose("the driver no longer answers".into()),
        }
    }
}
