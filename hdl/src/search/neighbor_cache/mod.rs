//! Coherent neighbor cache (thesis 6.4.2, 6.5.3, 6.6.3): answers a query that lies well inside the ball of an earlier one with
//! that one's neighbors, and has the others searched for; golden twin: `pointcore_golden::search::neighbor_cache`.

mod check;
mod copy;
mod cover;
mod deliver;
mod follow;
mod grid;
mod lead;
mod lru;
mod neighborhoods;
mod tickets;

use pointcore_contract::search::Config;
use pointcore_contract::search::units::neighbor_cache::PORTS;

use crate::compiler::{CompileError, Manifest, Options};
use crate::stream::skid;
use crate::units::ports::PulseInPorts;
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, layout};
use rtl::Module;

use check::{Check, Resources};
use copy::copy;
use cover::Covers;
use deliver::Deliveries;
use follow::Follow;
use lead::{Asked, Room, alone, lead};
use lru::{Chosen, Entries, Uses};
use neighborhoods::Neighborhoods;
use tickets::Tickets;

/// The unit's module and what the compiler decided about its datapaths.
pub struct NeighborCache {
    /// The module, `search_neighbor_cache`.
    pub module: Module,
    /// Of the datapath that compares a query with an entry.
    pub check: Manifest,
    /// Of the datapath that computes an entry's comparison value.
    pub cover: Manifest,
}

/// The unit.
///
/// # Errors
/// What the compiler rejects.
pub fn unit(config: &Config, options: &Options) -> Result<NeighborCache, CompileError> {
    let mut m = Module::new("search_neighbor_cache", "Answers coherent queries with the neighbors of earlier ones.");
    m.parameter("entries", config.neighbor_cache);
    m.parameter("neighbors", config.neighbors);
    m.parameter("tickets", config.tickets());
    let setup = PORTS.setup.declare(&mut m, config);
    let settings = setup.record.register(&mut m, config, "", setup.valid);
    let entries = Entries::new(&mut m, config);
    let covers = Covers::new(&mut m, config);
    let neighborhoods = Neighborhoods::new(&mut m, config);
    let tickets = Tickets::new(&mut m, config);
    let deliveries = Deliveries::new(&mut m, config);
    let room = deliveries.room;

    let copying = m.forward("copied", 1);
    let target = m.forward("copied_entry", config.entry_bits());
    let copied = Chosen { valid: copying.expr(), entry: target.expr() };
    let (pushed, asks) = Pushed::<Asked>::place(&mut m, config, "asks", skid(&layout::<Asked>(config)));
    let resources = Resources { asks, entries: &entries, covers: &covers, tickets: &tickets, settings, copied, room };
    let check = Check::new(&mut m, config, options, &resources)?;
    let hit = check.hit;
    let copy = copy(&mut m, config, (&entries, &tickets, &neighborhoods), (settings.ball, hit.by.valid, room));
    m.drive(copying, copy.target.valid);
    m.drive(target, copy.target.entry);
    let (judged, delivered, cover) =
        covers.judge(&mut m, config, options, settings, (copy.end.by.valid, copy.reach))?;
    let release = deliveries.send(&mut m, config, [hit, copy.end], &neighborhoods);

    let finished = [("hit", check.finished), ("delivered", delivered)];
    let finished = finished.map(|(name, finished)| finished.register(&mut m, name));
    let follow = Follow::new(&mut m, config, pushed.room);
    let room = Room { to_follow: follow.has_room, to_lead: pushed.room & !follow.has_next };
    let role = lead(&mut m, config, room, finished, (check.measured, setup.valid));
    let asked = Asked::choose(config, follow.has_next, alone(config, follow.next), role.asked);
    pushed.push(&mut m, config, follow.has_next | role.leads, asked);
    follow.update(&mut m, config, &role, finished);

    tickets.update(&mut m, config, &check, copy.end.by.valid, copy.ticket);
    let uses = Uses { setup: setup.valid, hit: hit.by, start: copy.starts, end: copy.end.by, judged, release };
    entries.update(&mut m, &uses);
    Ok(NeighborCache { module: m, check: check.manifest, cover })
}
