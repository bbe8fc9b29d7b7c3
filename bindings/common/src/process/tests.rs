//! Programs by name, file and text; attributes of all shapes; what is wrong.

use super::*;
use crate::ErrorKind;

/// A wavy sheet of 15 x 10 points.
fn sheet() -> Points {
    let place = |i: u32| [f64::from(i % 15), f64::from(i / 15), (0.4 * f64::from(i)).sin()];
    Points { places: (0..150).map(place).collect(), attributes: vec![] }
}

fn named(name: &str, values: &[f64], shape: &[usize]) -> Named {
    Named { name: name.to_owned(), values: values.to_vec(), shape: shape.to_vec() }
}

fn open(program: &str, back_end: BackEnd) -> Process {
    Process::open(ProgramSource::Said(program), None, back_end).unwrap_or_else(|error| panic!("{error}"))
}

fn message(result: Result<Results, BindingError>) -> String {
    let error = result.expect_err("something is wrong");
    assert_eq!(error.kind, ErrorKind::Input, "{error}");
    assert!(!error.message.contains("--"), "an option of the command: {error}");
    error.message
}

/// What the library gives for the same, bit by bit; by the point processor's model, too.
#[test]
fn results_are_those_of_the_library() {
    let points = sheet();
    let settings = ProcessSettings { k: Some(9), ..ProcessSettings::default() };
    let operation = Operation::named("mls").unwrap_or_else(|error| panic!("{error}"));
    let places = points.places.iter().copied().map(DVec3::from_array).collect();
    let cloud = Cloud::of(Format::F32.flushed(), "same".to_owned(), places, BTreeMap::new());
    let cloud = cloud.unwrap_or_else(|error| panic!("{error}"));
    let none = BTreeMap::new();
    let asked = Asked {
        operation: &operation,
        k: 9,
        radius: None,
        iterations: 16,
        passes: 1,
        settings: &none,
        attributes: &none,
    };
    let expected = process(&cloud, &Queries::Points((0..150).collect()), &asked, &Interpreted, &|_| ());
    let expected = Results::of(expected.unwrap_or_else(|error| panic!("{error}")));
    for (back_end, is_timed) in [(BackEnd::Interpreter, false), (BackEnd::Golden, true)] {
        let found = open("mls", back_end).run(&points, None, &settings).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((&found.outputs, &found.positions), (&expected.outputs, &expected.positions));
        assert_eq!((&found.iterations, &found.capped), (&expected.iterations, &expected.capped));
        assert_eq!(found.cycles.is_some_and(|cycles| cycles > 150), is_timed);
        assert_eq!(found.neighbors, (!is_timed).then(|| vec![9; 150]));
    }
    let normal = expected.output("normal").expect("it is an output");
    let Values::Float(numbers) = &normal.numbers else { panic!("normals are floats") };
    assert_eq!((normal.components, numbers.len()), (3, 450));
    let length2 = |normal: &[f32]| normal.iter().map(|component| component * component).sum::<f32>();
    assert!(numbers.chunks_exact(3).all(|normal| (length2(normal) - 1.0).abs() < 1e-5));
}

#[test]
fn programs_are_names_files_and_texts() {
    let text = ".program count\n.kernel\none = add 0, 1\naccumulate all, one\n.final\noutput all, all\n";
    let count = |process: &Process| {
        let settings = ProcessSettings { k: Some(5), ..ProcessSettings::default() };
        let found = process.run(&sheet(), None, &settings).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(found.output("all").map(|all| &all.numbers), Some(&Values::Int(vec![5; 150])));
    };
    count(&open(text, BackEnd::Interpreter));
    let folder = tempfile::tempdir().expect("there is room for a folder");
    let path = folder.path().join("count.pasm");
    std::fs::write(&path, text).expect("there is room for a file");
    count(&open(path.to_str().expect("the folder's name is UTF-8"), BackEnd::Interpreter));
    let renamed = folder.path().join("count");
    std::fs::rename(&path, &renamed).expect("the folder is writable");
    let opened = Process::open(ProgramSource::File(&renamed), None, BackEnd::Interpreter);
    count(&opened.unwrap_or_else(|error| panic!("{error}")));

    let fails = |program: &str, kind: ErrorKind, part: &str| {
        let opened = Process::open(ProgramSource::Said(program), None, BackEnd::Interpreter);
        let error = opened.err().expect("it is no program");
        assert!(error.kind == kind && error.message.contains(part), "`{part}` is missing in: {error}");
    };
    fails("smoothe", ErrorKind::Input, "no operation `smoothe`: expected normals, ");
    fails("no/such.pasm", ErrorKind::File, "no/such.pasm: cannot be read");
    fails(&text.replace("add 0, 1", "add 0, 1.0"), ErrorKind::Input, "program:3:");
}

