use super::*;
use crate::testing::for_each_seed;
use pointcore_contract::search::records::{BeatPlace, Query};
use std::collections::VecDeque;

fn config(lanes: u32) -> Config {
    Config { lanes, threads: 4, neighbors: 5, ..Config::default() }
}

fn start(thread: u8, number: u32, k: u8, radius2: u32) -> In {
    let query = Query { number, k, radius2, ..Query::default() };
    In { start: Some(Start { thread: Thread { thread }, query }), result_ready: true, ..In::default() }
}

fn beat(thread: u8, address: u32, last: bool, distances: &[u32]) -> Candidates {
    let place = BeatPlace { thread: Thread { thread }, address, last };
    let mut candidates = Candidates { place, ..Candidates::default() };
    candidates.distances[..distances.len()].copy_from_slice(distances);
    candidates
}

/// Clocks `inputs` in order, each when it is accepted, then finishes thread 0; returns the results and the last radius.
fn search(queue: &mut Queue, inputs: &[In]) -> (Vec<(bool, u32, u32)>, Option<u32>) {
    let finish = In { finish: Some(Thread::default()), result_ready: true, ..In::default() };
    let mut inputs: VecDeque<In> = inputs.iter().copied().collect();
    let (mut results, mut radius2) = (Vec::new(), None);
    let mut idle = 0;
    for _ in 0..200 {
        let out = queue.outputs();
        radius2 = out.radius.map(|radius| radius.radius2).or(radius2);
        if let Some(result) = out.result {
            results.push((result.found, result.index, result.distance2));
        }
        match inputs.front() {
            Some(input) => {
                queue.clock(&In { result_ready: true, ..*input });
                if out.candidates_ready || input.candidates.is_none() {
                    inputs.pop_front();
                }
            }
            None => {
                // All beats are done before a thread finishes.
                idle += 1;
                queue.clock(&if idle == 40 { finish } else { In { finish: None, ..finish } });
            }
        }
        if out.result.is_some_and(|result| result.last) {
            return (results, radius2);
        }
    }
    panic!("a search ends");
}

fn candidates(beat: Candidates) -> In {
    In { candidates: Some(beat), ..In::default() }
}

#[test]
fn the_nearest_stay_and_the_first_of_equals() {
    let inputs = [
        start(0, 1, 3, 100),
        candidates(beat(0, 4, false, &[50, 50, 100, 7])),
        candidates(beat(0, 9, true, &[50, 7, 3, u32::MAX])),
    ];
    let expected = vec![(true, 38, 3), (true, 19, 7), (true, 37, 7)];
    assert_eq!(search(&mut Queue::new(&config(4)), &inputs), (expected, Some(7)));
}

#[test]
fn a_query_with_fewer_neighbors_shows_them_and_one_without_any_shows_none() {
    let mut queue = Queue::new(&config(2));
    let inputs = [start(0, 1, 5, 100), candidates(beat(0, 3, true, &[0, 100]))];
    assert_eq!(search(&mut queue, &inputs), (vec![(true, 6, 0)], Some(100)));
    let inputs = [start(0, 2, 5, 100), candidates(beat(0, 3, true, &[100, 101]))];
    assert_eq!(search(&mut queue, &inputs), (vec![(false, 0, 100)], Some(100)), "nothing is left of the query before");
}

#[test]
fn a_beat_stays_a_cycle_for_every_further_candidate() {
    let mut queue = Queue::new(&config(8));
    queue.clock(&start(0, 1, 1, 100));
    queue.clock(&candidates(beat(0, 0, true, &[200, 9, 9, 5, 200, 7, 9, 200])));
    let events = [(); 8].map(|()| {
        queue.clock(&In::default());
        let QueueEvents { beat, insert, insert_wait } = queue.outputs().events;
        (beat, insert, insert_wait)
    });
    // Five lanes are nearer than the radius of the leaf before. The first nine is inserted two cycles after it is chosen and known
    // of in the next, in which 7 is chosen: the last one goes then, as the beat is seen to have done a cycle later. Then comes 5.
    let (nothing, stays) = ((false, false, false), (false, false, true));
    let expected = [nothing, stays, stays, (false, true, true), stays, (true, true, false), nothing, nothing];
    assert_eq!(events, expected);
}

/// A search under way in a thread.
struct Expected {
    k: usize,
    radius2: u32,
    /// Distances and indices in order of arrival.
    points: Vec<(u32, u32)>,
    /// Beats that no result of [`Out::radius`] has closed.
    open: bool,
}

/// Threads in any order, random stalls: every result against a stable sort of all that the thread got.
#[test]
fn rows_of_many_threads_do_not_mix() {
    for_each_seed("queue", |random| {
        let mut queue = Queue::new(&config(2));
        let mut threads: [Option<Expected>; 4] = [const { None }; 4];
        let mut finishing: VecDeque<(u8, Vec<(u32, u32)>)> = VecDeque::new();
        let mut received = Vec::new();
        let (mut number, mut address, mut answered, mut neighbors) = (0, 0, 0, 0);
        for _ in 0..20_000 {
            let out = queue.outputs();
            let mut inputs = In { result_ready: random.u8(0..3) > 0, ..In::default() };
            if let Some(Radius { thread, radius2 }) = out.radius {
                let search = threads[thread.index()].as_mut().expect("the thread has a search");
                search.points.sort();
                search.points.truncate(search.k);
                let farthest = search.points.get(search.k - 1).map_or(search.radius2, |point| point.0);
                assert_eq!(radius2, farthest);
                search.open = false;
            }
            if let Some(result) = out.result.filter(|_| inputs.result_ready) {
                received.extend(result.found.then_some((result.distance2, result.index)));
                if result.last {
                    let (thread, expected) = finishing.pop_front().expect("a thread has finished");
                    // Points are numbered as they come, so that the first of equals has the smallest index.
                    assert_eq!(received, expected, "query {} of thread {thread}", result.number);
                    neighbors += received.len();
                    received.clear();
                    answered += 1;
                }
            }
            let thread = random.u8(0..4);
            let idle = finishing.iter().all(|(finished, _)| *finished != thread);
            match &mut threads[usize::from(thread)] {
                empty @ None if idle => {
                    let (k, radius2) = (random.u8(1..=5), random.u32(1..200));
                    inputs.start = start(thread, number, k, radius2).start;
                    *empty = Some(Expected { k: k.into(), radius2, points: Vec::new(), open: false });
                    number += 1;
                }
                Some(search) if !search.open && out.finish_ready && random.u8(0..4) == 0 => {
                    inputs.finish = Some(Thread { thread });
                    finishing.push_back((thread, std::mem::take(&mut search.points)));
                    threads[usize::from(thread)] = None;
                }
                Some(search) if !search.open && out.candidates_ready => {
                    let distances = [random.u32(0..200), random.u32(0..200)];
                    inputs.candidates = Some(beat(thread, address, true, &distances));
                    let points = distances.iter().zip(2 * address..).map(|(distance, index)| (*distance, index));
                    search.points.extend(points.filter(|(distance, _)| *distance < search.radius2));
                    search.open = true;
                    address += 1;
                }
                _ => {}
            }
            queue.clock(&inputs);
        }
        assert!(answered > 500 && neighbors > 1000, "{answered} queries with {neighbors} neighbors");
    });
}
