//! Results as files that other programs read: PLY, CSV, NumPy's arrays.

use super::outcome::{Column, Numbers, Processed};
use npyz::WriterBuilder as _;
use ply_rs_bw::ply::{
    Addable as _, ElementDef, Encoding, Ply, Property, PropertyAccess, PropertyAccessResult, PropertyDef, PropertyType,
    ScalarType,
};
use ply_rs_bw::writer::Writer;
use std::fmt::Write as _;
use std::io;

/// A column of a file.
struct Named<'a> {
    name: String,
    numbers: &'a Numbers,
}

/// What stands before the name of an output that every file has besides.
const OF_PROGRAM: &str = "output_";

/// The query's place in the end is x, y, z; a normal is nx, ny, nz; everything else bears its name, which no other has.
fn columns<'a>(processed: &'a Processed, extra: &'a [(&'static str, Numbers)]) -> Vec<Named<'a>> {
    let mut columns: Vec<Named<'_>> =
        extra.iter().map(|(name, numbers)| Named { name: (*name).to_owned(), numbers }).collect();
    for column in processed.columns.iter().filter(|column| !(column.name == "position" && column.parts.len() == 3)) {
        for (part, numbers) in column.parts.iter().zip(&column.numbers) {
            let axis = part.strip_prefix("normal_").filter(|_| column.name == "normal");
            let mut name = axis.map_or(part.clone(), |axis| format!("n{axis}"));
            while columns.iter().any(|column| column.name == name) {
                name.insert_str(0, OF_PROGRAM);
            }
            columns.push(Named { name, numbers });
        }
    }
    columns
}

/// What every file has besides the outputs: places, iterations, whether they ended the query.
fn extra(processed: &Processed) -> Vec<(&'static str, Numbers)> {
    let place = |axis: usize| Numbers::Double(processed.places.iter().map(|place| place[axis]).collect());
    let answers = processed.answers();
    let neighbors: Option<Vec<i32>> = answers.iter().map(|answer| answer.neighbors.map(|count| count as i32)).collect();
    let mut columns = vec![
        ("x", place(0)),
        ("y", place(1)),
        ("z", place(2)),
        ("iterations", Numbers::Int(answers.iter().map(|answer| answer.iterations as i32).collect())),
    ];
    columns.extend(neighbors.map(|counts| ("neighbors", Numbers::Int(counts))));
    columns.push(("capped", Numbers::Bool(answers.iter().map(|answer| answer.capped).collect())));
    columns
}

/// Comma-separated values, a line a query.
#[must_use]
pub fn csv(processed: &Processed) -> String {
    let extra = extra(processed);
    let columns = columns(processed, &extra);
    let mut text = "query".to_owned();
    columns.iter().for_each(|column| _ = write!(text, ",{}", column.name));
    for query in 0..processed.places.len() {
        _ = write!(text, "\n{query}");
        for column in &columns {
            _ = match column.numbers {
                Numbers::Double(numbers) => write!(text, ",{}", numbers[query]),
                Numbers::Float(numbers) => write!(text, ",{:e}", numbers[query]),
                Numbers::Int(numbers) => write!(text, ",{}", numbers[query]),
                Numbers::Bool(numbers) => write!(text, ",{}", u8::from(numbers[query])),
            };
        }
    }
    text.push('\n');
    text
}

/// A query as PLY's writer asks for it.
struct Row<'a> {
    columns: &'a [Named<'a>],
    query: usize,
}

impl Row<'_> {
    fn numbers(&self, name: &str) -> Option<&Numbers> {
        self.columns.iter().find(|column| column.name == name).map(|column| column.numbers)
    }
}

