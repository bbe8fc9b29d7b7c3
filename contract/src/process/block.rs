//! A block of a program: straight-line nodes and what becomes of them.

use super::layout::Scalar;
use super::operation::{Operation, Source};

/// A node of a block, by its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub(super) usize);

impl NodeId {
    /// Position in [`Block::nodes`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

/// One value of a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// What computes it.
    pub operation: Operation,
    /// What it is computed from; all earlier in the block.
    pub operands: Vec<NodeId>,
    /// Its type.
    pub ty: Scalar,
    /// What the text calls it, in letters, digits and underscores.
    pub name: Option<String>,
}

/// A field that is written, if a condition holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Store {
    /// Name of the field.
    pub field: String,
    /// Position of its first word in the state.
    pub first: usize,
    /// The new words.
    pub words: Vec<NodeId>,
    /// When it is written; always without one.
    pub condition: Option<NodeId>,
}

/// What becomes of a block's values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Results {
    /// What is added to each word of the sums; in `kernel`.
    pub addends: Vec<NodeId>,
    /// Words of the outputs; in `final`.
    pub outputs: Vec<NodeId>,
    /// State that is written; in `init` and `final`.
    pub stores: Vec<Store>,
    /// The query's new position; in `final`. Its field is the query's.
    pub movement: Option<Store>,
    /// Whether the query is done; in `final`. A query is done without it.
    pub done: Option<NodeId>,
    /// Whether a query that is not done needs the neighbors of its position; in `final`. It keeps those it has without
    /// it.
    pub search: Option<NodeId>,
}

/// A straight-line program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Block {
    pub(super) nodes: Vec<Node>,
    pub(super) results: Results,
}

impl Block {
    /// All values; operands come before their users.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// What becomes of them.
    #[must_use]
    pub const fn results(&self) -> &Results {
        &self.results
    }

    /// A node.
    #[must_use]
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0]
    }

    /// What the block reads, each once, sorted.
    #[must_use]
    pub fn sources(&self) -> Vec<Source> {
        let source = |node: &Node| match node.operation {
            Operation::Input(source) => Some(source),
            _ => None,
        };
        let mut sources: Vec<Source> = self.nodes.iter().filter_map(source).collect();
        sources.sort_unstable();
        sources
    }
}
