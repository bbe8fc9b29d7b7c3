//! The ports of a block: what its data path takes and gives, in order.

use super::PARTIAL_SUMS;
use super::block::NodeId;
use super::layout::{Layout, Scalar, Word};
use super::operation::Source;
use super::program::{Program, Section};

/// A word that a data path takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Name of the port.
    pub name: String,
    /// Its type.
    pub ty: Scalar,
    /// What it brings.
    pub source: Source,
    /// Which partial sum, where the source is a sum.
    pub partial: usize,
}

/// A word that a data path gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outgoing {
    /// Name of the port.
    pub name: String,
    /// Its type.
    pub ty: Scalar,
    /// The node that makes it; without one it is a constant one.
    pub value: Option<NodeId>,
}

impl Program {
    /// What the data path of a block takes: the values it reads, sorted, and of each sum its partial sums. Settings are
    /// constant while queries are under way.
    #[must_use]
    pub fn inputs(&self, section: Section) -> Vec<Port> {
        let sources = self.block(section).sources().into_iter();
        sources
            .flat_map(|source| {
                let Word { name, ty } = self.word(source);
                let parts = if matches!(source, Source::Sum(_)) { PARTIAL_SUMS } else { 1 };
                (0..parts).map(move |partial| {
                    let name = if parts == 1 { name.clone() } else { format!("{name}_{partial}") };
                    Port { name, ty, source, partial }
                })
            })
            .collect()
    }

    /// What the data path of a block gives: addends, outputs, stored state each with whether it is written, position
    /// and whether it moves, `done` and `search`. A `final` without `done` is always done.
    #[must_use]
    pub fn results(&self, section: Section) -> Vec<Outgoing> {
        let results = self.block(section).results();
        let mut all = vec![];
        let mut words = |layout: &Layout, prefix: &str, values: &[NodeId]| {
            for (word, &value) in layout.words().into_iter().zip(values) {
                all.push(Outgoing { name: format!("{prefix}_{}", word.name), ty: word.ty, value: Some(value) });
            }
        };
        words(&self.sums, "sum", &results.addends);
        words(&self.outputs, "output", &results.outputs);
        for store in &results.stores {
            let field = self.state.fields().iter().filter(|field| field.name == store.field).cloned();
            words(&Layout::of_fields(field.collect()), "state", &store.words);
        }
        if let Some(movement) = &results.movement {
            words(&Layout::of_point(), "moved", &movement.words);
        }
        let mut flag = |name: String, value| all.push(Outgoing { name, ty: Scalar::Bool, value });
        for store in &results.stores {
            flag(format!("write_{}", store.field), store.condition);
        }
        if let Some(movement) = &results.movement {
            flag("move".into(), movement.condition);
        }
        if section == Section::Final {
            flag("done".into(), results.done);
        }
        if results.search.is_some() {
            flag("search".into(), results.search);
        }
        all
    }
}
