//! What a driver has to know of a configuration besides registers and records: sizes of what lies in memory, and formats.

use pointcore_contract::bus::Layout;
use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::{packets, units};
use pointcore_contract::process::records::Neighbor;
use pointcore_contract::rendering::Sampling;
use pointcore_contract::splat::config::{TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::Pixel;
use pointcore_contract::splat::{AttributeFormat, UniformFormat};
use pointcore_contract::{Format, points, search, splat};

/// A number with a name.
pub(super) struct Constant {
    /// Its name, without the core's before it.
    pub name: String,
    /// Its value.
    pub number: String,
    /// As C writes it.
    pub value: String,
    /// One line.
    pub doc: String,
}

fn count(name: &str, value: u64, doc: &str) -> Constant {
    let number = value.to_string();
    let value = if value > u64::from(u32::MAX) { format!("UINT64_C({value})") } else { format!("{value}u") };
    Constant { name: name.to_owned(), number, value, doc: doc.to_owned() }
}

fn flag(name: &str, is_set: bool, doc: &str) -> Constant {
    let number = u32::from(is_set).to_string();
    Constant { name: name.to_owned(), value: number.clone(), number, doc: doc.to_owned() }
}

/// What makes numbers of a floating-point format.
fn float(name: &str, format: Format) -> Vec<Constant> {
    let number = |part: &str, value: u64, doc: &str| Constant {
        name: format!("{name}_{part}"),
        number: format!("0x{value:x}"),
        value: format!("UINT32_C(0x{value:x})"),
        doc: doc.to_owned(),
    };
    let bits = |part: &str, value: u32, doc: &str| count(&format!("{name}_{part}"), value.into(), doc);
    vec![
        bits("EXPONENT_BITS", format.exponent, &format!("of {format}, docs/numbers.md")),
        bits("MANTISSA_BITS", format.mantissa, "behind the leading one"),
        number("INFINITY", format.infinity(), "positive"),
        number("NAN", format.quiet_nan(), "the one that operators return"),
    ]
}

/// Of the search core.
pub(super) fn search(config: &search::Config) -> Vec<Constant> {
    let tree_bits = if config.tree_cache == 0 { TREE_WORD_BITS } else { config.bus.memory_bits };
    let records = 2 << config.tree_depth;
    let stride = u64::from(packets::tree_stride(config, tree_bits));
    let mut constants = vec![
        count("NEIGHBORS", config.neighbors.into(), "the largest `k` of a query"),
        count("INDEX_BITS", config.index_bits.into(), "of a point's index and of a query's number"),
        count("LANES", config.lanes.into(), "points in a beat: a record of `points`"),
        count("BUCKET", config.bucket.into(), "points of a leaf at most"),
        count("LEAF_BEATS", units::beats_max(config).into(), "beats of a leaf at most"),
        count("POINT_BEATS", 1 << config.beat_bits(), "beats of points at most: what indices reach"),
        count("TREE_DEPTH", config.tree_depth.into(), "levels of internal nodes"),
        count("TREE_RECORDS", records, "nodes and leaves: `2^(tree_depth + 1)`"),
        count("TREE_STRIDE", stride, "bytes from one record of the tree to the next"),
        count("TREE_BYTES", records * stride, "the whole tree"),
        flag("TREE_IN_MEMORY", config.tree_cache > 0, "the tree lies in memory, at `tree_base`; else behind `s_axi`"),
        count("NEIGHBORHOODS", config.neighbor_cache.into(), "what the neighbor cache holds; 0 where there is none"),
    ];
    constants.extend(float("GEOMETRY", config.geometry));
    constants
}

/// Of the point processor.
pub(super) fn points(config: &points::Config) -> Vec<Constant> {
    let points::Config { search: found, process } = config;
    let stride = Layout::record::<Neighbor>(process).stride(found.bus.memory_bits);
    let mut constants = search(found);
    constants.extend([
        count("LINE_POINTS", process.line_points.into(), "points of a line, which are read together"),
        count("POINT_STRIDE", stride.into(), "bytes from one point to the next at `lines_base`"),
        count("THREADS", process.threads.into(), "queries under way at a time"),
    ]);
    constants
}

/// Of the renderer.
pub(super) fn splat(config: &splat::Config) -> Vec<Constant> {
    let stride = Layout::record::<Pixel>(config).stride(config.bus.memory_bits);
    let buffer = u64::from(TILE_PIXELS * stride) * config.buffer_tiles() as u64;
    let mut constants = vec![
        count("WIDTH", config.width.into(), "columns of samples"),
        count("HEIGHT", config.height.into(), "rows of samples"),
        flag(
            "FLIPQUAD",
            config.sampling == Sampling::Flipquad,
            "two columns of samples a pixel, else one in its middle",
        ),
        count(
            "TIME_BINS",
            config.time_bins.into(),
            "columns that each sample has for parts of the exposure, none where nothing moves",
        ),
        count("TILE_SIZE", TILE_SIZE.into(), "edge of a tile, in samples"),
        count("BUFFER_BYTES", buffer, "the reconstruction buffer"),
        count("CONTINUOUS", config.continuous.into(), "attributes that are blended"),
        count("CARDINAL", config.cardinal.into(), "attributes that are selected"),
        flag("CULLING", config.culling.is_on(), "splats that face away from the eye are not drawn"),
        flag(
            "SCREEN_FILTER",
            config.screen_filter.is_on(),
            "splats cover `filter_radius` around their centre at least",
        ),
        flag("EYE_PLANE", config.eye_plane.is_on(), "splats may reach behind the eye"),
        flag(
            "DEPTH_PLANE",
            config.has_depth_plane(),
            "samples have the depth of the splat's plane, else of its centre",
        ),
        Constant {
            name: "KERNEL_GAMMA".to_owned(),
            number: config.kernel_gamma.to_string(),
            value: format!("{:?}", config.kernel_gamma),
            doc: "weights are exp(-gamma rho^2)".to_owned(),
        },
    ];
    constants.extend(float("GEOMETRY", config.geometry));
    match config.attribute {
        AttributeFormat::Float(format) => constants.extend(float("ATTRIBUTE", format)),
        AttributeFormat::Fixed(_) => {
            let bits = config.attribute.width();
            constants.push(count("ATTRIBUTE_FRACTION_BITS", (bits - 1).into(), "behind the point, below the sign"));
        }
    }
    match config.filter_scale_format() {
        UniformFormat::Float(format) => constants.extend(float("FILTER_SCALE", format)),
        UniformFormat::Fixed(format) => {
            constants.push(count("FILTER_SCALE_BITS", format.width.into(), "without sign"));
            constants.push(count("FILTER_SCALE_FRACTION_BITS", format.fraction.into(), "of them behind the point"));
        }
    }
    constants
}
