//! Latency, bandwidth, bursts and order of answers, one at a time.

use super::*;

const BEAT: u32 = 12;

/// Requests of `beats` beats each in cycle 0, everything taken at once: cycles, keys and numbers of the beats.
fn run(settings: MemorySettings, beats: &[u32]) -> (Vec<(u64, usize, u32)>, ExternalMemory<usize>) {
    let mut memory = ExternalMemory::new(settings, 1, BEAT, 1);
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
    assert_eq!((memory.requests_taken, memory.bus().bytes()), (2, 36));
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
    assert_eq!(memory.bus().bytes(), 64);
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
    let mut memory = ExternalMemory::new(settings, 2, BEAT, 1).ordered(1);
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
    let mut memory = ExternalMemory::new(MemorySettings { latency_cycles: 1, ..MemorySettings::default() }, 2, BEAT, 1);
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
