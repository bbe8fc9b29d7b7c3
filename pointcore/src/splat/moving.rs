//! A scene that moves while the shutter is open: what moves on hardware with bins of the exposure, and what stands still on hardware without.

use super::encode::{END, EncodedFrame};
use crate::exposure::shutter;
use crate::number::{decode, decode_attribute, encode, encode_attribute};
use crate::plan::differing;
use crate::scene::Scene;
use crate::shading;
use crate::uniforms::uniforms;
use glam::DVec3;
use pointcore_contract::Splat;
use pointcore_contract::splat::config::ConfigError;
use pointcore_contract::splat::motion::{SHUTTER, TIME_FRACTION_BITS};
use pointcore_contract::splat::records::{self, Attributes, Seen, Shutter};
use pointcore_contract::splat::{Config, Feature};
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use pointcore_golden::reference::motion::{Exposure, Interval, MovingSplat, Place};
use pointcore_golden::reference::{Fragment, Frame};

/// A moving scene and the hardware that draws what moves in it.
pub struct MovingScene<'a> {
    scene: &'a Scene,
    /// What moves.
    splats: Vec<MovingSplat>,
    /// What stands still.
    still: Vec<Splat>,
    config: Config,
    /// As in a [`Plan`](crate::plan::Plan): the attributes that the hardware is given, and the values of the others.
    attributes: Vec<usize>,
    constants: [Option<f32>; CONTINUOUS_ATTRIBUTES],
    /// That of all splats, where hardware need not carry it.
    only_material: Option<u16>,
}

impl<'a> MovingScene<'a> {
    /// A scene on hardware with so many bins, all else as `like` has it. Such hardware has no screen filter: a splat that moves, and is smaller than
    /// a pixel, leaves holes.
    ///
    /// # Errors
    /// There is no such hardware.
    pub fn new(scene: &'a Scene, time_bins: u32, like: &Config) -> Result<Self, ConfigError> {
        let (still, splats): (Vec<_>, Vec<_>) = scene.moving_splats().into_iter().partition(MovingSplat::is_still);
        let still = still.into_iter().map(|moving| moving.splat).collect();
        let (attributes, constants) = differing(splats.iter().map(|moving| &moving.splat));
        let materials = || splats.iter().map(|moving| moving.splat.material);
        let first = materials().next().unwrap_or_default();
        let only_material = materials().all(|material| material == first).then_some(first);
        let edge = |edge: usize| u32::try_from(edge).unwrap_or(u32::MAX);
        let config = Config {
            width: edge(scene.rendering.width).saturating_mul(time_bins.max(1)),
            height: edge(scene.rendering.height),
            sampling: scene.rendering.sampling,
            depth: scene.rendering.depth,
            kernel_gamma: scene.rendering.kernel_gamma,
            continuous: attributes.len() as u32,
            cardinal: only_material.is_none().into(),
            time_bins,
            culling: Feature::On,
            screen_filter: Feature::Off,
            eye_plane: Feature::On,
            ..like.clone()
        };
        config.validate()?;
        Ok(Self { scene, splats, still, config, attributes, constants, only_material })
    }

    /// The hardware.
    #[must_use]
    pub const fn config(&self) -> &Config {
        &self.config
    }

    /// The splats that stand still for all of the exposure: hardware without bins draws them.
    #[must_use]
    pub fn still(&self) -> &[Splat] {
        &self.still
    }

    /// Every splat that moves, or part of its way, as the hardware takes it.
    #[must_use]
    pub fn frame(&self) -> EncodedFrame {
        let records = self.splats.iter().map(|moving| self.record(moving)).chain([END]).collect();
        let registers = uniforms(&self.scene.camera, &self.scene.rendering, &self.config);
        EncodedFrame { records, uniforms: records::Uniforms { shutter: self.shutter(), ..registers } }
    }

