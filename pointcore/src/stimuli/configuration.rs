//! Random configurations of both cores: all that validation allows can come, small ones most often, as the compiler
//! takes long for large ones.

use super::one_of;
use fastrand::Rng;
use pointcore_contract::splat::config::{MEMORY_PORTS_MAX, PayloadStore, Reordering, TILE_SIZE};
use pointcore_contract::splat::{AttributeFormat, Coefficient, Division, Feature, Fraction, RasterFormat};
use pointcore_contract::{Format, FragmentDepth, Sampling};
use pointcore_contract::{search, splat};
use std::ops::RangeInclusive;

/// One configuration in so many takes a parameter from its whole range.
const RARELY: u32 = 24;
/// Samples of the largest image: a splat may cover all of them.
const SAMPLES_MAX: u32 = 1 << 14;
/// Splats in a frame are so many that more levels would not fill the heap.
const HEAP_LEVELS: RangeInclusive<u32> = 2..=8;
/// The same of places for payloads.
const SPLAT_LEVELS: RangeInclusive<u32> = 0..=6;
/// Registers of all priority queues together, beyond which a core takes minutes to compile.
const RANKS_MAX: u32 = 512;

/// A number of the usual range, now and then of the whole one.
fn mostly(random: &mut Rng, usual: RangeInclusive<u32>, whole: RangeInclusive<u32>) -> u32 {
    if random.u32(..RARELY) == 0 { random.u32(whole) } else { random.u32(usual) }
}

fn feature(random: &mut Rng) -> Feature {
    if random.bool() { Feature::On } else { Feature::Off }
}

fn float(random: &mut Rng, formats: &[Format]) -> Format {
    let format = one_of(random, formats);
    if random.bool() { format.flushed() } else { format }
}

/// Formats of the rasterizer that a geometry format admits.
fn raster_format(random: &mut Rng, geometry: Format, depth: FragmentDepth) -> Option<RasterFormat> {
    match random.u8(..4) {
        0 | 1 => None,
        2 if depth == FragmentDepth::Center => {
            let width = one_of(random, &[Coefficient::Sixteen, Coefficient::Eighteen]);
            Some(RasterFormat::Fixed(width))
        }
        _ => {
            let narrow = [Format::F32, Format::F24, Format::BF16].into_iter();
            let narrow: Vec<_> = narrow.filter(|format| format.mantissa <= geometry.mantissa).collect();
            Some(RasterFormat::Float(float(random, &narrow)))
        }
    }
}

/// Attributes blended and selected: at least one, at most fourteen together.
fn attributes(random: &mut Rng) -> (u32, u32) {
    let both = mostly(random, 1..=4, 1..=splat::config::ATTRIBUTES_MAX);
    let cardinal = if random.bool() { 0 } else { random.u32(0..=both) };
    (both - cardinal, cardinal)
}

/// Columns and rows of an image, a multiple of so many columns, as many as a splat can cover in time with so many bins of the exposure.
fn image(random: &mut Rng, columns: u32, bins: u32) -> (u32, u32) {
    let edge = |random: &mut Rng| mostly(random, 1..=72, 1..=splat::config::IMAGE_EDGE_MAX);
    let (width, height) = (edge(random), edge(random));
    let width = width.next_multiple_of(columns);
    (width, height.min((SAMPLES_MAX / width / bins).max(1)))
}

/// Bins of the exposure, in one renderer of six.
fn time_bins(random: &mut Rng) -> u32 {
    if random.u8(..6) > 0 { 0 } else { one_of(random, &[1, 2, 4, 8]) }
}

