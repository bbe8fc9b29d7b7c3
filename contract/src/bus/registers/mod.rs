//! Registers, what they are, and the maps of both cores.

mod maps;

pub use maps::{
    MapEntries, MapEntry, PointsRegisters, PointsSettings, RegisterMap, SearchRegisters, SearchSettings,
    SplatRegisters, SplatSettings, common, settings,
};

use crate::record;
use crate::splat::config::index_bits;

/// Address of `id`.
pub const ID: u32 = 0x000;
/// Address of `control`.
pub const CONTROL: u32 = 0x004;
/// Address of `status`.
pub const STATUS: u32 = 0x008;
/// Address of `interrupt_enable`.
pub const INTERRUPT_ENABLE: u32 = 0x00c;
/// Address of the first counter that every core has; the others follow word by word.
pub const COUNTERS: u32 = 0x010;
/// Address of the counter of the first event; the others follow word by word.
pub const EVENTS: u32 = 0x040;
/// Address of the first setting.
pub const SETTINGS: u32 = 0x080;
/// Address of the first uniform register of the renderer.
pub const UNIFORMS: u32 = 0x100;

/// Bits of `control`.
pub const CONTROL_BITS: [(&str, &str); 4] = [
    ("start", "begins a run, clears `done` and the run's counters"),
    ("reset", "resets the core's state (caches, threads); uniforms and the tree stay"),
    ("clear_errors", "clears the error counters"),
    (
        "abort",
        "ends the run under way: the core is reset, what is under way on the buses is taken and dropped; without a run, nothing",
    ),
];
/// Bits of `status`; the last where a `start` may wait.
pub const STATUS_BITS: [(&str, &str); 4] = [
    ("busy", "a run is under way"),
    ("done", "a run has ended since the last start"),
    ("error", "an error counter is not zero"),
    ("waiting", "a start waits until its frame may begin"),
];
/// Bits of `interrupt_enable`.
pub const INTERRUPT_BITS: [(&str, &str); 1] = [("done", "`irq` is high while `done` is")];

/// What counts errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ErrorCounter {
    /// Refused accesses to registers.
    Access,
    /// What is refused because a run is under way.
    Busy,
    /// Refused and misshapen bursts.
    Burst,
    /// Refused packets.
    Packet,
    /// Bad answers from memory.
    Memory,
}

/// The error counters in order.
pub const ERRORS: [(ErrorCounter, &str, &str); 5] = [
    (
        ErrorCounter::Access,
        "access_errors",
        "register accesses refused: outside the map, not of a whole aligned word, written where only read or read where only \
         written, a value that makes no sense",
    ),
    (ErrorCounter::Busy, "busy_errors", "accesses refused because a run is under way"),
    (
        ErrorCounter::Burst,
        "burst_errors",
        "bursts refused by `s_axi`, read bursts from memory whose `rlast` was not at their end, beats from memory that nobody \
         asked for, and leaves without beats, read as of one",
    ),
    (
        ErrorCounter::Packet,
        "packet_errors",
        "packets refused: `tlast` before or after their end, or a field out of its range",
    ),
    (ErrorCounter::Memory, "memory_errors", "responses from memory that were not OKAY"),
];

/// How many sources there are elsewhere of each kind of error but of access, which is the registers' own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ErrorSources {
    /// Of what is refused because a run is under way.
    pub busy: u32,
    /// Of refused and misshapen bursts.
    pub burst: u32,
    /// Of refused packets.
    pub packet: u32,
    /// Of bad answers from memory.
    pub memory: u32,
}

/// Errors from elsewhere, a bit a source.
#[record(sources: ErrorSources)]
pub struct ErrorInputs {
    /// Something was refused because a run is under way.
    #[when(sources.busy > 0)]
    #[bits(sources.busy)]
    pub busy_error: u8,
    /// A burst was refused, or ended where it must not.
    #[when(sources.burst > 0)]
    #[bits(sources.burst)]
    pub burst_error: u16,
    /// A packet was refused.
    #[when(sources.packet > 0)]
    #[bits(sources.packet)]
    pub packet_error: u8,
    /// Memory answered with an error.
    #[when(sources.memory > 0)]
    #[bits(sources.memory)]
    pub memory_error: u32,
}

/// What counts in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RunCounter {
    /// Cycles.
    Cycles,
    /// Packets taken.
    PacketsIn,
    /// Packets sent.
    PacketsOut,
    /// Cycles with an event of the core's, by its place among them.
    Event(usize),
}

/// The counters of a run that every core has, before those of its events.
pub const RUN_COUNTERS: [(RunCounter, &str, &str); 3] = [
    (RunCounter::Cycles, "cycles", "cycles of the run, to its end or so far"),
    (RunCounter::PacketsIn, "packets_in", "packets taken in the run"),
    (RunCounter::PacketsOut, "packets_out", "packets sent in the run"),
];

/// How a register may be accessed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Read only.
    Read,
    /// Written only.
    Write,
    /// Both.
    ReadWrite,
}

/// When a register may be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// At any time.
    Always,
    /// While no start waits.
    Ahead,
    /// While no run is under way.
    Idle,
}

