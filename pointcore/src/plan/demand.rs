//! What a frame asks of the hardware, splat by splat, by the hardware's own arithmetic: the golden models of transform and setup with
//! everything in are asked what they do with a splat, so that a part is left out only if no bit of the frame hangs on it.
//!
//! Samples are too many to be tried one by one. What follows bounds the rasterizer's rounding, with `u` half a unit in the last place relative
//! to a number, `S = |x|(|A_y| + |B_y|) + |y|(|A_x| + |B_x|)` at most over the bounds, and all numbers those that setup has stored.
//!
//! **Eye plane.** `D = Δ − ⟨s, (α, β)⟩` up to order and signs (docs/splat.md), so that `|s| ≥ |Δ − D|/√q`. Rounding moves `|s|` by at most
//! `3uS` and `D` by at most `6uS + 4u|Δ|`. A sample that the hardware takes for one behind the eye has a `D` of the other sign than `Δ`, or one
//! within its rounding of zero; then `|s| ≥ (|Δ| + |D|)/√q` less rounding, and since `q < 1 − clearance` its `ρ² = |s|²/D²` comes out at 1 or
//! more unless `|Δ|` is within `10u(S + |Δ|)` of zero. At 1 and more a sample is outside, as it is at infinity. The few splats whose `Δ`
//! is so small are sampled, and those of which near or far plane may cut something.
//!
//! **Screen filter.** `|s| ≤ σ_max·dist`, `D ≥ Δ − √q|s|` and `Δ = σ_min·σ_max` of the projection's Jacobian, so that
//! `ρ ≤ dist/(σ_min − √q·dist)`, which is below the filter's `dist/radius` within the radius if `σ_min ≥ radius(1 + √q)`. The margin is for
//! rounding, which moves every factor by a few `u` and `Δ` by `4uσ_max²`.
//!
//! **In fixed point** rounding is that of offsets and coefficients, absolute rather than relative, and neither argument holds near a splat's
//! centre. There every splat's samples are tried, with the part and without.

use crate::number::{decode, encode};
use crate::scene::Scene;
use crate::splat::Front;
use crate::splat::moving::{Lens, moving_record};
use crate::uniforms::uniforms;
use pointcore_contract::splat::config::{MEMORY_PORTS_MAX, TILE_SIZE};
use pointcore_contract::splat::records::Uniforms;
use pointcore_contract::splat::records::{Footprint, ImageRectangle, SetupSplat, Sight, Splat as Record, SplatCopy};
use pointcore_contract::splat::{Config, Feature, RasterFormat};
use pointcore_contract::{Format, Splat};
use pointcore_golden::reference::motion::MovingSplat;
use pointcore_golden::splat::uniforms::{SetupUniforms, TransformUniforms};
use pointcore_golden::splat::{Rasterizer, Setup, Slant, Splitter, Transform, rasterizer};
use rayon::prelude::*;

/// Share by which a splat must be wider than the screen filter, if only for the radius' own rounding.
const FILTER_MARGIN: f64 = 1.0 / 256.0;
/// The same in units of rounding, of which a sample's distances collect less than half as many.
const FILTER_MARGIN_UNITS: f64 = 128.0;
/// Twice the roundings that the bound on `|s|` and `D` collects, in `u(S + |Δ|)`: more than those of a footprint's conversion, too.
const SIDE_UNITS: f64 = 20.0;
/// Numbers between these neither overflow nor vanish when squared.
const SQUARABLE: std::ops::RangeInclusive<f64> = 1e-12..=1e18;
/// Splats of more samples are not tried sample by sample: the part that they may need costs less than that.
const SAMPLES_TRIED: usize = 1 << 14;

/// A share of the rasterizer's cycles: what transform and setup may take, as splats do not come evenly.
const SHARE: f64 = 0.8;
/// A share of the rasterizers' cycles: what the frame's pixels may take to leave, before which they go to memory and come back more
/// than once.
const PIXELS_SHARE: f64 = 0.25;
/// More cycles a splat save next to nothing.
const INTERVAL_MAX: u32 = 8;

/// How the units before the rasterizer are loaded beside it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Load {
    /// Splats.
    pub splats: usize,
    /// Samples within their bounds, of which a rasterizer takes one a cycle.
    pub samples: usize,
}

