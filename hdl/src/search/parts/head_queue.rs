//! A queue in look-up tables whose head is read without a register: what takes an item moves an address and nothing else, where
//! in a [`skid`](crate::stream::skid) it moves all bits of the items.

use pointcore_contract::splat::Field;

use crate::units::records::{Record, width};
use rtl::{Expr, Memory, Module, Reg};

/// The queue. An item that is pushed shows at the head in the next cycle if it was empty.
pub(crate) struct HeadQueue {
    /// An item can be pushed in this cycle.
    pub room: Expr,
    /// There is an item.
    pub holds: Expr,
    /// The first one.
    pub head: Record,
    fields: Vec<Field>,
    items: Memory,
    count: Reg,
    write_address: Reg,
    read_address: Reg,
}

impl HeadQueue {
    /// An empty queue of `depth` items, a power of two.
    pub fn new(m: &mut Module, name: &str, depth: u32, fields: &[Field]) -> Self {
        let address_bits = depth.ilog2();
        let count = m.reg_reset(&format!("{name}_count"), address_bits + 1, 0);
        let [write_address, read_address] =
            ["write", "read"].map(|side| m.reg_reset(&format!("{name}_{side}_address"), address_bits, 0));
        let items = m.memory_distributed(name, depth, width(fields));
        let head = m.read_now(items, &format!("{name}_head"), read_address);
        let (room, holds, head) = (!count.eq_lit(depth as u128), count.any(), Record::unpack(fields, head));
        Self { room, holds, head, fields: fields.to_vec(), items, count, write_address, read_address }
    }

    /// Pushes an item, which has all fields and may have more, where `push` is set, which implies room, and takes out the head
    /// where `pop` is; to be called once.
    pub fn update(&self, m: &mut Module, push: Expr, item: &Record, pop: Expr) {
        m.write(self.items, push, self.write_address, item.only(&self.fields).pack());
        m.next_if(self.write_address, push, self.write_address.add_lit(1));
        m.next_if(self.read_address, pop, self.read_address.add_lit(1));
        let count = &self.count;
        m.next(*count, *count + push.zext(count.width()) - pop.zext(count.width()));
    }
}
