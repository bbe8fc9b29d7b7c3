//! Gathering (thesis 6.5.4): makes points with attributes of the indices that a search found, through lines that it keeps.
//!
//! What is wanted is looked up ahead of its use: a line that is missing is asked for at once, and the neighbor waits in a
//! queue for its turn, as those before and behind it do. A line takes its slot when all that was wanted of the slot's
//! former line has been read.

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::process::Config;
use pointcore_contract::process::config::WORDS_MAX;
use pointcore_contract::process::records::{Gather, Gathered, LineFetch, Neighbor, NeighborPlace};
pub use pointcore_contract::process::units::gatherer::{In, Out};
use pointcore_contract::process::units::{GatherEvents, LINES_UNDER_WAY, NEIGHBORS_UNDER_WAY};

/// Counts are kept modulo this: those of neighbors long gone may seem to be of some under way.
const COUNTED: u64 = 4 * NEIGHBORS_UNDER_WAY as u64;

/// A line's place.
#[derive(Clone, Debug, Default)]
struct Slot {
    /// The line that was wanted last.
    line: Option<u32>,
    /// How many neighbors had been wanted when one of it was, that one included.
    wanted: u64,
}

/// A neighbor that waits for its turn.
#[derive(Clone, Copy, Debug)]
struct Pending {
    place: NeighborPlace,
    point: usize,
    missed: bool,
}

/// A line that was asked for.
#[derive(Clone, Copy, Debug)]
struct Missed {
    slot: usize,
    /// It may be kept when so many neighbors have been read.
    after: u64,
}

/// The gathering.
#[derive(Clone, Debug)]
pub struct Gatherer {
    line_points: u32,
    words: usize,
    slots: Vec<Slot>,
    points: Vec<[u32; WORDS_MAX]>,
    /// The slot that is emptied next, after reset and when everything is forgotten.
    clearing: Option<usize>,
    gather: Skid<Gather>,
    fill: Skid<Neighbor>,
    /// The stages l and k.
    looked_up: Option<Gather>,
    known: Option<Gather>,
    /// Neighbors that have been wanted, and those of them that have been read.
    wanted: u64,
    read: u64,
    /// Those that had been read before this cycle.
    read_before: u64,
    pending: Fifo<Pending>,
    missed: Fifo<Missed>,
    /// The line that comes, and how many of its points are there.
    filling: Option<(usize, usize)>,
    /// Lines that are complete and that no neighbor has been read of.
    complete: u32,
    /// The stages r and s.
    reads: Option<Gathered>,
    shows: Option<Gathered>,
    fetch: Skid<LineFetch>,
    gathered: Skid<Gathered>,
    events: GatherEvents,
}

