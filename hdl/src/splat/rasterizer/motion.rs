//! Rasterizer of splats that move while the shutter is open (thesis chapter 4): integrates one sample after the other over a bin of the exposure;
//! golden twin: `pointcore_golden::splat::MotionRasterizer`.

use super::scanner::{self, Scanner};
use crate::compiler::{CompileError, Datapath, Options};
use crate::splat::motion_evaluation;
use crate::stream;
use crate::units::passage::Passage;
use crate::units::ports::{OutputPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, Wires, layout};
use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::motion::SHARE_BITS;
use pointcore_contract::splat::records::{
    ATTRIBUTES, Band, MovingPlace, MovingSample, Sample, SamplePlace, attribute_name,
};
use pointcore_contract::splat::units::motion_evaluation::PORTS as EVALUATION;
use pointcore_contract::splat::units::rasterizer::PORTS;
use rtl::{Expr, Module, lit};

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
    let mut m = Module::new("splat_rasterizer", "Samples of a moving splat's copy in a bin of the exposure.");
    let copy = PORTS.input.declare(&mut m, config);
    let evaluation = Passage::<MovingPlace, MovingSample>::place(&mut m, "evaluation", evaluation);
    let advance = evaluation.room(&mut m);
    let queue = stream::fifo(scanner::copies(&manifest), &layout::<Shared>(config));
    let queue = Passage::<Shared>::place(&mut m, "shared", queue);

    let scanner = Scanner::new(&mut m, config);
    let [ready, load] = scanner.take(&mut m, config, &copy, advance);
    queue.has_room_for(&mut m, load);
    let moving = copy.record.moving;
    let footprint = moving.footprint.register(&mut m, config, "", ready);
    let [column, row] = scanner.place(config);
    let odd_bin = scanner.odd_bin(config);
    let place = MovingPlace { last: *scanner.last, slot: *scanner.slot, column, row, odd_bin, footprint };
    evaluation.push(&mut m, config, scanner.busy, place);
    queue.push(&mut m, config, load, Shared { epsilon: moving.epsilon, attributes: copy.record.attributes });
    let depth_a = PORTS.depth_a.declare_word(&mut m, config.geometry.width());
    EVALUATION.depth_a.feed_word(&mut m, evaluation.instance(), depth_a);

    let (valid, moving) = evaluation.shown(&mut m, config);
    let (_, shared) = queue.shown(&mut m, config);
    let sample = sample(&mut m, config, &moving, &shared);
    let counts = m.wire("counts", sample.place.inside | sample.place.last);
    let shows = m.wire("shows", valid & counts);
    let out_ready = PORTS.out.drive(&mut m, config, shows, sample);
    let passes = m.wire("passes", valid & (out_ready | !counts));
    evaluation.take(&mut m, passes);
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

/// What a bin sees of a sample.
fn sample(m: &mut Module, config: &Config, moving: &MovingSample<Wires>, shared: &Shared<Wires>) -> Sample<Wires> {
    let MovingSample { last, inside, slot, pixel, time, depth: [begin, end], share } = *moving;
    let weight = weight(config, share);
    let depth = m.wire("depth", begin.add_carry(end).bits(DEPTH_BITS, 1));
    let nears = m.wire("nears", end.lt(begin));
    let [near, far] =
        [("near", nears.mux(end, begin)), ("far", nears.mux(begin, end))].map(|(name, depth)| m.wire(name, depth));
    let high = m.wire("high", far.add_carry(shared.epsilon));
    let low = near.lt(shared.epsilon).mux(lit(DEPTH_BITS, 0), near - shared.epsilon);
    let band = Band { depth, low, high: high.trunc(DEPTH_BITS) | high.msb().repeat(DEPTH_BITS) };
    let place = SamplePlace { last, inside: inside & weight.any(), slot, pixel, weight };
    Sample { place, band, time, attributes: shared.attributes }
}
