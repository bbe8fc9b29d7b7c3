//! `Division`: how the renderer comes to reciprocals, quotients and square roots.

use serde::{Deserialize, Serialize};

/// The operators that divide and take roots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Division {
    /// Digit by digit, correctly rounded.
    Rounded,
    /// From a table and Newton steps: multipliers in the place of dividers, one unit in the last place off at most.
    Newton,
}
