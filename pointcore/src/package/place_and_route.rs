//! How a whole core is placed and routed by `nextpnr-ecp5`.

use crate::configuration::Configuration;

/// The device, with pins for everybody.
pub const ECP5: &[&str] = &["--85k", "--speed", "6", "--package", "CABGA756", "--lpf-allow-unconstrained"];
/// A core has room, and its placer knows of time, which counts six times as much as it usually would.
const ROOMY: &[&str] = &["--freq", "100", "--placer-heap-timingweight", "60"];
/// In a crowded core what counts first is that all wires find a way: they do from the places of nextpnr's static placer, with which they
/// are a third shorter than with its usual one.
const CROWDED: &[&str] = &["--freq", "100", "--placer", "static"];

/// How hard it is to find a way for all wires of a core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crowding {
    /// They find it by themselves.
    Roomy,
    /// There are more of them than find their way by themselves.
    Crowded,
}

impl Crowding {
    /// That of a configuration's core.
    #[must_use]
    pub const fn of(configuration: &Configuration) -> Self {
        match configuration {
            Configuration::Splat(_) | Configuration::Points(_) => Self::Crowded,
            Configuration::Search(_) => Self::Roomy,
        }
    }

    /// The arguments of `nextpnr`, whatever the device.
    #[must_use]
    pub const fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Roomy => ROOMY,
            Self::Crowded => CROWDED,
        }
    }
}

/// The arguments of `nextpnr-ecp5` for the whole core of a configuration, beside files and seed.
pub(super) fn arguments(configuration: &Configuration) -> Vec<&'static str> {
    [ECP5, Crowding::of(configuration).arguments()].concat()
}
