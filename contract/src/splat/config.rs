//! `Config`: every parameter of the renderer, with the ranges the hardware holds.

use super::division::Division;
use super::{AttributeFormat, Coefficient, RasterFormat, UniformFormat};
use crate::{Format, FragmentDepth, Sampling, TableShape, bus};
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
/// Entries of the queue that holds the per-copy values of the copies under rasterization.
pub const COPY_QUEUE_DEPTH: u32 = 64;
/// Entries of the sample queue before the accumulators, which absorbs their hazard stalls.
pub const SAMPLE_QUEUE_DEPTH: u32 = 64;
/// Bits of the counter of copies under way in one tile slot.
pub const IN_FLIGHT_BITS: u32 = 8;
/// Image edges the coordinates hold, in pixels.
pub const IMAGE_EDGE_MAX: u32 = 4096;
/// Sharpness of kernels that the weight table resolves.
pub const KERNEL_GAMMA_RANGE: std::ops::RangeInclusive<f64> = 0.1..=8.0;

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

/// The parameters of one renderer. Missing keys take the default, unknown keys are errors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// Samples a row: pixels, or what `sampling` makes of them.
    pub width: u32,
    /// Rows of samples.
    pub height: u32,
    /// Where samples lie (thesis 5.6.2).
    pub sampling: Sampling,
    /// Whether all samples of a splat have its depth, or each that of the splat's plane.
    pub depth: FragmentDepth,
    /// Format of all geometry, from the splat's centre to ρ².
    pub geometry: Format,
    /// Format of the footprint behind setup and of the rasterizer, down to ρ²; none, `"geometry"` in a file, for that of all geometry.
    #[serde(with = "as_geometry")]
    pub rasterizer: Option<RasterFormat>,
    /// Format of attributes and of their accumulators.
    pub attribute: AttributeFormat,
    /// Attributes that are blended (eq. 5.11).
    pub continuous: u32,
    /// Attributes that are selected by the larger weight (eq. 5.12).
    pub cardinal: u32,
    /// Levels of the pipelined heap: it holds `2^levels − 1` splat copies (thesis 5.5.2).
    pub heap_levels: u32,
    /// Cycles an operation of the heap takes: 2, or 4 for a higher clock.
    pub heap_interval: u32,
    /// Bits of the arrival number that keeps the copies of a tile in order.
    pub sequence_bits: u32,
    /// Tiles the cache holds.
    pub tile_slots: u32,
    /// Discard splats that face away from the eye (thesis table 5.1).
    pub culling: Feature,
    /// The screen-space filter of thesis 5.4.2.
    pub screen_filter: Feature,
    /// Splats that reach the eye plane get the viewport for bounds, and samples behind the eye are none of theirs.
    pub eye_plane: Feature,
    /// Kernel sharpness γ: the weight is exp(−γρ²), cut at ρ = 1.
    pub kernel_gamma: f64,
    /// Leading bits of ρ² that choose an entry of the kernel's table.
    pub kernel_index_bits: u32,
    /// Bits of ρ² behind those, which interpolate between entries; 0 for the table alone.
    pub kernel_fraction_bits: u32,
    /// How setup, rasterizer and normalizer divide and take roots.
    pub division: Division,
    /// Cycles a splat takes in the transform unit (initiation interval).
    pub transform_interval: u32,
    /// Cycles a splat takes in the setup unit (initiation interval).
    pub setup_interval: u32,
    /// Cycles from a stored pixel to its new value: one to choose the slot, the others for test and sums, at least the
    /// three of the depth test.
    pub accumulate_stages: u32,
    /// Widths of the bus around the core.
    pub bus: bus::Config,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            width: 256,
            height: 256,
            sampling: Sampling::Center,
            depth: FragmentDepth::Center,
            geometry: Format::F32.flushed(),
            rasterizer: None,
            attribute: AttributeFormat::F16,
            continuous: 6,
            cardinal: 0,
            heap_levels: 10,
            heap_interval: 2,
            sequence_bits: 16,
            tile_slots: 4,
            culling: Feature::On,
            screen_filter: Feature::On,
            eye_plane: Feature::On,
            kernel_gamma: 2.0,
            kernel_index_bits: 8,
            kernel_fraction_bits: 8,
            division: Division::Rounded,
            transform_interval: 2,
            setup_interval: 4,
            accumulate_stages: 7,
            bus: bus::Config::default(),
        }
    }
}

