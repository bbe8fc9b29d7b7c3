//! The register maps of both cores.

use super::config::BORDER_BYTES;
use crate::search;
use crate::splat::records::Uniforms;
use crate::{fields, splat};

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

/// "PC", in the upper half of `id`.
const SIGNATURE: u32 = 0x5043;
/// Version of the layout of registers and packets.
const VERSION: u32 = 1;
/// The renderer's and the search core's byte in `id`.
const SPLAT: u32 = 0x0a;
const SEARCH: u32 = 0x0b;

/// Bits of `control`.
pub const CONTROL_BITS: [(&str, &str); 3] = [
    ("start", "begins a run, clears `done` and the run's counters"),
    ("reset", "resets the core's state (caches, threads); uniforms and the tree stay"),
    ("clear_errors", "clears the error counters"),
];
/// Bits of `status`.
pub const STATUS_BITS: [(&str, &str); 3] = [
    ("busy", "a run is under way"),
    ("done", "a run has ended since the last start"),
    ("error", "an error counter is not zero"),
];
/// Bits of `interrupt_enable`.
pub const INTERRUPT_BITS: [(&str, &str); 1] = [("done", "`irq` is high while `done` is")];

/// The error counters in order.
pub const ERRORS: [(&str, &str); 5] = [
    (
        "access_errors",
        "register accesses refused: outside the map, not of a whole aligned word, written where only read or read where only \
         written, a value that makes no sense",
    ),
    ("busy_errors", "accesses refused because a run is under way"),
    ("burst_errors", "bursts refused by `s_axi`, and read bursts from memory whose `rlast` was not at their end"),
    ("packet_errors", "packets refused: `tlast` before or after their end, or a field out of its range"),
    ("memory_errors", "responses from memory that were not OKAY"),
];
/// The counters of a run that every core has, before those of its events.
pub const RUN_COUNTERS: [(&str, &str); 3] = [
    ("cycles", "cycles of the run, to its end or so far"),
    ("packets_in", "packets taken in the run"),
    ("packets_out", "packets sent in the run"),
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
    /// While no run is under way.
    Idle,
}

/// What a register is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A constant.
    Identity(u32),
    /// Commands, [`CONTROL_BITS`].
    Control,
    /// [`STATUS_BITS`].
    Status,
    /// [`INTERRUPT_BITS`].
    InterruptEnable,
    /// Counts errors until they are cleared.
    Errors,
    /// Counts in a run.
    Run,
    /// A value that the hardware holds; a multiple of `multiple`.
    Setting {
        /// What every value is a multiple of; a power of two.
        multiple: u32,
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
    pub kind: Kind,
    /// Its bits, from the lowest on; others are ignored when written and read as zero.
    pub width: u32,
    /// One line.
    pub doc: String,
}

impl Register {
    fn new(name: &str, address: u32, kind: Kind, width: u32, doc: impl Into<String>) -> Self {
        Self { name: name.to_owned(), address, kind, width, doc: doc.into() }
    }

    /// How it may be accessed.
    #[must_use]
    pub const fn access(&self) -> Access {
        match self.kind {
            Kind::Identity(_) | Kind::Status | Kind::Errors | Kind::Run => Access::Read,
            Kind::Control | Kind::Uniform => Access::Write,
            Kind::InterruptEnable | Kind::Setting { .. } | Kind::Queries => Access::ReadWrite,
        }
    }

    /// When it may be written; of `control`, `clear_errors` always may.
    #[must_use]
    pub const fn when(&self) -> When {
        match self.kind {
            Kind::InterruptEnable => When::Always,
            _ => When::Idle,
        }
    }

    /// Its value after reset.
    #[must_use]
    pub const fn reset(&self) -> u32 {
        match self.kind {
            Kind::Identity(value) => value,
            _ => 0,
        }
    }

    /// Names and meanings of its bits, lowest first, where they have any.
    #[must_use]
    pub const fn bits(&self) -> &'static [(&'static str, &'static str)] {
        match self.kind {
            Kind::Control => &CONTROL_BITS,
            Kind::Status => &STATUS_BITS,
            Kind::InterruptEnable => &INTERRUPT_BITS,
            _ => &[],
        }
    }
}

