//! The front door: what a user meets who comes with a model, with points, or with a mistake.
//!
//! A model of one's own must end in a right picture and right neighbors, a mistake in one clear error and exit code 2. The cases are
//! tables: [`models`] and [`refusals`]. The command's tests assert all of them, `pointcore bench` counts them.

mod files;
pub mod models;
mod neighbors;
mod picture;
pub mod program;
pub mod refusals;
mod shapes;

/// The folder of the cache that runs are given, in the folder they are started in.
pub const CACHE_FOLDER: &str = "cache";