impl Load {
    /// The greater one: more splats to a sample.
    const fn or(self, other: Self) -> Self {
        let is_greater = self.splats * other.samples >= other.splats * self.samples;
        if is_greater { self } else { other }
    }

    const fn sum(self, other: Self) -> Self {
        Self { splats: self.splats + other.splats, samples: self.samples + other.samples }
    }

    /// The most cycles, a power of two, that a splat may take while samples in so many rasterizers take longer.
    pub fn interval(self, rasterizers: u32) -> u32 {
        let cycles = SHARE * self.samples as f64 / (self.splats.max(1) as f64 * f64::from(rasterizers));
        let longest = INTERVAL_MAX.ilog2();
        (0..=longest).rev().map(|power| 1 << power).find(|&interval| f64::from(interval) <= cycles).unwrap_or(1)
    }
}

/// Copies that a lane holds: as many as tiles need that take turns, to twice as many payloads as cost a core's block RAM.
const COPY_LEVELS: std::ops::RangeInclusive<u32> = 10..=12;

/// What the splats of a frame ask for together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Demand {
    /// Splats that culling drops and nothing else would.
    pub back_facing: usize,
    /// Splats of whose samples or bounds the screen filter may decide one.
    pub filtered: usize,
    /// Splats that move and are narrower than the screen filter, whose disc the host sends.
    pub discs: usize,
    /// Splats that reach near, far or eye plane, or with samples of which only that says that they are outside.
    pub crossing: usize,
    /// The first of them.
    pub first_crossing: Option<usize>,
    /// Splats that are drawn.
    pub drawn: usize,
    /// Copies of them, one a tile.
    pub copies: usize,
    /// Of transform and setup beside the rasterizer.
    pub load: Load,
    /// Tile columns and rows that they lie in.
    pub(super) tiles: Option<[[u32; 2]; 2]>,
}

impl Demand {
    /// What the frames of a scene ask for on hardware with everything in: of each figure the greatest.
    pub(super) fn of(scene: &Scene, everything: &Config) -> Self {
        let now = Self::of_frame(scene, everything);
        // The first of several frames is what a scene shows when it is planned, or any: all are asked.
        if scene.views.len() < 2 {
            return now;
        }
        let mut shown = scene.clone();
        scene.views.iter().fold(now, |demand, view| {
            shown.look(view);
            demand.or(Self::of_frame(&shown, everything))
        })
    }

    /// What the frame that a scene shows asks for.
    fn of_frame(scene: &Scene, everything: &Config) -> Self {
        let units = Units::new(scene, everything);
        scene
            .splats
            .par_iter()
            .enumerate()
            .map(|(index, splat)| units.demand(index, splat))
            .reduce(Self::default, Self::sum)
    }

    /// What splats that move ask for, on hardware with near and far plane.
    pub(super) fn of_moving(scene: &Scene, splats: &[MovingSplat], config: &Config) -> Self {
        let front = Front::new(config, &uniforms(&scene.camera, &scene.rendering, config));
        let lens = Lens::of(scene);
        let of_record = |index: usize, moving: &MovingSplat| {
            let Some(Ok(drawn)) = front.set_up(&moving_record(moving, config)) else {
                return Self { load: Load { splats: 1, samples: 0 }, ..Self::default() };
            };
            // Where all of a splat's way lies between the planes, they are met never.
            let [begin, end, _] = drawn.moving.footprint.planes.map(|time| decode(config.geometry, time));
            let is_crossing = !(begin.is_infinite() && end.is_infinite());
            Self {
                crossing: is_crossing.into(),
                first_crossing: is_crossing.then_some(index),
                ..Self::drawn(config, &drawn, front.copies(&drawn))
            }
        };
        let of_splat = |(index, moving): (usize, &MovingSplat)| {
            let sent = lens.sent(moving);
            let discs = usize::from(sent[1].is_some());
            let records = sent.iter().flatten().map(|moving| of_record(index, moving));
            records.fold(Self { discs, ..Self::default() }, Self::sum)
        };
        let all = splats.par_iter().enumerate().map(of_splat).reduce(Self::default, Self::sum);
        // A place has a tile for each bin.
        let last = config.time_bins - 1;
        let tiles = all.tiles.map(|[columns, rows]| [columns.map(|column| column << config.bin_bits()), rows]);
        Self { tiles: tiles.map(|[[left, right], rows]| [[left, right + last], rows]), ..all }
    }

