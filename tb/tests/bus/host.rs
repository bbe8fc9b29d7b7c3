//! A host with memory around a core on AXI: registers, packets, bursts, all of them stalling.

use std::collections::VecDeque;

use pointcore::splat::depth_memory::DEPTH_BYTES;
use pointcore_contract::bus::axi::{
    BurstAddress, PacketBusIn, PacketBusOut, ReadMaster, RegisterBus, Slave, SlaveBits, WriteBeat, WriteMaster,
};
use pointcore_contract::bus::config::{ADDRESS_BITS, BORDER_BYTES, ID_BITS, TREE_WORD_BITS};
use pointcore_contract::bus::packets::Packet;
use pointcore_contract::bus::registers::{Access, CONTROL, ERRORS, RegisterMap, STATUS, SplatRegisters};
use pointcore_contract::bus::units::splat_axi;
use pointcore_contract::bus::{Config, Layout, Register};
use pointcore_contract::splat;
use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, TILE_PIXELS};
use pointcore_contract::splat::records::{Pixel, payload_bytes};
use pointcore_contract::{self as contract, Words, read};
use pointcore_golden::bus::{PacketIn, PacketOut, Verdict};
use rtl::Module;

use super::{Bench, Carrier, Drain, Feed, bytes, stalls, words};

/// Answers of a slave.
const OKAY: u64 = 0;
const SLAVE_ERROR: u64 = 2;
/// How the address of a burst goes on: up.
const UP: u8 = 1;
/// Bits of `control`.
pub const START: u32 = 1;
pub const RESET: u32 = 2;
const ABORT: u32 = 8;
/// Cycles that an answer takes at most, and a run.
const ANSWER_CYCLES: u64 = 20_000;
const RUN_CYCLES: u64 = 3_000_000;

/// Where in memory a burst of a memory port begins, and how many bytes it has; `origin` is the memory's first address.
fn extent(burst: &BurstAddress, origin: u32, beat_bytes: usize) -> (usize, usize) {
    let length = (usize::from(burst.length) + 1) * beat_bytes;
    let end = burst.address + (length - 1) as u32;
    assert_eq!((burst.burst, 1 << burst.size), (UP, beat_bytes), "{burst:x?}");
    assert_eq!(burst.address as usize % beat_bytes, 0, "{burst:x?}");
    assert_eq!(burst.address / BORDER_BYTES, end / BORDER_BYTES, "{burst:x?} goes over a border");
    ((burst.address - origin) as usize, length)
}

/// Whether a slave's answer says that all is well.
fn is_accepted(response: u64) -> bool {
    assert!([OKAY, SLAVE_ERROR].contains(&response), "an answer of {response}");
    response == OKAY
}

/// A memory port's read half, and where it reads.
struct Reads {
    address: Drain,
    data: Feed,
    beat_bytes: usize,
}

impl Reads {
    fn new(bench: &Bench, (bus, bits): (ReadMaster, u32), random: &mut fastrand::Rng) -> Self {
        let address = Drain::new(bench, bus.address, &ADDRESS_BITS, stalls(random));
        let pattern = stalls(random);
        let data = Feed::new(bench, bus.data, &bits, random, pattern);
        Self { address, data, beat_bytes: bits as usize / 8 }
    }

    fn step(&mut self, bench: &Bench, origin: u32, memory: &[u8]) {
        self.data.taken(bench);
        let Some(burst) = self.address.taken(bench) else { return };
        let burst: BurstAddress = read(&ADDRESS_BITS, &burst);
        let (place, length) = extent(&burst, origin, self.beat_bytes);
        let beats = memory[place..place + length].chunks(self.beat_bytes);
        let last = beats.len() - 1;
        self.data.items.extend(beats.enumerate().map(|(beat, bytes)| {
            let end = [OKAY, u64::from(beat == last)];
            std::iter::once(burst.id.into()).chain(words(bytes)).chain(end).collect()
        }));
    }
}

/// A memory port's write half.
struct Writes {
    address: Drain,
    data: Drain,
    answer: Feed,
    /// Bursts that lack data, and data that lack a burst.
    bursts: VecDeque<(usize, usize)>,
    packets: VecDeque<Vec<u8>>,
    gathered: Vec<u8>,
    beat_bytes: usize,
}

