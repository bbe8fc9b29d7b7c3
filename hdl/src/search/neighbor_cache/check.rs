//! Coherence check (thesis 6.5.3): compares each query with one entry a cycle, and answers it or has it searched for.

use pointcore_contract::record;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{AXES, CacheSetup, CachedQuery, Query};
use pointcore_contract::search::units::neighbor_cache::PORTS;

use super::cover::{Cover, Covers};
use super::deliver::Answer;
use super::grid::Measured;
use super::lead::{Asked, Finished, Leading};
use super::lru::{Chosen, Entries, VERSION_BITS};
use super::tickets::Tickets;
use crate::compiler::{CompileError, Datapath, Manifest, Options, Program, Value, compile, name};
use crate::search::parts::head_queue::HeadQueue;
use crate::units::datapath::dot;
use crate::units::passage::Passage;
use crate::units::ports::{Flow, OutputPorts, StreamOutPorts};
use crate::units::values::{Terms, Values};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, bit, lit};

/// Queries whose comparisons may be under way.
const CHECKS: u32 = 8;

/// What of a comparison is judged.
#[record(config: Config)]
struct Judged {
    /// The entry.
    #[bits(config.entry_bits())]
    entry: u8,
    /// It is the query's last.
    last: bool,
}

/// A query's comparison with one entry.
#[record(config: Config)]
struct Item {
    /// Which it is.
    judged: Judged,
    /// The entry's neighborhood could be reused as it was read.
    present: bool,
    /// Which neighborhood of the entry's it was.
    #[bits(VERSION_BITS)]
    version: u8,
}

/// What of a query its answer needs.
#[record(config: Config)]
pub(super) struct Searched {
    /// The query.
    pub query: Query,
    /// Whether others wait for its neighborhood.
    pub leading: Leading,
}

/// What of a query the comparison needs.
#[record(config: Config)]
struct Ball {
    /// Where the query is.
    #[name(AXES[i])]
    #[bits(config.geometry.width())]
    point: [u32; 3],
    /// The radius around it within which a neighborhood must be complete.
    #[bits(config.geometry.width())]
    reach: u32,
}

/// What an entry's neighborhood covers, beside the query in one record.
#[record(config: Config)]
struct EntryCover {
    /// Where the query is that the neighborhood was found for.
    #[name(format!("entry_{}", AXES[i]))]
    #[bits(config.geometry.width())]
    point: [u32; 3],
    /// The comparison value.
    #[name("entry_c")]
    #[bits(config.geometry.width())]
    c: u32,
}

impl From<Cover<Wires>> for EntryCover<Wires> {
    fn from(Cover { point, c }: Cover<Wires>) -> Self {
        Self { point, c }
    }
}

/// What is compared.
#[record(config: Config)]
struct Comparison {
    /// Which comparison it is.
    item: Item,
    /// The query.
    ball: Ball,
    /// The entry.
    entry: EntryCover,
}

/// A setting.
#[record(config: Config)]
struct MarginScale {
    /// As in the setup.
    #[bits(config.geometry.width())]
    margin_scale: u32,
}

/// What comes of a comparison.
#[record(config: Config)]
struct Compared {
    /// The comparison.
    item: Item,
    /// How far around its query the entry's neighborhood covers such queries.
    #[bits(config.geometry.width())]
    margin: u32,
    /// The entry's neighborhood, as it was then, covers the query.
    covered: bool,
}

/// Whether a query's ball lies within what an entry's neighborhood covers (thesis eq. 6.5, 6.6 and table 6.1).
fn comparison(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_check", "Whether a neighborhood covers a query.");
    let Comparison { item, ball, entry: EntryCover { point, c } } = Comparison::<Values>::inputs(&program, config);
    let number = |value: Value| value.as_float(config.geometry);
    let offset: [Value; 3] = std::array::from_fn(|axis| number(ball.point[axis]) - number(point[axis]));
    let (cover, reach) = (number(c), number(ball.reach));
    let excess = cover - reach;
    let MarginScale { margin_scale } = MarginScale::<Values>::uniforms(&program, config, config.geometry);
    let margin = excess * margin_scale;
    let [offset_x, offset_y, offset_z] = offset;
    name!(offset_x, offset_y, offset_z, excess, margin);
    let covered = reach.lt(cover) & dot(&offset, &offset).lt(margin * margin);
    Compared { item, margin, covered }.outputs(&program, config);
    compile(&program, options)
}

/// What a query may be answered from or searched with.
pub(super) struct Resources<'a> {
    /// The queries.
    pub asks: Flow<Asked<Wires>>,
    pub entries: &'a Entries,
    pub covers: &'a Covers,
    pub tickets: &'a Tickets,
    pub settings: CacheSetup<Wires>,
    /// The entry that a neighborhood is copied to.
    pub copied: Chosen,
    /// An answer can be pushed in this cycle.
    pub room: Expr,
}

/// What becomes of queries in a cycle.
pub(super) struct Check {
    /// A query enters.
    pub enters: Expr,
    /// A query that was answered leaves.
    pub answered: Expr,
    /// A query is answered.
    pub hit: Answer,
    /// A query is to be searched for.
    pub misses: Expr,
    /// The query of both.
    pub searched: Searched<Wires>,
    /// The query is a leader's, and answered.
    pub finished: Finished,
    /// What a comparison tells of the margins of neighborhoods.
    pub measured: Measured,
    pub manifest: Manifest,
}

