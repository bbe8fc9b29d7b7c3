//! Node traversal (thesis 6.5.2, listing 6.2): descends from a node to a leaf and stacks the paths not taken; golden
//! twin: `pointcore_golden::search::traversal`.
//!
//! Tokens go round through two stages: in `f` the memories show a node and its sibling, in `v` a node is visited. Which of two
//! children is the near one is known when they are there already, in `s`. With a tree cache, nodes go through it on their way
//! from `f` to `v`.

mod nodes;

use pointcore_contract::record;
use pointcore_contract::search::Config;
use pointcore_contract::search::config::DIMENSION_BITS;
use pointcore_contract::search::records::{AXES, Descent, LeafVisit, Path, Push};
use pointcore_contract::search::units::traversal::PORTS;

use super::parts::coordinates::coordinates;
use crate::compiler::{CompileError, Datapath, Options, Program, compile};
use crate::float::compare;
use crate::float::parts::shift::leading_zeros;
use crate::units::operator::Placed;
use crate::units::passage::Passage;
use crate::units::ports::{PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, held};
use crate::units::values::{Terms, Values};
use crate::units::wires::Bundle;
use nodes::{Fetched, Nodes, Place, Token};
use rtl::{Expr, Module, bit, cat};

/// What `s` sends through the path datapath.
#[record(config: Config)]
struct Step {
    /// A leaf is reached.
    is_leaf: bool,
    /// Else the path not taken.
    descent: Descent,
    /// The query's coordinate in the dimension that the plane cuts.
    #[bits(config.geometry.width())]
    coordinate: u32,
    /// Where the plane cuts it.
    #[bits(config.geometry.width())]
    split: u32,
}

/// What becomes of it.
#[record(config: Config)]
struct Passed {
    /// A leaf is reached.
    is_leaf: bool,
    /// Else the path not taken.
    push: Push,
}

/// The squared distance from the query to the splitting plane.
fn distance(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("search_path", "Squared distance of a query to a splitting plane.");
    let Step { is_leaf, descent, coordinate, split } = Step::<Values>::inputs(&program, config);
    let [coordinate, split] = [coordinate, split].map(|value| value.as_float(config.geometry));
    let distance = (coordinate - split).named("distance");
    let path = Path { node: descent.node, distance2: (distance * distance).bits(config.square_bits() - 1, 0) };
    Passed { is_leaf, push: Push { thread: descent.thread, path } }.outputs(&program, config);
    compile(&program, &options.taken_at_once())
}

/// How far a node's leading one is from the top. The lowest bit, which is known last, is only looked at in the root, where it is one.
fn leading_places(node: Expr) -> Expr {
    leading_zeros(cat([node.bits(node.width() - 1, 1), bit(true)]))
}

/// The number of the first deepest leaf below a node (eq. 6.7): its address shifted up until the leading one is on top,
/// without it.
fn leaf_number(node: Expr, places: Expr) -> Expr {
    node.shl_by(places).trunc(node.width() - 1)
}

/// On which side of a plane a query is: each coordinate is compared with each split, before it is known which of them count. In one
/// cycle there is no time to choose and to compare.
struct Sides(Vec<[Placed; 3]>);

impl Sides {
    /// For the splits of even and odd nodes, or for one.
    fn new(m: &mut Module, config: &Config) -> Self {
        let kinds: &[&str] = if config.tree_cache > 0 { &[""] } else { &["_even", "_odd"] };
        let module = compare::lt(config.geometry, 1).module;
        let mut less = |axis, kind| Placed::new(m, &format!("less_{axis}{kind}"), module.clone());
        Self(kinds.iter().map(|kind| AXES.map(|axis| less(axis, kind))).collect())
    }

    /// Whether it is on the left, in the cycle after.
    fn left(&self, m: &mut Module, dimension: Expr, is_odd: Expr) -> Expr {
        let of_each: Vec<Expr> = self.0.iter().map(|less| dimension.pick(less.map(|less| less.result(m)))).collect();
        m.wire("left", if let [even, odd] = of_each[..] { is_odd.mux(odd, even) } else { of_each[0] })
    }

    /// Compares a query's coordinates.
    fn feed(self, m: &mut Module, enable: Expr, point: [Expr; 3], splits: &[Expr]) {
        for (less, split) in self.0.into_iter().zip(splits) {
            less.into_iter().zip(point).for_each(|(less, coordinate)| less.feed(m, enable, [coordinate, *split]));
        }
    }
}

/// What leaves the datapath is always taken: a path not taken, or a leaf that is reached.
fn show(m: &mut Module, config: &Config, path: &Passage<Step, Passed>) {
    let out = path.out(m, config);
    m.drive(out.ready, bit(true));
    let Passed { is_leaf, push } = out.record;
    PORTS.push.drive(m, config, out.valid & !is_leaf, push);
    PORTS.reached.drive(m, config, out.valid & is_leaf, push.thread);
}

