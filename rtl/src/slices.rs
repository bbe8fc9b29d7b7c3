//! Parts of expressions, and expressions at other widths.

use super::expression::{Expr, Primitive, cat, lit};

impl Expr {
    /// Bits `high` down to `low`, both included.
    #[must_use]
    #[track_caller]
    pub fn bits(self, high: u32, low: u32) -> Expr {
        if high < low || high >= self.width() {
            let width = high.saturating_sub(low) + 1;
            return Expr::poison(width, format!("`{self}` has {} bits and no [{high}:{low}]", self.width()));
        }
        Expr::build(Primitive::Slice(low), high - low + 1, [self])
    }

    /// One bit.
    #[must_use]
    #[track_caller]
    pub fn bit(self, index: u32) -> Expr {
        self.bits(index, index)
    }

    /// The most significant bit.
    #[must_use]
    #[track_caller]
    pub fn msb(self) -> Expr {
        self.bit(self.width() - 1)
    }

    /// Extended with zeros to `width` bits.
    #[must_use]
    #[track_caller]
    pub fn zext(self, width: u32) -> Expr {
        if width <= self.width() {
            return self.unextended("zero-extension", width);
        }
        cat([lit(width - self.width(), 0), self])
    }

    /// Extended with copies of the sign to `width` bits.
    #[must_use]
    #[track_caller]
    pub fn sext(self, width: u32) -> Expr {
        if width <= self.width() {
            return self.unextended("sign-extension", width);
        }
        cat([self.msb().repeat(width - self.width()), self])
    }

    #[track_caller]
    fn unextended(self, what: &str, width: u32) -> Expr {
        if width == self.width() {
            return self;
        }
        Expr::poison(width, format!("{what} of `{self}` from {} to {width} bits", self.width()))
    }

    /// The lowest `width` bits.
    #[must_use]
    #[track_caller]
    pub fn trunc(self, width: u32) -> Expr {
        if width == 0 || width > self.width() {
            return Expr::poison(width, format!("truncation of `{self}` from {} to {width} bits", self.width()));
        }
        self.bits(width - 1, 0)
    }

    /// Zero-extended or truncated to `width` bits.
    #[must_use]
    #[track_caller]
    pub fn resize(self, width: u32) -> Expr {
        if width < self.width() { self.trunc(width) } else { self.zext(width) }
    }

    /// `count` copies side by side.
    #[must_use]
    #[track_caller]
    pub fn repeat(self, count: u32) -> Expr {
        if count == 0 {
            return Expr::poison(1, format!("`{self}` repeated no times"));
        }
        Expr::build(Primitive::Repeat(count), self.width() * count, [self])
    }
}
