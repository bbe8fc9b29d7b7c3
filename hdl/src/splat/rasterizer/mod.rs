//! Rasterizer (thesis 5.4.2): walks a copy's rectangle and evaluates one sample a cycle; golden twin:
//! `pointcore_golden::splat::rasterizer`.

mod evaluation;
mod fixed_distance;
mod position;

use crate::compiler::{CompileError, Datapath, Options};
use crate::stream;
use crate::units::passage::Passage;
use crate::units::ports::{Flow, OutputPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, Wires, layout};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::COPY_QUEUE_DEPTH;
use pointcore_contract::splat::records::{LOCAL_BITS, PlacedCopy, Sample, TileRectangle};
use pointcore_contract::splat::units::RasterizerEvents;
use pointcore_contract::splat::units::rasterizer::PORTS;
use position::{Evaluated, Position, Shape, Shared};
use rtl::{Expr, Module, Reg, cat};

/// The scanner's registers. A copy of hundreds of bits hangs on whether one can be taken, so that is known before the cycle begins.
struct Scanner {
    busy: Reg,
    /// A copy can be taken: there is none, or its current pixel is the last.
    idle: Reg,
    end: Reg,
    /// The current pixel is the copy's last.
    last: Reg,
    slot: Reg,
    tile: Reg,
    column: Reg,
    row: Reg,
    left: Reg,
    right: Reg,
    bottom: Reg,
}

impl Scanner {
    fn new(m: &mut Module, config: &Config) -> Self {
        Self {
            busy: m.reg_reset("busy", 1, 0),
            idle: m.reg_reset("idle", 1, 1),
            end: m.reg("is_end", 1),
            last: m.reg("is_last", 1),
            slot: m.reg("slot", config.slot_bits()),
            tile: m.reg("tile", config.tile_bits()),
            column: m.reg("column", LOCAL_BITS),
            row: m.reg("row", LOCAL_BITS),
            left: m.reg("left", LOCAL_BITS),
            right: m.reg("right", LOCAL_BITS),
            bottom: m.reg("bottom", LOCAL_BITS),
        }
    }

    /// On `advance`: takes `copy`, if there is one, on `ready`; else steps to the next pixel or falls idle.
    fn step(&self, m: &mut Module, copy: &Flow<PlacedCopy<Wires>>, advance: Expr, ready: Expr) {
        let load = ready & copy.valid;
        let row_done = self.column.eq(self.right);
        m.next_if(self.busy, advance, load | (self.busy & !self.last));
        let PlacedCopy { copy, slot } = copy.record;
        let TileRectangle { left, right, top, bottom } = copy.bounds;
        m.next_if(self.end, ready, copy.end);
        m.next_if(self.slot, ready, slot);
        m.next_if(self.tile, ready, copy.tile);
        m.next_if(self.left, ready, left);
        m.next_if(self.right, ready, right);
        m.next_if(self.bottom, ready, bottom);
        let next_column = row_done.mux(self.left, self.column.add_lit(1));
        let next_row = row_done.mux(self.row.add_lit(1), self.row);
        m.next_if(self.column, advance, load.mux(left, next_column));
        m.next_if(self.row, advance, load.mux(top, next_row));
        let place = |column: Expr, row: Expr| cat([column, row]);
        let single = copy.end | place(left, top).eq(place(right, bottom));
        let reaches_last = place(next_column, next_row).eq(place(*self.right, *self.bottom));
        m.next_if(self.last, advance, load.mux(single, reaches_last));
        let falls_idle = !self.busy | (self.last | reaches_last);
        m.next_if(self.idle, advance, load.mux(single, falls_idle));
    }

    /// The current pixel of a splat.
    fn position(&self, config: &Config, shape: Shape<Wires>) -> Position<Wires> {
        let column_bits = config.tile_column_bits();
        let tile_column = self.tile.bits(column_bits - 1, 0);
        let tile_row = self.tile.bits(config.tile_bits() - 1, column_bits);
        Position {
            end: *self.end,
            last: self.last & !self.end,
            slot: *self.slot,
            column: cat([tile_column, *self.column]),
            row: cat([tile_row, *self.row]),
            shape,
        }
    }
}

/// The rasterizer; the manifest is that of its evaluation.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let Datapath { module: evaluation, manifest } = evaluation::datapath(config, options)?;
    let mut m = Module::new("splat_rasterizer", "Samples of a splat copy, one a cycle, with their kernel weights.");
    let copy = PORTS.input.declare(&mut m, config);
    let evaluation = Passage::<Position, Evaluated>::place(&mut m, "evaluation", evaluation);
    let advance = evaluation.room(&mut m);
    let queue = stream::fifo(COPY_QUEUE_DEPTH, &layout::<Shared>(config));
    let queue = Passage::<Shared>::place(&mut m, "shared", queue);
    let queue_ready = queue.room(&mut m);

    let scanner = Scanner::new(&mut m, config);
    let ready = m.wire("take", (advance & scanner.idle) & queue_ready);
    m.drive(copy.ready, ready);
    let load = m.wire("load", ready & copy.valid);
    scanner.step(&mut m, &copy, advance, ready);
    let splat = copy.record.copy;
    let shape = Shape::from(splat.footprint).register(&mut m, config, "", ready);
    evaluation.push(&mut m, config, scanner.busy, scanner.position(config, shape));
    let shared = Shared { band: splat.footprint.band, attributes: splat.attributes };
    queue.push(&mut m, config, load & !splat.end, shared);

    let (valid, Evaluated { place, band }) = evaluation.shown(&mut m, config);
    let (_, shared) = queue.shown(&mut m, config);
    let band = if config.has_depth_plane() { band } else { shared.band };
    let sample = Sample { place, band, attributes: shared.attributes };
    let out_ready = PORTS.out.drive(&mut m, config, valid, sample);
    evaluation.take(&mut m, out_ready);
    queue.take(&mut m, (out_ready & valid) & place.last);

    if config.screen_filter.is_on() {
        let filter_scale = PORTS.filter_scale.declare_word(&mut m, config.filter_scale_format().width());
        PORTS.filter_scale.feed_word(&mut m, evaluation.instance(), filter_scale);
    }
    let busy = scanner.busy.expr();
    let events = RasterizerEvents {
        sample: (advance & busy) & !scanner.end,
        starved: advance & !busy,
        blocked: busy & !advance,
    };
    PORTS.events.events(&mut m, config, events);
    Ok(Datapath { module: m, manifest })
}
