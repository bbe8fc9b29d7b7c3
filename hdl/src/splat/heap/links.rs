//! What the stages of the heap hold and tell each other, as records.

use pointcore_contract::splat::Config;
use pointcore_contract::{Places, Record, fields, places, record};

use super::order::EntryFormat;
use crate::units::wires::{Bundle, Wired};
use rtl::{Expr, Module, Reg};

/// Where a stage stands in the heap.
///
/// The root is node 1, the children of node `n` are `2n` and `2n + 1`, and row `n` of a memory holds one of them.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub format: EntryFormat,
    pub levels: u32,
    /// The upper one of its levels, the root's being 0.
    pub upper: u32,
}

impl Place {
    pub fn new(config: &Config, format: EntryFormat, upper: u32) -> Self {
        Self { format, levels: config.heap_levels, upper }
    }

    /// Bits of the rows that the stage reads, which are the numbers of the parents.
    pub const fn row_bits(self) -> u32 {
        self.upper + 1
    }

    /// Nodes of the upper level have children.
    pub const fn has_lower(self) -> bool {
        self.upper + 1 < self.levels
    }

    /// Nodes of the lower level have children.
    pub const fn continues(self) -> bool {
        self.upper + 2 < self.levels
    }

    /// Bits of the count of entries on the left below a node of the upper level.
    const fn count_bits(self) -> u32 {
        self.levels - 1 - self.upper
    }
}

/// What lies below a node.
#[record(place: Place)]
pub(super) struct Below {
    /// There is an entry on the right.
    right_below: bool,
    /// How many there are on the left.
    #[bits(place.count_bits())]
    left_count: u32,
}

/// A stored node.
#[record(place: Place)]
pub(super) struct Node {
    /// Its entry.
    #[bits(place.format.width())]
    entry: u64,
    /// The parity of both children's marks says which of them is first.
    mark: bool,
    /// What lies below it, where anything can.
    #[when(place.has_lower())]
    below: Below,
}

/// What a step brings to a level, where it meets the two children of a parent.
#[record(place: Place)]
pub(super) struct Step {
    /// There is one.
    valid: bool,
    /// The parent's entry is gone: the first of the children and the carried entry takes its place.
    /// Otherwise the carried entry is inserted below the parent.
    hole: bool,
    /// An entry is carried, as by every insertion.
    carry: bool,
    /// Where an insertion goes on.
    right: bool,
    /// The parent has a left child.
    left_exists: bool,
    /// The parent has a right child.
    right_exists: bool,
    /// The step before this one came by here if it came that deep.
    follows: bool,
    /// The carried entry.
    #[bits(place.format.width())]
    entry: u64,
    /// The key of the parent's sibling.
    #[bits(place.format.key_width())]
    sibling: u64,
}

/// What a level promotes in the step it compares, to the level above, where the step writes back.
#[record(place: Place)]
pub(super) struct Promotion {
    /// The first of the chosen child and the carried entry.
    #[bits(place.format.width())]
    entry: u64,
    /// The chosen child exists, and leaves before its parent's sibling.
    ahead: bool,
    /// It is the right one.
    right: bool,
    /// It has no children.
    childless: bool,
}

/// A step that compares, as the memories have shown it.
#[record(place: Place)]
pub(super) struct Compared {
    /// There is one.
    valid: bool,
    /// See [`Step`].
    hole: bool,
    /// See [`Step`].
    carry: bool,
    /// See [`Step`].
    follows: bool,
    /// The carried entry.
    #[bits(place.format.width())]
    carried: u64,
    /// The chosen child exists.
    exists: bool,
    /// It is the right one.
    right: bool,
    /// It was the first of both.
    was_first: bool,
    /// The key of the parent's sibling.
    #[bits(place.format.key_width())]
    parent_sibling: u64,
    /// The node stored in the cycle before is the chosen child, newer than what the memories have shown.
    chosen_stored: bool,
    /// It is the sibling.
    sibling_stored: bool,
    /// The sibling's key.
    #[bits(place.format.key_width())]
    sibling: u64,
    /// There is a sibling.
    sibling_exists: bool,
    /// Its mark.
    sibling_mark: bool,
    /// The chosen child's entry.
    #[bits(place.format.width())]
    entry: u64,
    /// What lies below it, where anything can.
    #[when(place.has_lower())]
    below: Below,
}

