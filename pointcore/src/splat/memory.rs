//! The reconstruction buffer behind the renderer's memory port.

use pointcore_contract::splat::config::TILE_PIXELS;
use std::collections::VecDeque;

/// External memory that holds tiles of pixels: reads come back in order after a latency, one pixel a cycle; a read sees
/// every write accepted before it.
#[derive(Clone)]
pub struct ReconstructionBuffer {
    pixel_words: usize,
    words: Vec<u64>,
    latency: u64,
    /// Requested tiles with the cycle in which their first pixel may come.
    reads: VecDeque<(usize, u64)>,
    next_pixel: usize,
    /// Pixels read.
    pub pixels_read: u64,
    /// Pixels written.
    pub pixels_written: u64,
}

impl ReconstructionBuffer {
    /// An empty buffer of `tiles` tiles whose pixels have `pixel_words` fields.
    #[must_use]
    pub fn new(tiles: usize, pixel_words: usize, latency: u64) -> Self {
        let words = vec![0; tiles * TILE_PIXELS as usize * pixel_words];
        let reads = VecDeque::new();
        Self { pixel_words, words, latency, reads, next_pixel: 0, pixels_read: 0, pixels_written: 0 }
    }

    fn pixel(&self, tile: usize, pixel: usize) -> std::ops::Range<usize> {
        let start = (tile * TILE_PIXELS as usize + pixel) * self.pixel_words;
        start..start + self.pixel_words
    }

    /// Accepts a read of a whole tile in cycle `now`.
    pub fn request(&mut self, tile: u64, now: u64) {
        self.reads.push_back((tile as usize, now + self.latency));
    }

    /// The pixel that is on offer in cycle `now`.
    #[must_use]
    pub fn offer(&self, now: u64) -> Option<&[u64]> {
        let &(tile, ready) = self.reads.front()?;
        (ready <= now).then(|| &self.words[self.pixel(tile, self.next_pixel)])
    }

    /// The offered pixel was taken.
    pub fn take(&mut self) {
        self.pixels_read += 1;
        self.next_pixel += 1;
        if self.next_pixel == TILE_PIXELS as usize {
            self.next_pixel = 0;
            self.reads.pop_front();
        }
    }

    /// Accepts a write.
    pub fn write(&mut self, tile: u64, pixel: u64, fields: &[u64]) {
        self.pixels_written += 1;
        let place = self.pixel(tile as usize, pixel as usize);
        self.words[place].copy_from_slice(fields);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_return_what_was_written_after_the_latency() {
        let mut buffer = ReconstructionBuffer::new(2, 1, 3);
        for pixel in 0..64 {
            buffer.write(1, pixel, &[100 + pixel]);
        }
        buffer.request(1, 10);
        assert_eq!(buffer.offer(12), None);
        for pixel in 0..64 {
            assert_eq!(buffer.offer(13), Some([100 + pixel].as_slice()));
            buffer.take();
        }
        assert_eq!(buffer.offer(99), None);
        assert_eq!((buffer.pixels_read, buffer.pixels_written), (64, 64));
    }
}
