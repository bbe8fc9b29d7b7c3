//! Color images: writing, comparing, magnifying differences.

use std::path::Path;

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
    path: std::path::PathBuf,
    source: image::ImageError,
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
        let bytes = self.bytes();
        image::save_buffer_with_format(
            path,
            &bytes,
            self.width as u32,
            self.height as u32,
            image::ColorType::Rgb8,
            image::ImageFormat::Png,
        )
        .map_err(|source| PictureError { path: path.to_owned(), source })
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
    fn a_written_png_reads_back() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("gray.png");
        gray(0.2).save_png(&path).expect("the folder is writable");
        let read = image::open(&path).expect("the file was just written").to_rgb8();
        assert_eq!((read.dimensions(), read.get_pixel(1, 0).0), ((2, 1), [51; 3]));
        assert!(gray(0.2).save_png(&folder.path().join("missing/gray.png")).is_err());
    }
}
