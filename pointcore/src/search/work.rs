//! What a host works on.

use super::kdtree::Tree;
use super::query::Asked;
use super::reuse::{QueryKind, Reuse};
use crate::memory::MemorySettings;
use pointcore_contract::search::Config;

/// What a host works on.
#[derive(Clone, Copy)]
pub struct Work<'a> {
    /// The hardware's configuration.
    pub config: &'a Config,
    /// The tree and its points.
    pub tree: &'a Tree,
    /// What to ask.
    pub queries: &'a [Asked],
    /// What the neighbor cache may answer, if there is one.
    pub reuse: Reuse,
    /// Of which kind all queries are, as the neighbor cache needs it.
    pub kind: QueryKind,
    /// How the memory answers.
    pub memory: MemorySettings,
}
