//! A frame for `splat_axi`.

use super::{AddressSpace, Packets, Region, Vectors, VectorsError, writes};
use crate::splat::{EncodedFrame, SplatCore, SplatRunner};
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::registers::{RegisterMap, SplatRegisters};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{Fragment, Pixel, Splat, Uniforms};
use pointcore_contract::{fields, words};

/// A frame, with the reconstruction buffer at `base`. Fragments of a tile come in the order of the vectors, tiles in any, and the end last.
///
/// # Errors
/// The buffer has no place, or the golden model does not come to its end.
pub fn frame(config: &Config, frame: &EncodedFrame, base: u64) -> Result<Vectors, VectorsError> {
    let stride = Layout::record::<Pixel>(config).stride(config.bus.memory_bits);
    let bytes = u64::from(TILE_PIXELS * stride) * config.buffer_tiles() as u64;
    let buffer_base = AddressSpace::new(base)?.take("a reconstruction buffer", bytes)?;
    let fragments = SplatRunner::new(config, frame).golden(&SplatCore::generate(config)?)?.fragments;

    let splats = frame.records.iter().map(|splat| words(config, *splat));
    let end = Fragment { end: true, ..Fragment::default() };
    let fragments = fragments.into_iter().chain([end]).map(|fragment| words(config, fragment));
    let uniforms = fields::<Uniforms>(config).into_iter().zip(words(config, frame.uniforms));
    let uniforms: Vec<_> = uniforms.map(|(field, value)| (field.name, value as u32)).collect();
    let uniforms = uniforms.iter().map(|(name, value)| (name.as_str(), *value));
    Ok(Vectors {
        top: "splat_axi",
        stream_bits: config.bus.stream_bits,
        memory_bits: config.bus.memory_bits,
        registers: writes(
            &SplatRegisters::registers(config),
            [("buffer_base", buffer_base)].into_iter().chain(uniforms),
        ),
        send: Packets::new("splat", &fields::<Splat>(config), &config.bus, splats),
        receive: Packets::new("fragment", &fields::<Fragment>(config), &config.bus, fragments),
        memory: vec![Region {
            name: "pixel",
            port: "m_axi",
            base: buffer_base,
            bytes,
            stride,
            file: None,
            contents: None,
        }],
    })
}
