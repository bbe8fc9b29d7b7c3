//! Runs that are ended before their time.

use super::super::operations::{Channel, Pauses, Refusal};
use super::super::registers::{ABORT, BUSY, DONE, RESET, START};
use super::runs::{ALWAYS, FEW, Host, SETTLE_CYCLES};
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::registers::{CONTROL, ErrorCounter, STATUS};
use pointcore_contract::search::records::CachedQuery;

impl Host<'_> {
    /// Runs that lack nearly all of their queries.
    pub fn run_without_end(&mut self) {
        self.control.script.pauses(Pauses::None);
        let few = FEW.min(self.searches.count());
        for bit in 2..u32::BITS {
            self.expect(0..few);
            self.start(1 << bit);
            (0..few).for_each(|index| self.send(index));
            self.control.script.wait_received(0);
            self.control.script.wait(20);
            self.control.script.read(STATUS, BUSY);
            self.control.script.write(CONTROL, ABORT);
            self.control.finish(few);
        }
    }

    /// A host that has sent a part of a packet goes on with it in the next run.
    pub fn abort_within_packet(&mut self) {
        self.control.script.pauses(Pauses::Some);
        let beats = Layout::record::<CachedQuery>(self.config).beats(self.config.bus.stream_bits);
        for held in 1..beats {
            self.control.script.expect(&[]);
            self.start(2);
            self.control.script.hold(Some(held));
            self.send(0);
            self.control.script.wait(SETTLE_CYCLES);
            self.control.script.write(CONTROL, ABORT);
            self.control.finish(0);
            self.expect(0..1);
            self.start(1);
            self.control.script.hold(None);
            self.control.script.count(ErrorCounter::Packet);
            self.send(0);
            self.control.script.wait_received(0);
            self.control.finish(1);
        }
    }

    /// Nothing is taken back that is under way: until it has come, no run begins.
    pub fn abort_held(&mut self) {
        for channel in [Channel::Receive, Channel::ReadData] {
            self.control.script.pauses(Pauses::None);
            self.control.script.write(CONTROL, RESET);
            self.control.script.share(channel, ALWAYS);
            self.expect(self.all());
            self.start(self.searches.count() as u32);
            // Not more than the core takes while it is held.
            let few = FEW.min(self.config.threads as usize).min(self.searches.count());
            (0..few).for_each(|index| self.send(index));
            // A tree cache clears a line a cycle.
            self.control.script.wait(self.config.tree_cache + SETTLE_CYCLES);
            self.control.script.write(CONTROL, ABORT);
            self.control.script.wait(SETTLE_CYCLES);
            self.control.script.refuse(CONTROL, START, Refusal::Busy);
            self.control.script.write(CONTROL, ABORT);
            self.control.script.errors(BUSY);
            self.control.script.share(channel, 128);
            self.control.script.wait_interrupt();
            self.control.check_counters(few);
            self.control.script.expect(&[]);
            self.control.script.errors(DONE);
            self.run(Pauses::Some);
        }
    }

    /// A run that is aborted somewhere on its way.
    pub fn abort_somewhere(&mut self) {
        self.control.script.pauses(Pauses::Some);
        self.expect(self.all());
        let sent = self.control.script.random.usize(1..self.searches.count().max(2));
        self.start(self.searches.count() as u32);
        self.all().take(sent).for_each(|index| self.send(index));
        self.control.script.wait_sent();
        let cycles = self.control.script.random.u32(..SETTLE_CYCLES);
        self.control.script.wait(cycles);
        self.control.script.write(CONTROL, ABORT);
        self.control.script.wait_interrupt();
        self.control.check_counters(sent.min(self.searches.count()));
        self.control.script.expect(&[]);
        self.control.script.check_quiet(0);
        self.control.script.errors(DONE);
    }
}
