//! Operators over point sets: what comes out of surfaces that are known, of other people's points, and of what is wrong.

use super::*;
use crate::scene::trefoil;
use glam::DVec3;
use pointcore_contract::Format;
use std::collections::BTreeMap;

type Given = BTreeMap<String, Vec<f64>>;

/// Points on a sphere of radius 1 around a center, evenly spread, moved off it by up to `noise`.
fn sphere(count: usize, center: DVec3, noise: f64) -> Vec<DVec3> {
    let mut random = fastrand::Rng::with_seed(7);
    let point = |index: usize| {
        let z = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
        let angle = index as f64 * 2.399_963;
        let radius = (1.0 - z * z).sqrt();
        let direction = DVec3::new(radius * angle.cos(), radius * angle.sin(), z);
        center + direction * (1.0 + noise * (2.0 * random.f64() - 1.0))
    };
    (0..count).map(point).collect()
}

fn cloud(points: Vec<DVec3>, columns: &[(&str, Vec<f64>)]) -> Cloud {
    let columns = columns.iter().map(|(name, values)| ((*name).to_owned(), values.clone())).collect();
    Cloud::of(Format::F32.flushed(), "test".to_owned(), points, columns).unwrap_or_else(|error| panic!("{error}"))
}

fn given(numbers: &[(&str, &[f64])]) -> Given {
    numbers.iter().map(|(name, values)| ((*name).to_owned(), values.to_vec())).collect()
}

/// What is asked besides the operation.
struct Asked {
    k: u32,
    radius: Option<f64>,
    passes: u32,
    settings: Given,
    attributes: Given,
}

impl Default for Asked {
    fn default() -> Self {
        Self { k: 16, radius: None, passes: 1, settings: Given::new(), attributes: Given::new() }
    }
}

fn run(operation: &Operation, cloud: &Cloud, queries: &Queries, asked: &Asked) -> Result<Processed, ProcessError> {
    let Asked { k, radius, passes, settings, attributes } = asked;
    let (k, radius, passes) = (*k, *radius, *passes);
    let asked = Process { operation, k, radius, iterations: 16, passes, settings, attributes };
    process(cloud, queries, &asked, &Interpreted, &|_| ())
}

fn all(cloud: &Cloud) -> Queries {
    Queries::Points((0..cloud.len()).collect())
}

fn named(name: &str) -> Operation {
    Operation::named(name).unwrap_or_else(|error| panic!("{error}"))
}

