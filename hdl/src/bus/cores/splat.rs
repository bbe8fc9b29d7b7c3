//! The renderer on AXI (`docs/interfaces.md`): splats and fragments as packets, the reconstruction buffer in memory, registers.

use std::rc::Rc;

use pointcore_contract::bus::registers::{
    ErrorInputs, ErrorSources, RegisterMap, SplatRegisters, SplatSettings, UniformBits,
};
use pointcore_contract::bus::units;
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::RUN_PIXELS_MAX;
use pointcore_contract::splat::records::{Fragment, Pixel, PlacedPixel, Splat, StoredPixel, UniformWrite};
use pointcore_contract::splat::units::top::{PORTS, Ports as CorePorts};

use super::buffer::{Buffer, Placed, Run};
use super::port::PortSignals;
use super::wiring::{Abort, report};
use super::{depths, payloads};
use crate::bus::{Top, frames, packet_in, packet_out, reader, registers, writer};
use crate::compiler::{CompileError, Options};
use crate::splat::arbiter::{self, Client};
use crate::splat::parts::collected::{self, Source};
use crate::splat::top;
use crate::stream::fifo;
use crate::units::passage::Passage;
use crate::units::ports::{
    Flow, InputPorts, OutputPorts, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, export,
    pipe, pulse,
};
use crate::units::wires::layout;
use rtl::{Expr, Instance, Module, Reg, address_width, bit, cat, lit};

/// Errors from elsewhere: misplaced `rlast`, packets, answers to reads and writes.
fn error_sources(config: &Config) -> ErrorSources {
    let memories = 1 + config.payload_ports();
    let reads = memories + config.merge_ports();
    ErrorSources { busy: 0, burst: reads, packet: 1, memory: reads + memories + config.depth_writers() }
}

/// Pixels that may be asked for and not taken: enough for memory's latency, so that one a cycle may come. A power of two.
const PIXELS_ASKED_MAX: u32 = 128;

/// The ports of what is placed.
const TOP: Ports = Ports::ALL;
const CONTROL: units::registers::Ports<SplatRegisters> = units::registers::Ports::ALL;
const SPLATS: units::packet_in::Ports<Splat> = units::packet_in::Ports::ALL;
const FRAMES: units::frames::Ports = units::frames::Ports::ALL;
const FRAGMENTS: units::packet_out::Ports<Fragment> = units::packet_out::Ports::ALL;
const READS: units::reader::Ports<Pixel> = units::reader::Ports::ALL;
const WRITES: units::writer::Ports<Pixel> = units::writer::Ports::ALL;

