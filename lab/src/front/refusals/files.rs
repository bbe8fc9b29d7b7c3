//! Models that are missing, empty, of another kind, or whose text is wrong.

use super::{File, Rows};

pub(super) const ROWS: Rows = &[
    // Missing, or no file.
    ("run gone.ply", "gone.ply", "cannot be read"),
    ("inspect gone.laz", "gone.laz", "cannot be read"),
    ("knn --points gone.pcd", "gone.pcd", "cannot be read"),
    ("run folder.ply", "folder.ply", "is a directory"),
    ("inspect folder.ply", "folder.ply", "Is a directory"),
    ("knn --points folder", "folder", "must end in .ply"),
    ("knn --points surface:100 --queries gone.xyz", "gone.xyz", "cannot be read"),
    // Empty.
    ("run empty.ply", "empty.ply", "not a PLY header"),
    ("run empty.obj", "empty.obj", "a model needs at least one"),
    ("run empty.gltf", "empty.gltf", "not a glTF file"),
    ("run empty.glb", "empty.glb", "not a glTF file"),
    ("run empty.pcd", "empty.pcd", "not a PCD file"),
    ("run empty.las", "empty.las", "not a LAS or LAZ file"),
    ("run empty.laz", "empty.laz", "not a LAS or LAZ file"),
    ("run empty.xyz", "empty.xyz", "a model needs at least one"),
    ("knn --points empty.csv", "empty.csv", "a model needs at least one"),
    ("inspect names-alone.csv", "names-alone.csv", "a model needs at least one"),
    // Of another kind.
    ("run model.stl", "model.stl: is no scene", "must end in .ply"),
    ("inspect good.toml", "good.toml", "must end in .ply"),
    ("knn --points good.toml", "good.toml", "must end in .ply"),
    ("run prose.ply", "prose.ply", "not a PLY header"),
    ("run prose.xyz", "prose.xyz: line 1", "`Dear reader` is not a number"),
    ("run prose.pcd", "prose.pcd", "not a PCD file"),
    ("run prose.glb", "prose.glb", "not a glTF file"),
    ("run prose.las", "prose.las", "not a LAS or LAZ file"),
    ("run prose.obj", "prose.obj", "a model needs at least one"),
    // PLY.
    ("run no-vertex.ply", "no-vertex.ply", "no element `vertex`"),
    ("run no-z.ply", "no-z.ply", "no property `z`"),
    ("run twice.ply", "twice.ply: line 6", "declares property `x` twice"),
    ("run misspelt.ply", "misspelt.ply: not a PLY header: line 4", "property flaot x"),
    ("run version.ply", "version.ply", "expected 1.0"),
    ("run list.ply", "list.ply", "`x`"),
    ("run word.ply", "word.ply: element `vertex`: line 11", "`one` is not a number"),
    ("run short-line.ply", "short-line.ply: element `vertex`: line 11", "too few numbers"),
    ("run long-line.ply", "long-line.ply: element `vertex`: line 11", "too many numbers"),
    ("run stray-face.ply", "stray-face.ply: triangle 0", "there are only 3"),
    ("run negative-face.ply", "negative-face.ply: face 0", "-7 is not the index of a vertex"),
    // OBJ.
    ("run short.obj", "short.obj: line 2", "three numbers expected"),
    ("run word.obj", "word.obj: line 2", "`one` is not a number"),
    ("run stray-face.obj", "stray-face.obj: line 4", "`9` is not among the 3"),
    ("run zero-face.obj", "zero-face.obj: line 4", "`0` is not among the 3"),
    // Columns.
    ("run two-columns.xyz", "two-columns.xyz: line 1", "three numbers expected"),
    ("run word.csv", "word.csv: line 3", "`one` is not a number"),
    ("run ragged.xyz", "ragged.xyz: line 2", "3 numbers expected"),
    ("run wide.xyz", "wide.xyz", "UTF-8"),
    // Numbers that are none.
    ("run nan.xyz --set object.0.drop_invalid=false", "nan.xyz: vertex 1", "`drop_invalid = true`"),
    ("run infinite.xyz --set object.0.drop_invalid=false", "infinite.xyz: vertex 1", "must be finite and below 1e9"),
    ("run far.xyz --set object.0.drop_invalid=false", "far.xyz: vertex 1", "must be finite and below 1e9"),
    ("run all-nan.xyz", "all-nan.xyz", "besides 2 that are no numbers"),
    ("inspect all-nan.xyz", "all-nan.xyz", "besides 2 that are no numbers"),
    ("knn --points nan.xyz", "nan.xyz: vertex 1", "--drop-invalid"),
    ("knn --points far.xyz", "far.xyz: vertex 1", "--drop-invalid"),
    ("knn --points all-nan.xyz --drop-invalid", "all-nan.xyz", "a model needs at least one"),
    ("knn --points surface:100 --queries nan.xyz", "nan.xyz: vertex 1", "--drop-invalid"),
    ("accuracy --neighbors nan.xyz", "nan.xyz: vertex 1", "must be finite"),
    ("vectors --points nan.xyz -o out", "nan.xyz: vertex 1", "must be finite"),
    // Normals that are asked for.
    ("run good.xyz --set object.0.normals=file", "good.xyz", "`normals = \"estimate\"`"),
    (
        "run no-normals.ply --set object.0.normals=file",
        "no-normals.ply: all normals are zero",
        "`normals = \"estimate\"`",
    ),
    ("run good.xyz --set object.0.orient=viewpoint", "good.xyz", "`viewpoint = [x, y, z]`"),
];