impl Gatherer {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let lines = config.cache_lines as usize;
        Self {
            line_points: config.line_points,
            words: config.program.neighbor.len(),
            slots: vec![Slot::default(); lines],
            points: vec![[0; WORDS_MAX]; lines * config.line_points as usize],
            clearing: Some(0),
            gather: Skid::default(),
            fill: Skid::default(),
            looked_up: None,
            known: None,
            wanted: 0,
            read: 0,
            read_before: 0,
            pending: Fifo::new(NEIGHBORS_UNDER_WAY as usize),
            missed: Fifo::new(LINES_UNDER_WAY as usize),
            filling: None,
            complete: 0,
            reads: None,
            shows: None,
            fetch: Skid::default(),
            gathered: Skid::default(),
            events: GatherEvents::default(),
        }
    }

    /// The stage k: the neighbor joins those that wait; returns it with the line to be asked for, if there is room.
    fn judge(&mut self) -> Option<(Pending, Option<(Missed, LineFetch)>)> {
        let Gather { place, index } = self.known?;
        let line = index / self.line_points;
        let slot = line as usize % self.slots.len();
        let is_hit = place.none || self.slots[slot].line == Some(line);
        let has_room = self.pending.in_ready() && (is_hit || (self.fetch.in_ready() && self.missed.in_ready()));
        if !has_room {
            return None;
        }
        self.known = None;
        let point = slot * self.line_points as usize + (index % self.line_points) as usize;
        let pending = Pending { place, point, missed: !is_hit };
        // What was wanted of the former line, if anything of it is still to be read.
        let since = (self.wanted - self.slots[slot].wanted) % COUNTED;
        let waits = self.slots[slot].line.is_some() && since < self.wanted - self.read_before;
        let after = if waits { self.wanted - since } else { self.read_before };
        self.wanted += 1;
        if !place.none {
            self.slots[slot] = Slot { line: Some(line), wanted: self.wanted };
        }
        Some((pending, (!is_hit).then_some((Missed { slot, after }, LineFetch { line }))))
    }

    /// Takes a point of a line that comes; returns whether one is taken.
    fn fill(&mut self, neighbor: Option<Neighbor>) -> bool {
        let Some((slot, count)) = &mut self.filling else { return false };
        let Some(neighbor) = neighbor else { return true };
        self.points[*slot * self.line_points as usize + *count] = neighbor.words;
        *count += 1;
        if *count == self.line_points as usize {
            self.filling = None;
            self.complete += 1;
        }
        true
    }

    /// Reads the neighbor whose turn it is, if its line is there.
    fn read(&mut self, complete: bool) -> Option<Gathered> {
        let Pending { place, point, missed } = *self.pending.out().filter(|pending| !pending.missed || complete)?;
        self.complete -= u32::from(missed);
        self.read += 1;
        let mut words = if place.none { [0; WORDS_MAX] } else { self.points[point] };
        words[self.words..].fill(0);
        Some(Gathered { place, neighbor: Neighbor { words } })
    }
}

impl Model for Gatherer {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            gather_ready: self.gather.in_ready(),
            gathered: self.gathered.out().copied(),
            fetch: self.fetch.out().copied(),
            fill_ready: self.fill.in_ready(),
            events: self.events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let was_clearing = self.clearing;
        self.read_before = self.read;
        // Neighbors leave.
        let is_complete = self.complete > 0;
        let shows_advance = self.shows.is_none() || self.gathered.in_ready();
        let shown = if shows_advance { self.shows.take() } else { None };
        let reads_advance = self.reads.is_none() || shows_advance;
        if shows_advance {
            self.shows = self.reads.take();
        }
        if reads_advance {
            self.reads = self.read(is_complete);
        }
        let pops = self.read > self.read_before;

        // A line comes.
        let takes_fill = self.fill(self.fill.out().copied());
        let next_line = self.missed.out().copied().filter(|missed| missed.after <= self.read_before);
        let takes_line = self.filling.is_none();
        if takes_line {
            self.filling = next_line.map(|missed| (missed.slot, 0));
        }

        // Neighbors are looked up.
        let judged = self.judge();
        self.events = GatherEvents::default();
        if let Some((Pending { place, .. }, missed)) = judged {
            self.events = GatherEvents { hit: missed.is_none() && !place.none, miss: missed.is_some() };
        }
        if self.known.is_none() {
            self.known = self.looked_up.take();
        }
        let takes_gather = self.looked_up.is_none() && was_clearing.is_none();
        if takes_gather {
            self.looked_up = self.gather.out().copied();
        }
        let missed = judged.and_then(|(_, missed)| missed);
        self.pending.step(judged.map(|(pending, _)| pending), pops);
        self.missed.step(missed.map(|(missed, _)| missed), takes_line && next_line.is_some());
        self.fetch.step(missed.map(|(_, fetch)| fetch), inputs.fetch_ready);
        self.gather.step(inputs.gather, takes_gather);
        self.fill.step(inputs.fill, takes_fill);
        self.gathered.step(shown, inputs.gathered_ready);

        if let Some(slot) = was_clearing {
            self.slots[slot] = Slot::default();
            self.clearing = Some(slot + 1).filter(|next| *next < self.slots.len());
        }
        if inputs.forget {
            self.clearing = Some(0);
        }
    }
}
