//! Memories, tables and their ports.

use std::panic::Location;

use super::arena::Name;
use super::error::{FaultKind, Place};
use super::expression::{Expr, lit};
use super::module::{Module, Source};

/// A memory of a module.
#[derive(Clone, Copy)]
pub struct Memory {
    module: u64,
    index: usize,
    name: Name,
}

/// How a memory is to be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    /// As the synthesis tool sees fit: block RAM where it is large.
    Inferred,
    /// Likewise, without order between the reads and the write of a cycle.
    Unordered,
    /// Look-up-table RAM.
    Distributed,
}

/// What a module holds for a memory.
pub(super) struct Store {
    pub name: String,
    pub place: Place,
    pub depth: u32,
    pub width: u32,
    pub style: Style,
    /// Bits of a word that lie in one memory of the device.
    pub slice: u32,
    pub content: Content,
}

/// Where a memory's words come from.
pub(super) enum Content {
    /// A write port.
    Written(Option<WritePort>),
    /// A constant table.
    Constant(Vec<u128>),
}

pub(super) struct WritePort {
    pub enable: Expr,
    pub address: Expr,
    pub data: Expr,
}

/// Bits that address `depth` words: at least one.
#[must_use]
pub fn address_width(depth: u32) -> u32 {
    (u32::BITS - depth.saturating_sub(1).leading_zeros()).max(1)
}

impl Module {
    /// A memory of `depth` words with registered reads, block RAM where the synthesis tool finds it large enough.
    /// Addresses have [`address_width`] bits; words past `depth` do not exist and read as anything.
    #[track_caller]
    pub fn memory(&mut self, name: &str, depth: u32, width: u32) -> Memory {
        self.store(name, depth, width, Style::Inferred, Content::Written(None))
    }

    /// A memory as [`Module::memory`] where a word that is read in the cycle in which it is written reads as anything, in simulation
    /// with assertions as the old word inverted. A block RAM that is to show the old one needs registers and a choice behind its outputs.
    #[track_caller]
    pub fn memory_unordered(&mut self, name: &str, depth: u32, width: u32) -> Memory {
        self.store(name, depth, width, Style::Unordered, Content::Written(None))
    }

    /// A memory as [`Module::memory`], built from look-up tables; also read without a register.
    #[track_caller]
    pub fn memory_distributed(&mut self, name: &str, depth: u32, width: u32) -> Memory {
        self.store(name, depth, width, Style::Distributed, Content::Written(None))
    }

    /// A memory as [`Module::memory_unordered`], in slices of so many bits, the last one with what remains: each is a memory of its own,
    /// so that none is chosen among behind slow outputs.
    #[track_caller]
    pub fn memory_sliced(&mut self, name: &str, depth: u32, width: u32, slice: u32) -> Memory {
        let memory = self.memory_unordered(name, depth, width);
        if let Some(store) = self.stores.last_mut() {
            store.slice = slice.clamp(1, store.width);
        }
        memory
    }

    #[track_caller]
    fn store(&mut self, name: &str, depth: u32, width: u32, style: Style, content: Content) -> Memory {
        self.claim(name);
        if depth < 2 || width == 0 {
            let message = format!("a memory of {depth} words of {width} bits: it needs 2 words and 1 bit at least");
            self.fault(FaultKind::Expression { user: format!("`{name}`"), message });
        }
        let place = Location::caller();
        let (depth, width) = (depth.max(2), width.max(1));
        self.stores.push(Store { name: name.into(), place, depth, width, style, slice: width, content });
        Memory { module: self.identity, index: self.stores.len() - 1, name: Name::new(name) }
    }

    /// A read port: the word at `address` one cycle later. A word written in the same cycle reads as it was before, but for
    /// [`Module::memory_unordered`].
    #[track_caller]
    pub fn read(&mut self, memory: Memory, name: &str, address: impl Into<Expr>) -> Expr {
        self.read_port(memory, name, None, address.into())
    }

    /// A read port that keeps its word while `enable` is low.
    #[track_caller]
    pub fn read_if(&mut self, memory: Memory, name: &str, enable: impl Into<Expr>, address: impl Into<Expr>) -> Expr {
        self.read_port(memory, name, Some(enable.into().as_condition("enable")), address.into())
    }

