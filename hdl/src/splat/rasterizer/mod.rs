//! Rasterizer (thesis 5.4.2): walks a copy's rectangle and evaluates one sample a cycle; golden twin:
//! `pointcore_golden::splat::rasterizer`.

mod fixed_distance;

use super::parts::division::squared_ratio;
use crate::compiler::{CompileError, Datapath, Options, Program, Table, Type, Value, compile};
use crate::float::exp_neg;
use crate::stream;
use crate::units::datapath::{Inputs, uniform};
use crate::units::records::{layout, stream_in};
use pointcore_contract::splat::config::{COPY_QUEUE_DEPTH, DEPTH_BITS, TILE_SIZE, index_bits};
use pointcore_contract::splat::{Config, Field, RasterFormat, records};
use pointcore_contract::{Fixed, Format, FragmentDepth, Sampling, Signedness};
use rtl::{Expr, Instance, Module, Reg, Stream, cat};
use std::rc::Rc;

/// Bits of a pixel's column or row within its tile.
const LOCAL_BITS: u32 = index_bits(TILE_SIZE);

/// What the scanner sends into the evaluation, one item a sample.
fn position(config: &Config) -> Vec<Field> {
    let flags = ["end", "last"].map(|name| (name.to_owned(), 1));
    let mut record = flags.to_vec();
    record.push(("slot".to_owned(), config.slot_bits()));
    record.push(("column".to_owned(), config.column_bits()));
    record.push(("row".to_owned(), config.row_bits()));
    let shared = records::shared(config);
    record.extend(records::footprint(config).into_iter().filter(|field| !shared.contains(field)));
    record
}

/// exp(−γρ²) for ρ² in `[0, 1]`.
fn kernel(config: &Config) -> Result<Rc<Table>, CompileError> {
    let shape = config.kernel_table();
    Table::new(shape, exp_neg::samples(config.kernel_gamma, shape)).map(Rc::new)
}

/// `ρ²` of a sample.
enum Squared {
    /// A number, from the offsets `x` and `y` to the splat's centre, px.
    Float { format: Format, distance: Value, offset: [Value; 2] },
    /// Its leading bits.
    Fixed(fixed_distance::Squared),
}

/// Intersects the viewing ray of each sample with the splat's plane (table 5.2, recentred) and weighs it.
fn evaluation(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program =
        Program::new("splat_evaluation", "Distance of a sample from its splat's centre, and its kernel weight.");
    let input = Inputs::new(&program, &position(config));
    let squared = match config.raster_format() {
        RasterFormat::Float(format) => floating(config, format, &program, &input),
        RasterFormat::Fixed(coefficient) => {
            let places = ["column", "row"].map(|axis| sample(config.sampling, &program, &input, axis));
            Squared::Fixed(fixed_distance::squared(config, coefficient, &program, &input, places))
        }
    };

    let (end, last) = (input.bits("end"), input.bits("last"));
    let covered = match &squared {
        Squared::Float { format, distance, .. } => distance.lt(program.float(*format, 1.0)),
        Squared::Fixed(squared) => squared.covered,
    };
    let inside = covered & !end;
    program.keep_if(inside | last | end);
    let kernel = kernel(config)?;
    let argument_bits = kernel.shape().index_bits + kernel.shape().fraction_bits;
    let argument = match &squared {
        Squared::Float { distance, .. } => {
            distance.to_fixed(Fixed { width: argument_bits, fraction: argument_bits, signed: Signedness::Unsigned })
        }
        Squared::Fixed(squared) => squared.argument,
    };
    let weight = argument.kernel(&kernel);
    let local = |name| input.bits(name).bits(LOCAL_BITS - 1, 0);
    let pixel = local("row").cat(local("column"));
    let mut computed = vec![("inside", inside), ("pixel", pixel), ("weight", weight)];
    if let (FragmentDepth::Plane, Squared::Float { format, offset, .. }) = (config.depth, &squared) {
        computed.extend(depth_band(*format, &program, &input, offset));
    }
    input.output(&program, &records::evaluated(config), &computed);
    compile(&program, options)
}

