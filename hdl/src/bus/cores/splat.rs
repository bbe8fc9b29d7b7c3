//! The renderer on AXI (`docs/interfaces.md`): splats and fragments as packets, the reconstruction buffer in memory, registers.

use std::rc::Rc;

use pointcore_contract::bus::{Bus, ports, registers as maps};
use pointcore_contract::fields;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{Fragment, Pixel, Splat, UniformWrite};
use pointcore_contract::splat::units::events;
use pointcore_contract::splat::units::top::PORTS;

use super::buffer::Buffer;
use super::wiring::{export, join, report};
use crate::bus::{Top, packet_in, packet_out, reader, registers, writer};
use crate::compiler::{CompileError, Options};
use crate::splat::top;
use crate::units::ports::{Pulse, PulseInPorts, StreamOutPorts};
use crate::units::wires::Bundle;
use rtl::{Module, bit, cat};

/// Errors from elsewhere: none of being busy, misplaced `rlast`, packets, answers to reads and writes.
const ERROR_SOURCES: ports::ErrorSources = [0, 1, 1, 2];

/// Builds the core on its bus; ports as in `contract::bus::ports::splat`.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Top, CompileError> {
    let top::Core { module: core_module, manifests } = top::core(config, options)?;
    let core_module = Rc::new(core_module);
    let bus = config.bus;
    let map = maps::splat(config);
    let (splat, pixel, fragment) = (fields::<Splat>(config), fields::<Pixel>(config), fields::<Fragment>(config));
    let mut m = Module::new("splat_axi", "Surface-splat renderer on AXI.");
    // First, so that its modules have the names that they have without a bus.
    let core = m.instance("core", core_module.clone());
    let control = m.instance("registers", registers::module(&map, ERROR_SOURCES));
    let splats = m.instance("splats", packet_in::module(&splat, bus.stream_bits, None));
    let fragments = m.instance("fragments", packet_out::module(&fragment, bus.stream_bits));
    let reads = m.instance("reads", reader::module(&pixel, bus.memory_bits, TILE_PIXELS));
    let writes = m.instance("writes", writer::module(&pixel, bus.memory_bits));
    export(&mut m, control, Bus::Registers, "s_axil", "s_axil");
    export(&mut m, splats, Bus::StreamIn(bus.stream_bits), "s_axis", "s_axis_splat");
    export(&mut m, fragments, Bus::StreamOut(bus.stream_bits), "m_axis", "m_axis_fragment");
    export(&mut m, reads, Bus::ReadMaster(bus.memory_bits), "m_axi", "m_axi");
    export(&mut m, writes, Bus::WriteMaster(bus.memory_bits), "m_axi", "m_axi");

    let [start, core_reset] = ["start", "core_reset"].map(|name| m.out(control, name));
    m.reset_by(core, core_reset);
    m.connect(splats, "opens", start);
    m.pipe((splats, "out"), (core, "splat"));
    let valid = m.out(control, "uniform_valid");
    let record = UniformWrite::shown_by(&mut m, config, control, "uniform_");
    PORTS.uniform.feed(&mut m, config, core, Pulse { valid, record });

    let base = m.out(control, "buffer_base");
    let (tile_pixels, memory_bits) = (TILE_PIXELS, bus.memory_bits);
    let buffer = Buffer { pixel: &pixel, tile_pixels, memory_bits, base, reads, writes };
    let (read, write) = (PORTS.read.of(&mut m, config, core), PORTS.write.of(&mut m, config, core));
    buffer.order(&mut m, &read.plain(config), &write.plain(config));
    m.pipe((reads, "record"), (core, "data"));

    // The run ends when its last packet has left and memory has answered.
    let fragment = PORTS.fragment.of(&mut m, config, core);
    fragment.into(&mut m, config, fragments, "in");
    let is_last = m.wire("is_last", fragment.transfer() & fragment.record.end);
    let has_ended = m.reg_reset("has_ended", 1, 0);
    m.next(has_ended, is_last | (has_ended & !start));
    let [sender_idle, writer_idle] = [&fragments, &writes].map(|unit| m.out(*unit, "idle"));
    let finished = (has_ended & !start) & (sender_idle & writer_idle);
    m.connect(control, "finished", finished);
    m.connect(control, "occupied", bit(false));

    let [read_error, write_error] = [&reads, &writes].map(|unit| m.out(*unit, "error"));
    m.connect(control, "memory_error", cat([write_error, read_error]));
    join(&mut m, control, &[(reads, "misplaced", "burst_error")]);
    report(&mut m, control, core, [splats, fragments], events(config));
    Ok(Top { module: m, core: core_module, manifests })
}
