//! Trees of points of all kinds hold what the search relies on.

use super::*;
use pointcore_contract::Format;
use proptest::prelude::*;
use std::ops::RangeInclusive;

const SPLITTINGS: [Splitting; 3] = [Splitting::Median, Splitting::Packed, Splitting::Midpoint];

/// Checks a subtree whose points must lie within `cell`; returns the number of its points and of its leaves.
fn check_node(tree: &Tree, node: u32, cell: [RangeInclusive<f32>; 3], found: &mut Vec<u32>) -> (usize, usize) {
    let deepest = tree.leaves.len() as u32;
    let record =
        if node < deepest { tree.nodes[node as usize].expect("nodes on a path are there") } else { Node::Leaf };
    let Node::Split { dimension, split } = record else {
        let depth = deepest.ilog2();
        let number = (node << (depth - node.ilog2())) - deepest;
        let Bucket { begin, beats, points } = tree.leaves[number as usize].expect("a leaf has a bucket");
        assert_eq!(beats, points.div_ceil(tree.lanes).max(1));
        for place in begin * tree.lanes..(begin + beats) * tree.lanes {
            let point = tree.memory[place as usize];
            let Some(source) = tree.source(place) else {
                assert_eq!(point, [tree.format.quiet_nan() as u32; 3], "places without a point are NaN");
                continue;
            };
            found.push(source);
            let coordinates = point.map(|bits| crate::number::decode(tree.format, bits));
            assert!(coordinates.iter().zip(&cell).all(|(coordinate, range)| range.contains(coordinate)));
        }
        return (points as usize, 1);
    };
    let axis = usize::from(dimension);
    let [mut left, mut right] = [cell.clone(), cell.clone()];
    left[axis] = *cell[axis].start()..=split;
    right[axis] = split..=*cell[axis].end();
    let (left, right) = (check_node(tree, 2 * node, left, found), check_node(tree, 2 * node + 1, right, found));
    (left.0 + right.0, left.1 + right.1)
}

/// Builds and checks; every point must be in one leaf.
fn check(config: &Config, points: &[[f32; 3]], splitting: Splitting) -> TreeStatistics {
    let set = PointSet::new(config.geometry, points).expect("the points are finite");
    let tree = Tree::build(config, &set, splitting).unwrap_or_else(|error| panic!("{error}"));
    let everywhere = [(); 3].map(|()| f32::NEG_INFINITY..=f32::INFINITY);
    let mut found = Vec::new();
    let (count, leaves) = check_node(&tree, 1, everywhere, &mut found);
    assert!(tree.leaves.iter().flatten().all(|bucket| bucket.points <= config.bucket));
    found.sort_unstable();
    assert!(found.iter().copied().eq(0..points.len() as u32), "every point is in one leaf");
    for (place, source) in tree.sources.iter().enumerate() {
        let encoded = source.map(|source| set.points()[source as usize].map(|number| encode(config.geometry, number)));
        assert!(encoded.is_none_or(|point| point == tree.memory[place]));
    }
    let statistics = tree.statistics();
    assert_eq!((statistics.points, statistics.leaves, statistics.nodes), (count, leaves, leaves - 1));
    assert_eq!(tree.writes().filter(|write| write.is_leaf).count(), leaves);
    statistics
}

fn config(points: usize, bucket: u32, lanes: u32, format: Format) -> Config {
    Config { geometry: format, bucket, lanes, tree_depth: depth_for(points, bucket), ..Config::default() }
}

fn format() -> impl Strategy<Value = Format> {
    prop::sample::select(vec![Format::F32, Format::F32.flushed(), Format::F24, Format::F24.flushed()])
}

/// Points in a cube, on a lattice, in a plane, on a line, all the same, or of any magnitude.
fn points() -> impl Strategy<Value = Vec<[f32; 3]>> {
    let unit = -1.0_f32..1.0;
    let lattice = (-2..3_i8).prop_map(|cell| f32::from(cell) / 2.0);
    let magnitude = (-30.0_f32..30.0, any::<bool>())
        .prop_map(|(exponent, negative)| if negative { -exponent.exp2() } else { 10_f32.powf(exponent) });
    let axis = prop_oneof![unit.clone().boxed(), lattice.boxed(), magnitude.boxed()].boxed();
    let cloud = prop::collection::vec([axis.clone(), axis.clone(), axis.clone()], 1..600);
    let shaped = (cloud, 0_u8..4, [axis.clone(), axis.clone(), axis]).prop_map(|(mut cloud, free, fixed)| {
        for point in &mut cloud {
            point[usize::from(free).min(3)..].copy_from_slice(&fixed[usize::from(free).min(3)..]);
        }
        cloud
    });
    shaped.boxed()
}

proptest! {
    #[test]
    fn every_point_lies_once_on_its_side_of_every_plane(
        points in points(), bucket in 1_u32..40, lanes in prop::sample::select(vec![1, 2, 4, 8]), format in format(), spare in 0_u32..3,
    ) {
        for splitting in SPLITTINGS {
            let mut config = config(points.len(), bucket, lanes, format);
            config.tree_depth += spare;
            check(&config, &points, splitting);
        }
    }
}

/// Half of the points in a speck, the other half far apart.
fn lopsided(count: usize) -> Vec<[f32; 3]> {
    let mut random = fastrand::Rng::with_seed(1);
    (0..count).map(|index| [(); 3].map(|()| random.f32() * if index % 2 == 0 { 1e-6 } else { 1.0 })).collect()
}

#[test]
fn full_trees_hold_their_points_however_they_lie() {
    for splitting in SPLITTINGS {
        for bucket in [1, 5, 16] {
            let count = (bucket as usize) << 8;
            let statistics = check(&config(count, bucket, 1, Format::F32), &lopsided(count), splitting);
            assert_eq!((statistics.leaves, statistics.depth), (256, 8), "all leaves are full");
            check(&config(count - 1, bucket, 4, Format::F32), &lopsided(count - 1), splitting);
        }
    }
}

#[test]
fn packed_buckets_are_full() {
    let points = lopsided(10_000);
    let config = config(points.len(), 16, 4, Format::F32);
    let [median, packed, _] = SPLITTINGS.map(|splitting| check(&config, &points, splitting));
    assert_eq!((packed.leaves, packed.beats), (625, 2500), "10,000 = 625 · 16");
    assert!(median.leaves > 900 && median.depth == 10);
    assert_eq!(packed.memory_bytes, 10_000 * 12);
    assert!(packed.to_string().starts_with("10000 points in 625 leaves of 16.0"));
}

#[test]
fn what_does_not_fit_is_said() {
    let error = |config: Config, count| {
        let points = PointSet::new(config.geometry, &lopsided(count)).expect("the points are finite");
        Tree::build(&config, &points, Splitting::Median).unwrap_err().to_string()
    };
    let small = Config { tree_depth: 3, bucket: 4, ..Config::default() };
    assert!(error(small.clone(), 33).contains("raise `tree_depth` to 4"));
    let narrow = Config { tree_depth: 10, index_bits: 8, ..small.clone() };
    assert!(error(narrow, 257).contains("raise it to 9"));
    assert!(error(Config { bucket: 0, ..small }, 1).contains("`bucket` = 0"));
}

#[test]
fn the_depth_follows_from_the_number_of_points() {
    for (points, bucket, depth) in [(1, 16, 1), (32, 16, 1), (33, 16, 2), (64, 16, 2), (134_345, 16, 14)] {
        assert_eq!(depth_for(points, bucket), depth, "{points} points");
    }
}
