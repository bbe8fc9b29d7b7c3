//! How far a neighborhood reaches: each entry's query with the comparison value `c` (thesis eq. 6.5, 6.6 and table 6.1).

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{AXES, CacheSetup};
use pointcore_contract::{record, width};

use super::lead::{Finished, Leading};
use super::lru::Chosen;
use super::neighborhoods::entry_words;
use crate::compiler::{CompileError, Datapath, Manifest, Options, Program, Value, compile};
use crate::units::passage::Passage;
use crate::units::values::{Terms, Values};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Memory, Module, bit};

/// What a query is compared with.
#[record(config: Config)]
pub(super) struct Cover {
    /// Where the query is that the neighborhood was found for.
    #[name(AXES[i])]
    #[bits(config.geometry.width())]
    pub point: [u32; 3],
    /// The comparison value.
    #[bits(config.geometry.width())]
    pub c: u32,
}

/// A neighborhood that is to be judged: its entry, its query, the squared distances that say how far it reaches.
#[record(config: Config)]
pub(super) struct Reach {
    /// The entry.
    #[bits(config.entry_bits())]
    pub entry: u8,
    /// Where its query is.
    #[name(AXES[i])]
    #[bits(config.geometry.width())]
    pub point: [u32; 3],
    /// Within this squared distance all points are known.
    #[bits(config.geometry.width())]
    pub far2: u32,
    /// Within this one lie all that are wanted.
    #[bits(config.geometry.width())]
    pub near2: u32,
    /// Whether others wait for it.
    pub leading: Leading,
}

/// A setting.
#[record(config: Config)]
struct FarScale {
    /// As in the setup.
    #[bits(config.geometry.width())]
    far_scale: u32,
}

/// A neighborhood that is judged.
#[record(config: Config)]
struct EntryCover {
    /// The entry.
    #[bits(config.entry_bits())]
    entry: u8,
    /// What queries are compared with.
    cover: Cover,
    /// Whether others wait for it.
    leading: Leading,
}

/// The comparison value from the squared distances.
fn comparison_value(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_cover", "How far a neighborhood reaches.");
    let Reach { entry, point, far2, near2, leading } = Reach::<Values>::inputs(&program, config);
    let root = |square: Value| square.as_float(config.geometry).sqrt();
    let far = root(far2).named("far");
    let FarScale { far_scale } = FarScale::<Values>::uniforms(&program, config, config.geometry);
    let cover = Cover { point, c: far * far_scale - root(near2).named("near") };
    EntryCover { entry, cover, leading }.outputs(&program, config);
    compile(&program, &options.taken_at_once())
}

/// A memory of them by entry.
pub(super) struct Covers {
    memory: Memory,
}

impl Covers {
    /// Unknown contents.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        Self { memory: m.memory("covers", entry_words(config), width::<Cover>(config)) }
    }

    /// An entry's, in the cycle after `enable`.
    pub fn read(&self, m: &mut Module, config: &Config, enable: Expr, entry: Expr) -> Cover<Wires> {
        let cover = m.read_if(self.memory, "entry_cover", enable, entry);
        Cover::unpack(config, cover)
    }

    /// Judges a neighborhood where `valid`; returns the entry whose comparison value is written, some time later, and the leader
    /// that it was found for.
    pub fn judge(
        self,
        m: &mut Module,
        config: &Config,
        options: &Options,
        settings: CacheSetup<Wires>,
        (valid, reach): (Expr, Reach<Wires>),
    ) -> Result<(Chosen, Finished, Manifest), CompileError> {
        let Datapath { module, manifest } = comparison_value(config, options)?;
        let datapath = Passage::<Reach, EntryCover>::place(m, "judge", module);
        let reach_valid = m.reg_reset("reach_valid", 1, 0);
        m.next(reach_valid, valid);
        let reach = reach.register(m, config, "reach_", bit(true));
        datapath.push(m, config, reach_valid, reach);
        datapath.set::<FarScale>(m, config, FarScale { far_scale: settings.far_scale });
        let out = datapath.out(m, config);
        m.drive(out.ready, bit(true));
        let EntryCover { entry, cover, leading } = out.record;
        m.write(self.memory, out.valid, entry, cover.pack(config));
        Ok((Chosen { valid: out.valid, entry }, Finished::of(out.valid, leading), manifest))
    }
}
