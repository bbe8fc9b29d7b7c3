//! Hardware against golden models. Every file of this folder is a part of the one test, so a unit's test is found without being listed.

mod bus;
mod compiler;
mod harness;
mod points;
mod process;
mod search;
mod splat;
automod::dir!("tests");