impl Writes {
    fn new(bench: &Bench, (bus, bits): (WriteMaster, u32), random: &mut fastrand::Rng) -> Self {
        let address = Drain::new(bench, bus.address, &ADDRESS_BITS, stalls(random));
        let data = Drain::new(bench, bus.data, &bits, stalls(random));
        let pattern = stalls(random);
        let answer = Feed::new(bench, bus.answer, &(), random, pattern);
        let (bursts, packets, gathered) = (VecDeque::new(), VecDeque::new(), vec![]);
        Self { address, data, answer, bursts, packets, gathered, beat_bytes: bits as usize / 8 }
    }

    fn step(&mut self, bench: &Bench, origin: u32, memory: &mut [u8]) {
        self.answer.taken(bench);
        let extent = |burst: Vec<u64>| extent(&read(&ADDRESS_BITS, &burst), origin, self.beat_bytes);
        self.bursts.extend(self.address.taken(bench).map(extent));
        if let Some(beat) = self.data.taken(bench) {
            let &[.., strobes, last] = &beat[..] else { panic!("a beat has strobes") };
            assert_eq!(strobes.count_ones() as usize, self.beat_bytes, "all of a beat is written");
            self.gathered.extend(bytes(&beat, self.beat_bytes));
            if last == 1 {
                self.packets.push_back(std::mem::take(&mut self.gathered));
            }
        }
        if !self.bursts.is_empty() && !self.packets.is_empty() {
            let ((place, length), packet) = (self.bursts.pop_front().unwrap(), self.packets.pop_front().unwrap());
            assert_eq!(packet.len(), length, "a burst has its beats");
            memory[place..place + length].copy_from_slice(&packet);
            self.answer.items.push_back(vec![0, OKAY]);
        }
    }
}

/// The host.
pub struct Host<I: Packet, O: Packet> {
    bench: Bench,
    widths: Config,
    map: Vec<Register>,
    register_write: (Feed, Feed, Drain),
    register_read: (Feed, Drain),
    packets_in: Feed,
    config: I::Config,
    sender: PacketOut<I>,
    packets_out: Drain,
    receiver: PacketIn<O>,
    /// Beats of the packet that comes, and how it is to look.
    arriving: Vec<(Vec<u8>, bool)>,
    mirror: PacketOut<O>,
    reads: Vec<Reads>,
    writes: Vec<Writes>,
    window: Option<(Feed, Feed, Drain)>,
    memory_order: MemoryOrder,
    /// Bytes behind all memory ports, and the address of the first.
    pub memory: Vec<u8>,
    origin: u32,
    /// Packets that came.
    pub received: Vec<O>,
    /// No packet is taken.
    pub is_held: bool,
}

/// What feeds a carrier, with a pattern of stalls of its own.
fn feed<C: Carrier>(bench: &Bench, carrier: C, config: &C::Config, random: &mut fastrand::Rng) -> Feed {
    let pattern = stalls(random);
    Feed::new(bench, carrier, config, random, pattern)
}

/// What a top has around it.
pub struct Around {
    /// Its registers.
    pub map: Vec<Register>,
    /// Where they are reached.
    pub registers: RegisterBus,
    /// Its streams of packets.
    pub packets: (PacketBusIn, PacketBusOut),
    /// Its memory ports that read, and bits of their beats.
    pub reads: Vec<(ReadMaster, u32)>,
    /// Its memory ports that write, likewise.
    pub writes: Vec<(WriteMaster, u32)>,
    /// Its window for the tree, and how wide that is.
    pub window: Option<(Slave, SlaveBits)>,
    /// Bytes of memory.
    pub memory: usize,
    /// What the memory does first.
    pub memory_order: MemoryOrder,
}

/// Where the renderer's records lie, from where memory begins on.
#[derive(Clone, Copy)]
pub struct Bases {
    /// Its reconstruction buffer.
    pub buffer: u32,
    /// Its payloads.
    pub payloads: u32,
    /// The depths that its fragments, or samples of what moves, are tested against.
    pub depths: u32,
}

