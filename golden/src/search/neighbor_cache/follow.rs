//! The queries that follow others: each waits until its leader's fate is known, and is compared then.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::CachedQuery;

/// How far a query has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    /// There is none.
    #[default]
    Free,
    WaitsFor(usize),
    /// Its leader has finished.
    Ready,
    /// It goes before those that become ready later.
    Due,
    /// It goes next: the stage v.
    Chosen,
}

/// The followers.
#[derive(Clone, Debug)]
pub(super) struct Follow {
    followers: Vec<(State, CachedQuery)>,
    /// Where the next query that follows goes.
    free: Option<usize>,
    chosen: Option<usize>,
    /// The query that is compared next: the stage w.
    next: Option<CachedQuery>,
}

impl Follow {
    pub(super) fn new(config: &Config) -> Self {
        Self { followers: vec![Default::default(); config.followers() as usize], free: None, chosen: None, next: None }
    }

    pub(super) const fn has_room(&self) -> bool {
        self.free.is_some()
    }

    /// The query that is compared next, if there is one.
    pub(super) const fn next(&self) -> Option<CachedQuery> {
        self.next
    }

    /// One clock edge; `enters` is a query with its leader, `leaves` whether the next one does.
    pub(super) fn clock(&mut self, enters: Option<(CachedQuery, usize)>, leaves: bool, finished: &[usize]) {
        let first = |state: State| self.followers.iter().position(|(other, _)| *other == state);
        let (free, due) = (first(State::Free), first(State::Due));
        if due.is_none() {
            for (state, _) in self.followers.iter_mut().filter(|(state, _)| *state == State::Ready) {
                *state = State::Due;
            }
        }
        let reads = self.next.is_none() || leaves;
        let chooses = self.chosen.is_none() || reads;
        if reads {
            self.next = self.chosen.map(|chosen| {
                self.followers[chosen].0 = State::Free;
                self.followers[chosen].1
            });
        }
        if chooses {
            self.chosen = due;
            due.into_iter().for_each(|due| self.followers[due].0 = State::Chosen);
        }
        if let Some((query, leader)) = enters {
            let place = &mut self.followers[self.free.expect("a query follows only if there is room")];
            assert_eq!(place.0, State::Free, "queries follow some cycles apart");
            *place = (State::WaitsFor(leader), query);
        }
        self.free = free;
        for (state, _) in &mut self.followers {
            if matches!(state, State::WaitsFor(leader) if finished.contains(leader)) {
                *state = State::Ready;
            }
        }
    }
}
