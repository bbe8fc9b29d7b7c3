//! `docs/configuration.md` has a row for every key, made of the keys' descriptions.

use super::{Configuration, parse, read_text};
use pointcore_contract::configuration::{Derived, Key, SetBy, Table, Values};
use pointcore_contract::{points, search, splat};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Set to write the page instead of comparing it.
const WRITE: &str = "POINTCORE_WRITE";

/// What the page has of a core.
struct Core {
    kind: &'static str,
    /// What decides about keys that no configuration sets.
    input: &'static str,
    tables: &'static [Table],
    derived: &'static [Derived],
    defaults: Configuration,
}

fn cores() -> [Core; 3] {
    let (splat, search) = (splat::Config::default(), search::Config::default());
    [
        Core {
            kind: "splat",
            input: "scene",
            tables: splat::Config::TABLES,
            derived: splat::Config::DERIVED,
            defaults: Configuration::Splat(splat),
        },
        Core {
            kind: "search",
            input: "points",
            tables: search::Config::TABLES,
            derived: search::Config::DERIVED,
            defaults: Configuration::Search(search),
        },
        Core {
            kind: "points",
            input: "points",
            tables: points::Config::TABLES,
            derived: points::Config::DERIVED,
            defaults: Configuration::Points(points::Config::default()),
        },
    ]
}

impl Core {
    /// The tables of keys, in Markdown.
    fn rows(&self) -> String {
        let defaults: toml::Table = toml::from_str(&self.defaults.text()).expect("it was written as TOML");
        let mut text = String::new();
        for Table { name, doc, keys } in self.tables {
            let _ = writeln!(text, "\n### `[{name}]`\n\n{}\n", doc.trim());
            text += "| key | values | default | set by | what it does |\n|---|---|---|---|---|\n";
            for Key { name: key, doc, values, set_by } in *keys {
                let values = match values {
                    Values::Range(low, high) => format!("{low} to {high}"),
                    Values::Described(values) => (*values).to_owned(),
                };
                let set_by = match set_by {
                    SetBy::User => "",
                    SetBy::Input => self.input,
                    SetBy::Sweep => "sweep only",
                };
                let default = &defaults[*name][*key];
                let _ = writeln!(text, "| `{key}` | {values} | `{default}` | {set_by} | {} |", doc.trim());
            }
        }
        text += "\n### Derived\n\n| value | follows from | what it is |\n|---|---|---|\n";
        for Derived { name, rule, doc } in self.derived {
            let _ = writeln!(text, "| `{name}` | {rule} | {} |", doc.trim());
        }
        text
    }
}

fn workspace(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// The page with its tables as they should be.
fn with_rows(page: &str) -> String {
    let mut page = page.to_owned();
    for core in cores() {
        let [begin, end] = [format!("<!-- keys of {} -->\n", core.kind), format!("\n<!-- end of {} -->", core.kind)];
        let (head, rest) = page.split_once(&begin).unwrap_or_else(|| panic!("{begin} is missing"));
        let (_, tail) = rest.split_once(&end).unwrap_or_else(|| panic!("{end} is missing"));
        page = [head, &begin, &core.rows(), &end, tail].concat();
    }
    page
}

#[test]
fn the_page_has_every_key_and_no_other() {
    let path = workspace("docs/configuration.md");
    let page = read_text(&path).unwrap();
    let expected = with_rows(&page);
    if std::env::var_os(WRITE).is_some() {
        std::fs::write(&path, expected).expect("the page is writable");
        return;
    }
    assert!(page == expected, "docs/configuration.md is old: {WRITE}=1 cargo test -p pointcore --lib reference");
}

#[test]
fn the_page_names_every_configuration_that_is_there() {
    let page = read_text(&workspace("docs/configuration.md")).unwrap();
    for file in std::fs::read_dir(workspace("configs")).expect("the folder is there") {
        let name = file.unwrap().file_name().into_string().expect("names are ASCII");
        assert!(page.contains(&format!("[configs/{name}](../configs/{name})")), "{name} is missing");
    }
    assert_eq!(page.matches("](../configs/").count(), std::fs::read_dir(workspace("configs")).unwrap().count());
}

#[test]
fn tables_list_the_keys_of_files_each_once() {
    for core in cores() {
        let file: toml::Table = toml::from_str(&core.defaults.text()).expect("it was written as TOML");
        let mut names = BTreeSet::new();
        let tables: BTreeSet<_> = core.tables.iter().map(|table| table.name).chain(["kind"]).collect();
        assert_eq!(file.keys().map(String::as_str).collect::<BTreeSet<_>>(), tables);
        for table in core.tables {
            let written = file[table.name].as_table().expect("a table");
            let listed: BTreeSet<_> = table.keys.iter().map(|key| key.name).collect();
            assert_eq!(written.keys().map(String::as_str).collect::<BTreeSet<_>>(), listed);
            assert!(table.keys.iter().all(|key| names.insert(key.name)), "names are unique: [{}]", table.name);
        }
    }
}

#[test]
fn values_that_the_page_names_are_taken() {
    let mut taken = 0;
    for core in cores() {
        for (table, key) in core.tables.iter().flat_map(|table| table.keys.iter().map(move |key| (table, key))) {
            let values: Vec<String> = match key.values {
                Values::Range(low, high) => [low, high].map(|end| format!("{end}")).into(),
                Values::Described(text) => {
                    text.split('`').filter(|part| part.starts_with('"')).map(str::to_owned).collect()
                }
            };
            for value in values {
                // A real number has a point.
                let value =
                    if key.name == "kernel_gamma" { format!("{:?}", value.parse::<f64>().unwrap()) } else { value };
                let mut text = format!("kind = \"{}\"\n{}.{} = {value}\n", core.kind, table.name, key.name);
                // The smallest index numbers few threads.
                if core.kind == "points" && key.name == "index_bits" {
                    text += "process.process_threads = 16\n";
                }
                parse(Path::new("file.toml"), &text).unwrap_or_else(|error| panic!("{text}{error}"));
                taken += 1;
            }
        }
    }
    assert!(taken > 60, "{taken} values");
}

/// The keys that a file sets in some tables.
fn keys(path: &Path, tables: &[&str]) -> BTreeSet<String> {
    let file: toml::Table = toml::from_str(&read_text(path).unwrap()).unwrap_or_else(|error| panic!("{error}"));
    let tables = tables.iter().filter_map(|table| file.get(*table)?.as_table());
    tables.flat_map(|table| table.keys().cloned()).collect()
}

#[test]
fn what_is_marked_for_sweeps_is_set_by_no_file() {
    let files = |folder: &str| {
        let entries = std::fs::read_dir(workspace(folder)).expect("the folder is there");
        entries.map(|entry| entry.unwrap().path()).filter(|path| path.is_file())
    };
    let mut set: BTreeSet<String> = BTreeSet::new();
    files("configs").for_each(|path| set.extend(keys(&path, &["image", "features", "implementation", "bus"])));
    for folder in ["scenes", "scenes/bench"] {
        files(folder).for_each(|path| set.extend(keys(&path, &["overrides"])));
    }
    for key in cores().iter().flat_map(|core| core.tables).flat_map(|table| table.keys) {
        assert!(key.set_by != SetBy::Sweep || !set.contains(key.name), "`{}` is set by more than sweeps", key.name);
    }
    assert!(set.contains("heap_levels") && set.contains("lanes"), "{set:?}");
}
