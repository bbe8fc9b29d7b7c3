//! Begins frames one after the other (`docs/interfaces.md`): uniforms wait in a memory until the frame before is set up; golden twin:
//! `pointcore_golden::bus::frames`.

use pointcore_contract::bus::units::FRAMES_MAX;
use pointcore_contract::bus::units::frames::Ports;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{UNIFORM_ADDRESS_BITS, UniformWrite, Uniforms, late_uniforms};
use pointcore_contract::{Field, fields};

use crate::units::ports::{Pulse, PulseInPorts, PulseOutPorts, WordPort};
use crate::units::wires::Wires;
use rtl::{Expr, Module, address_width, bit, lit};

/// The unit; ports as in `contract::bus::units::frames`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let ports = Ports::ALL;
    let mut m = Module::new("bus_frames", "Begins frames, each with the uniforms written before its start.");
    let count = fields::<Uniforms>(config).len() as u32;
    m.parameter("uniforms", count);
    let [start, set_up, sent] = [ports.start, ports.set_up, ports.sent].map(|port| port.declare_word(&mut m, 1));
    let write = ports.write.declare(&mut m, config);

    let waiting = m.reg_reset("waiting", 1, 0);
    let setting_up = m.reg_reset("setting_up", 1, 0);
    let under_way = m.reg_reset("under_way", address_width(FRAMES_MAX + 1), 0);
    let is_alone = m.wire("is_alone", under_way.is_zero());
    let has_room = !(*setting_up | under_way.eq_lit(FRAMES_MAX.into()));
    let begins = m.forward("begins", 1);
    let must_be_alone = late_changes(&mut m, config, &write, begins.expr());
    m.drive(begins, *waiting & has_room & (is_alone | !must_be_alone));
    m.next(setting_up, begins | (setting_up & !set_up));
    m.next(under_way, under_way + begins.zext(under_way.width()) - sent.zext(under_way.width()));

    // A uniform a cycle.
    let copies = m.reg_reset("copies", 1, 0);
    let copied = m.reg("copied", UNIFORM_ADDRESS_BITS);
    let ends = m.wire("ends", copies & copied.eq_lit(u128::from(count) - 1));
    m.next(copies, begins | (copies & !ends));
    m.next(copied, begins.mux(lit(UNIFORM_ADDRESS_BITS, 0), copied.add_lit(1)));
    m.next(waiting, start | (waiting & !ends));
    let values = m.memory_distributed("values", 1 << UNIFORM_ADDRESS_BITS, config.geometry.width());
    m.write(values, write.valid, write.record.address, write.record.data);
    let data = m.read_now(values, "value", copied);
    ports.uniform.registered(&mut m, config, copies, UniformWrite { address: copied.expr(), data });
    ports.begun.event(&mut m, ends);
    ports.idle.drive_word(&mut m, !waiting & is_alone);
    m
}

/// Whether the next frame has another value of what is read late: by units that may still be at work on the frames before.
fn late_changes(m: &mut Module, config: &Config, write: &Pulse<UniformWrite<Wires>>, begins: Expr) -> Expr {
    let uniforms = fields::<Uniforms>(config);
    let changes = late_uniforms(config).into_iter().map(|place| {
        let Field { name, width, .. } = &uniforms[place];
        let value = write.record.data.trunc(*width);
        let is_written = m.wire(&format!("writes_{name}"), write.valid & write.record.address.eq_lit(place as u128));
        let last = m.reg(name, *width);
        m.next_if(last, is_written, value);
        let changes = m.reg_reset(&format!("{name}_changes"), 1, 0);
        m.next(changes, (is_written & !last.eq(value)) | (changes & !begins));
        changes.expr()
    });
    changes.reduce(|any, one| any | one).unwrap_or(bit(false))
}