/// A PLY file of three points and a face, with something in it replaced.
fn ply(from: &str, to: &str) -> Vec<u8> {
    let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    let text = format!("{header}{faces}0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert!(text.contains(from), "nothing is replaced");
    text.replacen(from, to, 1).into_bytes()
}

pub(super) fn files() -> Vec<File> {
    let text = |text: &str| text.as_bytes().to_vec();
    let wide = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let mut files = Vec::new();
    for name in [
        "empty.ply",
        "empty.obj",
        "empty.gltf",
        "empty.glb",
        "empty.pcd",
        "empty.las",
        "empty.laz",
        "empty.xyz",
        "empty.csv",
    ] {
        files.push((name, Vec::new()));
    }
    for name in ["prose.ply", "prose.xyz", "prose.pcd", "prose.glb", "prose.las", "prose.obj"] {
        files.push((name, text("Dear reader,\nthis is no model.\n")));
    }
    files.extend([
        ("good.xyz", text("0 0 0\n1 0 0\n0 1 0\n1 1 0\n")),
        ("names-alone.csv", text("x,y,z\n")),
        ("model.stl", text("solid\nendsolid\n")),
        ("no-vertex.ply", ply("element vertex", "element point")),
        ("no-z.ply", ply("property float z", "property float w")),
        ("twice.ply", ply("property float z\n", "property float x\n")),
        ("misspelt.ply", ply("property float x", "property flaot x")),
        ("version.ply", ply("1.0", "2.0")),
        ("list.ply", ply("property float x", "property list uchar float x")),
        ("word.ply", ply("\n1 0 0\n", "\n1 one 0\n")),
        ("short-line.ply", ply("\n1 0 0\n", "\n1 0\n")),
        ("long-line.ply", ply("\n1 0 0\n", "\n1 0 0 0\n")),
        ("stray-face.ply", ply("3 0 1 2", "3 0 1 9")),
        ("negative-face.ply", ply("3 0 1 2", "3 0 1 -7")),
        ("short.obj", text("v 0 0 0\nv 1 0\n")),
        ("word.obj", text("v 0 0 0\nv 1 one 0\n")),
        ("stray-face.obj", text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")),
        ("zero-face.obj", text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n")),
        ("two-columns.xyz", text("1 2\n3 4\n")),
        ("word.csv", text("x,y,z\n1,2,3\n1,one,3\n")),
        ("ragged.xyz", text("1 2 3\n4 5\n")),
        ("wide.xyz", wide("1 2 3\n4 5 6\n")),
        ("nan.xyz", text("0 0 0\nnan 0 0\n0 1 0\n1 1 1\n")),
        ("infinite.xyz", text("0 0 0\ninf 0 0\n0 1 0\n")),
        ("far.xyz", text("0 0 0\n1e300 0 0\n0 1 0\n")),
        ("all-nan.xyz", text("nan 0 0\n0 nan 0\n")),
        (
            "no-normals.ply",
            text("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n\
                  property float ny\nproperty float nz\nend_header\n0 0 0 0 0 0\n1 0 0 0 0 0\n"),
        ),
    ]);
    files
}
