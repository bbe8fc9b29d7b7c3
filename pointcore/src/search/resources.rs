//! What a generated search core holds, beside thesis tables 6.2 (arithmetic units) and 6.3 (on-chip storage).

use pointcore_hdl::compiler::Manifest;
use rtl::Design;
use std::collections::BTreeMap;

const BYTE_BITS: f64 = 8.0;
const KILOBYTE: f64 = 1000.0;

/// On-chip storage of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct StorageRow {
    /// The part, by its name in table 6.3.
    pub part: &'static str,
    /// Kilobytes in memories of the generated core.
    pub kilobytes: f64,
    /// Of the thesis' prototype; none where it has no such part.
    pub prototype: Option<f64>,
    /// Of the thesis' variant with the tree in external memory.
    pub off_chip: Option<f64>,
}

/// A part of table 6.3.
struct Part {
    name: &'static str,
    /// Its memories by unit and part of their names; no name stands for all of a unit that are not named elsewhere.
    memories: &'static [(&'static str, Option<&'static str>)],
    /// Kilobytes of the thesis' prototype, and of its variant with the tree in external memory.
    thesis: [f64; 2],
}

const PARTS: [Part; 6] = [
    Part { name: "traversal stack", memories: &[("search_stack", None)], thesis: [2.0, 2.0] },
    Part {
        name: "kd-tree",
        memories: &[("search_traversal", Some("nodes")), ("search_leaf", Some("leaves")), ("search_tree_cache", None)],
        thesis: [170.0, 16.0],
    },
    Part { name: "priority queues", memories: &[("search_queue", Some("rows"))], thesis: [3.0, 4.0] },
    Part { name: "point cache", memories: &[("search_point_cache", None)], thesis: [16.0, 16.0] },
    Part { name: "neighbor cache", memories: &[("search_neighbor_cache", None)], thesis: [8.15, 1.15] },
    Part {
        name: "thread data",
        memories: &[
            ("search_traversal", None),
            ("search_recursion", None),
            ("search_leaf", None),
            ("search_sieve", None),
            ("search_queue", None),
        ],
        thesis: [1.36, 1.36],
    },
];

/// Memories of the core by part of table 6.3; what is left, which is queues between units and delays in datapaths, comes last.
/// The thesis' memory manager has no counterpart: external memory is outside the core.
#[must_use]
pub fn storage(design: &Design) -> Vec<StorageRow> {
    let mut bits = [0; PARTS.len() + 1];
    for module in design.modules() {
        for memory in &module.memories {
            let belongs = |(unit, name): &(&str, Option<&str>)| {
                *unit == module.unit && name.is_none_or(|name| memory.name.contains(name))
            };
            let part = PARTS.iter().position(|part| part.memories.iter().any(belongs));
            bits[part.unwrap_or(PARTS.len())] += module.instances * memory.bits();
        }
    }
    let named = PARTS.iter().map(|part| (part.name, part.thesis.map(Some)));
    let rows = named.chain([("queues and delays", [None, None])]).zip(bits);
    rows.map(|((part, [prototype, off_chip]), bits)| StorageRow {
        part,
        kilobytes: bits as f64 / BYTE_BITS / KILOBYTE,
        prototype,
        off_chip,
    })
    .collect()
}

/// Copies of an arithmetic unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ArithmeticRow {
    /// The kind of unit, by its name in table 6.2.
    pub kind: &'static str,
    /// In the search proper: traversal and leaf processing.
    pub search: u32,
    /// In the neighbor cache.
    pub cache: u32,
    /// Of the thesis' search and neighbor cache.
    pub thesis: [u32; 2],
}

/// Kinds of table 6.2 with the compiler's operators that count as such.
const KINDS: [(&str, &[&str], [u32; 2]); 4] = [
    ("add, subtract", &["add", "sub"], [6, 6]),
    ("multiply", &["mul"], [4, 6]),
    ("divide", &["div"], [0, 0]),
    ("square root", &["sqrt"], [0, 2]),
];

/// Datapaths of the search proper.
const SEARCH: [&str; 2] = ["traversal", "leaf"];

/// Arithmetic units of the core's datapaths.
#[must_use]
pub fn arithmetic(manifests: &BTreeMap<String, Manifest>) -> Vec<ArithmeticRow> {
    let count = |kinds: &[&str], in_search: bool| {
        let chosen = manifests.iter().filter(|(unit, _)| SEARCH.contains(&unit.as_str()) == in_search);
        let operators = chosen.flat_map(|(_, manifest)| &manifest.operators);
        let of_kind = operators.filter(|(name, _)| kinds.contains(&name.split('.').next().unwrap_or_default()));
        of_kind.map(|(_, operator)| operator.instances).sum()
    };
    let row = |(kind, operators, thesis): &(&'static str, &[&str], [u32; 2])| ArithmeticRow {
        kind,
        search: count(operators, true),
        cache: count(operators, false),
        thesis: *thesis,
    };
    KINDS.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::search::SearchCore;
    use pointcore_contract::search::Config;

    #[test]
    fn every_part_is_found_and_nothing_is_lost() {
        let base = Config { neighbor_cache: 8, ..Config::default() };
        for config in [base.clone(), Config { tree_cache: 256, ..base }] {
            let core = SearchCore::generate(&config).expect("the configuration is valid");
            let rows = storage(&core.design);
            assert!(rows.iter().all(|row| row.kilobytes > 0.0), "{rows:?}");
            let of = |part: &str| rows.iter().find(|row| row.part == part).map(|row| row.kilobytes);
            assert!(of("kd-tree") > of("thread data"), "{rows:?}");
            let bits =
                core.design.modules().iter().map(|module| module.instances * module.area.memory_bits).sum::<u64>();
            let kilobytes: f64 = rows.iter().map(|row| row.kilobytes).sum();
            assert!((kilobytes - bits as f64 / BYTE_BITS / KILOBYTE).abs() < 1e-9);
        }
    }

    #[test]
    fn one_lane_takes_the_thesis_arithmetic_units() {
        let core =
            SearchCore::generate(&Config { neighbor_cache: 8, ..Config::default() }).expect("the default is valid");
        let rows = arithmetic(&core.manifests);
        assert_eq!(
            rows.iter().map(|row| row.search).collect::<Vec<_>>(),
            rows.iter().map(|row| row.thesis[0]).collect::<Vec<_>>()
        );
        assert_eq!(rows.iter().map(|row| row.cache).collect::<Vec<_>>(), [7, 6, 0, 2], "an addition more for balls");
    }
}