/// What both maps begin with: identity to counters.
fn common(core: u32, events: &[impl AsRef<str>]) -> Vec<Register> {
    let identity = SIGNATURE << 16 | core << 8 | VERSION;
    let mut map = vec![
        Register::new(
            "id",
            ID,
            Kind::Identity(identity),
            32,
            "\"PC\", the core (0x0A or 0x0B), the layout's version (1)",
        ),
        Register::new("control", CONTROL, Kind::Control, 3, "commands"),
        Register::new("status", STATUS, Kind::Status, 3, "where the core is"),
        Register::new("interrupt_enable", INTERRUPT_ENABLE, Kind::InterruptEnable, 1, "what raises `irq`"),
    ];
    let errors = ERRORS.map(|(name, doc)| (name, doc.to_owned(), Kind::Errors));
    let run = RUN_COUNTERS.map(|(name, doc)| (name, doc.to_owned(), Kind::Run));
    let common = (COUNTERS..).step_by(4).zip(errors.into_iter().chain(run));
    let events = events.iter().map(AsRef::as_ref);
    let events = events.map(|name| (name, format!("cycles of the run in which `{name}` was high"), Kind::Run));
    let counters = common.chain((EVENTS..).step_by(4).zip(events));
    map.extend(counters.map(|(address, (name, doc, kind))| Register::new(name, address, kind, 32, doc)));
    map
}

/// The base of something in memory.
fn base(name: &str, address: u32, what: &str) -> Register {
    let doc = format!("address of {what}, a multiple of {BORDER_BYTES}");
    Register::new(name, address, Kind::Setting { multiple: BORDER_BYTES }, 32, doc)
}

/// The registers of the renderer, by address.
#[must_use]
pub fn splat(config: &splat::Config) -> Vec<Register> {
    let mut map = common(SPLAT, &splat::units::events(config));
    map.push(base("buffer_base", SETTINGS, "the reconstruction buffer"));
    let width = config.geometry.width();
    map.extend((UNIFORMS..).step_by(4).zip(fields::<Uniforms>(config)).map(|(address, field)| {
        let doc = format!("uniform `{}`, in {}", field.name, config.uniform_format(&field.name));
        Register::new(&field.name, address, Kind::Uniform, width, doc)
    }));
    map
}

/// The registers of the search core, by address.
#[must_use]
pub fn search(config: &search::Config) -> Vec<Register> {
    let mut map = common(SEARCH, &search::units::events(config));
    map.push(base("points_base", SETTINGS, "the points"));
    if config.tree_cache > 0 {
        map.push(base("tree_base", SETTINGS + 0x4, "the tree"));
    }
    map.push(Register::new("queries", SETTINGS + 0x8, Kind::Queries, 32, "queries of the next run, at least 1"));
    if config.neighbor_cache > 0 {
        let value = Kind::Setting { multiple: 1 };
        let width = config.geometry.width();
        let scale = |name, offset, what: &str| {
            Register::new(name, SETTINGS + offset, value, width, format!("{what}, in {}", config.geometry))
        };
        map.push(Register::new("cache_ball", SETTINGS + 0xc, value, 1, "whether queries are balls (neighbor cache)"));
        map.push(scale("cache_far_scale", 0x10, "factor of the distance to the farthest neighbor"));
        map.push(scale("cache_margin_scale", 0x14, "factor of what is left of it"));
    }
    map
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn registers_lie_apart_where_the_contract_has_them() {
        let b = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
        for map in [splat(&splat::Config::default()), search(&search::Config::default()), search(&b)] {
            assert!(map.is_sorted_by(|a, b| a.address < b.address), "{map:?}");
            assert!(map.iter().all(|register| register.address % 4 == 0 && register.address < 0x1000));
            let names: HashSet<_> = map.iter().map(|register| &register.name).collect();
            assert_eq!(names.len(), map.len());
            let last = map.iter().rfind(|register| matches!(register.kind, Kind::Run)).unwrap();
            assert!(last.address < SETTINGS, "counters run into the settings");
            let address =
                |name: &str| map.iter().find(|register| register.name == name).map(|register| register.address);
            assert_eq!([address("memory_errors"), address("cycles")], [Some(0x20), Some(0x24)]);
            assert_eq!([address("packets_in"), address("packets_out")], [Some(0x28), Some(0x2c)]);
        }
        let map = search(&b);
        let address = |name: &str| map.iter().find(|register| register.name == name).map(|register| register.address);
        assert_eq!(
            [address("event_node"), address("tree_base"), address("queries")],
            [Some(0x40), Some(0x84), Some(0x88)]
        );
        assert_eq!(address("cache_margin_scale"), Some(0x94));
        assert_eq!(map[0].reset(), 0x5043_0b01);
    }
}
