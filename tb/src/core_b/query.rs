//! Queries and what they bring, in the user's terms.

use super::Error;
use super::points::encode;
use pointcore_golden::core_b::records;
use pointcore_spec::core_b::Config;

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

impl Query {
    /// Checks that the core can answer it.
    ///
    /// # Errors
    /// It cannot; the error bears `index`.
    pub fn check(&self, config: &Config, index: usize) -> Result<(), Error> {
        self.encode(config, index).map(drop)
    }

    /// The query as the core takes it, with 0 for a number.
    ///
    /// # Errors
    /// The core cannot answer it; the error bears `index`.
    pub(super) fn encode(&self, config: &Config, index: usize) -> Result<records::Query, Error> {
        let wrong = |problem| Err(Error::Query { index, problem });
        let format = config.geometry;
        let &Self { point, k, radius } = self;
        if k == 0 {
            return wrong("k is 0: expected 1 at least".to_owned());
        }
        if k > config.neighbors {
            let remedy = if k > NEIGHBORS_LIMIT { "ask for fewer".to_owned() } else { format!("raise it to {k}") };
            return wrong(format!(
                "k is {k}, but the hardware's `neighbors` is {}: {remedy} (up to {NEIGHBORS_LIMIT})",
                config.neighbors
            ));
        }
        let radius2 = match radius {
            None => format.infinity() as u32,
            Some(radius) if radius > 0.0 => encode(format, radius * radius),
            Some(radius) => return wrong(format!("the radius is {radius}: expected a positive number")),
        };
        if radius2 == 0 {
            return wrong(format!("the radius is {radius:?}: its square vanishes in {format}"));
        }
        let encoded = point.map(|number| encode(format, number));
        // Of encoded numbers without their sign, infinity and NaN are the greatest.
        if !encoded.iter().all(|bits| u64::from(*bits) & !format.sign_mask() < format.infinity()) {
            return wrong(format!("the point is {point:?}: coordinates must be finite in {format}"));
        }
        Ok(records::Query { number: 0, k: k as u8, radius2, point: encoded })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queries_without_meaning_are_refused() {
        let config = Config { neighbors: 10, ..Config::default() };
        let sound = Query { point: [0.0; 3], k: 10, radius: Some(1.5) };
        let encoded = sound.encode(&config, 0).expect("the query is sound");
        assert_eq!((encoded.k, encoded.radius2), (10, 2.25_f32.to_bits()));
        let unbounded = Query { radius: None, ..sound }.encode(&config, 0).expect("the query is sound");
        assert_eq!(unbounded.radius2, f32::INFINITY.to_bits());
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
            let message = query.encode(&config, 7).unwrap_err().to_string();
            assert!(message.starts_with("query 7: ") && message.contains(part), "{message}");
        }
    }
}
