//! Run-time-sized modules over rust-hdl.
