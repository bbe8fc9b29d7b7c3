//! A host with memory around a core on AXI: registers, packets, bursts, all of them stalling.

use std::collections::VecDeque;

use pointcore_contract::Field;
use pointcore_contract::bus::registers::{CONTROL, STATUS};
use pointcore_contract::bus::{Config, Register};
use pointcore_golden::bus::{PacketIn, PacketOut, Verdict};
use rtl::Module;

use super::{Bench, Drain, Feed, bytes, stalls, words};

const SLAVE_ERROR: u64 = 2;
const ADDRESS_FIELDS: [&str; 5] = ["id", "addr", "len", "size", "burst"];
/// Bits of `control`.
pub const START: u32 = 1;
pub const RESET: u32 = 2;

/// A memory port's read half, and where it reads.
struct Reads {
    address: Drain,
    data: Feed,
}

impl Reads {
    fn new(bench: &Bench, prefix: &str, random: &mut fastrand::Rng) -> Self {
        let address = Drain::new(bench, &format!("{prefix}_ar"), &ADDRESS_FIELDS, stalls(random));
        let pattern = stalls(random);
        let data = Feed::new(bench, &format!("{prefix}_r"), &["id", "data", "resp", "last"], random, pattern);
        Self { address, data }
    }

    fn step(&mut self, bench: &Bench, memory: &[u8], beat_bytes: usize) {
        self.data.taken(bench);
        let Some(burst) = self.address.taken(bench) else { return };
        let [_, first, length] = [0, 1, 2].map(|field| burst[field] as usize);
        for beat in 0..=length {
            let place = first + beat * beat_bytes;
            let mut item = vec![burst[0]];
            item.extend(words(&memory[place..place + beat_bytes]));
            item.extend([0, u64::from(beat == length)]);
            self.data.items.push_back(item);
        }
    }
}

/// A memory port's write half.
struct Writes {
    address: Drain,
    data: Drain,
    answer: Feed,
    /// Bursts that lack data, and data that lack a burst.
    bursts: VecDeque<usize>,
    packets: VecDeque<Vec<u8>>,
    gathered: Vec<u8>,
}

impl Writes {
    fn new(bench: &Bench, prefix: &str, random: &mut fastrand::Rng) -> Self {
        let address = Drain::new(bench, &format!("{prefix}_aw"), &ADDRESS_FIELDS, stalls(random));
        let data = Drain::new(bench, &format!("{prefix}_w"), &["data", "strb", "last"], stalls(random));
        let pattern = stalls(random);
        let answer = Feed::new(bench, &format!("{prefix}_b"), &["id", "resp"], random, pattern);
        let (bursts, packets, gathered) = (VecDeque::new(), VecDeque::new(), vec![]);
        Self { address, data, answer, bursts, packets, gathered }
    }

    fn step(&mut self, bench: &Bench, memory: &mut [u8], beat_bytes: usize) {
        self.answer.taken(bench);
        self.bursts.extend(self.address.taken(bench).map(|burst| burst[1] as usize));
        if let Some(beat) = self.data.taken(bench) {
            self.gathered.extend(bytes(&beat, beat_bytes));
            if beat[beat.len() - 1] == 1 {
                self.packets.push_back(std::mem::take(&mut self.gathered));
            }
        }
        if !self.bursts.is_empty() && !self.packets.is_empty() {
            let (place, packet) = (self.bursts.pop_front().unwrap(), self.packets.pop_front().unwrap());
            memory[place..place + packet.len()].copy_from_slice(&packet);
            self.answer.items.push_back(vec![0, 0]);
        }
    }
}

/// The host.
pub struct Host {
    bench: Bench,
    widths: Config,
    map: Vec<Register>,
    register_write: (Feed, Feed, Drain),
    register_read: (Feed, Drain),
    packets_in: Feed,
    sender: PacketOut,
    packets_out: Drain,
    receiver: PacketIn,
    reads: Vec<Reads>,
    writes: Option<Writes>,
    window: Option<(Feed, Feed, Drain)>,
    /// Bytes behind all memory ports.
    pub memory: Vec<u8>,
    /// Packets that came.
    pub received: Vec<Vec<u64>>,
}

/// What a top has around it.
pub struct Around<'a> {
    /// Its registers.
    pub map: Vec<Register>,
    /// Its streams of packets: names and fields, in and out.
    pub packets: [(&'a str, Vec<Field>); 2],
    /// Its memory ports that read.
    pub reads: &'a [&'a str],
    /// Its memory port that writes.
    pub writes: Option<&'a str>,
    /// It has a window for the tree.
    pub window: bool,
    /// Bytes of memory.
    pub memory: usize,
}

