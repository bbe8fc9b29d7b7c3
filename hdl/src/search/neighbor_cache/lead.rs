//! Lead or follow: finds out of each query whether one near it is under way, whose neighborhood it had better wait for; golden
//! twin: `pointcore_golden::search::neighbor_cache`.

use pointcore_contract::record;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{AXES, CachedQuery};
use pointcore_contract::search::units::neighbor_cache::PORTS;

use super::grid::{Grid, Measured, PLACE_BITS};
use crate::search::parts::sets::{decode, index_of, lowest, set};
use crate::units::ports::{Flow, StreamInPorts};
use crate::units::wires::Wires;
use rtl::{Expr, Module, Reg, bit, lit};

/// A query's part as a leader.
#[record(config: Config)]
pub(super) struct Leading {
    /// Others may wait for it.
    pub leads: bool,
    /// Its number among the leaders.
    #[bits(config.leader_bits())]
    pub leader: u8,
}

/// A query to be compared.
#[record(config: Config)]
pub(super) struct Asked {
    /// The query.
    pub query: CachedQuery,
    /// Whether others may wait for it.
    pub leading: Leading,
}

/// A leader whose fate is known, where `valid`.
#[derive(Clone, Copy)]
pub(super) struct Finished {
    pub valid: Expr,
    pub leader: Expr,
}

impl Finished {
    /// The query of `leading` is done with, where `valid`.
    pub fn of(valid: Expr, leading: Leading<Wires>) -> Self {
        Self { valid: valid & leading.leads, leader: leading.leader }
    }

    /// The same a cycle later.
    pub fn register(self, m: &mut Module, name: &str) -> Self {
        let valid = m.reg_reset(&format!("{name}_finishes"), 1, 0);
        let leader = m.reg(&format!("{name}_leader"), self.leader.width());
        m.next(valid, self.valid);
        m.next(leader, self.leader);
        Self { valid: valid.expr(), leader: leader.expr() }
    }

    /// Whether this leader is it.
    pub fn is(self, leader: Expr) -> Expr {
        self.valid & self.leader.eq(leader)
    }
}

/// Where there is room for a query in this cycle.
#[derive(Clone, Copy)]
pub(super) struct Room {
    pub to_follow: Expr,
    pub to_lead: Expr,
}

/// What becomes of a query in a cycle.
pub(super) struct Role {
    /// It waits for a leader.
    pub follows: Expr,
    /// For this one.
    pub followed: Expr,
    /// It is compared.
    pub leads: Expr,
    /// The query, as one that leads.
    pub asked: Asked<Wires>,
}

/// The queries that others may follow, a bit or a place for each.
struct Leaders {
    unfinished: Reg,
    /// Their places are on the grid as it is now.
    comparable: Reg,
    places: Vec<[Reg; 3]>,
}

impl Leaders {
    fn new(m: &mut Module, config: &Config) -> Self {
        let count = config.leaders();
        let unfinished = m.reg_reset("unfinished", count, 0);
        let comparable = m.reg("comparable", count);
        let place = |leader| AXES.map(|axis| m.reg(&format!("leader_{leader}_{axis}"), PLACE_BITS));
        Self { unfinished, comparable, places: (0..count).map(place).collect() }
    }

    /// Those near a place, for each axis; together they are those near it.
    fn near(&self, grid: &Grid, aligned: Expr, place: [Reg; 3]) -> [Expr; 3] {
        let near: [Expr; 3] = std::array::from_fn(|axis| {
            let is_near = |leader: &[Reg; 3]| grid.is_near(place[axis].expr(), leader[axis].expr());
            set(&self.places.iter().map(is_near).collect::<Vec<_>>())
        });
        let comparable = (aligned & grid.known).repeat(near[0].width()) & self.comparable;
        [near[0] & comparable, near[1], near[2]]
    }
}

/// The step of a query's way to its place: `true` in the cycle in which it is made.
fn steps(m: &mut Module, queries: &Flow<CachedQuery<Wires>>, taken: Expr) -> [Expr; 4] {
    let step = m.reg_reset("lead_step", 2, 0);
    let at = |number: u128| queries.valid & step.eq_lit(number);
    let steps = [0, 1, 2, 3].map(at);
    m.next_if(step, queries.valid & (!steps[3] | taken), step.add_lit(1));
    steps
}

/// Looks at one query after the other.
pub(super) fn lead(
    m: &mut Module,
    config: &Config,
    room: Room,
    finished: [Finished; 2],
    (measured, setup): (Measured, Expr),
) -> Role {
    let queries = PORTS.query.queue(m, config);
    let taken = m.forward("query_taken", 1);
    let [shifts, places, compares, decides] = steps(m, &queries, taken.expr());
    let grid = Grid::new(m, config.geometry);
    let leaders = Leaders::new(m, config);
    let count = leaders.unfinished.width();

    let aligned = m.reg("aligned", 1);
    m.next(aligned, (shifts | aligned) & !grid.changes);
    let point = queries.record.query.point;
    let place: [Reg; 3] = std::array::from_fn(|axis| {
        let name = format!("lead_{}", AXES[axis]);
        let shift = grid.shift(m, &name, shifts, point[axis]);
        let place = m.reg(&format!("{name}_place"), PLACE_BITS);
        m.next_if(place, places, grid.place(point[axis], shift));
        place
    });
    let near = leaders.near(&grid, aligned.expr(), place);
    let near: [Reg; 3] = std::array::from_fn(|axis| {
        let register = m.reg(&format!("near_{}", AXES[axis]), count);
        m.next_if(register, compares, near[axis]);
        register
    });

    let candidates = m.wire("candidates", (near[0] & near[1]) & (near[2] & leaders.unfinished));
    let is_near = candidates.any();
    let follows = m.wire("follows", decides & (is_near & room.to_follow));
    let leads = m.wire("leads", decides & (!is_near & room.to_lead));
    m.drive(taken, follows | leads);
    m.drive(queries.ready, taken);
    let bits = config.leader_bits();
    let first = m.wire("first_candidate", lowest(candidates));
    let followed = m.wire("followed", index_of(first, bits));

    let free = m.wire("free_leader", lowest(!leaders.unfinished));
    let becomes = m.wire("becomes_leader", free & leads.repeat(count));
    let gone = finished.map(|Finished { valid, leader }| decode(valid, leader, count));
    let gone = m.wire("finished_leaders", gone[0] | gone[1]);
    m.next(leaders.unfinished, (leaders.unfinished | becomes) & !gone);
    let comparable =
        becomes.any().mux((leaders.comparable & !becomes) | (becomes & aligned.repeat(count)), leaders.comparable);
    m.next(leaders.comparable, comparable & !grid.changes.repeat(count));
    for (leader, places) in (0..).zip(&leaders.places) {
        places.iter().zip(place).for_each(|(of_leader, place)| m.next_if(*of_leader, becomes.bit(leader), place));
    }
    m.assert("finished_leaders_were_none_before", (gone & !leaders.unfinished).is_zero());
    grid.update(m, measured, setup);
    let leading = Leading { leads: free.any(), leader: index_of(free, bits) };
    Role { follows, followed, leads, asked: Asked { query: queries.record, leading } }
}

/// A query that others do not wait for.
pub(super) fn alone(config: &Config, query: CachedQuery<Wires>) -> Asked<Wires> {
    Asked { query, leading: Leading { leads: bit(false), leader: lit(config.leader_bits(), 0) } }
}
