//! Scores, kept with the source and made into a table.

use super::Score;
use crate::Figures;
use crate::marks::{self, MarkError};
use pointcore::configuration::{ConfigurationError, read_text, wrong};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What the name of a package's test begins with.
pub const SELF_TEST: &str = "selftest.";

/// Scores, at most one of a unit or package, by name.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct MutationRecord {
    scores: Vec<Score>,
}

impl MutationRecord {
    /// Reads a record; an empty one if there is no such file.
    ///
    /// # Errors
    /// The file cannot be read, or is none of ours.
    pub fn load(path: &Path) -> Result<Self, ConfigurationError> {
        if !path.exists() {
            return Ok(Self::default());
        }
        serde_json::from_str(&read_text(path)?).map_err(|error| wrong(path, error.to_string()))
    }

    /// Adds a score in the place of an earlier one of that name.
    pub fn insert(&mut self, score: Score) {
        match self.scores.binary_search_by(|other| other.name.cmp(&score.name)) {
            Ok(place) => self.scores[place] = score,
            Err(place) => self.scores.insert(place, score),
        }
    }

    /// The score of a unit or package.
    #[must_use]
    pub fn score(&self, name: &str) -> Option<&Score> {
        self.scores.iter().find(|score| score.name == name)
    }

    /// The file's text.
    #[must_use]
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).expect("scores have string keys") + "\n"
    }

    /// Figures by key: `mutation.UNIT.found` and the like, of a package's test `mutation.selftest.CONFIG.found`.
    #[must_use]
    pub fn figures(&self) -> Figures {
        let mut figures = Figures::new();
        for score in &self.scores {
            let mut put = |figure: &str, value: serde_json::Value| {
                figures.insert(format!("mutation.{}.{figure}", score.name), value);
            };
            put("mutants", score.mutants.into());
            put("found", score.found.into());
            put("equivalent", score.equivalent.into());
            put("score", score.percent().into());
        }
        figures
    }

    /// A document with its tables of scores written anew: of units' tests between `<!-- mutation units -->` and
    /// `<!-- end of mutation -->`, of packages' tests after `<!-- mutation packages -->`.
    ///
    /// # Errors
    /// A table is missing, or has no end.
    pub fn tabulate(&self, document: &str) -> Result<String, MarkError> {
        let (packages, units): (Vec<_>, Vec<_>) =
            self.scores.iter().partition(|score| score.name.starts_with(SELF_TEST));
        let document = marks::replace(document, "mutation units", &table("unit", &units))?;
        marks::replace(&document, "mutation packages", &table("package", &packages))
    }
}

/// A table in Markdown.
fn table(kind: &str, scores: &[&Score]) -> String {
    let line = |score: &&Score| {
        let Score { name, mutants, found, equivalent, .. } = score;
        let (name, missed) = (name.trim_start_matches(SELF_TEST), score.missed.len());
        format!("| `{name}` | {mutants} | {equivalent} | {found} | {missed} | {:.1} % |\n", score.percent())
    };
    let head = format!("| {kind} | mutants | equivalent | found | missed | found of those that change something |\n");
    let sum = |count: fn(&Score) -> usize| scores.iter().map(|score| count(score)).sum::<usize>();
    let all = Score {
        name: "all".to_owned(),
        mutants: sum(|score| score.mutants),
        found: sum(|score| score.found),
        equivalent: sum(|score| score.equivalent),
        missed: scores.iter().flat_map(|score| score.missed.clone()).collect(),
        source: String::new(),
    };
    let lines: String = scores.iter().copied().chain([&all]).map(|score| line(&score)).collect();
    format!("{head}|---|--:|--:|--:|--:|--:|\n{lines}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn score(name: &str, found: usize) -> Score {
        let missed = vec!["search_sieve: mutate -mode inv (undecided)".to_owned(); 9 - found];
        Score { name: name.to_owned(), mutants: 10, found, equivalent: 1, missed, source: "0".into() }
    }

    #[test]
    fn scores_become_figures_and_tables() {
        let mut record = MutationRecord::default();
        for (name, found) in [("stream_skid", 3), ("selftest.tiny_knn", 6), ("search_sieve", 8), ("stream_skid", 9)] {
            record.insert(score(name, found));
        }
        assert_eq!(serde_json::from_str::<MutationRecord>(&record.text()).ok(), Some(record.clone()));
        let misses = |name: &str, mutant: &str| record.score(name).is_some_and(|score| score.misses(mutant));
        assert!(misses("search_sieve", "search_sieve: mutate -mode inv"));
        assert!(
            !misses("stream_skid", "search_sieve: mutate -mode inv") && !misses("search_sieve", "search_sieve: mutate")
        );
        let figures = record.figures();
        assert_eq!(figures["mutation.stream_skid.found"], 9);
        assert_eq!(figures["mutation.selftest.tiny_knn.score"], 100.0 * 6.0 / 9.0);
        let document = "<!-- mutation units: by a command -->\n<!-- end of mutation -->\n\
            <!-- mutation packages -->\nold\n<!-- end of mutation -->\n";
        let text = record.tabulate(document).unwrap_or_else(|error| panic!("{error}"));
        for part in
            ["| `stream_skid` | 10 | 1 | 9 | 0 | 100.0 % |", "| `tiny_knn` | 10 | 1 | 6 | 3 | 66.7 % |", "| `all` |"]
        {
            assert!(text.contains(part), "`{part}` is missing in: {text}");
        }
        assert!(!text.contains("old"));
    }
}
