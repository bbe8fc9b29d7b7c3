//! A queue in look-up tables whose head is read without a register: what takes an item moves an address and nothing else, where
//! in a [`skid`](crate::stream::skid) it moves all bits of the items.

use pointcore_contract::width;

use crate::units::wires::Bundle;
use rtl::{Expr, Memory, Module, Reg};

/// The queue. An item that is pushed shows at the head in the next cycle if it was empty.
pub(crate) struct HeadQueue<B> {
    /// An item can be pushed in this cycle: known from the start of it, for much hangs on a push.
    pub room: Reg,
    /// There is an item.
    pub holds: Expr,
    /// The first one.
    pub head: B,
    items: Memory,
    depth: u32,
    count: Reg,
    /// Where the next item is written.
    pub write_address: Reg,
    /// Where the head is.
    pub read_address: Reg,
}

impl<B: Bundle> HeadQueue<B> {
    /// An empty queue of `depth` items, a power of two.
    pub fn new(m: &mut Module, config: &B::Config, name: &str, depth: u32) -> Self {
        let address_bits = depth.ilog2();
        let count = m.reg_reset(&format!("{name}_count"), address_bits + 1, 0);
        let [write_address, read_address] =
            ["write", "read"].map(|side| m.reg_reset(&format!("{name}_{side}_address"), address_bits, 0));
        let items = m.memory_distributed(name, depth, width::<B>(config));
        let head = m.read_now(items, &format!("{name}_head"), read_address);
        let room = m.reg_reset(&format!("{name}_has_room"), 1, 1);
        let (holds, head) = (count.any(), B::unpack(config, head));
        Self { room, holds, head, items, depth, count, write_address, read_address }
    }

    /// Pushes an item where `push` is set, which implies room, and takes out the head where `pop` is; to be called once.
    pub fn update(&self, m: &mut Module, config: &B::Config, push: Expr, item: B, pop: Expr) {
        m.write(self.items, push, self.write_address, item.pack(config));
        m.next_if(self.write_address, push, self.write_address.add_lit(1));
        m.next_if(self.read_address, pop, self.read_address.add_lit(1));
        let count = &self.count;
        m.next(*count, *count + push.zext(count.width()) - pop.zext(count.width()));
        let is = |items: u32| count.eq_lit(items.into());
        m.next(self.room, pop | !(is(self.depth) | (is(self.depth - 1) & push)));
    }
}
