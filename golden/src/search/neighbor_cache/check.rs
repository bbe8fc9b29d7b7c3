//! Coherence check: compares a query with one entry after the other (thesis 6.6.3).

use super::coverage::Reference;
use super::entries::Entries;
use super::lead::Asked;
use crate::datapath::{Datapath, Token};
use crate::stream::Skid;
use pointcore_contract::Format;
use pointcore_contract::search::records::{CacheSetup, CachedQuery};
use std::collections::VecDeque;

/// Queries that are being checked.
const CHECKS: usize = 8;

/// An entry to be judged, and its state when it was read.
#[derive(Clone, Copy, Debug)]
struct Item {
    entry: usize,
    last: bool,
    present: bool,
    version: u8,
}

/// A query with the entry that was read for it.
#[derive(Clone, Copy, Debug)]
struct Issued {
    item: Item,
    query: CachedQuery,
    reference: Reference,
}

#[derive(Clone, Copy, Debug)]
struct Compared {
    item: Item,
    margin: u32,
    covered: bool,
}

/// A comparison whose consequences are drawn.
#[derive(Clone, Copy, Debug)]
struct Judged {
    entry: usize,
    last: bool,
    margin: u32,
    /// The entry was still what it had been when it was read.
    reusable: bool,
    /// Besides, it covers the query.
    matches: bool,
}

impl Compared {
    fn judge(self, entries: &Entries) -> Judged {
        let Self { item: Item { entry, last, present, version }, margin, covered } = self;
        let now = entries.get(entry);
        let reusable = present && now.present && now.version == version;
        Judged { entry, last, margin, reusable, matches: covered && reusable }
    }
}

/// What comes of an item.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict {
    /// The entry answers the query.
    Hit { entry: usize, asked: Asked },
    /// No entry does.
    Miss { asked: Asked },
    /// Nothing yet, or the query was answered before.
    Pass,
}

/// The coherence check.
#[derive(Clone, Debug)]
pub(super) struct Check {
    geometry: Format,
    queries: Skid<Asked>,
    /// The entry that the next item is about.
    next: usize,
    /// What is asked by the items under way.
    asked: VecDeque<Asked>,
    issued: Option<Issued>,
    datapath: Datapath<Compared>,
    judged: Option<Judged>,
    /// An item of the oldest query was a hit.
    answered: bool,
}

impl Check {
    pub(super) fn new(geometry: Format, latency: u32) -> Self {
        Self {
            geometry,
            queries: Skid::default(),
            next: 0,
            asked: VecDeque::with_capacity(CHECKS),
            issued: None,
            datapath: Datapath::new(latency, 1),
            judged: None,
            answered: false,
        }
    }

    pub(super) fn in_ready(&self) -> bool {
        self.queries.in_ready()
    }

    /// What comes of the item that is judged, if there is one, while `copying` is copied to.
    pub(super) fn verdict(&self, copying: Option<usize>) -> Option<Verdict> {
        let Judged { entry, last, matches, .. } = self.judged?;
        let asked = *self.asked.front().expect("a query stays until its last item leaves");
        Some(if self.answered {
            Verdict::Pass
        } else if matches && copying != Some(entry) {
            Verdict::Hit { entry, asked }
        } else if last {
            Verdict::Miss { asked }
        } else {
            Verdict::Pass
        })
    }

    /// What the item that is judged tells of the margins of neighborhoods, as it leaves.
    pub(super) fn margin(&self) -> Option<u32> {
        self.judged.filter(|judged| judged.reusable).map(|judged| judged.margin)
    }

    /// Queries that are being compared.
    pub(super) fn compared(&self) -> usize {
        self.asked.len()
    }

    /// One clock edge; `leaves` is the verdict on the item that leaves in this cycle, `copying` the entry that is copied to,
    /// `admits` whether one more query may be compared.
    pub(super) fn clock(
        &mut self,
        input: Option<Asked>,
        leaves: Option<Verdict>,
        copying: Option<usize>,
        admits: bool,
        entries: &Entries,
        setup: &CacheSetup,
    ) {
        let has_room = self.next != 0 || (self.asked.len() < CHECKS && admits);
        let enters = self.datapath.in_ready();
        let advances = self.issued.is_none() || enters;
        let compared = self.issued.filter(|_| enters).map(|Issued { item, query, reference }| {
            let (margin, covered) = reference.covers(self.geometry, &query, setup);
            Compared { item, margin, covered }
        });
        let takes_judged = self.judged.is_none() || leaves.is_some();
        let left = self.datapath.step(compared.map(Token::Kept), takes_judged);
        if leaves.is_some() {
            self.answered |= matches!(leaves, Some(Verdict::Hit { .. }));
            if self.judged.is_some_and(|judged| judged.last) {
                self.asked.pop_front();
                self.answered = false;
            }
        }
        if takes_judged {
            self.judged = left.map(|compared| compared.judge(entries));
        } else if let Some(judged) = &mut self.judged {
            judged.matches &= copying != Some(judged.entry);
        }

        let mut takes_query = false;
        if advances {
            self.issued = self.queries.out().copied().filter(|_| has_room).map(|asked| self.issue(asked, entries));
            takes_query = self.issued.is_some_and(|issued| issued.item.last);
        }
        self.queries.step(input, takes_query);
    }

    fn issue(&mut self, asked: Asked, entries: &Entries) -> Issued {
        let entry = self.next;
        let last = entry + 1 == entries.len();
        if entry == 0 {
            self.asked.push_back(asked);
        }
        self.next = if last { 0 } else { entry + 1 };
        let state = entries.get(entry);
        let item = Item { entry, last, present: state.present, version: state.version };
        Issued { item, query: asked.query, reference: state.reference }
    }
}