/// A configuration the hardware cannot hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// A number lies outside its range.
    #[error("`{key}` = {value}: expected {low} to {high}")]
    Range {
        /// The TOML key.
        key: &'static str,
        /// Its value.
        value: f64,
        /// Smallest value allowed.
        low: f64,
        /// Largest value allowed.
        high: f64,
    },
    /// A pace the heap does not have.
    #[error("`heap_interval` = {0}: expected 2 cycles an operation, or 4 for a higher clock")]
    HeapInterval(u32),
    /// A row of samples that ends within a pixel.
    #[error(
        "`width` = {0} with `sampling` = \"flipquad\": expected an even number, two samples for each pixel of a row and one more"
    )]
    OddWidth(u32),
    /// More or fewer attributes than the accumulators hold.
    #[error("`continuous` + `cardinal` = {0}: expected 1 to {ATTRIBUTES_MAX} attributes")]
    Attributes(u32),
    /// A format the operators cannot compute in.
    #[error("`{key}` = \"{format}\": expected one of {expected}")]
    Format {
        /// The TOML key.
        key: &'static str,
        /// Its value.
        format: Format,
        /// What would be right.
        expected: &'static str,
    },
    /// Depths of samples where there is no number to hold them.
    #[error(
        "`rasterizer` = \"{0}\" with `depth` = \"plane\": expected `depth` = \"center\", or a floating-point `rasterizer`, in which \
         samples have depths of their own"
    )]
    PlaneInFixedPoint(RasterFormat),
    /// A width that no bus has.
    #[error(transparent)]
    Bus(#[from] bus::ConfigError),
}

impl Config {
    /// Checks every range.
    ///
    /// # Errors
    /// The first parameter the hardware cannot hold.
    pub fn validate(&self) -> Result<(), ConfigError> {
        let ranges = [
            ("width", self.width, 1, IMAGE_EDGE_MAX),
            ("height", self.height, 1, IMAGE_EDGE_MAX),
            ("heap_levels", self.heap_levels, 2, 14),
            ("sequence_bits", self.sequence_bits, 2, 24),
            ("tile_slots", self.tile_slots, 2, 64),
            ("kernel_index_bits", self.kernel_index_bits, 4, 10),
            ("kernel_fraction_bits", self.kernel_fraction_bits, 0, 10),
            ("transform_interval", self.transform_interval, 1, 16),
            ("setup_interval", self.setup_interval, 1, 16),
            ("accumulate_stages", self.accumulate_stages, 5, 12),
        ];
        for (key, value, low, high) in ranges {
            if !(low..=high).contains(&value) {
                let [value, low, high] = [value, low, high].map(f64::from);
                return Err(ConfigError::Range { key, value, low, high });
            }
        }
        if ![2, 4].contains(&self.heap_interval) {
            return Err(ConfigError::HeapInterval(self.heap_interval));
        }
        if !self.width.is_multiple_of(self.sampling.columns()) {
            return Err(ConfigError::OddWidth(self.width));
        }
        if !KERNEL_GAMMA_RANGE.contains(&self.kernel_gamma) {
            let (low, high) = KERNEL_GAMMA_RANGE.into_inner();
            return Err(ConfigError::Range { key: "kernel_gamma", value: self.kernel_gamma, low, high });
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
                let expected = "\"geometry\", f32, f24, bf16, f32-ftz, f24-ftz, bf16-ftz (no wider than `geometry`), or fixed24, fixed18, fixed16";
                return Err(ConfigError::Format { key: "rasterizer", format, expected });
            }
            format @ RasterFormat::Fixed(_) if self.depth == FragmentDepth::Plane => {
                return Err(ConfigError::PlaneInFixedPoint(format));
            }
            _ => {}
        }
        Ok(self.bus.validate()?)
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

