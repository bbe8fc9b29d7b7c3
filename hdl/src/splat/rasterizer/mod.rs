//! Rasterizer (thesis 5.4.2): walks the octagon of a copy and evaluates one sample a cycle; golden twin:
//! `pointcore_golden::splat::rasterizer`.

mod evaluation;
mod fixed_distance;
mod motion;
mod position;
mod scanner;

use crate::compiler::{CompileError, Datapath, Options};
use crate::stream;
use crate::units::passage::Passage;
use crate::units::ports::{OutputPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, layout};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Sample;
use pointcore_contract::splat::units::rasterizer::PORTS;
use position::{Evaluated, Position, Shape, Shared};
use rtl::Module;
use scanner::Scanner;

/// The rasterizer; the manifest is that of its evaluation.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    if config.has_motion() {
        return motion::datapath(config, options);
    }
    let Datapath { module: evaluation, manifest } = evaluation::datapath(config, options)?;
    let mut m = Module::new("splat_rasterizer", "Samples of a splat copy, one a cycle, with their kernel weights.");
    let copy = PORTS.input.declare(&mut m, config);
    let evaluation = Passage::<Position, Evaluated>::place(&mut m, "evaluation", evaluation);
    let advance = evaluation.room(&mut m);
    let queue = stream::fifo(scanner::copies(&manifest), &layout::<Shared>(config));
    let queue = Passage::<Shared>::place(&mut m, "shared", queue);

    let scanner = Scanner::new(&mut m, config);
    let [ready, load] = scanner.take(&mut m, config, &copy, advance);
    queue.has_room_for(&mut m, load);
    let splat = copy.record;
    let shape = Shape::from(splat.footprint).register(&mut m, config, "", ready);
    let [column, row] = scanner.place(config);
    let position = Position { last: *scanner.last, slot: *scanner.slot, column, row, shape };
    evaluation.push(&mut m, config, scanner.busy, position);
    let shared = Shared { band: splat.footprint.band, attributes: splat.attributes };
    queue.push(&mut m, config, load, shared);

    let (valid, Evaluated { place, band }) = evaluation.shown(&mut m, config);
    let (_, shared) = queue.shown(&mut m, config);
    let band = if config.has_depth_plane() { band } else { shared.band };
    let sample = Sample { place, band, attributes: shared.attributes, ..Sample::default() };
    let out_ready = PORTS.out.drive(&mut m, config, valid, sample);
    evaluation.take(&mut m, out_ready);
    queue.take(&mut m, (out_ready & valid) & place.last);

    if config.screen_filter.is_on() {
        let filter_scale = PORTS.filter_scale.declare_word(&mut m, config.filter_scale_format().width());
        PORTS.filter_scale.feed_word(&mut m, evaluation.instance(), filter_scale);
    }
    PORTS.events.events(&mut m, config, scanner.events(advance));
    Ok(Datapath { module: m, manifest })
}
