//! Coherence check (thesis 6.5.3): compares each query with one entry a cycle, and answers it or has it searched for.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::cover::{Covers, cover_fields};
use super::deliver::Answer;
use super::lru::{Chosen, Entries, VERSION_BITS};
use super::tickets::Tickets;
use crate::compiler::{CompileError, Datapath, Manifest, Options, Program, Value, compile};
use crate::search::parts::head_queue::HeadQueue;
use crate::units::datapath::{Inputs, dot, uniform};
use crate::units::records::{Record, event_out, queue_in, queue_out};
use rtl::{Expr, Module, Stream, lit};

/// Queries whose comparisons may be under way.
const CHECKS: u32 = 8;

/// A query's comparison with one entry: which it is, whether it is the query's last, and the entry's state as it was read.
fn item_fields(config: &Config) -> Vec<Field> {
    let fields = [("entry", config.entry_bits()), ("last", 1), ("present", 1), ("version", VERSION_BITS)];
    fields.map(|(name, width)| (name.to_owned(), width)).to_vec()
}

/// What of an item is judged.
fn judged_fields(config: &Config) -> Vec<Field> {
    item_fields(config).into_iter().filter(|(name, _)| ["entry", "last"].contains(&name.as_str())).collect()
}

/// What of a query the comparison needs.
fn ball_fields(config: &Config) -> Vec<Field> {
    ["x", "y", "z", "reach"].map(|name| (name.to_owned(), config.geometry.width())).to_vec()
}

/// Whether a query's ball lies within what an entry's neighborhood covers (thesis eq. 6.5, 6.6 and table 6.1).
fn comparison(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_check", "Whether a neighborhood covers a query.");
    let mut fields = item_fields(config);
    fields.extend(ball_fields(config));
    fields.extend(cover_fields(config).into_iter().map(|(name, width)| (format!("entry_{name}"), width)));
    let item = Inputs::new(&program, &fields);
    let float = |name: &str| item.float(config.geometry, name);
    let offset: [Value; 3] = ["x", "y", "z"].map(|axis| float(axis) - float(&format!("entry_{axis}")));
    let (cover, reach) = (float("entry_c"), float("reach"));
    let margin = (cover - reach) * uniform(&program, config.geometry, "margin_scale");
    let covered = reach.lt(cover) & dot(&offset, &offset).lt(margin * margin);
    for (name, _) in item_fields(config) {
        program.output(&name, item.bits(&name));
    }
    program.output("covered", covered);
    compile(&program, options)
}

/// What a query may be answered from or searched with.
pub(super) struct Resources<'a> {
    pub entries: &'a Entries,
    pub covers: &'a Covers,
    pub tickets: &'a Tickets,
    pub settings: &'a Record,
    /// The entry that a neighborhood is copied to.
    pub copied: &'a Chosen,
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
    pub query: Record,
    pub manifest: Manifest,
}

/// The comparisons that enter the datapath: all of one query's, then the next one's. Returns the datapath's output.
struct Comparisons {
    out: Stream,
    enters: Expr,
    /// The queries whose comparisons are under way.
    asked: HeadQueue,
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
        let query = queue_in(m, "query", &records::cached_query(config));
        let Datapath { module, manifest } = comparison(config, options)?;
        let datapath = m.instance("check", module);
        let accepts = m.out(datapath, "in_ready");

        let entry = m.reg_reset("next_entry", config.entry_bits(), 0);
        let first = m.wire("first_entry", entry.is_zero());
        let last = m.wire("last_entry", entry.eq_lit(u128::from(config.neighbor_cache) - 1));
        let issues = m.forward("issues", 1);
        let enters = m.wire("enters", issues & first);
        let asked = HeadQueue::new(m, "asked", CHECKS, &records::query(config));
        asked.update(m, enters, &Record::from(&query), pop);

        let i1_valid = m.reg_reset("i1_valid", 1, 0);
        let advance = m.wire("i_advance", !i1_valid | accepts);
        let admits = m.wire("admits", asked.room & from.tickets.admit());
        m.drive(issues, (query.valid & advance) & (!first | admits));
        m.ready(&query, issues & last);
        m.next_if(entry, issues, last.mux(lit(entry.width(), 0), entry.add_lit(1)));
        m.next_if(i1_valid, advance, issues);
        let item = Record::new(&item_fields(config), |name| match name {
            "entry" => entry.expr(),
            "last" => last,
            "present" => from.entries.is_present(*entry),
            _ => from.entries.version(*entry),
        });
        let item = item.register(m, "i1_", issues);
        let ball = Record::from(&query).only(&ball_fields(config)).register(m, "i1_", issues);
        let cover = from.covers.read(m, *issues, *entry);

        m.connect(datapath, "in_valid", i1_valid);
        item.connect(m, datapath, "in_");
        ball.connect(m, datapath, "in_");
        cover.connect(m, datapath, "in_entry_");
        m.connect(datapath, "margin_scale", from.settings.get("margin_scale"));
        Ok(Self { out: m.stream_from(datapath, "out"), enters, asked, manifest })
    }
}

impl Check {
    /// Judges one comparison a cycle.
    pub fn new(m: &mut Module, config: &Config, options: &Options, from: &Resources<'_>) -> Result<Self, CompileError> {
        let pops = m.forward("asked_pops", 1);
        let Comparisons { out, enters, asked, manifest } = Comparisons::new(m, config, options, from, pops.expr())?;
        let compared = out.field("entry");
        let unchanged = out.field("version").eq(from.entries.version(compared));
        let reusable = (out.field("present") & from.entries.is_present(compared)) & unchanged;
        let matched = m.wire("matched", out.field("covered") & reusable);

        // j: what the entry was when its item was taken is known; what it is now, the copying tells.
        let advance = m.forward("j_advance", 1);
        let valid = m.reg_reset("j_valid", 1, 0);
        let matches = m.reg("j_matches", 1);
        m.next_if(valid, advance, out.valid);
        m.ready(&out, advance);
        let judged = Record::from(&out).only(&judged_fields(config)).register(m, "j_", advance);
        let (entry, last) = (judged.get("entry"), judged.get("last"));
        let given_away = m.wire("j_given_away", from.copied.valid & entry.eq(from.copied.entry));
        let reads = m.wire("j_reads", matches & !given_away);
        m.next(matches, advance.mux(matched, reads));

        let answered = m.reg_reset("answered", 1, 0);
        let open = m.wire("open", valid & !answered);
        let hit = m.wire("hit", open & reads);
        let miss = m.wire("miss", open & (last & !hit));

        let search = queue_out(m, "search", &records::query(config));
        let hits = m.wire("hits", hit & from.room);
        let misses = m.wire("misses", miss & search.room);
        let stays = (hit & !hits) | (miss & !misses);
        let leaves = m.wire("leaves", valid & !stays);
        m.drive(advance, !valid | leaves);
        m.drive(pops, leaves & last);
        m.next(answered, (answered | hits) & !pops);
        m.assert("a_comparison_has_its_query", !valid | asked.holds);
        m.assert("a_hit_is_present", !hits | from.entries.is_present(entry));

        search.push(m, misses, |name| match name {
            "number" => from.tickets.next.zext(config.index_bits),
            field => asked.head.get(field),
        });
        event_out(m, "event_cache_hit", hits);
        event_out(m, "event_cache_miss", misses);
        let hit = Answer { by: Chosen { valid: hits, entry }, number: asked.head.get("number") };
        let answered = pops & !misses;
        Ok(Self { enters, answered, hit, misses, query: asked.head, manifest })
    }
}
