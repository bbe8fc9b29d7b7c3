//! The memory of depths behind the renderer's ports: what triangles or other surfaces left there (thesis 5.4.6), or of what stands still.

use crate::memory::{MemorySettings, ReadWriteMemory, Traffic};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::{Depth, DepthRun, Fragment, StoredDepth, depth_place};
use pointcore_golden::reference;

/// Bytes that a depth takes in memory.
pub const DEPTH_BYTES: u32 = MERGED_DEPTH_BITS / u8::BITS;
/// The depth of nothing.
pub const NO_DEPTH: f32 = f32::INFINITY;

/// Depths as memory has them: tile by tile.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Depths(Vec<u32>);

impl Depths {
    /// Those of samples of hardware's image, none where `of` knows none.
    #[must_use]
    pub fn new(config: &Config, of: impl Fn(u32, u32) -> Option<f32>) -> Self {
        let mut depths = vec![NO_DEPTH.to_bits(); (TILE_PIXELS as usize) << config.image_tile_bits()];
        for (column, row) in (0..config.height).flat_map(|row| (0..config.width).map(move |column| (column, row))) {
            if let Some(depth) = of(column, row) {
                depths[place(config, column, row)] = depth.to_bits();
            }
        }
        Self(depths)
    }

    /// Those of fragments, a row of so many samples after the other.
    #[must_use]
    pub fn of_fragments(config: &Config, width: usize, fragments: &[Option<reference::Fragment>]) -> Self {
        Self::new(config, |column, row| {
            let is_inside = (column as usize) < width;
            let found = fragments.get(row as usize * width + column as usize).filter(|_| is_inside)?;
            found.as_ref().map(|fragment| fragment.depth as f32)
        })
    }

    /// Any bits, by their place in memory.
    #[must_use]
    pub fn of_places(config: &Config, bits: impl Fn(u32) -> u32) -> Self {
        Self((0..TILE_PIXELS << config.image_tile_bits()).map(bits).collect())
    }

    /// What is left of fragments of one surface that come before these depths, and leave theirs. Ends stay.
    #[must_use]
    pub fn merge(&mut self, config: &Config, fragments: &[Fragment]) -> Vec<Fragment> {
        let low_bits = MERGED_DEPTH_BITS - config.geometry.width();
        let is_left = |fragment: &&Fragment| {
            let Fragment { end: false, column, row, depth, .. } = **fragment else { return true };
            let stored = &mut self.0[place(config, column.into(), row.into())];
            let is_nearer = depth < *stored >> low_bits;
            if is_nearer {
                *stored = depth << low_bits;
            }
            is_nearer
        };
        fragments.iter().filter(is_left).copied().collect()
    }

    /// The bits of each, in their order.
    #[must_use]
    pub fn bits(&self) -> &[u32] {
        &self.0
    }
}

/// Where a sample's depth lies.
const fn place(config: &Config, column: u32, row: u32) -> usize {
    let column_bits = config.tile_column_bits() - config.bin_bits();
    let tile = ((row / TILE_SIZE) << column_bits) | (column / TILE_SIZE);
    depth_place(tile, row % TILE_SIZE * TILE_SIZE + column % TILE_SIZE) as usize
}

/// External memory that holds a depth for each sample; a read sees every write accepted before it.
#[derive(Clone)]
pub struct DepthMemory {
    depths: Depths,
    memory: ReadWriteMemory<DepthRun>,
}

impl DepthMemory {
    /// A memory for a renderer, with these depths or with nothing in it; it has no ports where nothing is tested. Its answers keep their
    /// order, whatever the settings say.
    #[must_use]
    pub fn new(config: &Config, settings: MemorySettings, depths: Option<&Depths>) -> Self {
        let ports = config.merge_ports();
        let depths = match depths {
            Some(depths) if ports > 0 => depths.clone(),
            None if ports > 0 => Depths::new(config, |_, _| None),
            _ => Depths::default(),
        };
        Self { depths, memory: ReadWriteMemory::new(settings, ports, DEPTH_BYTES) }
    }

    /// How many ports there are.
    #[must_use]
    pub const fn ports(&self) -> usize {
        self.memory.ports()
    }

    /// Accepts a read of a port in cycle `now`.
    pub fn request(&mut self, port: usize, run: DepthRun, now: u64) {
        self.memory.request(port, run, run.count.into(), now);
    }

    /// Gives the bus to what waits for it; once a cycle, before what is on offer is asked for.
    pub fn advance(&mut self, now: u64) {
        self.memory.advance(now);
    }

    /// The depth that is on offer at a port in cycle `now`.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<Depth> {
        let (DepthRun { tile, pixel, .. }, beat) = self.memory.offer(port, now)?;
        Some(Depth { depth: self.depths.0[depth_place(tile, u32::from(pixel) + beat) as usize] })
    }

    /// The depth offered at a port was taken.
    pub fn take(&mut self, port: usize) {
        self.memory.take(port);
    }

    /// Whether a write can be accepted in cycle `now`.
    #[must_use]
    pub fn is_writable(&self, now: u64) -> bool {
        self.memory.is_writable(now)
    }

    /// Accepts a write of a port in cycle `now`.
    pub fn write(&mut self, port: usize, write: &StoredDepth, now: u64) {
        let StoredDepth { tile, pixel, value } = *write;
        self.depths.0[depth_place(tile, pixel.into()) as usize] = value.depth;
        self.memory.write(port, tile as usize, pixel.into(), now);
    }

    /// The depths that passed so far.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        self.memory.traffic()
    }
}