/// The unit.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let tree_depth = config.tree_depth;
    let coordinate_bits = config.geometry.width();
    let mut m = Module::new("search_traversal", "Descends to leaves and stacks the paths not taken.");
    m.parameter("threads", config.threads);
    m.parameter("tree_depth", tree_depth);
    let start = PORTS.start.declare(&mut m, config);
    let descend = PORTS.descend.queue(&mut m, config);
    let resume = PORTS.resume.queue(&mut m, config);
    let leaf = PORTS.leaf.queue(&mut m, config);
    let Datapath { module, manifest } = distance(config, options)?;
    let path = Passage::<Step, Passed>::place(&mut m, "path", module);
    let nodes = Nodes::new(&mut m, config);
    let [f, v, s] = ["f", "v", "s"].map(|stage| Token::new(&mut m, config, stage));
    let [f_is_child, s_at_leaf] = ["f_is_child", "s_at_leaf"].map(|name| m.reg(name, 1));
    let [s_coordinate, s_split] = ["s_coordinate", "s_split"].map(|name| m.reg(name, coordinate_bits));
    let s_dimension = m.reg("s_dimension", DIMENSION_BITS);
    let sides = Sides::new(&mut m, config);
    let left = sides.left(&mut m, *s_dimension, s.descent.node.bit(0));

    let accepts = path.room(&mut m);
    let advance = m.forward("advance", 1);

    // f → v: a child's lowest bit says on which side of its parent's plane the query is.
    let low = f_is_child.mux(!left, f.descent.node.bit(0));
    let node = cat([f.descent.node.bits(tree_depth, 1), low]);
    let wanted = Place { valid: f.valid.expr(), descent: Descent { thread: f.descent.thread, node } };
    let next_node = m.forward("next_node", tree_depth + 1);
    let nodes_room = nodes.room();
    let Fetched { entering, node, splits } = nodes.fetch(&mut m, config, *advance, *next_node, (wanted, &v));
    v.take(&mut m, config, *advance, &entering);
    let v_places = held(&mut m, "v_places", *advance, leading_places(entering.descent.node));
    let point = coordinates(&mut m, config, start, *advance, entering.descent.thread.thread);

    // v: a leaf goes out, the children of another node are fetched, else a newcomer.
    let Descent { thread: v_thread, node: v_node } = *v.descent;
    let at_leaf = m.wire("at_leaf", v_node.msb() | node.internal_leaf);
    let reaches = m.wire("reaches", v.valid & at_leaf);
    let proceeds = m.wire("proceeds", nodes_room & (!reaches | leaf.room));
    m.drive(advance, accepts & proceeds);
    leaf.push(&mut m, config, advance & reaches, LeafVisit { thread: v_thread, leaf: leaf_number(v_node, v_places) });
    PORTS.event_node.event(&mut m, advance & v.valid);
    let descends = m.wire("descends", v.valid & !at_leaf);
    let resumes = m.wire("resumes", resume.valid & !descends);
    let newcomer = Descent::choose(config, resume.valid, resume.record, descend.record);
    let child = Descent { thread: v_thread, node: cat([v_node.trunc(tree_depth), bit(false)]) };
    let next = Descent::choose(config, descends, child, newcomer);
    m.drive(next_node, next.node);
    let descent = Descent { thread: next.thread, node: next_node.expr() };
    f.take(&mut m, config, *advance, &Place { valid: descends | (resume.valid | descend.valid), descent });
    m.next_if(f_is_child, advance, descends);
    m.drive(resume.ready, advance & !descends);
    m.drive(descend.ready, advance & !(descends | resumes));

    // v → s: the decision.
    s.take(&mut m, config, *advance, &v.place());
    m.next_if(s_at_leaf, advance, at_leaf);
    let coordinate = m.wire("coordinate", node.dimension.pick(point));
    m.next_if(s_coordinate, advance, coordinate);
    m.next_if(s_split, advance, node.split);
    m.next_if(s_dimension, advance, node.dimension);
    sides.feed(&mut m, *advance, point, &splits);

    // s: the far child, or that the leaf is reached, goes through the path datapath.
    let far = cat([s.descent.node.trunc(tree_depth), left]);
    let (is_leaf, descent) = (s_at_leaf.expr(), Descent { thread: s.descent.thread, node: far });
    let step = Step { is_leaf, descent, coordinate: s_coordinate.expr(), split: s_split.expr() };
    path.push(&mut m, config, s.valid & proceeds, step);

    show(&mut m, config, &path);
    Ok(Datapath { module: m, manifest })
}
