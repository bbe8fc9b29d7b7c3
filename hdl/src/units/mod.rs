//! What the units of both cores share.

pub(crate) mod datapath;
pub(crate) mod records;

#[cfg(test)]
pub(crate) mod testing;
