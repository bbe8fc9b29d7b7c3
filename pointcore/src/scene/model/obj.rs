//! Wavefront OBJ, of which a point model needs `v`, with a color behind the coordinates or without, `vn` and `f`; other statements are skipped.
//!
//! A reader of our own because readers of meshes drop vertices that no face refers to, and a point cloud has no faces.

use super::{Model, colors, fan, text};
use glam::DVec3;

/// A corner of a face: its vertex and, if given, its normal.
struct Corner {
    vertex: usize,
    normal: Option<usize>,
}

/// Parses a whole file; an error names the line.
pub(super) fn parse(bytes: &[u8]) -> Result<Model, String> {
    let text = text(bytes)?;
    let (mut model, mut normals, mut colors) = (Model::default(), Vec::new(), Vec::new());
    let mut polygons = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let statement = line.split('#').next().unwrap_or_default();
        let mut words = statement.split_whitespace();
        let result = match words.next() {
            Some("v") => vector(&mut words).and_then(|point| {
                model.points.push(point);
                colors.extend(color(words)?);
                Ok(())
            }),
            Some("vn") => vector(&mut words).map(|normal| normals.push(normal)),
            Some("f") => words
                .map(|word| corner(word, model.points.len(), normals.len()))
                .collect::<Result<Vec<_>, _>>()
                .map(|polygon| polygons.push(polygon)),
            _ => Ok(()),
        };
        result.map_err(|problem| format!("line {}: {problem}", index + 1))?;
    }
    for polygon in &polygons {
        let indices: Vec<_> = polygon.iter().map(|corner| corner.vertex as u32).collect();
        model.triangles.extend(fan(&indices));
    }
    model.normals = vertex_normals(model.points.len(), &polygons, &normals);
    model.colors = (!colors.is_empty() && colors.len() == model.points.len()).then(|| colors::linear(&colors));
    Ok(model)
}

/// The color behind a vertex' coordinates; a single number there is a weight, and more than three begin with one.
fn color<'a>(words: impl Iterator<Item = &'a str>) -> Result<Option<[f64; 3]>, String> {
    let number = |word: &str| word.parse::<f64>().map_err(|_| format!("`{word}` is not a number"));
    let numbers = words.map(number).collect::<Result<Vec<_>, _>>()?;
    Ok(match numbers[..] {
        [red, green, blue] | [_, red, green, blue] => Some([red, green, blue]),
        _ => None,
    })
}

fn vector<'a>(words: &mut impl Iterator<Item = &'a str>) -> Result<DVec3, String> {
    let mut component = || {
        let word = words.next().ok_or("three numbers expected")?;
        word.parse::<f64>().map_err(|_| format!("`{word}` is not a number"))
    };
    Ok(DVec3::new(component()?, component()?, component()?))
}

/// `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`, counted from one, or backwards from −1.
fn corner(word: &str, vertices: usize, normals: usize) -> Result<Corner, String> {
    let resolve = |text: &str, kind: &str, count: usize| {
        let number: i64 = text.parse().map_err(|_| format!("`{word}` is not the corner of a face"))?;
        let index = if number < 0 { count as i64 + number } else { number - 1 };
        let known = (0..count as i64).contains(&index);
        known
            .then_some(index as usize)
            .ok_or_else(|| format!("{kind} {number} of `{word}` is not among the {count} so far"))
    };
    let mut parts = word.split('/');
    let vertex = resolve(parts.next().unwrap_or_default(), "vertex", vertices)?;
    let normal = parts.nth(1).filter(|part| !part.is_empty());
    Ok(Corner { vertex, normal: normal.map(|part| resolve(part, "normal", normals)).transpose()? })
}

/// The sum of the normals that faces give a vertex; without faces, the normals themselves if each vertex has one.
fn vertex_normals(vertices: usize, polygons: &[Vec<Corner>], normals: &[DVec3]) -> Option<Vec<DVec3>> {
    if polygons.is_empty() {
        return (!normals.is_empty() && normals.len() == vertices).then(|| normals.to_vec());
    }
    let mut sums = vec![DVec3::ZERO; vertices];
    for corner in polygons.iter().flatten() {
        sums[corner.vertex] += normals[corner.normal?];
    }
    Some(sums)
}
