//! Graph 1 of the thesis (5.7.1) anew: bytes between chip and memory for a frame, against the split of equal storage between reorder stage
//! and tile cache.
//!
//! Stages with heap and with lists are whole frames of the golden model. Beside them all storage is a cache without reordering.

mod lru;
mod storage;

use super::bounds::TABLE_SCENES;
use super::page::{FigurePage, PageLine};
use super::{SCAN_SCENE, load_shipped};
use crate::{Figures, LabError, note};
use pointcore::splat::{EncodedFrame, Fates, SplatCore, SplatRunner, copy_tiles};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{Reordering, TILE_PIXELS};
use pointcore_contract::splat::records::pixel_bytes;
use rayon::prelude::*;
use std::path::Path;
use storage::{Payload, payload_bytes, reorder_bits, slot_bits};

/// Storage on the chip in kB, of 1,024 bytes.
const STORAGE_KB: [u64; 2] = [16, 64];
/// Levels of the reorder stage, the logarithm of the copies that it holds.
const LEVELS: [u32; 6] = [2, 4, 6, 8, 10, 12];
/// Slots that the tile cache has at least, and at most.
const SLOTS: [u64; 2] = [2, 64];
/// What orders copies, by name.
const ORDERS: [(&str, Reordering); 2] = [("heap", Reordering::Heap), ("lists", Reordering::Lists)];
/// Bytes of a megabyte.
const MB: f64 = 1e6;

/// A frame whose traffic is measured.
struct Scene {
    name: String,
    core: SplatCore,
    config: Config,
    frame: EncodedFrame,
    /// Splats that have copies.
    splats: u64,
    /// The tiles of its copies in the order in which they come.
    tiles: Vec<u32>,
}

/// A way to divide the storage.
#[derive(Clone)]
struct Split {
    kb: u64,
    payload: Payload,
    config: Config,
}

impl Split {
    /// The split with a reorder stage of so many levels; none if there is no room for two slots, or for more than the cache has.
    fn new(config: &Config, kb: u64, heap_levels: u32, reorder: Reordering, payload: Payload) -> Option<Self> {
        // A splat has about two copies; in memory there is a place for each.
        let splat_levels = match payload {
            Payload::OnChip => heap_levels - 1,
            Payload::InMemory => heap_levels,
        };
        let mut config = Config { heap_levels, splat_levels, reorder, ..config.clone() };
        let left = storage_bits(kb).checked_sub(reorder_bits(&config, payload))?;
        let slots = left / slot_bits(&config);
        config.tile_slots = slots as u32;
        (SLOTS[0]..=SLOTS[1]).contains(&slots).then_some(Self { kb, payload, config })
    }

    /// Share of the storage that is the reorder stage's.
    fn share(&self) -> f64 {
        reorder_bits(&self.config, self.payload) as f64 / storage_bits(self.kb) as f64
    }

    /// What is moved for a frame.
    fn traffic(&self, scene: &Scene) -> Result<Traffic, LabError> {
        let runner = SplatRunner::new(&self.config, &scene.frame);
        let buffer = runner.golden(&scene.core)?.counters.buffer;
        let pixel_bytes = (buffer.read + buffer.written) * u64::from(pixel_bytes(&self.config));
        let payload_bytes = match self.payload {
            Payload::OnChip => 0,
            Payload::InMemory => (scene.splats + scene.tiles.len() as u64) * payload_bytes(&self.config),
        };
        Ok(Traffic { pixel_bytes, payload_bytes })
    }
}

/// Bytes between chip and memory for a frame.
#[derive(Clone, Copy)]
struct Traffic {
    /// To and from the reconstruction buffer.
    pixel_bytes: u64,
    /// Of payloads in memory, written once a splat and read once a copy.
    payload_bytes: u64,
}

impl Traffic {
    const fn bytes(self) -> u64 {
        self.pixel_bytes + self.payload_bytes
    }
}

const fn storage_bits(kb: u64) -> u64 {
    kb * 1024 * u8::BITS as u64
}

/// Measures Graph 1 on the scan, if one is given, and on the scene that stands for the thesis' first; writes its page to `folder`.
///
/// # Errors
/// A scene cannot be loaded, a frame does not come to its end, or the page cannot be written.
pub fn figures(scan: Option<&Path>, folder: &Path, figures: &mut Figures) -> Result<(), LabError> {
    let mut page = FigurePage::new(folder, "Graph 1", "tile copies of whole frames");
    for path in [SCAN_SCENE, TABLE_SCENES[0]] {
        let Some((scene, plan)) = load_shipped(path, scan)? else { continue };
        let (config, core) = (plan.config.clone(), SplatCore::generate(&plan.config)?);
        let frame = EncodedFrame::new(&scene, &plan);
        let tiles = copy_tiles(&config, &frame);
        let name = path.rsplit('/').next().unwrap_or(path).to_owned();
        let splats = Fates::of(&config, &frame).drawn;
        let scene = Scene { name, core, config, frame, splats, tiles };
        for kb in STORAGE_KB {
            note!("graph 1: {}, {kb} kB", scene.name);
            chart(&scene, kb, &mut page, figures)?;
        }
    }
    page.save()
}

