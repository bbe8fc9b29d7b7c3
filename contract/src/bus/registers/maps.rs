//! The register maps of the cores.

use super::{
    CONTROL, COUNTERS, ERRORS, EVENTS, ID, INTERRUPT_ENABLE, RUN_COUNTERS, Register, RegisterKind, RunCounter,
    SETTINGS, STATUS, UNIFORMS, When,
};
use crate::bus::config::{BORDER_BYTES, REGISTER_BITS};
use crate::process::Scalar;
use crate::process::config::{ITERATION_BITS, WORDS_MAX};
use crate::record::{Domain, Visitor, Word};
use crate::splat::records::{Uniforms, uniform_formats};
use crate::{Field, Format, Record, Visit, Words, fields, points, record, search, splat};

/// "PC", in the upper half of `id`.
const SIGNATURE: u32 = 0x5043;
/// Version of the layout of registers and packets.
const VERSION: u32 = 1;
/// The cores' bytes in `id`.
const SPLAT: u32 = 0x0a;
const SEARCH: u32 = 0x0b;
const POINTS: u32 = 0x0c;
/// Where the settings of the point processor begin, behind those of the others: it has more events.
const POINTS_OFFSET: u32 = 0x40;
/// Where its program's settings begin.
const PROGRAM_OFFSET: u32 = UNIFORMS - SETTINGS;

/// A core as its registers meet it.
pub trait RegisterMap {
    /// What the map depends on.
    type Config;
    /// What the registers hold for the core, in the order of the map.
    type Settings: Record<Domain = Words, Config = Self::Config>;
    /// What they count for it, in the order of the map.
    type Events: Record<Domain = Words, Config = Self::Config>;

    /// When `start` may be written.
    const STARTS: When;

    /// The registers by address.
    #[must_use]
    fn registers(config: &Self::Config) -> Vec<Register>;
}

/// The terms of maps: of each setting, what its register is.
#[derive(Clone, Copy, Debug, Default)]
pub struct MapEntries;

impl Domain for MapEntries {
    type Bits<W: Word> = Option<MapEntry>;
}

/// What a setting's register is, beside what its record says.
#[derive(Clone, Copy, Debug)]
pub struct MapEntry {
    /// Bytes behind the first setting.
    pub offset: u32,
    /// What it is.
    pub kind: RegisterKind,
    /// The format of its number, if it holds one.
    pub format: Option<Format>,
}

impl MapEntry {
    /// The base of something in memory.
    #[must_use]
    pub const fn base(offset: u32) -> Option<Self> {
        Some(Self { offset, kind: RegisterKind::Setting { multiple: BORDER_BYTES }, format: None })
    }

    /// Any value.
    #[must_use]
    pub const fn value(offset: u32) -> Option<Self> {
        Some(Self { offset, kind: RegisterKind::Setting { multiple: 1 }, format: None })
    }

    /// Any number of a format.
    #[must_use]
    pub const fn number(offset: u32, format: Format) -> Option<Self> {
        Some(Self { offset, kind: RegisterKind::Setting { multiple: 1 }, format: Some(format) })
    }

    /// A number from `low` to `high`.
    #[must_use]
    pub const fn within(offset: u32, low: u32, high: u32) -> Option<Self> {
        Some(Self { offset, kind: RegisterKind::Range { low, high }, format: None })
    }

    /// A number of a format that is neither negative nor NaN.
    #[must_use]
    pub const fn positive(offset: u32, format: Format) -> Option<Self> {
        let kind = RegisterKind::Range { low: 0, high: format.infinity() as u32 };
        Some(Self { offset, kind, format: Some(format) })
    }

    /// The number of queries of a run.
    #[must_use]
    pub const fn queries(offset: u32) -> Option<Self> {
        Some(Self { offset, kind: RegisterKind::Queries, format: None })
    }

    fn register(self, field: &Field) -> Register {
        let doc = clause(field.doc);
        let doc = match (self.kind, self.format) {
            (RegisterKind::Queries, _) => format!("{doc}, at least 1"),
            (RegisterKind::Setting { multiple: 2.. }, _) => format!("{doc}, a multiple of {BORDER_BYTES}"),
            (RegisterKind::Range { .. }, Some(format)) => format!("{doc}, in {format}, from zero to infinity"),
            (RegisterKind::Range { low, high }, None) => format!("{doc}, {low} to {high}"),
            (_, Some(format)) => format!("{doc}, in {format}"),
            _ => doc,
        };
        Register::new(&field.name, SETTINGS + self.offset, self.kind, field.width, doc)
    }
}

