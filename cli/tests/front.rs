//! The front door, case by case: models of one's own, and mistakes. The tables are `pointcore_lab::front`'s.

use pointcore_lab::front::models::{self, Case};
use pointcore_lab::front::program::Program;
use pointcore_lab::front::refusals;
use pointcore_tb::skipped::skipped;
use std::collections::HashSet;
use std::path::Path;
use std::thread;
use tempfile::TempDir;

/// Scans beside the project.
const SCANS: [&str; 3] = ["igea.ply", "stanford-bunny.obj", "dragon.ply"];

/// Where cases are run; dropped, it is gone.
fn place() -> (TempDir, Program) {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let program = Program { path: env!("CARGO_BIN_EXE_pointcore").into(), folder: folder.path().to_owned() };
    (folder, program)
}

/// Judges cases, several at a time; fails with all that is said of those which are wrong.
fn assert_all<T: Sync, R: Send>(cases: &[T], judge: impl Fn(&T) -> Result<R, String> + Sync) {
    let jobs = thread::available_parallelism().map_or(1, usize::from);
    let judged =
        |job: usize| cases.iter().skip(job).step_by(jobs).filter_map(|case| judge(case).err()).collect::<Vec<_>>();
    let wrong: Vec<String> = thread::scope(|scope| {
        let judged = &judged;
        let jobs: Vec<_> = (0..jobs).map(|job| scope.spawn(move || judged(job))).collect();
        jobs.into_iter().flat_map(|job| job.join().expect("no case panics")).collect()
    });
    assert!(wrong.is_empty(), "{} of {} cases:\n{}", wrong.len(), cases.len(), wrong.join("\n\n"));
}

#[test]
fn models_of_ones_own_end_in_right_pictures_and_right_neighbors() {
    const LEAST_CASES: usize = 12;
    let mut cases = models::cases();
    assert!(cases.len() >= LEAST_CASES, "{} models", cases.len());
    for name in SCANS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(name);
        if path.exists() {
            cases.push(Case::scan(&path).unwrap_or_else(|error| panic!("{error}")));
        } else {
            skipped(&format!("there is no {}", path.display()));
        }
    }
    let (_folder, program) = place();
    assert_all(&cases, |case| case.judge(&program).inspect(|figures| println!("{figures}")));
}

#[test]
fn wrong_input_ends_in_one_clear_error_and_leaves_nothing_behind() {
    const LEAST_CASES: usize = 60;
    let cases = refusals::cases();
    let distinct: HashSet<_> = cases.iter().map(|case| case.arguments).collect();
    assert!(distinct.len() >= LEAST_CASES, "{} mistakes", distinct.len());
    let (_folder, program) = place();
    refusals::prepare(&program.folder).expect("a temporary folder can be written");
    // One after the other: what a case leaves behind is its own.
    let wrong: Vec<_> = cases.iter().filter_map(|case| case.judge(&program).err()).collect();
    assert!(wrong.is_empty(), "{} of {} cases:\n{}", wrong.len(), cases.len(), wrong.join("\n\n"));
}
