//! What a point of a sweep comes to: how far its picture is from the truth, how long it takes, and of how much hardware.

use nv_flip::{DEFAULT_PIXELS_PER_DEGREE, FlipImageRgb8, FlipPool, flip};
use pointcore::area::proxy::Proxy;
use pointcore::picture::Picture;
use pointcore_contract::splat::Config;
use pointcore_golden::reference::Frame;
use serde::{Deserialize, Serialize};

/// The signal-to-noise ratio of pictures that do not differ, beyond that of any that do: JSON has no infinity.
pub const PSNR_MAX_DB: f64 = 200.0;

/// What rendered a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PointEngine {
    /// The bit-exact, cycle-accurate golden model.
    Golden,
    /// The Verilog and the golden model in lockstep: every output was compared in every cycle.
    Lockstep,
    /// The f64 reference, which no hardware computes.
    F64,
}

impl PointEngine {
    /// As tables say it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Golden => "golden",
            Self::Lockstep => "lockstep",
            Self::F64 => "f64",
        }
    }
}

/// The figures of a point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointFigures {
    /// What rendered it.
    pub engine: PointEngine,
    /// Peak signal-to-noise ratio against the truth, up to [`PSNR_MAX_DB`].
    pub psnr_db: f64,
    /// How visible the differences from the truth are, by FLIP: the mean over all pixels, from 0 (not at all) to 1.
    pub flip: f64,
    /// The largest difference of a color component from the truth, of 1.
    pub worst: f64,
    /// Peak signal-to-noise ratio against the f64 reference at the same samples: what number formats alone cost.
    pub rounding_psnr_db: f64,
    /// Samples that show another surface than that reference's; none of a scene that moves, of which a sample shows several.
    pub surface_differences: Option<u64>,
    /// Samples of the frame.
    pub samples: u64,
    /// Time and hardware; none of [`PointEngine::F64`].
    pub hardware: Option<Hardware>,
}

/// What a point takes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hardware {
    /// Cycles of the frame.
    pub cycles: u64,
    /// Operators and memories.
    pub proxy: Proxy,
    /// The configuration; of a scene that moves, that of what moves.
    pub config: Config,
}

/// A picture beside the reference at the same samples.
pub struct Compared {
    /// Of the pictures.
    pub psnr_db: f64,
    /// Samples that show another surface, where each shows one.
    pub surface_differences: Option<u64>,
    /// Samples of the picture.
    pub samples: u64,
}

/// Samples that only one of two frames covers, or that show another material or another depth.
#[must_use]
pub fn surface_differences(frame: &Frame, reference: &Frame, depth_tolerance: f64) -> u64 {
    let pairs = frame.pixels.iter().zip(&reference.pixels);
    let differs = pairs.filter(|pair| match pair {
        (Some(a), Some(b)) => a.material != b.material || (a.depth - b.depth).abs() > depth_tolerance,
        (None, None) => false,
        _ => true,
    });
    differs.count() as u64
}

impl PointFigures {
    /// Compares a picture with the truth; beside it what it is compared with at the same samples.
    ///
    /// # Panics
    /// The pictures differ in size.
    #[must_use]
    pub fn new(
        engine: PointEngine,
        picture: &Picture,
        truth: &Picture,
        compared: &Compared,
        hardware: Option<Hardware>,
    ) -> Self {
        let differences = picture.pixels.iter().flatten().zip(truth.pixels.iter().flatten());
        Self {
            engine,
            psnr_db: picture.psnr_db(truth).min(PSNR_MAX_DB),
            flip: perceived(picture, truth),
            worst: differences.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max),
            rounding_psnr_db: compared.psnr_db.min(PSNR_MAX_DB),
            surface_differences: compared.surface_differences,
            samples: compared.samples,
            hardware,
        }
    }
}

/// Mean FLIP error at the distance from the screen that its authors suggest.
pub(crate) fn perceived(picture: &Picture, truth: &Picture) -> f64 {
    let image =
        |picture: &Picture| FlipImageRgb8::with_data(picture.width as u32, picture.height as u32, &picture.bytes());
    let errors = flip(image(truth), image(picture), DEFAULT_PIXELS_PER_DEGREE);
    f64::from(FlipPool::from_image(&errors).mean())
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_golden::reference::{Fragment, Statistics};

    fn picture(value: f64) -> Picture {
        Picture { width: 16, height: 16, pixels: vec![[value, 0.5, 0.5]; 256] }
    }

    fn frame(pixels: Vec<Option<Fragment>>) -> Frame {
        let (decisions, margins) = (Vec::new(), Vec::new());
        Frame { width: pixels.len(), height: 1, pixels, decisions, margins, statistics: Statistics::default() }
    }

    fn fragment(depth: f64, material: u16) -> Option<Fragment> {
        Some(Fragment { depth, weight: 1.0, attributes: [0.0; 6], material })
    }

    #[test]
    fn other_surfaces_are_told_by_cover_material_and_depth() {
        let truth = frame(vec![None, None, fragment(0.5, 0), fragment(0.5, 0), fragment(0.5, 0), fragment(0.5, 0)]);
        let seen = frame(vec![None, fragment(0.5, 0), None, fragment(0.5, 1), fragment(0.6, 0), fragment(0.501, 0)]);
        let differences = surface_differences(&seen, &truth, 0.01);
        assert_eq!(differences, 4);
        let compared = Compared { psnr_db: f64::INFINITY, surface_differences: Some(differences), samples: 6 };
        let figures = PointFigures::new(PointEngine::F64, &picture(0.5), &picture(0.5), &compared, None);
        assert_eq!((figures.psnr_db, figures.rounding_psnr_db, figures.worst), (PSNR_MAX_DB, PSNR_MAX_DB, 0.0));
        assert_eq!(figures.flip, 0.0);
        let off = PointFigures::new(PointEngine::F64, &picture(0.5), &picture(0.25), &compared, None);
        assert!((off.worst - 0.25).abs() < 1e-9 && off.flip > 0.05 && off.psnr_db < 20.0, "{off:?}");
    }
}
