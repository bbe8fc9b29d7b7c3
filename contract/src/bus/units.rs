//! The units between a core and its buses at their ports, and the tops.

use super::axi::{PacketBusIn, PacketBusOut, ReadMaster, RegisterBus, Slave, SlaveBits, WriteMaster};
use super::config::{ADDRESS_BITS, BORDER_BYTES, BURST_BEATS_MAX, TREE_WORD_BITS};
use super::layout::Layout;
use super::packets::Packet;
use super::registers::{ErrorInputs, ErrorSources, RegisterMap, RegisterWrite, UniformBits, When};
use crate::record::{Domain, Visitor};
use crate::splat::config::MERGED_DEPTH_BITS;
use crate::splat::config::index_bits;
use crate::splat::records::UniformWrite;
use crate::{Field, Record, Visit, points, ports, record, search, splat};

/// What a unit for packets is made for.
#[derive(Debug)]
pub struct Packets<'a, R: Record> {
    /// What the record depends on.
    pub record: &'a R::Config,
    /// Bits of a beat.
    pub stream_bits: u32,
}

/// Gathers the beats of packets into records.
#[ports(unit: Packets<'_, R>)]
pub struct PacketIn<R: Packet> {
    /// A run begins.
    opens: Input<bool>,
    /// The packet that comes next is the run's last, where packets do not say so themselves.
    #[when(R::end(unit.record).is_none())]
    last: Input<bool>,
    /// Packets.
    #[port("s_axis")]
    #[with(&unit.stream_bits)]
    packets: PacketBusIn,
    /// The records of good packets.
    #[with(unit.record)]
    out: Out<R>,
    /// A packet was taken.
    taken: Output<bool>,
    /// A packet was refused.
    refused: Output<bool>,
}

/// Spreads records over the beats of packets.
#[ports(unit: Packets<'_, R>)]
pub struct PacketOut<R: Record> {
    /// Records.
    #[port("in")]
    #[with(unit.record)]
    input: In<R>,
    /// Their packets.
    #[port("m_axis")]
    #[with(&unit.stream_bits)]
    packets: PacketBusOut,
    /// A packet was sent.
    sent: Output<bool>,
    /// Nothing is on its way.
    idle: Output<bool>,
}

/// What a unit that writes records is made for.
#[derive(Debug)]
pub struct Writes<'a, R: Record> {
    /// What the record depends on.
    pub record: &'a R::Config,
    /// Bits of a beat.
    pub memory_bits: u32,
}

/// What a unit that reads records is made for.
#[derive(Debug)]
pub struct Reads<'a, R: Record> {
    /// What the record depends on.
    pub record: &'a R::Config,
    /// Bits of a beat.
    pub memory_bits: u32,
    /// The most records of a request.
    pub records_max: u32,
}

/// Records wanted.
#[record(records_max: u32)]
pub struct ReadRequest {
    /// Where the first one lies.
    #[bits(ADDRESS_BITS)]
    pub address: u32,
    /// How many.
    #[bits(index_bits(*records_max + 1))]
    pub records: u32,
}

/// Reads records from memory in bursts.
#[ports(unit: Reads<'_, R>)]
pub struct Reader<R: Record> {
    /// Records wanted.
    #[with(&unit.records_max)]
    request: In<ReadRequest>,
    /// Memory.
    #[port("m_axi")]
    #[with(&unit.memory_bits)]
    memory: ReadMaster,
    /// The records.
    #[with(unit.record)]
    record: Out<R>,
    /// An answer was none of success.
    error: Output<bool>,
    /// A burst ended whose last beat was not marked so, or another was; or a beat came that nobody asked for.
    misplaced: Output<bool>,
}

/// A record on its way to memory.
#[derive(Clone, Copy, Debug, Default)]
pub struct Addressed<R: Record> {
    /// Where it goes.
    pub address: <R::Domain as Domain>::Bits<u32>,
    /// What goes there.
    pub record: R,
}

impl<R: Record> Visit<R::Domain> for Addressed<R> {
    type Config = R::Config;

    fn visit(&mut self, config: &R::Config, visitor: &mut impl Visitor<R::Domain>) {
        visitor.bits::<u32>(&mut self.address);
        self.record.visit(config, visitor);
    }
}

impl<R: Record> Record for Addressed<R> {
    type Domain = R::Domain;
    type In<E: Domain> = Addressed<R::In<E>>;
    const DOC: &'static str = "A record on its way to memory.";

    fn describe(config: &R::Config, fields: &mut Vec<Field>) {
        fields.push(Field { doc: "Where the record goes.", ..Field::new("address", ADDRESS_BITS) });
        R::describe(config, fields);
    }
}

