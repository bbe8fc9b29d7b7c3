//! Two versions side by side, followed from their reset on.
//!
//! In each cycle a register is zero, one, or holds a symbol that others may hold, too, or its opposite. Inputs are symbols of their
//! own in every cycle. From these follows what registers hold a cycle later; what is not a constant then becomes a symbol. So
//! phases stay numbers, and a bit that was inverted stays the opposite of what it was, until it is inverted again or looked at.
//! Once registers hold what they held before, all cycles have been seen. No invariant is searched for.

use super::Proof;
use super::symbols::{FALSE, Literal, Symbols};
use crate::mutation::side_by_side::VERSIONS;
use flussab_aiger::aig::{OrderedAig, SymbolTarget};
use flussab_aiger::binary::{Config, Parser};
use rustc_hash::FxHashMap;
use std::collections::HashMap;
use std::fs::File;
use std::io;
use std::path::Path;
use std::time::{Duration, Instant};

/// A circular buffer as a shift register: what it is given comes out after as many steps as it has places.
pub(super) const DELAYS: &str = include_str!("delays.v");

/// Both versions, with an output that says whether they differ.
struct Miter {
    aig: OrderedAig<u32>,
    /// The registers of both that have the same name.
    pairs: Vec<[usize; 2]>,
}

impl Miter {
    fn read(path: &Path) -> io::Result<Self> {
        let parsed = Parser::from_read(File::open(path)?, Config::default()).and_then(Parser::parse);
        let aig: OrderedAig<u32> = parsed.map_err(|error| io::Error::other(error.to_string()))?;
        let latches = aig.symbols.iter().filter_map(|symbol| match symbol.target {
            SymbolTarget::Latch(latch) => Some((&*symbol.name, latch)),
            _ => None,
        });
        let latches: HashMap<&str, usize> = latches.collect();
        let pair = |(name, &first): (&&str, &usize)| {
            let [gold, gate] = VERSIONS.map(|version| format!("{version}."));
            let rest = name.strip_prefix(&*gold)?;
            Some([first, *latches.get(&*format!("{gate}{rest}"))?])
        };
        let pairs = latches.iter().filter_map(pair).collect();
        Ok(Self { aig, pairs })
    }

    /// What registers hold after a cycle, and what says whether both versions differ in it.
    fn step(&self, symbols: &mut Symbols, state: &[Literal]) -> (Vec<Literal>, Literal) {
        let Self { aig, .. } = self;
        let mut literals = vec![FALSE];
        literals.extend((0..aig.input_count).map(|_| symbols.fresh()));
        literals.extend(state);
        let of = |literals: &[Literal], code: u32| literals[code as usize / 2] ^ (code & 1);
        for gate in &aig.and_gates {
            let [a, b] = gate.inputs.map(|input| of(&literals, input));
            literals.push(symbols.and(a, b));
        }
        let next = aig.latches.iter().map(|latch| of(&literals, latch.next_state)).collect();
        (next, of(&literals, aig.outputs[0]))
    }

    /// Has both versions of a register hold one, if they hold the same.
    fn unite(&self, symbols: &Symbols, state: &mut [Literal]) {
        for &[gold, gate] in &self.pairs {
            if symbols.are_same(state[gold], state[gate]) {
                state[gate] = state[gold];
            }
        }
    }

    /// The same registers, with a symbol for each that is not a constant: one for those that hold one.
    fn forget(symbols: &mut Symbols, state: &mut [Literal]) {
        *symbols = Symbols::new();
        let mut known = FxHashMap::from_iter([(FALSE, FALSE)]);
        for literal in state {
            let sign = *literal & 1;
            *literal = sign ^ *known.entry(*literal & !1).or_insert_with(|| symbols.fresh() | sign);
        }
    }

    /// Whether they never differ, as far as is seen where registers are forgotten in every turn of so many cycles, after the cycle
    /// `last` of it; and how many cycles there are until all comes again, which is looked for in turns of one even if they do.
    fn follow(&self, turn: u64, last: u64, end: Instant) -> (Proof, u64) {
        let mut state = vec![FALSE; self.aig.latches.len()];
        let mut symbols = Symbols::new();
        let mut before = (0, state.clone());
        let mut proof = Proof::Equivalent;
        for cycle in 0_u64.. {
            let (next, differ) = self.step(&mut symbols, &state);
            state = next;
            // The first cycle is the reset. Once they differ, nothing of it is asked any more.
            if cycle > 0 && proof == Proof::Equivalent && !symbols.is_never(differ) {
                proof = Proof::Open;
            }
            if (turn > 1 && proof == Proof::Open) || Instant::now() > end {
                break;
            }
            if cycle % turn != last {
                continue;
            }
            if proof == Proof::Equivalent {
                self.unite(&symbols, &mut state);
            }
            Self::forget(&mut symbols, &mut state);
            if state == before.1 {
                return (proof, cycle - before.0);
            }
            if (cycle / turn).is_power_of_two() {
                before = (cycle, state.clone());
            }
        }
        (Proof::Open, 1)
    }
}

/// Whether the miter in a file never says that both differ.
pub(super) fn follow(path: &Path, limit: Duration) -> io::Result<Proof> {
    let miter = Miter::read(path)?;
    let end = Instant::now() + limit;
    let (mut proof, turn) = miter.follow(1, 0, end);
    // What is inverted on a condition has no symbol, but within a turn it is known by the condition.
    for last in 0..turn {
        if turn == 1 || proof == Proof::Equivalent {
            break;
        }
        (proof, _) = miter.follow(turn, last, end);
    }
    Ok(proof)
}
