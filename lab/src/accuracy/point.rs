//! The points of a sweep: settings of a scene, by name, and the knobs that make them.

use super::figures::PointEngine;
use serde::Serialize;

/// A setting as `--set` takes it: key and value.
pub type Setting = (String, String);

/// Whether a value is tried together with other knobs' values.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    /// Everything else as the scene says.
    Alone,
    /// With every other combined value, too.
    Combined,
}

/// A knob of the hardware, or of how the host uses it, and values that it can be set to.
#[derive(Clone)]
pub struct Knob {
    name: String,
    values: Vec<(String, Vec<Setting>, Use)>,
}

/// How a point is rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RenderMethod {
    /// On the hardware, or its model.
    Hardware,
    /// By the f64 reference with the hardware's algorithm: what is left are the samples.
    Backward,
    /// By the f64 reference with affine forward mapping (thesis ch. 3), which no hardware here computes.
    Forward,
}

/// A point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepPoint {
    /// Short and unique.
    pub name: String,
    /// What is rendered otherwise than the scene says.
    pub settings: Vec<Setting>,
    /// By what.
    pub method: RenderMethod,
}

/// A knob that is none, or has no value.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}`: expected KNOB=VALUE,…, such as samples=1,2 or overrides.tile_slots=2,4, where KNOB is a key of the scene or one of {names}",
    names = KEYS.map(|(name, _)| format!("`{name}`")).join(", ")
)]
pub struct UnknownKnob(String);

/// Keys of a scene by the names of knobs.
const KEYS: [(&str, &[&str]); 15] = [
    ("geometry", &["overrides.geometry"]),
    ("rasterizer", &["overrides.rasterizer"]),
    ("attribute", &["overrides.attribute"]),
    ("samples", &["image.samples"]),
    ("sampling", &["image.sampling"]),
    ("depth", &["splatting.depth"]),
    ("cutoff", &["splatting.cutoff"]),
    ("kernel", &["overrides.kernel_index_bits", "overrides.kernel_fraction_bits"]),
    ("division", &["overrides.division"]),
    // One number shares the operators of both units.
    ("sharing", &["overrides.transform_interval", "overrides.setup_interval"]),
    ("tile_slots", &["overrides.tile_slots"]),
    ("motion", &["splatting.motion"]),
    ("resample", &["splatting.resample_px"]),
    ("table", &["overrides.kernel_index_bits"]),
    ("sample_interval", &["overrides.sample_interval"]),
];

impl Knob {
    pub(super) fn new(name: &str, alone: &[&str], combined: &[&str]) -> Self {
        let keys: Vec<String> = match KEYS.iter().find(|(known, _)| *known == name) {
            Some((_, keys)) => keys.iter().map(ToString::to_string).collect(),
            None => vec![name.to_owned()],
        };
        let value = |value: &str, use_of: Use| {
            // As many parts as keys, as in `8+0`, or one value for all.
            let parts: Vec<&str> = value.split('+').collect();
            let part = |index| if parts.len() == keys.len() { parts[index] } else { value };
            let settings = keys.iter().enumerate().map(|(index, key)| (key.clone(), part(index).to_owned())).collect();
            (value.to_owned(), settings, use_of)
        };
        let alone = alone.iter().map(|text| value(text, Use::Alone));
        let values = alone.chain(combined.iter().map(|text| value(text, Use::Combined))).collect();
        Self { name: name.to_owned(), values }
    }

    /// What is swept unless something else is asked for: formats of geometry, rasterizer and attributes, samples along a pixel's edge,
    /// where the kernel is cut off and how its table is resolved, the operators that divide, and how many cycles share an operator of
    /// transform and setup.
    #[must_use]
    pub fn standard() -> Vec<Self> {
        vec![
            Self::new("geometry", &["f32", "f24", "bf16-ftz"], &["f32-ftz", "f24-ftz"]),
            Self::new("rasterizer", &["geometry", "f24-ftz", "bf16-ftz", "fixed18", "fixed16"], &[]),
            Self::new("attribute", &["f32", "f24", "fixed16", "fixed12", "fixed8"], &["f16", "bf16"]),
            Self::new("samples", &["3"], &["1", "2", "4"]),
            Self::new("sampling", &["flipquad"], &[]),
            Self::new("depth", &["plane"], &[]),
            Self::new("cutoff", &["0.7", "0.85"], &[]),
            Self::new("kernel", &["8+8", "8+0", "6+6", "5+0"], &[]),
            Self::new("division", &["rounded", "newton"], &[]),
            Self::new("sharing", &["1", "2", "4"], &["8"]),
        ]
    }

