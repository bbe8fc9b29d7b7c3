//! The cheapest point of the product of some knobs: far too many to render them all.
//!
//! Every value was rendered alone. Taken for independent of each other, knobs add errors (mean squares) and area, and multiply time;
//! so every combination has a predicted cost and error. In the order of predicted cost, combinations are generated for their area, and
//! rendered where they may be cheaper than the cheapest known. One that is not accurate enough rules out all in which no knob does better.

use super::choice::{Against, Decibels, Prefer, Rated, cheapest, rate};
use super::point::{Knob, SweepPoint};
use super::sweep::{MeasuredPoint, Sweep};
use crate::LabError;
use pointcore::area::estimate::Estimator;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Combinations that are looked at at most.
pub const PRODUCT_LIMIT: usize = 4_000_000;
/// Cores generated for their area at most, for each that may be rendered.
const GENERATED_PER_TRY: usize = 8;
/// How much less accurate than asked for a combination may be predicted and is tried all the same.
const ERROR_MARGIN_DB: f64 = 3.0;
/// How much dearer than the cheapest known, likewise.
const COST_MARGIN: f64 = 1.1;

/// What is sought.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// Decibels at least.
    pub at_least: Decibels,
    /// Which error they are of.
    pub against: Against,
    /// What the cheapest point has the least of.
    pub prefer: Prefer,
    /// Combinations rendered at most.
    pub tries: usize,
}

/// What a search went through.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Searched {
    /// Combinations of the product.
    pub combinations: usize,
    /// Those that might be accurate enough and cheaper.
    pub promising: usize,
    /// Those rendered.
    pub rendered: usize,
    /// Whether some that might be cheaper are left.
    pub is_cut_short: bool,
}

/// What a value does beside the scene as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Effect {
    lut4: f64,
    time: f64,
    error: f64,
}

const NO_EFFECT: Effect = Effect { lut4: 0.0, time: 1.0, error: 0.0 };

/// A combination: a value of each knob, the last for leaving it as it is.
struct Candidate {
    choice: Vec<u16>,
    cost: f64,
    error: f64,
}

/// Mean square error of a signal-to-noise ratio.
fn error(psnr_db: f64) -> f64 {
    10_f64.powf(-psnr_db / 10.0)
}

struct Model {
    base: Effect,
    /// By knob and value.
    effects: Vec<Vec<Effect>>,
    prefer: Prefer,
}

impl Model {
    /// Learns from points of one value each; one that is missing came to the same as the scene as it is, or has yet to be tried.
    fn new(knobs: &[Knob], rated: &[Rated], goal: &Goal) -> Option<Self> {
        let effect_of = |name: &str| {
            let point = rated.iter().find(|point| point.measured.point.name == name)?;
            let lut4 = point.lut4().unwrap_or(0.0);
            Some(Effect { lut4, time: point.time_ms?, error: error(point.psnr_db(goal.against)) })
        };
        let base = effect_of(&SweepPoint::base().name)?;
        let beside = |alone: Effect| Effect {
            lut4: alone.lut4 - base.lut4,
            time: alone.time / base.time,
            error: alone.error - base.error,
        };
        let effects = |knob: &Knob| -> Vec<Effect> {
            let values = knob.values().map(|value| effect_of(&knob.alone(value)).map_or(NO_EFFECT, beside));
            values.chain([NO_EFFECT]).collect()
        };
        Some(Self { base, effects: knobs.iter().map(effects).collect(), prefer: goal.prefer })
    }

    fn combinations(&self) -> usize {
        self.effects.iter().fold(1, |count: usize, values| count.saturating_mul(values.len()))
    }

    fn effect(&self, choice: &[u16]) -> Effect {
        let chosen = self.effects.iter().zip(choice).map(|(values, value)| values[usize::from(*value)]);
        let mut all = chosen.fold(self.base, |all, one| Effect {
            lut4: all.lut4 + one.lut4,
            time: all.time * one.time,
            error: all.error + one.error,
        });
        // What several knobs take away of one error they do not take away twice.
        all.error = all.error.max(0.0);
        all
    }

    fn cost(&self, effect: Effect) -> f64 {
        match self.prefer {
            Prefer::AreaTime => effect.time * effect.lut4.max(1.0),
            Prefer::Time => effect.time,
            Prefer::Area => effect.lut4,
        }
    }