/// A step that writes back.
#[record(place: Place)]
pub(super) struct WriteBack {
    /// There is one.
    valid: bool,
    /// See [`Step`].
    hole: bool,
    /// See [`Step`].
    carry: bool,
    /// The chosen child existed.
    existed: bool,
    /// What is known to take the chosen child's place leaves before the sibling.
    ahead: bool,
    /// There is a sibling.
    sibling_exists: bool,
    /// Its mark.
    sibling_mark: bool,
    /// What stays in the chosen child's place, or fills a hole where nothing lies below.
    #[bits(place.format.width())]
    entry: u64,
    /// What lies below that place, where anything can.
    #[when(place.has_lower())]
    below: Below,
}

/// A tick of the heap, in which an operation passes a level and of which it takes two: one cycle, or two for a higher clock.
pub(super) enum Pace {
    Cycle,
    /// Set in the second cycle.
    TwoCycles(Expr),
}

impl Pace {
    /// Every module of the heap counts for itself, so that no wire has to reach all of it.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        if config.heap_interval == 2 {
            return Self::Cycle;
        }
        // A tick ends in the first cycle after reset.
        let ends = m.reg_reset("ends", 1, 1);
        m.next(ends, !ends);
        Self::TwoCycles(ends.expr())
    }

    /// Set in every other tick, not in the first.
    pub fn lower(&self, m: &mut Module) -> Expr {
        let lower = m.reg_reset("lower", 1, 0);
        self.next(m, lower, !lower);
        lower.expr()
    }

    /// `value` in the last cycle of a tick.
    pub fn at_end(&self, value: Expr) -> Expr {
        match self {
            Self::Cycle => value,
            Self::TwoCycles(ends) => *ends & value,
        }
    }

    /// The register takes `value` when the tick ends.
    pub fn next(&self, m: &mut Module, register: Reg, value: impl Into<Expr>) {
        let value = value.into();
        match self {
            Self::Cycle => m.next(register, value),
            Self::TwoCycles(ends) => m.next_if(register, *ends, value),
        }
    }

    /// What the first cycle of a tick finds, for use when it ends.
    pub fn found(&self, m: &mut Module, name: &str, value: impl Into<Expr>) -> Expr {
        let value = value.into();
        match self {
            Self::Cycle => value,
            Self::TwoCycles(_) => {
                let register = m.reg(&format!("{name}_found"), value.width());
                m.next(register, value);
                register.expr()
            }
        }
    }
}

/// Registers that take new values once a tick.
pub(super) struct Registers<R: Record> {
    registers: Vec<Reg>,
    /// What they hold.
    pub record: Wired<R>,
}

impl<R: Record> Registers<R> {
    /// Registers `<prefix><field>`; the flag that says whether the others matter is reset.
    pub fn new(
        m: &mut Module,
        config: &R::Config,
        prefix: &str,
        flag: impl FnOnce(R::In<Places>) -> Option<usize>,
    ) -> Self {
        let flag = flag(places::<R>(config));
        let registers: Vec<_> = (0..)
            .zip(fields::<R>(config))
            .map(|(place, field)| {
                let name = format!("{prefix}{}", field.name);
                if Some(place) == flag { m.reg_reset(&name, 1, 0) } else { m.reg(&name, field.width) }
            })
            .collect();
        let record = Bundle::from_values(config, registers.iter().map(|register| register.expr()));
        Self { registers, record }
    }

    /// States what they take when the tick ends.
    pub fn next(&self, m: &mut Module, config: &R::Config, pace: &Pace, record: Wired<R>) {
        for (register, value) in self.registers.iter().zip(record.values(config)) {
            pace.next(m, *register, value);
        }
    }
}
