//! Color images: writing, one or a sequence, comparing, magnifying differences; and images of numbers.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use std::fs::File;
use std::io::{BufWriter, Error, Write};
use std::path::{Path, PathBuf};

/// An image of sRGB-encoded components in `0..=1`, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green and blue of each pixel.
    pub pixels: Vec<[f64; 3]>,
}

/// An image that cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("{}: cannot be written: {source}", path.display())]
pub struct PictureError {
    path: PathBuf,
    source: Error,
}

impl PictureError {
    fn new(path: &Path, source: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self { path: path.to_owned(), source: Error::other(source) }
    }
}

/// Frames of an animation in a second.
const FRAMES_PER_SECOND: u16 = 12;

/// An animated PNG in the making, which every browser shows; it plays without end.
pub struct Animation {
    path: PathBuf,
    writer: png::Writer<BufWriter<File>>,
    /// Frames still to come.
    missing: usize,
}

impl Animation {
    /// Begins a file of so many frames of a size.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn create(path: &Path, [width, height]: [usize; 2], frames: usize) -> Result<Self, PictureError> {
        let fault = |error: png::EncodingError| PictureError::new(path, error);
        let file = File::create(path).map_err(|source| PictureError { path: path.to_owned(), source })?;
        let mut encoder = png::Encoder::new(BufWriter::new(file), width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_animated(frames as u32, 0).map_err(fault)?;
        encoder.set_frame_delay(1, FRAMES_PER_SECOND).map_err(fault)?;
        let writer = encoder.write_header().map_err(fault)?;
        Ok(Self { path: path.to_owned(), writer, missing: frames })
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// The file cannot be written, or the frame is of another size or one too many.
    pub fn push(&mut self, picture: &Picture) -> Result<(), PictureError> {
        let missing = self.missing.checked_sub(1);
        self.missing = missing.ok_or_else(|| PictureError::new(&self.path, "it has all its frames"))?;
        self.writer.write_image_data(&picture.bytes()).map_err(|error| PictureError::new(&self.path, error))
    }

    /// Closes the file.
    ///
    /// # Errors
    /// The file cannot be written, or frames are missing.
    pub fn finish(self) -> Result<(), PictureError> {
        let path = self.path;
        self.writer.finish().map_err(|error| PictureError::new(&path, error))
    }
}

/// An image of numbers, one or three a pixel, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct FloatImage<const CHANNELS: usize> {
    /// Pixels a row.
    pub width: usize,
    /// The numbers of each pixel.
    pub pixels: Vec<[f32; CHANNELS]>,
}

impl<const CHANNELS: usize> FloatImage<CHANNELS> {
    /// Writes a PFM (portable float map), which image viewers and OpenCV read: `PF` of three numbers a pixel, `Pf` of one.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn save_pfm(&self, path: &Path) -> Result<(), PictureError> {
        const { assert!(CHANNELS == 1 || CHANNELS == 3, "the format has no others") };
        let kind = if CHANNELS == 1 { "Pf" } else { "PF" };
        let height = self.pixels.len() / self.width.max(1);
        // Little-endian, says the negative scale; the lowest row comes first.
        let mut bytes = format!("{kind}\n{} {height}\n-1.0\n", self.width).into_bytes();
        for row in self.pixels.chunks(self.width.max(1)).rev() {
            bytes.extend(row.iter().flatten().flat_map(|number| number.to_le_bytes()));
        }
        let written = File::create(path).and_then(|mut file| file.write_all(&bytes));
        written.map_err(|source| PictureError { path: path.to_owned(), source })
    }
}

/// Red, green and blue of a picture of some width and height as a PNG.
pub(crate) fn png(bytes: &[u8], [width, height]: [usize; 2]) -> Vec<u8> {
    let mut png = Vec::new();
    PngEncoder::new(&mut png)
        .write_image(bytes, width as u32, height as u32, ExtendedColorType::Rgb8)
        .expect("there are three bytes a pixel, and memory can be written");
    png
}