/// A sentence as a part of another.
fn clause(sentence: &str) -> String {
    let mut letters = sentence.trim_end_matches('.').chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

/// Collects the entries of a record.
struct Collector(Vec<MapEntry>);

impl Visitor<MapEntries> for Collector {
    fn bits<W: Word>(&mut self, entry: &mut Option<MapEntry>) {
        self.0.push(entry.expect("a map says of every setting what it is"));
    }
}

/// The registers of settings, in their order.
///
/// # Panics
/// When a setting of the layout has no entry.
pub fn settings<R: Record>(config: &R::Config, mut entries: R::In<MapEntries>) -> impl Iterator<Item = Register> {
    let mut collector = Collector(vec![]);
    entries.visit(config, &mut collector);
    fields::<R>(config).into_iter().zip(collector.0).map(|(field, entry)| entry.register(&field))
}

/// What every map begins with: identity to counters.
#[must_use]
pub fn common(identity: u32, starts: When, events: &[Field]) -> Vec<Register> {
    let with_bits = |name, address, kind, doc| {
        let register = Register::new(name, address, kind, 0, doc);
        Register { width: register.bits().len() as u32, ..register }
    };
    let mut map = vec![
        Register::new(
            "id",
            ID,
            RegisterKind::Identity(identity),
            32,
            "\"PC\", the core (0x0A, 0x0B or 0x0C), the layout's version (1)",
        ),
        with_bits("control", CONTROL, RegisterKind::Control(starts), "commands"),
        with_bits("status", STATUS, RegisterKind::Status(starts), "where the core is"),
        with_bits("interrupt_enable", INTERRUPT_ENABLE, RegisterKind::InterruptEnable, "what raises `irq`"),
    ];
    let errors = ERRORS.map(|(counter, name, doc)| (name, doc.to_owned(), RegisterKind::Errors(counter)));
    let run = RUN_COUNTERS.map(|(counter, name, doc)| (name, doc.to_owned(), RegisterKind::Run(counter)));
    let common = (COUNTERS..).step_by(4).zip(errors.into_iter().chain(run));
    let events = events.iter().enumerate().map(|(place, Field { name, width, .. })| {
        let doc = match width {
            1 => format!("cycles of the run in which `{name}` was high"),
            _ => format!("sum of `{name}` over the cycles of the run"),
        };
        (name.as_str(), doc, RegisterKind::Run(RunCounter::Event(place)))
    });
    let counters = common.chain((EVENTS..).step_by(4).zip(events));
    map.extend(counters.map(|(address, (name, doc, kind))| Register::new(name, address, kind, 32, doc)));
    map
}

const fn identity(core: u32) -> u32 {
    SIGNATURE << 16 | core << 8 | VERSION
}

/// The registers of the renderer.
#[derive(Clone, Copy, Debug)]
pub struct SplatRegisters;

/// What the registers hold for the renderer.
#[record(config: splat::Config)]
pub struct SplatSettings {
    /// Address of the reconstruction buffer.
    #[bits(REGISTER_BITS)]
    pub buffer_base: u32,
    /// Address of the payloads.
    #[when(config.has_payloads_in_memory())]
    #[bits(REGISTER_BITS)]
    pub payload_base: u32,
    /// Address of the depths that fragments are tested against, or samples of what moves.
    #[when(config.merge.is_on())]
    #[bits(REGISTER_BITS)]
    pub depth_base: u32,
}

impl RegisterMap for SplatRegisters {
    type Config = splat::Config;
    type Settings = SplatSettings;
    type Events = splat::units::Events;

    const STARTS: When = When::Ahead;

    fn registers(config: &splat::Config) -> Vec<Register> {
        let mut map = common(identity(SPLAT), Self::STARTS, &fields::<Self::Events>(config));
        map.extend(settings::<SplatSettings>(
            config,
            SplatSettings {
                buffer_base: MapEntry::base(0),
                payload_base: MapEntry::base(0x4),
                depth_base: MapEntry::base(0x8),
            },
        ));
        let width = config.geometry.width();
        let uniforms = fields::<Uniforms>(config).into_iter().zip(uniform_formats(config));
        map.extend((UNIFORMS..).step_by(4).zip(uniforms).map(|(address, (field, format))| {
            let doc = format!("uniform `{}`, in {format}", field.name);
            Register::new(&field.name, address, RegisterKind::Uniform, width, doc)
        }));
        map
    }
}

/// The registers of the search core.
#[derive(Clone, Copy, Debug)]
pub struct SearchRegisters;

/// What the registers hold for the search core.
#[record(config: search::Config)]
pub struct SearchSettings {
    /// Address of the points.
    #[bits(REGISTER_BITS)]
    pub points_base: u32,
    /// Address of the tree.
    #[when(config.tree_cache > 0)]
    #[bits(REGISTER_BITS)]
    pub tree_base: u32,
    /// Queries of the next run.
    #[bits(REGISTER_BITS)]
    pub queries: u32,
    /// Whether queries are balls (neighbor cache).
    #[when(config.neighbor_cache > 0)]
    pub cache_ball: bool,
    /// Factor of the distance to the farthest neighbor.
    #[when(config.neighbor_cache > 0)]
    #[bits(config.geometry.width())]
    pub cache_far_scale: u32,
    /// Factor of what is left of it.
    #[when(config.neighbor_cache > 0)]
    #[bits(config.geometry.width())]
    pub cache_margin_scale: u32,
}

impl RegisterMap for SearchRegisters {
    type Config = search::Config;
    type Settings = SearchSettings;
    type Events = search::units::Events;

    const STARTS: When = When::Idle;

    fn registers(config: &search::Config) -> Vec<Register> {
        let entries = SearchSettings {
            points_base: MapEntry::base(0),
            tree_base: MapEntry::base(0x4),
            queries: MapEntry::queries(0x8),
            cache_ball: MapEntry::value(0xc),
            cache_far_scale: MapEntry::number(0x10, config.geometry),
            cache_margin_scale: MapEntry::number(0x14, config.geometry),
        };
        let mut map = common(identity(SEARCH), Self::STARTS, &fields::<Self::Events>(config));
        map.extend(settings::<SearchSettings>(config, entries));
        map
    }
}

/// The registers of the point processor.
#[derive(Clone, Copy, Debug)]
pub struct PointsRegisters;

/// What the registers hold for the point processor.
#[record(config: points::Config)]
pub struct PointsSettings {
    /// Address of the positions, as the search reads them.
    #[bits(REGISTER_BITS)]
    pub points_base: u32,
    /// Address of the tree.
    #[when(config.search.tree_cache > 0)]
    #[bits(REGISTER_BITS)]
    pub tree_base: u32,
    /// Address of the points, as the program reads them.
    #[bits(REGISTER_BITS)]
    pub lines_base: u32,
    /// Queries of the next run.
    #[bits(REGISTER_BITS)]
    pub queries: u32,
    /// Neighbors wanted.
    #[bits(config.search.rank_bits())]
    pub k: u8,
    /// Squared radius within which neighbors count.
    #[bits(config.search.geometry.width())]
    pub radius2: u32,
    /// Radius within which a neighborhood must be complete to be reused: 0 for k nearest neighbors, the radius of balls.
    #[when(config.search.neighbor_cache > 0)]
    #[bits(config.search.geometry.width())]
    pub reach: u32,
    /// Whether neighborhoods are balls (neighbor cache).
    #[when(config.search.neighbor_cache > 0)]
    pub cache_ball: bool,
    /// Factor of the distance to the farthest neighbor.
    #[when(config.search.neighbor_cache > 0)]
    #[bits(config.search.geometry.width())]
    pub cache_far_scale: u32,
    /// Factor of what is left of it.
    #[when(config.search.neighbor_cache > 0)]
    #[bits(config.search.geometry.width())]
    pub cache_margin_scale: u32,
    /// Iterations of a query at most.
    #[bits(ITERATION_BITS)]
    pub iterations_max: u16,
    /// A constant of the program.
    #[count(config.process.program.settings.len())]
    #[name(format!("setting_{}", config.process.program.settings.words()[i].name))]
    #[bits(config.process.word_bits(config.process.program.settings.words()[i].ty))]
    pub program: [u32; WORDS_MAX],
}

impl RegisterMap for PointsRegisters {
    type Config = points::Config;
    type Settings = PointsSettings;
    type Events = points::units::Events;

    const STARTS: When = When::Idle;

    fn registers(config: &points::Config) -> Vec<Register> {
        let geometry = config.search.geometry;
        let at = |place: u32| POINTS_OFFSET + 4 * place;
        let types: Vec<_> = config.process.program.settings.words().into_iter().map(|word| word.ty).collect();
        let constant = |place: usize| {
            let offset = PROGRAM_OFFSET + 4 * place as u32;
            match types.get(place) {
                Some(Scalar::Float) => MapEntry::number(offset, geometry),
                _ => MapEntry::value(offset),
            }
        };
        let entries = PointsSettings {
            points_base: MapEntry::base(at(0)),
            tree_base: MapEntry::base(at(1)),
            lines_base: MapEntry::base(at(2)),
            queries: MapEntry::queries(at(3)),
            k: MapEntry::within(at(4), 1, config.search.neighbors),
            radius2: MapEntry::positive(at(5), geometry),
            reach: MapEntry::positive(at(6), geometry),
            cache_ball: MapEntry::value(at(7)),
            cache_far_scale: MapEntry::number(at(8), geometry),
            cache_margin_scale: MapEntry::number(at(9), geometry),
            iterations_max: MapEntry::within(at(10), 1, u16::MAX as u32),
            program: std::array::from_fn(constant),
        };
        let mut map = common(identity(POINTS), Self::STARTS, &fields::<Self::Events>(config));
        map.extend(settings::<PointsSettings>(config, entries));
        map
    }
}
