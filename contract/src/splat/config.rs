//! `Config`: every parameter of the renderer, with the ranges the hardware holds.

mod error;

pub use error::ConfigError;

use super::division::Division;
use super::motion::{MOTION_TABLE_BITS, TIME_BINS_MAX, TIME_BITS};
use super::{AttributeFormat, Coefficient, RasterFormat, UniformFormat};
use crate::configuration::{Derived, configuration};
use crate::{Format, FragmentDepth, Sampling, TableShape};
use serde::{Deserialize, Serialize};

/// Edge of a tile in pixels (thesis 5.5.1).
pub const TILE_SIZE: u32 = 8;
/// Pixels of a tile.
pub const TILE_PIXELS: u32 = TILE_SIZE * TILE_SIZE;
/// Bits of a kernel weight: an unsigned fraction of one.
pub const WEIGHT_BITS: u32 = 16;
/// Bits of an accumulated weight: 4,096 splats of full weight on one pixel.
pub const WEIGHT_SUM_BITS: u32 = WEIGHT_BITS + 12;
/// Bits of a depth: an unsigned fraction of the near–far range.
pub const DEPTH_BITS: u32 = 24;
/// Bits of an accumulated weighted depth.
pub const DEPTH_SUM_BITS: u32 = WEIGHT_SUM_BITS + DEPTH_BITS;
/// Largest number of attributes a splat carries, continuous and cardinal together (thesis 5.6.2).
pub const ATTRIBUTES_MAX: u32 = 14;
/// Entries of the queue between tile cache and rasterizer: how far ahead of the samples tiles are fetched.
pub const PLACED_QUEUE_DEPTH: u32 = 16;
/// Entries of the sample queue before the accumulators, which absorbs their hazard stalls.
pub const SAMPLE_QUEUE_DEPTH: u32 = 64;
/// Memories that the tile slots share: pixels beside each other lie in different ones.
pub const SLOT_BANKS: u32 = 2;
/// The most pixels of a run: it stays within a row of its tile.
pub const RUN_PIXELS_MAX: u32 = TILE_SIZE;
/// Runs of pixels that may be asked for and not have come: enough for memory's latency where runs are short.
pub const RUNS_ASKED_MAX: u32 = 32;
/// Frames that the reconstruction buffer has room for: one is drawn while the one before leaves (thesis 5.3).
pub const SURFACES: u32 = 2;
/// Bits of a surface's number.
pub const SURFACE_BITS: u32 = SURFACES.ilog2();
/// Tiles that were written back for the last time, and wait to leave with their frame.
pub const GONE_TILES: u32 = 16;
/// Pixels of evicted tiles that may be read and not be written yet.
pub const WRITE_QUEUE_DEPTH: u32 = 8;
/// Copies that wait before each of a distributor's sides.
pub const DISTRIBUTED_COPIES: u32 = 16;
/// Reads of which pixels are still to come, where several rasterizers share a memory.
pub const COLLECTED_READS: u32 = 32;
/// The most ports to the reconstruction buffer.
pub const MEMORY_PORTS_MAX: u32 = 4;
/// The most rasterizers.
pub const RASTERIZERS_MAX: u32 = 8;
/// Bits of a depth in memory: an `f32`, as depth buffers of triangles have it.
pub const MERGED_DEPTH_BITS: u32 = 32;
/// Samples that may be under way from where they wait for depths in memory to behind the test.
pub const OCCLUSION_QUEUE_DEPTH: u32 = 8;
/// Copies that wait until memory has taken their payload.
pub const WRITTEN_COPIES: u32 = 8;
/// Bits of the counter of copies under way in one tile slot.
pub const IN_FLIGHT_BITS: u32 = 8;
/// Image edges the coordinates hold, in pixels.
pub const IMAGE_EDGE_MAX: u32 = 4096;
/// Sharpness of kernels that the weight table resolves.
pub const KERNEL_GAMMA_RANGE: std::ops::RangeInclusive<f64> = KERNEL_GAMMA_LEAST..=KERNEL_GAMMA_MOST;
const KERNEL_GAMMA_LEAST: f64 = 0.1;
const KERNEL_GAMMA_MOST: f64 = 8.0;

/// Whether a part of the hardware is generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Feature {
    /// The part is there.
    On,
    /// The part is left out.
    Off,
}

