//! A frame for `splat_axi`.

use super::{AddressSpace, Packets, Region, Vectors, VectorsError, writes};
use crate::splat::depth_memory::{DEPTH_BYTES, Depths};
use crate::splat::{EncodedFrame, SplatCore, SplatRunner};
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::axi::ReadMaster;
use pointcore_contract::bus::registers::{RegisterMap, SplatRegisters};
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{Fragment, PayloadWord, Pixel, Splat, Uniforms, payload_bytes};
use pointcore_contract::{fields, words};

/// A frame, with the reconstruction buffer at `base`. Fragments of a tile come in the order of the vectors, tiles in any, and the end last.
///
/// # Errors
/// The frame has several surfaces, the buffer has no place, or the golden model does not come to its end.
pub fn frame(config: &Config, frame: &EncodedFrame, base: u64) -> Result<Vectors, VectorsError> {
    let surfaces = frame.records.iter().filter(|record| record.end).count();
    if surfaces > 1 {
        return Err(VectorsError::Surfaces(surfaces));
    }
    let stride = Layout::record::<Pixel>(config).stride(config.bus.memory_bits);
    let bytes = u64::from(TILE_PIXELS * stride) * config.buffer_tiles() as u64;
    let mut space = AddressSpace::new(base)?;
    let buffer_base = space.take("a reconstruction buffer", bytes)?;
    let payloads = if config.has_payloads_in_memory() { Some(payloads(config, &mut space)?) } else { None };
    let payload_base = payloads.as_ref().map(|regions| ("payload_base", regions[0].base));
    let depths = if config.merge.is_on() { Some(depths(config, frame, &mut space)?) } else { None };
    let depth_base = depths.as_ref().map(|regions| ("depth_base", regions[0].base));
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
            [("buffer_base", buffer_base)].into_iter().chain(payload_base).chain(depth_base).chain(uniforms),
        ),
        send: Packets::new("splat", &fields::<Splat>(config), &config.bus, splats),
        receive: Packets::new("fragment", &fields::<Fragment>(config), &config.bus, fragments),
        memory: std::iter::once(empty("pixel", "m_axi", buffer_base, bytes, stride))
            .chain([payloads, depths].into_iter().flatten().flatten())
            .collect(),
    })
}

/// A region in which nothing lies.
const fn empty(name: &'static str, port: &'static str, base: u32, bytes: u64, stride: u32) -> Region {
    Region { name, port, base, bytes, stride, file: None, contents: None }
}

/// The regions of payloads, one behind the other, each behind a port of its own.
fn payloads(config: &Config, space: &mut AddressSpace) -> Result<Vec<Region>, VectorsError> {
    let beat_bits = config.bus.memory_bits;
    let bytes = u64::from(payload_bytes(config, beat_bits));
    let stride = Layout::record::<PayloadWord>(config).stride(beat_bits);
    let base = space.take("payloads", bytes * u64::from(config.payload_ports()))?;
    let ports = Ports::ALL.payload_reads.iter().take(config.payload_ports() as usize);
    let region = |(number, port): (u32, &ReadMaster)| {
        empty("payload", port.address.bus, base + number * bytes as u32, bytes, stride)
    };
    Ok((0..).zip(ports).map(region).collect())
}

/// The depths that fragments are tested against, behind each of their ports.
fn depths(config: &Config, frame: &EncodedFrame, space: &mut AddressSpace) -> Result<Vec<Region>, VectorsError> {
    let depths = frame.depths.clone().unwrap_or_else(|| Depths::new(config, |_, _| None));
    let contents: Vec<u8> = depths.bits().iter().flat_map(|bits| bits.to_le_bytes()).collect();
    let bytes = contents.len() as u64;
    let base = space.take("depths", bytes)?;
    let region = |port: &ReadMaster| {
        let (file, contents) = (Some("depth.bin".to_owned()), Some(contents.clone()));
        Region { name: "depth", port: port.address.bus, base, bytes, stride: DEPTH_BYTES, file, contents }
    };
    Ok(Ports::ALL.depth_reads.iter().take(config.merge_ports() as usize).map(region).collect())
}
