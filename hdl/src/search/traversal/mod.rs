//! Node traversal (thesis 6.5.2, listing 6.2): descends from a node to a leaf and stacks the paths not taken; golden
//! twin: `pointcore_golden::search::traversal`.
//!
//! Tokens go round through two stages: in `f` the memories show a node and its sibling, in `v` a node is visited. Which of two
//! children is the near one is known when they are there already, in `s`. With a tree cache, nodes go through it on their way
//! from `f` to `v`.

mod nodes;

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use super::parts::coordinates::{AXES, coordinates};
use crate::compiler::{CompileError, Datapath, Options, Program, compile};
use crate::float::compare;
use crate::units::datapath::Inputs;
use crate::units::records::{Record, event_out, pulse_in, pulse_out, queue_in, queue_out};
use nodes::{Nodes, Place, Token};
use rtl::{Expr, Instance, Module, bit, cat};

/// What `t2` sends through the path datapath: a leaf that is reached, or a path not taken with what its distance follows
/// from.
fn steps(config: &Config) -> Vec<Field> {
    let mut fields = vec![("is_leaf".to_owned(), 1)];
    fields.extend(records::descent(config));
    fields.extend(["coordinate", "split"].map(|name| (name.to_owned(), config.geometry.width())));
    fields
}

/// The squared distance from the query to the splitting plane.
fn distance(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_path", "Squared distance of a query to a splitting plane.");
    let step = Inputs::new(&program, &steps(config));
    let [coordinate, split] = ["coordinate", "split"].map(|name| step.float(config.geometry, name));
    let distance = coordinate - split;
    for name in ["is_leaf", "thread", "node"] {
        program.output(name, step.bits(name));
    }
    program.output("distance2", distance * distance);
    compile(&program, options)
}

/// The number of the first deepest leaf below a node (eq. 6.7): its address shifted up until the leading one is on top,
/// without it.
fn leaf_number(node: Expr) -> Expr {
    let depth = node.width() - 1;
    let steps = (0..=depth.ilog2()).rev().map(|exponent| 1_u32 << exponent);
    let shifted = steps.fold(node, |node, step| {
        let zeros = node.bits(depth, depth + 1 - step).is_zero();
        zeros.mux(node << step, node)
    });
    shifted.trunc(depth)
}

/// What leaves the datapath is always taken: a path not taken, or a leaf that is reached.
fn show(m: &mut Module, config: &Config, path: Instance) {
    let out = m.stream_from(path, "out");
    m.ready(&out, bit(true));
    let (is_leaf, passed) = (out.field("is_leaf"), Record::from(&out));
    let thread_only = records::thread_only(config);
    let push_fields = [thread_only.clone(), records::path(config)].concat();
    pulse_out(m, "push", out.valid & !is_leaf, &passed.only(&push_fields));
    pulse_out(m, "reached", out.valid & is_leaf, &passed.only(&thread_only));
}

/// The unit; ports as in `contract::search::ports::traversal`.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let tree_depth = config.tree_depth;
    let coordinate_bits = config.geometry.width();
    let mut m = Module::new("search_traversal", "Descends to leaves and stacks the paths not taken.");
    m.parameter("threads", config.threads);
    m.parameter("tree_depth", tree_depth);
    let start = pulse_in(&mut m, "start", &records::start(config));
    let descend = queue_in(&mut m, "descend", &records::descent(config));
    let resume = queue_in(&mut m, "resume", &records::descent(config));
    let leaf = queue_out(&mut m, "leaf", &records::leaf(config));
    let Datapath { module, manifest } = distance(config, options)?;
    let path = m.instance("path", module);
    let nodes = Nodes::new(&mut m, config);
    let [f, v, s] = ["f", "v", "s"].map(|stage| Token::new(&mut m, config, stage));
    let [f_is_child, s_at_leaf] = ["f_is_child", "s_at_leaf"].map(|name| m.reg(name, 1));
    let [s_coordinate, s_split] = ["s_coordinate", "s_split"].map(|name| m.reg(name, coordinate_bits));
    let less = m.instance("less", compare::lt(config.geometry, 1).module);
    let left = m.out(less, "y");

    let accepts = m.out(path, "in_ready");
    let advance = m.forward("advance", 1);

    // f → v: a child's lowest bit says on which side of its parent's plane the query is.
    let low = f_is_child.mux(!left, f.node.bit(0));
    let node = cat([f.node.bits(tree_depth, 1), low]);
    let wanted = Place { valid: f.valid.expr(), thread: f.thread.expr(), node };
    let next_node = m.forward("next_node", tree_depth + 1);
    let nodes_room = nodes.room();
    let (entering, node) = nodes.fetch(&mut m, config, *advance, *next_node, (wanted, &v));
    v.take(&mut m, *advance, &entering);
    let point = coordinates(&mut m, config, &start, *advance, entering.thread);

    // v: a leaf goes out, the children of another node are fetched, else a newcomer.
    let at_leaf = m.wire("at_leaf", v.node.msb() | node.get("internal_leaf"));
    let reaches = m.wire("reaches", v.valid & at_leaf);
    let proceeds = m.wire("proceeds", nodes_room & (!reaches | leaf.room));
    m.drive(advance, accepts & proceeds);
    leaf.push(&mut m, advance & reaches, |name| if name == "thread" { v.thread.expr() } else { leaf_number(*v.node) });
    event_out(&mut m, "event_node", advance & v.valid);
    let descends = m.wire("descends", v.valid & !at_leaf);
    let resumes = m.wire("resumes", resume.valid & !descends);
    let newcomer = |name: &str| resume.valid.mux(resume.field(name), descend.field(name));
    let child = cat([v.node.trunc(tree_depth), bit(false)]);
    m.drive(next_node, descends.mux(child, newcomer("node")));
    let next = Place {
        valid: descends | (resume.valid | descend.valid),
        thread: descends.mux(v.thread, newcomer("thread")),
        node: next_node.expr(),
    };
    f.take(&mut m, *advance, &next);
    m.next_if(f_is_child, advance, descends);
    m.ready(&resume, advance & !descends);
    m.ready(&descend, advance & !(descends | resumes));

    // v → s: the decision.
    s.take(&mut m, *advance, &v.place());
    m.next_if(s_at_leaf, advance, at_leaf);
    let axes = AXES.map(|axis| point.get(axis));
    let coordinate = m.wire("coordinate", node.get("dimension").pick(axes));
    m.next_if(s_coordinate, advance, coordinate);
    m.next_if(s_split, advance, node.get("split"));
    m.connect(less, "enable", advance);
    m.connect(less, "a", coordinate);
    m.connect(less, "b", node.get("split"));

    // s: the far child, or that the leaf is reached, goes through the path datapath.
    let far = cat([s.node.trunc(tree_depth), left]);
    let step = Record::new(&steps(config), |name| match name {
        "is_leaf" => s_at_leaf.expr(),
        "thread" => s.thread.expr(),
        "node" => far,
        "coordinate" => s_coordinate.expr(),
        _ => s_split.expr(),
    });
    m.connect(path, "in_valid", s.valid & proceeds);
    step.connect(&mut m, path, "in_");

    show(&mut m, config, path);
    Ok(Datapath { module: m, manifest })
}
