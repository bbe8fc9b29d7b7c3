//! Many counters of 32 bits in one memory: each has a few bits of its own that count in every cycle, and a round of visits adds
//! them to the memory's words with one adder. A read is a visit out of turn, so it misses nothing.
//!
//! A visit takes two cycles, and every second one is the round's, so a counter is visited once in `4·n` cycles at least.

use pointcore_contract::splat::config::index_bits;

use super::REGISTER_BITS;
use rtl::{Expr, Module, Reg, address_width, lit};

/// Cycles from one visit of the round to the next, on average. A visit takes two. At most one of three is to what is asked for: who
/// asks takes the answer and gives an address in between.
const CYCLES_A_VISIT: u32 = 3;

/// What a counter counts.
pub(super) struct Counter {
    /// Adds them up.
    pub sources: Vec<Expr>,
    /// Sets it to zero.
    pub clear: Expr,
}

/// An answer to a read.
pub(super) struct Answer {
    /// The value is there.
    pub valid: Expr,
    /// The counter's value; it saturates.
    pub value: Expr,
}

/// The sum of some numbers.
fn sum(numbers: &[Expr], width: u32) -> Expr {
    numbers.iter().map(|number| number.zext(width)).reduce(|sum, number| sum + number).unwrap_or_else(|| lit(width, 0))
}

/// Counts; reads the counter `asked` where `asks` is set, which is to fall with the answer, and for a cycle.
pub(super) fn counters(m: &mut Module, counters: &[Counter], asks: Expr, asked: Expr) -> Answer {
    let count = counters.len() as u32;
    let index_width = address_width(count);
    let adds = m.reg_reset("adds", 1, 0);
    m.next(adds, !adds);
    let visited = m.reg_reset("visited", index_width, 0);
    let looks = m.wire("looks", !adds);

    let (mut parts, mut voids) = (vec![], vec![]);
    for (index, counter) in (0..).zip(counters) {
        let visits = m.wire(&format!("visits_{index}"), looks & visited.eq_lit(u128::from(index)));
        let [part, void] = own_bits(m, index, count, counter, visits);
        parts.push(part);
        voids.push(void);
    }
    let widest = parts.iter().map(|part| part.width()).max().unwrap_or(1);
    let part = m.reg("part", widest);
    m.next(part, visited.pick(parts.into_iter().map(|part| part.zext(widest))));
    let is_void = m.reg("is_void", 1);
    m.next(is_void, visited.pick(voids));

    let words = m.memory_distributed("words", count, REGISTER_BITS);
    let word = m.read(words, "word", visited);
    let base = lit(REGISTER_BITS, 0);
    let base = is_void.mux(base, word);
    let sum = m.wire("sum", base.add_carry(part.zext(REGISTER_BITS)));
    let saturated = m.wire("saturated", sum.trunc(REGISTER_BITS) | sum.msb().repeat(REGISTER_BITS));
    m.write(words, adds, visited, saturated);

    let round = m.reg_reset("round", index_width, 0);
    let for_read = m.reg_reset("for_read", 1, 0);
    let turns_aside = m.wire("turns_aside", asks & !for_read);
    m.next_if(for_read, adds, turns_aside);
    m.next_if(visited, adds, turns_aside.mux(asked, round));
    let next = round.eq_lit(u128::from(count) - 1).mux(lit(index_width, 0), round.add_lit(1));
    m.next_if(round, adds & !turns_aside, next);
    let valid = m.reg_reset("read_valid", 1, 0);
    m.next(valid, adds & for_read);
    let value = m.reg("read_value", REGISTER_BITS);
    m.next(value, saturated);
    Answer { valid: valid.expr(), value: value.expr() }
}

/// A counter's own bits: what it has counted since its last visit, and whether its word in memory is void.
fn own_bits(m: &mut Module, index: u32, count: u32, counter: &Counter, visits: Expr) -> [Reg; 2] {
    let most =
        counter.sources.iter().map(|source| (1 << source.width()) - 1).sum::<u32>() * CYCLES_A_VISIT * (count + 1);
    let width = index_bits(most + 1);
    let part = m.reg_reset(&format!("part_{index}"), width, 0);
    let more = sum(&counter.sources, width);
    m.assert(&format!("part_{index}_has_room"), !part.add_carry(more).msb());
    let starts_anew = visits | counter.clear;
    m.next(part, starts_anew.mux(more, part + more));
    let void = m.reg_reset(&format!("void_{index}"), 1, 1);
    m.next(void, counter.clear | (void & !visits));
    [part, void]
}
