//! When a cached neighborhood answers a query: the comparison value of an entry, and the test against it (eqs. 6.5 and 6.6,
//! table 6.1, rearranged as docs/units/search/neighbor_cache.md states).
//!
//! Each operation is rounded once. A comparison value of NaN covers nothing, one of infinity every query at a finite distance.

use crate::number::Number;
use crate::search::leaf::squared_distance;
use pointcore_contract::Format;
use pointcore_contract::search::records::{CacheSetup, CachedQuery, Point};

/// Squared distances of a neighborhood's farthest neighbor and of the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) far2: u32,
    pub(super) near2: u32,
}

/// What the coherence check compares a query with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Reference {
    /// The point whose neighborhood it is.
    pub(super) point: Point,
    /// The comparison value `c`.
    pub(super) cover: u32,
}

impl Extent {
    /// `c = √far2·far_scale − √near2`.
    pub(super) fn cover(self, geometry: Format, setup: &CacheSetup) -> u32 {
        let number = |bits| Number::new(geometry, bits);
        (number(self.far2).sqrt() * number(setup.far_scale) - number(self.near2).sqrt()).bits()
    }
}

impl Reference {
    /// `margin = (c − r)·margin_scale`, and whether `r < c` and `d² < margin²`.
    pub(super) fn covers(&self, geometry: Format, query: &CachedQuery, setup: &CacheSetup) -> (u32, bool) {
        let number = |bits| Number::new(geometry, bits);
        let (cover, reach) = (number(self.cover), number(query.reach));
        let margin = (cover - reach) * number(setup.margin_scale);
        let distance2 = number(squared_distance(geometry, self.point, query.query.point));
        (margin.bits(), reach.is_below(cover) && distance2.is_below(margin * margin))
    }
}
