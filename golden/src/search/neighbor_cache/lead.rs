//! Lead or follow: finds out of each query whether one near it is under way, whose neighborhood it had better wait for.

use super::grid::{Grid, Place, Shifts};
use crate::stream::Skid;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::CachedQuery;

/// A query to be compared, and its number among the leaders if others may wait for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    pub(super) query: CachedQuery,
    pub(super) leader: Option<usize>,
}

/// A query under way that others may follow.
#[derive(Clone, Copy, Debug, Default)]
struct Leader {
    unfinished: bool,
    /// Its place is one on the grid as it is now.
    comparable: bool,
    place: Place,
}

/// What is known of the query that is looked at.
#[derive(Clone, Debug)]
enum Stage {
    New,
    Shifted(Shifts),
    Placed(Place),
    Compared { place: Place, near: Vec<bool> },
}

/// What becomes of a query.
#[derive(Clone, Copy, Debug)]
pub(super) enum Role {
    /// It waits for a leader.
    Follows { query: CachedQuery, leader: usize },
    /// It is compared at once.
    Leads { asked: Asked, place: Place },
}

/// The leaders, and the query that is looked at.
#[derive(Clone, Debug)]
pub(super) struct Lead {
    queries: Skid<CachedQuery>,
    stage: Stage,
    /// The grid has not changed since the query was looked at.
    aligned: bool,
    grid: Grid,
    leaders: Vec<Leader>,
}

impl Lead {
    pub(super) fn new(config: &Config) -> Self {
        Self {
            queries: Skid::default(),
            stage: Stage::New,
            aligned: false,
            grid: Grid::new(config.geometry),
            leaders: vec![Leader::default(); config.leaders() as usize],
        }
    }

    pub(super) fn in_ready(&self) -> bool {
        self.queries.in_ready()
    }

    /// What becomes of the query in this cycle, if there is room for it among those that follow or lead.
    pub(super) fn role(&self, room_to_follow: bool, room_to_lead: bool) -> Option<Role> {
        let (Some(query), Stage::Compared { place, near }) = (self.queries.out().copied(), &self.stage) else {
            return None;
        };
        let followed = self.leaders.iter().zip(near).position(|(leader, near)| leader.unfinished && *near);
        match followed {
            Some(leader) => room_to_follow.then_some(Role::Follows { query, leader }),
            None => room_to_lead.then(|| {
                let leader = self.leaders.iter().position(|leader| !leader.unfinished);
                Role::Leads { asked: Asked { query, leader }, place: *place }
            }),
        }
    }

    /// One clock edge; `measured` is a margin that the grid follows, `finished` are the leaders whose fate is known.
    pub(super) fn clock(
        &mut self,
        input: Option<CachedQuery>,
        role: Option<Role>,
        measured: Option<u32>,
        finished: &[usize],
        forgets: bool,
    ) {
        if let Some(query) = self.queries.out() {
            let point = query.query.point;
            self.stage = match &self.stage {
                Stage::New => {
                    self.aligned = true;
                    Stage::Shifted(self.grid.shifts(point))
                }
                Stage::Shifted(shifts) => Stage::Placed(self.grid.place(point, *shifts)),
                Stage::Placed(place) => Stage::Compared { place: *place, near: self.near(*place) },
                compared @ Stage::Compared { .. } => compared.clone(),
            };
        }
        if let Some(Role::Leads { asked: Asked { leader: Some(leader), .. }, place }) = role {
            self.leaders[leader] = Leader { unfinished: true, comparable: self.aligned, place };
        }
        if role.is_some() {
            self.stage = Stage::New;
        }
        for leader in finished {
            self.leaders[*leader].unfinished = false;
        }
        if measured.is_some_and(|margin| self.grid.measure(margin)) {
            self.aligned = false;
            self.leaders.iter_mut().for_each(|leader| leader.comparable = false);
        }
        if forgets {
            self.grid.forget();
        }
        self.queries.step(input, role.is_some());
    }

    fn near(&self, place: Place) -> Vec<bool> {
        let is_near = |leader: &Leader| self.aligned && leader.comparable && self.grid.is_near(place, leader.place);
        self.leaders.iter().map(is_near).collect()
    }
}
