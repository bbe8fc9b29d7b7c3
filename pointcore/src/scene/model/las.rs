//! LAS and LAZ, the formats of airborne and terrestrial laser scanners.

use super::{Model, colors};
use ::las::{Color, PointDataBuilder, Reader};
use glam::DVec3;
use std::io::Cursor;

/// Bytes decoded at a time: a header may promise any number of points.
const BATCH_BYTES: usize = 1 << 24;
/// Where a file says how far its points are from its beginning, and in which format they are.
const POINTS_OFFSET: usize = 96;
const POINT_FORMAT: usize = 104;
/// What the readers below say of a file that ends too soon.
const OUT_OF_BYTES: &str = "failed to fill whole buffer";
/// Of the format, whether points are compressed.
const COMPRESSED: u8 = 0x80;

/// Parses a whole file; an error says what is wrong with it.
pub(super) fn parse(bytes: &[u8]) -> Result<Model, String> {
    let problem = |error: ::las::Error| {
        let message = error.to_string();
        let cause = if message.contains(OUT_OF_BYTES) { "it is truncated or its header wrong" } else { &message };
        format!("not a LAS or LAZ file that can be read: {cause}")
    };
    check_chunks(bytes)?;
    // The reader keeps its source for itself.
    let mut reader = Reader::new(Cursor::new(bytes.to_vec())).map_err(problem)?;
    let mut batch = PointDataBuilder::new().for_header(reader.header()).build();
    let (mut points, mut rgb): (Vec<DVec3>, Vec<Color>) = Default::default();
    let batch_points = (BATCH_BYTES / batch.record_len().max(1)) as u64;
    while reader.fill_points(batch_points, &mut batch).map_err(problem)? > 0 {
        points.extend(batch.x().zip(batch.y()).zip(batch.z()).map(|((x, y), z)| DVec3::new(x, y, z)));
        rgb.extend(batch.rgb().into_iter().flatten().map(|(red, green, blue)| Color { red, green, blue }));
    }
    // Files of a format with colors may have left them all black.
    let has_colors = rgb.iter().any(|Color { red, green, blue }| red | green | blue != 0);
    let components = |color: &Color| [color.red, color.green, color.blue].map(f64::from);
    let colors = has_colors.then(|| colors::linear(&rgb.iter().map(components).collect::<Vec<_>>()));
    Ok(Model { points, colors, ..Model::default() })
}

/// A table may promise any number of compressed chunks; no more than fit the file are read.
fn check_chunks(bytes: &[u8]) -> Result<(), String> {
    if bytes.get(POINT_FORMAT).is_none_or(|format| format & COMPRESSED == 0) {
        return Ok(());
    }
    let after = |place: usize| bytes.get(place..).unwrap_or_default();
    let word = |place: usize| after(place).first_chunk().map_or(0, |word| u32::from_le_bytes(*word));
    let table = |place: usize| after(place).first_chunk().map_or(0, |place| i64::from_le_bytes(*place));
    // Writers that cannot go back leave the place to the end of the file.
    let place = match table(word(POINTS_OFFSET) as usize) {
        -1 => table(bytes.len().saturating_sub(size_of::<i64>())),
        place => place,
    };
    // Behind the version of the table.
    let chunks = usize::try_from(place).map_or(0, |place| word(place.saturating_add(size_of::<u32>())));
    let fits = u64::from(chunks) <= bytes.len() as u64;
    fits.then_some(())
        .ok_or_else(|| format!("not a LAZ file that can be read: it promises {chunks} chunks in {} bytes", bytes.len()))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use ::las::{Builder, Point, Transform, Vector, Writer, point::Format};

    /// A file of these points, of a millimeter each, compressed or not.
    fn file(points: &[DVec3], colors: Option<[u16; 3]>, is_compressed: bool) -> Vec<u8> {
        let mut builder = Builder::from((1, 2));
        builder.point_format = Format::new(if colors.is_some() { 2 } else { 0 }).expect("such formats exist");
        builder.point_format.is_compressed = is_compressed;
        let transform = |offset| Transform { scale: 0.001, offset };
        builder.transforms = Vector { x: transform(500_000.0), y: transform(5_000_000.0), z: transform(0.0) };
        let header = builder.into_header().expect("the header is good");
        let mut writer = Writer::new(Cursor::new(Vec::new()), header).expect("the header is good");
        for &DVec3 { x, y, z } in points {
            let color = colors.map(|[red, green, blue]| Color { red, green, blue });
            writer.write_point(Point { x, y, z, color, ..Point::default() }).expect("memory takes it");
        }
        writer.close().expect("memory takes it");
        writer.into_inner().expect("it was closed").into_inner()
    }

    #[test]
    fn points_and_colors_are_read_compressed_or_not() {
        let points = [DVec3::new(500_001.25, 4_999_999.5, 12.125), DVec3::new(500_002.0, 5_000_000.0, -3.0)];
        for is_compressed in [false, true] {
            let model = parse(&file(&points, Some([65_535, 0, 0]), is_compressed)).expect("the file is good");
            assert_eq!(model.colors, Some(vec![[1.0, 0.0, 0.0]; 2]));
            assert!(model.points.iter().zip(points).all(|(read, point)| read.distance(point) < 1e-9), "{model:?}");
            let plain = parse(&file(&points, None, is_compressed)).expect("the file is good");
            assert_eq!((plain.points.len(), plain.colors), (2, None));
        }
        assert_eq!(parse(&file(&points, Some([0; 3]), false)).expect("good").colors, None, "never filled in");
    }

    #[test]
    fn what_is_no_such_file_is_said() {
        let whole = file(&[DVec3::new(500_000.0, 5e6, 0.0); 10], None, false);
        for bytes in [&b"hello"[..], &[], &whole[..whole.len() - 30]] {
            assert!(parse(bytes).is_err_and(|problem| problem.contains("LAS or LAZ")));
        }
    }
}
