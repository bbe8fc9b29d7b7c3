//! What a search has in memory, or behind a window: its points and its tree. The search core and the point processor share it.

use pointcore_contract::bus::axi::{ReadMaster, Slave};
use pointcore_contract::bus::config::{READS_MAX, TREE_WORD_BITS};
use pointcore_contract::bus::units::{self, ReadRequest, WindowWrite};
use pointcore_contract::bus::{Layout, packets};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Beat, BeatPlace, Fetch, Lookup, Points, TreeRecord, TreeWrite};
use pointcore_contract::unit::{In, Out, PulseIn};
use pointcore_contract::{Record, record};

use super::wiring::{Abort, feed, place};
use crate::bus::{reader, window};
use crate::stream::fifo;
use crate::units::passage::Passage;
use crate::units::ports::{Flow, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, export};
use crate::units::wires::{Bundle, Wired, layout};
use rtl::{Expr, Instance, Module, bit, lit};

/// Requests to memory that may await their answer: as many as `threads` may have, of which each may have `each`.
fn requests(threads: u32, each: u32) -> u32 {
    (threads * each).clamp(2, READS_MAX)
}

const POINTS: units::reader::Ports<Points> = units::reader::Ports::ALL;
const TREE: units::reader::Ports<TreeWord> = units::reader::Ports::ALL;
const WINDOW: units::window::Ports = units::window::Ports::ALL;

/// A word of the tree as it lies in the window and in memory.
#[record(config: Config)]
struct TreeWord {
    /// What a node or a leaf holds.
    #[bits(TREE_WORD_BITS)]
    word: u64,
}

/// A record that lies in a word of the tree.
fn in_word<B: Bundle>(config: &B::Config, word: Expr) -> B {
    let layout = Layout::record::<B>(config);
    B::from_values(config, layout.places.iter().map(|place| word.bits((place.bit() + place.width) - 1, place.bit())))
}

/// A search: its core, the core's ports, those of the bus, and what the registers say.
#[derive(Clone, Copy)]
pub(super) struct Search<'a> {
    pub config: &'a Config,
    pub core: Instance,
    pub tree: PulseIn<TreeWrite>,
    pub lookup: Out<Lookup>,
    pub record: In<TreeRecord>,
    pub fetch: Out<Fetch>,
    pub beat: In<Beat>,
    /// Memory with the points.
    pub points_bus: ReadMaster,
    /// Window to the tree, or memory with it.
    pub window_bus: Slave,
    pub tree_bus: ReadMaster,
    pub points_base: Expr,
    /// Where the tree lies in memory.
    pub tree_base: Expr,
    /// A run is under way.
    pub busy: Expr,
    pub abort: Abort,
}

/// What the other parts hear of the points.
pub(super) struct PointSignals {
    /// A leaf without beats is read: as one of one beat.
    pub empty: Expr,
    /// A burst is misshapen.
    pub misplaced: Expr,
    /// Memory answers with an error.
    pub error: Expr,
    /// None are awaited.
    pub idle: Expr,
}

/// What the other parts hear of the tree.
pub(super) struct TreeSignals {
    /// The tree is written while a run is under way, where it can be written.
    pub busy: Option<Expr>,
    /// A burst is refused or misshapen.
    pub burst: Expr,
    /// Memory answers with an error, where the tree lies in memory.
    pub memory: Option<Expr>,
    /// It is being written: no run may begin.
    pub occupied: Expr,
    /// Nothing of it is awaited.
    pub idle: Expr,
}

