//! Pixels come back as they were written, when latency, bandwidth and bursts say.

use super::*;
use pointcore_contract::splat::records::PlacedPixel;

fn config() -> Config {
    Config { width: 16, height: 8, continuous: 6, ..Config::default() }
}

/// Pixels of the second tile.
const fn run(pixel: u8, count: u8) -> PixelRun {
    PixelRun { surface: false, tile: 1, pixel, count }
}

/// All pixels of a tile.
const fn whole(tile: u32) -> PixelRun {
    PixelRun { surface: false, tile, pixel: 0, count: TILE_PIXELS as u8 }
}

fn value(pixel: u8) -> Pixel {
    Pixel { weight: 100 + u32::from(pixel), ..Pixel::default() }
}

fn stored(tile: u32, pixel: u8) -> StoredPixel {
    StoredPixel { surface: false, placed: PlacedPixel { tile, pixel, value: value(pixel) } }
}

/// A buffer whose second tile is written, and the cycle in which the last pixel was accepted.
fn written(settings: MemorySettings) -> (ReconstructionBuffer, u64) {
    let mut buffer = ReconstructionBuffer::new(&config(), settings);
    let (mut now, mut pixel) = (0, 0);
    while pixel < PIXELS as u8 {
        buffer.advance(now);
        if buffer.is_writable(now) {
            buffer.write(0, &stored(1, pixel), now);
            pixel += 1;
        }
        now += 1;
    }
    (buffer, now - 1)
}

/// Requests runs in cycle `now`, takes every pixel as soon as it is offered: cycles and weights.
fn read(buffer: &mut ReconstructionBuffer, runs: &[PixelRun], now: u64) -> Vec<(u64, u32)> {
    runs.iter().for_each(|run| buffer.request(0, *run, now));
    let mut seen = vec![];
    for cycle in now..now + 2000 {
        buffer.advance(cycle);
        if let Some(pixel) = buffer.offer(0, cycle) {
            seen.push((cycle - now, pixel.weight));
            buffer.take(0);
        }
    }
    seen
}

#[test]
fn reads_return_what_was_written_after_the_latency_a_pixel_a_cycle() {
    let (mut buffer, last) = written(MemorySettings { latency_cycles: 3, ..ReconstructionBuffer::SETTINGS });
    assert_eq!(last, 63, "a write a cycle");
    let seen = read(&mut buffer, &[whole(1), whole(0)], 100);
    let expected = (0..64).map(|pixel| (3 + pixel, 100 + pixel as u32)).chain((64..128).map(|pixel| (3 + pixel, 0)));
    assert_eq!(seen, expected.collect::<Vec<_>>());
    let traffic = buffer.traffic();
    assert_eq!((traffic.read, traffic.written, traffic.busy_cycles), (128, 64, 128));
    assert_eq!(traffic.bytes, 192 * u64::from(pixel_bytes(&config())));
}

#[test]
fn a_run_of_any_length_is_read() {
    let (mut buffer, _) = written(MemorySettings { latency_cycles: 5, ..ReconstructionBuffer::SETTINGS });
    let runs = [run(7, 3), run(63, 1)];
    assert_eq!(read(&mut buffer, &runs, 100), [(5, 107), (6, 108), (7, 109), (8, 163)]);
}

#[test]
fn reads_and_writes_share_a_bandwidth() {
    let bytes = f64::from(pixel_bytes(&config()));
    let settings = |pixels: f64| MemorySettings {
        latency_cycles: 1,
        bytes_per_cycle: Some(pixels * bytes),
        ..ReconstructionBuffer::SETTINGS
    };
    let (mut buffer, last) = written(settings(0.5));
    assert_eq!(last, 126, "a write every second cycle");
    // A read in the midst of writes waits for the bus, and they for the read.
    buffer.request(0, whole(0), 200);
    buffer.advance(201);
    assert!(!buffer.is_writable(201) && !buffer.is_writable(328) && buffer.is_writable(329));
    assert_eq!(buffer.traffic().busy_cycles, 256);
    let (_, last) = written(settings(4.0));
    assert_eq!(last, 63, "the port takes no more than a pixel a cycle");
}

#[test]
fn bursts_are_moved_whole_and_once() {
    let settings = MemorySettings { burst_bytes: 64, ..ReconstructionBuffer::SETTINGS };
    let tile = (64 * u64::from(pixel_bytes(&config()))).next_multiple_of(64);
    let (mut buffer, _) = written(settings);
    assert_eq!(buffer.traffic().bytes, tile, "pixels of a burst share it");
    read(&mut buffer, &[run(2, 1)], 100);
    assert_eq!(buffer.traffic().bytes, tile + 64, "a single pixel takes a burst");
}

#[test]
fn every_port_moves_a_pixel_a_cycle_and_all_share_a_bandwidth() {
    let config = Config { rasterizers: 2, memory_ports: 2, ..config() };
    let bytes = f64::from(pixel_bytes(&config));
    for (bytes_per_cycle, last, busy_cycles) in [(None, 63, 64), (Some(bytes), 127, 256)] {
        let settings = MemorySettings { latency_cycles: 3, bytes_per_cycle, ..ReconstructionBuffer::SETTINGS };
        let mut buffer = ReconstructionBuffer::new(&config, settings);
        let (mut now, mut pixels) = (0, 0);
        while pixels < PIXELS as u8 {
            if buffer.is_writable(now) {
                (0..2).for_each(|port| buffer.write(port, &stored(port as u32, pixels), now));
                pixels += 1;
            }
            now += 1;
        }
        assert_eq!(now - 1, last - u64::from(bytes_per_cycle.is_some()), "two pixels at once");
        (0..2).for_each(|port| buffer.request(port, whole(port as u32), now));
        let mut came = [vec![], vec![]];
        for cycle in now..now + 400 {
            buffer.advance(cycle);
            for (port, came) in came.iter_mut().enumerate() {
                if let Some(pixel) = buffer.offer(port, cycle) {
                    came.push((cycle - now, pixel.weight));
                    buffer.take(port);
                }
            }
        }
        assert!(came.iter().all(|came| came.iter().map(|(_, weight)| *weight).eq(100..164)));
        let [first, second] = came.map(|came| came[63].0);
        assert!(first < second && second <= 3 + last + 32, "{first}, {second}");
        assert_eq!(buffer.traffic().busy_cycles, busy_cycles);
    }
}
