//! A host at the registers of either core: settings, starts, and what a run counted.

use super::operations::Counted;
use super::registers::{DONE, START};
use super::script::Script;
use pointcore_contract::bus::Register;
use pointcore_contract::bus::registers::CONTROL;

/// The registers of a core, and the script that uses them.
pub struct Control<'a> {
    pub script: &'a mut Script,
    pub map: &'a [Register],
}

impl Control<'_> {
    fn address(&self, name: &str) -> Option<u32> {
        self.map.iter().find(|register| register.name == name).map(|register| register.address)
    }

    /// Writes a setting, where the core has it.
    pub fn set(&mut self, name: &str, value: u32) {
        if let Some(address) = self.address(name) {
            self.script.write(address, value);
        }
    }

    fn get(&mut self, name: &str, counted: Counted) {
        let address = self.address(name).expect("every map has the counters of a run");
        self.script.read_counted(address, counted, 0);
    }

    /// Begins a run.
    pub fn start(&mut self) {
        self.script.write(CONTROL, START);
        self.script.interrupt(0);
    }

    /// The end of a run, after which nothing is left over, and what it counted.
    pub fn finish(&mut self, packets_in: usize) {
        self.script.wait_interrupt();
        self.check_counters(packets_in);
        self.script.check_quiet(0);
        self.script.errors(DONE);
    }

    /// What a run counted.
    pub fn check_counters(&mut self, packets_in: usize) {
        self.get("cycles", Counted::Cycles);
        let address = self.address("packets_in").expect("every map has the counters of a run");
        self.script.read(address, packets_in as u32);
        self.get("packets_out", Counted::Packets);
        let events = self.map.iter().filter(|register| register.name.starts_with("event_"));
        let addresses: Vec<u32> = events.map(|register| register.address).collect();
        for (place, address) in (0..).zip(addresses) {
            self.script.read_counted(address, Counted::Event(place), 0);
        }
        // They stand still after a run.
        self.get("cycles", Counted::Cycles);
    }
}
