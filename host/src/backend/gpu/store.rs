//! The buffers of a device, and the ways in and out of them.

use super::connection::Connection;
use crate::backend::BackendError;
use std::sync::mpsc;

/// Data moves in pieces of this size, so that a large buffer needs no second one as large beside it.
const PIECE_BYTES: u64 = 64 << 20;

/// Size of the buffer from which outputs are filled.
const POISON_BYTES: u64 = 1 << 20;

/// A buffer on the device. Without elements it has one word there, since no driver binds an empty buffer.
pub(super) struct DeviceBuffer {
    pub buffer: wgpu::Buffer,
    /// Size of the elements.
    pub bytes: u64,
}

impl DeviceBuffer {
    /// A buffer that passes can bind.
    pub fn storage(connection: &Connection, label: &str, bytes: u64) -> Result<Self, BackendError> {
        let what = || format!("buffer `{label}` of {bytes} bytes");
        connection.check_limit(what, bytes, connection.max_buffer_bytes())?;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
        let buffer = connection.buffer(label, bytes.max(4), usage);
        connection.check(what)?;
        Ok(Self { buffer, bytes })
    }

    /// A uniform buffer with `data`.
    pub fn uniform(connection: &Connection, label: &str, data: &[u8]) -> Result<Self, BackendError> {
        let limit = connection.limits.max_uniform_buffer_binding_size;
        let bytes = data.len().next_multiple_of(16) as u64;
        let what = || format!("uniform `{label}`");
        connection.check_limit(what, bytes, limit)?;
        let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
        let uniform = Self { buffer: connection.buffer(label, bytes, usage), bytes: data.len() as u64 };
        uniform.fill(connection, data);
        connection.check(what)?;
        Ok(uniform)
    }

    /// Writes `data` (whole words) to the start of the buffer, before anything that is submitted from now on.
    pub fn fill(&self, connection: &Connection, data: &[u8]) {
        for (number, piece) in data.chunks(PIECE_BYTES as usize).enumerate() {
            connection.queue.write_buffer(&self.buffer, number as u64 * PIECE_BYTES, piece);
            if piece.len() as u64 == PIECE_BYTES {
                connection.queue.submit([]);
            }
        }
    }

    /// What the buffer holds once all that was submitted is done.
    pub fn read(&self, connection: &Connection) -> Result<Vec<u8>, BackendError> {
        let mut data = Vec::new();
        let size = self.bytes as usize;
        data.try_reserve_exact(size).map_err(|_| BackendError::OutOfMemory {
            place: "the CPU".into(),
            what: format!("{size} bytes read from `{}`", connection.report.name),
        })?;
        let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
        for start in (0..self.bytes).step_by(PIECE_BYTES as usize) {
            let bytes = PIECE_BYTES.min(self.bytes - start);
            let staging = connection.buffer("staging", bytes, usage);
            let mut encoder = connection.encoder();
            encoder.copy_buffer_to_buffer(&self.buffer, start, &staging, 0, bytes);
            connection.queue.submit([encoder.finish()]);
            connection.check(|| "a copy from the device".into())?;
            append(connection, &staging, &mut data)?;
        }
        Ok(data)
    }
}

/// Appends what a staging buffer holds.
fn append(connection: &Connection, staging: &wgpu::Buffer, data: &mut Vec<u8>) -> Result<(), BackendError> {
    let what = || "reading from the device".to_string();
    let (sender, receiver) = mpsc::channel();
    staging.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver waits below.
        let _ = sender.send(result.is_ok());
    });
    connection.wait();
    connection.check(what)?;
    let failed = || BackendError::Rejected { what: what(), message: "the memory cannot be mapped".into() };
    if receiver.try_recv() != Ok(true) {
        return Err(failed());
    }
    data.extend_from_slice(&staging.get_mapped_range(..).map_err(|_| failed())?);
    Ok(())
}

/// What outputs are filled with: all ones.
pub(super) struct Poison(wgpu::Buffer);

impl Poison {
    pub fn new(connection: &Connection) -> Self {
        let usage = wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
        let buffer = connection.buffer("poison", POISON_BYTES, usage);
        connection.queue.write_buffer(&buffer, 0, &[0xff; POISON_BYTES as usize]);
        Self(buffer)
    }

    /// Records that `buffer` is filled.
    pub fn fill(&self, encoder: &mut wgpu::CommandEncoder, buffer: &wgpu::Buffer) {
        for start in (0..buffer.size()).step_by(POISON_BYTES as usize) {
            let bytes = POISON_BYTES.min(buffer.size() - start);
            encoder.copy_buffer_to_buffer(&self.0, 0, buffer, start, bytes);
        }
    }
}