/// What a register is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegisterKind {
    /// A constant.
    Identity(u32),
    /// Commands, [`CONTROL_BITS`], of which `start` may be written then.
    Control(When),
    /// [`STATUS_BITS`], of a core that may be started then.
    Status(When),
    /// [`INTERRUPT_BITS`].
    InterruptEnable,
    /// Counts errors until they are cleared.
    Errors(ErrorCounter),
    /// Counts in a run.
    Run(RunCounter),
    /// A value that the hardware holds; a multiple of `multiple`.
    Setting {
        /// What every value is a multiple of; a power of two.
        multiple: u32,
    },
    /// A number that the hardware holds, after reset the smallest one; others than those of the range are refused.
    Range {
        /// The smallest value.
        low: u32,
        /// The largest value.
        high: u32,
    },
    /// The number of queries of a run, a setting without which no run starts.
    Queries,
    /// A register inside the core.
    Uniform,
}

/// A register.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Register {
    /// Its name.
    pub name: String,
    /// Its byte address.
    pub address: u32,
    /// What it is.
    pub kind: RegisterKind,
    /// Its bits, from the lowest on; others are ignored when written and read as zero.
    pub width: u32,
    /// One line.
    pub doc: String,
}

impl Register {
    fn new(name: &str, address: u32, kind: RegisterKind, width: u32, doc: impl Into<String>) -> Self {
        Self { name: name.to_owned(), address, kind, width, doc: doc.into() }
    }

    /// How it may be accessed.
    #[must_use]
    pub const fn access(&self) -> Access {
        match self.kind {
            RegisterKind::Identity(_) | RegisterKind::Status(_) | RegisterKind::Errors(_) | RegisterKind::Run(_) => {
                Access::Read
            }
            RegisterKind::Control(_) | RegisterKind::Uniform => Access::Write,
            RegisterKind::InterruptEnable
            | RegisterKind::Setting { .. }
            | RegisterKind::Range { .. }
            | RegisterKind::Queries => Access::ReadWrite,
        }
    }

    /// When it may be written; of `control`, `start`: `reset` only while no run is under way, the others always.
    #[must_use]
    pub const fn when(&self) -> When {
        match self.kind {
            RegisterKind::InterruptEnable => When::Always,
            RegisterKind::Control(start) => start,
            RegisterKind::Uniform => When::Ahead,
            _ => When::Idle,
        }
    }

    /// Its value after reset.
    #[must_use]
    pub const fn reset(&self) -> u32 {
        match self.kind {
            RegisterKind::Identity(value) => value,
            RegisterKind::Range { low, .. } => low,
            _ => 0,
        }
    }

    /// Names and meanings of its bits, lowest first, where they have any.
    #[must_use]
    pub const fn bits(&self) -> &'static [(&'static str, &'static str)] {
        match self.kind {
            RegisterKind::Control(_) => &CONTROL_BITS,
            RegisterKind::Status(When::Ahead) => &STATUS_BITS,
            RegisterKind::Status(_) => STATUS_BITS.split_at(STATUS_BITS.len() - 1).0,
            RegisterKind::InterruptEnable => &INTERRUPT_BITS,
            _ => &[],
        }
    }
}

/// How a map's uniforms are told apart, and how wide they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UniformBits {
    /// Bits that number them.
    pub address: u32,
    /// Bits of a value.
    pub data: u32,
}

impl UniformBits {
    /// Of the uniforms of a map, if it has any.
    #[must_use]
    pub fn of(map: &[Register]) -> Option<Self> {
        let uniforms: Vec<_> = map.iter().filter(|register| register.kind == RegisterKind::Uniform).collect();
        Some(Self { address: index_bits(uniforms.len() as u32), data: uniforms.first()?.width })
    }
}

/// A write to one of the core's own registers.
#[record(bits: UniformBits)]
pub struct RegisterWrite {
    /// The register's place among them.
    #[bits(bits.address)]
    pub address: u8,
    /// Its new value.
    #[bits(bits.data)]
    pub data: u32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{points, search, splat};
    use std::collections::HashSet;

    #[test]
    fn registers_lie_apart_where_the_contract_has_them() {
        let b = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
        for map in [
            SplatRegisters::registers(&splat::Config::default()),
            SearchRegisters::registers(&search::Config::default()),
            SearchRegisters::registers(&b),
            PointsRegisters::registers(&points::Config::default()),
            PointsRegisters::registers(&points::Config { search: b.clone(), ..points::Config::default() }),
        ] {
            assert!(map.is_sorted_by(|a, b| a.address < b.address), "{map:?}");
            assert!(map.iter().all(|register| register.address % 4 == 0 && register.address < 0x1000));
            let names: HashSet<_> = map.iter().map(|register| &register.name).collect();
            assert_eq!(names.len(), map.len());
            let is_held = |register: &&Register| register.access() == Access::ReadWrite && register.address >= EVENTS;
            let last = map.iter().rfind(|register| matches!(register.kind, RegisterKind::Run(_))).unwrap();
            let first = map.iter().find(is_held).unwrap();
            assert!(last.address < first.address && first.address >= SETTINGS, "counters run into the settings");
            let address =
                |name: &str| map.iter().find(|register| register.name == name).map(|register| register.address);
            assert_eq!([address("memory_errors"), address("cycles")], [Some(0x20), Some(0x24)]);
            assert_eq!([address("packets_in"), address("packets_out")], [Some(0x28), Some(0x2c)]);
        }
        let map = SearchRegisters::registers(&b);
        let address = |name: &str| map.iter().find(|register| register.name == name).map(|register| register.address);
        assert_eq!(
            [address("event_node"), address("tree_base"), address("queries")],
            [Some(0x40), Some(0x84), Some(0x88)]
        );
        assert_eq!(address("cache_margin_scale"), Some(0x94));
        assert_eq!(map[0].reset(), 0x5043_0b01);
    }
}
