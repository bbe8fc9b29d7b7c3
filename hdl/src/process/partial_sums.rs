//! Banks of partial sums (thesis 6.5.4): those of one query wait or leave while the next queries' are added.
//!
//! They lie in look-up tables, those of even numbers and those of odd ones apart: one of each leaves in a cycle.

use pointcore_contract::process::config::WORDS_MAX;
use pointcore_contract::process::records::{Sums, Thread};
use pointcore_contract::process::units::kernel::PORTS;
use pointcore_contract::process::{Config, PARTIAL_SUMS};
use pointcore_contract::{record, width};

use crate::search::parts::sets::{contains, decode};
use crate::units::ports::StreamOutPorts;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Memory, Module, Reg, cat, lit};

/// Banks. A bank is held while its query's neighbors come, while the adders take the last one in, and while the sums
/// leave: for queries of eight neighbors three times as long as they take to come.
pub(super) const BANKS: u32 = 4;

/// Bits of the number of a bank.
pub(super) const BANK_BITS: u32 = BANKS.ilog2();

/// Bits of the number of a partial sum.
pub(super) const PARTIAL_BITS: u32 = PARTIAL_SUMS.ilog2();

/// Bits of the number of a pair of partial sums.
const PAIR_BITS: u32 = PARTIAL_BITS - 1;

/// What the block gives.
#[record(config: Config)]
pub(super) struct Addends {
    /// For each word of the sums.
    #[count(config.program.sums.len())]
    #[name(format!("sum_{}", config.program.sums.words()[i].name))]
    #[bits(config.word_bits(config.program.sums.words()[i].ty))]
    pub words: [u32; WORDS_MAX],
}

/// A partial sum's place, and what comes of it.
#[record(config: Config)]
pub(super) struct Place {
    /// The bank.
    #[bits(BANK_BITS)]
    pub bank: u8,
    /// The partial sum.
    #[bits(PARTIAL_BITS)]
    pub partial: u8,
    /// It is to stay as it is.
    pub none: bool,
    /// The query's last one.
    pub last: bool,
}

/// The banks.
pub(super) struct Banks {
    /// Partial sums of even numbers, and of odd ones.
    words: [Memory; 2],
    /// By bank: it belongs to a query, and all of it is there.
    pub taken: Reg,
    complete: Reg,
    /// By bank: its query, and how many of its partial sums there are.
    threads: Vec<Reg>,
    present: Vec<Reg>,
}

/// Where a pair of partial sums lies.
fn address(bank: Expr, partial: Expr) -> Expr {
    cat([bank, partial.bits(PARTIAL_BITS - 1, 1)])
}

impl Banks {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        let [taken, complete] = ["taken", "complete"].map(|name| m.reg_reset(name, BANKS, 0));
        let words = ["even_sums", "odd_sums"]
            .map(|name| m.memory_distributed(name, BANKS * PARTIAL_SUMS as u32 / 2, width::<Addends>(config)));
        let mut by_bank = |name: &str, bits| (0..BANKS).map(|bank| m.reg(&format!("{name}_{bank}"), bits)).collect();
        let threads = by_bank("thread", config.thread_bits());
        Self { words, taken, complete, threads, present: by_bank("present", PARTIAL_BITS + 1) }
    }

    /// A partial sum so far.
    pub fn former(&self, m: &mut Module, config: &Config, bank: Expr, partial: Expr) -> Addends<Wires> {
        let [even, odd] = [("former_even", self.words[0]), ("former_odd", self.words[1])]
            .map(|(name, words)| m.read_now(words, name, address(bank, partial)));
        Addends::unpack(config, partial.bit(0).mux(odd, even))
    }

    /// A neighbor is added: the bank has so many partial sums of that thread.
    pub fn take(&self, m: &mut Module, adds: Expr, bank: Expr, thread: Expr, present: Expr) {
        for (number, (of_thread, of_bank)) in self.threads.iter().zip(&self.present).enumerate() {
            let is_it = adds & bank.eq_lit(number as u128);
            m.next_if(*of_thread, is_it, thread);
            m.next_if(*of_bank, is_it, present);
        }
    }

    /// Keeps what leaves the adders.
    pub fn write(&self, m: &mut Module, config: &Config, valid: Expr, place: Place<Wires>, addends: Addends<Wires>) {
        let writes = m.wire("writes_sum", valid & !place.none);
        let is_odd = place.partial.bit(0);
        for (words, is_it) in self.words.into_iter().zip([!is_odd, is_odd]) {
            m.write(words, writes & is_it, address(place.bank, place.partial), addends.pack(config));
        }
    }

    /// Takes a pair of partial sums in a cycle to where all of a bank's are shown, one bank after the other. `taken`
    /// and `completed` are the sets of banks that are so from the next cycle on.
    pub fn leave(&self, m: &mut Module, config: &Config, taken: Expr, completed: Expr) {
        let bank = m.reg_reset("leaving", BANK_BITS, 0);
        let pair = m.reg_reset("left", PAIR_BITS, 0);
        let shown = m.reg_reset("shown", 1, 0);
        let leaves = m.wire("leaves", contains(self.complete, bank) & !shown.expr());
        let ends = m.wire("bank_ends", leaves & pair.all());
        m.next_if(pair, leaves, pair.add_lit(1));
        m.next_if(bank, ends, bank.add_lit(1));
        let thread = m.reg("shown_thread", config.thread_bits());
        m.next_if(thread, ends, bank.expr().pick(self.threads.iter().copied()));
        let present = bank.expr().pick(self.present.iter().copied());

        let mut sums = Sums { thread: Thread { thread: thread.expr() }, ..Sums::default() };
        for (parity, name) in ["even", "odd"].into_iter().enumerate() {
            let words = m.read_now(self.words[parity], &format!("leaving_{name}"), cat([bank.expr(), pair.expr()]));
            let partial = cat([pair.expr(), lit(1, parity as u128)]);
            let is_there = m.wire(&format!("{name}_is_there"), partial.zext(PARTIAL_BITS + 1).lt(present));
            let words = Addends::<Wires>::unpack(config, words);
            let words = Addends::choose(config, is_there, words, Addends::zeros(config)).words;
            for (word, described) in config.program.sums.words().iter().enumerate() {
                // The first one comes first and has the longest way.
                let mut next = words[word];
                for place in (parity..PARTIAL_SUMS).step_by(2).rev() {
                    let register = m.reg(&format!("{}_{place}", described.name), next.width());
                    m.next_if(register, leaves, next);
                    next = register.expr();
                    sums.partial[word][place] = next;
                }
            }
        }
        let ready = PORTS.sums.drive(m, config, shown, sums);
        m.next(shown, ends | (shown.expr() & !ready));
        let free = decode(ends, bank, BANKS);
        m.next(self.taken, (self.taken.expr() & !free) | taken);
        m.next(self.complete, (self.complete.expr() & !free) | completed);
    }
}
