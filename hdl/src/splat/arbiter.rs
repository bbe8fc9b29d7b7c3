//! Leads two sides to one port of the reconstruction buffer (thesis 5.5.3); golden twin: `pointcore_golden::splat::arbiter`.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::COLLECTED_READS;
use pointcore_contract::splat::records::{LOCAL_BITS, Pixel, PixelRun, RUN_BITS, StoredPixel};
use pointcore_contract::splat::units::arbiter::PORTS;
use pointcore_contract::unit::{In, Out};

use super::parts::turns::take;
use crate::stream::{fifo_distributed, skid};
use crate::units::ports::{StreamInPorts, StreamOutPorts, pipe};
use crate::units::queue::Pushed;
use crate::units::wires::layout;
use rtl::{Expr, Instance, Module, lit};

/// Pixels that are to come.
#[record(config: Config)]
struct Awaited {
    /// They are for the side of the higher numbers.
    is_high: bool,
    /// How many.
    #[bits(RUN_BITS)]
    count: u8,
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

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_arbiter", "Leads two sides to one port of the reconstruction buffer.");
    let write = PORTS.write.queue(&mut m, config);
    reads(&mut m, config, write.holds);
    let room = write.room;
    let written = take::<StoredPixel>(&mut m, config, "write", [PORTS.low_write, PORTS.high_write], |_| room);
    write.push(&mut m, config, written.moves, written.record);
    m
}

/// Whoever reads and writes pixels, and its ports.
#[derive(Clone, Copy)]
pub(crate) struct Client {
    pub instance: Instance,
    pub read: Out<PixelRun>,
    pub data: In<Pixel>,
    pub write: Out<StoredPixel>,
}

/// Places an arbiter of that name between two clients and the port that they share.
pub(crate) fn join(m: &mut Module, config: &Config, name: &str, [low, high]: [Client; 2]) -> Client {
    let instance = m.instance(name, module(config));
    let sides = [
        (low, PORTS.low_read, PORTS.low_data, PORTS.low_write),
        (high, PORTS.high_read, PORTS.high_data, PORTS.high_write),
    ];
    for (client, read, data, write) in sides {
        pipe(m, config, (client.instance, client.read), (instance, read));
        pipe(m, config, (instance, data), (client.instance, client.data));
        pipe(m, config, (client.instance, client.write), (instance, write));
    }
    Client { instance, read: PORTS.read, data: PORTS.data, write: PORTS.write }
}
