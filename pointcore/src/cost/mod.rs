//! What the effects of planned hardware cost, and what leaving the others out saves.

pub mod budget;
mod table;

pub use table::{TABLE_HEAD, choices_row, table_row};

use crate::area::estimate::Estimator;
use crate::area::proxy::Proxy;
use crate::generated::GenerateError;
use crate::plan::{Effect, EffectExtent, Plan};
use crate::scene::Scene;
use crate::splat::{EncodedFrame, SplatCore, SplatRunner};
use pointcore_contract::splat::Config;
use pointcore_tb::lockstep::LockstepError;
use rayon::prelude::*;
use serde::Serialize;

/// Whether frames are run for their cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycles {
    /// On the golden model of each hardware.
    Measured,
    /// Only the area is told.
    Untold,
}

/// Hardware that could not be measured.
#[derive(Debug, thiserror::Error)]
pub enum CostError {
    /// A fault of the generator.
    #[error(transparent)]
    Generate(#[from] GenerateError),
    /// The frame does not come to its end.
    #[error(transparent)]
    Run(#[from] LockstepError),
}

/// What hardware takes, or by how much two differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct HardwareFigures {
    /// Bits of registers.
    pub register_bits: i64,
    /// Bits of memories and tables.
    pub memory_bits: i64,
    /// Multipliers.
    pub multipliers: i64,
    /// Bits of sums, differences and ordered comparisons.
    pub adder_bits: i64,
    /// Bits of two-way choices.
    pub mux_bits: i64,
    /// Look-up tables, estimated, where there is a record to estimate from.
    pub lut4: Option<f64>,
    /// Cycles of the frame, where it was run.
    pub cycles: Option<i64>,
}

/// An effect's price.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Priced {
    /// The effect.
    pub effect: Effect,
    /// What the planned hardware takes more than the same with the least of the effect. Cycles are those of another picture where that is
    /// less than the scene calls for.
    pub cost: HardwareFigures,
    /// What it takes less than the same with the most of the effect.
    pub saved: HardwareFigures,
}

/// What a plan costs.
#[derive(Clone, Debug, Serialize)]
pub struct Costs {
    /// The planned hardware.
    pub planned: HardwareFigures,
    /// Hardware with everything in.
    pub everything: HardwareFigures,
    /// Effect by effect.
    pub effects: Vec<Priced>,
}

impl HardwareFigures {
    fn minus(&self, other: &Self) -> Self {
        Self {
            register_bits: self.register_bits - other.register_bits,
            memory_bits: self.memory_bits - other.memory_bits,
            multipliers: self.multipliers - other.multipliers,
            adder_bits: self.adder_bits - other.adder_bits,
            mux_bits: self.mux_bits - other.mux_bits,
            lut4: self.lut4.zip(other.lut4).map(|(a, b)| a - b),
            cycles: self.cycles.zip(other.cycles).map(|(a, b)| a - b),
        }
    }
}

/// A share saved: how much less `planned` is than `everything`.
fn saved(planned: f64, everything: f64) -> f64 {
    1.0 - planned / everything
}

impl Costs {
    /// Prices the effects of a scene's hardware.
    ///
    /// # Errors
    /// A fault of the generator, or a frame that does not come to its end.
    pub fn of(scene: &Scene, plan: &Plan, cycles: Cycles, estimator: Option<&Estimator>) -> Result<Self, CostError> {
        let mut plans = vec![plan.clone(), plan.with_everything()];
        for &effect in plan.effects() {
            plans.extend([EffectExtent::Least, EffectExtent::Most].map(|extent| plan.at(effect, extent)));
        }
        let mut distinct: Vec<&Plan> = Vec::new();
        for plan in &plans {
            if distinct.iter().all(|other| other.config != plan.config) {
                distinct.push(plan);
            }
        }
        let measure = |plan: &&Plan| Ok((plan.config.clone(), figures(scene, plan, cycles, estimator)?));
        let measured =
            distinct.par_iter().map(measure).collect::<Result<Vec<(Config, HardwareFigures)>, CostError>>()?;
        let figures_of = |plan: &Plan| {
            let found = measured.iter().find(|(config, _)| *config == plan.config);
            found.expect("every configuration was measured").1
        };
        let (planned, everything) = (figures_of(&plans[0]), figures_of(&plans[1]));
        let priced = |&effect: &Effect| Priced {
            effect,
            cost: planned.minus(&figures_of(&plan.at(effect, EffectExtent::Least))),
            saved: figures_of(&plan.at(effect, EffectExtent::Most)).minus(&planned),
        };
        Ok(Self { planned, everything, effects: plan.effects().iter().map(priced).collect() })
    }

    /// Planned hardware and hardware with everything in, without the prices of single effects.
    ///
    /// # Errors
    /// As [`Costs::of`].
    pub fn whole(scene: &Scene, plan: &Plan, cycles: Cycles, estimator: Option<&Estimator>) -> Result<Self, CostError> {
        let planned = figures(scene, plan, cycles, estimator)?;
        let everything = figures(scene, &plan.with_everything(), cycles, estimator)?;
        Ok(Self { planned, everything, effects: Vec::new() })
    }

    /// Share of the cycles saved, where they were counted.
    #[must_use]
    pub fn cycles_saved(&self) -> Option<f64> {
        self.planned.cycles.zip(self.everything.cycles).map(|(planned, all)| saved(planned as f64, all as f64))
    }

    /// Share of the look-up tables saved, as far as they can be estimated.
    #[must_use]
    pub fn area_saved(&self) -> Option<f64> {
        self.planned.lut4.zip(self.everything.lut4).map(|(planned, all)| saved(planned, all))
    }

    /// Share of the memory saved.
    #[must_use]
    pub fn memory_saved(&self) -> f64 {
        saved(self.planned.memory_bits as f64, self.everything.memory_bits as f64)
    }

    /// Share of the multipliers saved.
    #[must_use]
    pub fn multipliers_saved(&self) -> f64 {
        saved(self.planned.multipliers as f64, self.everything.multipliers as f64)
    }
}

fn figures(
    scene: &Scene,
    plan: &Plan,
    cycles: Cycles,
    estimator: Option<&Estimator>,
) -> Result<HardwareFigures, CostError> {
    let core = SplatCore::generate(&plan.config)?;
    let proxy = Proxy::of(&core.design);
    let cycles = match cycles {
        Cycles::Untold => None,
        Cycles::Measured => {
            let frame = EncodedFrame::new(scene, plan);
            Some(SplatRunner::new(&plan.config, &frame).golden(&core)?.counters.cycles as i64)
        }
    };
    Ok(HardwareFigures {
        register_bits: proxy.register_bits as i64,
        memory_bits: proxy.memory_bits as i64,
        multipliers: proxy.multipliers as i64,
        adder_bits: proxy.adder_bits as i64,
        mux_bits: proxy.mux_bits as i64,
        lut4: estimator.and_then(|estimator| estimator.lut4(&proxy)),
        cycles,
    })
}
