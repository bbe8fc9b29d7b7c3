//! Columns of numbers as text (XYZ, CSV, ASC, PTS): a point a line, separated by commas, semicolons or blanks. A line of names, commented
//! out or not, says what the columns are; without one their number and their values do.

use super::{Model, colors, text};
use glam::DVec3;
use std::collections::BTreeMap;

/// Columns of a line that are no longer looked at.
const COLUMNS_LIMIT: usize = 64;
/// How far a normal's length may be from one among numbers written with few digits.
const UNIT_TOLERANCE: f64 = 0.02;
/// Lines that are looked at to tell normals from colors.
const LINES_TRIED: usize = 1000;

/// Names of a column, lower case.
const NAMES: [[&str; 3]; 9] = [
    ["x", "easting", "px"],
    ["y", "northing", "py"],
    ["z", "height", "pz"],
    ["nx", "normal_x", "normalx"],
    ["ny", "normal_y", "normaly"],
    ["nz", "normal_z", "normalz"],
    ["r", "red", "rf"],
    ["g", "green", "gf"],
    ["b", "blue", "bf"],
];
/// Where each group of three begins in [`NAMES`].
const POINT: usize = 0;
const NORMAL: usize = 3;
const COLOR: usize = 6;

/// Which columns hold what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Layout {
    point: [usize; 3],
    normal: Option<[usize; 3]>,
    color: Option<[usize; 3]>,
}

/// Parses a whole file; an error names the line.
pub(super) fn parse(bytes: &[u8]) -> Result<Model, String> {
    let text = text(bytes)?;
    let mut names: Option<Vec<String>> = None;
    let mut rows: Vec<(usize, Vec<f64>)> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.trim_start_matches('\u{feff}').trim();
        let comment = line.strip_prefix('#').or_else(|| line.strip_prefix("//"));
        let words = split(comment.unwrap_or(line));
        if words.iter().all(|word| word.is_empty()) {
            continue;
        }
        if rows.is_empty() && layout_of_names(&words).is_some() {
            names = Some(words.iter().map(|word| (*word).to_owned()).collect());
            continue;
        }
        if comment.is_some() {
            continue;
        }
        rows.push((index + 1, numbers(&words, index + 1)?));
    }
    // A file of the ending .pts begins with the number of its points.
    if let [(_, first), (_, second), ..] = &rows[..]
        && first.len() == 1
        && second.len() > 1
    {
        rows.remove(0);
    }
    let Some((line, first)) = rows.first() else { return Ok(Model::default()) };
    let named =
        names.as_deref().and_then(|names| layout_of_names(&names.iter().map(String::as_str).collect::<Vec<_>>()));
    if first.len() < 3 {
        return Err(format!("line {line}: three numbers expected, separated by commas, semicolons or blanks"));
    }
    let attributes = names.as_deref().map(|names| attributes(&rows, names)).unwrap_or_default();
    if let Some([present, missing]) = names.as_deref().and_then(half_a_normal) {
        return Err(format!("has `{present}` but no `{missing}`: expected nx, ny and nz, or none of them"));
    }
    Ok(Model { attributes, ..model(&rows, named.unwrap_or_else(|| layout_of_numbers(&rows)))? })
}

/// A part of a normal among the names, and one that is not.
fn half_a_normal(names: &[String]) -> Option<[&'static str; 2]> {
    let parts = &NAMES[NORMAL..COLOR];
    let is_present = |part: &[&str; 3]| names.iter().any(|name| part.contains(&name.to_lowercase().as_str()));
    let present = parts.iter().find(|part| is_present(part))?;
    let missing = parts.iter().find(|part| !is_present(part))?;
    Some([present[0], missing[0]])
}

/// The columns of other names that hold a number at least.
fn attributes(rows: &[(usize, Vec<f64>)], names: &[String]) -> BTreeMap<String, Vec<f64>> {
    let others = names.iter().enumerate().map(|(column, name)| (column, name.to_lowercase()));
    let others = others.filter(|(_, name)| !NAMES.iter().flatten().any(|known| known == name));
    let values =
        |column: usize| rows.iter().map(move |(_, row)| row.get(column).copied().unwrap_or(f64::NAN)).collect();
    let columns = others.map(|(column, name)| (name, values(column)));
    columns.filter(|(_, values): &(_, Vec<f64>)| !values.iter().all(|value| value.is_nan())).collect()
}

fn model(rows: &[(usize, Vec<f64>)], layout: Layout) -> Result<Model, String> {
    let Layout { point, normal, color } = layout;
    let needed = [Some(point), normal, color].into_iter().flatten().flatten().max().unwrap_or_default() + 1;
    if let Some((line, row)) = rows.iter().find(|(_, row)| row.len() < needed) {
        return Err(format!("line {line}: {needed} numbers expected, as in the lines before, not {}", row.len()));
    }
    let values = |columns: [usize; 3]| rows.iter().map(move |(_, row)| columns.map(|column| row[column]));
    let vectors = |columns| values(columns).map(DVec3::from_array).collect();
    Ok(Model {
        points: vectors(point),
        normals: normal.map(vectors),
        colors: color.map(|columns| colors::linear(&values(columns).collect::<Vec<_>>())),
        ..Model::default()
    })
}

/// The words of a line; of two commas in a row the word between them is empty, of two blanks there is none.
fn split(line: &str) -> Vec<&str> {
    let words: Box<dyn Iterator<Item = &str>> = match [';', ','].into_iter().find(|separator| line.contains(*separator))
    {
        Some(separator) => Box::new(line.split(separator)),
        None => Box::new(line.split_whitespace()),
    };
    words.map(|word| word.trim().trim_matches('"').trim()).take(COLUMNS_LIMIT).collect()
}

