//! The reconstruction buffer behind the renderer's memory port.

use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::splat::records::{Pixel, PlacedPixel};
use std::collections::VecDeque;

/// Pixels of a tile.
const PIXELS: usize = TILE_PIXELS as usize;

/// External memory that holds tiles of pixels: reads come back in order after a latency, one pixel a cycle; a read sees
/// every write accepted before it.
#[derive(Clone)]
pub struct ReconstructionBuffer {
    /// By tile; one that was never written is empty.
    tiles: Vec<Option<Box<[Pixel; PIXELS]>>>,
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
    /// An empty buffer of so many tiles.
    #[must_use]
    pub fn new(tiles: usize, latency: u64) -> Self {
        let (tiles, reads) = (vec![None; tiles], VecDeque::new());
        Self { tiles, latency, reads, next_pixel: 0, pixels_read: 0, pixels_written: 0 }
    }

    /// Accepts a read of a whole tile in cycle `now`.
    pub fn request(&mut self, tile: u32, now: u64) {
        self.reads.push_back((tile as usize, now + self.latency));
    }

    /// The pixel that is on offer in cycle `now`.
    #[must_use]
    pub fn offer(&self, now: u64) -> Option<Pixel> {
        let &(tile, ready) = self.reads.front()?;
        let pixel = || self.tiles[tile].as_ref().map_or_else(Pixel::default, |pixels| pixels[self.next_pixel]);
        (ready <= now).then(pixel)
    }

    /// The offered pixel was taken.
    pub fn take(&mut self) {
        self.pixels_read += 1;
        self.next_pixel += 1;
        if self.next_pixel == PIXELS {
            self.next_pixel = 0;
            self.reads.pop_front();
        }
    }

    /// Accepts a write.
    pub fn write(&mut self, write: &PlacedPixel) {
        self.pixels_written += 1;
        let tile = self.tiles[write.tile as usize].get_or_insert_with(|| Box::new([Pixel::default(); PIXELS]));
        tile[usize::from(write.pixel)] = write.value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_return_what_was_written_after_the_latency() {
        let value = |pixel: u8| Pixel { weight: 100 + u32::from(pixel), ..Pixel::default() };
        let mut buffer = ReconstructionBuffer::new(2, 3);
        for pixel in 0..64 {
            buffer.write(&PlacedPixel { tile: 1, pixel, value: value(pixel) });
        }
        buffer.request(1, 10);
        buffer.request(0, 10);
        assert_eq!(buffer.offer(12), None);
        for pixel in 0..64 {
            assert_eq!(buffer.offer(13), Some(value(pixel)));
            buffer.take();
        }
        assert_eq!(buffer.offer(99), Some(Pixel::default()));
        assert_eq!((buffer.pixels_read, buffer.pixels_written), (64, 64));
    }
}