/// A renderer.
#[must_use]
pub fn renderer(random: &mut Rng) -> splat::Config {
    let sampling = one_of(random, &[Sampling::Center, Sampling::Center, Sampling::Flipquad]);
    let time_bins = time_bins(random);
    let moves = time_bins > 0;
    let (width, height) = image(random, sampling.columns(), time_bins.max(1));
    let geometry = float(random, &[Format::F32, Format::F24, Format::F24, Format::BF16, Format::BF16]);
    let depth = one_of(random, &[FragmentDepth::Center, FragmentDepth::Plane]);
    let rasterizer = raster_format(random, geometry, depth).filter(|_| !moves);
    let attribute = if random.bool() {
        float(random, &[Format::F32, Format::F24, Format::F16, Format::BF16]).into()
    } else {
        AttributeFormat::Fixed(one_of(random, &Fraction::NAMED).1)
    };
    let (continuous, cardinal) = attributes(random);
    let rasterizers = rasterizers(random, width);
    let (low, high) = (*splat::config::KERNEL_GAMMA_RANGE.start(), *splat::config::KERNEL_GAMMA_RANGE.end());
    splat::Config {
        width,
        height,
        sampling,
        geometry,
        rasterizer,
        attribute,
        continuous,
        cardinal,
        depth,
        time_bins,
        culling: if moves { Feature::On } else { feature(random) },
        screen_filter: if moves { Feature::Off } else { feature(random) },
        eye_plane: feature(random),
        merge: if random.u8(..3) > 0 { Feature::Off } else { Feature::On },
        merge_ahead: mostly(random, 8..=40, 8..=1024),
        kernel_gamma: low + (high - low) * random.f64().powi(2),
        kernel_index_bits: random.u32(4..=10),
        kernel_fraction_bits: random.u32(0..=10),
        division: one_of(random, &[Division::Rounded, Division::Newton]),
        heap_levels: mostly(random, HEAP_LEVELS, 2..=14),
        reorder: one_of(random, &[Reordering::Heap, Reordering::Lists]),
        tiles_in_turn: random.u32(1..=8),
        heap_interval: one_of(random, &[2, 4]),
        splat_levels: mostly(random, SPLAT_LEVELS, 0..=14),
        payload_beats: random.u32(1..=8),
        payload: one_of(random, &[PayloadStore::Chip, PayloadStore::Chip, PayloadStore::Memory]),
        payload_ahead: random.u32(1..=64),
        tile_slots: mostly(random, 2..=6, 2..=64),
        rasterizers,
        memory_ports: one_of(random, &[1, 1, 2, MEMORY_PORTS_MAX]).min(rasterizers),
        transform_interval: random.u32(1..=16),
        setup_interval: random.u32(1..=16),
        sample_interval: random.u32(1..=8),
        accumulate_stages: random.u32(5..=12),
        ..splat::Config::default()
    }
}

/// One, or as many as there are columns of tiles at most.
fn rasterizers(random: &mut Rng, width: u32) -> u32 {
    one_of(random, &[1, 1, 2, 4, 8]).min(width.div_ceil(TILE_SIZE).next_power_of_two())
}

/// A power of two among `exponents`, or in every third configuration none.
fn cache(random: &mut Rng, usual: RangeInclusive<u32>, whole: RangeInclusive<u32>) -> u32 {
    if random.u8(..3) == 0 { 0 } else { 1 << mostly(random, usual, whole) }
}