/// The numbers of a line; what follows them, such as a label, is left alone.
fn numbers(words: &[&str], line: usize) -> Result<Vec<f64>, String> {
    let mut numbers = Vec::with_capacity(words.len());
    for (column, word) in words.iter().enumerate() {
        match word.parse() {
            Ok(number) => numbers.push(number),
            // A field left empty is a point that was not measured.
            Err(_) if word.is_empty() => numbers.push(f64::NAN),
            Err(_) if column < 3 => return Err(format!("line {line}: `{word}` is not a number")),
            Err(_) => numbers.push(f64::NAN),
        }
    }
    Ok(numbers)
}

/// What the columns are by their names, if the coordinates are among them.
fn layout_of_names(words: &[&str]) -> Option<Layout> {
    let place = |names: &[&str; 3]| words.iter().position(|word| names.contains(&word.to_lowercase().as_str()));
    let places = NAMES.each_ref().map(place);
    let three = |first: usize| Some([places[first]?, places[first + 1]?, places[first + 2]?]);
    Some(Layout { point: three(POINT)?, normal: three(NORMAL), color: three(COLOR) })
}

/// What the columns are by their number and values: beyond the coordinates three of unit length are a normal, three of 0 to 255 a color, with an
/// intensity before them or not.
fn layout_of_numbers(rows: &[(usize, Vec<f64>)]) -> Layout {
    let columns = rows.iter().map(|(_, row)| row.len()).min().unwrap_or_default();
    let tried = || rows.iter().take(LINES_TRIED);
    let all = |first: usize, holds: &dyn Fn(DVec3) -> bool| {
        first + 3 <= columns && tried().all(|(_, row)| holds(DVec3::from_slice(&row[first..])))
    };
    let is_normal = |first| all(first, &|v| (v.length() - 1.0).abs() < UNIT_TOLERANCE);
    let is_color = |first| all(first, &|v| v.min_element() >= 0.0 && v.max_element() <= f64::from(u8::MAX));
    let at = |first: usize| [first, first + 1, first + 2];
    let normal = [3, 6, 7].into_iter().find(|&first| is_normal(first));
    let color = [3, 4, 6].into_iter().find(|&first| {
        let is_apart = normal.is_none_or(|normal| normal.abs_diff(first) >= 3);
        is_apart && is_color(first)
    });
    Layout { point: at(0), normal: normal.map(at), color: color.map(at) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Model {
        parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error} in {text}"))
    }

    #[test]
    fn separators_are_those_of_the_line() {
        let expected = [DVec3::new(500_000.25, -0.5, 1e5), DVec3::new(1.0, 2.0, 3.0)];
        for text in [
            "500000.25 -.5 1e5\n1 2 3\n",
            "500000.25\t-.5\t1e5\r\n\r\n1\t2\t3",
            "500000.25, -.5, 1e5\n1,2,3\n",
            "# made by hand\n500000.25;-.5;1e5\n1;2;3;\n",
            "2\n500000.25 -.5 1e5\n1 2 3\n",
        ] {
            assert_eq!(read(text).points, expected, "{text}");
        }
    }

    #[test]
    fn names_say_what_columns_are() {
        for text in
            ["id,Z,Y,X,nx,ny,nz,R,G,B\n7,3,2,1,0,0,1,255,0,0\n", "//id Z Y X nx ny nz R G B\n7 3 2 1 0 0 1 255 0 0\n"]
        {
            let model = read(text);
            assert_eq!((model.points, model.normals), (vec![DVec3::new(1.0, 2.0, 3.0)], Some(vec![DVec3::Z])));
            assert_eq!(model.colors, Some(vec![[1.0, 0.0, 0.0]]));
        }
    }

    #[test]
    fn columns_of_other_names_are_attributes() {
        let attributes = read("x,y,z,Area,label,Height\n1,2,3,0.5,wall,7\n4,5,6,,floor,8\n").attributes;
        assert_eq!(attributes.keys().collect::<Vec<_>>(), ["area"], "a label is no number, and `height` names z");
        assert_eq!((attributes["area"][0], attributes["area"][1].is_nan()), (0.5, true));
        assert!(read("1 2 3 0.5\n").attributes.is_empty());
    }

    #[test]
    fn without_names_values_say_what_columns_are() {
        let has = |text: &str| {
            let model = read(text);
            (model.normals.is_some(), model.colors.is_some())
        };
        assert_eq!(has("1 2 3\n"), (false, false));
        assert_eq!(has("1 2 3 0.6 0 0.8\n1 2 4 0 1 0\n"), (true, false));
        assert_eq!(has("1 2 3 200 100 0\n"), (false, true));
        assert_eq!(has("1 2 3 -1000 200 100 0\n"), (false, true), "after an intensity");
        assert_eq!(has("1 2 3 200 100 0 0 0 1\n"), (true, true));
        assert_eq!(has("1 2 3 -7 8\n"), (false, false), "two columns of something else");
    }

    #[test]
    fn faults_are_named_with_their_line() {
        let fails = |text: &str, part: &str| {
            let message = parse(text.as_bytes()).expect_err("the file is bad");
            assert!(message.contains(part), "{message}");
        };
        fails("1 2\n", "line 1: three numbers");
        fails("1 2 3\n4 x 6\n", "line 2: `x`");
        fails("1 2 3\n4 5\n", "line 2: 3 numbers expected");
        assert!(read("1 2 3\n4,,6\n").points[1].is_nan(), "a field left empty");
    }
}
