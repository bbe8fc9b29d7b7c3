//! Whether a picture is right: beside the f64 reference, and beside where the model's points are by their own projection.

use super::program::Program;
use super::shapes::Shape;
use glam::DVec3;
use pointcore::scene::Scene;
use serde_json::Value;
use std::io::BufReader;

/// The pictures' size.
pub const WIDTH: usize = 96;
/// The pictures' height.
pub const HEIGHT: usize = 72;
/// No surface has this color, so that what is covered shows.
const BACKGROUND: [u8; 3] = [255, 0, 255];
/// Of the pixels that frame or reference cover, those that both do.
const LEAST_AGREEMENT: f64 = 0.97;
/// Of the points, those that must lie where the picture is covered, a pixel beside it included.
const LEAST_COVERED: f64 = 0.995;
/// Of the points in a color of their own, those that must be seen in it.
const LEAST_COLORED: f64 = 0.9;
/// How far an 8-bit component may be from its point's: within a splat colors blend.
const COLOR_TOLERANCE: f64 = 16.0;
/// Of the pixels with points, those whose depth must be that of the nearest point around.
const LEAST_IN_DEPTH: f64 = 0.9;
/// How far around, in pixels, where there are fewer points than pixels.
const SPARSE_REACH: usize = 2;
/// How far depths may be from it, as a share of the model's size.
const DEPTH_TOLERANCE: f64 = 0.08;
/// A camera that fits leaves no more than this share of the picture free in both directions.
const LEAST_EXTENT: f64 = 0.6;

/// What a model's picture must show.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    /// The least PSNR against the f64 reference.
    pub psnr_db: f64,
    /// Covered pixels lie no farther than this from a point of the model.
    pub reach_px: f64,
    /// Whether the points are a surface, which hides what lies behind it.
    pub is_surface: bool,
}

/// What is measured of a picture.
struct Frame {
    depths: Vec<f64>,
    colors: Vec<[u8; 3]>,
    reference: Vec<[u8; 3]>,
}

impl Frame {
    fn is_covered(&self, column: usize, row: usize) -> bool {
        self.depths[row * WIDTH + column].is_finite()
    }

    /// Whether there is a covered pixel at a place or beside it.
    fn is_near(&self, [x, y]: [f64; 2]) -> bool {
        let around = |place: f64, size: usize| place as usize..(place as usize + 3).min(size + 1);
        let mut pixels = around(y, HEIGHT).flat_map(|row| around(x, WIDTH).map(move |column| [column, row]));
        pixels.any(|[column, row]| column > 0 && row > 0 && self.is_covered(column - 1, row - 1))
    }
}

/// A point's place in the picture and its distance along the viewing direction, in the model's unit.
struct Seen {
    place: [f64; 2],
    depth: f64,
}

/// Settings under which a model's picture is judged.
#[must_use]
pub fn settings(shape: &Shape) -> Vec<String> {
    let mut settings =
        vec![format!("image.width={WIDTH}"), format!("image.height={HEIGHT}"), "image.background=[1,0,1]".to_owned()];
    if shape.colors.is_some() {
        // Colors as they are in the file.
        settings.extend(["light.ambient=1".to_owned(), "light.diffuse=0".to_owned()]);
    }
    settings
}

/// Renders a model's file; an error says what is wrong with the picture.
///
/// # Errors
/// It is not right.
pub fn judge(
    program: &Program,
    file: &str,
    shape: &Shape,
    expected: Expected,
    arguments: &[&str],
) -> Result<String, String> {
    let settings = [settings(shape), arguments.iter().map(|&argument| argument.to_owned()).collect()].concat();
    let output = format!("out/{}", file.replace('.', "-"));
    let run = ["run", file, "--model", "golden", "--depth", "--json", "-o", &output];
    let words = run.into_iter().chain(settings.iter().flat_map(|setting| ["--set", setting.as_str()]));
    let said = program.run(words)?;
    if said.code != Some(0) {
        return Err(format!("exit code {:?}: {}", said.code, said.error));
    }
    let report: Value = serde_json::from_str(&said.out).map_err(|error| format!("no report: {error}"))?;
    let frame = read(program, &output)?;
    let scene = Scene::load(&program.file(file), &settings).map_err(|error| error.to_string())?;
    let seen: Vec<Seen> = shape.seen().map(|point| project(point, &scene)).collect();

    let psnr_db = beside_reference(&frame, &report, expected)?;
    let covered = beside_points(&frame, &seen, expected)?;
    if expected.is_surface {
        beside_depths(&frame, &seen, shape)?;
    }
    if let (Some(colors), None) = (&shape.colors, &shape.surface) {
        beside_colors(&frame, &seen, colors)?;
    }
    Ok(format!("{covered} px, {psnr_db:.1} dB"))
}