/// Builds the core on its bus; ports as in `contract::bus::units::splat_axi`.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Top, CompileError> {
    let top::Core { module: core_module, manifests } = top::core(config, options)?;
    let core_module = Rc::new(core_module);
    let (bus, sources) = (config.bus, error_sources(config));
    let mut m = Module::new("splat_axi", "Surface-splat renderer on AXI.");
    // First, so that its modules have the names that they have without a bus.
    let core = m.instance("core", core_module.clone());
    let control = m.instance("registers", registers::module::<SplatRegisters>(config, sources));
    let splats = m.instance("splats", packet_in::module::<Splat>(config, bus.stream_bits));
    let frames = m.instance("frames", frames::module(config));
    let fragments = m.instance("fragments", packet_out::module::<Fragment>(config, bus.stream_bits));
    let reads = m.instance("reads", reader::module::<Pixel>(config, bus.memory_bits, RUN_PIXELS_MAX));
    let writes = m.instance("writes", writer::module::<Pixel>(config, bus.memory_bits));
    export(&mut m, &(), (control, CONTROL.host), TOP.registers);
    export(&mut m, &bus.stream_bits, (splats, SPLATS.packets), TOP.splats);
    export(&mut m, &bus.stream_bits, (fragments, FRAGMENTS.packets), TOP.fragments);
    export(&mut m, &bus.memory_bits, (reads, READS.memory), TOP.reads);
    export(&mut m, &bus.memory_bits, (writes, WRITES.memory), TOP.writes);

    let [start, core_reset] = [CONTROL.start, CONTROL.core_reset].map(|port| port.word_of(&mut m, control));
    let abort = Abort::place::<SplatRegisters>(&mut m, control);
    let core_reset = core_reset | abort.drops;
    m.reset_by(core, core_reset);
    let (memory, fragment) = only_port(&mut m, config, core, core_reset);
    m.reset_by(splats, abort.drops);
    pipe(&mut m, config, (splats, SPLATS.out), (core, PORTS.splat));
    m.reset_by(frames, abort.drops);
    FRAMES.start.feed_word(&mut m, frames, start);
    let written = CONTROL.uniform.of(&mut m, &uniform_bits(config), control);
    let record = UniformWrite { address: written.record.address, data: written.record.data };
    FRAMES.write.feed(&mut m, config, frames, Pulse { valid: written.valid, record });
    pulse(&mut m, config, (frames, FRAMES.uniform), (core, PORTS.uniform));
    let begun = FRAMES.begun.word_of(&mut m, frames);
    CONTROL.begun.feed_word(&mut m, control, begun);
    SPLATS.opens.feed_word(&mut m, splats, begun);
    let set_up = PORTS.frame_set_up.word_of(&mut m, core);
    FRAMES.set_up.feed_word(&mut m, frames, set_up);

    let SplatSettings { buffer_base: base, payload_base, depth_base } = CONTROL.settings.of(&mut m, config, control);
    let (run_pixels, memory_bits) = (RUN_PIXELS_MAX, bus.memory_bits);
    let buffer = Buffer::<Pixel> { name: "", config, run_pixels, memory_bits, base, reads };
    let write = memory.write.of(&mut m, config, memory.instance);
    let write = write.map(|StoredPixel { surface, placed }| {
        let PlacedPixel { tile, pixel, value } = placed;
        Placed { tile: cat([surface, tile]), pixel, value }
    });
    let (read, all_came) = read_pixels(&mut m, config, memory, reads, abort);
    buffer.order(&mut m, read, writes, write);
    let mut others = payloads::connect(&mut m, config, core, payload_base, abort);
    others.extend(depths::connect(&mut m, config, core, depth_base, abort));

    // The run ends when the last packet of its frames has left and memory has answered.
    let fragment = fragment.1.of(&mut m, config, fragment.0);
    FRAGMENTS.input.feed(&mut m, config, fragments, fragment);
    FRAMES.sent.feed_word(&mut m, frames, fragment.transfer() & fragment.record.end);
    let no_frame = FRAMES.idle.word_of(&mut m, frames);
    let idle = [FRAGMENTS.idle.word_of(&mut m, fragments), WRITES.idle.word_of(&mut m, writes)];
    let all = |begun: Expr, more: fn(&PortSignals) -> Expr| others.iter().map(more).fold(begun, |all, more| all & more);
    let idle = m.wire("is_idle", all(idle[0] & idle[1], |port| port.written));
    let quiet = m.wire("quiet", all(idle & all_came, |port| port.all_came));
    let finished = abort.finished(&mut m, (no_frame & !start) & idle, quiet);
    CONTROL.finished.feed_word(&mut m, control, finished);
    CONTROL.occupied.feed_word(&mut m, control, abort.drops);

    let [read_error, write_error] = [READS.error.word_of(&mut m, reads), WRITES.error.word_of(&mut m, writes)];
    let misplaced = READS.misplaced.word_of(&mut m, reads);
    let errors = ErrorInputs {
        burst_error: cat(others.iter().map(|port| port.misplaced).chain([misplaced])),
        packet_error: SPLATS.refused.word_of(&mut m, splats),
        memory_error: cat(others.iter().flat_map(|port| port.errors.iter().copied()).chain([write_error, read_error])),
        ..ErrorInputs::default()
    };
    CONTROL.errors.feed(&mut m, &sources, control, errors);
    let events = (core, PORTS.events);
    let irq = report::<SplatRegisters, Splat, Fragment>(&mut m, config, control, events, [splats, fragments]);
    TOP.irq.drive_word(&mut m, irq);
    Ok(Top { module: m, core: core_module, manifests })
}

