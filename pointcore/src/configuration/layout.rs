//! Which core a configuration file is for, and whether each of its keys stands where it belongs.

use crate::wording::plain;
use pointcore_contract::configuration::{Derived, Key, Table};
use pointcore_contract::{points, search, splat};
use std::fmt::Display;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// The key that every file has.
const KIND: &str = "kind";

/// What the key `kind` may say.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Splat,
    Search,
    Points,
}

impl Kind {
    const ALL: [Self; 3] = [Self::Splat, Self::Search, Self::Points];

    const fn name(self) -> &'static str {
        match self {
            Self::Splat => "splat",
            Self::Search => "search",
            Self::Points => "points",
        }
    }

    const fn tables(self) -> &'static [Table] {
        match self {
            Self::Splat => splat::Config::TABLES,
            Self::Search => search::Config::TABLES,
            Self::Points => points::Config::TABLES,
        }
    }

    /// What was a key, or might be taken for one.
    fn derived(self, name: &str) -> Option<&'static Derived> {
        let all = match self {
            Self::Splat => splat::Config::DERIVED,
            Self::Search => search::Config::DERIVED,
            Self::Points => points::Config::DERIVED,
        };
        all.iter().find(|derived| derived.name == name)
    }

    fn knows(self, name: &str) -> bool {
        self.tables().iter().any(|table| table.name == name) || self.table_of(name).is_some()
    }

    /// The table with a key.
    fn table_of(self, name: &str) -> Option<&'static Table> {
        self.tables().iter().find(|table| table.keys.iter().any(|key| key.name == name))
    }

    /// Why a key stands wrong where only some are expected.
    fn misplaced(self, name: &str, expected: &str) -> String {
        if let Some(Derived { rule, .. }) = self.derived(name) {
            return format!("`{name}` is no key, it follows from others ({rule}): remove the line");
        }
        let other = Self::ALL.into_iter().find(|other| *other != self && other.knows(name));
        match (self.table_of(name), other) {
            (Some(table), _) => format!("`{name}` belongs into the table [{}]", table.name),
            (None, Some(other)) => {
                let (own, other) = (self.name(), other.name());
                format!("`{name}` goes with `kind = \"{other}\"`, and the file says `kind = \"{own}\"`")
            }
            (None, None) => format!("`{name}` is unknown: expected {expected}"),
        }
    }

    /// The first key that stands wrong, and why.
    fn first_misplaced(self, file: &DeTable<'_>) -> Option<(Range<usize>, String)> {
        let mut wrong = Vec::new();
        for (name, value) in file.iter().filter(|(name, _)| name.get_ref() != KIND) {
            let text: &str = name.get_ref();
            let Some(table) = self.tables().iter().find(|table| table.name == text) else {
                let tables = listed(self.tables().iter().map(|table| format!("[{}]", table.name)));
                wrong.push((name.span(), self.misplaced(text, &format!("the tables {tables}"))));
                continue;
            };
            let DeValue::Table(keys) = value.get_ref() else {
                wrong.push((name.span(), format!("`{text}` is a table: write its keys below the line [{text}]")));
                continue;
            };
            let expected = || listed(table.keys.iter().map(|key| format!("`{}`", key.name)));
            let is_known = |name: &str| table.keys.iter().any(|key: &Key| key.name == name);
            let unknown = keys.keys().filter(|key| !is_known(key.get_ref()));
            wrong.extend(unknown.map(|key| (key.span(), self.misplaced(key.get_ref(), &expected()))));
        }
        wrong.into_iter().min_by_key(|(span, _)| span.start)
    }
}

/// The core that a file is for.
///
/// # Errors
/// The text is no TOML, does not say for which core it is, or has keys where none of that name belong.
pub(super) fn check(text: &str) -> Result<Kind, String> {
    let file = DeTable::parse(text).map_err(|error| plain(&error))?;
    let at = |span: Range<usize>, problem: &dyn Display| {
        format!("line {}: {problem}", text[..span.start].matches('\n').count() + 1)
    };
    let Some(kind) = file.get_ref().get(KIND) else {
        return Err("the line `kind = \"splat\"`, for the renderer, `kind = \"search\"`, for the neighbor search, or \
                    `kind = \"points\"`, for a search with a program behind it, is missing: add it at the top"
            .to_owned());
    };
    let named = Kind::ALL.into_iter().find(|known| kind.get_ref().as_str() == Some(known.name()));
    let Some(named) = named else {
        let problem = format!("`kind = {}`: expected \"splat\", \"search\" or \"points\"", &text[kind.span()]);
        return Err(at(kind.span(), &problem));
    };
    match named.first_misplaced(file.get_ref()) {
        Some((span, problem)) => Err(at(span, &problem)),
        None => Ok(named),
    }
}

fn listed(names: impl Iterator<Item = String>) -> String {
    names.collect::<Vec<_>>().join(", ")
}
