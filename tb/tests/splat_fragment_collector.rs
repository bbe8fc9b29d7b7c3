//! `splat_fragment_collector` against its model, in every cycle.

use pointcore_contract::splat::records::Fragment;
use pointcore_contract::splat::units::fragment_collector::UNIT;
use pointcore_golden::splat::FragmentCollector;
use pointcore_hdl::splat::fragment_collector;

use crate::splat::collected::check;
use crate::splat::configs;
use crate::support::cases;

#[test]
fn it_agrees_with_the_model_and_frames_are_those_of_both_sides() {
    for config in cases(configs()) {
        let unit = (&fragment_collector::module(&config), &UNIT);
        check::<Fragment, _>(&config, unit, &FragmentCollector::default(), |fragment| &mut fragment.end);
    }
}
