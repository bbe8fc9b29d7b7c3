//! Proofs that a mutant changes nothing that can be seen.
//!
//! Design and mutant run side by side on the same inputs, from all registers zero; ABC searches an invariant under which
//! no output ever differs, or inputs that show a difference. Where a module's streams are known, outputs count when they
//! count in lockstep, and inputs keep the rules of streams. The design's assertions are assumed, as simulations check
//! them: some say what its neighbors never do. Inputs are free otherwise, so a mutant counts even where only inputs show
//! it that no neighbor gives.

mod exhausted;
mod followed;
mod one_reset;
mod planted;
mod search;
mod symbols;
mod versions;
mod way;

use super::MutationError;
use super::campaign::Subject;
use super::modules::{Instance, Modules};
use super::side_by_side::Border;
use crate::synthesis::Tool;
use std::collections::BTreeSet;
use std::fmt;
use way::{Around, NEAR, NEAR_WITH_COMPARISONS, Operators, Way};

/// Bits of a memory that is taken for registers.
const LARGEST_MEMORY_BITS: u32 = 2048;

/// What the names of floating-point operators begin with.
const OPERATORS: &str = "float_";

/// And those that a prover sees through: they shift or compare, and make the same of all that is too small or too large.
const COMPARISONS: [&str; 7] =
    ["float_to_fixed_", "float_convert_", "float_lt_", "float_le_", "float_eq_", "float_min_", "float_max_"];

/// With more text than this, but for operators', a module is a whole core: the prover comes to no end with it.
const LARGEST_BYTES: usize = 120_000;

/// With more text than this, a module is a datapath of its own: it stays out where the fault is elsewhere, and is compared near the
/// fault alone where it is in there.
const LARGEST_MODULE_BYTES: usize = 50_000;

/// What became of a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proof {
    /// No input ever shows a difference.
    Equivalent,
    /// Some inputs show a difference.
    Different,
    /// Neither was found in the time given.
    Open,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Equivalent => "equivalent",
            Self::Different => "differs",
            Self::Open => "undecided",
        })
    }
}

/// Compares a design with its mutant: an operator of one operand on all of them, else first the module that is mutated, whatever
/// the modules in it do, which is small, of a datapath what is near; then with what is in it but large memories and operators, unless
/// that is large; then what surrounds it, likewise, which may hide the difference or keep it from coming about.
pub fn prove(yosys: &Tool, subject: &Subject, mutation: &str, seconds: u32) -> Result<Proof, MutationError> {
    let module = argument(mutation, "-module").unwrap_or(&subject.top);
    let text = format!("{}\n{}", subject.verilog, subject.others);
    let (mutated, cell) = (plain(module), argument(mutation, "-cell"));
    Prover { yosys, subject, mutation, mutated, cell, seconds, modules: Modules::of(&text) }.judge(module)
}

/// What follows an option of a mutation.
fn argument<'a>(mutation: &'a str, name: &str) -> Option<&'a str> {
    mutation.split(' ').skip_while(|word| *word != name).nth(1)
}

/// What the names of cells begin with that are yosys' own, not instances.
const INTERNAL: char = '$';

/// What the names of circular buffers begin with.
const DELAY: &str = "delay_";

/// What yosys calls registers.
const REGISTER: &str = "$procdff";

/// What proofs about one mutant share.
struct Prover<'a> {
    yosys: &'a Tool,
    subject: &'a Subject,
    mutation: &'a str,
    /// The module that is mutated, and the cell in it.
    mutated: &'a str,
    cell: Option<&'a str>,
    seconds: u32,
    modules: Modules<'a>,
}

/// What the prover comes to no end with: a memory of more bits than that is a flood of registers, and operators compute.
fn is_hard(instance: &Instance<'_>) -> bool {
    let is_large_memory = |[width, depth]: [u32; 2]| width * depth > LARGEST_MEMORY_BITS;
    instance.of.starts_with(OPERATORS) || instance.memory_size().is_some_and(is_large_memory)
}

/// What stays out but conversions and comparisons.
fn but_comparisons<'a>(open: &BTreeSet<&'a str>) -> BTreeSet<&'a str> {
    let compares = |inner: &str| COMPARISONS.iter().any(|prefix| inner.starts_with(prefix));
    open.iter().copied().filter(|inner| !compares(inner)).collect()
}

/// What the text calls a module: of one with parameters, yosys' name ends with it.
fn plain(module: &str) -> &str {
    module.rsplit('\\').next().unwrap_or(module)
}