    /// All combinations that may be accurate enough and cheaper than `known`, cheapest first, of equal cost the most accurate.
    fn candidates(&self, limit: f64, known: f64) -> Vec<Candidate> {
        let mut choice = vec![0; self.effects.len()];
        let mut found = Vec::new();
        for _ in 0..self.combinations() {
            let effect = self.effect(&choice);
            let cost = self.cost(effect);
            if effect.error <= limit && cost < known * COST_MARGIN {
                found.push(Candidate { choice: choice.clone(), cost, error: effect.error });
            }
            for (value, values) in choice.iter_mut().zip(&self.effects) {
                *value += 1;
                if usize::from(*value) < values.len() {
                    break;
                }
                *value = 0;
            }
        }
        found.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)));
        found
    }

    /// Whether no knob does better in `other` than in `failed`.
    fn is_no_better(&self, other: &[u16], failed: &[u16]) -> bool {
        let errors = self.effects.iter().zip(other.iter().zip(failed));
        errors.into_iter().all(|(values, (a, b))| values[usize::from(*a)].error >= values[usize::from(*b)].error)
    }
}

/// The number of combinations of some knobs.
#[must_use]
pub fn combinations(knobs: &[Knob]) -> usize {
    knobs.iter().fold(1, |count: usize, knob| count.saturating_mul(knob.values().count() + 1))
}

