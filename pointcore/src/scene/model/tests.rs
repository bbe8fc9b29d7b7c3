use super::*;
use pointcore_tb::skipped::skipped;
use std::path::PathBuf;

const TRIANGLE_HEADER: &str = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n";

/// Loads a file of the given name and content.
fn load(name: &str, content: &[u8]) -> Result<Model, SceneError> {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = folder.path().join(name);
    std::fs::write(&path, content).expect("the folder is writable");
    Model::load(&path)
}

fn ascii_ply(rest: &str) -> Vec<u8> {
    format!("ply\nformat ascii 1.0\n{rest}").into_bytes()
}

/// Asserts that loading fails with a message that holds all of `parts`.
fn assert_fails(name: &str, content: &[u8], parts: &[&str]) {
    let message = load(name, content).expect_err("the file is bad").to_string();
    for part in parts.iter().chain(&[name]) {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

/// A model of the shared data; `None`, visibly, where it is not present.
pub(crate) fn shared(name: &str) -> Option<(PathBuf, Model)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(name);
    if !path.exists() {
        skipped(&format!("there is no file {}", path.display()));
        return None;
    }
    let model = Model::load(&path).unwrap_or_else(|error| panic!("{error}"));
    Some((path, model))
}

#[test]
fn ascii_ply_may_order_its_properties_freely_and_hold_others() {
    let text = "comment two points, then a foreign element\nelement vertex 2\nproperty uchar red\nproperty double z\n\
                property float quality\nproperty uchar green\nproperty uchar blue\nproperty float y\nproperty int x\n\
                property float ny\nproperty float nx\nproperty float nz\nelement camera 1\nproperty list uchar float m\n\
                end_header\n255 3.5 0.1 0 0 2 1 0 1 0\n0 -3.5 0.1 0 255 -2 -1 0 0 -2e0\n2 1.0 2.0\n";
    let model = load("points.ply", &ascii_ply(text)).expect("the file is good");
    assert_eq!(model.points, [DVec3::new(1.0, 2.0, 3.5), DVec3::new(-1.0, -2.0, -3.5)]);
    assert_eq!(model.normals, Some(vec![DVec3::X, DVec3::new(0.0, 0.0, -2.0)]));
    assert_eq!(model.colors, Some(vec![[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]));
    let (normals, origin) = model.unit_normals(NormalSource::Auto).expect("normals are given");
    assert_eq!((normals[1], origin), (DVec3::NEG_Z, NormalOrigin::Vertices));
}

#[test]
fn binary_ply_of_both_byte_orders_reads_alike() {
    let values = [0.0_f32, 0.5, 1.0, 2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 2.0, 2.0, 0.0];
    let strip = [6_i32, 0, 1, 2, 3, -1, 0];
    let header = |order| {
        format!(
            "ply\nformat binary_{order}_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        )
    };
    let mut little = header("little").into_bytes();
    little.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    little.extend(strip.iter().flat_map(|value| value.to_le_bytes()));
    let mut big = header("big").into_bytes();
    big.extend(values.iter().flat_map(|value| value.to_be_bytes()));
    big.extend(strip.iter().flat_map(|value| value.to_be_bytes()));
    let model = load("little.ply", &little).expect("the file is good");
    assert_eq!(model.points[0], DVec3::new(0.0, 0.5, 1.0));
    assert_eq!(model.triangles, [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(load("big.ply", &big).expect("the file is good"), model);
    assert_fails("short.ply", &little[..little.len() - 30], &["vertex", "truncated"]);
    assert_fails("strip.ply", &little[..little.len() - 5], &["tristrips", "ends too soon"]);
}

#[test]
fn ply_faces_give_outward_normals() {
    let text = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n\
                property list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    let model = load("quad.ply", &ascii_ply(text)).expect("the file is good");
    assert_eq!(model.triangles, [[0, 1, 2], [0, 2, 3]]);
    let (normals, origin) = model.unit_normals(NormalSource::File).expect("faces are given");
    assert_eq!((normals, origin), (vec![DVec3::Z; 4], NormalOrigin::Faces));
}

#[test]
fn bad_ply_files_are_named_with_their_fault() {
    assert_fails("empty.ply", b"", &["not a PLY header"]);
    assert_fails("binary.ply", &[0xff, 0xfe, 0x00, 0x80], &["not a PLY header"]);
    assert_fails("cut.ply", &ascii_ply("element vertex 3\n"), &["header", "end_header"]);
    assert_fails(
        "none.ply",
        &ascii_ply("element vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n"),
        &["no vertex"],
    );
    assert_fails(
        "flat.ply",
        &ascii_ply("element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n"),
        &["property `z`"],
    );
    assert_fails(
        "faces.ply",
        &ascii_ply("element face 1\nproperty list uchar int vertex_indices\nend_header\n1 0\n"),
        &["element `vertex`"],
    );
    assert_fails(
        "few.ply",
        &ascii_ply(&format!("{TRIANGLE_HEADER}0.000000 0.000000 0.000000\n")),
        &["vertex", "expected 3, got 1"],
    );
    assert_fails("word.ply", &ascii_ply(&format!("{TRIANGLE_HEADER}0 0 0\n0 x 0\n1 1 1\n")), &["line 9"]);
    let huge = TRIANGLE_HEADER.replace(" 3", " 4000000000000");
    assert_fails("huge.ply", &ascii_ply(&huge), &["4000000000000 elements `vertex`", "truncated"]);
    let overflow = TRIANGLE_HEADER.replace(" 3", " 99999999999999999999");
    assert_fails("overflow.ply", &ascii_ply(&overflow), &["Invalid element"]);
    assert_fails("void.ply", &ascii_ply("element vertex 1000000000000\nend_header\n"), &["without a property"]);
    let face = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n\
                property list uchar int vertex_indices\nend_header\n0 0 0\n";
    assert_fails("stray.ply", &ascii_ply(&format!("{face}3 0 0 7\n")), &["triangle 0", "only 1"]);
    assert_fails("negative.ply", &ascii_ply(&format!("{face}3 0 0 -2\n")), &["face 0", "-2"]);
}

#[test]
fn coordinates_must_be_usable_numbers() {
    let file = |value: f32| {
        let mut bytes = b"ply\nformat binary_little_endian 1.0\n".to_vec();
        bytes.extend(TRIANGLE_HEADER.bytes());
        bytes.extend([0.0, 0.0, 0.0, 0.0, value, 0.0, 1.0, 0.0, 0.0_f32].iter().flat_map(|value| value.to_le_bytes()));
        bytes
    };
    assert!(load("good.ply", &file(1.0)).is_ok());
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30] {
        assert_fails("bad.ply", &file(value), &["vertex 1", "finite"]);
    }
}

#[test]
fn ascii_ply_takes_numbers_as_programs_write_them() {
    let text = format!("{TRIANGLE_HEADER}.5 -.5 1e5\n\n+1. 2E-3 0\nnan 0 -inf\n");
    assert_fails("scan.ply", &ascii_ply(&text), &["vertex 2", "finite", "must be finite"]);
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = folder.path().join("scan.ply");
    std::fs::write(&path, ascii_ply(&text)).expect("the folder is writable");
    let model = Model::load_with(&path, InvalidPoints::Drop).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(model.points, [DVec3::new(0.5, -0.5, 1e5), DVec3::new(1.0, 2e-3, 0.0)]);
    assert_eq!(model.dropped.len(), 1);
}

#[test]
fn what_hangs_on_dropped_points_goes_with_them() {
    let text = "v nan 0 0 1 0 0\nv 0 0 0 0 1 0\nv 1 0 0 0 0 1\nv 0 1 0 1 1 1\nf 1 2 3\nf 2 3 4\n";
    let model = obj::parse(text.as_bytes())
        .expect("the file is good")
        .without_invalid()
        .consistent()
        .expect("what is left is good");
    assert_eq!((model.points.len(), model.dropped.len(), &model.triangles[..]), (3, 1, &[[0, 1, 2]][..]));
    assert_eq!(model.colors.map(|colors| colors[0]), Some([0.0, 1.0, 0.0]));
    let nothing = obj::parse(b"v nan 0 0\n").expect("the file is good").without_invalid().consistent();
    assert!(nothing.is_err_and(|problem| problem.contains("besides 1")));
}

#[test]
fn colors_of_ply_may_have_other_names_and_widths() {
    let text = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty ushort diffuse_red\n\
                property ushort diffuse_green\nproperty ushort diffuse_blue\nend_header\n0 0 0 65535 0 0\n";
    assert_eq!(load("wide.ply", &ascii_ply(text)).expect("good").colors, Some(vec![[1.0, 0.0, 0.0]]));
}

#[test]
fn obj_reads_colors_behind_coordinates() {
    let colors = |text: &str| load("colors.obj", text.as_bytes()).expect("good").colors;
    let expected = Some(vec![[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(colors("v 0 0 0 1 0 0\nv 1 0 0 0 0 1\n"), expected);
    assert_eq!(colors("v 0 0 0 255 0 0\nv 1 0 0 0 0 255\n"), expected, "bytes");
    assert_eq!(colors("v 0 0 0 1.0\nv 1 0 0 1.0\n"), None, "a weight");
    assert_eq!(colors("v 0 0 0 1 0 0\nv 1 0 0\n"), None, "not all have one");
}

#[test]
fn obj_reads_points_normals_and_faces() {
    let cloud =
        load("cloud.obj", b"# no faces\nv 1 2 3\nv -1 -2 -3 # trailing\r\nvn 0 0 1\nvn 0 2 0\ng part\n").expect("good");
    assert_eq!(cloud.points, [DVec3::new(1.0, 2.0, 3.0), DVec3::new(-1.0, -2.0, -3.0)]);
    assert_eq!(cloud.normals, Some(vec![DVec3::Z, DVec3::new(0.0, 2.0, 0.0)]));
    let faces = load("faces.obj", b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/5 2/5 3/5 -1/5\n").expect("good");
    assert_eq!((faces.triangles, faces.normals), (vec![[0, 1, 2], [0, 2, 3]], None));
    let shaded = load("shaded.obj", b"v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 1 0\nf 1//1 2//1 3//-1\n").expect("good");
    assert_eq!(shaded.normals, Some(vec![DVec3::Y; 3]));
}

#[test]
fn obj_comments_may_be_in_any_encoding() {
    assert_eq!(load("latin.obj", b"v 1 2 3 # caf\xe9\n").expect("good").points, [DVec3::new(1.0, 2.0, 3.0)]);
}

#[test]
fn ply_errors_take_one_line() {
    let vertices = |rest: &str| ascii_ply(&format!("{TRIANGLE_HEADER}{rest}"));
    for (content, parts) in [
        (vertices("0 0 0\n0 1,5 0\n0 0 0\n"), ["line 9", "0 1,5 0"]),
        (vertices("0 0 0\n0.000000 1.000000\n0 0 0\n"), ["line 9", "0.000000 1.000000"]),
        (ascii_ply("element vertex -1\n"), ["line 3", "element vertex -1"]),
        (ascii_ply("element vertex 1\nproperty quaternion x\n"), ["line 4", "property quaternion x"]),
        (b"hello\n".to_vec(), ["line 1", "hello"]),
    ] {
        assert_fails("bad.ply", &content, &parts);
        let message = load("bad.ply", &content).expect_err("the file is bad").to_string();
        assert_eq!(message.lines().count(), 1, "{message}");
    }
}

#[test]
fn ply_headers_that_could_be_misread_are_refused() {
    let doubled =
        "element vertex 1\nproperty float x\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    assert_fails("property.ply", &ascii_ply(&format!("{doubled}1 1 2 3\n")), &["line 5", "property `x`"]);
    let header = TRIANGLE_HEADER.replace("end_header\n", "");
    assert_fails("element.ply", &ascii_ply(&format!("{header}{TRIANGLE_HEADER}")), &["line 7", "element `vertex`"]);
    let version = format!("ply\nformat ascii 9.0\n{TRIANGLE_HEADER}0 0 0\n0 0 0\n0 0 0\n");
    assert_fails("version.ply", version.as_bytes(), &["9.0", "1.0"]);
}

#[test]
fn bad_obj_files_are_named_with_their_line() {
    assert_fails("empty.obj", b"", &["no vertex"]);
    assert_fails("two.obj", b"v 1 2 3\nv 1 2\n", &["line 2", "three numbers"]);
    assert_fails("word.obj", b"v 1 two 3\n", &["line 1", "`two`"]);
    assert_fails("nan.obj", b"v 0 0 0\nv 0 nan 0\n", &["vertex 1", "finite"]);
    assert_fails("face.obj", b"v 0 0 0\n\nf 1 2 3\n", &["line 3", "vertex 2"]);
    assert_fails("zero.obj", b"v 0 0 0\nf 0 0 0\n", &["line 2", "vertex 0"]);
    assert_fails("corner.obj", b"v 0 0 0\nf 1//7 a b\n", &["line 2", "normal 7"]);
}

#[test]
fn other_files_are_refused() {
    assert_fails("scan.stl", b"solid", &[".ply, .obj", "or .pts"]);
    assert!(Model::is_model(Path::new("a.LAZ")) && !Model::is_model(Path::new("a.toml")));
    let message = Model::load(Path::new("missing.ply")).expect_err("there is no such file").to_string();
    assert!(message.contains("missing.ply") && message.contains("cannot be read"), "{message}");
}

#[test]
fn missing_normals_are_asked_for_in_vain() {
    let model = load("cloud.obj", b"v 0 0 0\nv 1 0 0\n").expect("the file is good");
    assert!(model.unit_normals(NormalSource::File).is_err_and(|problem| problem.contains("estimate")));
    assert!(model.unit_normals(NormalSource::Auto).is_err_and(|problem| problem.contains("3")));
}

#[test]
fn the_shared_scans_have_outward_normals_by_faces_and_by_estimation() {
    // Estimation rounds off creases and loses its way in folds; what must agree is all but a few points.
    const AGREEING_SHARE: f64 = 0.99;
    for (name, points) in [("igea.ply", 134_345), ("stanford-bunny.obj", 35_947)] {
        let Some((_, model)) = shared(name) else { continue };
        assert_eq!(model.points.len(), points, "{name}");
        let (by_faces, origin) = model.unit_normals(NormalSource::Auto).expect("the scan has faces");
        assert_eq!(origin, NormalOrigin::Faces);
        let (estimated, _) = model.unit_normals(NormalSource::Estimate).expect("the scan has points enough");
        let agreeing = by_faces.iter().zip(&estimated).filter(|(a, b)| a.dot(**b) > 0.0).count();
        let outward = outward_share(&model.points, &by_faces);
        println!("{name}: {agreeing} of {points} agree, {outward:.3} point away from the centroid");
        assert!(agreeing as f64 > AGREEING_SHARE * points as f64, "{name}: {agreeing} of {points} agree");
        assert!(outward > 0.75, "{name}: {outward}");
    }
    if let Some((_, model)) = shared("dragon.ply") {
        let (normals, origin) = model.unit_normals(NormalSource::Auto).expect("the scan has points enough");
        assert_eq!((model.points.len(), origin), (39_994, NormalOrigin::Estimated));
        let outward = outward_share(&model.points, &normals);
        println!("dragon.ply: {outward:.3} point away from the centroid");
        assert!(outward > 0.6, "{outward}");
    }
}

/// The share of normals that point away from the points' centroid.
fn outward_share(points: &[DVec3], normals: &[DVec3]) -> f64 {
    let centroid = points.iter().sum::<DVec3>() / points.len() as f64;
    let outward = points.iter().zip(normals).filter(|(point, normal)| normal.dot(**point - centroid) > 0.0);
    outward.count() as f64 / points.len() as f64
}