    /// Of a splat that is drawn.
    fn drawn(config: &Config, drawn: &SetupSplat, copies: impl Iterator<Item = SplatCopy>) -> Self {
        let rows = |copy: &SplatCopy| copy.bounds.top..=copy.bounds.bottom;
        let columns =
            |copy: &SplatCopy, row| rasterizer::columns(config.sampling.columns(), &copy.bounds, &copy.diagonals, row);
        let visited = |copy: SplatCopy| rows(&copy).map(|row| columns(&copy, row).count()).sum::<usize>();
        let (copies, samples) = copies.map(visited).fold((0, 0), |(count, sum), samples| (count + 1, sum + samples));
        let ImageRectangle { left, right, top, bottom } = drawn.bounds;
        let tiles = [[left, right], [top, bottom]].map(|range| range.map(|pixel| u32::from(pixel) / TILE_SIZE));
        Self { drawn: 1, copies, load: Load { splats: 1, samples }, tiles: Some(tiles), ..Self::default() }
    }

    /// Of two frames, the greater of each figure, and the tiles of both.
    fn or(self, other: Self) -> Self {
        Self {
            back_facing: self.back_facing.max(other.back_facing),
            filtered: self.filtered.max(other.filtered),
            discs: self.discs.max(other.discs),
            crossing: self.crossing.max(other.crossing),
            drawn: self.drawn.max(other.drawn),
            copies: self.copies.max(other.copies),
            load: self.load.or(other.load),
            ..self.sum(other)
        }
    }

    fn sum(self, other: Self) -> Self {
        let tiles = match (self.tiles, other.tiles) {
            (Some(a), Some(b)) => Some([0, 1].map(|axis: usize| {
                let ([a_first, a_last], [b_first, b_last]) = (a[axis], b[axis]);
                [a_first.min(b_first), a_last.max(b_last)]
            })),
            (a, b) => a.or(b),
        };
        Self {
            back_facing: self.back_facing + other.back_facing,
            filtered: self.filtered + other.filtered,
            discs: self.discs + other.discs,
            crossing: self.crossing + other.crossing,
            first_crossing: self.first_crossing.into_iter().chain(other.first_crossing).min(),
            drawn: self.drawn + other.drawn,
            copies: self.copies + other.copies,
            load: self.load.sum(other.load),
            tiles,
        }
    }

    /// Pixels of the tiles that splats lie in, at most.
    pub(super) fn pixels(&self) -> usize {
        self.tiles().map(|edge| (edge * TILE_SIZE) as usize).into_iter().product()
    }

    /// Ports to memory for so many rasterizers: as many as let the frame's pixels leave, one a cycle each, in no more than a share of
    /// the time that samples take, and a pixel for each copy come back, whose tile may have gone.
    pub(super) fn memory_ports(&self, rasterizers: u32) -> u32 {
        let cycles = PIXELS_SHARE * self.load.samples as f64 / f64::from(rasterizers);
        let needed = ((self.pixels() + self.copies) as f64 / cycles.max(1.0)).ceil() as u32;
        needed.next_power_of_two().min(rasterizers).clamp(1, MEMORY_PORTS_MAX)
    }

    /// Levels of copies whose samples take as long as the frame's pixels need to leave, one a cycle: once the last splat has come, it
    /// leaves while those are drawn.
    pub(super) fn copy_levels(&self) -> u32 {
        let copies = self.pixels() * self.copies / self.load.samples.max(1);
        copies.max(1).next_power_of_two().ilog2().clamp(*COPY_LEVELS.start(), *COPY_LEVELS.end())
    }

    /// Columns and rows of the rectangle of tiles in which all drawn splats lie.
    pub(super) fn tiles(&self) -> [u32; 2] {
        self.tiles.map_or([0, 0], |axes| axes.map(|[first, last]| last - first + 1))
    }
}

/// The units that decide, with a frame's constants.
struct Units<'a> {
    config: &'a Config,
    transform_uniforms: TransformUniforms,
    setup_uniforms: SetupUniforms,
    filter_scale: u32,
    transform: Transform,
    setup: Setup,
    without_culling: Setup,
    without_planes: (Transform, Setup),
    without_filter: Setup,
    splitter: Splitter,
    rasterizer: Rasterizer,
    without_side: Rasterizer,
    without_disc: Rasterizer,
}

