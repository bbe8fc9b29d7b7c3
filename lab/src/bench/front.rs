//! The front door in figures: models that end right, mistakes that end in a clear error, and how long the first picture takes.

use crate::front::models::{self, Case};
use crate::front::program::Program;
use crate::front::refusals;
use crate::{Figures, LabError, note};
use pointcore_tb::cache::file;
use pointcore_tb::scratch::Scratch;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Runs the command at `program` on everything that the tables of [`crate::front`] hold, and on the scans at `scans` besides.
///
/// # Errors
/// There is no place for the cases, or a scan cannot be read.
pub fn figures(program: &Path, scans: &[PathBuf], figures: &mut Figures) -> Result<(), LabError> {
    let folder = std::env::temp_dir().join(format!("pointcore-front-{}", std::process::id()));
    let scratch = Scratch::create(folder.clone()).map_err(file("create", &folder))?;
    let place = |name: &str| {
        let folder = scratch.path().join(name);
        std::fs::create_dir(&folder).map_err(file("create", &folder))?;
        Ok::<_, LabError>(Program { path: program.to_owned(), folder })
    };
    let mut count = |key: &str, right_key: &str, judged: Vec<Result<(), String>>| {
        judged.iter().filter_map(|result| result.as_ref().err()).for_each(|problem| note!("{problem}"));
        figures.insert(format!("front.{key}"), judged.len().into());
        figures.insert(format!("front.{right_key}"), judged.iter().filter(|result| result.is_ok()).count().into());
    };

    let models = place("models")?;
    let scans = scans.iter().map(|path| Case::scan(path)).collect::<Result<Vec<_>, _>>()?;
    let cases: Vec<Case> = models::cases().into_iter().chain(scans).collect();
    let judge = |case: &Case| case.judge(&models).map(|figures| note!("{figures}"));
    count("models", "models_right", cases.iter().map(judge).collect());

    let mistakes = place("mistakes")?;
    refusals::prepare(&mistakes.folder).map_err(file("write to", &mistakes.folder))?;
    let judged = refusals::cases().iter().map(|case| case.judge(&mistakes)).collect();
    count("bad_inputs", "bad_inputs_clear", judged);

    if let Some(seconds) = first_picture(&place("first")?) {
        figures.insert("front.first_picture_s".to_owned(), seconds.into());
    }
    Ok(())
}

/// Seconds from the start of the command to the picture of a model of one's own, on the hardware in lockstep, everything generated and
/// compiled on the way: the cache is empty.
fn first_picture(program: &Program) -> Option<f64> {
    let case = models::first();
    std::fs::write(program.file(&case.file), &case.bytes).ok()?;
    let started = Instant::now();
    let said = program.run(["run", case.file.as_str()]);
    let seconds = started.elapsed().as_secs_f64();
    let is_there = program.file("out").join(case.file.trim_end_matches(".ply")).join("frame.png").is_file();
    match said {
        Ok(said) if said.code == Some(0) && is_there => Some(seconds),
        Ok(said) => {
            note!("no first picture: {}", said.error);
            None
        }
        Err(problem) => {
            note!("no first picture: {problem}");
            None
        }
    }
}
