//! Rasterizer of splats that move while the shutter is open (thesis chapter 4): integrates one sample after the other, and cuts each into its bins;
//! golden twin: `pointcore_golden::splat::MotionRasterizer`.

use super::scanner::Scanner;
use crate::compiler::{CompileError, Datapath, Options};
use crate::splat::motion_evaluation;
use crate::stream;
use crate::units::passage::Passage;
use crate::units::ports::{OutputPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, Wires, layout};
use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{COPY_QUEUE_DEPTH, DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::motion::SHARE_BITS;
use pointcore_contract::splat::records::{
    ATTRIBUTES, Band, MovingPlace, MovingSample, PIXEL_BITS, Sample, SamplePlace, attribute_name,
};
use pointcore_contract::splat::units::motion_evaluation::PORTS as EVALUATION;
use pointcore_contract::splat::units::rasterizer::PORTS;
use rtl::{Expr, Module, Reg, bit, cat, lit};

/// What all samples of a copy share.
#[record(config: Config)]
struct Shared {
    /// Half the depth band.
    #[bits(DEPTH_BITS)]
    epsilon: u32,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    attributes: [u32; ATTRIBUTES],
}

/// The rasterizer; the manifest is that of its evaluation.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let Datapath { module: evaluation, manifest } = motion_evaluation::datapath(config, options)?;
    let mut m = Module::new("splat_rasterizer", "Samples of a moving splat's copy, bin by bin of the exposure.");
    let copy = PORTS.input.declare(&mut m, config);
    let evaluation = Passage::<MovingPlace, MovingSample>::place(&mut m, "evaluation", evaluation);
    let advance = evaluation.room(&mut m);
    let queue = Passage::<Shared>::place(&mut m, "shared", stream::fifo(COPY_QUEUE_DEPTH, &layout::<Shared>(config)));
    let queue_ready = queue.room(&mut m);

    let scanner = Scanner::new(&mut m, config);
    let [ready, load] = scanner.take(&mut m, config, &copy, [advance, queue_ready]);
    let moving = copy.record.moving;
    let footprint = moving.footprint.register(&mut m, config, "", ready);
    let [column, row] = scanner.place(config);
    let place = MovingPlace { last: *scanner.last, slot: *scanner.slot, column, row, footprint };
    evaluation.push(&mut m, config, scanner.busy, place);
    queue.push(&mut m, config, load, Shared { epsilon: moving.epsilon, attributes: copy.record.attributes });
    let depth_a = PORTS.depth_a.declare_word(&mut m, config.geometry.width());
    EVALUATION.depth_a.feed_word(&mut m, evaluation.instance(), depth_a);

    let (valid, moving) = evaluation.shown(&mut m, config);
    let (_, shared) = queue.shown(&mut m, config);
    let bins = Bins::new(&mut m, config);
    let sample = bins.sample(&mut m, config, &moving, &shared);
    let counts = m.wire("counts", sample.place.inside | sample.place.last);
    let shows = m.wire("shows", valid & counts);
    let out_ready = PORTS.out.drive(&mut m, config, shows, sample);
    let passes = m.wire("passes", valid & (out_ready | !counts));
    let leaves = bins.step(&mut m, passes);
    evaluation.take(&mut m, leaves);
    queue.take(&mut m, (shows & out_ready) & sample.place.last);

    PORTS.events.events(&mut m, config, scanner.events(advance));
    Ok(Datapath { module: m, manifest })
}

/// A bin's share of the exposure as one of the bin; what does not fit weighs most.
fn weight(config: &Config, share: Expr) -> Expr {
    let bits = config.bin_bits();
    let of_bin = share.bits(SHARE_BITS - 1, SHARE_BITS - WEIGHT_BITS - bits);
    if bits == 0 {
        return of_bin;
    }
    of_bin.trunc(WEIGHT_BITS) | of_bin.bits(WEIGHT_BITS + bits - 1, WEIGHT_BITS).any().repeat(WEIGHT_BITS)
}

/// Which bin of the sample that leaves the evaluation is shown; of one bin nothing has to be counted.
struct Bins {
    number: Option<Reg>,
    last: Expr,
}

impl Bins {
    fn new(m: &mut Module, config: &Config) -> Self {
        if config.bin_bits() == 0 {
            return Self { number: None, last: bit(true) };
        }
        let number = m.reg_reset("bin", config.bin_bits(), 0);
        Self { number: Some(number), last: number.all() }
    }

    /// The current one of a value for each bin.
    fn pick(&self, values: impl Iterator<Item = Expr>) -> Expr {
        let values: Vec<_> = values.collect();
        self.number.map_or(values[0], |number| number.pick(values.iter().copied()))
    }

    /// What the bin sees.
    fn sample(
        &self,
        m: &mut Module,
        config: &Config,
        moving: &MovingSample<Wires>,
        shared: &Shared<Wires>,
    ) -> Sample<Wires> {
        let bins = config.time_bins as usize;
        let between = |values: &[Expr]| [0, 1].map(|end| self.pick((0..bins).map(|bin| values[bin + end])));
        let [begin, end] = between(&moving.time);
        let [near, far] = between(&moving.depth);
        let share = m.wire("share", self.pick(moving.share[..bins].iter().copied()));
        let weight = weight(config, share);
        let depth = m.wire("depth", near.add_carry(far).bits(DEPTH_BITS, 1));
        let high = m.wire("high", depth.add_carry(shared.epsilon));
        let low = depth.lt(shared.epsilon).mux(lit(DEPTH_BITS, 0), depth - shared.epsilon);
        let band = Band { depth, low, high: high.trunc(DEPTH_BITS) | high.msb().repeat(DEPTH_BITS) };

        // Modulo two bins, of which every other border is zero.
        let time_bits = config.bin_time_bits();
        let odd = self.number.map_or(bit(false), |number| number.bit(0));
        let border = |odd: Expr| cat([odd, lit(time_bits - 1, 0)]);
        let time = [border(!odd) - begin.trunc(time_bits), end.trunc(time_bits) - border(odd)];
        let place = SamplePlace {
            last: moving.last & self.last,
            inside: moving.inside & weight.any(),
            slot: moving.slot,
            pixel: self.number.map_or(moving.pixel, |number| moving.pixel | number.zext(PIXEL_BITS)),
            weight,
        };
        Sample { place, band, time, attributes: shared.attributes }
    }

    /// Goes on to the next bin; returns whether that is the next sample's.
    fn step(&self, m: &mut Module, passes: Expr) -> Expr {
        if let Some(number) = self.number {
            m.next_if(number, passes, number.add_lit(1));
        }
        passes & self.last
    }
}