impl Feature {
    /// Whether the part is there.
    #[must_use]
    pub const fn is_on(self) -> bool {
        matches!(self, Self::On)
    }
}

/// What puts splat copies in the order of their tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Reordering {
    /// A pipelined heap: tile after tile.
    Heap,
    /// A list for each tile: some tiles in turn.
    Lists,
}

/// Where payloads are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PayloadStore {
    /// On the chip.
    Chip,
    /// In memory, behind a port of each rasterizer's.
    Memory,
}

configuration! {
    /// The parameters of one renderer. In a file they stand in tables; missing keys take the default, unknown keys are errors.
    pub struct Config, kind "splat" {
        /// What is drawn.
        image: Image {
            /// Samples a row: pixels, or what `sampling` makes of them.
            width: u32 = 256, range(1, IMAGE_EDGE_MAX), Input;
            /// Rows of samples.
            height: u32 = 256, range(1, IMAGE_EDGE_MAX), Input;
            /// Where samples lie (thesis 5.6.2).
            sampling: Sampling = Sampling::Center, described("`\"center\"`, `\"flipquad\"`"), Input;
        }
        /// What is computed: every key that a bit of the frame hangs on.
        features: Features {
            /// Format of all geometry, from the splat's centre to ρ².
            geometry: Format = Format::F32.flushed(),
            described("`\"f32\"`, `\"f24\"`, `\"bf16\"`; with `-ftz` they flush subnormals"), User;
            /// Format of the footprint behind setup and of the rasterizer, down to ρ²; none, `"geometry"` in a file, for that of all geometry.
            #[serde(with = "as_geometry")]
            rasterizer: Option<RasterFormat> = None,
            described("`\"geometry\"`, a format no wider than that, `\"fixed18\"`, `\"fixed16\"`"), User;
            /// Format of attributes and of their accumulators.
            attribute: AttributeFormat = AttributeFormat::F16,
            described("`\"f32\"`, `\"f24\"`, `\"f16\"`, `\"bf16\"`, each with `-ftz` or not; `\"fixed16\"`, `\"fixed12\"`, `\"fixed8\"`"), User;
            /// Attributes that are blended (eq. 5.11).
            continuous: u32 = 6, described("0 to 14; 1 to 14 attributes of both kinds together"), Input;
            /// Attributes that are selected by the larger weight (eq. 5.12).
            cardinal: u32 = 0, described("0 to 14; 1 to 14 attributes of both kinds together"), Input;
            /// Whether all samples of a splat have its depth, or each that of the splat's plane.
            depth: FragmentDepth = FragmentDepth::Center, described("`\"center\"`, `\"plane\"`"), Input;
            /// Discard splats that face away from the eye (thesis table 5.1).
            culling: Feature = Feature::On, described("`\"on\"`, `\"off\"`"), Input;
            /// The screen-space filter of thesis 5.4.2.
            screen_filter: Feature = Feature::On, described("`\"on\"`, `\"off\"`"), Input;
            /// Splats that reach the near, far or eye plane are drawn as far as they lie between near and far, sample by sample.
            eye_plane: Feature = Feature::On, described("`\"on\"`, `\"off\"`"), Input;
            /// Bins of the exposure that splats which move are told apart in (thesis ch. 4), each with tiles of its own. 0 where nothing moves.
            time_bins: u32 = 0, described("0, 1, 2, 4, 8"), Input;
            /// Fragments are tested against depths in memory, of triangles or of surfaces that came before, and only those that are
            /// nearer leave (thesis 5.4.6). With `time_bins` samples are, against depths of what stands still.
            merge: Feature = Feature::Off, described("`\"on\"`, `\"off\"`"), Input;
            /// Kernel sharpness γ: the weight is exp(−γρ²), cut at ρ = 1.
            kernel_gamma: f64 = 2.0, range(KERNEL_GAMMA_LEAST, KERNEL_GAMMA_MOST), Input;
            /// Leading bits of ρ² that choose an entry of the kernel's table; with `time_bins` those of a distance, too, in that of its integral.
            kernel_index_bits: u32 = 8, range(4, 10), Sweep;
            /// Bits of ρ² behind those, which interpolate between entries; 0 for the table alone. With `time_bins` all of 24 do.
            kernel_fraction_bits: u32 = 8, range(0, 10), Sweep;
            /// How setup, rasterizer and normalizer divide and take roots: correctly rounded digit by digit, or from tables and
            /// Newton steps.
            division: Division = Division::Rounded, described("`\"rounded\"`, `\"newton\"`"), Sweep;
        }
        /// What it costs in area and time: no bit of the frame hangs on it.
        implementation: Implementation {
            /// Levels of the pipelined heap: it holds `2^levels − 1` splat copies, lists hold `2^levels` (thesis 5.5.2).
            heap_levels: u32 = 10, range(2, 14), Input;
            /// What puts splat copies in the order of their tiles: lists, one a tile, or a heap.
            reorder: Reordering = Reordering::Lists, described("`\"lists\"`, `\"heap\"`"), User;
            /// Tiles whose lists give a splat copy each in turn, fewer than `tile_slots` in any case: no sample then waits for the one before it.
            tiles_in_turn: u32 = 4, range(1, 16), User;
            /// Cycles an operation of the heap takes: 2, or 4 for a higher clock.
            heap_interval: u32 = 2, described("2, 4"), User;
            /// Splats whose payload is held, `2^splat_levels`: those of the copies that wait.
            splat_levels: u32 = 10, range(0, 14), Input;
            /// Cycles in which a copy gets its splat's payload, footprint and attributes: as many words hold it.
            payload_beats: u32 = 2, range(1, 8), User;
            /// Where payloads are kept: on the chip, or in memory behind a port of each rasterizer's.
            payload: PayloadStore = PayloadStore::Chip, described("`\"chip\"`, `\"memory\"`"), User;
            /// Copies whose payload is asked for before they are drawn, where it is in memory: enough for its latency.
            payload_ahead: u32 = 16, range(1, 64), User;
            /// Fragments whose depth in memory is asked for before they are tested, with `merge`: enough for its latency.
            merge_ahead: u32 = 128, range(8, 1024), User;
            /// Tiles the cache holds.
            tile_slots: u32 = 8, range(2, 64), Input;
            /// Rasterizers that draw side by side, each with lists or heap, tile slots and accumulator of its own (thesis 5.5.3).
            rasterizers: u32 = 1, described("1, 2, 4, 8; no more than the image is wide in tiles, rounded up to a power of two"), User;
            /// Ports to the reconstruction buffer, each of some of the rasterizers, with a normalizer and a stream of fragments of its own: a
            /// pixel a cycle each way and a fragment a cycle for each.
            memory_ports: u32 = 1, described("1, 2, 4; no more than `rasterizers`"), Input;
            /// Cycles a splat takes in the transform unit (initiation interval).
            transform_interval: u32 = 2, range(1, 16), Input;
            /// Cycles a splat takes in the setup unit (initiation interval).
            setup_interval: u32 = 4, range(1, 16), Input;
            /// Cycles a sample of a splat that moves takes in its rasterizer, with `time_bins` (initiation interval).
            sample_interval: u32 = 1, range(1, 8), User;
            /// Cycles from a stored pixel to its new value: one to choose the slot, the others for test and sums, at least the
            /// three of the depth test.
            accumulate_stages: u32 = 7, range(5, 12), Sweep;
        }
    }
}

