//! Payloads in words.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Payload, PayloadWord, payload_word_bits};
use pointcore_contract::width;

use crate::units::ports::held;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, address_width, cat, lit};

/// A word that is written.
pub(super) struct WrittenWord {
    pub enable: Expr,
    pub address: Expr,
    pub word: Expr,
}

/// How a payload is cut into words, the first one on top.
#[derive(Clone, Copy)]
pub(super) struct Words {
    pub count: u32,
    width: u32,
    /// Bits of the last one that hold nothing.
    padding: u32,
}

impl Words {
    pub fn of(config: &Config) -> Self {
        let (count, bits) = (config.payload_beats, payload_word_bits(config));
        Self { count, width: bits, padding: count * bits - width::<Payload>(config) }
    }

    /// The words of a payload.
    pub fn cut(self, config: &Config, payload: Payload<Wires>) -> Vec<Expr> {
        let packed = payload.pack(config);
        let padded = if self.padding == 0 { packed } else { cat([packed, lit(self.padding, 0)]) };
        (0..self.count).rev().map(|word| padded.bits((word + 1) * self.width - 1, word * self.width)).collect()
    }

    /// The payload of these words.
    pub fn join(self, config: &Config, words: &[Expr]) -> Payload<Wires> {
        let padded = cat(words.iter().copied());
        Payload::unpack(config, padded.bits(padded.width() - 1, self.padding))
    }

    /// A word as it passes ports.
    pub fn part(self, config: &Config, word: Expr) -> PayloadWord<Wires> {
        let mut low = 0;
        PayloadWord::from_fields(config, |part| {
            low += part.width;
            word.bits(low - 1, low - part.width)
        })
    }

    /// A word that has passed them.
    pub fn joined(self, config: &Config, word: PayloadWord<Wires>) -> Expr {
        cat(word.values(config).into_iter().rev())
    }

    /// The words that came last, this one at the end: those before move up when it `passes`.
    pub fn keep(self, m: &mut Module, passes: Expr, word: Expr) -> Vec<Expr> {
        let mut following = word;
        let keep = |number: u32| {
            following = held(m, &format!("kept_{number}"), passes, following);
            following
        };
        let mut kept: Vec<_> = (0..self.count - 1).rev().map(keep).collect();
        kept.reverse();
        kept.push(word);
        kept
    }

    /// Bits of a word's number.
    pub fn index_bits(self) -> u32 {
        address_width(self.count)
    }

    /// Whether it is the last word's number.
    pub fn is_last(self, number: Expr) -> Expr {
        number.eq_lit(u128::from(self.count) - 1)
    }

    /// Where a word of a place lies.
    pub fn address(self, number: Expr, place: Expr) -> Expr {
        if self.count == 1 { place } else { cat([number, place]) }
    }
}
