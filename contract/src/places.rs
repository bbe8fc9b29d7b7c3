//! Where a record's values stand among its fields: a field is told by `places::<Query>(config).k`, not by what it is called.

use crate::record::{Domain, Record, Visit, Visitor, Word};

/// The terms of places: of each value, its place among the fields of the layout, if it is one of them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Places;

impl Domain for Places {
    type Bits<W: Word> = Option<usize>;
}

/// Numbers the values of a record.
struct Counter(usize);

impl Visitor<Places> for Counter {
    fn bits<W: Word>(&mut self, value: &mut Option<usize>) {
        *value = Some(self.0);
        self.0 += 1;
    }
}

/// The places of a record's fields.
#[must_use]
pub fn places<R: Record>(config: &R::Config) -> R::In<Places> {
    let mut record = <R::In<Places>>::default();
    record.visit(config, &mut Counter(0));
    record
}
