//! Other Verilog in the place of a source, where the environment asks for it: tests run changed hardware without knowing of it.
//!
//! Mutation testing is made of this: it finds out which sources a test builds, and has the test run again with a mutant of one.

use std::borrow::Cow;
use std::cell::Cell;
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::thread;

use super::{ModuleInterface, VerilatedError, VerilogSource};
use crate::cache::{file, key};

/// The variable that names the folder of substitutes.
///
/// `<digest>.v` in it is verilated in the place of the source with that digest. A source without one is written to
/// `<digest>.original`, what its modules show to each other to `<digest>.interfaces`, and a line of [`USES`] says who builds it.
pub const VARIABLE: &str = "POINTCORE_SUBSTITUTES";

/// The variable that says which of a test's [`cases`] are run, by their numbers with commas between them; all where it is not set.
pub const CASES: &str = "POINTCORE_CASES";

/// The variable with an argument for the simulator, as for Verilog that asks by `$value$plusargs`.
pub const ARGUMENT: &str = "POINTCORE_PLUSARG";

/// File of the folder with a line a build: the source's digest, its top module, the thread, which a test gives its name, and the number
/// of the [case](cases), or a dash.
pub const USES: &str = "uses";

/// Ending of a source as it is, beside its digest.
pub const ORIGINAL: &str = "original";

/// Ending of the interfaces of a source's modules, a list of [`ModuleInterface`] in JSON, beside its digest.
pub const INTERFACES: &str = "interfaces";

/// What of a source counts: its text and which module is the top.
#[must_use]
pub fn digest(verilog: &str, top: &str) -> String {
    key([verilog, top])[..16].to_owned()
}

/// Whether the environment names a folder.
#[must_use]
pub fn are_asked_for() -> bool {
    std::env::var_os(VARIABLE).is_some()
}

thread_local! {
    /// The case that this thread is at.
    static CASE: Cell<Option<usize>> = const { Cell::new(None) };
}

/// The cases of a test, each with hardware of its own: a mutant of one is tried without the others.
pub fn cases<T>(all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    let asked: Option<Vec<usize>> = std::env::var(CASES).ok().map(|cases| {
        let number = |case: &str| case.parse().unwrap_or_else(|_| panic!("{CASES}={cases}: expected numbers"));
        cases.split(',').map(number).collect()
    });
    let mut all = all.into_iter().enumerate();
    std::iter::from_fn(move || {
        let next = all.find(|(case, _)| asked.as_ref().is_none_or(|asked| asked.contains(case)));
        CASE.set(next.as_ref().map(|(case, _)| *case));
        next.map(|(_, it)| it)
    })
}

/// The source that is to be built.
pub(super) fn of(source: &VerilogSource) -> Result<Cow<'_, VerilogSource>, VerilatedError> {
    match std::env::var_os(VARIABLE) {
        Some(folder) => within(source, Path::new(&folder)),
        None => Ok(Cow::Borrowed(source)),
    }
}

fn within<'a>(source: &'a VerilogSource, folder: &Path) -> Result<Cow<'a, VerilogSource>, VerilatedError> {
    let digest = digest(&source.verilog, &source.top);
    let path = folder.join(format!("{digest}.v"));
    match fs::read_to_string(&path) {
        Ok(verilog) => return Ok(Cow::Owned(VerilogSource { verilog, ..source.clone() })),
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        Err(error) => return Err(file("read", &path)(error).into()),
    }
    let VerilogSource { top, ports, streams, .. } = source.clone();
    let inner = source.interfaces.iter().filter(|interface| interface.name != top).cloned();
    let interfaces: Vec<_> = inner.chain([ModuleInterface { name: top.clone(), ports, streams }]).collect();
    let interfaces = serde_json::to_string(&interfaces).expect("interfaces have no maps");
    for (ending, text) in [(ORIGINAL, &source.verilog), (INTERFACES, &interfaces)] {
        let path = folder.join(format!("{digest}.{ending}"));
        fs::write(&path, text).map_err(file("write", &path))?;
    }
    let uses = folder.join(USES);
    let case = CASE.get().map_or_else(|| "-".to_owned(), |case| case.to_string());
    let line = format!("{digest} {} {} {case}\n", source.top, thread::current().name().unwrap_or("-"));
    let appended = OpenOptions::new().create(true).append(true).open(&uses);
    appended.and_then(|mut opened| opened.write_all(line.as_bytes())).map_err(file("write", &uses))?;
    Ok(Cow::Borrowed(source))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_is_told_of_until_it_has_a_substitute() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let source = VerilogSource {
            verilog: "module a;".into(),
            top: "a".into(),
            ports: Vec::new(),
            streams: Vec::new(),
            interfaces: Vec::new(),
        };
        let built = |source| within(source, folder.path()).unwrap_or_else(|error| panic!("{error}")).into_owned();
        assert_eq!(built(&source), source);
        let digest = digest("module a;", "a");
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap_or_default();
        assert_eq!(read(&format!("{digest}.{ORIGINAL}")), source.verilog);
        assert!(read(USES).starts_with(&format!("{digest} a ")) && read(USES).ends_with(" -\n"), "{}", read(USES));
        let second = cases(["first", "second"]).nth(1);
        assert_eq!(second, Some("second"));
        built(&source);
        assert!(read(USES).ends_with(" 1\n"), "{}", read(USES));
        fs::write(folder.path().join(format!("{digest}.v")), "module a; wire b;").expect("it can be written");
        assert_eq!(built(&source).verilog, "module a; wire b;");
    }
}
