//! The GPU backend: wgpu on Vulkan, which hands our SPIR-V to the driver as it is.
//!
//! naga's SPIR-V front end is never in the way: it drops NoContraction and turns unordered comparisons into
//! ordered ones. In the fast profile an adapter that takes no SPIR-V gets the WGSL text of the same kernel.

mod adapters;
mod connection;
mod faults;
mod modules;
mod pipeline;
mod raw;
mod specialise;
mod spirv;
mod store;

pub use adapters::{AdapterKind, AdapterReport, adapters};
pub use modules::{Module, Modules};
pub use raw::RawBinding;
pub use specialise::specialise;
pub use spirv::SpirvError;

use crate::backend::arguments::Arguments;
use crate::backend::grid::Grid;
use crate::backend::usage::Usage;
use crate::backend::{Backend, BackendError, Profile, check_handle, new_owner};
use bytemuck::Pod;
use connection::Connection;
use kernel_api::{Access, Buffer, Pass};
use pipeline::{Code, Declaration, Pipeline, Slot};
use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap};
use store::{DeviceBuffer, Poison};

/// Invocations of a heavy pass that even a slow GPU does in a fraction of the two seconds after which a
/// driver gives up.
const HARDWARE_HINT: u32 = 1 << 20;

/// Software drivers have no watchdog; this is for the caller's progress.
const SOFTWARE_HINT: u32 = 1 << 18;

/// An entry point and its specialisation constants (number, bits): what a pipeline is compiled for.
type Variant = (&'static str, Vec<(u32, u32)>);

/// Runs passes on a GPU, or on a software driver that stands in for one.
///
/// Runs are recorded and handed to the driver a batch at a time; what a pass did is known after
/// [`Backend::finish`] or [`Backend::read`]. An empty buffer of one-word elements has one (poisoned) element
/// for kernels, as no driver binds an empty one.
pub struct Gpu {
    owner: u32,
    next_id: u32,
    profile: Profile,
    connection: Connection,
    modules: Modules,
    pipelines: HashMap<Variant, Pipeline>,
    buffers: BTreeMap<u32, DeviceBuffer>,
    usage: Usage,
    poison: Poison,
    recording: Option<wgpu::CommandEncoder>,
    recorded: u64,
}

impl Gpu {
    /// The adapter whose name contains `name`, or the best one (a software driver if there is no hardware).
    pub fn open(profile: Profile, name: Option<&str>) -> Result<Self, BackendError> {
        Self::choose(profile, name, true)
    }

    /// The same adapter in another profile.
    pub fn in_profile(&self, profile: Profile) -> Result<Self, BackendError> {
        Self::open(profile, Some(&self.report().name))
    }

    /// The best hardware.
    pub(super) fn open_hardware(profile: Profile) -> Result<Self, BackendError> {
        Self::choose(profile, None, false)
    }

    fn choose(profile: Profile, name: Option<&str>, forced: bool) -> Result<Self, BackendError> {
        let (adapters, reports): (Vec<_>, Vec<_>) = adapters::enumerate(profile).into_iter().unzip();
        let index = adapters::choose(&reports, name, forced)?;
        let connection = Connection::open(&adapters[index], reports[index].clone())?;
        let poison = Poison::new(&connection);
        connection.check(|| "the device's first buffer".into())?;
        Ok(Self {
            owner: new_owner(),
            next_id: 0,
            profile,
            connection,
            modules: Modules::embedded(profile),
            pipelines: HashMap::new(),
            buffers: BTreeMap::new(),
            usage: Usage::default(),
            poison,
            recording: None,
            recorded: 0,
        })
    }

    /// The same device with other modules: how an engine brings the kernels of its own crate
    /// (start from [`Modules::embedded`] to add to those of this one).
    ///
    /// # Safety of modules
    /// SPIR-V goes to the driver unchecked. Use what `kernel-compiler` makes, or put it through `spirv-val`
    /// yourself.
    pub fn with_modules(mut self, modules: Modules) -> Self {
        self.modules = modules;
        self.pipelines.clear();
        self
    }

    /// The adapter in use.
    pub fn report(&self) -> &AdapterReport {
        &self.connection.report
    }

    /// The device, for an engine's own work beside the passes.
    pub fn device(&self) -> &wgpu::Device {
        &self.connection.device
    }

    /// The arithmetic of the passes.
    pub fn profile(&self) -> Profile {
        self.profile
    }

    /// Records a run whose arguments are checked.
    fn record<P: Pass>(&mut self, arguments: &Arguments, grid: Grid) -> Result<(), BackendError> {
        let connection = &self.connection;
        let pipeline = match self.pipelines.entry((P::NAME, arguments.constants.clone())) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                let pipeline = compile::<P>(connection, &self.modules, self.profile, &arguments.constants)?;
                entry.insert(pipeline)
            }
        };
        let uniforms = arguments.bytes.iter().filter(|(binding, _)| binding.access == Access::Uniform);
        let uniforms = uniforms
            .map(|(binding, bytes)| Ok((binding, DeviceBuffer::uniform(connection, binding.name, bytes)?)))
            .collect::<Result<Vec<_>, BackendError>>()?;
        let mut resources: Vec<_> = uniforms
            .iter()
            .map(|(binding, uniform)| (binding.set, binding.binding, &uniform.buffer))
            .collect();
        resources.extend(arguments.buffers.iter().filter_map(|bound| {
            let stored = self.buffers.get(&bound.id)?;
            Some((bound.binding.set, bound.binding.binding, &stored.buffer))
        }));
        let push = arguments.bytes.iter().find(|(binding, _)| binding.access == Access::Push);
        let push = push.map_or(&[][..], |(_, bytes)| bytes);
        let encoder = self.recording.get_or_insert_with(|| connection.encoder());
        pipeline.record(connection, encoder, &resources, push, grid.groups);
        self.recorded += grid.invocations();
        connection.check(|| format!("pass `{}`", P::NAME))
    }

    /// Hands what was recorded to the driver.
    fn submit(&mut self) -> Result<(), BackendError> {
        if let Some(encoder) = self.recording.take() {
            self.connection.queue.submit([encoder.finish()]);
            self.recorded = 0;
        }
        self.connection.check(|| "the recorded passes".into())
    }

    fn insert<T: Pod>(&mut self, buffer: DeviceBuffer, count: u32) -> Buffer<T> {
        self.next_id += 1;
        self.usage.add(buffer.bytes);
        self.buffers.insert(self.next_id, buffer);
        Buffer::new(self.owner, self.next_id, count)
    }

    fn allocate<T: Pod>(&self, label: &'static str, len: usize) -> Result<(DeviceBuffer, u32), BackendError> {
        const { assert!(size_of::<T>() > 0 && size_of::<T>().is_multiple_of(4), "elements are whole words") };
        let count = u32::try_from(len).map_err(|_| BackendError::TooLong { label, len })?;
        let bytes = u64::from(count) * size_of::<T>() as u64;
        Ok((DeviceBuffer::storage(&self.connection, label, bytes)?, count))
    }
}

