//! Errors by what their reader can do about them, with the library's messages.

use pointcore::configuration::ConfigurationError;
use pointcore::generated::GenerateError;
use pointcore::package::PackageError;
use pointcore::plan::PlanError;
use pointcore::process::ProcessError;
use pointcore::scene::SceneError;
use pointcore::search::SearchError;
use pointcore::splat::RenderError;
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::VerilatedError;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::Path;
use std::sync::Once;

/// Whose fault it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorKind {
    /// What was given makes no sense.
    Input,
    /// A file cannot be read or written.
    File,
    /// The hardware could not be generated, built or run, a tool is missing, or hardware and model differ.
    Hardware,
    /// A fault of pointcore itself.
    Internal,
}

/// An error as it crosses to another language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BindingError {
    /// Whose fault it is.
    pub kind: ErrorKind,
    /// What is wrong, where, and what would be right.
    pub message: String,
}

impl BindingError {
    /// A fault of what was given.
    #[must_use]
    pub fn input(message: impl Into<String>) -> Self {
        Self { kind: ErrorKind::Input, message: message.into() }
    }

    pub(crate) fn write(path: &Path, source: &std::io::Error) -> Self {
        Self { kind: ErrorKind::File, message: format!("{}: cannot be written: {source}", path.display()) }
    }
}

impl std::fmt::Display for BindingError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for BindingError {}

/// Runs what another language called: a panic, which must not unwind into its frames, becomes an error.
///
/// # Errors
/// Those of `run`, and its panics. What a panic may have left half done is not to be used again.
pub fn guarded<T>(run: impl FnOnce() -> Result<T, BindingError>) -> Result<T, BindingError> {
    silence_readers();
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|payload| Err(panicked(payload.as_ref())))
}

/// Panics of readers of model files become errors, and are not spoken of twice. The library has a panic hook of its own: that of the
/// program around it is another.
fn silence_readers() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let hook = take_hook();
        set_hook(Box::new(move |panic| {
            if !pointcore::scene::is_guarded() {
                hook(panic);
            }
        }));
    });
}

fn panicked(payload: &(dyn Any + Send)) -> BindingError {
    let text = payload.downcast_ref::<String>().map(String::as_str).or_else(|| payload.downcast_ref().copied());
    let message = format!("a fault of pointcore, please report it: {}", text.unwrap_or("it gave no reason"));
    BindingError { kind: ErrorKind::Internal, message }
}

/// Errors that tell their kind.
trait Kind: std::fmt::Display {
    fn kind(&self) -> ErrorKind;

    /// What is wrong, without the names of the command's options.
    fn message(&self) -> String {
        self.to_string()
    }
}

impl<E: Kind> From<E> for BindingError {
    fn from(error: E) -> Self {
        Self { kind: error.kind(), message: error.message() }
    }
}

impl Kind for SceneError {
    fn kind(&self) -> ErrorKind {
        if matches!(self, Self::Read { .. }) { ErrorKind::File } else { ErrorKind::Input }
    }
}

impl Kind for PlanError {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Input
    }
}

impl Kind for ConfigurationError {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Input
    }
}

impl Kind for GenerateError {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Hardware
    }
}

impl Kind for VerilatedError {
    fn kind(&self) -> ErrorKind {
        if matches!(self, Self::File(_)) { ErrorKind::File } else { ErrorKind::Hardware }
    }
}

impl Kind for LockstepError {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::Verilated(error) => error.kind(),
            Self::Seed { .. } => ErrorKind::Input,
            _ => ErrorKind::Hardware,
        }
    }
}

impl Kind for SearchError {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::Model(error) => error.kind(),
            Self::Verilated(error) => error.kind(),
            Self::Lockstep(error) => error.kind(),
            Self::Generate(_) | Self::Stuck { .. } => ErrorKind::Hardware,
            _ => ErrorKind::Input,
        }
    }
}

impl Kind for ProcessError {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::Points(error) => error.kind(),
            Self::Model(error) => error.kind(),
            Self::Read { .. } => ErrorKind::File,
            Self::Generate(_) => ErrorKind::Hardware,
            _ => ErrorKind::Input,
        }
    }

    fn message(&self) -> String {
        match self {
            Self::Operation { name, known } => {
                let known = known.join(", ");
                format!(
                    "there is no operation `{name}`: expected {known}, the path of a .pasm file, or a program's text"
                )
            }
            Self::MissingSetting { program, field } => {
                let told = format!("setting `{}` of `{program}` does not follow from the points", field.name);
                told + ": expected it among the settings"
            }
            Self::MissingAttribute { points, program, whose, field } => {
                let name = &field.name;
                format!("{points}: `{program}` reads {whose}.{name} ({}): expected an attribute `{name}`", field.ty)
            }
            Self::Attribute { points, name, index, problem } => format!("{points}: {name} of vertex {index} {problem}"),
            Self::NoScale { points, setting } => format!(
                "{points}: all points lie in one place, so there is no spacing to derive `{setting}` from: \
                 expected a radius, or `{setting}` among the settings"
            ),
            _ => self.to_string(),
        }
    }
}

impl Kind for RenderError {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::Plan(error) => error.kind(),
            Self::Generate(error) => error.kind(),
            Self::Verilated(error) => error.kind(),
            Self::Lockstep(error) => error.kind(),
            Self::Memory(_) | Self::Frame { .. } => ErrorKind::Input,
        }
    }
}

impl Kind for PackageError {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::Generate(error) => error.kind(),
            Self::Frame(error) => error.kind(),
            Self::Search(error) => error.kind(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_become_errors() {
        let literal = guarded::<()>(|| panic!("a literal"));
        let number = 7;
        let formatted = guarded::<()>(|| panic!("number {number}"));
        for (result, text) in [(literal, "a literal"), (formatted, "number 7")] {
            let error = result.expect_err("it panicked");
            assert_eq!(error.kind, ErrorKind::Internal);
            assert!(error.message.contains(text), "{error}");
        }
        assert_eq!(guarded(|| Ok(3)), Ok(3));
    }

    #[test]
    fn a_missing_file_is_told_from_a_bad_one() {
        let missing = SceneError::Read { path: "a.ply".into(), source: std::io::Error::other("gone") };
        assert_eq!(BindingError::from(SearchError::Model(missing)).kind, ErrorKind::File);
        assert_eq!(BindingError::from(SearchError::NoPoint).kind, ErrorKind::Input);
    }
}
