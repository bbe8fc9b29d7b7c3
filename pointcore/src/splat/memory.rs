//! The reconstruction buffer behind the renderer's memory ports.

use crate::memory::{Bus, ExternalMemory, MemorySettings, RequestSize, WrittenBursts};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{Pixel, PixelRun, StoredPixel, buffer_tile, pixel_bytes};

/// Pixels of a tile.
const PIXELS: usize = TILE_PIXELS as usize;

/// Pixels that passed the ports, and what they cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BufferTraffic {
    /// Pixels read.
    pub pixels_read: u64,
    /// Pixels written.
    pub pixels_written: u64,
    /// Bytes that the memory moved for them, whole bursts.
    pub bytes: u64,
    /// Cycles that this takes at the memory's bandwidth, and at that of the busiest port, whichever are more.
    pub busy_cycles: u64,
}

/// External memory that holds tiles of pixels. Reads of a port come back in order, one pixel a cycle at most; a read sees every write
/// accepted before it.
///
/// Without a bandwidth among its settings, a pixel a cycle goes each way at every port. Else reads and writes of all ports share the bus:
/// a read waits for it after the latency, a write is accepted when it is free.
#[derive(Clone)]
pub struct ReconstructionBuffer {
    config: Config,
    /// By surface and tile; one that was never written is empty.
    tiles: Vec<Option<Box<[Pixel; PIXELS]>>>,
    pixel_bytes: u32,
    memory: ExternalMemory<PixelRun>,
    /// The bus of the writes, where they have one of their own.
    write_bus: Option<Bus>,
    ports: Vec<Port>,
}

/// What passed a port.
#[derive(Clone, Copy)]
struct Port {
    written: WrittenBursts,
    pixels_read: u64,
    pixels_written: u64,
}

impl ReconstructionBuffer {
    /// A DRAM behind a controller that keeps up with the ports.
    pub const SETTINGS: MemorySettings =
        MemorySettings { latency_cycles: 24, bytes_per_cycle: None, burst_bytes: 1, reorder_window: 1 };

    /// An empty buffer for a renderer. Its answers keep their order, whatever the settings say.
    #[must_use]
    pub fn new(config: &Config, settings: MemorySettings) -> Self {
        let settings = MemorySettings { reorder_window: 1, ..settings };
        let pixel_bytes = pixel_bytes(config);
        let ports = config.memory_ports as usize;
        let bytes_at_once = pixel_bytes * config.memory_ports;
        Self {
            config: config.clone(),
            tiles: vec![None; config.buffer_tiles()],
            pixel_bytes,
            // Nothing is left to chance in order.
            memory: ExternalMemory::new(settings, ports, bytes_at_once, 0),
            write_bus: settings.bytes_per_cycle.is_none().then(|| Bus::new(&settings, bytes_at_once)),
            ports: vec![Port { written: WrittenBursts::new(&settings), pixels_read: 0, pixels_written: 0 }; ports],
        }
    }

    /// Accepts a read of a port in cycle `now`.
    pub fn request(&mut self, port: usize, run: PixelRun, now: u64) {
        let size = RequestSize { beats: run.count.into(), beat_bytes: self.pixel_bytes };
        self.memory.request(port, run, size, now);
    }

    /// Gives the bus to what waits for it; once a cycle, before what is on offer is asked for.
    pub fn advance(&mut self, now: u64) {
        self.memory.advance(now);
    }

    /// The pixel that is on offer at a port in cycle `now`.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<Pixel> {
        let (PixelRun { surface, tile, pixel, .. }, beat) = self.memory.offer(port, now)?;
        let pixels = self.tiles[buffer_tile(&self.config, surface, tile)].as_ref();
        Some(pixels.map_or_else(Pixel::default, |pixels| pixels[usize::from(pixel) + beat as usize]))
    }

    /// The pixel offered at a port was taken.
    pub fn take(&mut self, port: usize) {
        self.ports[port].pixels_read += 1;
        self.memory.take(port);
    }

    /// Whether a write can be accepted in cycle `now`.
    #[must_use]
    pub fn is_writable(&self, now: u64) -> bool {
        self.write_bus.as_ref().unwrap_or_else(|| self.memory.bus()).is_free(now)
    }

    /// Accepts a write of a port in cycle `now`.
    pub fn write(&mut self, port: usize, write: &StoredPixel, now: u64) {
        let place = buffer_tile(&self.config, write.surface, write.placed.tile);
        let write = write.placed;
        let tile = self.tiles[place].get_or_insert_with(|| Box::new([Pixel::default(); PIXELS]));
        tile[usize::from(write.pixel)] = write.value;

        let begin = u32::from(write.pixel) * self.pixel_bytes;
        let port = &mut self.ports[port];
        port.pixels_written += 1;
        let bytes = port.written.bytes(place, begin..begin + self.pixel_bytes);
        let bus = self.write_bus.as_mut().unwrap_or_else(|| self.memory.bus_mut());
        bus.transfer(bytes, now);
    }

    /// What passed so far.
    #[must_use]
    pub fn traffic(&self) -> BufferTraffic {
        let busiest = self.ports.iter().map(|port| port.pixels_read.max(port.pixels_written)).max().unwrap_or(0);
        let buses = || [Some(self.memory.bus()), self.write_bus.as_ref()].into_iter().flatten();
        let on_bus = buses().map(|bus| bus.busy_cycles().ceil() as u64).max().unwrap_or(0);
        BufferTraffic {
            pixels_read: self.ports.iter().map(|port| port.pixels_read).sum(),
            pixels_written: self.ports.iter().map(|port| port.pixels_written).sum(),
            bytes: buses().map(Bus::bytes).sum(),
            busy_cycles: on_bus.max(busiest),
        }
    }
}

#[cfg(test)]
mod tests;
