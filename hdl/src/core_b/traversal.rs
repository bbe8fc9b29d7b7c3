//! Node traversal (thesis 6.5.2, listing 6.2): descends from a node to a leaf and stacks the paths not taken; golden
//! twin: `pointcore_golden::core_b::traversal`.
//!
//! Tokens go round through three stages: `t0` presents addresses, `t1` has node and coordinates, `t2` has the decision. With
//! a tree cache, that is in the place of `t0`.

use pointcore_spec::core_a::Field;
use pointcore_spec::core_b::{Config, records};

use super::coordinates::coordinates;
use super::nodes::{Nodes, Place, Token};
use crate::compiler::{CompileError, Datapath, Options, Program, compile};
use crate::float::compare;
use crate::rtl::{Expr, Module, cat, select};
use crate::units::datapath::Inputs;
use crate::units::records::{Record, event_out, pulse_in, pulse_out, queue_in, queue_out, registered_pulse_out};

/// What `t2` sends on: a leaf, or a path not taken with what its distance follows from.
fn steps(config: &Config) -> Vec<Field> {
    let mut fields = vec![("is_leaf".to_owned(), 1)];
    fields.extend(records::descent(config));
    fields.extend(["coordinate", "split"].map(|name| (name.to_owned(), config.geometry.width())));
    fields
}

/// The squared distance from the query to the splitting plane.
fn distance(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("core_b_path", "Squared distance of a query to a splitting plane.");
    let step = Inputs::new(&program, &steps(config));
    let [coordinate, split] = ["coordinate", "split"].map(|name| step.float(config.geometry, name));
    let distance = coordinate - split;
    for name in ["is_leaf", "thread", "node"] {
        program.output(name, &step.bits(name));
    }
    program.output("distance2", &(&distance * &distance));
    compile(&program, options)
}

/// The number of the first deepest leaf below a node (eq. 6.7): its address shifted up until the leading one is on top,
/// without it.
fn leaf_number(node: &Expr) -> Expr {
    let depth = node.width() - 1;
    let steps = (0..=depth.ilog2()).rev().map(|exponent| 1_usize << exponent);
    let shifted = steps.fold(node.clone(), |node, step| {
        let zeros = node.bits(depth, depth + 1 - step).is_zero();
        zeros.mux(&node.shl(step), &node)
    });
    shifted.trunc(depth)
}

/// A value of `t1` as it is in `t2`.
fn later(m: &mut Module, name: &str, advance: &Expr, value: &Expr) -> Expr {
    let register = m.reg(name, value.width());
    m.next_if(&register, advance, value);
    register.expr()
}

/// The unit; ports as in `spec::core_b::ports::traversal`.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let tree_depth = config.tree_depth as usize;
    let mut m = Module::new("core_b_traversal", "Descends to leaves and stacks the paths not taken.");
    m.parameter("threads", config.threads);
    m.parameter("tree_depth", tree_depth);
    let start = pulse_in(&mut m, "start", &records::start(config));
    let descend = queue_in(&mut m, "descend", &records::descent(config));
    let resume = queue_in(&mut m, "resume", &records::descent(config));
    let Datapath { module, manifest } = distance(config, options)?;
    let path = m.instance("path", module);
    let nodes = Nodes::new(&mut m, config);
    let accepts = m.out(&path, "in_ready");
    let room = nodes.room();
    let advance = m.wire("advance", &(accepts & &room));
    let [t1, t2] = ["t1", "t2"].map(|stage| Token::new(&mut m, config, stage));

    // t0 → t1: node and query are read.
    let (entering, node) = nodes.read(&mut m, config, &advance);
    t1.take(&mut m, &advance, &entering);
    let [x, y, z] = coordinates(&mut m, config, &start, &advance, &entering.thread);

    // t1 → t2: the decision.
    t2.take(&mut m, &advance, &t1.place());
    let at_leaf = later(&mut m, "t2_at_leaf", &advance, &(t1.node.msb() | node.get("internal_leaf")));
    let coordinate = m.wire("coordinate", &select(&node.get("dimension"), &[&x, &y, &z]));
    let less = m.instance("less", compare::lt(config.geometry, 1).module);
    m.connect(&less, "enable", &advance);
    m.connect(&less, "a", &coordinate);
    m.connect(&less, "b", &node.get("split"));
    let left = m.out(&less, "y");
    let coordinate = later(&mut m, "t2_coordinate", &advance, &coordinate);
    let split = later(&mut m, "t2_split", &advance, &node.get("split"));

    // t2: the far child or the leaf goes into the path datapath, the near child round.
    let above = t2.node.trunc(tree_depth);
    let descends = m.wire("descends", &(&t2.valid & !&at_leaf));
    let near = cat(&[&above, &!&left]);
    let far = cat(&[&above, &left]);
    let number = leaf_number(&t2.node).zext(config.node_bits() as usize);
    let step = Record::new(&steps(config), |name| match name {
        "is_leaf" => at_leaf.clone(),
        "thread" => t2.thread.expr(),
        "node" => at_leaf.mux(&number, &far),
        "coordinate" => coordinate.clone(),
        _ => split.clone(),
    });
    m.connect(&path, "in_valid", &(&t2.valid & room));
    step.connect(&mut m, &path, "in_");

    let resumes = m.wire("resumes", &(&resume.valid & !&descends));
    let newcomer = |name: &str| resume.valid.mux(&resume.field(name), &descend.field(name));
    let enters = &descends | (&resume.valid | &descend.valid);
    let next = Place {
        valid: enters,
        thread: descends.mux(&t2.thread, &newcomer("thread")),
        node: descends.mux(&near, &newcomer("node")),
    };
    nodes.take(&mut m, &advance, &next);
    m.ready(&resume, &(&advance & !&descends));
    m.ready(&descend, &(&advance & !(&descends | resumes)));

    // Pushes are always taken, leaves when there is room.
    let out = m.stream_from(&path, "out");
    let is_leaf = out.field("is_leaf");
    let pushed = Record::from(&out);
    let mut push_fields = records::thread_only(config);
    push_fields.extend(records::path(config));
    pulse_out(&mut m, "push", &(&out.valid & !&is_leaf), &pushed.only(&push_fields));
    let leaf = queue_out(&mut m, "leaf", &records::leaf(config));
    let reaches = m.wire("reaches", &((&out.valid & &is_leaf) & &leaf.room));
    m.ready(&out, &(!&is_leaf | &leaf.room));
    leaf.push(&mut m, &reaches, |name| match name {
        "leaf" => out.field("node").trunc(tree_depth),
        field => out.field(field),
    });
    registered_pulse_out(&mut m, "reached", &reaches, &pushed.only(&records::thread_only(config)));
    event_out(&mut m, "event_node", &(&advance & &t2.valid));
    Ok(Datapath { module: m, manifest })
}
