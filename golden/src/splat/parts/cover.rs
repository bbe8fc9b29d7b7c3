//! When a bin of the exposure sees something: from the first to the last time, but for the parts of the bin in which it never does.

use pointcore_contract::splat::motion::BIN_PARTS;

/// When something is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cover {
    /// What is left of the bin at the first time, and what has passed of it at the last.
    pub span: [u32; 2],
    /// A bit for each part of the bin in which it is seen.
    pub parts: u16,
}

impl Cover {
    /// All of a span, in a bin of a length.
    #[must_use]
    pub fn of(span: [u32; 2], length: u32) -> Self {
        Self { span, parts: touched(span, length) }
    }

    /// When either is seen.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        let later = |end: usize| self.span[end].max(other.span[end]);
        Self { span: [later(0), later(1)], parts: self.parts | other.parts }
    }

    /// Whether another one is seen for all of the time.
    #[must_use]
    pub const fn is_within(self, other: Self) -> bool {
        self.parts & !other.parts == 0 && self.span[0] <= other.span[0] && self.span[1] <= other.span[1]
    }

    /// For how long it is, in a bin of a length.
    #[must_use]
    pub fn time(self, length: u32) -> u32 {
        let missed = (touched(self.span, length) & !self.parts).count_ones();
        (self.span[0] + self.span[1]).saturating_sub(length + missed * (length / BIN_PARTS))
    }
}

/// The parts that a span touches.
fn touched(span: [u32; 2], length: u32) -> u16 {
    let [left, passed] = span.map(|time| time.div_ceil(length / BIN_PARTS).min(BIN_PARTS));
    let first = |count: u32| (1_u32 << count) - 1;
    (first(passed) & !first(BIN_PARTS - left)) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gap_is_known_by_the_parts_within_it() {
        let length = 1 << 10;
        let cover = |begin: u32, end: u32| Cover::of([length - begin, end], length);
        assert_eq!((cover(0, length).parts, cover(0, length).time(length)), (0xffff, length));
        let (early, late) = (cover(70, 130), cover(900, 1000));
        assert_eq!((early.parts, late.parts), (0b110, 0xc000));
        assert_eq!([early, late].map(|cover| cover.time(length)), [60, 100]);
        let both = early.with(late);
        // From 70 to 1000, without the eleven parts from 192 to 896.
        assert_eq!((both.parts, both.time(length)), (0xc006, 930 - 704));
        assert!(early.is_within(both) && late.is_within(both) && !both.is_within(early));
        assert!(!cover(300, 400).is_within(both) && !cover(60, 130).is_within(both) && cover(128, 192).is_within(both));
        assert_eq!(Cover::of([0; 2], length).time(length), 0);
    }
}
