//! Leads two sides to one memory, and their finished pixels into one stream (thesis 5.5.3); golden twin:
//! `pointcore_golden::splat::collector`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::COLLECTED_READS;
use pointcore_contract::splat::records::{FinishedPixel, LOCAL_BITS, Pixel, PixelRun, RUN_BITS, StoredPixel};
use pointcore_contract::splat::units::collector::PORTS;
use pointcore_contract::unit::In;
use pointcore_contract::{Record, record};

use crate::stream::{fifo_distributed, skid};
use crate::units::ports::{QueueOut, StreamInPorts, StreamOutPorts};
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, Wired, layout};
use rtl::{Expr, Module, Reg, lit};

/// Pixels that are to come.
#[record(config: Config)]
struct Awaited {
    /// They are for the side of the higher numbers.
    is_high: bool,
    /// How many.
    #[bits(RUN_BITS)]
    count: u8,
}

/// What moves from one of the sides.
struct Taken<B> {
    moves: Expr,
    is_high: Expr,
    record: B,
}

/// Takes from the side whose turn it is, if `open`; the turn passes on where nothing moves.
fn take<R: Record<Config = Config>>(
    m: &mut Module,
    config: &Config,
    what: &str,
    sides: [In<R>; 2],
    open: impl FnOnce(Expr) -> Expr,
) -> Taken<Wired<R>> {
    let turn = m.reg_reset(&format!("{what}_turn"), 1, 0);
    let open = m.wire(&format!("{what}_open"), open(turn.expr()));
    let [low, high] = sides.map(|side| side.declare(m, config));
    m.drive(low.ready, open & !turn);
    m.drive(high.ready, open & turn);
    let moves = m.wire(&format!("{what}_moves"), open & turn.mux(high.valid, low.valid));
    m.next(turn, turn ^ !moves);
    Taken { moves, is_high: turn.expr(), record: Bundle::choose(config, turn.expr(), high.record, low.record) }
}

/// Leads requests to the memory, and data to the sides in their order.
fn reads(m: &mut Module, config: &Config, writes: Expr) {
    let read = PORTS.read.queue(m, config);
    let queue = fifo_distributed(COLLECTED_READS, &layout::<Awaited>(config));
    let (order, awaited) = Pushed::<Awaited>::place(m, config, "order", queue);
    // A read must find in memory what was written before it.
    let room = (read.room & order.room) & !writes;
    let request = take::<PixelRun>(m, config, "read", [PORTS.low_read, PORTS.high_read], |_| room);
    read.push(m, config, request.moves, request.record);
    let run = Awaited { is_high: request.is_high, count: request.record.count };
    order.push(m, config, request.moves, run);

    let data = PORTS.data.declare(m, config).through(m, config, "data_queue", skid(&layout::<Pixel>(config)));
    let is_high = awaited.record.is_high;
    let shows = data.valid & awaited.valid;
    let low = PORTS.low_data.drive(m, config, shows & !is_high, data.record);
    let high = PORTS.high_data.drive(m, config, shows & is_high, data.record);
    let taken = m.wire("data_taken", awaited.valid & is_high.mux(high, low));
    m.drive(data.ready, taken);
    let came = m.reg_reset("came", LOCAL_BITS, 0);
    let comes = m.wire("data_comes", taken & data.valid);
    let count = m.wire("came_now", came.zext(RUN_BITS).add_lit(1));
    let is_last = m.wire("is_last", comes & count.eq(awaited.record.count));
    m.next_if(came, comes, is_last.mux(lit(LOCAL_BITS, 0), count.trunc(LOCAL_BITS)));
    m.drive(awaited.ready, is_last);
}

/// Leads finished pixels into one stream, which ends when both sides have.
fn pixels(m: &mut Module, config: &Config, out: QueueOut<FinishedPixel>, ended: [Reg; 2]) {
    let [low, high] = ended;
    let sides = [PORTS.low_pixel, PORTS.high_pixel];
    let finished = take::<FinishedPixel>(m, config, "pixel", sides, |turn| out.room & !turn.mux(high, low));
    let closing = m.reg_reset("closing", 1, 0);
    let closes = m.wire("closes", ((low & high) & !closing) & out.room);
    let has_closed = m.wire("has_closed", closing & !out.holds);
    m.next(closing, closes | (closing & !has_closed));
    let ends = m.wire("ends", finished.moves & finished.record.end);
    for (ended, is_side) in ended.into_iter().zip([!finished.is_high, finished.is_high]) {
        m.next(ended, !has_closed & (ended | (ends & is_side)));
    }
    let pushes = closes | (finished.moves & !finished.record.end);
    out.push(m, config, pushes, FinishedPixel { end: closes, ..finished.record });
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_collector", "Leads two sides to one memory, and their pixels into one stream.");
    let write = PORTS.write.queue(&mut m, config);
    let ended = ["low_ended", "high_ended"].map(|name| m.reg_reset(name, 1, 0));
    reads(&mut m, config, write.holds);
    let room = write.room;
    let written = take::<StoredPixel>(&mut m, config, "write", [PORTS.low_write, PORTS.high_write], |_| room);
    write.push(&mut m, config, written.moves, written.record);
    let out = PORTS.pixel.queue(&mut m, config);
    pixels(&mut m, config, out, ended);
    m
}