fn runs(name: &str, cloud: &Cloud, asked: &Asked) -> Processed {
    run(&named(name), cloud, &all(cloud), asked).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn fails(name: &str, cloud: &Cloud, asked: &Asked, parts: &[&str]) {
    let message = run(&named(name), cloud, &all(cloud), asked).expect_err("it cannot be carried out").to_string();
    parts.iter().for_each(|part| assert!(message.contains(part), "`{part}` is missing in: {message}"));
}

/// The deviation of distances from a sphere of any radius: all of these operators shrink it.
fn roughness(points: &[DVec3], center: DVec3) -> f64 {
    let mean = |of: &dyn Fn(f64) -> f64| {
        points.iter().map(|point| of(point.distance(center))).sum::<f64>() / points.len() as f64
    };
    let radius = mean(&|distance| distance);
    mean(&|distance| (distance - radius).powi(2)).sqrt()
}

#[test]
fn surfaces_come_out_smoother_wherever_they_lie() {
    for center in [DVec3::ZERO, DVec3::new(1e6, -1e6, 1e6)] {
        let cloud = cloud(sphere(3000, center, 0.02), &[]);
        let before = roughness(cloud.points().given(), center);
        for (name, share) in [("mls", 0.7), ("apss", 0.7), ("smooth", 0.8)] {
            let processed = runs(name, &cloud, &Asked::default());
            assert_eq!(processed.summary.invalid, Some(0), "{name}");
            let after = roughness(&processed.places, center);
            assert!(after < share * before, "{name} at {center}: {after}, not {share} of {before}");
        }
    }
}

/// On a plane nothing but the noise is there to be smoothed.
#[test]
fn passes_go_on_from_where_the_one_before_ended() {
    let mut random = fastrand::Rng::with_seed(7);
    let mut point = |index: usize| {
        DVec3::new((index % 40) as f64, (index / 40) as f64, random.f64() - 0.5) * DVec3::new(0.05, 0.05, 0.02)
    };
    let cloud = cloud((0..1600).map(&mut point).collect(), &[]);
    let deviation = |passes: u32| {
        let processed = runs("smooth", &cloud, &Asked { passes, ..Asked::default() });
        assert_eq!(processed.summary.passes, passes);
        (processed.places.iter().map(|place| place.z.powi(2)).sum::<f64>() / 1600.0).sqrt()
    };
    let (once, eight) = (deviation(1), deviation(8));
    assert!(eight < 0.8 * once, "eight passes leave {eight}, one {once}");
}

#[test]
fn normals_are_those_of_the_sphere() {
    let cloud = cloud(sphere(3000, DVec3::ZERO, 0.0), &[]);
    let inside = Asked { settings: given(&[("viewpoint", &[0.0; 3])]), ..Asked::default() };
    let processed = runs("normals", &cloud, &inside);
    let normal = processed.column("normal").expect("it is an output");
    for (index, place) in processed.places.iter().enumerate() {
        let normal = DVec3::from_array([0, 1, 2].map(|axis| normal.numbers[axis].number(index)));
        assert!(normal.dot(*place) < -0.99, "{normal} at {place} does not look inwards");
    }
}

#[test]
fn patterns_add_points_on_the_surface() {
    let cloud = cloud(sphere(2000, DVec3::ZERO, 0.0), &[]);
    let queries = Queries::Pattern { points: (0..100).collect(), sides: [3, 2] };
    let processed =
        run(&named("resample"), &cloud, &queries, &Asked::default()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((processed.places.len(), processed.summary.invalid), (600, Some(0)));
    assert!(roughness(&processed.places, DVec3::ZERO) < 0.005);
    let apart = processed.places.iter().skip(100).zip(&processed.places).map(|(a, b)| a.distance(*b));
    assert!(apart.fold(f64::INFINITY, f64::min) > 0.01, "queries of a point lie apart");
}

#[test]
fn fluids_are_two_programs_after_another() {
    let cube = (0..1000).map(|i| DVec3::new((i % 10).into(), (i / 10 % 10).into(), (i / 100).into()) * 0.1).collect();
    let cloud = cloud(cube, &[]);
    let processed = runs("sph", &cloud, &Asked { k: 64, radius: Some(0.2), ..Asked::default() });
    assert_eq!(processed.stages.len(), 2);
    let z = &processed.column("acceleration").expect("it is an output").numbers[2];
    // In the middle, pressures cancel and gravity is left; at the top, particles are pushed out.
    assert!((z.number(555) + 9.81).abs() < 1.0, "{}", z.number(555));
    let attributes = &processed.summary.attributes;
    assert!(attributes.contains(&("density".to_owned(), "output of `sph_density`".to_owned())), "{attributes:?}");
}

#[test]
fn attributes_are_bound_by_name() {
    let points = sphere(100, DVec3::ZERO, 0.0);
    let text = ".program heat\n.setting gain: float\n.neighbor heat: float\n.neighbor wind: float3\n.neighbor kind: int\n\
                .kernel\nheated = mul neighbor.heat, gain\naccumulate warm, heated\naccumulate blown, neighbor.wind\n\
                accumulate kinds, neighbor.kind\n.final\noutput warm, warm\noutput blown, blown\noutput kinds, kinds\n";
    let operation = Operation::parse("heat.pasm", text).unwrap_or_else(|error| panic!("{error}"));
    let column = |value: f64| vec![value; 100];
    let columns =
        [("heat", column(2.0)), ("wx", column(1.0)), ("wy", column(0.5)), ("wz", column(-1.0)), ("kind", column(3.0))];
    let asked = Asked { k: 4, settings: given(&[("gain", &[3.0])]), ..Asked::default() };
    let cloud = cloud(points, &columns);
    let processed = run(&operation, &cloud, &all(&cloud), &asked).unwrap_or_else(|error| panic!("{error}"));
    let of = |name: &str| -> Vec<f64> {
        processed.column(name).expect("it is an output").numbers.iter().map(|numbers| numbers.number(50)).collect()
    };
    assert_eq!((of("warm"), of("blown"), of("kinds")), (vec![24.0], vec![4.0, 2.0, -4.0], vec![12.0]));
    let attributes = given(&[("wind", &[0.0; 3])]);
    let asked = Asked { attributes, settings: asked.settings, ..Asked::default() };
    let still = run(&operation, &cloud, &all(&cloud), &asked).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(still.column("blown").expect("it is an output").numbers[0].number(0), 0.0, "what is given goes first");
    let message = run(&operation, &cloud, &all(&cloud), &Asked::default()).expect_err("no gain").to_string();
    assert!(message.contains("setting `gain` of `heat`") && message.contains("--set gain=NUMBER"), "{message}");
}

#[test]
fn what_does_not_suit_is_named() {
    let points = || sphere(100, DVec3::ZERO, 0.0);
    let plain = cloud(points(), &[]);
    let with = |settings: Given, attributes: Given| Asked { settings, attributes, ..Asked::default() };
    let setting = |name: &str, values: &[f64]| with(given(&[(name, values)]), Given::new());
    let attribute = |name: &str, values: &[f64]| with(Given::new(), given(&[(name, values)]));
    fails("mls", &plain, &setting("speed", &[1.0]), &["`mls` has no setting `speed`", "tolerance (float)"]);
    fails("mls", &plain, &setting("tolerance", &[1.0, 2.0]), &["`tolerance`", "has 2 numbers: expected 1 for a float"]);
    fails("mls", &plain, &setting("tolerance", &[f64::NAN]), &["`tolerance`", "is NaN", "finite"]);
    fails("smooth", &plain, &attribute("weight", &[1.0]), &["`smooth` reads no field `weight`", "area (float)"]);
    fails("smooth", &plain, &attribute("normal", &[1.0]), &["`normal`", "expected 3 for a float3"]);
    let mut areas = vec![0.5; 100];
    areas[7] = f64::NAN;
    let holed = cloud(points(), &[("area", areas)]);
    fails("smooth", &holed, &Asked::default(), &["test: area of vertex 7 is NaN", "--attribute area="]);
    fails("mls", &plain, &Asked { k: 0, ..Asked::default() }, &["k is 0: expected 1 to 64"]);
    fails("mls", &plain, &Asked { radius: Some(-1.0), ..Asked::default() }, &["radius is -1e0: expected a positive"]);
    fails("normals", &plain, &Asked { passes: 2, ..Asked::default() }, &["2 passes of `normals`", "moves points"]);
    let same = cloud(vec![DVec3::ONE; 500], &[]);
    fails("mls", &same, &Asked::default(), &["all points lie in one place", "give --radius"]);
    let message = Operation::named("smoothe").expect_err("there is none").to_string();
    assert!(message.contains("no operation `smoothe`") && message.contains("resample"), "{message}");
}

/// One point, five hundred in one place, fewer than are asked for: nothing panics, and what has no surface says so.
#[test]
fn points_without_a_surface_stay_where_they_are() {
    for points in [vec![DVec3::new(1.0, 2.0, 3.0)], vec![DVec3::new(1e6, 2.0, 3.0); 500]] {
        let cloud = cloud(points, &[]);
        for name in ["normals", "covariance", "mls", "apss", "smooth"] {
            let processed = runs(name, &cloud, &Asked { k: 64, radius: Some(1.0), ..Asked::default() });
            assert_eq!(processed.places, cloud.points().given(), "{name}");
            let is_valid = processed.summary.invalid == Some(0);
            assert!(!is_valid || name == "smooth", "{name}: there is no direction");
        }
    }
    let few = cloud(sphere(20, DVec3::ZERO, 0.0), &[]);
    let processed = runs("normals", &few, &Asked { k: 64, ..Asked::default() });
    assert_eq!(processed.summary.neighbors, Some(20 * 20), "all points are neighbors");
}

/// The neighbors that the search core has: nearest first, of the core's distances.
#[test]
fn points_that_tie_come_in_the_order_of_the_set() {
    let mut points = vec![DVec3::ZERO; 100];
    points.push(DVec3::X);
    let cloud = cloud(points, &[]);
    let neighborhoods = Neighborhoods::new(cloud.points(), 4, None).unwrap_or_else(|error| panic!("{error}"));
    let position = |index: usize| cloud.points().encoded()[index];
    assert_eq!(neighborhoods.of(position(50)), [0, 1, 2, 3]);
    assert_eq!(neighborhoods.of(position(100)), [100, 0, 1, 2]);
}

#[test]
fn neighborhoods_are_those_of_a_search_through_all_points() {
    let points = cloud(trefoil(2000), &[]);
    let encoded = points.points().encoded();
    for (k, radius) in [(1, None), (16, None), (64, Some(0.2_f64)), (5, Some(0.2))] {
        let neighborhoods = Neighborhoods::new(points.points(), k, radius).unwrap_or_else(|error| panic!("{error}"));
        let radius2 = radius.map_or(f32::INFINITY, |radius| radius as f32 * radius as f32).to_bits();
        for query in (0..2000).step_by(50) {
            let format = points.points().format();
            let expected =
                pointcore_golden::reference::neighbors::nearest(format, &encoded, encoded[query], k as usize, radius2);
            let expected: Vec<u32> = expected.iter().map(|neighbor| neighbor.index as u32).collect();
            assert_eq!(neighborhoods.of(encoded[query]), expected, "k = {k}, radius {radius:?}");
        }
    }
    assert!(Neighborhoods::new(points.points(), 3, None).is_ok_and(|near| near.of([f32::NAN.to_bits(); 3]).is_empty()));
}

/// Outputs are within their bounds, and a fault in any of them is found.
#[test]
fn comparisons_find_what_is_off() {
    let cloud = cloud(sphere(300, DVec3::new(3.0, 0.0, 0.0), 0.02), &[]);
    for name in Operation::names().into_iter().filter(|name| *name != "resample") {
        let processed = runs(name, &cloud, &Asked::default());
        let compared = check::compare(&processed.stages).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(check::within_bounds(&compared), Ok(()), "{name}");
        assert!(compared.iter().all(|comparison| comparison.compared >= 290), "{name}: {compared:?}");
        for comparison in compared {
            let (program, output) = comparison.output.split_once('.').expect("a program and its output");
            let mut stages = processed.stages.clone();
            let stage = stages.iter_mut().find(|stage| stage.program.name() == program).expect("it has run");
            let place = stage.program.outputs.find(output).expect("it is an output");
            let answer = &mut stage.answers[17].outputs[place.first..place.first + place.ty.words()];
            let word = answer.iter_mut().max_by(|a, b| (**a << 1).cmp(&(**b << 1))).expect("it has a word");
            *word = if output == "valid" { 1 - *word } else { (f32::from_bits(*word) * 1.5 + 0.1).to_bits() };
            let compared = check::compare(&stages).unwrap_or_else(|error| panic!("{name}: {error}"));
            let found = check::within_bounds(&compared);
            assert!(matches!(found, Err(check::Uncompared::Violation(_))), "{name}: a fault in {output} is not found");
        }
    }
    let same = Cloud::of(Format::F32, "same".to_owned(), vec![DVec3::ONE; 9], BTreeMap::new());
    let same = same.unwrap_or_else(|error| panic!("{error}"));
    let nothing = runs("normals", &same, &Asked { radius: Some(1.0), ..Asked::default() });
    assert_eq!(check::compare(&nothing.stages), Err(check::Uncompared::Nothing("normals".to_owned())));
}

/// Results that are withheld are found.
#[test]
fn comparisons_judge_what_is_valid() {
    let mut places = sphere(300, DVec3::new(3.0, 0.0, 0.0), 0.02);
    // One that is alone within its radius.
    places.push(DVec3::new(90.0, 0.0, 0.0));
    let cloud = cloud(places, &[]);
    for name in ["covariance", "normals", "mls", "apss"] {
        let processed = runs(name, &cloud, &Asked { radius: Some(0.5), ..Asked::default() });
        let valid = |stages: &[Stage]| {
            let compared = check::compare(stages).unwrap_or_else(|error| panic!("{name}: {error}"));
            let valid = compared.into_iter().find(|comparison| comparison.output == format!("{name}.valid"));
            valid.expect("validity is an output")
        };
        let judged = valid(&processed.stages);
        assert!(judged.compared >= 290 && judged.violations == 0, "{name}: {judged:?}");
        let mut stages = processed.stages;
        let place = stages[0].program.outputs.find("valid").expect("it is an output").first;
        for query in [17, 42] {
            stages[0].answers[query].outputs[place] = 0;
        }
        assert_eq!(valid(&stages).violations, 2, "{name}");
    }
}

#[test]
fn files_are_read_back() {
    let cloud = cloud(sphere(50, DVec3::new(1e6, 0.0, 0.0), 0.0), &[]);
    let processed = runs("mls", &cloud, &Asked::default());
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let (first, second) = (folder.path().join("points.ply"), folder.path().join("points.csv"));
    std::fs::write(&first, ply(&processed).expect("memory can be written")).expect("the folder is writable");
    std::fs::write(&second, csv(&processed)).expect("the folder is writable");
    for path in [first, second] {
        let model = crate::scene::Model::load(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(model.points, processed.places, "{}", path.display());
        assert!(model.normals.is_some_and(|normals| normals.len() == 50));
        assert_eq!(model.attributes["valid"], [1.0; 50]);
        assert_eq!(model.attributes["residual"].len(), 50);
    }
    let arrays = npy(&processed).expect("memory can be written");
    let names: Vec<&str> = arrays.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["position", "normal", "residual", "valid", "iterations", "neighbors", "capped"]);
    let positions = npyz::NpyFile::new(&arrays[0].1[..]).expect("it is an array");
    assert_eq!(positions.shape(), [50, 3]);
    let positions: Vec<f64> = positions.into_vec().expect("its numbers are doubles");
    assert_eq!(DVec3::from_slice(&positions[3..]), processed.places[1]);
}
