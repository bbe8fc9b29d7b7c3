//! Powers of two, by exponents alone; golden twin: `pointcore_golden::number`.

use crate::compiler::{Program, Type, Value};
use pointcore_contract::Format;

/// Bits in which biased exponents are added: of the largest five times.
const EXPONENT_BITS: u32 = 11;
/// Biased exponent of one.
pub(super) const ONE: u64 = 127;

/// Where exponents are computed.
#[derive(Clone, Copy)]
pub(in crate::splat) struct Exponents<'a> {
    pub program: &'a Program,
    pub format: Format,
}

impl Exponents<'_> {
    /// The biased exponent.
    pub fn of(&self, value: Value) -> Value {
        value.bits(self.format.width() - 2, self.format.mantissa).resize(EXPONENT_BITS)
    }

    pub fn lit(&self, value: u64) -> Value {
        self.program.lit(EXPONENT_BITS, value)
    }

    /// `value − by`, at least 0.
    pub fn less(&self, value: Value, by: Value) -> Value {
        value.lt(by).mux(self.lit(0), value - by)
    }

    /// `value · 2^(plus − minus)`, zero where that vanishes; what is made must not overflow. Infinities and NaNs stay.
    pub fn raise(&self, value: Value, plus: Value, minus: Value) -> Value {
        let own = self.of(value);
        let sum = own + plus;
        let is_number = minus.lt(sum) & !own.eq(self.lit(0));
        let is_special = own.eq(self.lit(self.format.exponent_max()));
        let exponent = is_special.mux(own, sum - minus);
        self.assemble(value, is_special | is_number, exponent, self.fraction(value))
    }

    /// The same of what may overflow, to infinity.
    pub fn raise_far(&self, value: Value, plus: Value, minus: Value) -> Value {
        let (own, largest) = (self.of(value), self.lit(self.format.exponent_max()));
        let sum = own + plus;
        let is_number = minus.lt(sum) & !own.eq(self.lit(0));
        let is_special = own.eq(largest);
        let is_beyond = (minus + largest).le(sum) & is_number & !is_special;
        let exponent = is_special.mux(own, is_beyond.mux(largest, sum - minus));
        let none = self.program.lit(self.format.mantissa, 0);
        let fraction = is_beyond.mux(none, self.fraction(value));
        self.assemble(value, is_special | is_number, exponent, fraction)
    }

    fn fraction(&self, value: Value) -> Value {
        value.bits(self.format.mantissa - 1, 0)
    }

    fn assemble(&self, value: Value, is_left: Value, exponent: Value, fraction: Value) -> Value {
        let Format { exponent: bits, mantissa, .. } = self.format;
        let magnitude = exponent.resize(bits).cat(fraction);
        let magnitude = is_left.mux(magnitude, self.program.lit(bits + mantissa, 0));
        self.sign(value).cat(magnitude).reinterpret(Type::Float(self.format))
    }

    /// The sign bit.
    pub fn sign(&self, value: Value) -> Value {
        let top = self.format.width() - 1;
        value.bits(top, top)
    }

    /// All bits but the sign.
    pub fn magnitude(&self, value: Value) -> Value {
        value.bits(self.format.width() - 2, 0)
    }

    /// With the other sign.
    pub fn negated(&self, value: Value) -> Value {
        (!self.sign(value)).cat(self.magnitude(value)).reinterpret(Type::Float(self.format))
    }

    /// With a magnitude so many units in the last place smaller, zero at least.
    pub fn shrunk(&self, value: Value, units: u64) -> Value {
        let magnitude = self.magnitude(value);
        let [none, units] = [0, units].map(|value| self.program.lit(self.format.width() - 1, value));
        let magnitude = magnitude.lt(units).mux(none, magnitude - units);
        self.sign(value).cat(magnitude).reinterpret(Type::Float(self.format))
    }
}
