//! The entries' state: what may be reused, what is being read or written, and the order of use.

use super::coverage::Reference;

/// A neighborhood's state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Entry {
    /// It may answer queries.
    pub(super) present: bool,
    /// From the first neighbor copied until its comparison value is known.
    pub(super) writing: bool,
    /// The settings have changed while it was written.
    pub(super) stale: bool,
    /// Tells its neighborhoods apart: a check that is under way belongs to the one it has read.
    pub(super) version: u8,
    /// Answers under way from it.
    pub(super) readers: u8,
    /// Neighbors of an answer.
    pub(super) count: u8,
    pub(super) reference: Reference,
}

/// All entries.
#[derive(Clone, Debug)]
pub(super) struct Entries {
    entries: Vec<Entry>,
    /// From the least to the most recently used.
    order: Vec<usize>,
}

impl Entries {
    pub(super) fn new(entries: usize) -> Self {
        Self { entries: vec![Entry::default(); entries], order: (0..entries).collect() }
    }

    pub(super) const fn len(&self) -> usize {
        self.entries.len()
    }

    pub(super) fn get(&self, entry: usize) -> &Entry {
        &self.entries[entry]
    }

    /// The least recently used entry that is neither read nor written.
    pub(super) fn victim(&self) -> Option<usize> {
        let is_free = |entry: &usize| self.entries[*entry].readers == 0 && !self.entries[*entry].writing;
        self.order.iter().copied().find(is_free)
    }

    /// Makes an entry the most recently used.
    pub(super) fn touch(&mut self, entry: usize) {
        self.order.retain(|other| *other != entry);
        self.order.push(entry);
    }

    pub(super) fn start_writing(&mut self, entry: usize) {
        let Entry { present, writing, version, .. } = &mut self.entries[entry];
        (*present, *writing, *version) = (false, true, version.wrapping_add(1));
        self.touch(entry);
    }

    pub(super) fn set_count(&mut self, entry: usize, count: u8) {
        self.entries[entry].count = count;
    }

    /// An entry is complete.
    pub(super) fn stop_writing(&mut self, entry: usize, reference: Reference) {
        let entry = &mut self.entries[entry];
        *entry = Entry { present: !entry.stale, writing: false, stale: false, reference, ..*entry };
    }

    pub(super) fn add_reader(&mut self, entry: usize) {
        self.entries[entry].readers += 1;
    }

    pub(super) fn remove_reader(&mut self, entry: usize) {
        self.entries[entry].readers -= 1;
    }

    /// No neighborhood found so far may be reused.
    pub(super) fn forget(&mut self) {
        for entry in &mut self.entries {
            (entry.present, entry.stale) = (false, entry.writing);
        }
    }
}
