//! The reconstruction buffer behind the renderer's memory ports.

use crate::memory::{MemorySettings, ReadWriteMemory, Traffic};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{Pixel, PixelRun, StoredPixel, buffer_tile, pixel_bytes};

/// Pixels of a tile.
const PIXELS: usize = TILE_PIXELS as usize;

/// External memory that holds tiles of pixels; a read sees every write accepted before it.
#[derive(Clone)]
pub struct ReconstructionBuffer {
    config: Config,
    /// By surface and tile; one that was never written is empty.
    tiles: Vec<Option<Box<[Pixel; PIXELS]>>>,
    memory: ReadWriteMemory<PixelRun>,
}

impl ReconstructionBuffer {
    /// A DRAM behind a controller that keeps up with the ports.
    pub const SETTINGS: MemorySettings =
        MemorySettings { latency_cycles: 24, bytes_per_cycle: None, burst_bytes: 1, reorder_window: 1 };

    /// An empty buffer for a renderer. Its answers keep their order, whatever the settings say.
    #[must_use]
    pub fn new(config: &Config, settings: MemorySettings) -> Self {
        Self {
            config: config.clone(),
            tiles: vec![None; config.buffer_tiles()],
            memory: ReadWriteMemory::new(settings, config.memory_ports, pixel_bytes(config)),
        }
    }

    /// Accepts a read of a port in cycle `now`.
    pub fn request(&mut self, port: usize, run: PixelRun, now: u64) {
        self.memory.request(port, run, run.count.into(), now);
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
        self.memory.take(port);
    }

    /// Whether a write can be accepted in cycle `now`.
    #[must_use]
    pub fn is_writable(&self, now: u64) -> bool {
        self.memory.is_writable(now)
    }

    /// Accepts a write of a port in cycle `now`.
    pub fn write(&mut self, port: usize, write: &StoredPixel, now: u64) {
        let place = buffer_tile(&self.config, write.surface, write.placed.tile);
        let write = write.placed;
        let tile = self.tiles[place].get_or_insert_with(|| Box::new([Pixel::default(); PIXELS]));
        tile[usize::from(write.pixel)] = write.value;
        self.memory.write(port, place, write.pixel.into(), now);
    }

    /// The pixels that passed so far.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        self.memory.traffic()
    }
}

#[cfg(test)]
mod tests;
