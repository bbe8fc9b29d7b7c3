//! PCD, the format of the Point Cloud Library: text, binary, and compressed.

use super::{Model, colors};
use crate::wording::plain;
use glam::DVec3;
use pcd_rs::{DataKind, DynReader, Field, PcdMeta, ValueKind};
use std::io::Cursor;

/// What LZF makes of three bytes at most.
const EXPANSION_LIMIT: u64 = 264;
/// Bytes of the two sizes before compressed data.
const SIZES_BYTES: u64 = 8;

/// Parses a whole file; an error says what is wrong with it.
pub(super) fn parse(bytes: &[u8]) -> Result<Model, String> {
    let problem = |error: pcd_rs::Error| format!("not a PCD file that can be read: {}", plain(&error));
    let mut header = Cursor::new(bytes);
    let meta = PcdMeta::from_reader(&mut header).map_err(problem)?;
    check_size(&meta, &bytes[(header.position() as usize).min(bytes.len())..])?;
    let place = |name: &str| meta.field_defs.iter().position(|field| field.name == name && field.count == 1);
    let three = |names: [&str; 3]| {
        let [x, y, z] = names.map(place);
        Some([x?, y?, z?])
    };
    let point = three(["x", "y", "z"]).ok_or("has no fields `x`, `y` and `z` of one number each")?;
    let normal = three(["normal_x", "normal_y", "normal_z"]);
    let color = place("rgb").or_else(|| place("rgba"));

    let mut model = Model { normals: normal.map(|_| Vec::new()), ..Model::default() };
    let mut bytes_of_colors = Vec::new();
    for record in DynReader::from_bytes(bytes).map_err(problem)? {
        let fields = record.map_err(problem)?.0;
        let vector = |places: [usize; 3]| DVec3::from_array(places.map(|place| number(&fields[place])));
        model.points.push(vector(point));
        if let (Some(normals), Some(places)) = (&mut model.normals, normal) {
            normals.push(vector(places));
        }
        bytes_of_colors.extend(color.map(|place| packed_color(&fields[place])));
    }
    model.colors = color.map(|_| bytes_of_colors.iter().map(|rgb| colors::of_full(*rgb, u8::MAX.into())).collect());
    let viewpoint = &meta.viewpoint;
    let sensor = DVec3::new(viewpoint.tx, viewpoint.ty, viewpoint.tz);
    // Files whose sensor is not known say that it stood in the origin.
    model.sensor = (sensor != DVec3::ZERO && sensor.is_finite()).then_some(sensor);
    Ok(model)
}

/// A header may promise any number of points; no more than fit the data are read.
fn check_size(meta: &PcdMeta, data: &[u8]) -> Result<(), String> {
    let widths = meta.field_defs.iter().map(|field| (field.kind.byte_size() as u64).saturating_mul(field.count));
    let numbers = meta.field_defs.iter().fold(0_u64, |sum, field| sum.saturating_add(field.count));
    let record = widths.fold(0, u64::saturating_add);
    let (points, given) = (meta.num_points, data.len() as u64);
    let total = points.saturating_mul(record);
    let fits = match meta.data {
        // A digit and a separator each; the last line may lack its end.
        DataKind::Ascii => points.saturating_mul(numbers.saturating_mul(2)) <= given + 1 && points <= lines(data),
        DataKind::Binary => total <= given,
        DataKind::BinaryCompressed => match data.first_chunk::<8>() {
            Some(&[a, b, c, d, e, f, g, h]) => {
                let [compressed, whole] = [[a, b, c, d], [e, f, g, h]].map(|size| u64::from(u32::from_le_bytes(size)));
                compressed + SIZES_BYTES <= given && whole == total && whole <= compressed * EXPANSION_LIMIT
            }
            None => false,
        },
    };
    fits.then_some(()).ok_or_else(|| {
        format!("the header declares {points} points, which do not fit the {given} bytes that follow it: the file is truncated or its header wrong")
    })
}

/// Lines of text with something in them.
fn lines(data: &[u8]) -> u64 {
    let is_blank = |line: &[u8]| line.iter().all(u8::is_ascii_whitespace);
    data.split(|byte| *byte == b'\n').filter(|line| !is_blank(line)).count() as u64
}

/// A field of one number.
fn number(field: &Field) -> f64 {
    let first = match field {
        Field::I8(values) => values.first().map(|&value| value.into()),
        Field::I16(values) => values.first().map(|&value| value.into()),
        Field::I32(values) => values.first().map(|&value| value.into()),
        Field::I64(values) => values.first().map(|&value| value as f64),
        Field::U8(values) => values.first().map(|&value| value.into()),
        Field::U16(values) => values.first().map(|&value| value.into()),
        Field::U32(values) => values.first().map(|&value| value.into()),
        Field::U64(values) => values.first().map(|&value| value as f64),
        Field::F32(values) => values.first().map(|&value| value.into()),
        Field::F64(values) => values.first().copied(),
    };
    first.unwrap_or(f64::NAN)
}

/// Red, green and blue are bytes of a word, which may pass for a float.
fn packed_color(field: &Field) -> [f64; 3] {
    let word = match (field.kind(), field) {
        (ValueKind::F32, Field::F32(values)) => values.first().map_or(0, |value| value.to_bits()),
        _ => number(field) as u32,
    };
    let [_, red, green, blue] = word.to_be_bytes();
    [red, green, blue].map(f64::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(points: usize, data: &str) -> String {
        format!(
            "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4 4\nTYPE F F F U F F F\n\
             COUNT 1 1 1 1 1 1 1\nWIDTH {points}\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS {points}\nDATA {data}\n"
        )
    }

    #[test]
    fn text_and_binary_read_alike() {
        let text =
            parse(format!("{}1 2 3 16711680 0 0 1\nnan 5 6 255 0 1 0\n", header(2, "ascii")).as_bytes()).expect("good");
        let mut bytes = header(2, "binary").into_bytes();
        for (point, color, normal) in
            [([1.0, 2.0, 3.0], 0xff_0000_u32, [0.0, 0.0, 1.0]), ([f32::NAN, 5.0, 6.0], 0xff, [0.0, 1.0, 0.0_f32])]
        {
            bytes.extend(point.iter().flat_map(|value| value.to_le_bytes()));
            bytes.extend(color.to_le_bytes());
            bytes.extend(normal.iter().flat_map(|value| value.to_le_bytes()));
        }
        let binary = parse(&bytes).expect("good");
        for model in [text, binary] {
            assert_eq!((model.points[0], model.sensor), (DVec3::new(1.0, 2.0, 3.0), Some(DVec3::new(1.0, 2.0, 3.0))));
            assert!(model.points[1].is_nan() && model.points.len() == 2);
            assert_eq!(model.colors, Some(vec![[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]));
            assert_eq!(model.normals, Some(vec![DVec3::Z, DVec3::Y]));
        }
        assert!(parse(&bytes[..bytes.len() - 1]).is_err_and(|problem| problem.contains("truncated")));
    }

    #[test]
    fn what_cannot_be_is_refused() {
        for (file, part) in [
            (header(1_000_000_000_000, "ascii") + "1 2 3 0 0 0 1\n", "1000000000000 points"),
            (header(1_000_000_000_000, "binary_compressed") + "12345678", "1000000000000 points"),
            (header(1, "ascii").replace("FIELDS x", "FIELDS a") + "1 2 3 0 0 0 1\n", "`x`, `y` and `z`"),
            ("hello".to_owned(), "PCD"),
        ] {
            let problem = parse(file.as_bytes()).expect_err("the file is bad");
            assert!(problem.contains(part), "{problem}");
        }
    }
}