impl<'a> Units<'a> {
    fn new(scene: &Scene, config: &'a Config) -> Self {
        let registers = uniforms(&scene.camera, &scene.rendering, config);
        let Uniforms { model_view, near_plane, viewport, epsilon, filter_radius, filter_scale, .. } = registers;
        let without_planes = Config { eye_plane: Feature::Off, ..config.clone() };
        Self {
            config,
            transform_uniforms: TransformUniforms { model_view, near_plane },
            setup_uniforms: SetupUniforms { viewport, epsilon, near_plane, filter_radius },
            filter_scale,
            transform: Transform::new(config, 1),
            setup: Setup::new(config, 1),
            without_culling: Setup::new(&Config { culling: Feature::Off, ..config.clone() }, 1),
            without_planes: (Transform::new(&without_planes, 1), Setup::new(&without_planes, 1)),
            without_filter: Setup::new(&Config { screen_filter: Feature::Off, ..config.clone() }, 1),
            splitter: Splitter::new(config),
            rasterizer: Rasterizer::new(config, 1),
            without_side: Rasterizer::new(&Config { eye_plane: Feature::Off, ..config.clone() }, 1),
            without_disc: Rasterizer::new(&Config { screen_filter: Feature::Off, ..config.clone() }, 1),
        }
    }

    fn demand(&self, index: usize, splat: &Splat) -> Demand {
        let record_vector = |vector: [f32; 3]| vector.map(|value| encode(self.config.geometry, value));
        let record = Record {
            center: record_vector(splat.center),
            tangents: splat.tangents.map(record_vector),
            ..Record::default()
        };
        let dropped = Demand { load: Load { splats: 1, samples: 0 }, ..Demand::default() };
        let Some(splat) = self.transform.transform(&record, &self.transform_uniforms) else { return dropped };
        let Some(drawn) = self.setup.setup(&splat, &self.setup_uniforms) else {
            let is_culled = self.without_culling.setup(&splat, &self.setup_uniforms).is_some();
            // What nothing is seen of has bounds all the same where that is not asked.
            let is_crossing = self.lacks(&record, None);
            return Demand {
                back_facing: is_culled.into(),
                crossing: is_crossing.into(),
                first_crossing: is_crossing.then_some(index),
                ..dropped
            };
        };
        let slant = self.setup.slant_of(&splat, &self.setup_uniforms);
        let footprint = Footprint { sight: Sight { disc: false, ..drawn.footprint.sight }, ..drawn.footprint };
        let covers_filter = self.covers_filter(&drawn, &slant)
            && self.without_filter.setup(&splat, &self.setup_uniforms) == Some(SetupSplat { footprint, ..drawn });
        let is_crossing = !slant.is_whole || self.lacks(&record, Some(&drawn)) || self.needs_side(&drawn);
        Demand {
            back_facing: 0,
            filtered: (!covers_filter).into(),
            crossing: is_crossing.into(),
            first_crossing: is_crossing.then_some(index),
            ..Demand::drawn(self.config, &drawn, self.splitter.copies(&drawn))
        }
    }

    /// Whether setup makes another splat of it, or one or none where it should not, without the part for near, far and eye plane.
    fn lacks(&self, record: &Record, drawn: Option<&SetupSplat>) -> bool {
        let (transform, setup) = &self.without_planes;
        let splat = transform.transform(record, &self.transform_uniforms);
        let without = splat.and_then(|splat| setup.setup(&splat, &self.setup_uniforms));
        let blind = |drawn: &SetupSplat| Footprint { sight: Sight::default(), ..drawn.footprint };
        without != drawn.map(|drawn| SetupSplat { footprint: blind(drawn), ..*drawn })
    }

