//! Models that end too soon, or whose headers promise what is not there.

use super::{File, Rows};
use crate::front::files::{self, Ply};
use crate::front::shapes::{self, Shape};
use glam::DVec3;

pub(super) const ROWS: Rows = &[
    // The header ends too soon.
    ("run cut-header.ply", "cut-header.ply", "not a PLY header"),
    ("run cut-header.pcd", "cut-header.pcd", "not a PCD file"),
    ("run cut-header.las", "cut-header.las", "not a LAS or LAZ file"),
    ("run cut-header.laz", "cut-header.laz", "not a LAS or LAZ file"),
    ("run cut-header.glb", "cut-header.glb", "not a glTF file"),
    ("run cut-header.gltf", "cut-header.gltf", "not a glTF file"),
    // The body does.
    ("run cut-ascii.ply", "cut-ascii.ply: element `face`", "the file is truncated or its header wrong"),
    ("run cut-little.ply", "cut-little.ply", "the file is truncated or its header wrong"),
    ("run cut-big.ply", "cut-big.ply", "the file is truncated or its header wrong"),
    ("run cut-text.pcd", "cut-text.pcd", "the file is truncated or its header wrong"),
    ("run cut-binary.pcd", "cut-binary.pcd", "the file is truncated or its header wrong"),
    ("run cut.las", "cut.las", "truncated"),
    ("run cut.laz", "cut.laz", "truncated"),
    ("run cut.glb", "cut.glb", "not a glTF file"),
    ("run cut-buffer.gltf", "cut-buffer.gltf", "not a glTF file"),
    ("inspect cut-big.ply", "cut-big.ply", "truncated"),
    ("knn --points cut-little.ply", "cut-little.ply", "truncated"),
    ("knn --points cut.laz", "cut.laz", "truncated"),
    // Counts that lie.
    ("run many.ply", "many.ply: the header declares 1000000000000000000 elements `vertex`", "only"),
    ("run many-binary.ply", "many-binary.ply: the header declares 4000000000 elements `vertex`", "only"),
    ("run countless.ply", "countless.ply: not a PLY header: line 4", "element vertex many"),
    ("run negative.ply", "negative.ply: not a PLY header: line 4", "element vertex -8"),
    ("run many.pcd", "many.pcd: the header declares 4000000000 points", "truncated or its header wrong"),
    ("run many.las", "many.las", "truncated or its header wrong"),
    ("run many-views.glb", "many-views.glb", "promises 99 values"),
    ("run list.pcd", "list.pcd", "`x`, `y` and `z`"),
    ("run long-list.ply", "long-list.ply: element `face`: line", "too few numbers"),
    ("run no-buffer.gltf", "no-buffer.gltf", "gone.bin"),
    ("run no-number.pcd", "no-number.pcd", "not a PCD file"),
];

/// Where LAS counts its points, and how many bytes a header has at least.
const LAS_COUNT: std::ops::Range<usize> = 107..111;
/// Bytes that are left of a header.
const HEADER_CUT: usize = 100;
/// A count that no file here has.
const MANY: u32 = 4_000_000_000;

fn shape() -> Shape {
    shapes::cube(1).single()
}

fn cut(bytes: &[u8], share: f64) -> Vec<u8> {
    bytes[..(bytes.len() as f64 * share) as usize].to_vec()
}

/// Replaces text in a file that may be binary besides.
fn replaced(bytes: &[u8], from: &str, to: &str) -> Vec<u8> {
    let place = bytes.windows(from.len()).position(|window| window == from.as_bytes());
    let place = place.unwrap_or_else(|| panic!("`{from}` is in the file that is to be damaged"));
    [&bytes[..place], to.as_bytes(), &bytes[place + from.len()..]].concat()
}

pub(super) fn files() -> Vec<File> {
    let (shape, hills) = (shape(), shapes::terrain(12, 0.1));
    let [ascii, little, big] = [Ply::Ascii, Ply::Little, Ply::Big].map(|kind| files::ply(&shape, kind));
    let [glb, gltf] = [files::glb, files::gltf].map(|write| write(&shape, 1.0, DVec3::ZERO));
    let [text, binary] = [files::pcd, files::pcd_binary].map(|write| write(&hills));
    let [las, laz] = [false, true].map(|is_compressed| files::las(&hills, is_compressed));
    let mut many_las = las.clone();
    many_las[LAS_COUNT].copy_from_slice(&MANY.to_le_bytes());
    vec![
        ("cut-header.ply", cut(&ascii, 0.2)),
        ("cut-header.pcd", text[..HEADER_CUT].to_vec()),
        ("cut-header.las", las[..HEADER_CUT].to_vec()),
        ("cut-header.laz", laz[..HEADER_CUT].to_vec()),
        ("cut-header.glb", cut(&glb, 0.2)),
        ("cut-header.gltf", cut(&gltf, 0.2)),
        ("cut-ascii.ply", ascii[..ascii.len() - 16].to_vec()),
        ("cut-little.ply", cut(&little, 0.8)),
        ("cut-big.ply", cut(&big, 0.8)),
        ("cut-text.pcd", cut(&text, 0.7)),
        ("cut-binary.pcd", cut(&binary, 0.7)),
        ("cut.las", cut(&las, 0.7)),
        ("cut.laz", cut(&laz, 0.7)),
        ("cut.glb", cut(&glb, 0.9)),
        ("cut-buffer.gltf", replaced(&gltf, "\"byteLength\":240", "\"byteLength\":99999")),
        ("many.ply", replaced(&ascii, "element vertex 8", "element vertex 1000000000000000000")),
        ("many-binary.ply", replaced(&little, "element vertex 8", "element vertex 4000000000")),
        ("countless.ply", replaced(&ascii, "element vertex 8", "element vertex many")),
        ("negative.ply", replaced(&ascii, "element vertex 8", "element vertex -8")),
        ("many.pcd", replaced(&replaced(&text, "WIDTH 144", "WIDTH 4000000000"), "POINTS 144", "POINTS 4000000000")),
        ("many.las", many_las),
        ("many-views.glb", replaced(&glb, "\"count\":36", "\"count\":99")),
        ("list.pcd", replaced(&text, "COUNT 1 1 1", "COUNT 3 1 1")),
        ("long-list.ply", replaced(&ascii, "\n3 0 2 3\n", "\n9 0 2 3\n")),
        ("no-buffer.gltf", replaced(&gltf, "data:application/octet-stream;base64,", "gone.bin/")),
        ("no-number.pcd", replaced(&text, "POINTS 144", "POINTS many")),
    ]
}
