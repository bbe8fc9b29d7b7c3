//! Where the traversal's nodes come from: its own memory, or the tree cache.

use pointcore_spec::core_b::{Config, records};

use crate::rtl::{Expr, Memory, Module, Reg, Stream, bit};
use crate::units::records::{QueueOut, Record, pulse_in, queue_in, queue_out, width};

/// A thread at a node, or nothing.
pub(super) struct Place {
    pub valid: Expr,
    pub thread: Expr,
    pub node: Expr,
}

/// A stage of the ring.
pub(super) struct Token {
    pub valid: Reg,
    pub thread: Reg,
    pub node: Reg,
}

impl Token {
    pub fn new(m: &mut Module, config: &Config, stage: &str) -> Self {
        Self {
            valid: m.reg_reset(&format!("{stage}_valid"), 1, 0),
            thread: m.reg(&format!("{stage}_thread"), config.thread_bits() as usize),
            node: m.reg(&format!("{stage}_node"), config.node_bits() as usize),
        }
    }

    pub fn place(&self) -> Place {
        Place { valid: self.valid.expr(), thread: self.thread.expr(), node: self.node.expr() }
    }

    pub fn take(&self, m: &mut Module, advance: &Expr, place: &Place) {
        m.next_if(&self.valid, advance, &place.valid);
        m.next_if(&self.thread, advance, &place.thread);
        m.next_if(&self.node, advance, &place.node);
    }
}

/// What stands before `t1`.
pub(super) enum Nodes {
    /// A memory of nodes.
    Memory(Memory),
    /// Nodes are sent out and their records come back.
    Cache { node: QueueOut, record: Stream },
}

impl Nodes {
    /// Declares the ports.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        if config.tree_cache > 0 {
            let node = queue_out(m, "node", &records::descent(config));
            return Self::Cache { node, record: queue_in(m, "record", &records::node_record(config)) };
        }
        let tree = pulse_in(m, "tree", &records::tree_write(config));
        let fields = records::node(config);
        let nodes = m.memory("nodes", 1 << config.tree_depth, width(&fields));
        let writes = &tree.valid & !tree.record.get("is_leaf");
        m.write(&nodes, &writes, &tree.record.get("address"), &tree.record.only(&fields).pack());
        Self::Memory(nodes)
    }

    /// What is to be read can be taken in this cycle.
    pub fn room(&self) -> Expr {
        match self {
            Self::Memory(_) => bit(true),
            Self::Cache { node, .. } => node.room.clone(),
        }
    }

    /// Takes what is to be read on `advance`; returns what goes into `t1` on it, and its node as it is in `t1`.
    pub fn read(self, m: &mut Module, config: &Config, advance: &Expr, next: Place) -> (Place, Record) {
        let fields = records::node(config);
        match self {
            Self::Memory(nodes) => {
                let address = next.node.trunc(config.tree_depth as usize);
                let record = m.read_if(&nodes, "t1_record", advance, &address);
                (next, Record::unpack(&fields, &record))
            }
            Self::Cache { node, record } => {
                node.push(m, &(advance & &next.valid), |name| match name {
                    "thread" => next.thread.clone(),
                    _ => next.node.clone(),
                });
                m.ready(&record, advance);
                let [thread, node] = ["thread", "node"].map(|name| record.field(name));
                let place = Place { valid: record.valid.clone(), thread, node };
                (place, Record::from(&record).only(&fields).register(m, "t1_", advance))
            }
        }
    }
}