impl Prover<'_> {
    /// Whether nobody sees a difference outside of `module`, or of all that place it.
    fn judge(&self, module: &str) -> Result<Proof, MutationError> {
        let Self { subject, modules, .. } = self;
        let name = plain(module);
        let is_core = |name: &str| subject.core.as_deref() == Some(name);
        let is_mutated = name == self.mutated;
        // Where a port is mutated, the instance may not look at it: what it does shows that. A memory looks at all.
        let has_mutated_port =
            |inner: &Instance<'_>| is_mutated && self.cell == Some(inner.name) && inner.memory_size().is_none();
        let holds_mutated = |inner: &Instance<'_>| modules.within(inner.of, is_core).contains(&self.mutated);
        let inside = modules.inside(name);
        let mutated = inside.iter().filter(|inner| has_mutated_port(inner) || holds_mutated(inner));
        let mutated: BTreeSet<&str> = mutated.map(|inner| inner.of).collect();
        let is_far = |module: &str| !modules.within(module, is_core).contains(&self.mutated);
        let is_datapath = |module: &str| modules.bytes(&[module]) > LARGEST_MODULE_BYTES;
        let computes = |module: &str| is_core(module) || module.starts_with(OPERATORS);
        let (_, hard) = self.parted(name, computes);
        let (within, whole) = self.parted(name, |module| computes(module) || is_datapath(module) && is_far(module));
        let inside: Vec<&str> = inside.iter().map(|inner| inner.of).collect();
        let open: BTreeSet<&str> =
            inside.iter().copied().filter(|inner| is_core(inner) || !mutated.contains(inner)).collect();
        let is_large = |within: &[&str]| is_datapath(name) || modules.bytes(within) > LARGEST_BYTES;
        let is_small = !is_large(&modules.within(name, |inner| open.contains(inner)));
        let exhausted = if is_mutated { self.exhaust(name)? } else { None };
        let mut proof = exhausted.unwrap_or(Proof::Open);
        if proof == Proof::Open && (is_mutated || is_small) {
            // Of a datapath the search takes minutes where it finds nothing.
            let is_followed = || self.is_followed(module, &open);
            let is_first = is_datapath(name);
            if is_first && is_followed()?
                || self.is_hidden_near(module, &open, Operators::Strict)?
                || !is_first && is_followed()?
            {
                return Ok(Proof::Equivalent);
            }
            if is_small {
                proof = self.compare(module, &open)?;
            }
            if proof != Proof::Equivalent && self.is_hidden_near(module, &open, Operators::Tolerant)? {
                return Ok(Proof::Equivalent);
            }
            // What stands in it may have the phases in which it is looked at.
            for operators in [Operators::Strict, Operators::Tolerant] {
                if proof != Proof::Equivalent && open != hard && self.is_hidden_near(module, &hard, operators)? {
                    return Ok(Proof::Equivalent);
                }
            }
            if proof != Proof::Equivalent && self.is_hidden_by_comparisons(module, &open)? {
                return Ok(Proof::Equivalent);
            }
        }
        if proof != Proof::Equivalent && open != whole && !is_large(&within) {
            proof = self.compare(module, &whole)?;
        }
        if proof == Proof::Equivalent || name == subject.top {
            return Ok(proof);
        }
        for outer in modules.around(name) {
            proof = self.judge(outer)?;
            if proof != Proof::Equivalent {
                break;
            }
        }
        Ok(proof)
    }

    /// What stands in a module but what `stays_out`, and what is taken out of it: that, and what is hard.
    fn parted(&self, name: &str, stays_out: impl Fn(&str) -> bool) -> (Vec<&str>, BTreeSet<&str>) {
        let within = self.modules.within(name, &stays_out);
        let placed = within.iter().flat_map(|module| self.modules.inside(module));
        let out = placed.filter(|inner| is_hard(inner) || stays_out(inner.of)).map(|inner| inner.of);
        let out = out.filter(|inner| *inner != self.mutated).collect();
        (within, out)
    }

    /// What yosys calls the mutated cell in a module: around the one that is mutated, where all is one, its name ends so.
    fn name_in(&self, module: &str, cell: &str) -> String {
        if module == self.mutated { cell.to_owned() } else { format!("$flatten*.{cell}") }
    }

    /// The border of a module as the generator knows it.
    fn known(&self, module: &str) -> Option<Border> {
        self.subject.interfaces.iter().find(|interface| interface.name == module).map(Border::from)
    }

    /// The border of a module out of which some were taken, if all of them are known.
    fn border(&self, module: &str, open: &BTreeSet<&str>) -> Option<Border> {
        self.border_without(module, &|_, inner| open.contains(inner))
    }

    /// The same where circular buffers of the module stay in.
    fn border_with_delays(&self, module: &str, open: &BTreeSet<&str>) -> Option<Border> {
        self.border_without(module, &|place, inner| open.contains(inner) && !place.starts_with(DELAY))
    }

    /// The same without some instances, by their place and what they are.
    fn border_without(&self, module: &str, is_out: &dyn Fn(&str, &str) -> bool) -> Option<Border> {
        let mut border = self.known(module)?;
        self.take_out(&mut border, "", module, is_out)?;
        Some(border)
    }

    fn take_out(
        &self,
        border: &mut Border,
        path: &str,
        module: &str,
        is_out: &dyn Fn(&str, &str) -> bool,
    ) -> Option<()> {
        for instance in self.modules.inside(module) {
            let place = format!("{path}{}", instance.name);
            if is_out(&place, instance.of) {
                let inner = self.known(instance.of).or_else(|| Border::memory(&instance))?;
                border.take_out(&place, &inner);
            } else {
                self.take_out(border, &format!("{place}."), instance.of, is_out)?;
            }
        }
        Some(())
    }

    /// Compares a module of the design with its mutant, whatever the `open` ones in it do. The proof is easiest where operators are given the
    /// same at all times; where they are not, it may be that their answers do not count.
    fn compare(&self, module: &str, open: &BTreeSet<&str>) -> Result<Proof, MutationError> {
        let tolerant = self.border(plain(module), open);
        let strict = tolerant.as_ref().map(Border::without_operators);
        let mut proof = self.compare_as(module, open, Way::At(strict.as_ref()))?;
        let mut border = strict.as_ref();
        if let Some(tolerant) =
            tolerant.as_ref().filter(|tolerant| proof != Proof::Equivalent && tolerant.has_operators())
        {
            proof = self.compare_as(module, open, Way::At(Some(tolerant)))?;
            border = Some(tolerant);
        }
        if proof == Proof::Open && self.cell.is_some() && one_reset::has_reset(&self.subject.verilog, plain(module)) {
            proof = self.compare_as(module, open, Way::InTurns(border.map(Border::after_reset).as_ref()))?;
        }
        Ok(proof)
    }

    /// Whether no register near the fault shows a difference where it is looked at: whatever operators do, or as what they are
    /// given says. A register that inverts a bit may also begin with it the other way.
    fn is_hidden_near(&self, module: &str, open: &BTreeSet<&str>, operators: Operators) -> Result<bool, MutationError> {
        self.is_hidden_within(module, open, operators, NEAR)
    }

    /// The same with conversions and comparisons as they are, if any were to stay out.
    fn is_hidden_by_comparisons(&self, module: &str, open: &BTreeSet<&str>) -> Result<bool, MutationError> {
        let without = but_comparisons(open);
        for operators in [Operators::Strict, Operators::Tolerant] {
            if without != *open && self.is_hidden_within(module, &without, operators, NEAR_WITH_COMPARISONS)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The same for registers of which so many are near.
    fn is_hidden_within(
        &self,
        module: &str,
        open: &BTreeSet<&str>,
        operators: Operators,
        near: usize,
    ) -> Result<bool, MutationError> {
        let Some(cell) = self.cell else { return Ok(false) };
        // An instance's other ports lead elsewhere.
        let cell = cell.starts_with(INTERNAL).then(|| self.name_in(plain(module), cell));
        let has_operators = self.border(plain(module), open).is_some_and(|border| border.has_operators());
        if operators == Operators::Tolerant && !has_operators {
            return Ok(false);
        }
        for begins_set in [false, true] {
            let around = Way::Around(Around { cell: cell.as_deref(), operators, near, begins_set });
            let is_tried = !begins_set || cell.as_ref().is_some_and(|cell| cell.contains(REGISTER));
            if is_tried && self.compare_as(module, open, around)? == Proof::Equivalent {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the border of a module that has a reset shows no difference from there on, with conversions and comparisons as they
    /// are.
    fn is_followed(&self, module: &str, open: &BTreeSet<&str>) -> Result<bool, MutationError> {
        if self.cell.is_none() || !one_reset::has_reset(&self.subject.verilog, plain(module)) {
            return Ok(false);
        }
        let open = but_comparisons(open);
        let border = self.border_with_delays(plain(module), &open).as_ref().map(Border::after_reset);
        Ok(self.compare_as(module, &open, Way::Followed(border.as_ref()))? == Proof::Equivalent)
    }
}

#[cfg(test)]
mod tests;
