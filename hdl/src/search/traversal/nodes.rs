//! Where the traversal's nodes come from: its own memory, or the tree cache.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, Node, NodeRecord};
use pointcore_contract::search::units::traversal::PORTS;

use crate::units::ports::{Flow, PulseInPorts, QueueOut, StreamInPorts, StreamOutPorts, held};
use crate::units::sliced::Sliced;
use crate::units::wires::{Bundle, Registers, Wires};
use rtl::{Expr, Module, Reg, bit};

/// A thread at a node, or nothing.
pub(super) struct Place {
    pub valid: Expr,
    pub descent: Descent<Wires>,
}

/// A stage of the ring.
pub(super) struct Token {
    pub valid: Reg,
    pub descent: Registers<Descent<Wires>>,
}

impl Token {
    pub fn new(m: &mut Module, config: &Config, stage: &str) -> Self {
        let valid = m.reg_reset(&format!("{stage}_valid"), 1, 0);
        Self { valid, descent: Registers::new(m, config, &format!("{stage}_")) }
    }

    pub fn place(&self) -> Place {
        Place { valid: self.valid.expr(), descent: *self.descent }
    }

    pub fn take(&self, m: &mut Module, config: &Config, advance: Expr, place: &Place) {
        m.next_if(self.valid, advance, place.valid);
        self.descent.next_if(m, config, advance, place.descent);
    }
}

/// What stands between the stages `f` and `v`.
pub(super) enum Nodes {
    /// Memories of the even and the odd nodes, which are read together.
    Memories([Sliced; 2]),
    /// Nodes are sent out and their records come back.
    Cache { node: QueueOut<Descent>, record: Flow<NodeRecord<Wires>> },
}

/// What goes into the stage `v`.
pub(super) struct Fetched {
    /// Its place, before.
    pub entering: Place,
    /// Its node, once it is there.
    pub node: Node<Wires>,
    /// The splits of an even and of an odd node, or that of any: there before it is known which one it is.
    pub splits: Vec<Expr>,
}

/// Bits of a pair of siblings' address; a memory has two words at least.
const fn pair_bits(config: &Config) -> u32 {
    if config.tree_depth > 1 { config.tree_depth - 1 } else { 1 }
}

/// The address of the pair that a node is of.
fn pair(config: &Config, node: Expr) -> Expr {
    node.bits(node.width() - 1, 1).resize(pair_bits(config))
}

impl Nodes {
    /// Declares the ports.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        if config.tree_cache > 0 {
            let node = PORTS.node.queue(m, config);
            return Self::Cache { node, record: PORTS.record.queue(m, config) };
        }
        let tree = PORTS.tree.declare(m, config);
        let address = tree.record.address;
        let writes = tree.valid & !tree.record.is_leaf;
        let written = pair(config, address.resize(config.node_bits()));
        let is_odd = address.bit(0);
        let word = tree.record.node.pack(config);
        Self::Memories([("even", !is_odd), ("odd", is_odd)].map(|(name, is_here)| {
            let writes = m.wire(&format!("writes_{name}"), writes & is_here);
            Sliced::new(m, &format!("{name}_nodes"), writes, written, word)
        }))
    }

    /// What is to be read can be taken in this cycle.
    pub fn room(&self) -> Expr {
        match self {
            Self::Memories(_) => bit(true),
            Self::Cache { node, .. } => node.room,
        }
    }

    /// On `advance`, `next` goes into `f` without its lowest bit; what is in `f`, which is known by now, goes into `v`.
    pub fn fetch(
        self,
        m: &mut Module,
        config: &Config,
        advance: Expr,
        next: Expr,
        (wanted, v): (Place, &Token),
    ) -> Fetched {
        match self {
            Self::Memories(memories) => {
                let address = pair(config, next);
                let [even, odd] = [("even", &memories[0]), ("odd", &memories[1])].map(|(name, memory)| {
                    Node::<Wires>::unpack(config, memory.read_if(m, &format!("{name}_node"), advance, address))
                });
                // The split is chosen behind registers: in one cycle a block RAM only gets as far as these. The few bits that
                // say what becomes of the node, and so are needed early, are chosen in front of them.
                let [even_split, odd_split] = [("even", even), ("odd", odd)]
                    .map(|(name, node)| held(m, &format!("v_{name}_split"), advance, node.split));
                let is_odd = wanted.descent.node.bit(0);
                let dimension = held(m, "v_dimension", advance, is_odd.mux(odd.dimension, even.dimension));
                let is_leaf = is_odd.mux(odd.internal_leaf, even.internal_leaf);
                let internal_leaf = held(m, "v_internal_leaf", advance, is_leaf);
                let split = v.descent.node.bit(0).mux(odd_split, even_split);
                let splits = vec![even_split, odd_split];
                Fetched { entering: wanted, node: Node { split, dimension, internal_leaf }, splits }
            }
            Self::Cache { node, record } => {
                node.push(m, config, advance & wanted.valid, wanted.descent);
                m.drive(record.ready, advance);
                let NodeRecord { descent, node } = record.record;
                let (entering, node) =
                    (Place { valid: record.valid, descent }, node.register(m, config, "v_", advance));
                Fetched { entering, node, splits: vec![node.split] }
            }
        }
    }
}
