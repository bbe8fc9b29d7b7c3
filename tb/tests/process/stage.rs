//! The blocks `init` and `final` as units against their models: each thread leaves with what was computed of its words.

use pointcore_contract::process::Config;
use pointcore_contract::{Format, Record, Unit, fields};
use pointcore_golden::float;
use pointcore_golden::unit::Model;
use pointcore_hdl::compiler::Datapath;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};

const QUERIES: u64 = 40;

/// Collects threads.
#[derive(Clone, Default)]
struct Threads {
    entered: Vec<u64>,
    left: Vec<u64>,
}

impl Rule for Threads {
    const SEEDS: u64 = 160;

    fn transferred(&mut self, _: &mut Feeds, stream: &str, fields: &[u64]) {
        let threads = if stream == "in" { &mut self.entered } else { &mut self.left };
        threads.push(fields[0]);
    }
}

/// What the library's programs say is below this is finite, of a square, too.
const LARGEST: f64 = 1e38;
/// And how many powers of two below its root.
const BELOW: i32 = 6;

/// Words of a record; those of a float's width have magnitudes that programs can do something with, all of them in most records: a single
/// one that is out of all proportion hides the others in a sum. Now and then one has a single bit, or none, or is infinite.
fn any_words<R: Record<Config = Config>>(config: &Config, random: &mut fastrand::Rng) -> Vec<u64> {
    let format = config.format;
    let is_wild = random.u8(..4) == 0;
    let few_bits = random.u8(..4) == 0;
    let mut integer = 0;
    let mut word = |width: u32| {
        let word = random.u64(..) >> (64 - width);
        if width != format.width() && random.bool() {
            integer = if random.bool() { word } else { (integer + random.u64(..2)) & (u64::MAX >> (64 - width)) };
            return integer;
        }
        let exponent = random.i32(format.bias() - 6..format.bias() + 4) as u64;
        let is_tame = width == format.width() && !(is_wild && random.u8(..8) == 0);
        match random.u8(..8) {
            0 if few_bits => 0,
            1 if few_bits => 1 << random.u32(..width),
            2 if is_wild && width == format.width() => format.infinity(),
            _ if is_tame => word & !format.infinity() | exponent << format.mantissa,
            _ => word,
        }
    };
    fields::<R>(config).into_iter().map(|field| word(field.width)).collect()
}

/// Words of a record of which most are zero, and some of the first partial sums one, or a hair from what is just finite, or from its root,
/// or a power of two below that: a square that is wrong by as much is then not finite.
fn few_words<R: Record<Config = Config>>(config: &Config, random: &mut fastrand::Rng) -> Vec<u64> {
    let format = config.format;
    let mut word = |name: &str, width: u32| {
        let root = LARGEST.sqrt() * 0.5_f64.powi(random.i32(0..BELOW));
        let value = [0.0, 1.0, LARGEST, root][random.usize(..4)];
        let is_first = !name.starts_with("sum_") || name.ends_with("_0");
        if width != format.width() || !is_first || random.bool() {
            return 0;
        }
        let word = float::convert(Format::F32, format, (value as f32).to_bits().into());
        if value > 1.0 {
            word.wrapping_add_signed(random.i64(-8..8) << random.u32(..format.mantissa - 8))
        } else {
            word
        }
    };
    fields::<R>(config).into_iter().map(|field| word(&field.name, field.width)).collect()
}

/// Words of a record.
pub fn words<R: Record<Config = Config>>(config: &Config, random: &mut fastrand::Rng) -> Vec<u64> {
    if random.u8(..4) == 0 { few_words::<R>(config, random) } else { any_words::<R>(config, random) }
}

/// Compares a block with its model.
pub fn agree<M, I, S>(config: &Config, unit: &Unit<Config>, (datapath, model): (Datapath, M))
where
    M: Model<Config = Config> + 'static,
    I: Record<Config = Config>,
    S: Record<Config = Config>,
{
    let begin = |feeds: &mut Feeds| {
        let settings = words::<S>(config, &mut feeds.random);
        for (field, value) in fields::<S>(config).iter().zip(settings) {
            feeds.hold(&format!("setting_{}", field.name), value);
        }
        for _ in 0..QUERIES {
            let mut input = words::<I>(config, &mut feeds.random);
            input[0] = feeds.random.u32(..config.threads).into();
            feeds.feed("in", input);
        }
        Threads::default()
    };
    lockstep(config, &datapath.module, &model, unit, begin, all, |threads, report| {
        assert_eq!(report.transfers("out"), QUERIES);
        assert_eq!(threads.left, threads.entered);
    });
}