/// The test's own projection through the scene's camera, which looks from where everything is seen.
fn project(point: DVec3, scene: &Scene) -> Seen {
    let (camera, place) = (&scene.camera, scene.placement.place(point));
    let [x, y, z] = camera.model_view.map(|[x, y, z, w]| DVec3::new(x, y, z).dot(place) + w);
    let place = [camera.scale_x * x / z + camera.center_x, camera.scale_y * y / z + camera.center_y];
    Seen { place, depth: z * scene.placement.unit }
}

fn beside_reference(frame: &Frame, report: &Value, Expected { psnr_db, .. }: Expected) -> Result<f64, String> {
    let count = |holds: &dyn Fn(bool, bool) -> bool| {
        let is_covered = frame.depths.iter().zip(&frame.reference);
        is_covered.filter(|(depth, color)| holds(depth.is_finite(), **color != BACKGROUND)).count() as f64
    };
    let share = count(&|frame, reference| frame && reference) / count(&|frame, reference| frame || reference).max(1.0);
    if share < LEAST_AGREEMENT {
        return Err(format!("frame and reference cover {share:.3} of their pixels together"));
    }
    let found = report["psnr_db"].as_f64().ok_or("the report has no PSNR")?;
    if found < psnr_db { Err(format!("{found:.1} dB, expected {psnr_db} dB")) } else { Ok(found) }
}

/// The silhouette: every point is covered, and nothing is covered that lies far from all points. Returns how many pixels are.
fn beside_points(frame: &Frame, seen: &[Seen], expected: Expected) -> Result<usize, String> {
    let is_inside = |[x, y]: [f64; 2]| (0.0..WIDTH as f64).contains(&x) && (0.0..HEIGHT as f64).contains(&y);
    if let Some(outside) = seen.iter().find(|seen| !is_inside(seen.place) || seen.depth <= 0.0) {
        return Err(format!("a point is at {:?}, outside the picture", outside.place));
    }
    let covered = seen.iter().filter(|seen| frame.is_near(seen.place)).count() as f64 / seen.len() as f64;
    if covered < LEAST_COVERED {
        return Err(format!("{covered:.4} of the points lie where the picture is covered"));
    }
    let pixels: Vec<[usize; 2]> = (0..WIDTH * HEIGHT)
        .map(|index| [index % WIDTH, index / WIDTH])
        .filter(|[column, row]| frame.is_covered(*column, *row))
        .collect();
    let [reach_px, reach_squared] = [expected.reach_px, expected.reach_px.powi(2)];
    let is_far = |[column, row]: &&[usize; 2]| {
        let center = [*column as f64 + 0.5, *row as f64 + 0.5];
        let is_near =
            |Seen { place: [x, y], .. }: &Seen| (x - center[0]).powi(2) + (y - center[1]).powi(2) <= reach_squared;
        !seen.iter().any(is_near)
    };
    if let Some(pixel) = pixels.iter().find(is_far) {
        return Err(format!("pixel {pixel:?} is covered, more than {reach_px} px from every point"));
    }
    let extent = |axis: usize, size: usize| {
        let places = || pixels.iter().map(|pixel| pixel[axis]);
        (places().max().unwrap_or(0) + 1 - places().min().unwrap_or(0)) as f64 / size as f64
    };
    let extent = extent(0, WIDTH).max(extent(1, HEIGHT));
    if extent < LEAST_EXTENT {
        return Err(format!("the model fills {extent:.2} of the picture's length"));
    }
    Ok(pixels.len())
}

