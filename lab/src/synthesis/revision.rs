//! Of which state of the project a figure is.

use serde::{Deserialize, Serialize};

/// A revision of the project: a commit's short hash, or a date.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String")]
pub struct Revision(String);

impl TryFrom<String> for Revision {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let allowed = |c: char| c.is_ascii_alphanumeric() || ".-_".contains(c);
        let is_name = !text.is_empty() && text.chars().all(allowed);
        is_name.then(|| Self(text.clone())).ok_or_else(|| {
            format!("`{text}` is no revision: expected a commit's short hash or a date, of letters, digits and .-_")
        })
    }
}

impl std::str::FromStr for Revision {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.to_owned().try_into()
    }
}

impl std::fmt::Display for Revision {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}
