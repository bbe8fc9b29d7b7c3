//! A rust-hdl design with a generated core in it: the neighbor search, with its points in rust-hdl's ROMs beside it.
//!
//! `build.rs` generates the core's Verilog and [`search_top::SearchTop`], the rust-hdl block that stands for it. What
//! answers its requests for points is rust-hdl: three ROMs and four registers, wired with signals.

pub mod config;

use rust_hdl::prelude::*;

use search_top::SearchTop;

/// The generated core.
pub mod search_top {
    include!(concat!(env!("OUT_DIR"), "/search_top.rs"));
}

/// Bits of a place in the ROMs.
pub const PLACE_BITS: usize = 9;

/// The search core and its points: the host writes the tree, sends queries and takes results.
#[derive(LogicBlock)]
pub struct SearchInRom {
    /// Clock of everything.
    pub clk: Signal<In, Clock>,
    /// Synchronous reset, active high.
    pub rst: Signal<In, Bit>,
    /// A write to the tree.
    pub tree_valid: Signal<In, Bit>,
    /// It is one of a leaf.
    pub tree_is_leaf: Signal<In, Bit>,
    /// Leaf or node.
    pub tree_address: Signal<In, Bits<5>>,
    /// Where a node's plane is.
    pub tree_split: Signal<In, Bits<24>>,
    /// Which dimension the plane divides.
    pub tree_dimension: Signal<In, Bits<2>>,
    /// The node is a leaf.
    pub tree_internal_leaf: Signal<In, Bit>,
    /// A leaf's first point.
    pub tree_begin: Signal<In, Bits<16>>,
    /// A leaf's number of points.
    pub tree_beats: Signal<In, Bits<4>>,
    /// A query is there.
    pub query_valid: Signal<In, Bit>,
    /// It is taken.
    pub query_ready: Signal<Out, Bit>,
    /// What its results are called.
    pub query_number: Signal<In, Bits<16>>,
    /// How many neighbors it asks for.
    pub query_k: Signal<In, Bits<4>>,
    /// Square of the distance within which they lie.
    pub query_radius2: Signal<In, Bits<24>>,
    /// Where they are to be near.
    pub query_x: Signal<In, Bits<24>>,
    /// Where they are to be near.
    pub query_y: Signal<In, Bits<24>>,
    /// Where they are to be near.
    pub query_z: Signal<In, Bits<24>>,
    /// A result is there.
    pub result_valid: Signal<Out, Bit>,
    /// It is taken.
    pub result_ready: Signal<In, Bit>,
    /// The query's number.
    pub result_number: Signal<Out, Bits<16>>,
    /// It is the query's last.
    pub result_last: Signal<Out, Bit>,
    /// It is a neighbor.
    pub result_found: Signal<Out, Bit>,
    /// The neighbor's place in the ROMs.
    pub result_index: Signal<Out, Bits<16>>,
    /// Square of the neighbor's distance.
    pub result_distance2: Signal<Out, Bits<24>>,
    core: SearchTop,
    x: ROM<Bits<24>, PLACE_BITS>,
    y: ROM<Bits<24>, PLACE_BITS>,
    z: ROM<Bits<24>, PLACE_BITS>,
    busy: DFF<Bit>,
    thread: DFF<Bits<2>>,
    place: DFF<Bits<16>>,
    left: DFF<Bits<4>>,
}

