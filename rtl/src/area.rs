//! A proxy for area, counted before synthesis.

use super::canonical::{Graph, Need};
use super::expression::Operation;
use super::module::Source;

/// What one module holds, without its children.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// Bits of registers, read ports of memories included.
    pub register_bits: usize,
    /// Bits of memories and tables.
    pub memory_bits: usize,
    /// Multipliers.
    pub multipliers: usize,
    /// Bits of their products.
    pub multiplier_bits: usize,
    /// Bits of sums, differences and ordered comparisons.
    pub adder_bits: usize,
    /// Bits of two-way choices.
    pub mux_bits: usize,
}

/// A memory or table of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Storage {
    /// Its name in the module.
    pub name: String,
    /// Words.
    pub depth: usize,
    /// Bits of a word.
    pub width: usize,
}

impl Storage {
    /// The memories of a module, without its children.
    pub(super) fn of(graph: &Graph) -> Vec<Self> {
        let stores = graph.module.stores.iter().zip(&graph.stores).filter(|(_, need)| **need == Need::Hardware);
        stores.map(|(store, _)| Self { name: store.name.clone(), depth: store.depth, width: store.width }).collect()
    }

    /// Bits in all.
    #[must_use]
    pub const fn bits(&self) -> usize {
        self.depth * self.width
    }
}

impl Area {
    /// Counts the hardware of a module.
    pub(super) fn of(graph: &Graph) -> Self {
        let mut area = Self::default();
        for (signal, _) in graph.module.signals.iter().zip(&graph.signals).filter(|(_, need)| **need == Need::Hardware)
        {
            if matches!(signal.source, Source::Register { .. } | Source::Read { .. }) {
                area.register_bits += signal.reference.width();
            }
        }
        area.memory_bits = Storage::of(graph).iter().map(Storage::bits).sum();
        for node in &graph.nodes[..graph.hardware_nodes] {
            match node.operation {
                Operation::Multiply | Operation::MultiplySigned => {
                    area.multipliers += 1;
                    area.multiplier_bits += node.width;
                }
                Operation::Add | Operation::Subtract => area.adder_bits += node.width,
                Operation::Less | Operation::LessOrEqual | Operation::LessSigned => {
                    area.adder_bits += graph.nodes[node.operands[0]].width;
                }
                Operation::Mux => area.mux_bits += node.width,
                _ => {}
            }
        }
        area
    }
}