/// `ρ²` in a floating-point format.
fn floating(config: &Config, format: Format, program: &Program, input: &Inputs) -> Squared {
    let coefficient = |name| input.float(format, name);
    let offset = |pixel: &str, center: &str| {
        let (place, fraction) = sample(config.sampling, program, input, pixel);
        place.to_float(format, fraction) - input.float(format, center)
    };
    let (x, y) = (offset("column", "center_x"), offset("row", "center_y"));

    let s1 = x * coefficient("ay") - y * coefficient("ax");
    let s2 = x * coefficient("by") - y * coefficient("bx");
    let d = coefficient("delta") + x * coefficient("mx") + y * coefficient("my");
    let mut distance = squared_ratio(config.division, s1, s2, d);
    if config.eye_plane.is_on() {
        let behind = sign(d, format) ^ sign(coefficient("delta"), format);
        let infinity = program.constant(Type::Float(format), format.infinity());
        distance = behind.mux(infinity, distance);
    }
    if config.screen_filter.is_on() {
        let screen = (x * x + y * y) * uniform(program, format, "filter_scale");
        distance = distance.min(screen);
    }
    Squared::Float { format, distance, offset: [x, y] }
}

/// Place of a sample along an axis, px, as a fixed-point number with its fraction bits.
fn sample(sampling: Sampling, program: &Program, input: &Inputs, axis: &str) -> (Value, u32) {
    let index = input.bits(axis);
    match sampling {
        Sampling::Center => (index.cat(program.lit(1, 1)), 1),
        Sampling::Flipquad => {
            let is_top = input.bits("column").bits(0, 0);
            let odd = input.bits("column").bits(1, 1) ^ input.bits("row").bits(0, 0);
            let [none, three, five] = [0, 3, 5].map(|eighths| program.lit(3, eighths));
            let (pixel, eighths) = match axis {
                "column" => ((index >> 1), is_top.mux(odd.mux(five, three), none)),
                _ => (index, is_top.mux(none, odd.mux(three, five))),
            };
            (pixel.cat(eighths), 3)
        }
    }
}

/// Depth of the splat's plane at a sample, within the splat's range, and the ends of its ε-band.
fn depth_band(format: Format, program: &Program, input: &Inputs, [x, y]: &[Value; 2]) -> [(&'static str, Value); 3] {
    let number = |name| input.float(format, name);
    let plane = number("depth_center") + *x * number("depth_x") + *y * number("depth_y");
    let depth = plane.max(number("depth_near")).min(number("depth_far"));
    let (low, high) = (depth - number("epsilon"), depth + number("epsilon"));
    let zero = program.float(format, 0.0);
    let shape = Fixed { width: DEPTH_BITS, fraction: DEPTH_BITS, signed: Signedness::Unsigned };
    let fixed = |depth: Value| depth.max(zero).to_fixed(shape);
    [("depth", fixed(depth)), ("depth_low", fixed(low)), ("depth_high", fixed(high))]
}

fn sign(value: Value, format: Format) -> Value {
    let top = format.width() - 1;
    value.bits(top, top)
}

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
        let local = LOCAL_BITS;
        Self {
            busy: m.reg_reset("busy", 1, 0),
            idle: m.reg_reset("idle", 1, 1),
            end: m.reg("is_end", 1),
            last: m.reg("is_last", 1),
            slot: m.reg("slot", config.slot_bits()),
            tile: m.reg("tile", config.tile_bits()),
            column: m.reg("column", local),
            row: m.reg("row", local),
            left: m.reg("left", local),
            right: m.reg("right", local),
            bottom: m.reg("bottom", local),
        }
    }

    /// On `advance`: takes `copy`, if there is one, on `ready`; else steps to the next pixel or falls idle.
    fn step(&self, m: &mut Module, copy: &Stream, advance: Expr, ready: Expr) {
        let load = &(ready & copy.valid);
        let row_done = self.column.eq(self.right);
        m.next_if(self.busy, advance, *load | (*self.busy & !*self.last));
        for (register, field) in [
            (&self.end, "end"),
            (&self.slot, "slot"),
            (&self.tile, "tile"),
            (&self.left, "left"),
            (&self.right, "right"),
            (&self.bottom, "bottom"),
        ] {
            m.next_if(*register, ready, copy.field(field));
        }
        let next_column = row_done.mux(self.left, self.column.add_lit(1));
        let next_row = row_done.mux(self.row.add_lit(1), self.row);
        m.next_if(self.column, advance, load.mux(copy.field("left"), next_column));
        m.next_if(self.row, advance, load.mux(copy.field("top"), next_row));
        let place = |column: Expr, row: Expr| cat([column, row]);
        let corner = place(copy.field("right"), copy.field("bottom"));
        let single = copy.field("end") | place(copy.field("left"), copy.field("top")).eq(corner);
        let reaches_last = place(next_column, next_row).eq(place(*self.right, *self.bottom));
        m.next_if(self.last, advance, load.mux(single, reaches_last));
        let falls_idle = !*self.busy | (*self.last | reaches_last);
        m.next_if(self.idle, advance, load.mux(single, falls_idle));
    }

    /// Connects the evaluation's input to the current pixel.
    fn emit(&self, m: &mut Module, evaluation: Instance, config: &Config) {
        let column_bits = config.tile_column_bits();
        let tile_column = self.tile.bits(column_bits - 1, 0);
        let tile_row = self.tile.bits(config.tile_bits() - 1, column_bits);
        m.connect(evaluation, "in_valid", self.busy);
        m.connect(evaluation, "in_end", self.end);
        m.connect(evaluation, "in_last", *self.last & !*self.end);
        m.connect(evaluation, "in_slot", self.slot);
        m.connect(evaluation, "in_column", cat([tile_column, *self.column]));
        m.connect(evaluation, "in_row", cat([tile_row, *self.row]));
    }
}

