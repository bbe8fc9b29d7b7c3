//! The whole neighbor search: queries in, neighbors out, points behind a memory port; golden twin:
//! `pointcore_golden::core_b::top`.

use std::collections::BTreeMap;

use pointcore_spec::core_a::Field;
use pointcore_spec::core_b::ports::EVENTS;
use pointcore_spec::core_b::{Config, records};

use super::{leaf, queue, recursion, stack, threads, traversal};
use crate::compiler::{CompileError, Manifest, Options};
use crate::rtl::{Instance, Module};
use crate::units::records::{Pulse, Record, pulse_in, stream_in};

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `core_b_top`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// Leads a stream from one unit to the next.
fn pipe(m: &mut Module, (from, out): (&Instance, &str), (to, input): (&Instance, &str)) {
    let stream = m.stream_from(from, out);
    m.stream_into(to, input, &stream);
}

/// A pulse that a unit puts out.
fn pulse_from(m: &mut Module, from: &Instance, name: &str, fields: &[Field]) -> Pulse {
    let valid = m.out(from, &format!("{name}_valid"));
    Pulse { valid, record: Record::new(fields, |field| m.out(from, &format!("{name}_{field}"))) }
}

/// Leads a pulse into a unit.
fn pulse_into(m: &mut Module, to: &Instance, name: &str, pulse: &Pulse) {
    m.connect(to, &format!("{name}_valid"), &pulse.valid);
    pulse.record.connect(m, to, &format!("{name}_"));
}

/// Builds the core.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("core_b_top", "Neighbor search: queries in, nearest neighbors out.");
    let [traversal_unit, leaf_unit] = [traversal::datapath(config, options)?, leaf::datapath(config, options)?];
    let manifests =
        BTreeMap::from([("traversal".to_owned(), traversal_unit.manifest), ("leaf".to_owned(), leaf_unit.manifest)]);
    let threads = m.instance("threads", threads::module(config));
    let traversal = m.instance("traversal", traversal_unit.module);
    let stack = m.instance("stack", stack::module(config));
    let recursion = m.instance("recursion", recursion::module(config));
    let leaf = m.instance("leaf", leaf_unit.module);
    let queue = m.instance("queue", queue::module(config));

    let tree = pulse_in(&mut m, "tree", &records::tree_write(config));
    for unit in [&traversal, &leaf] {
        pulse_into(&mut m, unit, "tree", &tree);
    }
    let query = stream_in(&mut m, "query", &records::query(config));
    m.stream_into(&threads, "query", &query);
    let start = pulse_from(&mut m, &threads, "start", &records::start(config));
    for unit in [&traversal, &recursion, &leaf, &queue] {
        pulse_into(&mut m, unit, "start", &start);
    }

    pipe(&mut m, (&threads, "descend"), (&traversal, "descend"));
    pipe(&mut m, (&threads, "pop"), (&recursion, "in"));
    pipe(&mut m, (&threads, "finish"), (&queue, "finish"));
    pipe(&mut m, (&recursion, "resume"), (&traversal, "resume"));
    pipe(&mut m, (&traversal, "leaf"), (&leaf, "leaf"));
    pipe(&mut m, (&leaf, "candidates"), (&queue, "candidates"));

    let thread_only = records::thread_only(config);
    let path = records::path(config);
    let pushed: Vec<_> = thread_only.iter().chain(&path).cloned().collect();
    let push = pulse_from(&mut m, &traversal, "push", &pushed);
    pulse_into(&mut m, &stack, "push", &push);
    let pop = pulse_from(&mut m, &recursion, "pop", &thread_only);
    pulse_into(&mut m, &stack, "pop", &pop);
    let top_empty = m.out(&stack, "top_empty");
    m.connect(&recursion, "top_empty", &top_empty);
    Record::new(&path, |field| m.out(&stack, &format!("top_{field}"))).connect(&mut m, &recursion, "top_");

    let radius = pulse_from(&mut m, &queue, "radius", &records::radius(config));
    pulse_into(&mut m, &recursion, "radius", &radius);
    let leaf_done = Pulse { valid: radius.valid, record: radius.record.only(&thread_only) };
    pulse_into(&mut m, &threads, "leaf_done", &leaf_done);
    for (unit, name) in [(&traversal, "reached"), (&recursion, "empty"), (&queue, "released")] {
        let pulse = pulse_from(&mut m, unit, name, &thread_only);
        pulse_into(&mut m, &threads, name, &pulse);
    }

    let fetch = m.stream_from(&leaf, "fetch");
    m.stream_export("fetch", &fetch);
    let beat = stream_in(&mut m, "beat", &records::beat(config));
    m.stream_into(&leaf, "beat", &beat);
    let result = m.stream_from(&queue, "result");
    m.stream_export("result", &result);
    for (name, unit) in EVENTS.iter().zip([&traversal, &recursion, &queue, &queue, &queue, &threads]) {
        let event = m.out(unit, name);
        m.output(name, &event);
    }
    Ok(Core { module: m, manifests })
}
