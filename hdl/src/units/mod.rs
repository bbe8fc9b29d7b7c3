//! What the units of both cores share.

pub(crate) mod datapath;
pub(crate) mod records;
pub(crate) mod sliced;

#[cfg(test)]
pub(crate) mod testing;
