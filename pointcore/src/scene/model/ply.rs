//! PLY: ASCII or binary of either byte order, properties in any order, foreign elements and properties skipped.

use super::{Model, fan};
use crate::color::linear_from_srgb;
use glam::DVec3;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::collections::HashSet;
use std::io::Cursor;

/// Scalar properties that are kept, in the order of [`Element::scalars`].
const SCALARS: [&str; 9] = ["x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"];
const NORMAL: usize = 3;
const COLOR: usize = 6;

/// Ends a strip within a list of indices.
const STRIP_END: i64 = -1;

/// An element of any kind, reduced to what a model needs.
#[derive(Default)]
struct Element {
    scalars: [f64; SCALARS.len()],
    indices: Vec<i64>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if matches!(name, "vertex_indices" | "vertex_index") {
            self.indices = match property {
                Property::ListChar(list) => list.into_iter().map(i64::from).collect(),
                Property::ListUChar(list) => list.into_iter().map(i64::from).collect(),
                Property::ListShort(list) => list.into_iter().map(i64::from).collect(),
                Property::ListUShort(list) => list.into_iter().map(i64::from).collect(),
                Property::ListInt(list) => list.into_iter().map(i64::from).collect(),
                Property::ListUInt(list) => list.into_iter().map(i64::from).collect(),
                _ => return PropertyAccessResult::UnsupportedType,
            };
            return PropertyAccessResult::Set;
        }
        let Some(index) = SCALARS.iter().position(|known| *known == name) else { return PropertyAccessResult::Ignored };
        self.scalars[index] = match property {
            Property::Char(value) => value.into(),
            Property::UChar(value) => value.into(),
            Property::Short(value) => value.into(),
            Property::UShort(value) => value.into(),
            Property::Int(value) => value.into(),
            Property::UInt(value) => value.into(),
            Property::Float(value) => value.into(),
            Property::Double(value) => value,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// Parses a whole file; an error says what is wrong with it.
pub(super) fn parse(bytes: &[u8]) -> Result<Model, String> {
    let parser = Parser::<Element>::new();
    let mut reader = Reader::new(Cursor::new(bytes));
    let header = parser.read_header(&mut reader).map_err(|error| format!("not a PLY header: {}", one_line(&error)))?;
    check_names(bytes)?;
    if (header.version.major, header.version.minor) != (1, 0) {
        let (major, minor) = (header.version.major, header.version.minor);
        return Err(format!("is in version {major}.{minor} of PLY: expected 1.0"));
    }
    check_counts(&header, bytes.len() as u64 - reader.get_ref().position())?;
    let vertices = header.elements.get("vertex").ok_or("the header declares no element `vertex`")?;
    for axis in &SCALARS[..NORMAL] {
        if !vertices.properties.contains_key(*axis) {
            return Err(format!("the header declares no property `{axis}` of the vertices"));
        }
    }

    let mut model = Model::default();
    for definition in header.elements.values() {
        let elements = parser
            .read_payload_for_element(&mut reader, definition, &header)
            .map_err(|error| format!("element `{}`: {}", definition.name, one_line(&error)))?;
        match definition.name.as_str() {
            "vertex" => add_vertices(&mut model, definition, &elements),
            "face" => {
                for (index, element) in elements.iter().enumerate() {
                    let polygon = vertex_indices(&element.indices).map_err(|error| format!("face {index}: {error}"))?;
                    model.triangles.extend(fan(&polygon));
                }
            }
            "tristrips" => {
                for strip in elements.iter().flat_map(|element| element.indices.split(|&index| index == STRIP_END)) {
                    let strip = vertex_indices(strip).map_err(|error| format!("triangle strips: {error}"))?;
                    model.triangles.extend(strip_triangles(&strip));
                }
            }
            _ => {}
        }
    }
    Ok(model)
}

/// The parser's message without what its grammar would have taken: `line 9: couldn't read element line: 0 nan 0`.
fn one_line(error: &impl std::fmt::Display) -> String {
    let message = error.to_string();
    let mut lines = message.lines();
    let first = lines.next().unwrap_or_default().trim_end_matches('.');
    let summary = first.strip_prefix("Line ").map_or(first.to_owned(), |rest| format!("line {rest}"));
    match lines.next().and_then(|line| line.trim().strip_prefix("String: ")) {
        Some(text) => format!("{summary}: {}", text.trim_matches('\'').trim()),
        None => summary,
    }
}

/// The parser keeps the last of several declarations of one name, and would read what follows askew.
fn check_names(bytes: &[u8]) -> Result<(), String> {
    let (mut elements, mut properties) = (HashSet::new(), HashSet::new());
    for (index, line) in bytes.split(|byte| *byte == b'\n').enumerate() {
        let line = String::from_utf8_lossy(line);
        let words: Vec<_> = line.split_whitespace().collect();
        let fresh = match words[..] {
            ["end_header"] => break,
            ["element", name, ..] => {
                properties.clear();
                elements.insert(name.to_owned())
            }
            ["property", .., name] => properties.insert(name.to_owned()),
            _ => true,
        };
        if !fresh {
            let (kind, name) = (words[0], if words[0] == "element" { words[1] } else { words[words.len() - 1] });
            return Err(format!("line {}: the header declares {kind} `{name}` twice", index + 1));
        }
    }
    Ok(())
}

/// A header may promise any number of elements; no more than fit the file are read.
fn check_counts(header: &Header, payload_bytes: u64) -> Result<(), String> {
    let scalar_bytes = |scalar: &ScalarType| match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    };
    let mut needed = 0_u64;
    for ElementDef { name, count, properties } in header.elements.values() {
        if properties.is_empty() && *count > 0 {
            return Err(format!("the header declares {count} elements `{name}` without a property"));
        }
        let smallest: u64 = match header.encoding {
            // A digit and a separator each; the last line may lack its end.
            Encoding::Ascii => 2 * properties.len() as u64,
            Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => properties
                .values()
                .map(|property| match &property.data_type {
                    PropertyType::Scalar(scalar) | PropertyType::List(scalar, _) => scalar_bytes(scalar),
                })
                .sum(),
        };
        needed = needed.saturating_add(smallest.saturating_mul(*count as u64));
        if needed > payload_bytes + 1 {
            return Err(format!(
                "the header declares {count} elements `{name}`, which need {needed} bytes at least, but only \
                 {payload_bytes} follow it: the file is truncated or its header wrong"
            ));
        }
    }
    Ok(())
}

fn add_vertices(model: &mut Model, definition: &ElementDef, elements: &[Element]) {
    let has = |names: &[&str]| names.iter().all(|name| definition.properties.contains_key(*name));
    let vector = |element: &Element, first: usize| DVec3::from_slice(&element.scalars[first..]);
    model.points = elements.iter().map(|element| vector(element, 0)).collect();
    if has(&SCALARS[NORMAL..COLOR]) {
        model.normals = Some(elements.iter().map(|element| vector(element, NORMAL)).collect());
    }
    if has(&SCALARS[COLOR..]) {
        let data_type = &definition.properties[SCALARS[COLOR]].data_type;
        let full = match data_type {
            PropertyType::Scalar(ScalarType::Float | ScalarType::Double) => 1.0,
            _ => f64::from(u8::MAX),
        };
        let component = |value: f64| linear_from_srgb((value / full).clamp(0.0, 1.0)) as f32;
        let color = |element: &Element| (vector(element, COLOR).to_array()).map(component);
        model.colors = Some(elements.iter().map(color).collect());
    }
}

fn vertex_indices(indices: &[i64]) -> Result<Vec<u32>, String> {
    let index = |&index: &i64| u32::try_from(index).map_err(|_| format!("{index} is not the index of a vertex"));
    indices.iter().map(index).collect()
}

/// Every second triangle of a strip turns the other way round. Strips repeat vertices to turn a corner, which leaves
/// triangles without area.
fn strip_triangles(strip: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    let oriented = |(index, corner): (usize, &[u32])| match index % 2 {
        0 => [corner[0], corner[1], corner[2]],
        _ => [corner[1], corner[0], corner[2]],
    };
    strip.windows(3).enumerate().map(oriented).filter(|[a, b, c]| a != b && b != c && a != c)
}
