//! Two versions side by side, followed from their reset on.
//!
//! In each cycle a register is zero, one, or holds a symbol that others may hold, too, or its opposite. Inputs are symbols of their
//! own in every cycle. From these follows what registers hold a cycle later; what is not a constant then becomes a symbol. So
//! phases stay numbers, and a bit that was inverted stays the opposite of what it was, until it is inverted again or looked at.
//! Where both versions of a register differ only while others near it are one, it stays so. Once registers hold what they held
//! before, all cycles have been seen. No invariant is searched for.

use super::Proof;
use super::symbols::{FALSE, Literal, Symbols};
use crate::mutation::side_by_side::VERSIONS;
use flussab_aiger::aig::{OrderedAig, SymbolTarget};
use flussab_aiger::binary::{Config, Parser};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io;
use std::path::Path;
use std::rc::Rc;
use std::time::{Duration, Instant};

/// A circular buffer as a shift register: what it is given comes out after as many steps as it has places.
pub(super) const DELAYS: &str = include_str!("delays.v");

/// With more registers than this, a word or an operator is not one place.
const LARGEST_PLACE: usize = 200;

/// A register of both versions.
struct Pair {
    gold: usize,
    gate: usize,
    /// The first version's registers of the same word, or in the same operator.
    near: Rc<[usize]>,
}

/// Under which conditions both versions of a register differ: other registers that are one then, or with the sign zero.
type Conditions = BTreeMap<usize, Vec<(usize, Literal)>>;

/// Both versions, with an output that says whether they differ.
struct Miter {
    aig: OrderedAig<u32>,
    pairs: Vec<Pair>,
    /// Registers that are of no pair, or of the first version.
    others: Vec<usize>,
}

/// The operator that a register stands in, or else its word.
fn place(name: &str) -> &str {
    match name.split_once('.') {
        Some((instance, register)) if !register.starts_with("steps") => instance,
        _ => name.split('[').next().unwrap_or(name),
    }
}

impl Miter {
    fn read(path: &Path) -> io::Result<Self> {
        let parsed = Parser::from_read(File::open(path)?, Config::default()).and_then(Parser::parse);
        let aig: OrderedAig<u32> = parsed.map_err(|error| io::Error::other(error.to_string()))?;
        let latches = aig.symbols.iter().filter_map(|symbol| match symbol.target {
            // It goes by the first of its names.
            SymbolTarget::Latch(latch) => Some((symbol.name.split(' ').next()?, latch)),
            _ => None,
        });
        let latches: HashMap<&str, usize> = latches.collect();
        let [first, second] = VERSIONS.map(|version| format!("{version}."));
        let mut named = Vec::new();
        for (name, &gold) in &latches {
            let Some(name) = name.strip_prefix(&*first) else { continue };
            let Some(&gate) = latches.get(&*format!("{second}{name}")) else { continue };
            named.push((place(name), gold, gate));
        }
        named.sort_unstable();
        let mut pairs = Vec::new();
        for group in named.chunk_by(|(place, ..), (next, ..)| place == next) {
            let is_one_place = group.len() <= LARGEST_PLACE;
            let near: Rc<[usize]> = group.iter().filter(|_| is_one_place).map(|&(_, gold, _)| gold).collect();
            pairs.extend(group.iter().map(|&(_, gold, gate)| Pair { gold, gate, near: Rc::clone(&near) }));
        }
        let gates: FxHashSet<usize> = pairs.iter().map(|pair| pair.gate).collect();
        let others = (0..aig.latches.len()).filter(|register| !gates.contains(register)).collect();
        Ok(Self { aig, pairs, others })
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
        for &Pair { gold, gate, .. } in &self.pairs {
            if symbols.are_same(state[gold], state[gate]) {
                state[gate] = state[gold];
            }
        }
    }

    /// Under which conditions both versions of registers differ: as they follow from each other, or as is found near them.
    fn conditions(&self, symbols: &mut Symbols, state: &[Literal]) -> Conditions {
        let mut holders = FxHashMap::default();
        for &register in &self.others {
            holders.entry(state[register] & !1).or_insert(register);
        }
        let mut all = Conditions::new();
        for &Pair { gold, gate, ref near, .. } in &self.pairs {
            if holders.contains_key(&(state[gate] & !1)) {
                continue;
            }
            let difference = symbols.xor(state[gold], state[gate]);
            let parts = symbols.parts(difference).into_iter();
            let held =
                parts.filter_map(|part| holders.get(&(part & !1)).map(|&register| (register, part ^ state[register])));
            let mut found: Vec<(usize, Literal)> = held.collect();
            let signed = near.iter().flat_map(|&register| [(register, 0), (register, 1)]);
            let asked = signed.filter(|asked| state[asked.0] > 1 && !found.contains(asked));
            let asked: Vec<(usize, Literal)> = asked.collect();
            let held = |&(register, sign): &(usize, Literal)| state[register] ^ sign;
            let implied = symbols.implied(difference, asked.iter().map(held).collect());
            found.extend(asked.iter().filter(|asked| implied.contains(&held(asked))));
            if !found.is_empty() {
                all.insert(gate, found);
            }
        }
        all
    }

    /// The same registers, with a symbol for each that is not a constant: one for those that hold one. What differs under conditions still
    /// does. Returns all that is known then.
    fn forget(&self, symbols: &mut Symbols, state: &mut [Literal], conditions: Conditions) -> Vec<u32> {
        *symbols = Symbols::new();
        let mut known = FxHashMap::from_iter([(FALSE, FALSE)]);
        let mut rename = |literal: &mut Literal, new: &mut dyn FnMut() -> Literal| {
            let sign = *literal & 1;
            *literal = sign ^ *known.entry(*literal & !1).or_insert_with(|| sign ^ new());
        };
        for &register in &self.others {
            rename(&mut state[register], &mut || symbols.fresh());
        }
        for &Pair { gold, gate, .. } in &self.pairs {
            let mut literal = state[gate];
            rename(&mut literal, &mut || {
                let Some(conditions) = conditions.get(&gate) else { return symbols.fresh() };
                let held = conditions.iter().map(|&(register, sign)| state[register] ^ sign);
                let difference = held.fold(symbols.fresh(), |difference, held| symbols.and(difference, held));
                symbols.xor(state[gold], difference)
            });
            state[gate] = literal;
        }
        let conditions = conditions.into_iter().flat_map(|(gate, conditions)| {
            let conditions = conditions.into_iter().map(|(register, sign)| (2 * register as u32) | sign);
            [u32::MAX, gate as u32].into_iter().chain(conditions)
        });
        state.iter().copied().chain(conditions).collect()
    }

    /// Whether they never differ, as far as is seen where registers are forgotten in every turn of so many cycles, after the cycle
    /// `last` of it; and how many cycles there are until all comes again, which is looked for in turns of one even if they do.
    fn follow(&self, turn: u64, last: u64, end: Instant) -> (Proof, u64) {
        let mut state = vec![FALSE; self.aig.latches.len()];
        let mut symbols = Symbols::new();
        let mut before = (0, Vec::new());
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
            let conditions = if proof == Proof::Equivalent {
                self.unite(&symbols, &mut state);
                self.conditions(&mut symbols, &state)
            } else {
                Conditions::new()
            };
            let known = self.forget(&mut symbols, &mut state, conditions);
            if known == before.1 {
                return (proof, cycle - before.0);
            }
            if (cycle / turn).is_power_of_two() {
                before = (cycle, known);
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
