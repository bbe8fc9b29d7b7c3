//! External memory as the search core sees it: latency, bandwidth, bursts, and completion in or out of order.
//!
//! Requests of all ports share one bus. A request waits for the latency, then its transfer occupies the bus for its bytes,
//! rounded up to whole bursts, at the given bandwidth; its beats leave in order and together, one a cycle and port at most. What the
//! core does not take waits in the controller while the bus goes on.

use super::SearchError;
use std::collections::VecDeque;
use std::ops::RangeInclusive;

/// How the memory answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemorySettings {
    /// Cycles from a request to the first beat of its answer, if the bus is free.
    pub latency_cycles: u64,
    /// Bytes that the bus moves in a cycle; `None` for a beat of points a cycle.
    pub bytes_per_cycle: Option<f64>,
    /// Bytes that the memory can only move together; 1 for any number.
    pub burst_bytes: u32,
    /// Among how many of the oldest requests the next one to be answered is chosen at random; 1 keeps their order.
    pub reorder_window: usize,
}

impl Default for MemorySettings {
    fn default() -> Self {
        Self { latency_cycles: 40, bytes_per_cycle: None, burst_bytes: 1, reorder_window: 1 }
    }
}

impl MemorySettings {
    /// Cycles of latency that make sense.
    pub const LATENCY_CYCLES: RangeInclusive<u64> = 1..=500;
    /// Bandwidths that make sense: from a serial flash to anything on a die.
    pub const BYTES_PER_CYCLE: RangeInclusive<f64> = 0.01..=65_536.0;

    /// Checks every setting.
    ///
    /// # Errors
    /// The first one that no memory has.
    pub fn validate(&self) -> Result<(), SearchError> {
        let wrong = |setting, value, expected| Err(SearchError::Memory { setting, value, expected });
        if !Self::LATENCY_CYCLES.contains(&self.latency_cycles) {
            return wrong("latency", self.latency_cycles as f64, "1 to 500 cycles");
        }
        match self.bytes_per_cycle {
            Some(bytes) if !Self::BYTES_PER_CYCLE.contains(&bytes) => {
                return wrong("bandwidth", bytes, "0.01 to 65536 bytes a cycle");
            }
            _ => {}
        }
        if self.burst_bytes == 0 {
            return wrong("burst", 0.0, "1 byte at least");
        }
        if self.reorder_window == 0 {
            return wrong("reorder window", 0.0, "1 request at least");
        }
        Ok(())
    }
}

/// What a request asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RequestSize {
    /// Beats of the answer, at least one.
    pub beats: u32,
    /// Bytes of a beat.
    pub beat_bytes: u32,
}

#[derive(Clone, Debug)]
struct Request<K> {
    port: usize,
    key: K,
    extent: RequestSize,
    ready: u64,
}

/// An answer on the bus or behind it.
#[derive(Clone, Debug)]
struct Answer<K> {
    key: K,
    extent: RequestSize,
    /// When the bus began with it, in cycles.
    begin: f64,
    sent: u32,
}

/// A memory with some ports; requests and answers bear a key.
#[derive(Clone, Debug)]
pub struct PointMemory<K> {
    settings: MemorySettings,
    bytes_per_cycle: f64,
    random: fastrand::Rng,
    requests: VecDeque<Request<K>>,
    /// Whether a port's requests are answered in their order, whatever the settings say.
    is_ordered: Vec<bool>,
    answers: Vec<VecDeque<Answer<K>>>,
    /// When the bus is free again, in cycles.
    bus_free: f64,
    /// Requests accepted.
    pub requests_taken: u64,
    /// Bytes moved, whole bursts.
    pub bytes: u64,
}

impl<K: Copy> PointMemory<K> {
    /// An idle memory with so many ports; without a bandwidth among the settings, the bus moves `beat_bytes` a cycle. `seed` decides
    /// the order of answers.
    #[must_use]
    pub fn new(settings: MemorySettings, ports: usize, beat_bytes: u32, seed: u64) -> Self {
        Self {
            settings,
            bytes_per_cycle: settings.bytes_per_cycle.unwrap_or(beat_bytes.into()),
            random: fastrand::Rng::with_seed(seed),
            requests: VecDeque::new(),
            is_ordered: vec![false; ports],
            answers: (0..ports).map(|_| VecDeque::new()).collect(),
            bus_free: 0.0,
            requests_taken: 0,
            bytes: 0,
        }
    }

