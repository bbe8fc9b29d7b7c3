//! The registers of the cores, each with a counter that has all its bits within a test.

use pointcore_contract::bus::registers::{PointsRegisters, RegisterMap, RunCounter, SearchRegisters, SplatRegisters};
use pointcore_contract::bus::{Register, RegisterKind, When};
use pointcore_contract::{points, record, search, splat};

/// Bits of the event that has its counter run through all its bits.
pub const TALLY_BITS: u32 = 24;

/// A core's registers and one more, the counter of an event of so many bits that it soon has all of its own: those of the
/// core have a few, and a counter counts for minutes until it is full.
macro_rules! tallied {
    ($map:ident is $core:ty, $events:ident are [$($own:tt)+], [$($config:tt)+]) => {
        #[record(config: $($config)+)]
        pub struct $events {
            /// The core's own.
            #[with(config)]
            pub core: $($own)+,
            /// Anything.
            #[name("event_tally")]
            #[bits(TALLY_BITS)]
            pub tally: u32,
        }

        /// The map.
        pub struct $map;

        impl RegisterMap for $map {
            type Config = $($config)+;
            type Settings = <$core as RegisterMap>::Settings;
            type Events = $events;

            const STARTS: When = <$core as RegisterMap>::STARTS;

            fn registers(config: &Self::Config) -> Vec<Register> {
                with_tally(<$core as RegisterMap>::registers(config))
            }
        }
    };
}

tallied!(TalliedSplat is SplatRegisters, TalliedSplatEvents are [splat::units::Events], [splat::Config]);
tallied!(TalliedSearch is SearchRegisters, TalliedSearchEvents are [search::units::Events], [search::Config]);
tallied!(TalliedPoints is PointsRegisters, TalliedPointsEvents are [points::units::Events], [points::Config]);

/// Registers with one more, behind the counters of events.
fn with_tally(mut map: Vec<Register>) -> Vec<Register> {
    let place_of = |register: &Register| match register.kind {
        RegisterKind::Run(RunCounter::Event(place)) => Some(place),
        _ => None,
    };
    let last = map.iter().rposition(|register| place_of(register).is_some()).unwrap();
    let place = place_of(&map[last]).unwrap() + 1;
    let kind = RegisterKind::Run(RunCounter::Event(place));
    let tally = Register { name: "event_tally".into(), address: map[last].address + 4, kind, ..map[last].clone() };
    assert!(map.iter().all(|register| register.address != tally.address), "{:x} is taken", tally.address);
    map.insert(last + 1, tally);
    map
}
