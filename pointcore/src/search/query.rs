//! Queries and what they bring, in the user's terms.

use super::SearchError;
use super::reuse::{QueryKind, Reuse};
use crate::number::encode;
use pointcore_contract::search::Config;
use pointcore_contract::search::records;

/// A point whose nearest neighbors are asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// Where.
    pub point: [f32; 3],
    /// Neighbors wanted, 1 to the configuration's `neighbors`.
    pub k: u32,
    /// Only neighbors nearer than this count.
    pub radius: Option<f32>,
}

/// A neighbor of a query.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Neighbor {
    /// The point's index in the point set.
    pub point: u32,
    /// Its squared distance as the core rounds it.
    pub distance2: f32,
}

/// The largest k any configuration holds.
const NEIGHBORS_LIMIT: u32 = 64;

/// A query in the core's terms.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// What is sent, with 0 for a number: with a neighbor cache, more than is wanted.
    pub sent: records::CachedQuery,
    /// Neighbors wanted.
    pub k: usize,
    /// Squared radius within which they count.
    pub radius2: u32,
}

impl Query {
    /// Checks that the core can answer it.
    ///
    /// # Errors
    /// It cannot; the error bears `index`.
    pub fn check(&self, config: &Config, index: usize) -> Result<(), SearchError> {
        self.encode(config, Reuse::default(), index).map(drop)
    }

    /// What the query asks for.
    #[must_use]
    pub const fn kind(&self) -> QueryKind {
        if self.radius.is_some() { QueryKind::Ball } else { QueryKind::Nearest }
    }

    /// The query as the core takes it.
    ///
    /// # Errors
    /// The core cannot answer it; the error bears `index`.
    pub fn encode(&self, config: &Config, reuse: Reuse, index: usize) -> Result<Asked, SearchError> {
        let wrong = |problem| Err(SearchError::Query { index, problem });
        let format = config.geometry;
        let &Self { point, k, radius } = self;
        if k == 0 {
            return wrong("k is 0: expected 1 at least".to_owned());
        }
        // The distance to one neighbor more tells how far the neighborhood reaches.
        let searched = if config.neighbor_cache > 0 && radius.is_none() { k.saturating_add(1) } else { k };
        if searched > config.neighbors {
            let more = if searched > k { " and the neighbor cache needs one more" } else { "" };
            let remedy =
                if searched > NEIGHBORS_LIMIT { "ask for fewer".to_owned() } else { format!("raise it to {searched}") };
            return wrong(format!(
                "k is {k}{more}, but the hardware's `neighbors` is {}: {remedy} (up to {NEIGHBORS_LIMIT})",
                config.neighbors
            ));
        }
        let radius2 = match radius {
            None => format.infinity() as u32,
            Some(radius) if radius > 0.0 => encode(format, radius * radius),
            Some(radius) => return wrong(format!("the radius is {radius}: expected a positive number")),
        };
        if radius2 == 0 {
            return wrong(format!("the radius is {}: its square vanishes in {format}", radius.unwrap_or_default()));
        }
        let encoded = point.map(|number| encode(format, number));
        // Of encoded numbers without their sign, infinity and NaN are the greatest.
        if !encoded.iter().all(|bits| u64::from(*bits) & !format.sign_mask() < format.infinity()) {
            return wrong(format!("the point is {point:?}: coordinates must be finite in {format}"));
        }
        let extended = radius.filter(|_| config.neighbor_cache > 0);
        let sent_radius2 = extended.map_or(radius2, |radius| reuse.extended_radius2(format, radius));
        let query = records::Query { number: 0, k: searched as u8, radius2: sent_radius2, point: encoded };
        let reach = encode(format, radius.unwrap_or(0.0));
        Ok(Asked { sent: records::CachedQuery { query, reach }, k: k as usize, radius2 })
    }
}

/// Checks what a neighbor cache asks of all queries together: neighborhoods tell neither how many neighbors they were searched for
/// nor whether within a radius.
pub(super) fn check_alike(config: &Config, queries: &[Query]) -> Result<(), SearchError> {
    let Some(first) = queries.first().filter(|_| config.neighbor_cache > 0) else { return Ok(()) };
    let other = queries.iter().position(|query| query.k != first.k || query.kind() != first.kind());
    other.map_or(Ok(()), |index| {
        let problem = "differs from the first in k, or in whether it has a radius: search for such queries apart, or set \
                       `neighbor_cache` to 0";
        Err(SearchError::Query { index, problem: problem.to_owned() })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queries_without_meaning_are_refused() {
        let config = Config { neighbors: 10, ..Config::default() };
        let sound = Query { point: [0.0; 3], k: 10, radius: Some(1.5) };
        let encode = |query: Query, config: &Config| {
            let reuse = Reuse { alpha: 2.0, ..Reuse::default() };
            let asked = query.encode(config, reuse, 0).expect("the query is sound");
            (asked.sent.query.k, asked.sent.query.radius2, asked.sent.reach, asked.k, asked.radius2)
        };
        let [radius, radius2, extended2, infinity] = [1.5, 2.25, 9.0, f32::INFINITY].map(f32::to_bits);
        assert_eq!(encode(sound, &config), (10, radius2, radius, 10, radius2));
        let unbounded = Query { radius: None, k: 9, ..sound };
        assert_eq!(encode(unbounded, &config), (9, infinity, 0, 9, infinity));
        let cached = Config { neighbor_cache: 8, ..config.clone() };
        assert_eq!(encode(sound, &cached), (10, extended2, radius, 10, radius2));
        assert_eq!(encode(unbounded, &cached), (10, infinity, 0, 9, infinity));
        assert!(Query { k: 10, ..unbounded }.check(&cached, 0).is_err(), "there is no room for one more");
        assert!(check_alike(&cached, &[sound, sound]).is_ok() && check_alike(&config, &[sound, unbounded]).is_ok());
        assert!(check_alike(&cached, &[sound, unbounded]).is_err());
        assert!(check_alike(&cached, &[sound, Query { k: 9, ..sound }]).is_err());
        for (query, part) in [
            (Query { k: 0, ..sound }, "k is 0"),
            (Query { k: 11, ..sound }, "`neighbors` is 10: raise it to 11 (up to 64)"),
            (Query { k: 65, ..sound }, "ask for fewer (up to 64)"),
            (Query { radius: Some(0.0), ..sound }, "radius is 0"),
            (Query { radius: Some(-1.0), ..sound }, "radius is -1"),
            (Query { radius: Some(f32::NAN), ..sound }, "radius is NaN"),
            (Query { radius: Some(1e-30), ..sound }, "vanishes"),
            (Query { point: [0.0, f32::NAN, 0.0], ..sound }, "must be finite"),
            (Query { point: [f32::NEG_INFINITY; 3], ..sound }, "must be finite"),
        ] {
            let message = query.check(&config, 7).unwrap_err().to_string();
            assert!(message.starts_with("query 7: ") && message.contains(part), "{message}");
        }
    }
}