impl PropertyAccess for Row<'_> {
    fn new() -> Self {
        Self { columns: &[], query: 0 }
    }

    fn set_property(&mut self, _: &str, _: Property) -> PropertyAccessResult {
        PropertyAccessResult::Ignored
    }

    fn get_double(&self, name: &str) -> Option<f64> {
        self.numbers(name).map(|numbers| numbers.number(self.query))
    }

    fn get_float(&self, name: &str) -> Option<f32> {
        self.get_double(name).map(|number| number as f32)
    }

    fn get_int(&self, name: &str) -> Option<i32> {
        self.get_double(name).map(|number| number as i32)
    }

    fn get_uchar(&self, name: &str) -> Option<u8> {
        self.get_double(name).map(|number| number as u8)
    }
}

/// A binary PLY file, a vertex a query.
///
/// # Errors
/// The writer's; there is none in memory.
pub fn ply(processed: &Processed) -> io::Result<Vec<u8>> {
    let extra = extra(processed);
    let columns = columns(processed, &extra);
    let mut definition = ElementDef::new("vertex".to_owned());
    for column in &columns {
        let ty = match column.numbers {
            Numbers::Double(_) => ScalarType::Double,
            Numbers::Float(_) => ScalarType::Float,
            Numbers::Int(_) => ScalarType::Int,
            Numbers::Bool(_) => ScalarType::UChar,
        };
        definition.properties.add(PropertyDef::new(column.name.clone(), PropertyType::Scalar(ty)));
    }
    let mut ply = Ply::<Row<'_>>::new();
    ply.header.encoding = Encoding::BinaryLittleEndian;
    ply.header.elements.add(definition);
    let rows = (0..processed.places.len()).map(|query| Row { columns: &columns, query }).collect();
    ply.payload.insert("vertex".to_owned(), rows);
    let mut bytes = vec![];
    Writer::new().write_ply(&mut bytes, &mut ply).map_err(io::Error::other)?;
    Ok(bytes)
}

/// Arrays of NumPy, one an output, by their names: of a vector three numbers a query.
///
/// # Errors
/// The writer's; there is none in memory.
pub fn npy(processed: &Processed) -> io::Result<Vec<(String, Vec<u8>)>> {
    let places: Vec<Numbers> = extra(processed).into_iter().take(3).map(|(_, numbers)| numbers).collect();
    let mut arrays = vec![("position".to_owned(), array(&places.iter().collect::<Vec<_>>())?)];
    let extra = &extra(processed)[3..];
    let is_place = |column: &&Column| column.name == "position" && column.parts.len() == 3;
    for column in processed.columns.iter().filter(|column| !is_place(column)) {
        let mut name = column.name.clone();
        while arrays.iter().any(|(other, _)| *other == name) || extra.iter().any(|(other, _)| *other == name) {
            name.insert_str(0, OF_PROGRAM);
        }
        arrays.push((name, array(&column.numbers.iter().collect::<Vec<_>>())?));
    }
    for (name, numbers) in extra {
        arrays.push(((*name).to_owned(), array(&[numbers])?));
    }
    Ok(arrays)
}

fn array(parts: &[&Numbers]) -> io::Result<Vec<u8>> {
    let count = parts.first().map_or(0, |part| part.len());
    let shape: Vec<u64> = [count as u64].into_iter().chain((parts.len() > 1).then_some(parts.len() as u64)).collect();
    let all = || (0..count).flat_map(|query| parts.iter().map(move |part| part.number(query)));
    match parts.first() {
        Some(Numbers::Double(_)) | None => typed(&shape, all()),
        Some(Numbers::Float(_)) => typed(&shape, all().map(|number| number as f32)),
        Some(Numbers::Int(_)) => typed(&shape, all().map(|number| number as i32)),
        Some(Numbers::Bool(_)) => typed(&shape, all().map(|number| number != 0.0)),
    }
}

fn typed<T: npyz::AutoSerialize>(shape: &[u64], numbers: impl Iterator<Item = T>) -> io::Result<Vec<u8>> {
    let mut bytes = vec![];
    let mut writer = npyz::WriteOptions::new().default_dtype().shape(shape).writer(&mut bytes).begin_nd()?;
    writer.extend(numbers)?;
    writer.finish()?;
    Ok(bytes)
}