/// What the renderer has around it, its buffer at an address, and where all else lies behind that.
pub fn around_renderer(config: &splat::Config, buffer_base: u32, memory_order: MemoryOrder) -> (Around, Bases) {
    const TOP: splat_axi::Ports = splat_axi::Ports::ALL;
    let bits = config.bus.memory_bits;
    let tile_bytes = TILE_PIXELS * Layout::record::<Pixel>(config).stride(bits);
    let payload_base = (buffer_base + config.buffer_tiles() as u32 * tile_bytes).next_multiple_of(BORDER_BYTES);
    let payload_bytes = config.payload_ports() * payload_bytes(config, bits);
    let depth_base = (payload_base + payload_bytes).next_multiple_of(BORDER_BYTES);
    let depth_bytes = (TILE_PIXELS * DEPTH_BYTES) << config.image_tile_bits();
    let ports = [config.payload_ports(), config.merge_ports(), config.depth_writers()];
    let [payloads, depths, depth_writers] = ports.map(|ports| ports as usize);
    let reads = |buses: &[ReadMaster], bits: u32| buses.iter().map(|&bus| (bus, bits)).collect::<Vec<_>>();
    let writes = |buses: &[WriteMaster], bits: u32| buses.iter().map(|&bus| (bus, bits)).collect::<Vec<_>>();
    let around = Around {
        map: SplatRegisters::registers(config),
        registers: TOP.registers,
        packets: (TOP.splats, TOP.fragments),
        reads: [
            reads(&[TOP.reads], bits),
            reads(&TOP.payload_reads[..payloads], bits),
            reads(&TOP.depth_reads[..depths], MERGED_DEPTH_BITS),
        ]
        .concat(),
        writes: [
            writes(&[TOP.writes], bits),
            writes(&TOP.payload_writes[..payloads], bits),
            writes(&TOP.depth_writes[..depth_writers], MERGED_DEPTH_BITS),
        ]
        .concat(),
        window: None,
        memory: (depth_base + depth_bytes) as usize,
        memory_order,
    };
    (around, Bases { buffer: buffer_base, payloads: payload_base, depths: depth_base })
}

/// Tells the renderer where all of that lies.
pub fn place<I: Packet<Domain = Words, Config = splat::Config>, O: Packet<Domain = Words, Config = splat::Config>>(
    host: &mut Host<I, O>,
    config: &splat::Config,
    bases: Bases,
) {
    host.write_base("buffer_base", bases.buffer);
    if config.has_payloads_in_memory() {
        host.write_base("payload_base", bases.payloads);
    }
    if config.merge.is_on() {
        host.write_base("depth_base", bases.depths);
    }
}

/// What a memory does first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MemoryOrder {
    /// Reads and writes side by side.
    Any,
    /// It finishes the bursts that it reads before it takes anything that is written.
    ReadsFirst,
}

impl<C: Clone, I: Packet<Domain = Words, Config = C>, O: Packet<Domain = Words, Config = C>> Host<I, O> {
    pub fn new(top: Module, config: &C, widths: Config, around: Around, seed: u64) -> Self {
        let mut random = fastrand::Rng::with_seed(seed);
        let bench = Bench::new(top, seed);
        let random = &mut random;
        let host = around.registers;
        let register_write = (
            feed(&bench, host.write_address, &(), random),
            feed(&bench, host.write_data, &(), random),
            Drain::new(&bench, host.write_answer, &(), stalls(random)),
        );
        let read_address = feed(&bench, host.read_address, &(), random);
        let register_read = (read_address, Drain::new(&bench, host.read_value, &(), stalls(random)));
        let (bus_in, bus_out) = around.packets;
        let packets_in = feed(&bench, bus_in.beats, &widths.stream_bits, random);
        let packets_out = Drain::new(&bench, bus_out.beats, &widths.stream_bits, stalls(random));
        let window = around.window.map(|(window, bits)| {
            (
                feed(&bench, window.write_address, &bits.address, random),
                feed(&bench, window.write_data, &bits.beat, random),
                Drain::new(&bench, window.write_answer, &(), stalls(random)),
            )
        });
        let reads = around.reads.into_iter().map(|bus| Reads::new(&bench, bus, random)).collect();
        let writes = around.writes.into_iter().map(|bus| Writes::new(&bench, bus, random)).collect();
        Self {
            widths,
            map: around.map,
            register_write,
            register_read,
            packets_in,
            config: config.clone(),
            sender: PacketOut::new(config, widths.stream_bits),
            packets_out,
            receiver: PacketIn::new(config, widths.stream_bits),
            arriving: vec![],
            mirror: PacketOut::new(config, widths.stream_bits),
            reads,
            writes,
            window,
            memory_order: around.memory_order,
            memory: vec![0; around.memory],
            origin: random.u32(..u32::MAX - around.memory as u32) / BORDER_BYTES * BORDER_BYTES,
            received: vec![],
            is_held: false,
            bench,
        }
    }

