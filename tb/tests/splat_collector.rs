//! `splat_collector` against its model, in every cycle.

use pointcore_contract::splat::records::FinishedPixel;
use pointcore_contract::splat::units::collector::UNIT;
use pointcore_golden::splat::Collector;
use pointcore_hdl::splat::collector;

use crate::splat::collected::check;
use crate::splat::configs;
use crate::support::cases;

#[test]
fn it_agrees_with_the_model_and_frames_are_those_of_both_sides() {
    for config in cases(configs()) {
        let unit = (&collector::module(&config), &UNIT);
        check::<FinishedPixel, _>(&config, unit, &Collector::default(), |pixel| &mut pixel.end);
    }
}
