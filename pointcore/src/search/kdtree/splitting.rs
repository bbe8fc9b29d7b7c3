//! Where a node's points are divided.

use std::ops::RangeInclusive;

/// A point on its way to its leaf.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    pub point: [f32; 3],
    pub index: u32,
}

/// A way to divide the points of a node along their widest dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Splitting {
    /// Half of the points on either side.
    Median,
    /// The multiple of `bucket` nearest to half on the left: buckets are full, so none of a beat is wasted.
    Packed,
    /// The middle of the bounding box; cells are as compact as can be, leaves as full as the points happen to lie.
    Midpoint,
}

impl Splitting {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Median, Self::Packed, Self::Midpoint];

    /// As the command line spells it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Median => "median",
            Self::Packed => "packed",
            Self::Midpoint => "midpoint",
        }
    }

    /// How many of `items` go left. `allowed` is what leaves no side empty or fuller than its subtree can be.
    pub(super) fn count_left(
        self,
        items: &[Item],
        (axis, low, high): (usize, f32, f32),
        bucket: usize,
        allowed: RangeInclusive<usize>,
    ) -> usize {
        let half = items.len() / 2;
        let count = match self {
            Self::Median => half,
            Self::Packed => (half + bucket / 2) / bucket * bucket,
            // Without extent there is no side to either.
            Self::Midpoint if low == high => half,
            Self::Midpoint => {
                let middle = f32::midpoint(low, high);
                items.iter().filter(|item| item.point[axis] < middle).count()
            }
        };
        count.clamp(*allowed.start(), *allowed.end())
    }
}