/// The rasterizer; the manifest is that of its evaluation.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let Datapath { module: evaluation, manifest } = evaluation(config, options)?;
    let mut m = Module::new("splat_rasterizer", "Samples of a splat copy, one a cycle, with their kernel weights.");
    let copy = stream_in(&mut m, "in", &records::placed_copy(config));
    let evaluation = m.instance("evaluation", evaluation);
    let advance = m.out(evaluation, "in_ready");

    let shared = records::shared(config);
    let queue = m.instance("shared", stream::fifo(COPY_QUEUE_DEPTH, &layout(&shared)));
    let queue_ready = m.out(queue, "in_ready");

    let scanner = Scanner::new(&mut m, config);
    let ready = m.wire("take", (advance & *scanner.idle) & queue_ready);
    m.ready(&copy, ready);
    let load = m.wire("load", ready & copy.valid);
    scanner.step(&mut m, &copy, advance, ready);
    scanner.emit(&mut m, evaluation, config);
    for (name, width) in position(config).iter().skip(5) {
        let register = m.reg(name, *width);
        m.next_if(register, ready, copy.field(name));
        m.connect(evaluation, &format!("in_{name}"), register);
    }
    m.connect(queue, "in_valid", load & !copy.field("end"));
    for (name, _) in &shared {
        m.connect(queue, &format!("in_{name}"), copy.field(name));
    }

    let mut fields = Vec::new();
    for (name, _) in records::sample(config) {
        let source = if shared.iter().any(|(field, _)| *field == name) { queue } else { evaluation };
        let value = m.out(source, &format!("out_{name}"));
        fields.push((name, value));
    }
    let valid = m.out(evaluation, "out_valid");
    let last = m.out(evaluation, "out_last");
    let out_ready = m.stream_out("out", valid, fields);
    m.connect(evaluation, "out_ready", out_ready);
    m.connect(queue, "out_ready", (out_ready & valid) & last);

    if config.screen_filter.is_on() {
        let filter_scale = m.input("filter_scale", config.uniform_format("filter_scale").width());
        m.connect(evaluation, "filter_scale", filter_scale);
    }
    let busy = scanner.busy.expr();
    for (name, event) in [
        ("event_sample", (advance & busy) & !*scanner.end),
        ("event_starved", advance & !busy),
        ("event_blocked", busy & !advance),
    ] {
        let register = m.reg_reset(name, 1, 0);
        m.next(register, event);
        m.output(name, register);
    }
    Ok(Datapath { module: m, manifest })
}
