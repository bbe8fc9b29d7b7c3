//! Waveforms among the results of a run, with what a viewer needs.

use super::{Failure, write};
use pointcore::waveform::{View, Window};
use std::fs;
use std::path::Path;

/// The folder of the filters that turn words into numbers.
const FILTERS: &str = "formats";
/// Who may run a filter: everybody who may read it.
#[cfg(unix)]
const EXECUTABLE: u32 = 0o755;

/// Says so where a run was over before its window began.
pub fn finish(window: Option<&Window>, cycles: u64) -> Result<(), Failure> {
    match window {
        Some(Window(window)) if window.start >= cycles => {
            let problem = format!("the run has {cycles} cycles: expected a window that begins within");
            Err(Failure::Usage(format!("--trace-window {}..{}: {problem}", window.start, window.end)))
        }
        _ => Ok(()),
    }
}

/// Writes the view of a waveform into `folder`, from which it will be moved to `place`.
pub fn write_view(view: &View, waveform: &str, folder: &Path, place: &Path) -> Result<(), Failure> {
    let failed = |source| Failure::Write { path: folder.to_owned(), source };
    let program = std::env::current_exe().map_err(failed)?;
    for (name, text) in view.filters(&program) {
        let path = folder.join(FILTERS).join(name);
        write(&path, &text)?;
        #[cfg(unix)]
        fs::set_permissions(&path, std::os::unix::fs::PermissionsExt::from_mode(EXECUTABLE)).map_err(failed)?;
    }
    let place = std::path::absolute(place).map_err(failed)?;
    let text = view.save_file(&place.join(waveform), &place.join(FILTERS));
    write(&folder.join(waveform).with_extension("gtkw"), &text)
}
