//! Copy: takes the neighbors that a search found into an entry, and judges how far the neighborhood may be reused.

use super::coverage::{Extent, Reference};
use super::entries::Entries;
use crate::datapath::{Datapath, Token};
use crate::stream::Skid;
use pointcore_contract::Format;
use pointcore_contract::search::records::{CacheSetup, Query, QueryResult};

/// The neighborhood that is copied.
#[derive(Clone, Copy, Debug)]
pub(super) struct Copying {
    pub(super) entry: usize,
    /// The query that was searched for, under the host's number.
    pub(super) query: Query,
    /// Its number among the leaders, if it leads.
    leader: Option<usize>,
    /// Neighbors copied.
    pub(super) copied: u8,
    /// Squared distance of the last one copied, 0 if there is none.
    distance2: u32,
}

/// What happens in a cycle.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// Nothing can be done.
    Wait,
    /// The search of this ticket is given an entry.
    Start { entry: usize, ticket: u32 },
    /// A neighbor is taken; if `last`, the neighborhood is complete.
    Take { copying: Copying, result: QueryResult },
}

/// How a neighborhood is closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Closing {
    extent: Extent,
    /// Neighbors of an answer.
    count: u8,
}

impl Copying {
    /// What the last result makes of the neighborhood.
    fn close(&self, result: &QueryResult, setup: &CacheSetup) -> Closing {
        let Query { k, radius2, .. } = self.query;
        let found = self.copied + u8::from(result.found);
        let is_full = found == k;
        let near2 = if setup.ball {
            0
        } else if is_full {
            self.distance2
        } else if found + 1 == k {
            if result.found { result.distance2 } else { self.distance2 }
        } else {
            radius2
        };
        let far2 = if is_full { result.distance2 } else { radius2 };
        let count = if is_full && !setup.ball { found - 1 } else { found };
        Closing { extent: Extent { far2, near2 }, count }
    }
}

/// A complete neighborhood on its way to its entry.
#[derive(Clone, Copy, Debug)]
struct Complete {
    entry: usize,
    reference: Reference,
    leader: Option<usize>,
}

/// The copying of neighborhoods.
#[derive(Clone, Debug)]
pub(super) struct Copy {
    geometry: Format,
    found: Skid<QueryResult>,
    copying: Option<Copying>,
    /// A complete neighborhood whose comparison value is to be computed.
    closed: Option<Complete>,
    cover: Datapath<Complete>,
}

impl Copy {
    pub(super) fn new(geometry: Format, latency: u32) -> Self {
        Self {
            geometry,
            found: Skid::default(),
            copying: None,
            closed: None,
            cover: Datapath::always_taken(latency, 1),
        }
    }

    pub(super) fn in_ready(&self) -> bool {
        self.found.in_ready()
    }

    /// The entry that is copied to.
    pub(super) fn target(&self) -> Option<usize> {
        self.copying.map(|copying| copying.entry)
    }

    /// What happens in a cycle in which no hit leaves, or one does; an answer needs room.
    pub(super) fn step(&self, entries: &Entries, hit_leaves: bool, deliver_has_room: bool) -> Step {
        match (self.found.out().copied(), self.copying) {
            (Some(result), Some(copying)) if !result.last || (deliver_has_room && !hit_leaves) => {
                Step::Take { copying, result }
            }
            (Some(result), None) if !hit_leaves => match entries.victim() {
                Some(entry) => Step::Start { entry, ticket: result.number },
                None => Step::Wait,
            },
            _ => Step::Wait,
        }
    }

    /// The leader whose neighborhood is present from the next cycle on, if there is one.
    pub(super) fn finished(&self) -> Option<usize> {
        self.cover.out().and_then(|complete| complete.leader)
    }

    /// One clock edge; `query` is what was read of the ticket of a copy that starts.
    pub(super) fn clock(
        &mut self,
        found: Option<QueryResult>,
        step: &Step,
        query: Option<(Query, Option<usize>)>,
        entries: &mut Entries,
        setup: &CacheSetup,
    ) {
        let judged = self.closed.take();
        match *step {
            Step::Wait => {}
            Step::Start { entry, .. } => {
                entries.start_writing(entry);
                self.copying = query.map(|(query, leader)| Copying { entry, query, leader, copied: 0, distance2: 0 });
            }
            Step::Take { copying, result } if result.last => {
                let Closing { extent, count } = copying.close(&result, setup);
                entries.set_count(copying.entry, count);
                let cover = extent.cover(self.geometry, setup);
                let reference = Reference { point: copying.query.point, cover };
                self.closed = Some(Complete { entry: copying.entry, reference, leader: copying.leader });
                self.copying = None;
            }
            Step::Take { copying, result } if result.found => {
                let distance2 = result.distance2;
                self.copying = Some(Copying { copied: copying.copied + 1, distance2, ..copying });
            }
            Step::Take { .. } => {}
        }
        if let Some(Complete { entry, reference, .. }) = self.cover.step(judged.map(Token::Kept), true) {
            entries.stop_writing(entry, reference);
        }
        self.found.step(found, matches!(step, Step::Take { .. }));
    }
}