    /// The same of a scene that moves: how many bins the exposure has, how far straight parts of ways may lie from them, how the tables of the kernel
    /// and of its integral are resolved, and how many cycles share an operator of the rasterizer; but a rasterizer of the geometry's format.
    #[must_use]
    pub fn of_motion() -> Vec<Self> {
        vec![
            Self::new("motion", &["bins:1"], &["bins:2", "bins:4", "bins:8"]),
            Self::new("geometry", &["f32", "f32-ftz", "f24", "bf16-ftz"], &["f24-ftz"]),
            Self::new("attribute", &["f32", "f24", "f16", "fixed16", "fixed12", "fixed8"], &["bf16"]),
            Self::new("samples", &["1", "2"], &[]),
            Self::new("depth", &["plane"], &[]),
            Self::new("cutoff", &["0.7", "0.85"], &[]),
            Self::new("resample", &["0.0625", "1", "4"], &[]),
            Self::new("table", &["4", "6", "8", "10"], &[]),
            Self::new("division", &["rounded", "newton"], &[]),
            Self::new("sample_interval", &["1", "2", "4"], &[]),
            Self::new("sharing", &["2", "4", "8"], &[]),
        ]
    }

    /// A knob and its values as a user names them, all of them combined with those of other knobs.
    ///
    /// # Errors
    /// It is not of the form `KNOB=VALUE,…`.
    pub fn parse(text: &str) -> Result<Self, UnknownKnob> {
        let (name, values) = text.split_once('=').ok_or_else(|| UnknownKnob(text.to_owned()))?;
        let values: Vec<&str> = values.split(',').map(str::trim).collect();
        let known = KEYS.iter().any(|(known, _)| *known == name) || name.contains('.');
        if !known || values.iter().any(|value| value.is_empty()) {
            return Err(UnknownKnob(text.to_owned()));
        }
        Ok(Self::new(name, &[], &values))
    }
}

impl Knob {
    /// Its values, as a user writes them.
    pub fn values(&self) -> impl Iterator<Item = &str> {
        self.values.iter().map(|(value, ..)| value.as_str())
    }

    /// The name of the point that has this value and nothing else.
    #[must_use]
    pub fn alone(&self, value: &str) -> String {
        format!("{} {value}", self.name)
    }

    /// Values of which every point is among `refused`, each with the point's name.
    pub fn impossible<'a>(&'a self, all: &[SweepPoint], refused: &[&SweepPoint]) -> Vec<&'a str> {
        let has =
            |point: &&SweepPoint, settings: &[Setting]| settings.iter().all(|setting| point.settings.contains(setting));
        let is_impossible = |(_, settings, _): &&(String, Vec<Setting>, Use)| {
            all.iter().filter(|point| has(point, settings)).all(|point| refused.contains(&point))
        };
        self.values.iter().filter(is_impossible).map(|(value, ..)| value.as_str()).collect()
    }
}

impl SweepPoint {
    /// A value of each knob by its place; a place beyond leaves the knob as the scene has it.
    #[must_use]
    pub fn turned(knobs: &[Knob], choice: &[u16]) -> Self {
        let values =
            knobs.iter().zip(choice).filter_map(|(knob, &value)| Some((knob, knob.values.get(usize::from(value))?)));
        values.fold(Self::base(), |point, (knob, (value, settings, _))| point.with(&knob.name, value, settings))
    }

    /// The scene as it is.
    #[must_use]
    pub fn base() -> Self {
        Self { name: "base".to_owned(), settings: Vec::new(), method: RenderMethod::Hardware }
    }

    fn with(&self, knob: &str, value: &str, settings: &[Setting]) -> Self {
        let name = format!("{knob} {value}");
        let name = if self.settings.is_empty() { name } else { format!("{}, {name}", self.name) };
        let settings = [&self.settings[..], settings].concat();
        Self { name, settings, method: self.method }
    }