impl SearchInRom {
    /// A search among points whose coordinates are encoded in the core's format, connected.
    #[must_use]
    pub fn new(points: &[[u32; 3]]) -> Self {
        let axis = |axis: usize| ROM::from(points.iter().map(move |point| Bits::<24>::from(u64::from(point[axis]))));
        let mut block = Self {
            clk: Signal::default(),
            rst: Signal::default(),
            tree_valid: Signal::default(),
            tree_is_leaf: Signal::default(),
            tree_address: Signal::default(),
            tree_split: Signal::default(),
            tree_dimension: Signal::default(),
            tree_internal_leaf: Signal::default(),
            tree_begin: Signal::default(),
            tree_beats: Signal::default(),
            query_valid: Signal::default(),
            query_ready: Signal::default(),
            query_number: Signal::default(),
            query_k: Signal::default(),
            query_radius2: Signal::default(),
            query_x: Signal::default(),
            query_y: Signal::default(),
            query_z: Signal::default(),
            result_valid: Signal::default(),
            result_ready: Signal::default(),
            result_number: Signal::default(),
            result_last: Signal::default(),
            result_found: Signal::default(),
            result_index: Signal::default(),
            result_distance2: Signal::default(),
            core: SearchTop::default(),
            x: axis(0),
            y: axis(1),
            z: axis(2),
            busy: DFF::default(),
            thread: DFF::default(),
            place: DFF::default(),
            left: DFF::default(),
        };
        block.connect_all();
        block
    }
}

impl Logic for SearchInRom {
    #[hdl_gen]
    fn update(&mut self) {
        self.core.clk.next = self.clk.val();
        self.core.rst.next = self.rst.val();

        self.core.tree_valid.next = self.tree_valid.val();
        self.core.tree_is_leaf.next = self.tree_is_leaf.val();
        self.core.tree_address.next = self.tree_address.val();
        self.core.tree_split.next = self.tree_split.val();
        self.core.tree_dimension.next = self.tree_dimension.val();
        self.core.tree_internal_leaf.next = self.tree_internal_leaf.val();
        self.core.tree_begin.next = self.tree_begin.val();
        self.core.tree_beats.next = self.tree_beats.val();

        self.core.query_valid.next = self.query_valid.val();
        self.query_ready.next = self.core.query_ready.val();
        self.core.query_number.next = self.query_number.val();
        self.core.query_k.next = self.query_k.val();
        self.core.query_radius2.next = self.query_radius2.val();
        self.core.query_x.next = self.query_x.val();
        self.core.query_y.next = self.query_y.val();
        self.core.query_z.next = self.query_z.val();

        self.result_valid.next = self.core.result_valid.val();
        self.core.result_ready.next = self.result_ready.val();
        self.result_number.next = self.core.result_number.val();
        self.result_last.next = self.core.result_last.val();
        self.result_found.next = self.core.result_found.val();
        self.result_index.next = self.core.result_index.val();
        self.result_distance2.next = self.core.result_distance2.val();

        // A request for points is answered from the ROMs, a point a cycle, before the next one is taken.
        dff_setup!(self, clk, busy, thread, place, left);
        self.core.fetch_ready.next = !self.busy.q.val();
        if self.core.fetch_valid.val() & !self.busy.q.val() {
            self.busy.d.next = true;
            self.thread.d.next = self.core.fetch_thread.val();
            self.place.d.next = self.core.fetch_address.val();
            self.left.d.next = self.core.fetch_beats.val();
        }
        self.x.address.next = self.place.q.val().get_bits::<PLACE_BITS>(0);
        self.y.address.next = self.place.q.val().get_bits::<PLACE_BITS>(0);
        self.z.address.next = self.place.q.val().get_bits::<PLACE_BITS>(0);
        self.core.beat_valid.next = self.busy.q.val();
        self.core.beat_thread.next = self.thread.q.val();
        self.core.beat_address.next = self.place.q.val();
        self.core.beat_last.next = self.left.q.val() == 1;
        self.core.beat_x0.next = self.x.data.val();
        self.core.beat_y0.next = self.y.data.val();
        self.core.beat_z0.next = self.z.data.val();
        if self.busy.q.val() & self.core.beat_ready.val() {
            self.place.d.next = self.place.q.val() + 1;
            self.left.d.next = self.left.q.val() - 1;
            self.busy.d.next = self.left.q.val() != 1;
        }
        if self.rst.val() {
            self.busy.d.next = false;
        }
    }
}
