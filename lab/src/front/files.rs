//! Files of shapes in the formats that users have, by writers that share nothing with the readers.

use super::shapes::Shape;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::DVec3;
use las::point::Format;
use las::{Builder, Color, Point, Transform, Vector, Writer};
use pointcore::color::linear_from_srgb;
use serde_json::json;
use std::fmt::Write as _;
use std::io::Cursor;

/// Length of a step of coordinates in LAS.
pub const LAS_STEP: f64 = 0.001;
/// A byte of color as the words of LAS have it.
const WORD_PER_BYTE: u16 = 257;
/// The components' types in glTF.
const GLTF_WORD: u32 = 5125;
const GLTF_FLOAT: u32 = 5126;
/// Chunks of a binary glTF, and its first word.
const GLB_MAGIC: [u8; 4] = *b"glTF";
const GLB_JSON: [u8; 4] = *b"JSON";
const GLB_BINARY: [u8; 4] = *b"BIN\0";

/// How a PLY file writes numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Ply {
    /// As text.
    Ascii,
    /// Single precision, the least byte first.
    Little,
    /// Double precision, the greatest byte first.
    Big,
}

/// PLY.
#[must_use]
pub fn ply(shape: &Shape, kind: Ply) -> Vec<u8> {
    let (encoding, real) = match kind {
        Ply::Ascii => ("ascii", "double"),
        Ply::Little => ("binary_little_endian", "float"),
        Ply::Big => ("binary_big_endian", "double"),
    };
    let mut header = format!("ply\nformat {encoding} 1.0\ncomment a test\nelement vertex {}\n", shape.points.len());
    let mut properties = |kind: &str, names: &[&str]| {
        names.iter().for_each(|name| _ = writeln!(header, "property {kind} {name}"));
    };
    properties(real, &["x", "y", "z"]);
    if shape.normals.is_some() {
        properties(real, &["nx", "ny", "nz"]);
    }
    if shape.colors.is_some() {
        properties("uchar", &["red", "green", "blue"]);
    }
    _ = write!(header, "element face {}\nproperty list uchar int vertex_indices\nend_header\n", shape.triangles.len());

    let mut bytes = header.into_bytes();
    let reals = |bytes: &mut Vec<u8>, vector: DVec3| {
        for number in vector.to_array() {
            match kind {
                Ply::Ascii => bytes.extend(format!("{number:e} ").bytes()),
                Ply::Little => bytes.extend((number as f32).to_le_bytes()),
                Ply::Big => bytes.extend(number.to_be_bytes()),
            }
        }
    };
    for (index, point) in shape.points.iter().enumerate() {
        reals(&mut bytes, *point);
        shape.normals.iter().for_each(|normals| reals(&mut bytes, normals[index]));
        for byte in shape.colors.iter().flat_map(|colors| colors[index]) {
            match kind {
                Ply::Ascii => bytes.extend(format!("{byte} ").bytes()),
                Ply::Little | Ply::Big => bytes.push(byte),
            }
        }
        bytes.extend((kind == Ply::Ascii).then_some(b'\n'));
    }
    for [a, b, c] in &shape.triangles {
        match kind {
            Ply::Ascii => bytes.extend(format!("3 {a} {b} {c}\n").bytes()),
            Ply::Little => bytes.extend([vec![3], [a, b, c].map(|index| index.to_le_bytes()).concat()].concat()),
            Ply::Big => bytes.extend([vec![3], [a, b, c].map(|index| index.to_be_bytes()).concat()].concat()),
        }
    }
    bytes
}

/// Wavefront OBJ, with colors behind the coordinates.
#[must_use]
pub fn obj(shape: &Shape) -> Vec<u8> {
    let mut text = "# a test\no shape\n".to_owned();
    for (index, DVec3 { x, y, z }) in shape.points.iter().enumerate() {
        _ = write!(text, "v {x} {y} {z}");
        for [r, g, b] in shape.colors.iter().map(|colors| colors[index].map(|byte| f64::from(byte) / 255.0)) {
            _ = write!(text, " {r:.4} {g:.4} {b:.4}");
        }
        text.push('\n');
    }
    shape.normals.iter().flatten().for_each(|DVec3 { x, y, z }| _ = writeln!(text, "vn {x} {y} {z}"));
    for corners in &shape.triangles {
        let [a, b, c] = corners.map(|index| index + 1);
        _ = match shape.normals {
            Some(_) => writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}"),
            None => writeln!(text, "f {a} {b} {c}"),
        };
    }
    text.into_bytes()
}

