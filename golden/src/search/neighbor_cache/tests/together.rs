//! Queries that come before the neighborhood which answers them has arrived.

use super::*;

/// A cache that has learned how far a neighborhood covers.
fn experienced(config: &Config) -> Bench {
    let mut bench = Bench::new(config, LATENCIES, balls());
    let cached = [(); 2].map(|()| bench.ask(query(0, 13.0, 2.0, 1.5)).cached);
    assert_eq!(cached, [false, true]);
    bench
}

#[test]
fn queries_at_one_place_are_searched_for_once() {
    let queries: Vec<_> = (0..60).map(|number| query(number, 24.0, 2.0, 1.5)).collect();
    for threads in [1, 4, 32] {
        let mut bench = experienced(&Config { threads, ..config(2) });
        bench.latency = 200;
        let mut answers = bench.run(&queries, &mut Rng::with_seed(0));
        answers.sort_by_key(|answer| answer.number);
        let expected = |number| Answer { number, indices: (384..388).collect(), cached: number > 0 };
        assert!(answers.into_iter().eq((0..60).map(expected)), "with {threads} threads");
    }
}

/// A leader's neighborhood need not cover what has waited for it.
#[test]
fn a_query_that_waited_in_vain_is_searched_for() {
    let mut bench = experienced(&config(8));
    let queries: Vec<_> = [34.0, 34.25, 44.0].into_iter().zip(0..).map(|(x, i)| query(i, x, 2.0, 1.9)).collect();
    let mut left = queries.iter();
    let mut searches = Vec::new();
    let (mut found, mut answers) = (VecDeque::new(), HashMap::new());
    let mut search_until = |cycles: u32, found: &mut VecDeque<QueryResult>| {
        for _ in 0..cycles {
            let out = bench.cache.outputs();
            searches.extend(out.search);
            if let Some(CachedResult { result, cached }) = out.result {
                answers.insert(result.number, cached);
            }
            let inputs = In {
                query: left.as_slice().first().copied(),
                search_ready: true,
                found: found.front().copied(),
                result_ready: true,
                ..In::default()
            };
            left = if out.query_ready && inputs.query.is_some() { left.as_slice()[1..].iter() } else { left.clone() };
            found.pop_front_if(|_| out.found_ready);
            bench.cache.clock(&inputs);
        }
        searches.clone()
    };
    let places = |searches: &[Query]| searches.iter().map(|search| search.point).collect::<Vec<_>>();
    let place = |query: usize| queries[query].query.point;
    let under_way = search_until(300, &mut found);
    assert_eq!(places(&under_way), [place(0), place(2)], "the second waits for the first");
    found.extend(neighborhood(&under_way[0]));
    let under_way = search_until(300, &mut found);
    assert_eq!(places(&under_way), [place(0), place(2), place(1)]);
    found.extend(under_way[1..].iter().flat_map(neighborhood));
    search_until(300, &mut found);
    assert_eq!(answers, HashMap::from([(0, false), (1, false), (2, false)]));
}
