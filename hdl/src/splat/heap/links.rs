//! What the stages of the heap hold and tell each other, as records.

use pointcore_contract::splat::{Config, Field};

use super::order::EntryFormat;
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

    /// A stored node: an entry, its mark, and what lies below it where anything can.
    pub fn node(self) -> Vec<Field> {
        let mut node = fields(&[("entry", self.format.width()), ("mark", 1)]);
        node.extend(self.below());
        node
    }

    /// Whether there is an entry on the right below a node, and how many there are on the left.
    fn below(self) -> Vec<Field> {
        let bits = self.levels - 1 - self.upper;
        if self.has_lower() { fields(&[("right_below", 1), ("left_count", bits)]) } else { vec![] }
    }

    /// What a step brings to a level, where it meets the two children of a parent.
    pub fn step(self) -> Vec<Field> {
        fields(&[
            ("valid", 1),
            // The parent's entry is gone: the first of the children and the carried entry takes its place.
            // Otherwise the carried entry is inserted below the parent.
            ("hole", 1),
            // An entry is carried, as by every insertion.
            ("carry", 1),
            // Where an insertion goes on.
            ("right", 1),
            ("left_exists", 1),
            ("right_exists", 1),
            // The step before this one came by here if it came that deep.
            ("follows", 1),
            ("entry", self.format.width()),
            // The key of the parent's rival.
            ("rival", self.format.key_width()),
        ])
    }

    /// What a level says of the step it compares, to the level above, where the step settles.
    pub fn rise(self) -> Vec<Field> {
        fields(&[
            // The first of the chosen child and the carried entry.
            ("entry", self.format.width()),
            // The chosen child exists, and it leaves before its parent's rival.
            ("exists", 1),
            ("ahead", 1),
            ("right", 1),
            ("childless", 1),
        ])
    }

    /// A step that compares, as the memories have shown it.
    pub fn compared(self) -> Vec<Field> {
        let mut compared = fields(&[
            ("valid", 1),
            ("hole", 1),
            ("carry", 1),
            ("follows", 1),
            ("carried", self.format.width()),
            ("exists", 1),
            ("right", 1),
            // The chosen child was the first of both.
            ("was_first", 1),
            ("parent_rival", self.format.key_width()),
            // The node stored in the cycle before is newer than what the memories have shown.
            ("chosen_stored", 1),
            ("rival_stored", 1),
            ("rival", self.format.key_width()),
            ("rival_exists", 1),
            ("rival_mark", 1),
            ("entry", self.format.width()),
        ]);
        compared.extend(self.below());
        compared
    }

    /// A step that settles.
    pub fn settled(self) -> Vec<Field> {
        let mut settled = fields(&[
            ("valid", 1),
            ("hole", 1),
            ("carry", 1),
            ("existed", 1),
            // What is known to take the chosen child's place leaves before the rival.
            ("ahead", 1),
            ("rival_exists", 1),
            ("rival_mark", 1),
            ("entry", self.format.width()),
        ]);
        settled.extend(self.below());
        settled
    }
}

fn fields(widths: &[(&str, u32)]) -> Vec<Field> {
    widths.iter().map(|(name, width)| ((*name).to_owned(), (*width))).collect()
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
pub(super) struct Registers(Vec<(String, Reg)>);

impl Registers {
    /// Registers `<prefix><field>`; the field `valid` is reset.
    pub fn new(m: &mut Module, prefix: &str, fields: &[Field]) -> Self {
        let mut register = |name: &str, width: u32| {
            let full = format!("{prefix}{name}");
            if name == "valid" { m.reg_reset(&full, 1, 0) } else { m.reg(&full, width) }
        };
        Self(fields.iter().map(|(name, width)| (name.clone(), register(name, *width))).collect())
    }

    pub fn get(&self, name: &str) -> Expr {
        let field = self.0.iter().find(|(field, _)| field == name);
        field.map(|(_, register)| register.expr()).expect("stages ask for registers of their own")
    }

    pub fn next(&self, m: &mut Module, pace: &Pace, mut value: impl FnMut(&str) -> Expr) {
        for (name, register) in &self.0 {
            pace.next(m, *register, value(name));
        }
    }
}
