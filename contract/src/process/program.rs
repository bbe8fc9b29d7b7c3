//! A checked program.

use super::block::Block;
use super::layout::{Layout, Word};
use super::operation::Source;

/// A block of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Section {
    /// Once an iteration, before the neighbors.
    Init,
    /// Once a neighbor.
    Kernel,
    /// Once an iteration, after the neighbors.
    Final,
}

impl Section {
    /// All of them, in the order in which a query goes through them.
    pub const ALL: [Self; 3] = [Self::Init, Self::Kernel, Self::Final];

    /// Its name in the text.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Init => "init",
            Self::Kernel => "kernel",
            Self::Final => "final",
        }
    }
}

/// An operator on neighborhoods; made of a text by [`Program::parse`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    pub(super) name: String,
    pub(super) text: String,
    /// What a query carries; its position first.
    pub query: Layout,
    /// What a neighbor carries; its position first.
    pub neighbor: Layout,
    /// What a query keeps from block to block and from iteration to iteration, at most
    /// [`STATE_WORDS_MAX`](super::STATE_WORDS_MAX) words; zero when it begins.
    pub state: Layout,
    /// Constants of a run.
    pub settings: Layout,
    /// What `kernel` accumulates, zero when an iteration begins.
    pub sums: Layout,
    /// What leaves with a query that is done.
    pub outputs: Layout,
    pub(super) blocks: [Block; 3],
}

impl Program {
    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text that it was made of.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// One of its blocks; `init` may be empty.
    #[must_use]
    pub const fn block(&self, section: Section) -> &Block {
        &self.blocks[section as usize]
    }

    /// Name and type of a value from outside; those of a layout's words begin with the layout's name.
    #[must_use]
    pub fn word(&self, source: Source) -> Word {
        let (layout, prefix, index) = match source {
            Source::Query(index) => (&self.query, "query", index),
            Source::Neighbor(index) => (&self.neighbor, "neighbor", index),
            Source::Farthest(index) => (&self.neighbor, "farthest", index),
            Source::State(index) => (&self.state, "state", index),
            Source::Sum(index) => (&self.sums, "sum", index),
            Source::Setting(index) => (&self.settings, "setting", index),
            Source::Neighbors => return Word { name: "neighbors".into(), ty: super::Scalar::Int },
            Source::Count => return Word { name: "count".into(), ty: super::Scalar::Int },
        };
        let Word { name, ty } = layout.words().swap_remove(index);
        Word { name: format!("{prefix}_{name}"), ty }
    }
}