/// Looks for a point cheaper than all of `rated`; returns what was rendered on the way. `told` hears of each.
///
/// # Errors
/// A point cannot be rendered.
pub fn search(
    sweep: &Sweep,
    knobs: &[Knob],
    rated: &[Rated],
    estimator: &Estimator,
    goal: &Goal,
    told: impl Fn(&Rated),
) -> Result<(Vec<MeasuredPoint>, Searched), LabError> {
    let Some(model) = Model::new(knobs, rated, goal) else { return Ok((Vec::new(), Searched::default())) };
    let Goal { at_least, against, prefer, tries } = *goal;
    let cost = |rated: &Rated| rated.cost(prefer).unwrap_or(f64::INFINITY);
    let mut best = cheapest(rated, at_least, against, prefer).map_or(f64::INFINITY, cost);
    let candidates = model.candidates(error(at_least.0 - ERROR_MARGIN_DB), best);
    let mut searched =
        Searched { combinations: model.combinations(), promising: candidates.len(), ..Searched::default() };
    let mut known: Vec<String> = rated.iter().map(|point| point.measured.point.name.clone()).collect();
    let mut areas: HashMap<String, Option<f64>> = HashMap::new();
    let (mut failed, mut found): (Vec<Vec<u16>>, Vec<MeasuredPoint>) = (Vec::new(), Vec::new());
    for Candidate { choice, cost: predicted, .. } in &candidates {
        let is_ruled_out = failed.iter().any(|failed| model.is_no_better(choice, failed));
        if is_ruled_out || *predicted >= best * COST_MARGIN {
            continue;
        }
        let point = SweepPoint::turned(knobs, choice);
        // What neither scene nor hardware admits is no point.
        let Some(planned) = sweep.plan(vec![point]).0.pop() else { continue };
        let time = model.effect(choice).time;
        let hardware = planned.hardware();
        if !areas.contains_key(&hardware) && areas.len() == GENERATED_PER_TRY * tries {
            searched.is_cut_short = true;
            break;
        }
        let area = match areas.entry(hardware) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(new) => *new.insert(sweep.area(&planned, estimator)?),
        };
        let at_least_so_much = model.cost(Effect { lut4: area.unwrap_or(0.0), time, error: 0.0 });
        if known.contains(&planned.point.name) || at_least_so_much >= best * COST_MARGIN {
            continue;
        }
        if prefer == Prefer::Area && at_least_so_much >= best {
            continue;
        }
        if searched.rendered == tries {
            searched.is_cut_short = true;
            break;
        }
        searched.rendered += 1;
        let measured = match sweep.kept(&planned)? {
            Some(measured) => measured,
            None => sweep.measure(&planned)?,
        };
        known.push(measured.point.name.clone());
        let one = rate(vec![measured], estimator).pop().expect("one point was rated");
        told(&one);
        if one.psnr_db(against) < at_least.0 {
            failed.push(choice.clone());
        } else {
            best = best.min(cost(&one));
        }
        found.push(one.measured);
    }
    Ok((found, searched))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::choice::tests::{estimator, rated};
    use crate::accuracy::figures::PointEngine;
    use crate::accuracy::point::points;

    fn knobs() -> Vec<Knob> {
        ["geometry=f32-ftz,f24-ftz", "attribute=f16,bf16", "samples=2"]
            .map(|knob| Knob::parse(knob).expect("a knob"))
            .into()
    }

    fn model(prefer: Prefer) -> Model {
        let points = rated(&[
            ("base", 40.0, 100, 100),
            ("geometry f24-ftz", 39.9, 100, 60),
            ("attribute bf16", 35.0, 100, 90),
            ("samples 2", 50.0, 400, 100),
        ]);
        let goal = Goal { at_least: Decibels(45.0), against: Against::Truth, prefer, tries: 9 };
        Model::new(&knobs(), &points, &goal).expect("the base was measured")
    }

    #[test]
    fn the_product_has_every_value_and_leaving_it() {
        assert_eq!((model(Prefer::Area).combinations(), combinations(&knobs())), (18, 18));
    }

    #[test]
    fn combinations_are_predicted_from_values_alone() {
        let model = model(Prefer::Area);
        let both = model.effect(&[1, 1, 0]);
        assert!((both.lut4 - 50.0).abs() < 1e-9 && (both.time / model.base.time - 4.0).abs() < 1e-9, "{both:?}");
        let candidates = model.candidates(error(45.0 - ERROR_MARGIN_DB), f64::INFINITY);
        assert!(candidates.iter().all(|candidate| candidate.choice[2] == 0), "only two samples are accurate enough");
        assert!(candidates[0].cost <= candidates.last().expect("there are some").cost);
        assert_eq!(candidates[0].choice[0], 1, "the smallest first");
    }

    #[test]
    fn the_cheapest_of_the_product_is_found_with_few_of_it_rendered() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("scene.toml");
        let text = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 30, near = 1, far = 10 }\n\
                    image = { width = 24, height = 16, background = [0.9, 0.9, 0.9] }\n\
                    [[object]]\nkind = \"sphere\"\npoints = 200\nouter_radius = 1\nchecks = [4, 8]\nchecker_color = [0.1, 0.2, 0.6]\n";
        std::fs::write(&path, text).expect("a temporary folder can be written");
        let sweep = Sweep::open(&path, &[], folder.path().join("points"), PointEngine::Golden).expect("a scene");
        let knobs = [("geometry", &["f24-ftz", "bf16-ftz"][..]), ("samples", &["2"]), ("kernel", &["5+0"])];
        let knobs: Vec<Knob> = knobs.iter().map(|(name, values)| Knob::new(name, values, &[])).collect();
        let measured = |points: Vec<SweepPoint>| {
            let planned = sweep.plan(points).0;
            let points = planned.iter().map(|point| sweep.measure(point).expect("it renders")).collect();
            rate(points, &estimator())
        };
        let listed = measured(points(&knobs));
        let all = (0..3_u16).flat_map(|a| (0..2).flat_map(move |b| (0..2).map(move |c| [a, b, c])));
        let all = measured(all.map(|choice| SweepPoint::turned(&knobs, &choice)).collect());
        let best = |rated: &[Rated], db| {
            let best = cheapest(rated, Decibels(db), Against::Truth, Prefer::Area);
            best.map_or(f64::INFINITY, |point| point.cost(Prefer::Area).expect("hardware has a cost"))
        };
        let mut gained = 0;
        for db in [20.0, 25.0, 30.0, 35.0] {
            let goal = Goal { at_least: Decibels(db), against: Against::Truth, prefer: Prefer::Area, tries: 12 };
            let (found, searched) = search(&sweep, &knobs, &listed, &estimator(), &goal, |_| {}).expect("they render");
            assert!(searched.rendered == found.len() && searched.combinations == 12, "{searched:?}");
            let together = rate(found, &estimator());
            let cost = best(&together, db).min(best(&listed, db));
            assert_eq!(cost, best(&all, db), "{db} dB: as cheap as any of the product");
            gained += usize::from(cost < best(&listed, db));
        }
        assert!(gained > 0, "some of it is cheaper than the list");
    }

    #[test]
    fn what_failed_rules_out_what_is_no_better() {
        let model = model(Prefer::Area);
        assert!(model.is_no_better(&[1, 1, 0], &[1, 0, 0]));
        assert!(!model.is_no_better(&[0, 1, 0], &[1, 0, 0]), "its geometry does better");
    }
}