/// Writes records to memory, each in a burst.
#[ports(unit: Writes<'_, R>)]
pub struct Writer<R: Record> {
    /// Records.
    #[port("in")]
    #[with(unit.record)]
    input: In<Addressed<R>>,
    /// Memory.
    #[port("m_axi")]
    #[with(&unit.memory_bits)]
    memory: WriteMaster,
    /// An answer was none of success.
    error: Output<bool>,
    /// All that was taken is written.
    idle: Output<bool>,
}

/// A word that is written through the window.
#[record(index_bits: u32)]
pub struct WindowWrite {
    /// Its place.
    #[bits(*index_bits)]
    pub index: u32,
    /// The word.
    #[bits(TREE_WORD_BITS)]
    pub data: u64,
}

/// Takes bursts of words into a memory of `2^index_bits` words, and refuses all others.
#[ports(index_bits: u32)]
pub struct Window {
    /// Nothing may be written.
    locked: Input<bool>,
    /// The host.
    #[port("s_axi")]
    #[with(&window_bits(*index_bits))]
    host: Slave,
    /// Words written.
    write: PulseOut<WindowWrite>,
    /// A burst was refused for what it is.
    refused_burst: Output<bool>,
    /// A burst was refused because nothing may be written.
    refused_busy: Output<bool>,
    /// A burst is being written.
    occupied: Output<bool>,
}

/// Cycles of quiet in a row that end a run: more than what is handed over in one cycle takes to show on the other side of a queue.
pub const QUIET_CYCLES: u32 = 8;

/// Ends a run early: keeps the core in reset until nothing is under way.
#[ports(config: ())]
pub struct Abort {
    /// The run is to end.
    asked: Input<bool>,
    /// A run is under way.
    running: Input<bool>,
    /// Nothing is under way on the buses.
    quiet: Input<bool>,
    /// The core is to stay in reset, and what still comes to be dropped.
    aborts: Output<bool>,
    /// The run has ended.
    ended: Output<bool>,
}

/// Most frames that are under way in the renderer: one that leaves, one that is drawn, one that is set up.
pub const FRAMES_MAX: u32 = 3;

/// Begins frames one after the other, each with the uniforms that were written before its start.
#[ports(config: splat::Config)]
pub struct Frames {
    /// A frame is asked for.
    start: Input<bool>,
    /// Writes to uniforms; none comes while a start waits.
    write: PulseIn<UniformWrite>,
    /// The frame that began last is set up.
    set_up: Input<bool>,
    /// A frame has left.
    sent: Input<bool>,
    /// The uniforms of the frame that begins.
    uniform: PulseOut<UniformWrite>,
    /// Its uniforms are written, its splats may come.
    begun: Output<bool>,
    /// No frame is asked for or under way.
    idle: Output<bool>,
}

/// What the unit with the registers is made for.
#[derive(Debug)]
pub struct Registered<'a, M: RegisterMap> {
    /// What the map depends on.
    pub config: &'a M::Config,
    /// Where errors come from.
    pub sources: ErrorSources,
}

/// The registers of a core.
#[ports(unit: Registered<'_, M>)]
pub struct Registers<M: RegisterMap> {
    /// The host.
    #[port("s_axil")]
    #[with(&())]
    host: RegisterBus,
    /// The run has ended.
    finished: Input<bool>,
    /// No run may begin.
    occupied: Input<bool>,
    /// The frame of the start that waited has begun.
    #[when(M::STARTS == When::Ahead)]
    begun: Input<bool>,
    /// Errors from elsewhere.
    #[port("")]
    #[with(&unit.sources)]
    errors: Input<ErrorInputs>,
    /// A packet was taken.
    packet_taken: Input<bool>,
    /// A packet was sent.
    packet_sent: Input<bool>,
    /// What the core did in the last cycle.
    #[port("")]
    #[with(unit.config)]
    events: Input<M::Events>,
    /// A run is under way.
    busy: Output<bool>,
    /// A run begins.
    start: Output<bool>,
    /// The core is to be reset.
    core_reset: Output<bool>,
    /// The run is to end.
    aborts: Output<bool>,
    /// Interrupt.
    irq: Output<bool>,
    /// What the host has set.
    #[port("")]
    #[with(unit.config)]
    settings: Output<M::Settings>,
    /// Writes to the core's own registers.
    #[when(UniformBits::of(&M::registers(unit.config)).is_some())]
    #[with(&UniformBits::of(&M::registers(unit.config)).unwrap_or_default())]
    uniform: PulseOut<RegisterWrite>,
}

