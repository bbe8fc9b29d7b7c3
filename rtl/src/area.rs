//! A proxy for area, counted before synthesis.

use super::canonical::{Graph, Need};
use super::expression::Primitive;
use super::memory::{Store, Style};
use super::module::Source;

/// Bits of each factor of a device's multiplier.
const MULTIPLIER_BITS: u32 = 18;

/// What one module holds, without its children.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Area {
    /// Bits of registers, read ports of memories included.
    pub register_bits: u64,
    /// Bits of memories and tables.
    pub memory_bits: u64,
    /// Multipliers.
    pub multipliers: u64,
    /// Multipliers of 18 by 18 bits that they are made of.
    pub multiplier_blocks: u64,
    /// Bits of their products.
    pub multiplier_bits: u64,
    /// Bits of sums, differences and ordered comparisons.
    pub adder_bits: u64,
    /// Bits of two-way choices.
    pub mux_bits: u64,
}

/// A memory or table of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Storage {
    /// Its name in the module.
    pub name: String,
    /// Words.
    pub depth: u32,
    /// Bits of a word.
    pub width: u32,
    /// Read ports.
    pub reads: u32,
    /// Whether it is to lie in look-up tables.
    pub is_distributed: bool,
}

impl Storage {
    /// The memories of a module, without its children.
    pub(super) fn of(graph: &Graph) -> Vec<Self> {
        let stores = graph.module.stores.iter().enumerate();
        let stores = stores.filter(|(index, _)| graph.stores[*index] == Need::Hardware);
        let storage = |(index, store): (usize, &Store)| Self {
            name: store.name.clone(),
            depth: store.depth,
            width: store.width,
            reads: graph.readers(index).len() as u32,
            is_distributed: store.style == Style::Distributed,
        };
        stores.map(storage).collect()
    }

    /// Bits in all.
    #[must_use]
    pub const fn bits(&self) -> u64 {
        self.depth as u64 * self.width as u64
    }
}

impl Area {
    /// Counts the hardware of a module.
    pub(super) fn of(graph: &Graph) -> Self {
        let mut area = Self::default();
        for (signal, _) in graph.module.signals.iter().zip(&graph.signals).filter(|(_, need)| **need == Need::Hardware)
        {
            if matches!(signal.source, Source::Register { .. } | Source::Read { .. }) {
                area.register_bits += u64::from(signal.reference.width());
            }
        }
        area.memory_bits = Storage::of(graph).iter().map(Storage::bits).sum();
        for node in &graph.nodes[..graph.hardware_nodes] {
            match node.operation {
                Primitive::Multiply | Primitive::MultiplySigned => {
                    area.multipliers += 1;
                    let blocks = |operand: usize| u64::from(graph.nodes[operand].width.div_ceil(MULTIPLIER_BITS));
                    area.multiplier_blocks += blocks(node.operands[0]) * blocks(node.operands[1]);
                    area.multiplier_bits += u64::from(node.width);
                }
                Primitive::Add | Primitive::Subtract => area.adder_bits += u64::from(node.width),
                Primitive::Less | Primitive::LessOrEqual | Primitive::LessSigned => {
                    area.adder_bits += u64::from(graph.nodes[node.operands[0]].width);
                }
                Primitive::Mux => area.mux_bits += u64::from(node.width),
                _ => {}
            }
        }
        area
    }
}