    #[track_caller]
    fn read_port(&mut self, memory: Memory, name: &str, enable: Option<Expr>, address: Expr) -> Expr {
        let width = self.addressed(memory, address);
        self.declare(name, width, Source::Read { store: memory.index, enable, address })
    }

    /// The word at `address` in the same cycle; for distributed memories only.
    #[track_caller]
    pub fn read_now(&mut self, memory: Memory, name: &str, address: impl Into<Expr>) -> Expr {
        let address = address.into();
        let width = self.addressed(memory, address);
        if self.stores.get(memory.index).is_some_and(|store| store.style != Style::Distributed) {
            let message = format!("`{}` is not distributed and cannot be read without a register", memory.name.text());
            self.fault(FaultKind::Expression { user: format!("`{name}`"), message });
        }
        self.declare(name, width, Source::ReadNow { store: memory.index, address })
    }

    /// The memory's write port: stores `data` at clock edges where `enable` is set.
    #[track_caller]
    pub fn write(&mut self, memory: Memory, enable: impl Into<Expr>, address: impl Into<Expr>, data: impl Into<Expr>) {
        let (address, data) = (address.into(), data.into());
        let width = self.addressed(memory, address);
        self.check_width(&memory.name.text(), width, data);
        let port = WritePort { enable: enable.into().as_condition("enable"), address, data };
        match self.stores.get_mut(memory.index).map(|store| &mut store.content) {
            Some(Content::Written(slot @ None)) => *slot = Some(port),
            _ => self.fault(FaultKind::DoublyDriven(memory.name.text())),
        }
    }

    /// Checks a memory and an address; returns the width of the words.
    #[track_caller]
    fn addressed(&mut self, memory: Memory, address: Expr) -> u32 {
        match self.stores.get(memory.index) {
            Some(store) if memory.module == self.identity => {
                let (width, bits) = (store.width, address_width(store.depth));
                self.check_width(&format!("{} address", memory.name.text()), bits, address);
                width
            }
            _ => {
                self.fault(FaultKind::ForeignHandle(memory.name.text()));
                1
            }
        }
    }

    /// A registered read of a constant table; addresses past its end read the last value.
    #[track_caller]
    pub fn rom(&mut self, name: &str, values: &[u128], width: u32, address: impl Into<Expr>) -> Expr {
        self.constant_memory(name, values, width, None, address.into())
    }

    /// A read of a constant table as [`Module::rom`], kept while `enable` is low.
    #[track_caller]
    pub fn rom_if(
        &mut self,
        name: &str,
        values: &[u128],
        width: u32,
        enable: impl Into<Expr>,
        address: impl Into<Expr>,
    ) -> Expr {
        self.constant_memory(name, values, width, Some(enable.into().as_condition("enable")), address.into())
    }

    #[track_caller]
    fn constant_memory(
        &mut self,
        name: &str,
        values: &[u128],
        width: u32,
        enable: Option<Expr>,
        address: Expr,
    ) -> Expr {
        let table = format!("{name}_table");
        let mut padded = self.table(name, values, width, address);
        let depth = 1 << address_width(padded.len() as u32);
        padded.resize(depth as usize, *padded.last().expect("a table is never empty"));
        let memory = self.store(&table, depth, width, Style::Inferred, Content::Constant(padded));
        self.read_port(memory, name, enable, address)
    }

    /// A constant table without a register; addresses past its end give the last value.
    #[track_caller]
    pub fn lookup(&mut self, name: &str, values: &[u128], width: u32, address: impl Into<Expr>) -> Expr {
        let address = address.into();
        let values = self.table(name, values, width, address);
        self.declare(name, width, Source::Lookup { values, address })
    }

    /// The values of a table, checked; a stand-in where they are of no use.
    #[track_caller]
    fn table(&mut self, name: &str, values: &[u128], width: u32, address: Expr) -> Vec<u128> {
        let bits = address_width(values.len() as u32);
        self.check_width(&format!("{name} address"), bits, address);
        let misfit = values.iter().find(|&&value| lit(width, value).node().tainted);
        let message = match misfit {
            _ if values.is_empty() => "a table without values".to_string(),
            Some(value) => format!("{value} does not fit {width} bits"),
            None => return values.to_vec(),
        };
        self.fault(FaultKind::Expression { user: format!("`{name}`"), message });
        vec![0; values.len().max(1)]
    }
}
