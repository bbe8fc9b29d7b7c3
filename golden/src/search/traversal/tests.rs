use super::*;
use pointcore_contract::search::records::{Query, Start, TreeWrite};

const THREAD: Thread = Thread { thread: 2 };

/// Three levels: the root splits x at 1, its left child y at 2; its right child is an internal leaf.
fn unit(point: [f32; 3]) -> Traversal {
    let mut traversal = Traversal::new(&Config { tree_depth: 3, ..Config::default() }, 2);
    let nodes = [(1, 0, 1.0_f32, false), (2, 1, 2.0, false), (3, 0, 0.0, true), (4, 2, 3.0, false), (5, 2, 4.0, false)];
    for (address, dimension, split, internal_leaf) in nodes {
        let node = Node { dimension, split: split.to_bits(), internal_leaf };
        let write = TreeWrite { address, node, ..TreeWrite::default() };
        traversal.clock(&In { tree: Some(write), ..In::default() });
    }
    let query = Query { point: point.map(f32::to_bits), ..Query::default() };
    traversal.clock(&In { start: Some(Start { thread: THREAD, query }), ..In::default() });
    traversal
}

/// Descends from a node: what is pushed, in order, and the leaf.
fn descend(traversal: &mut Traversal, node: u32) -> (Vec<(u32, f32)>, u32) {
    traversal.clock(&In { descend: Some(Descent { thread: THREAD, node }), ..In::default() });
    let (mut pushed, mut leaf) = (Vec::new(), None);
    for _ in 0..40 {
        let out = traversal.outputs();
        pushed.extend(out.push.map(|push| (push.path.node, f32::from_bits(push.path.distance2))));
        leaf = leaf.or(out.leaf);
        traversal.clock(&In { leaf_ready: true, ..In::default() });
        if let Some(thread) = out.reached {
            assert_eq!(thread, THREAD);
            let visit = leaf.expect("the leaf is sent off before it counts as reached");
            assert_eq!(visit.thread, THREAD);
            return (pushed, visit.leaf);
        }
    }
    panic!("the descent ends within the cycles of three levels");
}

#[test]
fn the_far_sides_are_pushed_from_the_root_down() {
    assert_eq!(descend(&mut unit([0.5, 5.0, 1.0]), 1), (vec![(3, 0.25), (4, 9.0), (11, 9.0)], 2));
    assert_eq!(descend(&mut unit([0.5, 1.5, 3.5]), 2), (vec![(5, 0.25), (8, 0.25)], 1), "from a path");
}

#[test]
fn a_query_on_a_plane_goes_right_and_an_internal_leaf_ends_the_descent() {
    assert_eq!(descend(&mut unit([1.0, 0.0, 0.0]), 1), (vec![(2, 0.0)], 4));
}

#[test]
fn a_descent_shares_the_ring_with_others() {
    let mut traversal = unit([0.5, 1.5, 3.5]);
    let (mut sent, mut reached, mut visits) = (0, 0, 0);
    for _ in 0..200 {
        let out = traversal.outputs();
        let input = (sent < 20).then_some(Descent { thread: THREAD, node: 1 });
        sent += u32::from(input.is_some() && out.descend_ready);
        reached += u32::from(out.reached.is_some());
        visits += u32::from(out.event_node);
        traversal.clock(&In { descend: input, leaf_ready: true, ..In::default() });
        if reached == 20 {
            break;
        }
    }
    assert_eq!((reached, visits), (20, 80), "four nodes on the way to each leaf");
}

#[test]
fn leaves_that_are_not_taken_stop_the_ring_and_lose_nothing() {
    let mut traversal = unit([2.0, 0.0, 0.0]);
    let step = |traversal: &mut Traversal, leaf_ready| {
        let out = traversal.outputs();
        traversal.clock(&In { descend: Some(Descent { thread: THREAD, node: 1 }), leaf_ready, ..In::default() });
        (u32::from(out.descend_ready), u32::from(out.leaf.is_some() && leaf_ready))
    };
    let sent: u32 = (0..100).map(|_| step(&mut traversal, false).0).sum();
    assert!((2..12).contains(&sent), "{sent} descents are held in the unit");
    let (more, left) = (0..100).map(|_| step(&mut traversal, true)).fold((0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    assert!(left > 40 && sent + more - left < 12, "{sent} + {more} entered, {left} left");
}

#[test]
fn a_descent_takes_two_cycles_a_level_and_its_leaf_does_not_wait_for_the_paths() {
    let mut traversal = unit([0.5, 1.5, 3.5]);
    traversal.clock(&In { descend: Some(Descent { thread: THREAD, node: 1 }), ..In::default() });
    let (mut leaf, mut reached) = (None, None);
    for cycle in 1..40 {
        let out = traversal.outputs();
        leaf = leaf.or(out.leaf.map(|_| cycle));
        reached = reached.or(out.reached.map(|_| cycle));
        traversal.clock(&In { leaf_ready: true, ..In::default() });
    }
    // In f from cycle 2 on; four nodes, then the queue; what v held goes through s and the path datapath's two stages and queue.
    assert_eq!((leaf, reached), (Some(10), Some(13)));
}

#[test]
fn nodes_of_a_tree_in_external_memory_are_asked_for_one_by_one() {
    let config = Config { tree_depth: 3, tree_cache: 16, ..Config::default() };
    let mut traversal = Traversal::new(&config, 2);
    let query = Query { point: [0.5, 0.0, 0.0].map(f32::to_bits), ..Query::default() };
    traversal.clock(&In { start: Some(Start { thread: THREAD, query }), ..In::default() });
    let (mut asked, mut leaf, mut record) = (Vec::new(), None, None);
    for cycle in 0..100 {
        let out = traversal.outputs();
        // The memory answers in the cycle after the request, every node splitting x at 1.
        asked.extend(out.node.map(|descent| descent.node));
        leaf = leaf.or(out.leaf);
        let descend = (cycle == 0).then_some(Descent { thread: THREAD, node: 1 });
        traversal.clock(&In { descend, record, node_ready: true, leaf_ready: true, ..In::default() });
        let node = Node { split: 1.0_f32.to_bits(), ..Node::default() };
        record = out.node.map(|descent| NodeRecord { descent, node });
    }
    assert_eq!((asked, leaf.map(|visit| visit.leaf)), (vec![1, 2, 4, 8], Some(0)));
}