/// Bits of an arrival number beyond those that count the copies in a full heap: the top one is its epoch, the others give an epoch eight
/// heaps of arrivals.
///
/// A copy may stay until its tile's turn comes, and no third epoch begins before the first one's last copy left. In `scenes/knot.toml` and
/// `scenes/igea.toml` no frame waits for that with three bits or more; with two it takes up to 0.2 % longer, with one up to 3.5 %.
const ARRIVALS_BEYOND_HEAP_BITS: u32 = 4;

impl Config {
    /// What follows from the keys.
    pub const DERIVED: &'static [Derived] = &[Derived {
        name: "sequence_bits",
        rule: "`heap_levels` + 4",
        doc: " Bits of the arrival number that keeps the copies of a tile in order.",
    }];

    /// Checks every range.
    ///
    /// # Errors
    /// The first parameter the hardware cannot hold.
    pub fn validate(&self) -> Result<(), ConfigError> {
        self.check_ranges()?;
        if ![2, 4].contains(&self.heap_interval) {
            return Err(ConfigError::HeapInterval(self.heap_interval));
        }
        if ![1, 2, 4, RASTERIZERS_MAX].contains(&self.rasterizers) {
            return Err(ConfigError::Rasterizers(self.rasterizers));
        }
        let columns = self.width.div_ceil(TILE_SIZE).next_power_of_two();
        if self.rasterizers > 2.max(columns) {
            return Err(ConfigError::NarrowImage {
                width: self.width,
                rasterizers: self.rasterizers,
                most: 2.max(columns),
            });
        }
        if ![1, 2, MEMORY_PORTS_MAX].contains(&self.memory_ports) || self.memory_ports > self.rasterizers {
            return Err(ConfigError::MemoryPorts { ports: self.memory_ports, rasterizers: self.rasterizers });
        }
        self.check_motion()?;
        if !self.width.is_multiple_of(self.sampling.columns()) {
            return Err(ConfigError::CutPixel { width: self.width, columns: self.sampling.columns() });
        }
        let attributes = u64::from(self.continuous) + u64::from(self.cardinal);
        if !(1..=u64::from(ATTRIBUTES_MAX)).contains(&attributes) {
            return Err(ConfigError::Attributes(u32::try_from(attributes).unwrap_or(u32::MAX)));
        }
        if self.geometry.exponent != 8 {
            let expected = "f32, f24, bf16, f32-ftz, f24-ftz, bf16-ftz (the projection needs an 8-bit exponent)";
            return Err(ConfigError::Format { key: "geometry", format: self.geometry, expected });
        }
        match self.raster_format() {
            RasterFormat::Float(format) if !self.holds(format) => {
                let expected = "\"geometry\", f32, f24, bf16, f32-ftz, f24-ftz, bf16-ftz (no wider than `geometry`), or fixed18, fixed16";
                return Err(ConfigError::Format { key: "rasterizer", format, expected });
            }
            format @ RasterFormat::Fixed(_) if self.depth == FragmentDepth::Plane => {
                return Err(ConfigError::PlaneInFixedPoint(format));
            }
            _ => {}
        }
        Ok(self.bus.validate()?)
    }

    /// Checks what hardware for splats that move hangs on.
    fn check_motion(&self) -> Result<(), ConfigError> {
        let needs = |key, value, reason| Err(ConfigError::Motion { bins: self.time_bins, key, value, reason });
        match self.time_bins {
            0 => Ok(()),
            1 | 2 | 4 | 8 => {
                if self.screen_filter.is_on() {
                    return needs("screen_filter", "off", "splats that move have no disc on the screen");
                }
                if !self.culling.is_on() {
                    return needs("culling", "on", "a splat that moves lives while it faces the eye");
                }
                if self.rasterizer.is_some_and(|format| format != RasterFormat::Float(self.geometry)) {
                    return needs("rasterizer", "geometry", "footprints that move are in the format of all geometry");
                }
                Ok(())
            }
            bins => Err(ConfigError::TimeBins { bins, most: TIME_BINS_MAX as u32 }),
        }
    }

    /// Whether a number of a format is one of the geometry format's, but for subnormals.
    const fn holds(&self, format: Format) -> bool {
        format.exponent == self.geometry.exponent && format.mantissa <= self.geometry.mantissa
    }

    /// Format of the footprint behind setup and of the rasterizer.
    #[must_use]
    pub fn raster_format(&self) -> RasterFormat {
        self.rasterizer.unwrap_or(RasterFormat::Float(self.geometry))
    }

    /// Format of the reciprocal of the screen filter's squared radius.
    #[must_use]
    pub fn filter_scale_format(&self) -> UniformFormat {
        match self.raster_format() {
            RasterFormat::Float(format) => UniformFormat::Float(format),
            RasterFormat::Fixed(_) => UniformFormat::Fixed(Coefficient::FILTER_SCALE),
        }
    }

    /// Whether each sample has a depth of its own, by its splat's plane.
    #[must_use]
    pub fn has_depth_plane(&self) -> bool {
        self.depth == FragmentDepth::Plane
    }

    /// Whether splats may move while the shutter is open.
    #[must_use]
    pub const fn has_motion(&self) -> bool {
        self.time_bins > 0
    }

    /// Bits of a bin's number: none where there is but one.
    #[must_use]
    pub const fn bin_bits(&self) -> u32 {
        if self.has_motion() { self.time_bins.ilog2() } else { 0 }
    }

    /// Bits of a time within a bin, from 0 to the bin's length.
    #[must_use]
    pub const fn bin_time_bits(&self) -> u32 {
        TIME_BITS - self.bin_bits()
    }

    /// Attributes of both kinds.
    #[must_use]
    pub const fn attributes(&self) -> u32 {
        self.continuous + self.cardinal
    }

    /// The table of kernel weights over ρ² in `[0, 1)`.
    #[must_use]
    pub const fn kernel_table(&self) -> TableShape {
        TableShape {
            index_bits: self.kernel_index_bits,
            fraction_bits: self.kernel_fraction_bits,
            value_bits: WEIGHT_BITS,
        }
    }

    /// The same over ρ² of what moves, and the table of its integral over ρ, both in `[0, 1)`.
    #[must_use]
    pub const fn motion_table(&self) -> TableShape {
        let index_bits = self.kernel_index_bits;
        TableShape { index_bits, fraction_bits: MOTION_TABLE_BITS - index_bits, value_bits: MOTION_TABLE_BITS }
    }

    /// Bits of a pixel column.
    #[must_use]
    pub const fn column_bits(&self) -> u32 {
        index_bits(self.width.div_ceil(TILE_SIZE)) + TILE_SIZE.ilog2()
    }

    /// Bits of a pixel row.
    #[must_use]
    pub const fn row_bits(&self) -> u32 {
        self.tile_row_bits() + TILE_SIZE.ilog2()
    }

    /// Bits of a sum of a pixel's column and row.
    #[must_use]
    pub const fn diagonal_bits(&self) -> u32 {
        let (columns, rows) = (self.column_bits() - self.sampling.columns().ilog2(), self.row_bits());
        1 + if columns < rows { rows } else { columns }
    }

    /// Bits of a tile column, at least one. Where splats move, the tiles of a place's bins of the exposure lie side by side: the bin is what the
    /// lowest bits say.
    #[must_use]
    pub const fn tile_column_bits(&self) -> u32 {
        self.column_bits() - TILE_SIZE.ilog2() + self.bin_bits()
    }

    /// Tiles in a row of the image.
    #[must_use]
    pub const fn tile_columns(&self) -> u32 {
        self.width.div_ceil(TILE_SIZE) << self.bin_bits()
    }

    /// Bits of a tile row, at least one.
    #[must_use]
    pub const fn tile_row_bits(&self) -> u32 {
        index_bits(self.height.div_ceil(TILE_SIZE))
    }

    /// Bits of a tile index: row above column, so that index order is scan-line order.
    #[must_use]
    pub const fn tile_bits(&self) -> u32 {
        self.tile_row_bits() + self.tile_column_bits()
    }

    /// Bits of a tile's number among those of the image, whose bins of the exposure share one.
    #[must_use]
    pub const fn image_tile_bits(&self) -> u32 {
        self.tile_bits() - self.bin_bits()
    }

    /// Bits of a rasterizer's number: none where there is but one.
    #[must_use]
    pub const fn rasterizer_bits(&self) -> u32 {
        self.rasterizers.ilog2()
    }

    /// Rasterizers that share a port to the reconstruction buffer.
    #[must_use]
    pub const fn rasterizers_a_port(&self) -> u32 {
        self.rasterizers / self.memory_ports
    }

    /// Bits of a tile's place among those of its rasterizer: the lowest bits of its column say, with its row, only whose it is.
    #[must_use]
    pub const fn place_bits(&self) -> u32 {
        self.tile_bits() - self.rasterizer_bits()
    }

    /// Bits of the column in a tile's place among those of its rasterizer.
    #[must_use]
    pub const fn place_column_bits(&self) -> u32 {
        self.tile_column_bits() - self.rasterizer_bits()
    }

    /// Column and row of the last place that has a tile of the image: some rasterizer's, if not each one's.
    #[must_use]
    pub const fn last_place(&self) -> [u32; 2] {
        let [last_column, last_row] = [self.tile_columns() - 1, (self.height - 1) / TILE_SIZE];
        [last_column >> self.rasterizer_bits(), last_row]
    }

    /// Tiles that the reconstruction buffer holds.
    #[must_use]
    pub const fn buffer_tiles(&self) -> usize {
        (SURFACES as usize) << self.tile_bits()
    }

    /// Bits of a tile slot's number.
    #[must_use]
    pub const fn slot_bits(&self) -> u32 {
        index_bits(self.tile_slots)
    }

    /// Bits of the arrival number that keeps the copies of a tile in order.
    #[must_use]
    pub const fn sequence_bits(&self) -> u32 {
        self.heap_levels + ARRIVALS_BEYOND_HEAP_BITS
    }

    /// Tiles whose lists give a copy each in turn: one slot at least is left to load, no list is empty, and turns wait only while
    /// two copies wait to leave.
    #[must_use]
    pub fn turns(&self) -> u32 {
        self.tiles_in_turn.min(self.tile_slots - 1).min(self.pointers() - 2)
    }

    /// Splats whose payload is held at a time.
    #[must_use]
    pub const fn splats_held(&self) -> u32 {
        1 << self.splat_levels
    }

    /// Bits of the place of a splat's payload.
    #[must_use]
    pub const fn splat_bits(&self) -> u32 {
        index_bits(self.splats_held())
    }

    /// Whether payloads are in memory.
    #[must_use]
    pub fn has_payloads_in_memory(&self) -> bool {
        self.payload == PayloadStore::Memory
    }

    /// Ports to the memory of payloads, one for each rasterizer.
    #[must_use]
    pub fn payload_ports(&self) -> u32 {
        if self.has_payloads_in_memory() { self.rasterizers } else { 0 }
    }

    /// Whether fragments are tested against depths in memory.
    #[must_use]
    pub const fn tests_fragments(&self) -> bool {
        self.merge.is_on() && !self.has_motion()
    }

    /// Whether samples are: a fragment of what moves is of no single depth.
    #[must_use]
    pub const fn tests_samples(&self) -> bool {
        self.merge.is_on() && self.has_motion()
    }

    /// Ports to depths in memory: with `merge`, one for each port to the reconstruction buffer, or for each rasterizer where samples are tested.
    #[must_use]
    pub const fn merge_ports(&self) -> u32 {
        match self.merge {
            Feature::Off => 0,
            Feature::On if self.has_motion() => self.rasterizers,
            Feature::On => self.memory_ports,
        }
    }

    /// Ports by which depths go to memory: samples leave none there.
    #[must_use]
    pub const fn depth_writers(&self) -> u32 {
        if self.tests_fragments() { self.memory_ports } else { 0 }
    }

    /// Bits of a number of ports to depths in memory.
    #[must_use]
    pub const fn merge_count_bits(&self) -> u32 {
        index_bits(self.merge_ports() + 1)
    }

    /// Bits of a number of copies of one splat: it has one a tile at most.
    #[must_use]
    pub const fn copy_count_bits(&self) -> u32 {
        self.tile_bits() + 1
    }

    /// Splat copies the reorder stage's memory holds.
    #[must_use]
    pub const fn pointers(&self) -> u32 {
        1 << self.heap_levels
    }

    /// Splat copies that wait in the reorder stage at a time.
    #[must_use]
    pub const fn copies_held(&self) -> u32 {
        match self.reorder {
            Reordering::Heap => self.heap_capacity(),
            Reordering::Lists => self.pointers(),
        }
    }

    /// Splat copies the heap holds.
    #[must_use]
    pub const fn heap_capacity(&self) -> u32 {
        (1 << self.heap_levels) - 1
    }
}

/// A format that is that of all geometry unless it is named.
mod as_geometry {
    use crate::splat::RasterFormat;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    const GEOMETRY: &str = "geometry";

    pub fn serialize<S: Serializer>(format: &Option<RasterFormat>, serializer: S) -> Result<S::Ok, S::Error> {
        match format {
            Some(format) => serializer.collect_str(format),
            None => serializer.serialize_str(GEOMETRY),
        }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<RasterFormat>, D::Error> {
        let name = String::deserialize(deserializer)?;
        if name == GEOMETRY {
            return Ok(None);
        }
        let format = name.parse().map_err(|error| D::Error::custom(format_args!("{error}; or \"{GEOMETRY}\"")))?;
        Ok(Some(format))
    }
}

/// Bits that count to `count − 1`, at least one.
#[must_use]
pub const fn index_bits(count: u32) -> u32 {
    if count <= 2 { 1 } else { (count - 1).ilog2() + 1 }
}

#[cfg(test)]
mod tests;