/// An order of copies and where they wait, with the splits and what each moves, by [`LEVELS`].
struct Stage {
    order: &'static str,
    payload: Payload,
    points: Vec<Option<(Split, Traffic)>>,
}

impl Stage {
    fn measured(
        scene: &Scene,
        kb: u64,
        (order, reorder): (&'static str, Reordering),
        payload: Payload,
    ) -> Result<Self, LabError> {
        let point = |levels: &u32| {
            let split = Split::new(&scene.config, kb, *levels, reorder, payload);
            split.map(|split| Ok((split.clone(), split.traffic(scene)?))).transpose()
        };
        Ok(Self { order, payload, points: LEVELS.par_iter().map(point).collect::<Result<_, LabError>>()? })
    }

    /// Its line in a chart of megabytes.
    fn line(&self, what: &str, bytes: impl Fn(&Traffic) -> u64) -> PageLine {
        let mut line = PageLine::new(&format!("{}, {what}", self.order));
        self.points.iter().for_each(|point| {
            line.push_if(point.as_ref().map(|(_, traffic)| bytes(traffic) as f64 / MB));
        });
        line
    }

    /// Adds its figures, and says what its splits are.
    fn tell(&self, key: &str, figures: &mut Figures) -> String {
        let mut text = format!("{}, {}:", self.order, self.payload.words());
        for (split, traffic) in self.points.iter().flatten() {
            let Config { tile_slots, .. } = split.config;
            let (copies, share) = (split.config.pointers(), split.share());
            let key = format!("{key}.{}_{}.{copies}", self.order, self.payload.name());
            figures.insert(format!("{key}.bytes"), traffic.bytes().into());
            figures.insert(format!("{key}.payload_bytes"), traffic.payload_bytes.into());
            figures.insert(format!("{key}.slots"), tile_slots.into());
            figures.insert(format!("{key}.reorder_share"), share.into());
            text += &format!(" {copies}: {:.0} %, {tile_slots} slots;", 100.0 * share);
        }
        text.trim_end_matches(';').to_owned() + "."
    }
}

/// The chart of a scene and a storage.
fn chart(scene: &Scene, kb: u64, page: &mut FigurePage, figures: &mut Figures) -> Result<(), LabError> {
    let key = format!("graph1.{}.{kb}kb", scene.name);
    let stages = Payload::ALL.into_iter().flat_map(|payload| ORDERS.map(|order| (order, payload)));
    let stages: Vec<_> = stages.collect();
    let stages: Vec<Stage> = stages
        .into_par_iter()
        .map(|(order, payload)| Stage::measured(scene, kb, order, payload))
        .collect::<Result<_, _>>()?;

    let slots = storage_bits(kb) / slot_bits(&scene.config);
    let moves = lru::play(&scene.tiles, slots as usize);
    let cached = (moves.read + moves.written) * u64::from(TILE_PIXELS * pixel_bytes(&scene.config));
    figures.insert(format!("{key}.lru.bytes"), cached.into());
    figures.insert(format!("{key}.lru.slots"), slots.into());
    let mut cache = PageLine::new("no reordering, all of it an LRU cache");
    LEVELS.iter().for_each(|_| cache.push(cached as f64 / MB));

    let lines = stages.iter().map(|stage| stage.line(stage.payload.words(), |traffic| traffic.bytes()));
    let in_memory = stages.iter().find(|stage| stage.payload == Payload::InMemory);
    let uncounted = in_memory.map(|stage| stage.line("copies in memory not counted", |traffic| traffic.pixel_bytes));
    let lines: Vec<_> = std::iter::once(cache).chain(lines).chain(uncounted).collect();
    let copies = LEVELS.map(|levels| (1 << levels).to_string());
    let title = format!("{}, {kb} kB on the chip: MB to and from memory", scene.name);
    page.lines(&key, &title, "copies in the reorder stage; the rest is tile slots", "MB", &copies, lines)?;
    let splits: Vec<_> = stages.iter().map(|stage| stage.tell(&key, figures)).collect();
    page.paragraph(&format!(
        "The reorder stage's share of the storage, and tile slots, by copies. {}",
        splits.join(" ")
    ));
    Ok(())
}
