//! What the units of both cores share.

pub(crate) mod datapath;
mod documents;
pub(crate) mod operator;
pub(crate) mod passage;
pub(crate) mod ports;
pub(crate) mod queue;
pub(crate) mod sliced;
pub(crate) mod twins;
pub(crate) mod values;
pub(crate) mod wires;

#[cfg(test)]
pub(crate) mod testing;