/// Leads all of the core's ports to memory to one, and its fragments into one stream: the bus moves no more than a pixel a cycle.
fn only_port(m: &mut Module, config: &Config, core: Instance, reset: Expr) -> (Client, Source<Fragment>) {
    let of_port = |port: usize| {
        let CorePorts { read, data, write, fragment, .. } = PORTS;
        let client = Client { instance: core, read: read[port], data: data[port], write: write[port] };
        (client, (core, fragment[port]))
    };
    let mut ports: Vec<_> = (0..config.memory_ports as usize).map(of_port).collect();
    while ports.len() > 1 {
        let level = ports.len() / 2;
        let join = |(number, pair): (usize, &[(Client, Source<Fragment>)])| {
            let client = arbiter::join(m, config, &format!("arbiter_{level}_{number}"), [pair[0].0, pair[1].0]);
            let name = format!("fragment_collector_{level}_{number}");
            let fragments = collected::join(m, config, &name, [pair[0].1, pair[1].1]);
            m.reset_by(client.instance, reset);
            m.reset_by(fragments.0, reset);
            (client, fragments)
        };
        ports = ports.chunks(2).enumerate().map(join).collect();
    }
    ports[0]
}

/// Leads pixels from memory through a queue that has room for all that was asked for, so that memory never waits for the core, which
/// may wait for memory to take what it writes. Returns the pixels to be read, and whether all that was asked for came.
fn read_pixels(m: &mut Module, config: &Config, client: Client, reads: Instance, abort: Abort) -> (Flow<Run>, Expr) {
    let wanted = client.read.of(m, config, client.instance);
    let queue = Passage::<Pixel>::place(m, "pixels", fifo(PIXELS_ASKED_MAX, &layout::<Pixel>(config)));
    m.reset_by(queue.instance(), abort.drops);
    let pixel = READS.record.of(m, config, reads);
    let room = queue.room(m);
    queue.push(m, config, pixel.valid, pixel.record);
    m.drive(pixel.ready, room | abort.drops);
    let stored = queue.out(m, config);
    let taken = client.data.offer(m, config, client.instance, stored.valid, stored.record);
    m.drive(stored.ready, taken);

    // Pixels asked for that have not come, and that have not been taken.
    let ready = m.forward("reads_run", 1);
    let begins = m.wire("run_begins", wanted.transfer());
    let asked = begins.repeat(wanted.record.count.width()) & wanted.record.count;
    let awaited = unfinished(m, "pixels_awaited", PIXELS_ASKED_MAX, asked, pixel.transfer(), bit(false));
    let held = unfinished(m, "pixels_held", PIXELS_ASKED_MAX, asked, stored.transfer(), abort.drops);
    // A run of any length fits.
    let fits = m.wire("run_fits", held.lt_lit(u128::from(PIXELS_ASKED_MAX - RUN_PIXELS_MAX + 1)));
    m.drive(wanted.ready, ready & fits);
    let run = wanted.record;
    let run = Run { tile: cat([run.surface, run.tile]), pixel: run.pixel, count: run.count };
    (Flow { valid: wanted.valid & fits, record: run, ready }, awaited.is_zero())
}

/// Counts records that were asked for, less those that moved: so many at most.
pub(super) fn unfinished(m: &mut Module, name: &str, most: u32, asked: Expr, moved: Expr, clear: Expr) -> Reg {
    let bits = address_width(most + 1);
    let records = m.reg_reset(name, bits, 0);
    m.next(records, clear.mux(lit(bits, 0), records + asked.zext(bits) - moved.zext(bits)));
    records
}

/// How writes to uniforms come from the registers.
fn uniform_bits(config: &Config) -> UniformBits {
    UniformBits::of(&SplatRegisters::registers(config)).unwrap_or_default()
}
