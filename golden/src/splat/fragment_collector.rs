//! Fragment collector: two sides share one stream of fragments.

use super::parts::collected::Collected;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Fragment;
pub use pointcore_contract::splat::units::fragment_collector::{In, Out};

/// The collector.
pub type FragmentCollector = Collected<Fragment>;

impl Model for Collected<Fragment> {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let [low_ready, high_ready] = self.shared.ready(self.goes_on());
        Out { low_ready, high_ready, out: self.shared.out.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        self.step([inputs.low, inputs.high], inputs.out_ready);
    }
}
