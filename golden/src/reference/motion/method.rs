//! How it is settled which surface is seen at which time.

use std::fmt;
use std::str::FromStr;

/// The most bins, or parts of the exposure: a pixel holds each.
pub const COUNT_LIMIT: usize = 64;

/// How it is settled which surface is seen at which time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// An A-buffer (thesis 4.3.4): every time at which the splats over a sample change, in memory without a bound.
    Exact,
    /// So many bins of time a sample, each with one surface.
    Bins(usize),
    /// The thesis' six passes (4.4), for each of so many parts of the exposure: the earliest and the latest time of all that is seen.
    Passes(usize),
}

/// A text that names no method.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "is {0:?}: expected \"exact\", \"bins:K\" or \"gpu:N\" with 1 to {COUNT_LIMIT} bins or parts of the exposure, e.g. \"bins:8\""
)]
pub struct UnknownMethod(pub String);

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(text: &str) -> Result<Self, UnknownMethod> {
        let unknown = || UnknownMethod(text.to_owned());
        let (name, count) = text.split_once(':').map_or((text, None), |(name, count)| (name, Some(count)));
        let count =
            count.map(|count| count.parse().ok().filter(|count| (1..=COUNT_LIMIT).contains(count)).ok_or_else(unknown));
        match (name, count.transpose()?) {
            ("exact", None) => Ok(Self::Exact),
            ("bins", Some(count)) => Ok(Self::Bins(count)),
            ("gpu", count) => Ok(Self::Passes(count.unwrap_or(1))),
            _ => Err(unknown()),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Exact => write!(formatter, "exact"),
            Self::Bins(count) => write!(formatter, "bins:{count}"),
            Self::Passes(count) => write!(formatter, "gpu:{count}"),
        }
    }
}
