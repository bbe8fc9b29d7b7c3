//! Units that walk the tree.

use crate::search::Config;
use crate::search::records::{Descent, LeafVisit, NodeRecord, Path, Push, Radius, Start, Thread, TreeWrite};
use crate::unit;

/// Descends to a leaf and pushes the paths it does not take.
#[unit(search_traversal, config: Config)]
pub struct Traversal {
    /// Write to the node memory.
    #[when(config.tree_cache == 0)]
    tree: PulseIn<TreeWrite>,
    /// Nodes wanted of the tree cache.
    #[when(config.tree_cache > 0)]
    node: Out<Descent>,
    /// Nodes from the tree cache.
    #[when(config.tree_cache > 0)]
    record: In<NodeRecord>,
    /// A thread taking up a query.
    start: PulseIn<Start>,
    /// Descents from the root.
    descend: In<Descent>,
    /// Descents from a path that was not taken before.
    resume: In<Descent>,
    /// A path to remember.
    push: PulseOut<Push>,
    /// Leaves reached.
    leaf: Out<LeafVisit>,
    /// A thread's descent ended in a leaf.
    reached: PulseOut<Thread>,
    /// A node was visited.
    event_node: Output<bool>,
}

/// Keeps the paths that each thread has not taken yet.
#[unit(search_stack, config: Config)]
pub struct Stack {
    /// A path to remember.
    push: PulseIn<Push>,
    /// A thread that wants its last path back.
    pop: PulseIn<Thread>,
    /// The stack of the last pop was empty.
    top_empty: Output<bool>,
    /// Else the path that it found.
    top: Output<Path>,
}

/// Takes up the nearest path that the radius still reaches.
#[unit(search_recursion, config: Config)]
pub struct Recursion {
    /// A thread taking up a query.
    start: PulseIn<Start>,
    /// A thread's new radius.
    radius: PulseIn<Radius>,
    /// Threads that want their next path.
    #[port("in")]
    input: In<Thread>,
    /// A thread that wants its last path back.
    pop: PulseOut<Thread>,
    /// The stack of the last pop was empty.
    top_empty: Input<bool>,
    /// Else the path that it found.
    top: Input<Path>,
    /// Descents from a path that was not taken before.
    resume: Out<Descent>,
    /// A thread without a path left.
    empty: PulseOut<Thread>,
    /// A path was popped.
    event_pop: Output<bool>,
}