    /// Answers the requests of a port in their order.
    #[must_use]
    pub fn ordered(mut self, port: usize) -> Self {
        self.is_ordered[port] = true;
        self
    }

    /// Bytes that the bus can move in a cycle.
    #[must_use]
    pub const fn bytes_per_cycle(&self) -> f64 {
        self.bytes_per_cycle
    }

    fn transfer_bytes(&self, extent: RequestSize) -> u64 {
        let bytes = u64::from(extent.beats) * u64::from(extent.beat_bytes);
        bytes.next_multiple_of(self.settings.burst_bytes.into())
    }

    /// Cycles from a request to the end of its answer on an idle bus.
    #[must_use]
    pub fn answer_cycles(&self, extent: RequestSize) -> u64 {
        let transfer = self.transfer_bytes(extent) as f64 / self.bytes_per_cycle;
        self.settings.latency_cycles + transfer.ceil() as u64
    }

    /// Accepts a request in cycle `now`.
    pub fn request(&mut self, port: usize, key: K, extent: RequestSize, now: u64) {
        self.requests_taken += 1;
        self.requests.push_back(Request { port, key, extent, ready: now + self.settings.latency_cycles });
    }

    /// Gives the bus to requests as long as it gets free before cycle `now` ends.
    pub fn advance(&mut self, now: u64) {
        while self.bus_free < (now + 1) as f64 {
            let window = self.requests.len().min(self.settings.reorder_window);
            let ready = (0..window).filter(|index| self.requests[*index].ready <= now);
            let chosen = if self.settings.reorder_window == 1 {
                ready.min()
            } else {
                self.random.choice(ready.collect::<Vec<_>>())
            };
            let chosen = chosen.map(|index| self.in_order(index)).and_then(|index| self.requests.remove(index));
            let Some(Request { port, key, extent, .. }) = chosen else { return };
            let bytes = self.transfer_bytes(extent);
            let begin = self.bus_free.max(now as f64);
            self.bus_free = begin + bytes as f64 / self.bytes_per_cycle;
            self.bytes += bytes;
            self.answers[port].push_back(Answer { key, extent, begin, sent: 0 });
        }
    }

    /// The request to be answered in the place of a chosen one: the oldest of its port, where that is ordered.
    fn in_order(&self, chosen: usize) -> usize {
        let port = self.requests[chosen].port;
        let oldest = || self.requests.iter().position(|request| request.port == port);
        if self.is_ordered[port] { oldest().unwrap_or(chosen) } else { chosen }
    }