    /// The settings as `--set` takes them.
    #[must_use]
    pub fn arguments(&self) -> Vec<String> {
        self.settings.iter().map(|(key, value)| format!("{key}={value}")).collect()
    }

    /// Which engine renders it where hardware is to be rendered by `hardware`.
    #[must_use]
    pub const fn engine(&self, hardware: PointEngine) -> PointEngine {
        match self.method {
            RenderMethod::Hardware => hardware,
            RenderMethod::Backward | RenderMethod::Forward => PointEngine::F64,
        }
    }
}

/// All points of some knobs: the scene as it is and as the f64 reference renders it, every value alone, and all combinations of values that
/// are to be combined.
#[must_use]
pub fn points(knobs: &[Knob]) -> Vec<SweepPoint> {
    let base = SweepPoint::base();
    let reference = |name: &str, method| SweepPoint { name: name.to_owned(), method, ..SweepPoint::base() };
    let mut points = vec![
        base.clone(),
        reference("f64", RenderMethod::Backward),
        reference("f64, forward mapping", RenderMethod::Forward),
    ];
    for Knob { name, values } in knobs {
        points.extend(values.iter().map(|(value, settings, _)| base.with(name, value, settings)));
    }
    let mut combined = vec![base];
    for Knob { name, values } in knobs {
        let all = values.iter().filter(|(.., use_of)| *use_of == Use::Combined);
        let with = |point: &SweepPoint| -> Vec<SweepPoint> {
            all.clone().map(|(value, settings, _)| point.with(name, value, settings)).collect()
        };
        // Not to turn a knob is one of its values.
        combined = combined.iter().flat_map(|point| [vec![point.clone()], with(point)].concat()).collect();
    }
    // Those with fewer than two knobs turned are there.
    points.extend(combined.into_iter().filter(|point| point.name.contains(", ")));
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(knobs: &[&str]) -> Vec<String> {
        let knobs: Vec<_> = knobs.iter().map(|text| Knob::parse(text).expect("a knob")).collect();
        points(&knobs).into_iter().map(|point| point.name).collect()
    }

    #[test]
    fn knobs_are_turned_alone_and_together() {
        let combined = names(&["samples=1,2", "sharing=8"]);
        let alone = ["base", "f64", "f64, forward mapping", "samples 1", "samples 2", "sharing 8"];
        assert_eq!(combined[..6], alone);
        assert_eq!(combined[6..], ["samples 1, sharing 8", "samples 2, sharing 8"]);
        let sharing = Knob::parse("sharing=8").expect("a knob").values[0].1.clone();
        assert_eq!(sharing.len(), 2, "both intervals: {sharing:?}");
        let kernel = Knob::parse("kernel=5+0").expect("a knob").values[0].1.clone();
        let [index, fraction] = ["5", "0"].map(str::to_owned);
        let keys = ["overrides.kernel_index_bits", "overrides.kernel_fraction_bits"].map(str::to_owned);
        assert_eq!(kernel, keys.into_iter().zip([index, fraction]).collect::<Vec<_>>(), "a part for each key");
    }

    #[test]
    fn a_value_is_impossible_where_no_point_of_it_is_left() {
        let knobs = ["geometry=f24,f31", "samples=2"].map(|text| Knob::parse(text).expect("a knob"));
        let all = points(&knobs);
        let refused = |part: &str| all.iter().filter(|point| point.name.contains(part)).collect::<Vec<_>>();
        assert_eq!(knobs[0].impossible(&all, &refused("f31")), ["f31"]);
        assert!(knobs[0].impossible(&all, &refused("f31,")).is_empty(), "alone it is possible");
        assert!(knobs[1].impossible(&all, &refused("f31")).is_empty());
        let turned = SweepPoint::turned(&knobs, &[0, 0]);
        assert_eq!((turned.name.as_str(), turned.settings.len()), ("geometry f24, samples 2", 2));
        assert_eq!(SweepPoint::turned(&knobs, &[2, 1]), SweepPoint::base());
    }

    #[test]
    fn what_is_no_knob_is_said() {
        for text in ["geometry", "speed=1", "samples=1,,2"] {
            let error = Knob::parse(text).err().expect("no knob").to_string();
            assert!(error.contains(text) && error.contains("such as samples=1,2 or"), "{error}");
        }
        assert!(Knob::parse("overrides.tile_slots=2,4").is_ok());
    }
}
