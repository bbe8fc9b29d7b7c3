//! What moves, as hardware with bins of the exposure takes it.

use super::lens::Lens;
use crate::exposure::shutter;
use crate::number::{encode, encode_attribute};
use crate::plan::Plan;
use crate::scene::Scene;
use glam::DVec3;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::motion::SHUTTER;
use pointcore_contract::splat::records::{self, Shutter};
use pointcore_golden::reference::motion::{Interval, MovingSplat};

/// Every splat that moves, or part of its way, and what stands for the screen filter.
pub(crate) fn moving_records(scene: &Scene, plan: &Plan) -> Vec<records::Splat> {
    let config = &plan.config;
    let lens = Lens::of(scene);
    let record = |moving: MovingSplat| {
        let mut record = moving_record(&moving, config);
        for (attribute, &index) in record.attributes.iter_mut().zip(&plan.attributes) {
            *attribute = encode_attribute(config.attribute, moving.splat.attributes[index]);
        }
        record.attributes[config.continuous as usize..config.attributes() as usize].fill(moving.splat.material.into());
        record
    };
    let parts = scene.moving_part(config.time_bins as usize);
    parts.iter().flat_map(|moving| lens.sent(moving)).flatten().map(record).collect()
}

/// A splat's place, way and tangents.
pub(crate) fn moving_record(moving: &MovingSplat, config: &Config) -> records::Splat {
    let vector = |numbers: [f32; 3]| numbers.map(|number| encode(config.geometry, number));
    let MovingSplat { splat, motion, part } = moving;
    // The hardware counts from the middle of the exposure, not of the part.
    let center = DVec3::from_array(splat.center.map(f64::from)) - part.middle() * *motion;
    let [center, way] = [center, *motion].map(|numbers| vector(numbers.as_vec3().to_array()));
    let part = [part.begin, part.end].map(|time| encode(config.geometry, time as f32));
    let motion = records::Motion { way, part };
    records::Splat { center, tangents: splat.tangents.map(vector), motion, ..records::Splat::default() }
}

/// How much each bin of the exposure counts, all together as many as there are.
pub(crate) fn shutter_weights(scene: &Scene, config: &Config) -> Shutter {
    let (shutter, bins) = (shutter(scene), config.time_bins);
    let mut registers = Shutter::default();
    for (weight, part) in registers.weight.iter_mut().zip(Interval::equal_parts(bins as usize)) {
        *weight = (shutter.share(part) * f64::from(bins << SHUTTER.fraction)).round() as u32;
    }
    registers
}
