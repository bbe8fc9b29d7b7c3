//! Types of the libraries as values of arguments: what the command line calls them, and what it says of them.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use pointcore::search::Splitting;
use pointcore_lab::accuracy::choice::{Against, Prefer};
use pointcore_lab::synthesis::Target;

/// A value, its name, and what it is.
type Choice<T> = (T, &'static str, &'static str);

/// Takes one of these names.
fn choice<T: Copy + Send + Sync + 'static>(choices: &'static [Choice<T>]) -> impl TypedValueParser<Value = T> {
    let names = choices.iter().map(|(_, name, help)| PossibleValue::new(*name).help(*help));
    PossibleValuesParser::new(names).map(|given| {
        let chosen = choices.iter().find(|(_, name, _)| *name == given);
        chosen.expect("only names of the list are let through").0
    })
}

/// Technologies.
pub fn targets() -> impl TypedValueParser<Value = Target> {
    const TARGETS: [Choice<Target>; 4] = [
        (Target::Ecp5, Target::Ecp5.name(), "Lattice ECP5 LFE5U-85F, speed grade 6: synthesis, place and route"),
        (Target::Ice40, Target::Ice40.name(), "Lattice iCE40 HX8K: synthesis, place and route of small units"),
        (Target::Xilinx7, Target::Xilinx7.name(), "AMD 7-series: synthesis"),
        (Target::Gates, Target::Gates.name(), "Two-input gates and multiplexers, memories left whole: synthesis"),
    ];
    choice(&TARGETS)
}

/// Ways to divide the points of a node.
pub fn splittings() -> impl TypedValueParser<Value = Splitting> {
    const SPLITTINGS: [Choice<Splitting>; 3] = [
        (Splitting::Median, Splitting::Median.name(), "Half of the points on either side"),
        (
            Splitting::Packed,
            Splitting::Packed.name(),
            "The multiple of `bucket` nearest to half on the left: buckets are full, so none of a beat is wasted",
        ),
        (
            Splitting::Midpoint,
            Splitting::Midpoint.name(),
            "The middle of the bounding box; cells are as compact as can be, leaves as full as the points happen to lie",
        ),
    ];
    choice(&SPLITTINGS)
}

/// Which error counts.
pub fn errors() -> impl TypedValueParser<Value = Against> {
    const ERRORS: [Choice<Against>; 2] = [
        (Against::Truth, "truth", "The truth of 16 samples a pixel"),
        (Against::Rounding, "rounding", "The f64 reference at the same samples: rounding alone"),
    ];
    choice(&ERRORS)
}

/// What the cheapest point has the least of.
pub fn preferences() -> impl TypedValueParser<Value = Prefer> {
    const PREFERENCES: [Choice<Prefer>; 3] = [
        (Prefer::AreaTime, "area-time", "Time multiplied by area: frames a second from a device full of cores"),
        (Prefer::Time, "time", "Time"),
        (Prefer::Area, "area", "Area"),
    ];
    choice(&PREFERENCES)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{Arg, Command};

    #[test]
    fn every_technology_and_every_splitting_can_be_chosen() {
        let parsed = |name: &'static str| {
            let arguments = Command::new("test").arg(Arg::new("target").value_parser(targets()));
            let found = arguments.try_get_matches_from(["test", name]);
            found.ok().and_then(|found| found.get_one::<Target>("target").copied())
        };
        assert_eq!(Target::ALL.map(|target| parsed(target.name())), Target::ALL.map(Some));
        assert_eq!(parsed("ecp6"), None);
        let names: Vec<_> = splittings().possible_values().into_iter().flatten().collect();
        assert_eq!(names.len(), Splitting::ALL.len());
    }
}
