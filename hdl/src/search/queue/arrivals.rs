//! Beats that wait, in two places: whether one is taken is known late in a cycle, and moves few bits.

use pointcore_contract::record;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Candidates, Thread};

use super::tokens::near_lanes;
use crate::search::parts::head_queue::HeadQueue;
use crate::units::wires::{Bundle, Registers, Wires};
use rtl::{Expr, Module, Reg, bit};

/// A beat on its way.
#[record(config: Config)]
pub(super) struct Arrival {
    /// The beat.
    pub candidates: Candidates,
    /// The squared radius of its thread's last leaf as it came in.
    #[bits(config.square_bits())]
    pub limit: u32,
}

/// Whose beat it is.
#[record(config: Config)]
pub(super) struct Caller {
    /// Its thread.
    pub thread: Thread,
    /// It is of the thread of the beat before it. All are of a thread that is alone, which reads its row for its first one anyway.
    #[when(config.threads > 1)]
    pub follows: bool,
    /// It is of the thread of the beat before that one.
    #[when(config.threads > 1)]
    pub follows_second: bool,
}

impl Caller<Wires> {
    /// Of a beat that comes in where `comes` is set. Of which threads those before it were is compared here, for behind the queue it
    /// is asked late in a cycle.
    fn new(m: &mut Module, config: &Config, comes: Expr, thread: Expr) -> Self {
        if config.threads == 1 {
            return Self { thread: Thread { thread }, ..Self::zeros(config) };
        }
        let mut before = (bit(true), thread);
        let [follows, follows_second] = ["last", "second_last"].map(|name| {
            let is_known = m.reg_reset(&format!("{name}_known"), 1, 0);
            let its_thread = m.reg(&format!("{name}_thread"), config.thread_bits());
            m.next_if(is_known, comes, before.0);
            m.next_if(its_thread, comes, before.1);
            before = (is_known.expr(), its_thread.expr());
            is_known & its_thread.eq(thread)
        });
        Self { thread: Thread { thread }, follows, follows_second }
    }
}

/// The queue.
pub(super) struct Arrivals {
    /// Whose beats wait.
    pub callers: HeadQueue<Caller<Wires>>,
    /// The beats themselves, in registers.
    places: [Registers<Arrival<Wires>>; 2],
    /// The head is in the first place: the inverse of the callers' address, for a beat is hundreds of bits.
    reads_first: Reg,
}

impl Arrivals {
    /// An empty queue.
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let places = ["first", "second"].map(|place| Registers::new(m, config, &format!("{place}_")));
        let callers = HeadQueue::new(m, config, "callers", places.len() as u32);
        Self { callers, places, reads_first: m.reg_reset("reads_first", 1, 1) }
    }

    /// The first beat.
    pub fn head(&self, config: &Config) -> Candidates<Wires> {
        let [first, second] = self.places.each_ref().map(|place| place.candidates);
        Candidates::choose(config, self.reads_first, first, second)
    }

    /// The lanes of the head that are nearer than its limit and, where that counts, than what is farthest: of both beats all are
    /// compared.
    pub fn near_lanes(&self, config: &Config, farthest: Option<(Expr, Expr)>) -> Expr {
        let [first, second] = self.places.each_ref().map(|place| {
            let Arrival { candidates, limit } = **place;
            near_lanes(config, &candidates, std::iter::once((bit(true), limit)).chain(farthest))
        });
        self.callers.read_address.mux(second, first)
    }

    /// Pushes a beat where `push` is set, which implies room, and takes out the head where `pop` is; to be called once.
    pub fn update(&self, m: &mut Module, config: &Config, push: Expr, arrival: Arrival<Wires>, pop: Expr) {
        let caller = Caller::new(m, config, push, arrival.candidates.place.thread.thread);
        let second = self.callers.write_address.expr();
        self.places[0].next_if(m, config, push & !second, arrival);
        self.places[1].next_if(m, config, push & second, arrival);
        self.callers.update(m, config, push, caller, pop);
        m.next_if(self.reads_first, pop, !self.reads_first);
        m.assert("callers_go_with_their_beats", self.reads_first ^ self.callers.read_address);
    }
}
