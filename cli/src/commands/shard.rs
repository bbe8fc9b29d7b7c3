//! Work that is spread: over the threads of a process, and over processes that keep what they finish in one folder.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The I-th of N parts.
#[derive(Clone, Copy)]
pub struct Shard {
    index: usize,
    count: usize,
}

impl std::str::FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
        let shard = parts.filter(|(index, count)| (1..=*count).contains(index));
        let shard = shard.map(|(index, count): (usize, usize)| Self { index: index - 1, count });
        shard.ok_or_else(|| "expected I/N with I from 1 to N, such as 2/8".to_owned())
    }
}

impl Shard {
    /// Its part of some points.
    pub fn of<T>(self, points: impl IntoIterator<Item = T>) -> Vec<T> {
        points.into_iter().skip(self.index).step_by(self.count).collect()
    }
}

/// Does `work` on every item, several at a time; results are in the items' order.
pub fn spread<T: Sync, R: Send>(items: &[T], jobs: u16, work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::new());
    // Threads of their own: work that an item spreads over all processors must not wait for another item.
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(index) else { break };
                    let result = work(item);
                    results.lock().expect("no holder of this lock panics").push((index, result));
                }
            });
        }
    });
    let mut results = results.into_inner().expect("no holder of this lock panics");
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}
