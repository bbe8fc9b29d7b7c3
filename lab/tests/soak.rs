//! The soak's record and its table, and cases that are kept.

use pointcore_lab::soak::campaign::Campaign;
use pointcore_lab::soak::record::SoakRecord;
use pointcore_tb::verilated::Builder;
use std::path::Path;

#[test]
fn the_table_is_that_of_the_record() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let record = SoakRecord::load(&docs.join("soak.json")).unwrap_or_else(|error| panic!("{error}"));
    let page = std::fs::read_to_string(docs.join("results.md")).expect("the page is there");
    let expected = record.tabulate(&page).unwrap_or_else(|error| panic!("{error}"));
    assert!(page == expected, "run pointcore soak --recorded --record docs/soak.json --tables docs/results.md");
}

/// A search core of one thread, which compiles in no time.
const SMALL: u64 = 3;

#[test]
fn a_case_is_run_once_and_kept() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let builder = Builder::new().unwrap_or_else(|error| panic!("{error}"));
    let open = |seed| Campaign::new(seed, 20_000, folder.path().to_owned(), builder.clone());
    let kept = |campaign: &Campaign| campaign.kept(SMALL).unwrap_or_else(|error| panic!("{error}"));
    let first = open(1);
    assert_eq!(kept(&first), None);
    let outcome = first.run(SMALL).unwrap_or_else(|error| panic!("{error}"));
    assert!(outcome.failure.is_none() && outcome.cycles >= 20_000 && outcome.items > 0, "{outcome:?}");
    assert_eq!(kept(&open(1)), Some(outcome.clone()), "another process goes on where this one was");
    let again = open(1).run(SMALL).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again, outcome, "without a compiler's work");
    assert_eq!(kept(&open(2)), None, "another seed has other cases");
}