/// The comparisons that enter the datapath: all of one query's, then the next one's. Returns the datapath's output.
struct Comparisons {
    out: Flow<Compared<Wires>>,
    enters: Expr,
    /// The queries whose comparisons are under way.
    asked: HeadQueue<Searched<Wires>>,
    manifest: Manifest,
}

impl Comparisons {
    fn new(
        m: &mut Module,
        config: &Config,
        options: &Options,
        from: &Resources<'_>,
        pop: Expr,
    ) -> Result<Self, CompileError> {
        let queries = from.asks;
        let Asked { query: CachedQuery { query, reach }, leading } = queries.record;
        let Datapath { module, manifest } = comparison(config, options)?;
        let datapath = Passage::<Comparison, Compared>::place(m, "check", module);
        let accepts = datapath.room(m);

        let entry = m.reg_reset("next_entry", config.entry_bits(), 0);
        let last_entry = config.neighbor_cache - 1;
        let first = m.reg_reset("first_entry", 1, 1);
        let last = m.reg_reset("last_entry", 1, u64::from(last_entry == 0).into());
        let issues = m.forward("issues", 1);
        let enters = m.wire("enters", issues & first);
        let asked = HeadQueue::new(m, config, "asked", CHECKS);
        asked.update(m, config, enters, Searched { query, leading }, pop);

        let i1_valid = m.reg_reset("i1_valid", 1, 0);
        let advance = m.wire("i_advance", !i1_valid | accepts);
        let admits = m.wire("admits", asked.room & from.tickets.admits);
        m.drive(issues, (queries.valid & advance) & (!first | admits));
        m.drive(queries.ready, issues & last);
        m.next_if(entry, issues, last.mux(lit(entry.width(), 0), entry.add_lit(1)));
        m.next_if(first, issues, last);
        let is_last_but_one = entry.eq_lit(last_entry.saturating_sub(1).into());
        m.next_if(last, issues, if last_entry == 0 { bit(true) } else { is_last_but_one });
        m.next_if(i1_valid, advance, issues);
        let judged = Judged { entry: entry.expr(), last: last.expr() };
        let (present, version) = (from.entries.is_present(*entry), from.entries.version(*entry));
        let item = Item { judged, present, version }.register(m, config, "i1_", issues);
        let ball = Ball { point: query.point, reach }.register(m, config, "i1_", issues);
        let cover = from.covers.read(m, config, *issues, *entry);

        datapath.push(m, config, i1_valid, Comparison { item, ball, entry: cover.into() });
        datapath.set::<MarginScale>(m, config, MarginScale { margin_scale: from.settings.margin_scale });
        Ok(Self { out: datapath.out(m, config), enters, asked, manifest })
    }
}

impl Check {
    /// Judges one comparison a cycle.
    pub fn new(m: &mut Module, config: &Config, options: &Options, from: &Resources<'_>) -> Result<Self, CompileError> {
        let pops = m.forward("asked_pops", 1);
        let Comparisons { out, enters, asked, manifest } = Comparisons::new(m, config, options, from, pops.expr())?;
        let Compared { item, margin, covered } = out.record;
        let compared = item.judged.entry;
        let unchanged = item.version.eq(from.entries.version(compared));
        let reusable = m.wire("reusable", (item.present & from.entries.is_present(compared)) & unchanged);
        let matched = m.wire("matched", covered & reusable);

        // j: what the entry was when its item was taken is known; what it is now, the copying tells.
        let advance = m.forward("j_advance", 1);
        let valid = m.reg_reset("j_valid", 1, 0);
        let matches = m.reg("j_matches", 1);
        m.next_if(valid, advance, out.valid);
        m.drive(out.ready, advance);
        let Judged { entry, last } = item.judged.register(m, config, "j_", advance);
        let given_away = m.wire("j_given_away", from.copied.valid & entry.eq(from.copied.entry));
        let reads = m.wire("j_reads", matches & !given_away);
        m.next(matches, advance.mux(matched, reads));
        let measures = m.reg("j_reusable", 1);
        let measured = m.reg("j_margin", config.geometry.width());
        m.next_if(measures, advance, reusable);
        m.next_if(measured, advance, margin);

        let answered = m.reg_reset("answered", 1, 0);
        let open = m.wire("open", valid & !answered);
        let hit = m.wire("hit", open & reads);
        let miss = m.wire("miss", open & (last & !hit));

        let search = PORTS.search.queue(m, config);
        let hits = m.wire("hits", hit & from.room);
        let misses = m.wire("misses", miss & search.room);
        let stays = (hit & !hits) | (miss & !misses);
        let leaves = m.wire("leaves", valid & !stays);
        m.drive(advance, !valid | leaves);
        m.drive(pops, leaves & last);
        m.next(answered, (answered | hits) & !pops);
        m.assert("a_comparison_has_its_query", !valid | asked.holds);
        m.assert("a_hit_is_present", !hits | from.entries.is_present(entry));

        let searched = asked.head;
        let Searched { query, leading } = searched;
        search.push(m, config, misses, Query { number: from.tickets.next.zext(config.index_bits), ..query });
        PORTS.events.event(m, config, |events| events.hit, hits);
        PORTS.events.event(m, config, |events| events.miss, misses);
        let hit = Answer { by: Chosen { valid: hits, entry }, number: query.number };
        let answered = pops & !misses;
        let finished = Finished::of(hits, leading);
        let measured = Measured { valid: leaves & measures, margin: measured.expr() };
        Ok(Self { enters, answered, hit, misses, searched, finished, measured, manifest })
    }
}