impl Picture {
    /// The components as bytes, pixel by pixel.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let quantize = |component: &f64| (component.clamp(0.0, 1.0) * f64::from(u8::MAX)).round() as u8;
        self.pixels.iter().flatten().map(quantize).collect()
    }

    /// Writes an 8-bit PNG.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn save_png(&self, path: &Path) -> Result<(), PictureError> {
        std::fs::write(path, self.png()).map_err(|source| PictureError { path: path.to_owned(), source })
    }

    /// As an 8-bit PNG.
    #[must_use]
    pub fn png(&self) -> Vec<u8> {
        png(&self.bytes(), [self.width, self.height])
    }

    /// Peak signal-to-noise ratio in decibels, over the sRGB-encoded components without rounding to 8 bits; infinite
    /// for equal pictures.
    ///
    /// # Panics
    /// The pictures differ in size.
    #[must_use]
    pub fn psnr_db(&self, other: &Self) -> f64 {
        self.assert_same_size(other);
        let squares = self.pixels.iter().flatten().zip(other.pixels.iter().flatten()).map(|(a, b)| (a - b).powi(2));
        let mean = squares.sum::<f64>() / (3 * self.pixels.len()) as f64;
        -10.0 * mean.log10()
    }

    /// The absolute differences of the components, multiplied by `magnification` and clipped at 1.
    ///
    /// # Panics
    /// The pictures differ in size.
    #[must_use]
    pub fn difference(&self, other: &Self, magnification: f64) -> Self {
        self.assert_same_size(other);
        let pixel = |(a, b): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|i| ((a[i] - b[i]).abs() * magnification).min(1.0));
        Self { pixels: self.pixels.iter().zip(&other.pixels).map(pixel).collect(), ..*self }
    }

    fn assert_same_size(&self, other: &Self) {
        let sizes = ((self.width, self.height), (other.width, other.height));
        assert_eq!(sizes.0, sizes.1, "pictures must be of one size to be compared");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(value: f64) -> Picture {
        Picture { width: 2, height: 1, pixels: vec![[value; 3]; 2] }
    }

    #[test]
    fn psnr_of_a_uniform_error_is_its_decibels() {
        assert!((gray(0.5).psnr_db(&gray(0.4)) - 20.0).abs() < 1e-9);
        assert_eq!(gray(0.5).psnr_db(&gray(0.5)), f64::INFINITY);
    }

    #[test]
    fn differences_are_magnified_and_clipped() {
        assert!((gray(0.5).difference(&gray(0.49), 10.0).pixels[1][2] - 0.1).abs() < 1e-9);
        assert_eq!(gray(0.9).difference(&gray(0.1), 10.0), gray(1.0));
    }

    #[test]
    fn an_animation_has_its_frames() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("animation.png");
        let mut animation = Animation::create(&path, [2, 1], 2).expect("the folder is writable");
        for value in [0.2, 0.6] {
            animation.push(&gray(value)).expect("the folder is writable");
        }
        assert!(animation.push(&gray(1.0)).is_err(), "one too many");
        let mut animation = Animation::create(&path, [2, 1], 2).expect("the folder is writable");
        for value in [0.2, 0.6] {
            animation.push(&gray(value)).expect("the folder is writable");
        }
        animation.finish().expect("all frames are there");
        let file = std::io::BufReader::new(File::open(&path).expect("it was just written"));
        let mut reader = png::Decoder::new(file).read_info().expect("it is a PNG");
        assert_eq!(reader.info().animation_control().map(|control| control.num_frames), Some(2));
        let mut bytes = [0; 6];
        for expected in [51, 153] {
            reader.next_frame(&mut bytes).expect("the frame is there");
            assert_eq!(bytes, [expected; 6]);
        }
    }

    #[test]
    fn numbers_are_written_as_they_are_from_the_lowest_row() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("depth.pfm");
        let image = FloatImage { width: 1, pixels: vec![[1.5], [f32::INFINITY]] };
        image.save_pfm(&path).expect("the folder is writable");
        let expected = [&b"Pf\n1 2\n-1.0\n"[..], &f32::INFINITY.to_le_bytes(), &1.5_f32.to_le_bytes()].concat();
        assert_eq!(std::fs::read(&path).expect("it was just written"), expected);
        assert!(image.save_pfm(&folder.path().join("missing/depth.pfm")).is_err());
    }

    #[test]
    fn a_written_png_reads_back() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("gray.png");
        gray(0.2).save_png(&path).expect("the folder is writable");
        let read = image::open(&path).expect("the file was just written").to_rgb8();
        assert_eq!((read.dimensions(), read.get_pixel(1, 0).0), ((2, 1), [51; 3]));
        assert!(gray(0.2).save_png(&folder.path().join("missing/gray.png")).is_err());
    }
}
