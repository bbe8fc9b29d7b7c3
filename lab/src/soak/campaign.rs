//! A campaign: cases by the number, each kept when it is finished.
//!
//! A finished case is an entry of a cache, by its seed, its number and the sources of models and hardware. Any number
//! of processes may fill one cache: a campaign that was interrupted goes on where it was, and one that was spread over
//! machines is put together by running it again.

use super::case::{Case, CaseOutcome, Extent};
use super::device::AnyConfig;
use crate::LabError;
use crate::accuracy::{read_result, write_result};
use pointcore_tb::cache::{Cache, key};
use pointcore_tb::verilated::{Builder, Library};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Hash of the sources that decide what a case comes to; the build script makes it.
pub const SOURCES: &str = env!("POINTCORE_SOAK_SOURCES");

/// Cases of one seed.
pub struct Campaign {
    seed: u64,
    cycles: u64,
    cache: Cache,
    builder: Arc<Builder>,
}

impl Campaign {
    /// A campaign that runs so many cycles on each configuration, and keeps its cases in `folder`.
    #[must_use]
    pub fn new(seed: u64, cycles: u64, folder: PathBuf, builder: Arc<Builder>) -> Self {
        Self { seed, cycles, cache: Cache::new(folder), builder }
    }

    const fn case(&self, number: u64) -> Case {
        Case { seed: self.seed, number, given: None }
    }

    fn key(&self, number: u64) -> String {
        key(["soak", SOURCES, &self.seed.to_string(), &number.to_string(), &self.cycles.to_string()])
    }

    /// What is kept of a case.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn kept(&self, number: u64) -> Result<Option<CaseOutcome>, LabError> {
        self.cache.existing(&self.key(number)).map(|folder| read_result(&folder)).transpose()
    }

    /// Runs a case that is not kept. Of a clean one the compiled core is not kept: no other case has its configuration.
    ///
    /// # Errors
    /// It cannot be run or kept.
    pub fn run(&self, number: u64) -> Result<CaseOutcome, LabError> {
        let folder = self.cache.entry(&self.key(number), |folder| {
            let device = self.case(number).device(&self.builder)?;
            let outcome = self.case(number).run(&device, Extent::Cycles(self.cycles))?;
            if outcome.failure.is_none() {
                discard(device.library());
            }
            write_result(folder, &outcome)
        })?;
        read_result(&folder)
    }

    /// Runs a case, or one run of it, whether it is kept or not; keeps nothing.
    ///
    /// # Errors
    /// It cannot be run.
    pub fn again(&self, number: u64, run: Option<u64>) -> Result<CaseOutcome, LabError> {
        self.alone(&self.case(number), run)
    }

    /// Runs the configuration of a file, or one run on it; keeps nothing.
    ///
    /// # Errors
    /// It cannot be run.
    pub fn given(&self, path: &Path, config: AnyConfig, run: Option<u64>) -> Result<CaseOutcome, LabError> {
        self.alone(&Case { seed: self.seed, number: 0, given: Some((path.to_owned(), config)) }, run)
    }

    fn alone(&self, case: &Case, run: Option<u64>) -> Result<CaseOutcome, LabError> {
        let extent = run.map_or(Extent::Cycles(self.cycles), Extent::Run);
        case.run(&case.device(&self.builder)?, extent)
    }
}

/// Removes a compiled core from its cache.
fn discard(library: &Library) {
    let digest = library.digest();
    let entries = fs::read_dir(library.cache()).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| entry.file_name().to_string_lossy().starts_with(digest)) {
        // What cannot be removed takes some space, and no more.
        _ = if entry.path().is_dir() { fs::remove_dir_all(entry.path()) } else { fs::remove_file(entry.path()) };
    }
}