impl Host {
    pub fn new(top: Module, widths: Config, around: Around, seed: u64) -> Self {
        let mut random = fastrand::Rng::with_seed(seed);
        let bench = Bench::new(top, seed);
        let random = &mut random;
        let feed = |prefix: &str, fields: &[&str], random: &mut fastrand::Rng| {
            let pattern = stalls(random);
            Feed::new(&bench, prefix, fields, random, pattern)
        };
        let drain = |prefix: &str, fields: &[&str], random: &mut fastrand::Rng| {
            Drain::new(&bench, prefix, fields, stalls(random))
        };
        let register_write = (
            feed("s_axil_aw", &["addr"], random),
            feed("s_axil_w", &["data", "strb"], random),
            drain("s_axil_b", &["resp"], random),
        );
        let register_read = (feed("s_axil_ar", &["addr"], random), drain("s_axil_r", &["data", "resp"], random));
        let [(name_in, fields_in), (name_out, fields_out)] = &around.packets;
        let packets_in = feed(&format!("{name_in}_t"), &["data", "last"], random);
        let packets_out = drain(&format!("{name_out}_t"), &["data", "last"], random);
        let window = around.window.then(|| {
            (
                feed("s_axi_aw", &ADDRESS_FIELDS, random),
                feed("s_axi_w", &["data", "strb", "last"], random),
                drain("s_axi_b", &["id", "resp"], random),
            )
        });
        let reads = around.reads.iter().map(|prefix| Reads::new(&bench, prefix, random)).collect();
        let writes = around.writes.map(|prefix| Writes::new(&bench, prefix, random));
        Self {
            widths,
            map: around.map,
            register_write,
            register_read,
            packets_in,
            sender: PacketOut::new(fields_in, widths.stream_bits),
            packets_out,
            receiver: PacketIn::new(fields_out, widths.stream_bits, None),
            reads,
            writes,
            window,
            memory: vec![0; around.memory],
            received: vec![],
            bench,
        }
    }

    pub fn step(&mut self) {
        let Self { bench, register_write, register_read, packets_in, packets_out, reads, writes, window, .. } = self;
        let mut feeds = vec![&mut register_write.0, &mut register_write.1, &mut register_read.0, packets_in];
        let mut drains = vec![&mut register_write.2, &mut register_read.1, packets_out];
        for Reads { address, data } in reads.iter_mut() {
            drains.push(address);
            feeds.push(data);
        }
        if let Some(Writes { address, data, answer, .. }) = writes {
            drains.extend([address, data]);
            feeds.push(answer);
        }
        if let Some((address, data, answer)) = window {
            feeds.extend([address, data]);
            drains.push(answer);
        }
        feeds.into_iter().for_each(|feed| feed.offer(bench));
        drains.into_iter().for_each(|drain| drain.offer(bench));
        bench.step();
        let beat_bytes = self.widths.memory_bits as usize / 8;
        [&mut self.register_write.0, &mut self.register_write.1, &mut self.register_read.0, &mut self.packets_in]
            .into_iter()
            .for_each(|feed| _ = feed.taken(&self.bench));
        if let Some(beat) = self.packets_out.taken(&self.bench) {
            let (data, last) = beat.split_at(beat.len() - 1);
            let data = bytes(data, self.widths.stream_bits as usize / 8);
            match self.receiver.beat(&data, last[0] == 1) {
                Some(Verdict::Taken(packet)) => self.received.push(packet),
                Some(Verdict::Refused) => panic!("a packet of a wrong length came"),
                None => {}
            }
        }
        self.reads.iter_mut().for_each(|reads| reads.step(&self.bench, &self.memory, beat_bytes));
        if let Some(writes) = &mut self.writes {
            writes.step(&self.bench, &mut self.memory, beat_bytes);
        }
    }

    fn address(&self, name: &str) -> u64 {
        let register = self.map.iter().find(|register| register.name == name);
        register.unwrap_or_else(|| panic!("no register {name}")).address.into()
    }

    /// Writes a register; returns whether it was accepted.
    pub fn write_at(&mut self, address: u64, data: u32) -> bool {
        self.register_write.0.items.push_back(vec![address]);
        self.register_write.1.items.push_back(vec![data.into(), 0xf]);
        loop {
            self.step();
            if let Some(answer) = self.register_write.2.taken(&self.bench) {
                return answer[0] != SLAVE_ERROR;
            }
        }
    }

    pub fn write(&mut self, name: &str, data: u32) {
        assert!(self.write_at(self.address(name), data), "{name} = {data:x} is refused");
    }

    pub fn read(&mut self, name: &str) -> u32 {
        self.register_read.0.items.push_back(vec![self.address(name)]);
        loop {
            self.step();
            if let Some(answer) = self.register_read.1.taken(&self.bench) {
                assert_eq!(answer[1], 0, "{name} is refused");
                return answer[0] as u32;
            }
        }
    }

    /// Begins a run, with other commands besides.
    pub fn start(&mut self, commands: u32) -> bool {
        self.write_at(CONTROL.into(), START | commands)
    }

    /// Sends a packet, some beats short of its end.
    pub fn send(&mut self, record: &[u64], missing: usize) {
        let mut beats = self.sender.beats(record);
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
        while self.read(&status) & 1 == 1 {}
    }

    /// Writes a word of the tree; returns whether it was accepted.
    pub fn write_tree(&mut self, index: u64, word: u64) -> bool {
        let (address, data, _) = self.window.as_mut().expect("the core has a window");
        address.items.push_back(vec![5, index * 8, 0, 3, 1]);
        data.items.push_back(vec![word, 0xff, 1]);
        loop {
            self.step();
            let (address, data, answer) = self.window.as_mut().expect("the core has a window");
            address.taken(&self.bench);
            data.taken(&self.bench);
            if let Some(answer) = answer.taken(&self.bench) {
                return answer[1] != SLAVE_ERROR;
            }
        }
    }

    /// Whether nothing went wrong so far.
    pub fn expect_errors(&mut self, expected: [u32; 5]) {
        let names = ["access_errors", "busy_errors", "burst_errors", "packet_errors", "memory_errors"];
        assert_eq!(names.map(|name| self.read(name)), expected, "{names:?}");
    }
}
