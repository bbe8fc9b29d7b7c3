//! A memory behind a core or one of its units.

use crate::search::environment::Feeds;

/// Requests under way: one is answered after the other, any of them first.
#[derive(Clone, Default)]
pub struct Memory {
    requests: Vec<Vec<u64>>,
    answering: bool,
}

impl Memory {
    /// Takes a request; `answer` is called with the one to be answered now, if there is one.
    pub fn request(&mut self, feeds: &mut Feeds, request: &[u64], answer: impl FnOnce(&mut Feeds, &[u64])) {
        self.requests.push(request.to_vec());
        self.proceed(feeds, answer);
    }

    /// An answer is complete; `answer` is called with the request to be answered next, if there is one.
    pub fn answered(&mut self, feeds: &mut Feeds, answer: impl FnOnce(&mut Feeds, &[u64])) {
        self.answering = false;
        self.proceed(feeds, answer);
    }

    fn proceed(&mut self, feeds: &mut Feeds, answer: impl FnOnce(&mut Feeds, &[u64])) {
        if !self.answering && !self.requests.is_empty() {
            self.answering = true;
            let chosen = feeds.random.usize(..self.requests.len());
            answer(feeds, &self.requests.swap_remove(chosen));
        }
    }
}
