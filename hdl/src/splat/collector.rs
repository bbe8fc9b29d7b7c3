//! Leads two sides' finished pixels into one stream (thesis 5.5.3); golden twin: `pointcore_golden::splat::collector`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::FinishedPixel;
use pointcore_contract::splat::units::collector::PORTS;
use pointcore_contract::unit::{In, Out};

use super::parts::collected::{self, Closing};
use crate::units::wires::Wired;
use rtl::{Expr, Module};

impl Closing for FinishedPixel {
    const MODULE: [&'static str; 2] = ["splat_collector", "Leads two sides' finished pixels into one stream."];
    const PORTS: (In<Self>, In<Self>, Out<Self>) = (PORTS.low, PORTS.high, PORTS.out);

    fn end(record: &mut Wired<Self>) -> &mut Expr {
        &mut record.end
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    collected::module::<FinishedPixel>(config)
}