/// The code for `P` among `modules`, compiled.
fn compile<P: Pass>(
    connection: &Connection,
    modules: &Modules,
    profile: Profile,
    constants: &[(u32, u32)],
) -> Result<Pipeline, BackendError> {
    let module = modules.get(P::NAME);
    let module = module.ok_or(BackendError::NoModule { entry: P::NAME, profile: profile.name() })?;
    let takes_spirv = connection.has(wgpu::Features::PASSTHROUGH_SHADERS) && !module.spirv.is_empty();
    let code = match &module.wgsl {
        Some(text) if !takes_spirv && profile == Profile::Fast => Code::Wgsl(text),
        _ => Code::Spirv(&module.spirv),
    };
    Pipeline::new(connection, &declaration::<P>(), code, constants)
}

fn declaration<P: Pass>() -> Declaration<'static> {
    let is_push = |access| access == Access::Push;
    let slots = P::BINDINGS.iter().filter(|b| !is_push(b.access));
    Declaration {
        entry: P::NAME,
        threads: P::THREADS,
        slots: slots.map(|b| Slot { set: b.set, binding: b.binding, access: b.access }).collect(),
        push_bytes: P::BINDINGS.iter().find(|b| is_push(b.access)).map_or(0, |b| b.element_bytes),
    }
}

impl Backend for Gpu {
    fn describe(&self) -> String {
        let report = self.report();
        format!("{} ({})", report.name, report.driver)
    }

    fn create<T: Pod>(&mut self, label: &'static str, len: usize) -> Result<Buffer<T>, BackendError> {
        let (buffer, count) = self.allocate::<T>(label, len)?;
        let encoder = self.recording.get_or_insert_with(|| self.connection.encoder());
        self.poison.fill(encoder, &buffer.buffer);
        Ok(self.insert(buffer, count))
    }

    fn upload<T: Pod>(&mut self, label: &'static str, data: &[T]) -> Result<Buffer<T>, BackendError> {
        if data.is_empty() {
            return self.create(label, 0);
        }
        let (buffer, count) = self.allocate::<T>(label, data.len())?;
        buffer.fill(&self.connection, bytemuck::cast_slice(data));
        self.connection.check(|| format!("the upload of `{label}`"))?;
        Ok(self.insert(buffer, count))
    }

    fn read<T: Pod>(&mut self, buffer: Buffer<T>) -> Result<Vec<T>, BackendError> {
        self.submit()?;
        let stored = self.buffers.get(&buffer.id);
        let stored = check_handle("read", self.owner, buffer, stored, |stored| stored.bytes as usize)?;
        Ok(bytemuck::pod_collect_to_vec(&stored.read(&self.connection)?))
    }

    fn release<T: Pod>(&mut self, buffer: Buffer<T>) {
        if buffer.owner == self.owner
            && let Some(stored) = self.buffers.remove(&buffer.id)
        {
            self.usage.remove(stored.bytes);
        }
    }

    fn run<P: Pass>(&mut self, pass: &P, invocations: [u32; 3]) -> Result<(), BackendError> {
        let arguments = Arguments::of(pass);
        arguments.check::<P>(self.owner, |id| self.buffers.contains_key(&id))?;
        let grid = Grid::of::<P>(invocations)?;
        if grid.count() == 0 {
            return Ok(());
        }
        let limit = self.connection.limits.max_compute_workgroups_per_dimension.into();
        let widest = grid.groups.into_iter().max().unwrap_or(0).into();
        self.connection.check_limit(
            || format!("workgroups of `{}` along an axis", P::NAME),
            widest,
            limit,
        )?;
        if self.recorded + grid.invocations() > u64::from(self.max_invocations_hint()) {
            self.submit()?;
        }
        self.record::<P>(&arguments, grid)
    }

    fn finish(&mut self) -> Result<(), BackendError> {
        self.submit()?;
        self.connection.wait();
        self.connection.check(|| "the submitted passes".into())
    }

    fn max_invocations_hint(&self) -> u32 {
        if self.connection.is_software() { SOFTWARE_HINT } else { HARDWARE_HINT }
    }

    fn max_buffer_bytes(&self) -> u64 {
        self.connection.max_buffer_bytes()
    }

    fn take_peak_bytes(&mut self) -> u64 {
        self.usage.take_peak()
    }
}
