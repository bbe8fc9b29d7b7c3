//! Hard cases as frames for the whole core.

use super::case::{Case, Lens};
use super::families::{LEVELS, case};
use super::family::Family;
use pointcore::splat::{END, EncodedFrame};
use pointcore_contract::splat::records::Uniforms;
use pointcore_contract::splat::{Config, Feature};

/// Splats of a frame: more than the heap holds, on a few tiles.
pub const FRAME_SPLATS: u64 = 5000;

/// A small image, so that what covers all of it costs little, with a heap that holds 4,095 copies.
#[must_use]
pub fn config() -> Config {
    Config {
        width: 16,
        height: 8,
        heap_levels: 12,
        tile_slots: 2,
        culling: Feature::On,
        screen_filter: Feature::On,
        ..Config::default()
    }
}

/// Cases from `first` on, families and severities in turns, before the same camera.
#[must_use]
pub fn frame(config: &Config, first: u64, splats: u64, seed: u64) -> EncodedFrame {
    let format = config.geometry;
    let families = Family::ALL.len() as u64;
    let splat = |index: u64| {
        let level = ((index / families) % u64::from(LEVELS)) as u8;
        let mut splat = case(Family::ALL[(index % families) as usize], level, format, (seed << 40) ^ index).splat;
        // Cases are for cores of any configuration.
        splat.attributes[config.attributes() as usize..].fill(0);
        splat
    };
    EncodedFrame {
        records: (first..first + splats).map(splat).chain([END]).collect(),
        uniforms: uniforms(config),
        depths: None,
    }
}

/// Constants of a camera before which all cases are what they are named for.
pub(crate) fn uniforms(config: &Config) -> Uniforms {
    let ordinary = case(Family::Ordinary, 0, config.geometry, 0);
    // The image is a part of that of all cases, magnified to the same angle.
    let scale = Lens::new(config.geometry, 1.0, 1000.0).scale / 32.0;
    let origin = [config.width, config.height].map(|edge| f64::from(edge) / 2.0);
    let case = Case { lens: Lens { scale, origin, ..ordinary.lens }, ..ordinary };
    let (transform, setup) = (case.transform_uniforms(), case.setup_uniforms());
    Uniforms {
        model_view: transform.model_view,
        viewport: setup.viewport,
        near_plane: transform.near_plane,
        epsilon: setup.epsilon,
        filter_radius: setup.filter_radius,
        filter_scale: case.filter_scale(),
        ..Uniforms::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_has_its_splats_and_an_end() {
        let config = config();
        assert_eq!(config.validate(), Ok(()));
        let frame = frame(&config, 7, 30, 1);
        let ends: Vec<_> = frame.records.iter().map(|record| record.end).collect();
        assert_eq!((ends.len(), ends.iter().position(|end| *end)), (31, Some(30)));
    }
}