    pub fn step(&mut self) {
        let Self { bench, register_write, register_read, packets_in, packets_out, .. } = self;
        let Self { reads, writes, window, memory_order, .. } = self;
        let mut feeds = vec![&mut register_write.0, &mut register_write.1, &mut register_read.0, packets_in];
        let mut drains = vec![&mut register_write.2, &mut register_read.1, packets_out];
        for Reads { address, data, .. } in reads.iter_mut() {
            drains.push(address);
            feeds.push(data);
        }
        for Writes { address, data, answer, .. } in writes.iter_mut() {
            drains.extend([address, data]);
            feeds.push(answer);
        }
        if let Some((address, data, answer)) = window {
            feeds.extend([address, data]);
            drains.push(answer);
        }
        feeds.into_iter().for_each(|feed| feed.offer(bench));
        drains.into_iter().for_each(|drain| drain.offer(bench));
        let reads_wait = reads.iter().any(|reads| !reads.data.items.is_empty());
        if reads_wait && *memory_order == MemoryOrder::ReadsFirst {
            for writes in writes {
                writes.address.wait(bench);
                writes.data.wait(bench);
            }
        }
        if self.is_held {
            packets_out.wait(bench);
        }
        bench.step();
        [&mut self.register_write.0, &mut self.register_write.1, &mut self.register_read.0, &mut self.packets_in]
            .into_iter()
            .for_each(|feed| _ = feed.taken(&self.bench));
        if let Some(beat) = self.packets_out.taken(&self.bench) {
            let (data, last) = beat.split_at(beat.len() - 1);
            let data = bytes(data, self.widths.stream_bits as usize / 8);
            let verdict = self.receiver.beat(&data, last[0] == 1);
            self.arriving.push((data, last[0] == 1));
            match verdict {
                Some(Verdict::Taken(packet)) => {
                    assert_eq!(std::mem::take(&mut self.arriving), self.mirror.beats(packet), "padding is zero");
                    self.received.push(packet);
                }
                Some(Verdict::Refused) => panic!("a packet of a wrong length came"),
                None => {}
            }
        }
        self.reads.iter_mut().for_each(|reads| reads.step(&self.bench, self.origin, &self.memory));
        for writes in &mut self.writes {
            writes.step(&self.bench, self.origin, &mut self.memory);
        }
    }

    /// Cycles since the reset.
    pub const fn cycles(&self) -> u64 {
        self.bench.cycle
    }

    fn register(&self, name: &str) -> &Register {
        let register = self.map.iter().find(|register| register.name == name);
        register.unwrap_or_else(|| panic!("no register {name}"))
    }

    /// Writes a register; returns whether it was accepted.
    pub fn write_at(&mut self, address: u64, data: u32) -> bool {
        self.order_write(address, data);
        self.write_answered()
    }

    fn order_write(&mut self, address: u64, data: u32) {
        self.register_write.0.items.push_back(vec![address]);
        self.register_write.1.items.push_back(vec![data.into(), 0xf]);
    }

    /// Steps until there is an answer.
    fn answered(&mut self, mut taken: impl FnMut(&mut Self) -> Option<Vec<u64>>) -> Vec<u64> {
        for _ in 0..ANSWER_CYCLES {
            self.step();
            if let Some(answer) = taken(self) {
                return answer;
            }
        }
        panic!("no answer in {ANSWER_CYCLES} cycles");
    }