/// Pixels show the nearest of the points within them: nothing is turned inside out, and there is no hole to look through.
fn beside_depths(frame: &Frame, seen: &[Seen], shape: &Shape) -> Result<(), String> {
    let [low, high] = shape.bounds();
    let tolerance = DEPTH_TOLERANCE * (high - low).length();
    let mut nearest = vec![f64::INFINITY; WIDTH * HEIGHT];
    for Seen { place: [x, y], depth } in seen {
        let pixel = &mut nearest[*y as usize * WIDTH + *x as usize];
        *pixel = pixel.min(*depth);
    }
    // Where points are sparse, a pixel without one of the side that is seen may have one of the other side.
    let reach = if shape.surface.is_some() { 0 } else { SPARSE_REACH };
    let around = |index: usize| {
        let (column, row) = (index % WIDTH, index / WIDTH);
        let near = |place: usize, size: usize| place.saturating_sub(reach)..(place + reach + 1).min(size);
        let rows = near(row, HEIGHT).flat_map(|row| near(column, WIDTH).map(move |column| row * WIDTH + column));
        rows.map(|index| nearest[index]).fold(f64::INFINITY, f64::min)
    };
    let known: Vec<usize> = (0..WIDTH * HEIGHT).filter(|index| nearest[*index].is_finite()).collect();
    let is_right = |index: &&usize| (around(**index) - frame.depths[**index]).abs() <= tolerance;
    let share = known.iter().filter(is_right).count() as f64 / known.len() as f64;
    if share < LEAST_IN_DEPTH {
        return Err(format!("{share:.3} of the pixels are as deep as the nearest of their points"));
    }
    Ok(())
}

/// The points nearest to the eye in their pixel are seen in their colors.
fn beside_colors(frame: &Frame, seen: &[Seen], colors: &[[u8; 3]]) -> Result<(), String> {
    let mut front: Vec<Option<usize>> = vec![None; WIDTH * HEIGHT];
    for (index, Seen { place: [x, y], depth }) in seen.iter().enumerate() {
        let pixel = &mut front[*y as usize * WIDTH + *x as usize];
        if pixel.is_none_or(|other| *depth < seen[other].depth) {
            *pixel = Some(index);
        }
    }
    let known = || front.iter().zip(&frame.colors).filter_map(|(point, color)| Some((colors[(*point)?], *color)));
    let is_right = |(point, pixel): &([u8; 3], [u8; 3])| {
        point.iter().zip(pixel).all(|(a, b)| (f64::from(*a) - f64::from(*b)).abs() <= COLOR_TOLERANCE)
    };
    let share = known().filter(is_right).count() as f64 / known().count() as f64;
    if share < LEAST_COLORED {
        return Err(format!("{share:.3} of the points are seen in their colors"));
    }
    Ok(())
}

fn read(program: &Program, output: &str) -> Result<Frame, String> {
    let picture = |name: &str| png(program, &format!("{output}/{name}"));
    let bytes = std::fs::read(program.file(format!("{output}/depth.pfm"))).map_err(|error| error.to_string())?;
    let header = format!("Pf\n{WIDTH} {HEIGHT}\n-1.0\n");
    let numbers = bytes.strip_prefix(header.as_bytes()).ok_or("depth.pfm has another header")?;
    let depths: Vec<f64> = numbers.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes).into()).collect();
    // The lowest row comes first.
    let depths = depths.chunks(WIDTH).rev().flatten().copied().collect();
    Ok(Frame { depths, colors: picture("frame.png")?, reference: picture("reference.png")? })
}

fn png(program: &Program, name: &str) -> Result<Vec<[u8; 3]>, String> {
    let fault = |error: &dyn std::fmt::Display| format!("{name}: {error}");
    let file = std::fs::File::open(program.file(name)).map_err(|error| fault(&error))?;
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().map_err(|error| fault(&error))?;
    let mut bytes = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let info = reader.next_frame(&mut bytes).map_err(|error| fault(&error))?;
    let is_expected =
        (info.width as usize, info.height as usize, info.color_type) == (WIDTH, HEIGHT, png::ColorType::Rgb);
    if is_expected { Ok(bytes.as_chunks().0.to_vec()) } else { Err(fault(&"is of another size or kind")) }
}