#[test]
fn attributes_are_of_each_point_or_of_all() {
    let run = |attributes: Vec<Named>, queries: Option<Points>| {
        let points = Points { attributes, ..sheet() };
        let settings = ProcessSettings { radius: Some(2.5), ..ProcessSettings::default() };
        open("sph_density", BackEnd::Interpreter).run(&points, queries.as_ref(), &settings)
    };
    let density = |results: Result<Results, BindingError>| {
        let results = results.unwrap_or_else(|error| panic!("{error}"));
        results.output("density").expect("it is an output").numbers.clone()
    };
    let all = density(run(vec![named("mass", &[2.0], &[])], None));
    assert_eq!(density(run(vec![named("mass", &[2.0; 150], &[150])], None)), all);
    assert_ne!(density(run(vec![named("mass", &[1.0], &[1])], None)), all);
    let asked = density(run(vec![named("mass", &[2.0], &[])], Some(sheet())));
    assert_eq!(asked, all, "queries at the points are the points");
    for radius in [2.3, 2.7, 3.1] {
        let by = |radius| {
            let settings = ProcessSettings { radius: Some(radius), ..ProcessSettings::default() };
            density(open("sph_density", BackEnd::Interpreter).run(&sheet(), None, &settings))
        };
        assert_eq!(by(radius), by(f64::from(radius as f32)), "radii are floats, as the command's");
    }
    let nothing = Some(Points::default());
    assert_eq!(density(run(vec![], nothing)), Values::Float(vec![]));

    let velocity = message(run(vec![named("velocity", &[0.0; 450], &[150, 3])], None));
    assert!(velocity.contains("reads no field `velocity`: its fields are mass (float)"), "{velocity}");
    let wrong = message(run(vec![named("mass", &[1.0; 450], &[150, 3])], None));
    let expected = "attribute `mass` of points, a float, has shape (150, 3): expected (150,), or a number";
    assert_eq!(wrong, expected);
    let nowhere = message(run(vec![named("mass", &[f64::NAN], &[])], None));
    assert!(nowhere.contains("points: mass of vertex 0 is NaN"), "{nowhere}");
}

#[test]
fn faults_of_the_input_are_named() {
    let run = |program: &str, points: Points, queries: Option<&Points>, settings: ProcessSettings| {
        message(open(program, BackEnd::Interpreter).run(&points, queries, &settings))
    };
    let default = ProcessSettings::default;
    let check = |found: String, part: &str| assert!(found.contains(part), "`{part}` is missing in: {found}");
    check(run("mls", sheet(), None, ProcessSettings { k: Some(65), ..default() }), "k is 65: expected 1 to 64");
    check(run("mls", sheet(), None, ProcessSettings { passes: 0, ..default() }), "passes is 0");
    check(run("mls", sheet(), None, ProcessSettings { iterations: 0, ..default() }), "0 iterations");
    check(run("mls", Points::default(), None, default()), "the point set is empty");
    let speed = ProcessSettings { settings: vec![named("speed", &[1.0], &[])], ..default() };
    check(run("mls", sheet(), None, speed), "`mls` has no setting `speed`");
    let sides = |sides| ProcessSettings { pattern: Some(sides), ..default() };
    check(run("mls", sheet(), None, sides([2, 2])), "carry no offsets");
    check(run("resample", sheet(), None, sides([2, 65])), "the pattern is [2, 65]");
    check(run("resample", sheet(), Some(&sheet()), sides([2, 2])), "both given");
    check(run("resample", sheet(), Some(&sheet()), default()), "expected an attribute `u`");
    check(run("sph", sheet(), Some(&sheet()), default()), "expected no other queries");
    let place = Points { places: vec![[1.0; 3]; 9], attributes: vec![] };
    check(run("mls", place, None, default()), "expected a radius");
    let gain = ".program gain\n.setting gain: float\n.kernel\naccumulate all, gain\n.final\noutput all, all\n";
    check(run(gain, sheet(), None, default()), "setting `gain` of `gain` does not follow from the points");
    let configured = |configuration, back_end| {
        let opened = Process::open(ProgramSource::Said("mls"), Some(configuration), back_end);
        opened.err().expect("it does not suit").message
    };
    check(configured("kind = \"points\"", BackEnd::Interpreter), "knows no hardware");
    check(configured("kind = \"search\"", BackEnd::Golden), "is not for the point processor");
}
