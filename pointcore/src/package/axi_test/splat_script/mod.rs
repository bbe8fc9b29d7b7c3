//! The script for the renderer.

mod frames;
mod runs;

use super::operations::{Channel, Pauses};
use super::registers;
use super::script::Script;
use crate::splat::SplatCore;
use pointcore_contract::bus::registers::{RegisterMap, SplatRegisters};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::LOCAL_BITS;
use pointcore_tb::lockstep::LockstepError;
use runs::Host;

/// The seed of everything that a script chooses.
const SEED: u64 = 1;
/// Cycles of a reset.
const RESET_CYCLES: u32 = 5;
/// Runs with pauses, all different.
const PAUSING: u32 = 4;
/// Runs that are aborted somewhere.
const ABORTS: u32 = 4;
/// Frames that a reset ends somewhere.
const RESETS: u32 = 4;

/// The bits of a fragment's field that name its tile.
pub fn tile(field: &str) -> u64 {
    match field {
        "column" | "row" => u64::MAX << LOCAL_BITS,
        "bin" => u64::MAX,
        _ => 0,
    }
}

/// The whole script.
///
/// # Errors
/// The golden model does not come to its end.
pub fn script(config: &Config, core: &SplatCore) -> Result<Script, LockstepError> {
    let map = SplatRegisters::registers(config);
    let frames = frames::all(config, core)?;
    let mut script = Script::new(SEED);
    script.pauses(Pauses::None);
    registers::check_reset(&mut script, &map);
    registers::check_accesses(&mut script, &map);
    script.pauses(Pauses::Some);
    registers::check_accesses(&mut script, &map);
    registers::check_late(&mut script, &map);

    let mut host = Host::new(&mut script, config, &map, &frames);
    host.enter(0);
    host.run(Pauses::None);
    (0..PAUSING).for_each(|_| host.run(Pauses::Some));
    Channel::NARROW.into_iter().for_each(|channel| host.run_narrow(channel));
    host.run_silently();
    host.run_disturbed();
    host.run_spoilt();
    host.run_long();
    host.run_ahead();
    host.run_late();
    host.enter(1);
    host.run(Pauses::Some);
    host.abort_within_packet();
    host.abort_held();
    (0..ABORTS).for_each(|_| host.abort_somewhere());
    (0..RESETS).for_each(|_| host.reset_somewhere());
    host.run(Pauses::None);
    registers::start_after_reset(host.control.script, &map);
    host.control.script.reset(RESET_CYCLES);
    registers::check_reset(host.control.script, &map);
    host.enter(0);
    host.run(Pauses::Some);
    Ok(script)
}
