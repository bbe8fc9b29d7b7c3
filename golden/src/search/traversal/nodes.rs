//! Where the traversal gets its nodes from: memory on chip, or a tree cache.

use super::In;
use crate::stream::Skid;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, Node, NodeRecord};

/// The ring between a node's address and what the node holds.
#[derive(Clone, Debug)]
pub enum Nodes {
    /// The node memory.
    OnChip(Vec<Node>),
    /// To the tree cache and back.
    Cached { node: Skid<Descent>, record: Skid<NodeRecord> },
}

impl Nodes {
    pub fn new(config: &Config) -> Self {
        if config.tree_cache > 0 {
            Self::Cached { node: Skid::default(), record: Skid::default() }
        } else {
            Self::OnChip(vec![Node::default(); 1 << config.tree_depth])
        }
    }

    /// Whether a node can be asked for.
    pub fn has_room(&self) -> bool {
        match self {
            Self::OnChip(_) => true,
            Self::Cached { node, .. } => node.in_ready(),
        }
    }

    /// The node that is visited next when the ring moves on and asks for `wanted`.
    pub fn read(&self, wanted: Option<Descent>) -> Option<NodeRecord> {
        match self {
            Self::OnChip(memory) => wanted.map(|descent| {
                // A node of the deepest level reads what does not matter.
                let address = descent.node as usize & (memory.len() - 1);
                NodeRecord { descent, node: memory[address] }
            }),
            Self::Cached { record, .. } => record.out().copied(),
        }
    }

    /// What the tree cache is asked for.
    pub fn wanted(&self) -> Option<Descent> {
        match self {
            Self::OnChip(_) => None,
            Self::Cached { node, .. } => node.out().copied(),
        }
    }

    /// Whether a node from the tree cache is accepted.
    pub fn takes_record(&self) -> bool {
        match self {
            Self::OnChip(_) => false,
            Self::Cached { record, .. } => record.in_ready(),
        }
    }

    /// The clock edge; `wanted` is what the ring asks for if it moves on.
    pub fn step(&mut self, wanted: Option<Descent>, advances: bool, inputs: &In) {
        match self {
            Self::OnChip(memory) => {
                if let Some(write) = inputs.tree.filter(|write| !write.is_leaf) {
                    memory[write.address as usize] = write.node;
                }
            }
            Self::Cached { node, record } => {
                node.step(wanted.filter(|_| advances), inputs.node_ready);
                record.step(inputs.record, advances);
            }
        }
    }
}
