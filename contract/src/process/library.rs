//! The programs that come with the project: the files of programs/.

/// Their names and texts.
pub const PROGRAMS: &[(&str, &str)] = &[("mls", include_str!("../../../programs/mls.pasm"))];

/// The text of the program of that name.
#[must_use]
pub fn text(name: &str) -> Option<&'static str> {
    PROGRAMS.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}
