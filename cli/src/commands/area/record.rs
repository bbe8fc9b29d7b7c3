//! The record of measurements, written, checked, and turned into tables.

use crate::commands::{Failure, Output, write};
use pointcore::configuration::{read_text, wrong};
use pointcore_lab::synthesis::{
    AreaEntry, AreaRecord, MeasuredUnit, Measurement, Revision, Stale, Synthesizer, source_hash,
};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Keeps measurements in a file, one after the other.
pub struct Recorder {
    path: PathBuf,
    writing: Mutex<()>,
}

impl Recorder {
    /// A record in this file, which may be there already.
    pub fn new(path: &Path) -> Result<Self, Failure> {
        AreaRecord::load(path)?;
        Ok(Self { path: path.to_owned(), writing: Mutex::new(()) })
    }

    /// Adds a measurement to what the file holds by now.
    pub fn keep(
        &self,
        synthesizer: &Synthesizer,
        unit: &MeasuredUnit,
        configuration: Option<&Path>,
        measurement: &Measurement,
    ) -> Result<(), Failure> {
        let target = synthesizer.target();
        let source = source_hash(target, unit)?;
        let configuration = configuration.map(Path::to_owned);
        let entry = AreaEntry::new(target, configuration, source, synthesizer.tools(), measurement.clone());
        let _writing = self.writing.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let mut record = AreaRecord::load(&self.path)?;
        record.insert(entry);
        write(&self.path, &record.text())
    }
}

/// The tables of a document as the record has them, and as they are.
fn tabulated(record: &AreaRecord, tables: &Path) -> Result<(String, String), Failure> {
    let present = read_text(tables)?;
    let wanted = record.tabulate(&present).map_err(|problem| wrong(tables, problem))?;
    Ok((wanted, present))
}

/// Writes the tables of a document anew.
pub fn write_tables(record: &Path, tables: &Path) -> Result<(), Failure> {
    let (wanted, present) = tabulated(&AreaRecord::load(record)?, tables)?;
    if wanted == present { Ok(()) } else { write(tables, &wanted) }
}

/// A record that is there and has entries.
fn load(path: &Path) -> Result<AreaRecord, Failure> {
    if !path.exists() {
        return Err(wrong(path, "there is no such record").into());
    }
    let record = AreaRecord::load(path)?;
    if record.entries().is_empty() {
        return Err(wrong(path, "has no entry: nothing was checked").into());
    }
    Ok(record)
}

/// What of a record is of the hardware as it is now, in words and for programs.
fn print_ages(path: &Path, record: &AreaRecord, output: Output) -> Result<(), Failure> {
    let (entries, earlier) = (record.entries().len(), record.earlier());
    let ages = match earlier {
        0 => "all of the hardware as it is now".to_owned(),
        _ => format!(
            "{} of the hardware as it is now, {earlier} of earlier revisions, which they name",
            entries - earlier
        ),
    };
    let document = json!({ "measurements": entries, "earlier": earlier, "stale": 0 });
    output.print(&document, &format!("{}: {entries} measurements, {ages}", path.display()))
}

/// Has what is not of the hardware as it is now name the revision it was measured of.
pub fn mark_stale(path: &Path, revision: &Revision, output: Output) -> Result<(), Failure> {
    let mut record = load(path)?;
    record.mark_stale(revision);
    write(path, &record.text())?;
    print_ages(path, &record, output)
}

/// Compares the record with the hardware as it is now, and the tables with the record.
pub fn check(path: &Path, tables: Option<&Path>, output: Output) -> Result<(), Failure> {
    let record = load(path)?;
    let mut stale = record.stale(path);
    let has_aged = !stale.is_empty();
    if let Some(tables) = tables {
        let (wanted, present) = tabulated(&record, tables)?;
        if wanted != present {
            let remedy = format!("pointcore area --record {} --tables {} --recorded", path.display(), tables.display());
            let problem = format!("the tables of {} are not those of {}", tables.display(), path.display());
            stale.push(Stale { problem, remedy });
        }
    }
    if stale.is_empty() {
        return print_ages(path, &record, output);
    }
    if has_aged {
        stale.push(Stale {
            problem: "what is not measured again can say of what it was measured".to_owned(),
            remedy: format!("pointcore area --mark-stale REVISION --record {}", path.display()),
        });
    }
    let lines = stale.into_iter().map(|Stale { problem, remedy }| format!("  {problem}\n    {remedy}\n"));
    Err(Failure::Stale { path: path.to_owned(), list: lines.collect() })
}
