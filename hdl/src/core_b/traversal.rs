//! Node traversal (thesis 6.5.2, listing 6.2): descends from a node to a leaf and stacks the paths not taken; golden
//! twin: `pointcore_golden::core_b::traversal`.
//!
//! Tokens go round through three stages: `t0` presents addresses, `t1` has node and coordinates, `t2` has the decision.

use pointcore_spec::core_a::Field;
use pointcore_spec::core_b::{Config, records};

use super::coordinates::coordinates;
use crate::compiler::{CompileError, Datapath, Options, Program, compile};
use crate::float::compare;
use crate::rtl::{Expr, Module, Reg, cat, select};
use crate::units::datapath::Inputs;
use crate::units::records::{Record, event_out, pulse_in, pulse_out, queue_in, queue_out, registered_pulse_out, width};

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

/// A token: its thread and node.
struct Token {
    valid: Reg,
    thread: Reg,
    node: Reg,
}

impl Token {
    fn new(m: &mut Module, config: &Config, stage: &str) -> Self {
        Self {
            valid: m.reg_reset(&format!("{stage}_valid"), 1, 0),
            thread: m.reg(&format!("{stage}_thread"), config.thread_bits() as usize),
            node: m.reg(&format!("{stage}_node"), config.node_bits() as usize),
        }
    }

    fn take(&self, m: &mut Module, advance: &Expr, valid: &Expr, thread: &Expr, node: &Expr) {
        m.next_if(&self.valid, advance, valid);
        m.next_if(&self.thread, advance, thread);
        m.next_if(&self.node, advance, node);
    }

    fn follow(&self, m: &mut Module, advance: &Expr, before: &Self) {
        self.take(m, advance, &before.valid, &before.thread, &before.node);
    }
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
    let tree = pulse_in(&mut m, "tree", &records::tree_write(config));
    let start = pulse_in(&mut m, "start", &records::start(config));
    let descend = queue_in(&mut m, "descend", &records::descent(config));
    let resume = queue_in(&mut m, "resume", &records::descent(config));
    let Datapath { module, manifest } = distance(config, options)?;
    let path = m.instance("path", module);
    let advance = m.out(&path, "in_ready");
    let [t0, t1, t2] = ["t0", "t1", "t2"].map(|stage| Token::new(&mut m, config, stage));

    // t0 → t1: node and query are read.
    t1.follow(&mut m, &advance, &t0);
    let is_node_field = |(name, _): &Field| ["split", "dimension", "internal_leaf"].contains(&name.as_str());
    let node_fields: Vec<_> = records::tree_write(config).into_iter().filter(is_node_field).collect();
    let nodes = m.memory("nodes", 1 << tree_depth, width(&node_fields));
    let writes = &tree.valid & !tree.record.get("is_leaf");
    m.write(&nodes, &writes, &tree.record.get("address"), &tree.record.only(&node_fields).pack());
    let node = m.read_if(&nodes, "t1_record", &advance, &t0.node.trunc(tree_depth));
    let node = Record::unpack(&node_fields, &node);
    let [x, y, z] = coordinates(&mut m, config, &start, &advance, &t0.thread);

    // t1 → t2: the decision.
    t2.follow(&mut m, &advance, &t1);
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
    m.connect(&path, "in_valid", &t2.valid);
    step.connect(&mut m, &path, "in_");

    let resumes = m.wire("resumes", &(&resume.valid & !&descends));
    let newcomer = |name: &str| resume.valid.mux(&resume.field(name), &descend.field(name));
    let enters = &descends | (&resume.valid | &descend.valid);
    let thread = descends.mux(&t2.thread, &newcomer("thread"));
    let node = descends.mux(&near, &newcomer("node"));
    t0.take(&mut m, &advance, &enters, &thread, &node);
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
