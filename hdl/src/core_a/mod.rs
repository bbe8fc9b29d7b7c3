//! Core A, the surface-splat renderer. `docs/core_a.md` states what every unit does in every cycle; each file names the
//! thesis section it implements.

mod datapath;
pub mod normalizer;
pub mod rasterizer;
pub mod setup;
pub mod transform;
pub mod weighting;

use crate::rtl::{Module, StreamIn};
use pointcore_spec::core_a::Field;

/// A record's fields with the widths the front end counts in.
fn layout(record: &[Field]) -> Vec<(&str, usize)> {
    record.iter().map(|(name, width)| (name.as_str(), *width as usize)).collect()
}

/// Declares the ports of a stream of records that comes in.
fn stream_in(m: &mut Module, name: &str, record: &[Field]) -> StreamIn {
    m.stream_in(name, &layout(record))
}