    /// Whether the side of the eye may decide of a sample of a whole splat.
    fn needs_side(&self, drawn: &SetupSplat) -> bool {
        let RasterFormat::Float(format) = self.config.raster_format() else {
            return self.differs(drawn, &self.without_side);
        };
        let Footprint { center, ax, bx, ay, by, delta, .. } = drawn.footprint;
        let value = |bits| value(format, bits);
        let delta = value(delta).abs();
        let Sight { near, far, .. } = drawn.footprint.sight;
        if far != 0 || near.count_ones() < self.config.raster_format().limit_width() {
            return self.differs(drawn, &self.without_side);
        }
        // A splat seen edge-on: every distance is NaN, on whichever side.
        if delta.is_nan() {
            return false;
        }
        let ImageRectangle { left, right, top, bottom } = drawn.bounds;
        let reach = |center: u32, columns: u32, first: u16, last: u16| {
            // Between these edges of pixels lie all samples. Their places are rounded where a format has fewer digits than an image pixels.
            let edges = [u32::from(first) / columns, u32::from(last) / columns + 1].map(f64::from);
            let offset = |edge: f64| (edge - value(center)).abs() + rounding(format) * edge;
            edges.map(offset).into_iter().fold(0.0, f64::max)
        };
        let columns = self.config.sampling.columns();
        let [x, y] = [reach(center[0], columns, left, right), reach(center[1], 1, top, bottom)];
        let [extent_x, extent_y] = [[ax, bx], [ay, by]].map(|[a, b]| value(a).abs() + value(b).abs());
        let sum = x * extent_y + y * extent_x + delta;
        let is_far = delta >= SIDE_UNITS * rounding(format) * sum;
        let is_squarable = SQUARABLE.contains(&delta) && SQUARABLE.contains(&sum);
        !(is_far && is_squarable) && self.differs(drawn, &self.without_side)
    }

    /// Whether any sample of a splat comes out otherwise without a part of the rasterizer, by trying them; splats of very many are said to
    /// need it.
    fn differs(&self, drawn: &SetupSplat, without: &Rasterizer) -> bool {
        let ImageRectangle { left, right, top, bottom } = drawn.bounds;
        let (columns, rows) = (left..=right, top..=bottom);
        if columns.len() * rows.len() > SAMPLES_TRIED {
            return true;
        }
        let outcome = |unit: &Rasterizer, pixel: [u32; 2]| {
            let squared = unit.squared_distance(&drawn.footprint, pixel, self.filter_scale);
            (Rasterizer::is_inside(squared), unit.weight(squared))
        };
        let pixels = rows.flat_map(|row| columns.clone().map(move |column| [column, row].map(u32::from)));
        pixels.into_iter().any(|pixel| outcome(&self.rasterizer, pixel) != outcome(without, pixel))
    }

    /// Whether the splat's projection holds the screen filter's disc, so that the filter never decides.
    fn covers_filter(&self, drawn: &SetupSplat, slant: &Slant) -> bool {
        let RasterFormat::Float(format) = self.config.raster_format() else {
            return !self.differs(drawn, &self.without_disc);
        };
        let footprint = &drawn.footprint;
        let value = |bits| value(format, bits);
        if !slant.is_whole || value(footprint.delta).is_nan() {
            return false;
        }
        let radius = f64::from(decode(self.config.geometry, self.setup_uniforms.filter_radius));
        let [ax, bx, ay, by] = [footprint.ax, footprint.bx, footprint.ay, footprint.by].map(value);
        // Of all coefficients setup has taken one power of two, which `Δ` has once and the product of tangents twice.
        let taken = ((ax * by - bx * ay) / value(footprint.delta)).abs().log2().round().exp2();
        let [ax, bx, ay, by] = [ax, bx, ay, by].map(|length| length / taken);
        let (sum, difference) = ((ax + by).hypot(ay - bx), (ax - by).hypot(ay + bx));
        let (smallest, largest) = ((sum - difference).abs() / 2.0, (sum + difference) / 2.0);
        let steepness = f64::from(slant.alpha.value()).hypot(slant.beta.value().into());
        let margin = FILTER_MARGIN.max(FILTER_MARGIN_UNITS * rounding(format));
        smallest - 8.0 * rounding(format) * largest >= radius * (1.0 + steepness) * (1.0 + margin)
    }
}

/// A number of a footprint.
fn value(format: Format, bits: u32) -> f64 {
    decode(format, bits).into()
}

/// `u`: what a rounding may change a footprint's number by, relative to it.
fn rounding(format: Format) -> f64 {
    0.5_f64.powi(format.mantissa as i32 + 1)
}