/// PCD as text.
#[must_use]
pub fn pcd(shape: &Shape) -> Vec<u8> {
    let mut text = pcd_header(shape, 'U', "ascii");
    for (index, DVec3 { x, y, z }) in shape.points.iter().enumerate() {
        _ = write!(text, "{x} {y} {z}");
        shape.colors.iter().for_each(|colors| _ = write!(text, " {}", packed(colors[index])));
        text.push('\n');
    }
    text.into_bytes()
}

/// Binary PCD, whose colors pass for floats as the Point Cloud Library has them.
#[must_use]
pub fn pcd_binary(shape: &Shape) -> Vec<u8> {
    let mut bytes = pcd_header(shape, 'F', "binary").into_bytes();
    for (index, point) in shape.points.iter().enumerate() {
        bytes.extend(point.to_array().iter().flat_map(|number| (*number as f32).to_le_bytes()));
        bytes.extend(shape.colors.iter().flat_map(|colors| packed(colors[index]).to_le_bytes()));
    }
    bytes
}

fn pcd_header(shape: &Shape, color_kind: char, data: &str) -> String {
    let count = shape.points.len();
    let (name, size, kind, one) = match shape.colors {
        Some(_) => (" rgb", " 4", format!(" {color_kind}"), " 1"),
        None => ("", "", String::new(), ""),
    };
    format!(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z{name}\nSIZE 4 4 4{size}\nTYPE F F F{kind}\nCOUNT 1 1 1{one}\nWIDTH {count}\nHEIGHT 1\n\
         VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA {data}\n"
    )
}

fn packed([red, green, blue]: [u8; 3]) -> u32 {
    u32::from_be_bytes([0, red, green, blue])
}

/// LAS, or LAZ where it is compressed; coordinates count from a corner of the shape in steps of [`LAS_STEP`].
///
/// # Panics
/// Never: memory takes every such file.
#[must_use]
pub fn las(shape: &Shape, is_compressed: bool) -> Vec<u8> {
    const WRITTEN: &str = "memory takes every such file";
    let mut builder = Builder::from((1, 2));
    builder.point_format = Format::new(if shape.colors.is_some() { 2 } else { 0 }).expect(WRITTEN);
    builder.point_format.is_compressed = is_compressed;
    let [corner, _] = shape.bounds();
    let [x, y, z] = corner.to_array().map(|offset| Transform { scale: LAS_STEP, offset: offset.floor() });
    builder.transforms = Vector { x, y, z };
    let mut writer = Writer::new(Cursor::new(Vec::new()), builder.into_header().expect(WRITTEN)).expect(WRITTEN);
    for (index, DVec3 { x, y, z }) in shape.points.iter().copied().enumerate() {
        let color = shape.colors.as_ref().map(|colors| colors[index].map(|byte| WORD_PER_BYTE * u16::from(byte)));
        let color = color.map(|[red, green, blue]| Color { red, green, blue });
        writer.write_point(Point { x, y, z, color, ..Point::default() }).expect(WRITTEN);
    }
    writer.close().expect(WRITTEN);
    writer.into_inner().expect(WRITTEN).into_inner()
}

