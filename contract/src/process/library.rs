//! The programs that come with the project: the files of programs/.

use super::Program;

macro_rules! programs {
    ($($name:literal),* $(,)?) => {
        /// Their names and texts.
        pub const PROGRAMS: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../../programs/", $name, ".pasm")))),*];
    };
}

programs!("covariance", "normals", "mls", "apss", "smooth", "resample", "sph_density", "sph_forces");

/// The program of that name.
///
/// # Panics
/// If there is none; that all of them are programs is tested.
#[must_use]
pub fn program(name: &str) -> Program {
    let (name, text) = PROGRAMS.iter().find(|(known, _)| *known == name).expect("the library has the program");
    Program::parse(&format!("programs/{name}.pasm"), text).expect("a test holds that the programs are well formed")
}