    /// Format of a uniform register.
    #[must_use]
    pub fn uniform_format(&self, name: &str) -> UniformFormat {
        match self.raster_format() {
            RasterFormat::Float(format) if name == "filter_scale" => UniformFormat::Float(format),
            RasterFormat::Fixed(_) if name == "filter_scale" => UniformFormat::Fixed(Coefficient::FILTER_SCALE),
            _ => UniformFormat::Float(self.geometry),
        }
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

    /// Bits of a pixel column.
    #[must_use]
    pub const fn column_bits(&self) -> u32 {
        self.tile_column_bits() + TILE_SIZE.ilog2()
    }

    /// Bits of a pixel row.
    #[must_use]
    pub const fn row_bits(&self) -> u32 {
        self.tile_row_bits() + TILE_SIZE.ilog2()
    }

    /// Bits of a tile column, at least one.
    #[must_use]
    pub const fn tile_column_bits(&self) -> u32 {
        index_bits(self.width.div_ceil(TILE_SIZE))
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

    /// Bits of a tile slot's number.
    #[must_use]
    pub const fn slot_bits(&self) -> u32 {
        index_bits(self.tile_slots)
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
mod tests {
    use super::*;

    #[test]
    fn default_is_valid() {
        assert_eq!(Config::default().validate(), Ok(()));
    }

    #[test]
    fn errors_name_key_and_range() {
        let error = Config { width: 0, ..Config::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "`width` = 0: expected 1 to 4096");
        let error = Config { kernel_index_bits: 3, ..Config::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "`kernel_index_bits` = 3: expected 4 to 10");
        let error = Config { kernel_fraction_bits: 11, ..Config::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "`kernel_fraction_bits` = 11: expected 0 to 10");
        let error = Config { continuous: 15, ..Config::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "`continuous` + `cardinal` = 15: expected 1 to 14 attributes");
        let geometry = Format::F24;
        let error =
            Config { geometry, rasterizer: Some(Format::F32.into()), ..Config::default() }.validate().unwrap_err();
        assert!(error.to_string().starts_with("`rasterizer` = \"f32\": expected one of \"geometry\""), "{error}");
        for (text, named) in [
            ("widht = 3", ["widht", "width"]),
            ("division = \"exact\"", ["exact", "`newton`"]),
            ("rasterizer = \"f8\"", ["f24", "or \"geometry\""]),
            ("rasterizer = \"fixed20\"", ["`fixed20`", "fixed18"]),
        ] {
            let error = toml::from_str::<Config>(text).unwrap_err().to_string();
            assert!(named.iter().all(|name| error.contains(name)), "{error}");
        }
        let error = toml::from_str::<Config>("attribute = \"fixed9\"").unwrap_err().to_string();
        assert!(error.contains("`fixed9`") && error.contains("fixed12"), "{error}");
    }

    #[test]
    fn flipquad_has_two_samples_a_pixel() {
        let config = |width| Config { width, sampling: Sampling::Flipquad, ..Config::default() };
        assert_eq!(config(66).validate(), Ok(()));
        assert!(config(65).validate().unwrap_err().to_string().contains("expected an even number"));
    }

    #[test]
    fn the_rasterizer_computes_in_its_own_format_or_that_of_geometry() {
        let formats = [None, Some(Format::F24.flushed().into()), Some(RasterFormat::Fixed(Coefficient::Eighteen))];
        let scales = [Format::F32, Format::F24.flushed()].map(UniformFormat::Float);
        let scales = scales.into_iter().chain([UniformFormat::Fixed(Coefficient::FILTER_SCALE)]);
        for ((rasterizer, name), scale) in formats.into_iter().zip(["geometry", "f24-ftz", "fixed18"]).zip(scales) {
            let config = Config { rasterizer, geometry: Format::F32, ..Config::default() };
            assert_eq!(config.validate(), Ok(()));
            let text = toml::to_string(&config).unwrap();
            assert!(text.contains(&format!("rasterizer = \"{name}\"")), "{text}");
            assert_eq!(toml::from_str(&text), Ok(config.clone()));
            assert_eq!(config.uniform_format("filter_scale"), scale);
            assert_eq!(config.uniform_format("filter_radius"), UniformFormat::Float(Format::F32));
        }
    }

    #[test]
    fn a_rasterizer_in_fixed_point_has_no_depths_of_samples() {
        for (_, coefficient) in Coefficient::NAMED {
            let rasterizer = Some(RasterFormat::Fixed(coefficient));
            let config = Config { rasterizer, geometry: Format::F24, ..Config::default() };
            assert_eq!(config.validate(), Ok(()));
            let error = Config { depth: FragmentDepth::Plane, ..config }.validate().unwrap_err().to_string();
            assert!(error.contains("`depth` = \"center\"") && error.contains("fixed"), "{error}");
        }
    }

    #[test]
    fn index_widths() {
        let widths = [1, 2, 3, 4, 5, 8, 9].map(index_bits);
        assert_eq!(widths, [1, 1, 2, 2, 3, 3, 4]);
        assert_eq!(Config { width: 512, height: 512, ..Config::default() }.tile_bits(), 12);
    }
}