/// Columns of text, with a line of names before them or not.
#[must_use]
pub fn columns(shape: &Shape, separator: char, is_named: bool) -> Vec<u8> {
    let mut lines = Vec::new();
    if is_named {
        let groups = [
            Some(["x", "y", "z"]),
            shape.normals.as_ref().map(|_| ["nx", "ny", "nz"]),
            shape.colors.as_ref().map(|_| ["r", "g", "b"]),
        ];
        lines.push(groups.into_iter().flatten().flatten().map(str::to_owned).collect::<Vec<_>>());
    }
    for (index, point) in shape.points.iter().enumerate() {
        let normal = shape.normals.iter().flat_map(|normals| normals[index].to_array());
        let numbers = point.to_array().into_iter().chain(normal).map(|number| number.to_string());
        let color = shape.colors.iter().flat_map(|colors| colors[index]).map(|byte| byte.to_string());
        lines.push(numbers.chain(color).collect());
    }
    lines.iter().map(|words| words.join(&separator.to_string()) + "\n").collect::<String>().into_bytes()
}

/// glTF as text, its numbers within it; a node moves and scales what the shape is before that.
#[must_use]
pub fn gltf(shape: &Shape, scale: f64, origin: DVec3) -> Vec<u8> {
    let (mut document, buffer) = gltf_parts(shape, scale, origin);
    document["buffers"][0]["uri"] = format!("data:application/octet-stream;base64,{}", STANDARD.encode(&buffer)).into();
    document.to_string().into_bytes()
}

/// Binary glTF, otherwise as [`gltf`].
#[must_use]
pub fn glb(shape: &Shape, scale: f64, origin: DVec3) -> Vec<u8> {
    let (document, buffer) = gltf_parts(shape, scale, origin);
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = |bytes: &[u8]| (bytes.len() as u32).to_le_bytes();
    let chunks = [&length(&text)[..], &GLB_JSON, &text, &length(&buffer), &GLB_BINARY, &buffer].concat();
    let whole = (chunks.len() as u32 + 12).to_le_bytes();
    [&GLB_MAGIC[..], &2_u32.to_le_bytes(), &whole, &chunks].concat()
}

/// The document of a glTF file and its buffer.
fn gltf_parts(shape: &Shape, scale: f64, origin: DVec3) -> (serde_json::Value, Vec<u8>) {
    let (mut buffer, mut views, mut accessors) = (Vec::new(), Vec::new(), Vec::new());
    let mut add = |bytes: Vec<u8>, kind: u32, shape: &str, count: usize, bounds: Option<[DVec3; 2]>| {
        views.push(json!({ "buffer": 0, "byteOffset": buffer.len(), "byteLength": bytes.len() }));
        buffer.extend(bytes);
        let mut accessor =
            json!({ "bufferView": views.len() - 1, "componentType": kind, "count": count, "type": shape });
        if let Some([low, high]) = bounds {
            (accessor["min"], accessor["max"]) = (json!(low.to_array()), json!(high.to_array()));
        }
        accessors.push(accessor);
        accessors.len() - 1
    };
    let floats = |vectors: &[DVec3]| -> Vec<u8> {
        vectors.iter().flat_map(|vector| vector.to_array()).flat_map(|number| (number as f32).to_le_bytes()).collect()
    };
    let count = shape.points.len();
    let bounds = shape.bounds();
    let mut attributes = json!({ "POSITION": add(floats(&shape.points), GLTF_FLOAT, "VEC3", count, Some(bounds)) });
    if let Some(normals) = &shape.normals {
        attributes["NORMAL"] = add(floats(normals), GLTF_FLOAT, "VEC3", count, None).into();
    }
    if let Some(colors) = &shape.colors {
        let linear = |color: &[u8; 3]| DVec3::from_array(color.map(|byte| linear_from_srgb(f64::from(byte) / 255.0)));
        let colors: Vec<_> = colors.iter().map(linear).collect();
        attributes["COLOR_0"] = add(floats(&colors), GLTF_FLOAT, "VEC3", count, None).into();
    }
    let indices: Vec<u8> = shape.triangles.iter().flatten().flat_map(|index| index.to_le_bytes()).collect();
    let indices = add(indices, GLTF_WORD, "SCALAR", 3 * shape.triangles.len(), None);
    let document = json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "translation": origin.to_array(), "scale": [scale, scale, scale] }],
        "meshes": [{ "primitives": [{ "attributes": attributes, "indices": indices }] }],
        "buffers": [{ "byteLength": buffer.len() }],
        "bufferViews": views,
        "accessors": accessors,
    });
    (document, buffer)
}
