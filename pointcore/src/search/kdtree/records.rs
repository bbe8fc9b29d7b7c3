//! A tree as the core reads it: written into its memories, or record by record from external memory.

use super::{Bucket, Node, Tree};
use crate::number::encode;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{self, Lookup, TreeRecord, TreeWrite};
use pointcore_contract::width;

impl Tree {
    fn node(&self, address: u32) -> Option<records::Node> {
        Some(match (*self.nodes.get(address as usize)?)? {
            Node::Split { dimension, split } => {
                records::Node { dimension, split: encode(self.format, split), internal_leaf: false }
            }
            Node::Leaf => records::Node { internal_leaf: true, ..records::Node::default() },
        })
    }

    fn bucket(&self, number: u32) -> Option<records::Bucket> {
        let Bucket { begin, beats, .. } = (*self.leaves.get(number as usize)?)?;
        Some(records::Bucket { begin, beats: beats as u8 })
    }

    /// The writes that load the tree into the core.
    pub fn writes(&self) -> impl Iterator<Item = TreeWrite> + '_ {
        let addresses = 0..self.leaves.len() as u32;
        let nodes = addresses.clone().filter_map(|address| {
            let node = self.node(address)?;
            Some(TreeWrite { address, node, ..TreeWrite::default() })
        });
        let leaves = addresses.filter_map(|address| {
            let bucket = self.bucket(address)?;
            Some(TreeWrite { is_leaf: true, address, bucket, ..TreeWrite::default() })
        });
        nodes.chain(leaves)
    }

    /// The record of a node or leaf, as it lies in external memory; nothing where the tree has none.
    #[must_use]
    pub fn record(&self, lookup: Lookup) -> TreeRecord {
        let (node, bucket) = match lookup.address.checked_sub(self.leaves.len() as u32) {
            None => (self.node(lookup.address), None),
            Some(leaf) => (None, self.bucket(leaf)),
        };
        TreeRecord { lookup, node: node.unwrap_or_default(), bucket: bucket.unwrap_or_default() }
    }

    /// Bytes of a record in external memory, a power of two.
    #[must_use]
    pub fn record_bytes(config: &Config) -> u32 {
        let bits = width::<records::Node>(config).max(width::<records::Bucket>(config));
        bits.div_ceil(u8::BITS).next_power_of_two()
    }
}
