//! Ends a run early (`docs/interfaces.md`): the core stays in reset while what was asked of memory comes in and what has begun to leave
//! goes out; golden twin: `pointcore_golden::bus::abort`.

use pointcore_contract::bus::units::QUIET_CYCLES;
use pointcore_contract::bus::units::abort::Ports;

use crate::units::ports::WordPort;
use rtl::{Module, address_width, lit};

/// The unit; ports as in `contract::bus::units::abort`.
#[must_use]
pub fn module() -> Module {
    let ports = Ports::ALL;
    let mut m = Module::new("bus_abort", "Ends a run early: keeps the core in reset until nothing is under way.");
    let asked = ports.asked.declare_word(&mut m, 1);
    let running = ports.running.declare_word(&mut m, 1);
    let quiet = ports.quiet.declare_word(&mut m, 1);
    let aborts = m.reg_reset("is_aborting", 1, 0);
    let width = address_width(QUIET_CYCLES);
    let quiet_cycles = m.reg_reset("quiet_cycles", width, 0);
    let counts = m.wire("counts", aborts & quiet);
    let ends = m.wire("ends", counts & quiet_cycles.eq_lit((QUIET_CYCLES - 1).into()));
    m.next(quiet_cycles, counts.mux(quiet_cycles.add_lit(1), lit(width, 0)));
    m.next(aborts, aborts.mux(!ends, asked & running));
    ports.aborts.drive_word(&mut m, aborts);
    ports.ended.event(&mut m, ends);
    m
}
