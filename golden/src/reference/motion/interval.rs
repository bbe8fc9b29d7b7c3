//! Parts of the exposure.

/// A part of the exposure that is not empty, in its time `τ`: the shutter opens at −1 and closes at 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Where it begins.
    pub begin: f64,
    /// Where it ends, later than it begins.
    pub end: f64,
}

impl Interval {
    /// All the time for which the shutter is open.
    pub const EXPOSURE: Self = Self { begin: -1.0, end: 1.0 };

    /// From one time to a later one; `None` where nothing lies between them.
    #[must_use]
    pub fn new(begin: f64, end: f64) -> Option<Self> {
        (begin < end).then_some(Self { begin, end })
    }

    /// The exposure cut into parts of one length. Each begins with the very number with which the one before it ends, so that what borders share is
    /// counted once.
    pub fn equal_parts(count: usize) -> impl Iterator<Item = Self> {
        let border = move |index: usize| -1.0 + 2.0 * index as f64 / count as f64;
        (0..count).map(move |index| Self { begin: border(index), end: border(index + 1) })
    }

    /// What both have in common.
    #[must_use]
    pub fn intersection(self, other: Self) -> Option<Self> {
        Self::new(self.begin.max(other.begin), self.end.min(other.end))
    }

    /// From where the first begins to where the last ends.
    #[must_use]
    pub const fn hull(self, other: Self) -> Self {
        Self { begin: self.begin.min(other.begin), end: self.end.max(other.end) }
    }

    /// The part in which `at_zero + τ·slope ≥ 0`.
    #[must_use]
    pub fn where_positive(self, at_zero: f64, slope: f64) -> Option<Self> {
        let root = -at_zero / slope;
        match slope {
            0.0 => (at_zero >= 0.0).then_some(self),
            0.0.. => Self::new(self.begin.max(root), self.end),
            // A NaN is positive nowhere.
            _ => Self::new(self.begin, self.end.min(root)).filter(|_| !root.is_nan()),
        }
    }

    /// Half-way between begin and end.
    #[must_use]
    pub const fn middle(self) -> f64 {
        0.5 * (self.begin + self.end)
    }

    /// From begin to end.
    #[must_use]
    pub fn length(self) -> f64 {
        self.end - self.begin
    }

    /// Whether a time lies in it, its ends included.
    #[must_use]
    pub fn contains(self, time: f64) -> bool {
        (self.begin..=self.end).contains(&time)
    }
}