/// The renderer on AXI.
#[ports(config: splat::Config)]
pub struct SplatAxi {
    /// Registers.
    #[port("s_axil")]
    #[with(&())]
    registers: RegisterBus,
    /// Interrupt.
    irq: Output<bool>,
    /// Splats.
    #[port("s_axis_splat")]
    #[with(&config.bus.stream_bits)]
    splats: PacketBusIn,
    /// Fragments.
    #[port("m_axis_fragment")]
    #[with(&config.bus.stream_bits)]
    fragments: PacketBusOut,
    /// Memory with the reconstruction buffer.
    #[port("m_axi")]
    #[with(&config.bus.memory_bits)]
    reads: ReadMaster,
    /// The same memory.
    #[port("m_axi")]
    #[with(&config.bus.memory_bits)]
    writes: WriteMaster,
    /// Memory with the payloads of a rasterizer's splats.
    #[port("m_axi_payload")]
    #[count(config.payload_ports())]
    #[with(&config.bus.memory_bits)]
    payload_reads: [ReadMaster; 8],
    /// The same memory.
    #[port("m_axi_payload")]
    #[count(config.payload_ports())]
    #[with(&config.bus.memory_bits)]
    payload_writes: [WriteMaster; 8],
    /// Memory with depths that fragments of a stream are tested against, or a rasterizer's samples of what moves.
    #[port("m_axi_depth")]
    #[count(config.merge_ports())]
    #[with(&MERGED_DEPTH_BITS)]
    depth_reads: [ReadMaster; 8],
    /// The same memory.
    #[port("m_axi_depth")]
    #[count(config.depth_writers())]
    #[with(&MERGED_DEPTH_BITS)]
    depth_writes: [WriteMaster; 4],
}

/// The search core on AXI.
#[ports(config: search::Config)]
pub struct SearchAxi {
    /// Registers.
    #[port("s_axil")]
    #[with(&())]
    registers: RegisterBus,
    /// Interrupt.
    irq: Output<bool>,
    /// Queries.
    #[port("s_axis_query")]
    #[with(&config.bus.stream_bits)]
    queries: PacketBusIn,
    /// Results.
    #[port("m_axis_result")]
    #[with(&config.bus.stream_bits)]
    results: PacketBusOut,
    /// Memory with the points.
    #[port("m_axi")]
    #[with(&config.bus.memory_bits)]
    points: ReadMaster,
    /// Window to the tree.
    #[port("s_axi")]
    #[when(config.tree_cache == 0)]
    #[with(&window_bits(window_index_bits(config)))]
    window: Slave,
    /// Memory with the tree.
    #[port("m_axi_tree")]
    #[when(config.tree_cache > 0)]
    #[with(&config.bus.memory_bits)]
    tree: ReadMaster,
}

/// The point processor on AXI.
#[ports(config: points::Config)]
pub struct PointsAxi {
    /// Registers.
    #[port("s_axil")]
    #[with(&())]
    registers: RegisterBus,
    /// Interrupt.
    irq: Output<bool>,
    /// Queries.
    #[port("s_axis_query")]
    #[with(&config.search.bus.stream_bits)]
    queries: PacketBusIn,
    /// Results.
    #[port("m_axis_result")]
    #[with(&config.search.bus.stream_bits)]
    results: PacketBusOut,
    /// Memory with the positions, as the search reads them.
    #[port("m_axi")]
    #[with(&config.search.bus.memory_bits)]
    points: ReadMaster,
    /// Window to the tree.
    #[port("s_axi")]
    #[when(config.search.tree_cache == 0)]
    #[with(&window_bits(window_index_bits(&config.search)))]
    window: Slave,
    /// Memory with the tree.
    #[port("m_axi_tree")]
    #[when(config.search.tree_cache > 0)]
    #[with(&config.search.bus.memory_bits)]
    tree: ReadMaster,
    /// Memory with the points, as the program reads them.
    #[port("m_axi_line")]
    #[with(&config.search.bus.memory_bits)]
    lines: ReadMaster,
}

/// Bits of the index of a core's window: nodes in its lower half, leaves in its upper one.
#[must_use]
pub const fn window_index_bits(config: &search::Config) -> u32 {
    config.node_bits()
}

/// Widths of the bus to a window of `2^index_bits` words: its addresses end with it, or with the range that AXI gives any slave.
#[must_use]
pub const fn window_bits(index_bits: u32) -> SlaveBits {
    let words = index_bits + (TREE_WORD_BITS / 8).ilog2();
    let range = BORDER_BYTES.ilog2();
    SlaveBits { address: if words > range { words } else { range }, beat: TREE_WORD_BITS }
}

/// The most records that the search core asks of its memory at a time.
#[must_use]
pub const fn beats_max(config: &search::Config) -> u32 {
    config.bucket.div_ceil(config.lanes)
}

/// Records between two places where a burst must end.
#[must_use]
pub fn chunk_records<R: Record>(config: &R::Config, memory_bits: u32) -> u32 {
    let beat = memory_bits / 8;
    BORDER_BYTES.min(BURST_BEATS_MAX * beat) / Layout::record::<R>(config).stride(memory_bits)
}
