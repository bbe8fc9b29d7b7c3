//! Sends splat copies to one of two sides, by a bit of the number of the rasterizer whose tile it is (thesis 5.5.3);
//! golden twin: `pointcore_golden::splat::distributor`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::DISTRIBUTED_COPIES;
use pointcore_contract::splat::records::SplatCopy;
use pointcore_contract::splat::units::distributor::PORTS;

use super::parts::share;
use crate::units::ports::{StreamInPorts, StreamOutPorts};
use rtl::Module;

/// The unit behind so many others of its kind; the first looks at the highest bit.
#[must_use]
pub fn module(config: &Config, level: u32) -> Module {
    let bit = config.rasterizer_bits().saturating_sub(1 + level);
    let mut m = Module::new("splat_distributor", "Sends splat copies to one of two sides, by their tile.");
    m.variant("bit", bit);
    let input = PORTS.input.declare(&mut m, config);
    let [low, high] = [PORTS.low, PORTS.high].map(|side| side.deep(&mut m, config, DISTRIBUTED_COPIES));
    let room = m.wire("room", low.room & high.room);
    m.drive(input.ready, room);
    let takes = m.wire("takes", room & input.valid);
    let is_high = match config.rasterizer_bits() {
        0 => input.record.tile.bit(0),
        _ => share::number_bit(config, input.record.tile, bit),
    };
    let sides = [!is_high, is_high];

    // On each side the first copy of a splat is another.
    let begun = ["low_begun", "high_begun"].map(|name| m.reg_reset(name, 1, 0));
    let [low_begun, high_begun] = begun.map(|begun| begun & !input.record.first);
    for ((register, begun), is_side) in begun.into_iter().zip([low_begun, high_begun]).zip(sides) {
        m.next_if(register, takes & !input.record.end, begun | is_side);
    }
    let first = !is_high.mux(high_begun, low_begun);
    let copy = SplatCopy { first, ..input.record };
    for (queue, is_side) in [low, high].into_iter().zip(sides) {
        queue.push(&mut m, config, takes & (input.record.end | is_side), copy);
    }
    m
}
