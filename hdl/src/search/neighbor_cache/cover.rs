//! How far a neighborhood reaches: each entry's query with the comparison value `c` (thesis eq. 6.5, 6.6 and table 6.1).

use pointcore_contract::search::Config;
use pointcore_contract::splat::Field;

use super::lru::Chosen;
use super::neighborhoods::entry_words;
use crate::compiler::{CompileError, Datapath, Manifest, Options, Program, compile};
use crate::units::datapath::{Inputs, uniform};
use crate::units::records::{Record, width};
use rtl::{Expr, Memory, Module, bit};

fn numbers(config: &Config, names: &[&str]) -> Vec<Field> {
    names.iter().map(|&name| (name.to_owned(), config.geometry.width())).collect()
}

/// What a query is compared with.
pub(super) fn cover_fields(config: &Config) -> Vec<Field> {
    numbers(config, &["x", "y", "z", "c"])
}

/// A neighborhood that is to be judged: its entry, its query, the squared distances that say how far it reaches.
pub(super) fn reach_fields(config: &Config) -> Vec<Field> {
    let mut fields = vec![("entry".to_owned(), config.entry_bits())];
    fields.extend(numbers(config, &["x", "y", "z", "far2", "near2"]));
    fields
}

/// The comparison value from the squared distances.
fn comparison_value(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_cover", "How far a neighborhood reaches.");
    let reach = Inputs::new(&program, &reach_fields(config));
    let root = |name: &str| reach.float(config.geometry, name).sqrt();
    let far = root("far2") * uniform(&program, config.geometry, "far_scale");
    let computed = [("c", far - root("near2"))];
    program.output("entry", reach.bits("entry"));
    reach.output(&program, &cover_fields(config), &computed);
    compile(&program, options)
}

/// A memory of them by entry.
pub(super) struct Covers {
    fields: Vec<Field>,
    memory: Memory,
}

impl Covers {
    /// Unknown contents.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let fields = cover_fields(config);
        let memory = m.memory("covers", entry_words(config), width(&fields));
        Self { fields, memory }
    }

    /// An entry's, in the cycle after `enable`.
    pub fn read(&self, m: &mut Module, enable: Expr, entry: Expr) -> Record {
        let cover = m.read_if(self.memory, "entry_cover", enable, entry);
        Record::unpack(&self.fields, cover)
    }

    /// Judges a neighborhood where `valid`; returns the entry whose comparison value is written, some time later.
    pub fn judge(
        self,
        m: &mut Module,
        config: &Config,
        options: &Options,
        settings: &Record,
        (valid, reach): (Expr, &Record),
    ) -> Result<(Chosen, Manifest), CompileError> {
        let Datapath { module, manifest } = comparison_value(config, options)?;
        let datapath = m.instance("judge", module);
        let reach_valid = m.reg_reset("reach_valid", 1, 0);
        m.next(reach_valid, valid);
        let reach = reach.register(m, "reach_", bit(true));
        m.connect(datapath, "in_valid", reach_valid);
        reach.connect(m, datapath, "in_");
        m.connect(datapath, "far_scale", settings.get("far_scale"));
        let out = m.stream_from(datapath, "out");
        m.ready(&out, bit(true));
        let entry = out.field("entry");
        m.write(self.memory, out.valid, entry, Record::from(&out).only(&self.fields).pack());
        Ok((Chosen { valid: out.valid, entry }, manifest))
    }
}