    fn record(&self, moving: &MovingSplat) -> records::Splat {
        let Self { config, attributes, .. } = self;
        let vector = |vector: DVec3| vector.as_vec3().to_array().map(|number| encode(config.geometry, number));
        let double = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from));
        let MovingSplat { splat, motion, part } = moving;
        // The hardware counts from the middle of the exposure, not of the part.
        let center = double(splat.center) - part.middle() * *motion;
        let mut encoded = Attributes::default();
        for (attribute, &index) in encoded.iter_mut().zip(attributes) {
            *attribute = encode_attribute(config.attribute, splat.attributes[index]);
        }
        encoded[config.continuous as usize..config.attributes() as usize].fill(splat.material.into());
        let part = [part.begin, part.end].map(|time| encode(config.geometry, time as f32));
        records::Splat {
            end: false,
            center: vector(center),
            tangents: splat.tangents.map(|tangent| vector(double(tangent))),
            motion: records::Motion { way: vector(*motion), part },
            attributes: encoded,
        }
    }

    /// How much each bin counts, all together as many as there are.
    fn shutter(&self) -> Shutter {
        let (shutter, bins) = (shutter(self.scene), self.config.time_bins);
        let mut registers = Shutter::default();
        for (weight, part) in registers.weight.iter_mut().zip(Interval::equal_parts(bins as usize)) {
            *weight = (shutter.share(part) * f64::from(bins << SHUTTER.fraction)).round() as u32;
        }
        registers
    }

    /// What fragments expose, surface by surface, before a frame of what stands still: what lies behind that is not seen.
    #[must_use]
    pub fn exposure(&self, fragments: &[records::Fragment], background: &Frame) -> Exposure {
        let rendering = &self.scene.rendering;
        let shade = shading::colors(self.scene, &self.scene.camera);
        let mut exposure = Exposure::dark(rendering);
        for found in fragments {
            let [column, row] = [found.column >> self.config.bin_bits(), found.row].map(usize::from);
            let (place, index) = (Place::new(column, row, rendering), row * exposure.width + column);
            let Seen { share, rest_share, depth, ref attributes } = found.seen;
            for (share, depth, attributes) in [(share, found.depth, &found.attributes), (rest_share, depth, attributes)]
            {
                let surface = self.surface(depth, attributes);
                let hides = |still: &Fragment| still.depth < surface.depth - rendering.epsilon_bias;
                if share > 0 && !background.pixels[index].as_ref().is_some_and(hides) {
                    let share = f64::from(share) / f64::from(1 << TIME_FRACTION_BITS);
                    exposure.samples[index].add(shade(&surface, place.position), share);
                }
            }
        }
        for (index, sample) in exposure.samples.iter_mut().enumerate() {
            if let Some(still) = &background.pixels[index] {
                let place = Place::new(index % exposure.width, index / exposure.width, rendering);
                sample.add(shade(still, place.position), 1.0 - sample.coverage);
            }
        }
        exposure
    }

    fn surface(&self, depth: u32, bits: &Attributes) -> Fragment {
        let config = &self.config;
        let mut attributes = self.constants.map(|constant| f64::from(constant.unwrap_or(0.0)));
        for (&index, &bits) in self.attributes.iter().zip(bits) {
            attributes[index] = decode_attribute(config.attribute, bits).into();
        }
        let material = self.only_material.unwrap_or(bits[config.continuous as usize] as u16);
        Fragment { depth: decode(config.geometry, depth).into(), weight: 1.0, attributes, material }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exposure::by_method;
    use crate::shading::exposed;
    use crate::splat::{SplatCore, SplatRunner};
    use pointcore_golden::reference::motion::Method;
    use pointcore_golden::reference::{Mapping, render};
    use std::path::Path;

    /// Hardware sums in fewer bits, takes the depth of a bin from its ends, and hides what stands still a surface at a time.
    const PSNR_DB: f64 = 40.0;

    #[test]
    fn hardware_exposes_what_bins_in_f64_do() {
        for name in ["rotation", "uncover"] {
            let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/motion")).join(name);
            let changes = ["image.width=64", "image.height=64", "splatting.filter_radius_px=0"].map(str::to_owned);
            let scene = Scene::load(&path.with_extension("toml"), &changes).unwrap_or_else(|error| panic!("{error}"));
            let moving = MovingScene::new(&scene, 4, &Config::default()).unwrap_or_else(|error| panic!("{error}"));
            let core = SplatCore::generate(moving.config()).unwrap_or_else(|error| panic!("{error}"));
            let frame = moving.frame();
            let outcome = SplatRunner::new(moving.config(), &frame).golden(&core);
            let outcome = outcome.unwrap_or_else(|error| panic!("{error}"));
            let background = render(moving.still(), &scene.camera, &scene.rendering, Mapping::Backward);
            let hardware = exposed(&moving.exposure(&outcome.fragments, &background), &scene);
            let reference = exposed(&by_method(&scene, &scene.moving_splats(), Method::Bins(4), &|| ()), &scene);
            let psnr_db = hardware.psnr_db(&reference);
            println!("{name}: {psnr_db:.1} dB, {} splats, {} cycles", frame.records.len(), outcome.simulated_cycles);
            assert!(psnr_db > PSNR_DB, "{name}: {psnr_db} dB");
        }
    }
}
