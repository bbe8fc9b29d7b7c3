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
    /// Where one went in the last cycle, and the leaders that finished in it.
    entered: Option<usize>,
    finished: Vec<usize>,
    chosen: Option<usize>,
    /// The query that is compared next: the stage w.
    next: Option<CachedQuery>,
}

impl Follow {
    pub(super) fn new(config: &Config) -> Self {
        let followers = vec![Default::default(); config.followers() as usize];
        Self { followers, free: None, entered: None, finished: vec![], chosen: None, next: None }
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
        let missed = self.entered.take().map(|entered| (entered, self.finished.as_slice()));
        for (follower, (state, _)) in self.followers.iter_mut().enumerate() {
            let late = missed.filter(|(entered, _)| *entered == follower).map_or(&[][..], |(_, finished)| finished);
            if matches!(state, State::WaitsFor(leader) if finished.contains(leader) || late.contains(leader)) {
                *state = State::Ready;
            }
        }
        if let Some((query, leader)) = enters {
            let free = self.free.expect("a query follows only if there is room");
            assert_eq!(self.followers[free].0, State::Free, "queries follow some cycles apart");
            self.followers[free] = (State::WaitsFor(leader), query);
            self.entered = Some(free);
        }
        self.finished = finished.to_vec();
        self.free = free;
    }
}
