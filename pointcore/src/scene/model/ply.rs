//! PLY: ASCII or binary of either byte order, properties in any order, foreign elements and properties skipped.
//!
//! Numbers of ASCII files are read here, since the parser takes fewer ways to write one than programs have: `.5`, `1e5`, `nan`.

use super::{Model, colors, fan, strip};
use glam::DVec3;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::collections::HashSet;
use std::io::Cursor;

/// Scalar properties that are kept, in the order of [`Element::scalars`].
const SCALARS: [&str; 9] = ["x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"];
/// What some programs put before the names of colors.
const COLOR_PREFIX: &str = "diffuse_";
/// Names of the lists that are kept.
const LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];
const NORMAL: usize = 3;
const COLOR: usize = 6;

/// Ends a strip within a list of indices.
const STRIP_END: i64 = -1;

/// An element of any kind, reduced to what a model needs.
#[derive(Default)]
struct Element {
    scalars: [f64; SCALARS.len()],
    /// The other numbers in the order of the header.
    others: Vec<f64>,
    indices: Vec<i64>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if LISTS.contains(&name) {
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
        let value = match property {
            Property::Char(value) => value.into(),
            Property::UChar(value) => value.into(),
            Property::Short(value) => value.into(),
            Property::UShort(value) => value.into(),
            Property::Int(value) => value.into(),
            Property::UInt(value) => value.into(),
            Property::Float(value) => value.into(),
            Property::Double(value) => value,
            _ if scalar(name).is_none() => return PropertyAccessResult::Ignored,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        match scalar(name) {
            Some(index) => self.scalars[index] = value,
            None => self.others.push(value),
        }
        PropertyAccessResult::Set
    }
}

/// Where a property of this name is kept.
fn scalar(name: &str) -> Option<usize> {
    let plain = name.strip_prefix(COLOR_PREFIX).unwrap_or(name);
    SCALARS.iter().position(|known| *known == plain).filter(|&index| plain == name || index >= COLOR)
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
    let is_list = |name: &&str| {
        matches!(vertices.properties.get(*name).map(|property| &property.data_type), Some(PropertyType::List(..)))
    };
    if let Some(name) = SCALARS.iter().find(|name| is_list(name)) {
        return Err(format!("the header declares the property `{name}` of the vertices as a list: expected a number"));
    }

    let mut model = Model::default();
    let mut lines = Lines::after(bytes, reader.get_ref().position() as usize);
    for definition in header.elements.values() {
        let elements = match header.encoding {
            Encoding::Ascii => lines.elements(definition),
            _ => {
                parser.read_payload_for_element(&mut reader, definition, &header).map_err(|error| binary_fault(&error))
            }
        };
        let elements = elements.map_err(|problem| format!("element `{}`: {problem}", definition.name))?;
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
                    model.triangles.extend(self::strip(&strip));
                }
            }
            _ => {}
        }
    }
    Ok(model)
}

/// Lines as bytes.
type ByteLines<'a> = std::slice::Split<'a, u8, fn(&u8) -> bool>;

/// The lines of an ASCII file behind its header.
struct Lines<'a> {
    text: std::iter::Enumerate<ByteLines<'a>>,
    /// Lines of the header.
    before: usize,
}

impl<'a> Lines<'a> {
    fn after(bytes: &'a [u8], header_bytes: usize) -> Self {
        let (header, rest) = bytes.split_at(header_bytes.min(bytes.len()));
        let is_end: fn(&u8) -> bool = |byte| *byte == b'\n';
        Self { text: rest.split(is_end).enumerate(), before: header.iter().filter(|byte| is_end(byte)).count() }
    }

    /// The elements of a kind, one a line.
    fn elements(&mut self, definition: &ElementDef) -> Result<Vec<Element>, String> {
        (0..definition.count).map(|index| self.element(definition, index)).collect()
    }

    fn element(&mut self, definition: &ElementDef, index: usize) -> Result<Element, String> {
        let is_blank = |line: &[u8]| line.iter().all(u8::is_ascii_whitespace);
        let Some((place, line)) = self.text.find(|(_, line)| !is_blank(line)) else {
            return Err(format!(
                "expected {}, got {index}: the file is truncated or its header wrong",
                definition.count
            ));
        };
        let line = String::from_utf8_lossy(line);
        let fault = |problem: &str| format!("line {}: {problem}: {}", self.before + place + 1, line.trim());
        let mut words = line.split_ascii_whitespace();
        let mut number = || {
            let word = words.next().ok_or_else(|| fault("too few numbers"))?;
            word.parse::<f64>().map_err(|_| fault(&format!("`{word}` is not a number")))
        };
        let mut element = Element::default();
        for (name, property) in &definition.properties {
            if let PropertyType::List(..) = property.data_type {
                let items = (0..number()? as usize).map(|_| number()).collect::<Result<Vec<_>, _>>()?;
                if LISTS.contains(&name.as_str()) {
                    element.indices = items.into_iter().map(|item| item as i64).collect();
                }
            } else {
                let value = number()?;
                match scalar(name) {
                    Some(index) => element.scalars[index] = value,
                    None => element.others.push(value),
                }
            }
        }
        if words.next().is_some() {
            return Err(fault("too many numbers"));
        }
        Ok(element)
    }
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

/// What is wrong with the binary part of a file, which has no lines.
fn binary_fault(error: &impl std::fmt::Display) -> String {
    let message = one_line(error);
    if message.contains("Unexpected end of file") {
        return "ends too soon: the file is truncated or its header wrong".to_owned();
    }
    message
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
    let is_other = |name: &&String| scalar(name).is_none();
    let numbers =
        definition.properties.iter().filter(|(_, property)| matches!(property.data_type, PropertyType::Scalar(_)));
    for (place, name) in numbers.map(|(name, _)| name).filter(is_other).enumerate() {
        model.attributes.insert(name.to_lowercase(), elements.iter().map(|element| element.others[place]).collect());
    }
    let kind = |name: &str| {
        let prefixed = || definition.properties.get(&format!("{COLOR_PREFIX}{name}"));
        definition.properties.get(name).or_else(prefixed).map(|property| &property.data_type)
    };
    if let [Some(red), Some(_), Some(_)] = [COLOR, COLOR + 1, COLOR + 2].map(|index| kind(SCALARS[index])) {
        let full = match red {
            PropertyType::Scalar(ScalarType::Float | ScalarType::Double) => 1.0,
            PropertyType::Scalar(ScalarType::Short | ScalarType::UShort) => f64::from(u16::MAX),
            _ => f64::from(u8::MAX),
        };
        let color = |element: &Element| colors::of_full(vector(element, COLOR).to_array(), full);
        model.colors = Some(elements.iter().map(color).collect());
    }
}

fn vertex_indices(indices: &[i64]) -> Result<Vec<u32>, String> {
    let index = |&index: &i64| u32::try_from(index).map_err(|_| format!("{index} is not the index of a vertex"));
    indices.iter().map(index).collect()
}
