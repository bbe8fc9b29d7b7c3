//! The script for the search core.

mod aborts;
pub mod memory;
mod runs;
mod searches;
mod window;

use super::operations::{Channel, Pauses};
use super::registers;
use super::script::Script;
use crate::search::SearchError;
use pointcore_contract::bus::registers::{RegisterMap, SearchRegisters};
use pointcore_contract::search::Config;
use runs::Host;
use searches::Searches;

/// The seed of everything that a script chooses.
const SEED: u64 = 1;
/// Cycles of a reset.
const RESET_CYCLES: u32 = 5;
/// Runs with pauses, all different.
const PAUSING: u32 = 6;
/// Runs that are aborted somewhere.
const ABORTS: u32 = 6;

/// The whole script.
///
/// # Errors
/// The configuration is not valid, or the golden model is stuck.
pub fn script(config: &Config) -> Result<Script, SearchError> {
    let map = SearchRegisters::registers(config);
    let searches = Searches::new(config)?;
    let mut script = Script::new(SEED);
    script.pauses(Pauses::None);
    registers::check_reset(&mut script, &map);
    registers::check_accesses(&mut script, &map);
    script.pauses(Pauses::Some);
    registers::check_accesses(&mut script, &map);
    registers::check_late(&mut script, &map);

    let mut host = Host::new(&mut script, config, &map, &searches);
    if config.tree_cache == 0 {
        host.check_window();
    }
    host.enter(0);
    host.run(Pauses::None);
    (0..PAUSING).for_each(|_| host.run(Pauses::Some));
    [Channel::Receive, Channel::ReadData].into_iter().for_each(|channel| host.run_narrow(channel));
    host.run_silently();
    host.run_disturbed();
    host.run_spoilt();
    host.give_unasked();
    host.run_long();
    host.run_without_end();
    host.abort_within_packet();
    host.abort_held();
    host.reset_among_packets();
    (0..ABORTS).for_each(|_| host.abort_somewhere());
    host.run(Pauses::Some);
    host.enter(1);
    host.run(Pauses::Some);
    host.run(Pauses::None);
    host.read_empty_leaf();
    host.enter(0);
    host.run(Pauses::Some);
    if config.neighbor_cache > 0 {
        host.run_cached();
    }
    registers::start_after_reset(host.control.script, &map);
    host.control.script.reset(RESET_CYCLES);
    registers::check_reset(host.control.script, &map);
    host.enter(1);
    host.run(Pauses::Some);
    Ok(script)
}
