//! What stands behind a pipeline, which never holds a token back.
//!
//! Where results wait until they are taken, that is a queue with a place for each token that may be under way. There are as many
//! credits: a token takes one along, and gives it back when it leaves the queue or is dropped in front of it. Where results are
//! always taken, one register shows them.

use super::Taking;
use super::phases::LOADS;
use crate::stream::{fifo, fifo_distributed};
use rtl::{Expr, Module, Reg, address_width, bit};

/// Cycles from a token's acceptance to the first in which its credit can be taken again, besides the pipeline's: two in the queue,
/// one in which it leaves, one on the credit's way back.
const ROUND_CYCLES: u32 = 4;
/// Fewest places of a queue.
const PLACES_MIN: u32 = 2;
/// Deepest queue kept in look-up tables; deeper ones take block memory.
const DISTRIBUTED_PLACES: u32 = 64;

/// Places of the queue behind a pipeline: the fewest at which tokens enter at the initiation interval, whichever phase they are taken in.
pub(super) fn places(latency: u32, initiation_interval: u32) -> u32 {
    let waits = initiation_interval - 1;
    (latency + ROUND_CYCLES + waits).div_ceil(initiation_interval).max(PLACES_MIN)
}

/// Tokens at both ends of a pipeline.
pub(super) struct Tokens {
    /// One enters.
    pub enters: Expr,
    /// One arrives at the end.
    pub arrives: Expr,
    /// What becomes of it: whether it is kept.
    pub keep: Expr,
}

/// The end of a pipeline.
pub(super) enum Output {
    /// A queue of so many places.
    Queue {
        places: u32,
        /// One less than there are: its sign says that there is none.
        credits: Reg,
    },
    /// A register.
    Shown,
}

impl Output {
    /// The end of a pipeline with a queue of so many places, where it needs one.
    pub fn new(module: &mut Module, taking: Taking, places: u32) -> Self {
        match taking {
            Taking::Later => {
                let credits = module.reg_reset("credits", address_width(places) + 1, u128::from(places - 1));
                Self::Queue { places, credits }
            }
            Taking::AtOnce => Self::Shown,
        }
    }

    /// A token may enter, as far as this goes.
    pub fn admits(&self) -> Expr {
        match self {
            Self::Queue { credits, .. } => !credits.msb(),
            Self::Shown => bit(true),
        }
    }

    /// Leads the results of the tokens that are kept to the output stream.
    pub fn finish(self, module: &mut Module, tokens: &Tokens, results: &[(String, Expr)]) {
        let Tokens { enters, arrives, keep } = *tokens;
        let kept = module.wire("kept", arrives & keep);
        match self {
            Self::Queue { places, credits } => {
                let left = queue(module, places, kept, results);
                let dropped = module.reg_reset("dropped", 1, 0);
                module.next(dropped, arrives & !keep);
                let bits = |one: Expr| one.zext(credits.width());
                module.next(credits, credits - bits(enters) + bits(left) + bits(dropped.expr()));
            }
            Self::Shown => show(module, kept, results),
        }
    }
}

/// A queue of the results; returns whether one has left it in the cycle before. It is cut into some that go in step, so that no
/// signal of theirs has more than its share of the loads. Of deep ones flags have their own: what is taken may hang on them, and block
/// memory shows them late.
fn queue(module: &mut Module, places: u32, kept: Expr, results: &[(String, Expr)]) -> Expr {
    let (mut valid, mut readies, mut fields) = (Vec::new(), Vec::new(), Vec::new());
    let is_deep = places > DISTRIBUTED_PLACES;
    let (flags, words): (Vec<_>, Vec<_>) =
        results.iter().cloned().partition(|(_, value)| is_deep && value.width() == 1);
    let flags = parts(&flags).into_iter().map(|part| (part, true));
    for (part, is_distributed) in flags.chain(parts(&words).into_iter().map(|part| (part, !is_deep))) {
        let layout: Vec<(&str, u32)> = part.iter().map(|(name, value)| (name.as_str(), value.width())).collect();
        let fifo = if is_distributed { fifo_distributed(places, &layout) } else { fifo(places, &layout) };
        let queue = module.instance(&format!("queue_{}", valid.len() + 1), fifo);
        module.connect(queue, "in_valid", kept);
        part.iter().for_each(|(name, value)| module.connect(queue, &format!("in_{name}"), *value));
        let room = module.out(queue, "in_ready");
        module.assert(&format!("{}_has_a_place_for_each_result", queue.name()), !kept | room);
        let out = module.stream_from(queue, "out");
        fields.extend(part.iter().map(|(name, _)| (name, out.field(name))));
        valid.push(out.valid);
        readies.push(out.ready);
    }
    let place = |name: &String| results.iter().position(|(result, _)| result == name);
    fields.sort_by_key(|&(name, _)| place(name));
    let ready = module.stream_out("out", valid[0], fields);
    readies.into_iter().for_each(|out| module.drive(out, ready));
    for (index, other) in valid.iter().enumerate().skip(1) {
        module.assert(&format!("queue_{}_in_step", index + 1), other.eq(valid[0]));
    }
    let left = module.reg_reset("left", 1, 0);
    module.next(left, valid[0] & ready);
    left.expr()
}

/// The results in parts of no more than [`LOADS`] bits; a result has fewer.
fn parts(results: &[(String, Expr)]) -> Vec<&[(String, Expr)]> {
    let (mut parts, mut rest) = (Vec::new(), results);
    while !rest.is_empty() {
        let ends = rest.iter().scan(0, |bits, (_, value)| {
            *bits += value.width();
            Some(*bits)
        });
        let (part, others) = rest.split_at(ends.take_while(|&bits| bits <= LOADS).count());
        parts.push(part);
        rest = others;
    }
    parts
}

/// A register of the results.
fn show(module: &mut Module, kept: Expr, results: &[(String, Expr)]) {
    let valid = module.reg_reset("shown", 1, 0);
    module.next(valid, kept);
    let show = |(name, value): &(String, Expr)| {
        let register = module.reg(&format!("shown_{name}"), value.width());
        module.next(register, *value);
        (name.clone(), register)
    };
    let shown: Vec<_> = results.iter().map(show).collect();
    let ready = module.stream_out("out", valid, shown);
    module.assert("results_are_taken", !valid.expr() | ready);
}