    /// Whether the next write is accepted.
    fn write_answered(&mut self) -> bool {
        is_accepted(self.answered(|host| host.register_write.2.taken(&host.bench))[0])
    }

    /// Writes a register, which keeps it.
    pub fn write(&mut self, name: &str, data: u32) {
        let register = self.register(name);
        let (address, access) = (register.address, register.access());
        assert!(self.write_at(address.into(), data), "{name} = {data:x} is refused");
        if access == Access::ReadWrite {
            assert_eq!(self.read(name), data, "{name}");
        }
    }

    /// Writes where something in memory begins.
    pub fn write_base(&mut self, name: &str, place: u32) {
        self.write(name, self.origin + place);
    }

    pub fn read(&mut self, name: &str) -> u32 {
        let address = self.register(name).address;
        self.register_read.0.items.push_back(vec![address.into()]);
        let answer = self.answered(|host| host.register_read.1.taken(&host.bench));
        assert_eq!(answer[1], 0, "{name} is refused");
        answer[0] as u32
    }

    /// Begins a run, with other commands besides.
    pub fn start(&mut self, commands: u32) -> bool {
        self.write_at(CONTROL.into(), START | commands)
    }

    /// Sends a packet, some beats short of its end.
    pub fn send(&mut self, record: &[u64], missing: usize) {
        let mut beats = self.sender.beats(read(&self.config, record));
        beats.truncate(beats.len() - missing);
        let count = beats.len();
        for (place, (data, _)) in beats.into_iter().enumerate() {
            let item = words(&data).into_iter().chain([u64::from(place + 1 == count)]).collect();
            self.packets_in.items.push_back(item);
        }
    }

    /// Steps until the run has ended; its packets are in `received`.
    pub fn finish(&mut self) {
        let status = self.map.iter().find(|register| register.address == STATUS).unwrap().name.clone();
        let begin = self.cycles();
        while self.read(&status) & 1 == 1 {
            assert!(self.cycles() < begin + RUN_CYCLES, "a run has not ended in {RUN_CYCLES} cycles");
        }
    }

    /// Ends the run before its time, and forgets what was not sent and what has come.
    pub fn abort(&mut self) {
        assert!(self.write_at(CONTROL.into(), ABORT));
        self.finish();
        self.forget();
    }

    /// Ends a run that may just end by itself, and begins another at once; returns whether that was accepted.
    pub fn abort_and_start(&mut self) -> bool {
        self.order_write(CONTROL.into(), ABORT);
        self.order_write(CONTROL.into(), START);
        assert!(self.write_answered());
        self.write_answered()
    }

    /// Forgets what was not sent and what has come.
    pub fn forget(&mut self) {
        self.packets_in.cease(&mut self.bench);
        self.received.clear();
    }

    /// Writes a word of the tree; returns whether it was accepted.
    pub fn write_tree(&mut self, index: u64, word: u64) -> bool {
        let (address, data, _) = self.window.as_mut().expect("the core has a window");
        let id = index as u8 % (1 << ID_BITS);
        let burst = BurstAddress { id, address: index as u32 * 8, length: 0, size: 3, burst: UP };
        address.items.push_back(contract::words(&ADDRESS_BITS, burst));
        let beat = WriteBeat { data: word, strobes: 0xff, last: true };
        data.items.push_back(contract::words(&TREE_WORD_BITS, beat));
        let answer = self.answered(|host| {
            let (address, data, answer) = host.window.as_mut().expect("the core has a window");
            address.taken(&host.bench);
            data.taken(&host.bench);
            answer.taken(&host.bench)
        });
        assert_eq!(answer[0], u64::from(id));
        is_accepted(answer[1])
    }

    /// Whether nothing went wrong so far.
    pub fn expect_errors(&mut self, expected: [u32; 5]) {
        let names = ERRORS.map(|(_, name, _)| name);
        assert_eq!(names.map(|name| self.read(name)), expected, "{names:?}");
    }
}