impl Search<'_> {
    /// Reads points.
    pub fn points(self, m: &mut Module) -> PointSignals {
        let Self { config, core, abort, .. } = self;
        let bits = config.bus.memory_bits;
        let most = units::beats_max(config);
        let requests = requests(config.threads, config.leaves_in_flight);
        let reads = m.instance("points", reader::limited::<Points>(config, bits, most, requests));
        export(m, &bits, (reads, POINTS.memory), self.points_bus);
        let mut fetch = self.fetch.of(m, config, core);
        let is_empty = m.wire("is_empty", fetch.record.beats.is_zero());
        let empty = m.reg_reset("empty_leaf", 1, 0);
        m.next(empty, fetch.transfer() & is_empty);
        fetch.record.beats = m.wire("beats", fetch.record.beats | is_empty.zext(config.beats_bits()));
        let stride_bits = Layout::record::<Points>(config).stride(bits).ilog2();
        let address = m.wire("points_address", place(self.points_base, fetch.record.address, stride_bits));
        let asked = Asked { name: "fetches", requests, address, records: fetch.record.beats, records_max: most };
        let head = asked.remembered::<Fetch>(m, config, fetch, (reads, POINTS.request));

        let record = POINTS.record.of(m, config, reads);
        let place_bits = config.beats_bits();
        let place = m.reg_reset("beat", place_bits, 0);
        let last = m.wire("last_beat", place.add_lit(1).eq(head.record.beats));
        let gives = m.wire("gives_beat", record.valid & head.valid);
        let address = head.record.address + place.resize(config.beat_bits());
        let beat = Beat { place: BeatPlace { thread: head.record.thread, address, last }, points: record.record };
        let taken = self.beat.offer(m, config, core, gives, beat) | abort.drops;
        m.drive(record.ready, taken & head.valid);
        let moves = m.wire("beat_moves", gives & taken);
        m.drive(head.ready, moves & last);
        m.next_if(place, moves, last.mux(lit(place_bits, 0), place.add_lit(1)));
        let [misplaced, error] = [POINTS.misplaced, POINTS.error].map(|port| port.word_of(m, reads));
        PointSignals { empty: empty.expr(), misplaced, error, idle: !head.valid }
    }

    /// Leads the tree to the core.
    pub fn tree(self, m: &mut Module) -> TreeSignals {
        if self.config.tree_cache == 0 { self.tree_window(m) } else { self.tree_memory(m) }
    }

    /// Lets the host write the tree.
    fn tree_window(self, m: &mut Module) -> TreeSignals {
        let Self { config, core, .. } = self;
        let index_bits = units::window_index_bits(config);
        let window = m.instance("tree", window::module(index_bits));
        export(m, &units::window_bits(index_bits), (window, WINDOW.host), self.window_bus);
        let Pulse { valid, record: WindowWrite { index, data: word } } = WINDOW.write.of(m, &index_bits, window);
        let (node, bucket) = (in_word(config, word), in_word(config, word));
        let record = TreeWrite { is_leaf: index.msb(), address: index.trunc(config.tree_depth), node, bucket };
        self.tree.feed(m, config, core, Pulse { valid, record });
        WINDOW.locked.feed_word(m, window, self.busy);
        let occupied = WINDOW.occupied.word_of(m, window);
        let [refused_busy, burst] = [WINDOW.refused_busy, WINDOW.refused_burst].map(|port| port.word_of(m, window));
        TreeSignals { busy: Some(refused_busy), burst, memory: None, occupied, idle: bit(true) }
    }

    /// Reads the tree.
    fn tree_memory(self, m: &mut Module) -> TreeSignals {
        let Self { config, core, abort, .. } = self;
        let bits = config.bus.memory_bits;
        let requests = requests(config.threads, 1);
        let reads = m.instance("tree", reader::limited::<TreeWord>(config, bits, 1, requests));
        export(m, &bits, (reads, TREE.memory), self.tree_bus);
        let lookup = self.lookup.of(m, config, core);
        let stride_bits = packets::tree_stride(config, bits).ilog2();
        let address = m.wire("tree_address", place(self.tree_base, lookup.record.address, stride_bits));
        let asked = Asked { name: "lookups", requests, address, records: bit(true), records_max: 1 };
        let head = asked.remembered::<Lookup>(m, config, lookup, (reads, TREE.request));

        let record = TREE.record.of(m, config, reads);
        let gives = m.wire("gives_record", record.valid & head.valid);
        let TreeWord { word } = record.record;
        let (node, bucket) = (in_word(config, word), in_word(config, word));
        let answer = TreeRecord { lookup: head.record, node, bucket };
        let taken = self.record.offer(m, config, core, gives, answer) | abort.drops;
        m.drive(record.ready, taken & head.valid);
        m.drive(head.ready, taken & record.valid);
        let [burst, error] = [TREE.misplaced, TREE.error].map(|port| port.word_of(m, reads));
        TreeSignals { busy: None, burst, memory: Some(error), occupied: bit(false), idle: !head.valid }
    }
}

/// A request of the core's to memory.
struct Asked {
    name: &'static str,
    /// How many may await their answer.
    requests: u32,
    address: Expr,
    records: Expr,
    records_max: u32,
}

impl Asked {
    /// Hands the request to a reader and remembers whose it is; returns the oldest that is not answered.
    fn remembered<R: Record>(
        self,
        m: &mut Module,
        config: &R::Config,
        stream: Flow<Wired<R>>,
        (reads, port): (Instance, In<ReadRequest>),
    ) -> Flow<Wired<R>> {
        let queue = Passage::<R>::place(m, self.name, fifo(self.requests, &layout::<R>(config)));
        let room = queue.room(m);
        let reader_ready = port.room(m, reads);
        queue.push(m, config, stream.valid & reader_ready, stream.record);
        let request = ReadRequest { address: self.address, records: self.records };
        feed(m, &self.records_max, (stream.valid, stream.ready), (reads, port), room, request);
        queue.out(m, config)
    }
}
