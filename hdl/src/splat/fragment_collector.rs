//! Leads two sides' fragments into one stream (thesis 5.5.3); golden twin: `pointcore_golden::splat::fragment_collector`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Fragment;
use pointcore_contract::splat::units::fragment_collector::PORTS;
use pointcore_contract::unit::{In, Out};

use super::parts::collected::{self, Closing};
use crate::units::wires::Wired;
use rtl::{Expr, Module};

impl Closing for Fragment {
    const MODULE: [&'static str; 2] = ["splat_fragment_collector", "Leads two sides' fragments into one stream."];
    const PORTS: (In<Self>, In<Self>, Out<Self>) = (PORTS.low, PORTS.high, PORTS.out);

    fn end(record: &mut Wired<Self>) -> &mut Expr {
        &mut record.end
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    collected::module::<Fragment>(config)
}
