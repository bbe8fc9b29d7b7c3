//! A memory that a core reads and writes through some ports, a record a cycle each way.

use super::{Bus, ExternalMemory, MemorySettings, RequestSize, WrittenBursts};

/// Records that passed the ports, and what they cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Records read.
    pub read: u64,
    /// Records written.
    pub written: u64,
    /// Bytes that the memory moved for them, whole bursts.
    pub bytes: u64,
    /// Cycles that this takes at the memory's bandwidth, and at that of the busiest port, whichever are more.
    pub busy_cycles: u64,
}

/// The memory but for what it holds; requests bear a key. Reads of a port come back in order, a record a cycle at most.
///
/// Without a bandwidth among its settings, a record a cycle goes each way at every port. Else reads and writes of all ports share the
/// bus: a read waits for it after the latency, a write is accepted when it is free.
#[derive(Clone)]
pub struct ReadWriteMemory<K> {
    record_bytes: u32,
    memory: ExternalMemory<K>,
    /// The bus of the writes, where they have one of their own.
    write_bus: Option<Bus>,
    ports: Vec<Port>,
}

/// What passed a port.
#[derive(Clone, Copy)]
struct Port {
    bursts: WrittenBursts,
    read: u64,
    written: u64,
}

impl<K: Copy> ReadWriteMemory<K> {
    /// An idle memory of records of so many bytes. Its answers keep their order, whatever the settings say.
    #[must_use]
    pub fn new(settings: MemorySettings, ports: u32, record_bytes: u32) -> Self {
        let settings = MemorySettings { reorder_window: 1, ..settings };
        let bytes_at_once = record_bytes * ports.max(1);
        let port = Port { bursts: WrittenBursts::new(&settings), read: 0, written: 0 };
        Self {
            record_bytes,
            // Nothing is left to chance in order.
            memory: ExternalMemory::new(settings, ports as usize, bytes_at_once, 0),
            write_bus: settings.bytes_per_cycle.is_none().then(|| Bus::new(&settings, bytes_at_once)),
            ports: vec![port; ports as usize],
        }
    }

    /// How many ports there are.
    #[must_use]
    pub const fn ports(&self) -> usize {
        self.ports.len()
    }

    /// Accepts a read of so many records in cycle `now`.
    pub fn request(&mut self, port: usize, key: K, records: u32, now: u64) {
        self.memory.request(port, key, RequestSize { beats: records, beat_bytes: self.record_bytes }, now);
    }

    /// Gives the bus to what waits for it; once a cycle, before what is on offer is asked for.
    pub fn advance(&mut self, now: u64) {
        self.memory.advance(now);
    }

    /// What is on offer at a port in cycle `now`: the key of its request, and which of its records.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<(K, u32)> {
        self.memory.offer(port, now)
    }

    /// The record offered at a port was taken.
    pub fn take(&mut self, port: usize) {
        self.ports[port].read += 1;
        self.memory.take(port);
    }

    /// Whether a write can be accepted in cycle `now`.
    #[must_use]
    pub fn is_writable(&self, now: u64) -> bool {
        self.write_bus.as_ref().unwrap_or_else(|| self.memory.bus()).is_free(now)
    }

    /// Accepts a write of a record in cycle `now`, that number of a block; every block begins a burst.
    pub fn write(&mut self, port: usize, block: usize, number: u32, now: u64) {
        let begin = number * self.record_bytes;
        let port = &mut self.ports[port];
        port.written += 1;
        let bytes = port.bursts.bytes(block, begin..begin + self.record_bytes);
        let bus = self.write_bus.as_mut().unwrap_or_else(|| self.memory.bus_mut());
        bus.transfer(bytes, now);
    }

    /// What passed so far.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        let busiest = self.ports.iter().map(|port| port.read.max(port.written)).max().unwrap_or(0);
        let buses = || [Some(self.memory.bus()), self.write_bus.as_ref()].into_iter().flatten();
        let on_bus = buses().map(|bus| bus.busy_cycles().ceil() as u64).max().unwrap_or(0);
        Traffic {
            read: self.ports.iter().map(|port| port.read).sum(),
            written: self.ports.iter().map(|port| port.written).sum(),
            bytes: buses().map(Bus::bytes).sum(),
            busy_cycles: on_bus.max(busiest),
        }
    }
}