/// A search core.
#[must_use]
pub fn search_core(random: &mut Rng) -> search::Config {
    let threads = mostly(random, 1..=8, 1..=32);
    let neighbor_cache = if random.bool() { 0 } else { mostly(random, 1..=6, 1..=32) };
    let config = search::Config {
        geometry: float(random, &[Format::F32, Format::F24]),
        neighbors: mostly(random, 1..=10, 1..=(RANKS_MAX / threads).min(64)),
        tree_depth: mostly(random, 1..=7, 1..=20),
        bucket: mostly(random, 1..=20, 1..=255),
        neighbor_cache,
        threads,
        lanes: one_of(random, &[1, 1, 2, 2, 4, 8]),
        leaves_in_flight: random.u32(1..=4),
        point_cache: cache(random, 1..=4, 1..=8),
        tree_cache: if random.bool() { 0 } else { cache(random, 4..=6, 4..=16) },
        ..search::Config::default()
    };
    // A search bears its ticket as its number.
    let least_bits = if neighbor_cache > 0 { splat::config::index_bits(config.tickets()).max(4) } else { 4 };
    search::Config { index_bits: mostly(random, least_bits..=14, least_bits..=32), ..config }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// Draws so many.
    const DRAWS: u64 = 6000;

    /// What each key came to, over many configurations that all are valid.
    fn values(configurations: impl Iterator<Item = toml::Table>) -> BTreeMap<String, BTreeSet<String>> {
        let mut seen = BTreeMap::<String, BTreeSet<String>>::new();
        for (key, value) in configurations.flat_map(|table| table.into_iter()) {
            let keys = value.as_table().cloned().unwrap_or_else(|| toml::Table::from_iter([(key, value)]));
            for (key, value) in keys {
                seen.entry(key).or_default().insert(value.to_string());
            }
        }
        seen
    }

    fn table(config: &impl serde::Serialize) -> toml::Table {
        toml::Table::try_from(config).unwrap_or_else(|error| panic!("{error}"))
    }

    fn check(seen: &BTreeMap<String, BTreeSet<String>>, ends: &[(&str, &[&str])], fixed: &[&str]) {
        for (key, expected) in ends {
            let of_key = &seen[*key];
            assert!(expected.iter().all(|value| of_key.contains(*value)), "{key} is {of_key:?} only");
        }
        let constant = seen.iter().filter(|(_, values)| values.len() == 1).map(|(key, _)| key.as_str());
        assert_eq!(constant.collect::<Vec<_>>(), fixed, "every parameter is drawn");
    }

    #[test]
    fn renderers_are_valid_and_hit_every_parameter() {
        let draw = |seed| {
            let config = renderer(&mut Rng::with_seed(seed));
            assert_eq!(config.validate(), Ok(()), "{config:?}");
            assert!(config.width * config.height <= SAMPLES_MAX);
            table(&config)
        };
        let seen = values((0..DRAWS).map(draw));
        let ends: &[(&str, &[&str])] = &[
            ("geometry", &["\"f32\"", "\"f24-ftz\"", "\"bf16\"", "\"bf16-ftz\""]),
            ("rasterizer", &["\"geometry\"", "\"fixed18\"", "\"fixed16\"", "\"bf16\"", "\"f24-ftz\""]),
            ("attribute", &["\"f32\"", "\"f16-ftz\"", "\"fixed8\"", "\"fixed12\"", "\"fixed16\""]),
            ("continuous", &["0", "1", "14"]),
            ("cardinal", &["0", "1", "4"]),
            ("time_bins", &["0", "1", "2", "4", "8"]),
            ("merge", &["\"on\"", "\"off\""]),
            ("merge_ahead", &["8", "40"]),
            ("width", &["1", "8", "72"]),
            ("height", &["1", "8", "72"]),
            ("heap_levels", &["2", "8", "14"]),
            ("splat_levels", &["0", "6", "14"]),
            ("payload_beats", &["1", "8"]),
            ("tile_slots", &["2", "6", "64"]),
            ("rasterizers", &["1", "8"]),
            ("memory_ports", &["1", "4"]),
            ("transform_interval", &["1", "16"]),
            ("setup_interval", &["1", "16"]),
            ("accumulate_stages", &["5", "12"]),
            ("kernel_index_bits", &["4", "10"]),
            ("kernel_fraction_bits", &["0", "10"]),
        ];
        // The kind is that of the core, and buses are around it.
        check(&seen, ends, &["kind", "memory_bits", "stream_bits"]);
    }

    #[test]
    fn search_cores_are_valid_and_hit_every_parameter() {
        let draw = |seed| {
            let config = search_core(&mut Rng::with_seed(seed));
            assert_eq!(config.validate(), Ok(()), "{config:?}");
            table(&config)
        };
        let seen = values((0..DRAWS).map(draw));
        let ends: &[(&str, &[&str])] = &[
            ("geometry", &["\"f32\"", "\"f32-ftz\"", "\"f24\"", "\"f24-ftz\""]),
            ("neighbors", &["1", "10", "64"]),
            ("tree_depth", &["1", "7", "20"]),
            ("bucket", &["1", "20"]),
            ("index_bits", &["4", "14", "32"]),
            ("neighbor_cache", &["0", "1", "6", "32"]),
            ("threads", &["1", "8", "32"]),
            ("lanes", &["1", "2", "4", "8"]),
            ("leaves_in_flight", &["1", "4"]),
            ("point_cache", &["0", "2", "16", "256"]),
            ("tree_cache", &["0", "16", "64", "65536"]),
        ];
        check(&seen, ends, &["kind", "memory_bits", "stream_bits"]);
    }
}