    /// The beat on offer at a port in cycle `now`: the key of its request and its number in the answer.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<(K, u32)> {
        let answer = self.answers[port].front()?;
        let bytes = (answer.sent + 1) * answer.extent.beat_bytes;
        let complete = answer.begin + f64::from(bytes) / self.bytes_per_cycle;
        (complete <= (now + 1) as f64).then_some((answer.key, answer.sent))
    }

    /// The beat on offer at a port was taken.
    pub fn take(&mut self, port: usize) {
        let answers = &mut self.answers[port];
        if let Some(answer) = answers.front_mut() {
            answer.sent += 1;
            if answer.sent == answer.extent.beats {
                answers.pop_front();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BEAT: u32 = 12;

    /// Requests of `beats` beats each in cycle 0, everything taken at once: cycles, keys and numbers of the beats.
    fn run(settings: MemorySettings, beats: &[u32]) -> (Vec<(u64, usize, u32)>, PointMemory<usize>) {
        let mut memory = PointMemory::new(settings, 1, BEAT, 1);
        for (key, beats) in beats.iter().enumerate() {
            memory.request(0, key, RequestSize { beats: *beats, beat_bytes: BEAT }, 0);
        }
        let mut seen = Vec::new();
        for cycle in 0..1000 {
            memory.advance(cycle);
            if let Some((key, beat)) = memory.offer(0, cycle) {
                seen.push((cycle, key, beat));
                memory.take(0);
            }
        }
        assert_eq!(seen.len() as u32, beats.iter().sum::<u32>());
        (seen, memory)
    }

    #[test]
    fn beats_come_after_the_latency_one_a_cycle() {
        let (seen, memory) = run(MemorySettings { latency_cycles: 7, ..MemorySettings::default() }, &[2, 1]);
        assert_eq!(seen, [(7, 0, 0), (8, 0, 1), (9, 1, 0)]);
        assert_eq!((memory.requests_taken, memory.bytes), (2, 36));
    }

    #[test]
    fn bandwidth_spaces_beats() {
        let settings = MemorySettings { latency_cycles: 1, ..MemorySettings::default() };
        let slow = MemorySettings { bytes_per_cycle: Some(4.8), ..settings };
        // 12 bytes take two and a half cycles.
        let cycles = |settings| run(settings, &[2, 2]).0.iter().map(|(cycle, ..)| *cycle).collect::<Vec<_>>();
        assert_eq!(cycles(slow), [3, 5, 8, 10]);
        let fast = MemorySettings { bytes_per_cycle: Some(1e3), ..settings };
        assert_eq!(cycles(fast), [1, 2, 3, 4], "a port takes a beat a cycle");
    }

    #[test]
    fn transfers_are_whole_bursts() {
        let settings = MemorySettings { latency_cycles: 1, burst_bytes: 32, ..MemorySettings::default() };
        let (seen, memory) = run(settings, &[1, 1]);
        assert_eq!(memory.bytes, 64);
        // The bus is occupied for 32 bytes, two and two thirds of a beat.
        assert_eq!(seen, [(1, 0, 0), (4, 1, 0)]);
    }

    #[test]
    fn answers_overtake_each_other_within_the_window_but_beats_do_not() {
        const WINDOW: usize = 4;
        let settings = MemorySettings { latency_cycles: 3, reorder_window: WINDOW, ..MemorySettings::default() };
        let (seen, _) = run(settings, &[3; 40]);
        let keys: Vec<_> = seen
            .chunks(3)
            .map(|beats| {
                assert!(
                    beats.iter().enumerate().all(|(index, (_, key, beat))| (*key, *beat) == (beats[0].1, index as u32))
                );
                beats[0].1
            })
            .collect();
        assert!(!keys.is_sorted());
        for (place, key) in keys.iter().enumerate() {
            assert!(*key < place + WINDOW, "request {key} was answered in place {place}");
        }
        assert_eq!(run(settings, &[3; 40]).0, seen, "the same seed gives the same order");
    }

    #[test]
    fn an_ordered_port_keeps_its_order() {
        let settings = MemorySettings { latency_cycles: 3, reorder_window: 8, ..MemorySettings::default() };
        let mut memory = PointMemory::new(settings, 2, BEAT, 1).ordered(1);
        (0..40).for_each(|key| memory.request(key % 2, key, RequestSize { beats: 1, beat_bytes: BEAT }, 0));
        let mut seen = [vec![], vec![]];
        for cycle in 0..100 {
            memory.advance(cycle);
            for (port, seen) in seen.iter_mut().enumerate() {
                if let Some((key, _)) = memory.offer(port, cycle) {
                    seen.push(key);
                    memory.take(port);
                }
            }
        }
        assert_eq!(seen.each_ref().map(Vec::len), [20, 20]);
        assert!(!seen[0].is_sorted() && seen[1].is_sorted(), "{seen:?}");
    }

    #[test]
    fn ports_share_the_bus_but_do_not_wait_for_each_other() {
        let mut memory =
            PointMemory::new(MemorySettings { latency_cycles: 1, ..MemorySettings::default() }, 2, BEAT, 1);
        let extent = RequestSize { beats: 1, beat_bytes: BEAT };
        memory.request(0, 'a', extent, 0);
        memory.request(1, 'b', extent, 0);
        (1..=2).for_each(|cycle| memory.advance(cycle));
        assert_eq!((memory.offer(1, 1), memory.offer(1, 2)), (None, Some(('b', 0))), "after the other's beat");
        memory.take(1);
        assert_eq!((memory.offer(0, 2), memory.offer(1, 2)), (Some(('a', 0)), None));
    }

    #[test]
    fn settings_without_meaning_are_refused() {
        let sound = MemorySettings::default();
        assert!(sound.validate().is_ok());
        for (settings, part) in [
            (MemorySettings { latency_cycles: 0, ..sound }, "latency is 0: expected 1 to 500"),
            (MemorySettings { latency_cycles: 501, ..sound }, "latency"),
            (MemorySettings { bytes_per_cycle: Some(0.0), ..sound }, "bandwidth"),
            (MemorySettings { bytes_per_cycle: Some(f64::NAN), ..sound }, "bandwidth"),
            (MemorySettings { burst_bytes: 0, ..sound }, "burst"),
            (MemorySettings { reorder_window: 0, ..sound }, "window"),
        ] {
            let message = settings.validate().unwrap_err().to_string();
            assert!(message.contains(part), "{message}");
        }
    }
}
