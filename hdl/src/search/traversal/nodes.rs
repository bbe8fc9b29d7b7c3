//! Where the traversal's nodes come from: its own memory, or the tree cache.

use pointcore_contract::search::{Config, records};

use crate::units::records::{QueueOut, Record, pulse_in, queue_in, queue_out};
use crate::units::sliced::Sliced;
use rtl::{Expr, Module, Reg, Stream, bit};

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
            thread: m.reg(&format!("{stage}_thread"), config.thread_bits()),
            node: m.reg(&format!("{stage}_node"), config.node_bits()),
        }
    }

    pub fn place(&self) -> Place {
        Place { valid: self.valid.expr(), thread: self.thread.expr(), node: self.node.expr() }
    }

    pub fn take(&self, m: &mut Module, advance: Expr, place: &Place) {
        m.next_if(self.valid, advance, place.valid);
        m.next_if(self.thread, advance, place.thread);
        m.next_if(self.node, advance, place.node);
    }
}

/// What stands between the stages `f` and `v`.
pub(super) enum Nodes {
    /// Memories of the even and the odd nodes, which are read together.
    Memories([Sliced; 2]),
    /// Nodes are sent out and their records come back.
    Cache { node: QueueOut, record: Stream },
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
            let node = queue_out(m, "node", &records::descent(config));
            return Self::Cache { node, record: queue_in(m, "record", &records::node_record(config)) };
        }
        let tree = pulse_in(m, "tree", &records::tree_write(config));
        let fields = records::node(config);
        let address = tree.record.get("address");
        let writes = tree.valid & !tree.record.get("is_leaf");
        let written = pair(config, address.resize(config.node_bits()));
        let is_odd = address.bit(0);
        let word = tree.record.only(&fields).pack();
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

    /// On `advance`, `next` goes into `f` without its lowest bit; what is in `f`, which is known by now, goes into `v`: returns
    /// its place and, as it is in `v`, its node.
    pub fn fetch(
        self,
        m: &mut Module,
        config: &Config,
        advance: Expr,
        next: Expr,
        (wanted, v): (Place, &Token),
    ) -> (Place, Record) {
        let fields = records::node(config);
        match self {
            Self::Memories(memories) => {
                let address = pair(config, next);
                let [even, odd] = [("even", &memories[0]), ("odd", &memories[1])].map(|(name, memory)| {
                    Record::unpack(&fields, memory.read_if(m, &format!("{name}_node"), advance, address))
                });
                // The split is chosen behind registers: in one cycle a block RAM only gets as far as these. The few bits that
                // choose the coordinate, and so are needed early, are chosen in front of them.
                let (wide, few): (Vec<_>, Vec<_>) = fields.iter().cloned().partition(|(name, _)| name == "split");
                let splits = [("even", &even), ("odd", &odd)];
                let [even_split, odd_split] =
                    splits.map(|(name, node)| node.only(&wide).register(m, &format!("v_{name}_"), advance));
                let chosen = odd.only(&few).mux(wanted.node.bit(0), &even.only(&few)).register(m, "v_", advance);
                let split = odd_split.mux(v.node.bit(0), &even_split);
                let record = |name: &str| if name == "split" { split.get(name) } else { chosen.get(name) };
                (wanted, Record::new(&fields, record))
            }
            Self::Cache { node, record } => {
                node.push(m, advance & wanted.valid, |name| match name {
                    "thread" => wanted.thread,
                    _ => wanted.node,
                });
                m.ready(&record, advance);
                let [thread, node] = ["thread", "node"].map(|name| record.field(name));
                let place = Place { valid: record.valid, thread, node };
                (place, Record::from(&record).only(&fields).register(m, "v_", advance))
            }
        }
    }
}
