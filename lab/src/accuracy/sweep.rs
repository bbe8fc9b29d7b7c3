//! A sweep: which points there are, what of them is kept already, and measuring the rest.
//!
//! Every finished point is an entry of a cache, by the hash of the scene, the truth, the configuration and the sources of models and
//! hardware. Any number of processes may fill one cache: a sweep that was interrupted goes on where it was, and one that was spread over
//! machines is put together by running it again.

use super::figures::{PointEngine, PointFigures};
use super::measure::{PointPlan, measure, truth};
use super::point::{RenderMethod, SweepPoint};
use super::{read_result, write_result};
use crate::LabError;
use pointcore::area::estimate::Estimator;
use pointcore::area::proxy::Proxy;
use pointcore::picture::Picture;
use pointcore::plan::{MovingPlan, Plan};
use pointcore::scene::Scene;
use pointcore::splat::SplatCore;
use pointcore_tb::cache::{Cache, digest, key};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Hash of the sources that decide what a point comes to; the build script makes it.
pub(super) const SOURCES: &str = env!("POINTCORE_MODEL_SOURCES");
/// What the truth is rendered with: so many samples along each edge of a pixel, whole kernels, and each sample's own depth.
const TRUTH: [&str; 4] = ["image.samples=4", "image.sampling=center", "splatting.cutoff=1.0", "splatting.depth=plane"];
/// How much difference pictures magnify.
const MAGNIFICATION: f64 = 16.0;
/// The picture of an entry, or of the truth.
pub const FRAME: &str = "frame.png";
/// Its difference from the truth, magnified.
pub const DIFFERENCE: &str = "difference.png";

/// A scene and the hash of everything in it.
struct Loaded {
    scene: Scene,
    digest: String,
}

/// A scene under different settings; those that only change the hardware share what was loaded.
struct Scenes {
    path: PathBuf,
    settings: Vec<String>,
    loaded: Mutex<HashMap<Vec<String>, Arc<Loaded>>>,
}

/// A point that is ready to be measured.
pub struct Planned {
    /// The point.
    pub point: SweepPoint,
    scene: Arc<Loaded>,
    plan: PointPlan,
}

/// A point that was measured.
pub struct MeasuredPoint {
    /// The point.
    pub point: SweepPoint,
    /// What it came to.
    pub figures: PointFigures,
    /// Where its pictures are: [`FRAME`] and [`DIFFERENCE`].
    pub folder: PathBuf,
}

/// A sweep over a scene.
pub struct Sweep {
    scenes: Scenes,
    cache: Cache,
    hardware: PointEngine,
    truth: Arc<Loaded>,
    truth_picture: Mutex<Option<Arc<Picture>>>,
}

impl Planned {
    /// The point's hardware as configuration files, one behind the other, by which equal ones are known.
    #[must_use]
    pub fn hardware(&self) -> String {
        let file = |plan: &Plan| toml::to_string(&plan.config).expect("a configuration is a TOML table");
        self.plan.cores().into_iter().map(file).collect()
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // What is behind the locks here is whole at any time.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Scenes {
    /// The scene with more settings.
    fn load(&self, settings: &[String]) -> Result<Arc<Loaded>, LabError> {
        let all = [&self.settings[..], settings].concat();
        let mut loaded = locked(&self.loaded);
        if let Some(known) = loaded.get(&all) {
            return Ok(known.clone());
        }
        let scene = Scene::load(&self.path, &all)?;
        let digest = digest(&Scene { overrides: toml::Table::new(), ..scene.clone() });
        let new = Arc::new(Loaded { scene, digest });
        loaded.insert(all, new.clone());
        Ok(new)
    }

    /// The scene of a point, and its hardware.
    fn plan(&self, point: &SweepPoint) -> Result<(Arc<Loaded>, PointPlan), LabError> {
        let is_hardware = |setting: &String| setting.starts_with("overrides.");
        let (hardware, picture): (Vec<_>, Vec<_>) = point.arguments().into_iter().partition(is_hardware);
        let loaded = self.load(&picture)?;
        let all = [&self.settings[..], &picture, &hardware].concat();
        let overrides = Scene::overrides(&self.path, &all)?;
        let scene = &loaded.scene;
        let plan = if scene.motion.is_some() {
            PointPlan::Moving(Box::new(MovingPlan::with_overrides(scene, &overrides)?))
        } else {
            PointPlan::Still(Box::new(Plan::with_overrides(scene, &overrides)?))
        };
        Ok((loaded, plan))
    }
}

impl Sweep {
    /// A sweep over the scene of a file, with settings as [`Scene::load`] takes them; its points are kept in `folder`. Hardware is rendered on
    /// `hardware`.
    ///
    /// # Errors
    /// The scene cannot be loaded.
    pub fn open(path: &Path, settings: &[String], folder: PathBuf, hardware: PointEngine) -> Result<Self, LabError> {
        let scenes = Scenes { path: path.to_owned(), settings: settings.to_vec(), loaded: Mutex::default() };
        let truth = scenes.load(&TRUTH.map(str::to_owned))?;
        Ok(Self { scenes, cache: Cache::new(folder), hardware, truth, truth_picture: Mutex::default() })
    }

    /// Makes points ready; of those that come to the same the first stays. Those that the scene or the hardware does not admit come second, with
    /// the reason.
    #[must_use]
    pub fn plan(&self, points: Vec<SweepPoint>) -> (Vec<Planned>, Vec<(SweepPoint, LabError)>) {
        let (mut planned, mut refused, mut seen) = (Vec::new(), Vec::new(), HashSet::new());
        for point in points {
            match self.scenes.plan(&point) {
                Ok((scene, plan)) => {
                    let ready = Planned { point, scene, plan };
                    if seen.insert(self.key(&ready, self.hardware)) {
                        planned.push(ready);
                    }
                }
                Err(error) => refused.push((point, error)),
            }
        }
        (planned, refused)
    }

    fn key(&self, planned: &Planned, hardware: PointEngine) -> String {
        let Planned { point, scene, .. } = planned;
        let engine = point.engine(hardware);
        let config = match point.method {
            RenderMethod::Hardware => planned.hardware(),
            RenderMethod::Backward | RenderMethod::Forward => String::new(),
        };
        let method = format!("{:?}", point.method);
        key([SOURCES, &scene.digest, &self.truth.digest, &config, &method, engine.name()])
    }

    fn read(planned: &Planned, folder: PathBuf) -> Result<MeasuredPoint, LabError> {
        Ok(MeasuredPoint { point: planned.point.clone(), figures: read_result(&folder)?, folder })
    }

    /// What is kept of a point; what was measured in lockstep counts for the model, too.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn kept(&self, planned: &Planned) -> Result<Option<MeasuredPoint>, LabError> {
        let engines = [PointEngine::Lockstep, self.hardware];
        let folder = engines.into_iter().find_map(|engine| self.cache.existing(&self.key(planned, engine)));
        folder.map(|folder| Self::read(planned, folder)).transpose()
    }

    /// Look-up tables of a point's hardware, recorded or estimated; nothing is rendered.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn area(&self, planned: &Planned, estimator: &Estimator) -> Result<Option<f64>, LabError> {
        let mut all = Some(0.0);
        for Plan { config, .. } in planned.plan.cores() {
            let core = SplatCore::generate(config)?;
            let lut4 = estimator.estimate(config, &Proxy::of(&core.design)).lut4;
            all = all.zip(lut4).map(|(all, lut4)| all + lut4);
        }
        Ok(all)
    }

    /// Whether the scene moves while the shutter is open.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.truth.scene.motion.is_some()
    }

    /// Measures a point that is not kept.
    ///
    /// # Errors
    /// It cannot be rendered or kept.
    pub fn measure(&self, planned: &Planned) -> Result<MeasuredPoint, LabError> {
        let folder = self.cache.entry(&self.key(planned, self.hardware), |folder| {
            let Planned { point, scene, plan } = planned;
            let truth = self.truth();
            let rendered = measure(&scene.scene, plan, point.method, point.engine(self.hardware), &truth)?;
            rendered.picture.save_png(&folder.join(FRAME))?;
            rendered.picture.difference(&truth, MAGNIFICATION).save_png(&folder.join(DIFFERENCE))?;
            write_result(folder, &rendered.figures)
        })?;
        Self::read(planned, folder)
    }

    /// The truth, rendered when it is first asked for.
    fn truth(&self) -> Arc<Picture> {
        let mut known = locked(&self.truth_picture);
        known.get_or_insert_with(|| Arc::new(truth(&self.truth.scene))).clone()
    }

    /// The folder that has the truth as [`FRAME`].
    ///
    /// # Errors
    /// It cannot be written.
    pub fn truth_folder(&self) -> Result<PathBuf, LabError> {
        self.cache.entry(&key(["truth", SOURCES, &self.truth.digest]), |folder| {
            Ok::<_, LabError>(self.truth().save_png(&folder.join(FRAME))?)
        })
    }

    /// A scene file that renders a point: `pointcore run` takes it.
    ///
    /// # Errors
    /// The scene cannot be read.
    pub fn scene_file(&self, point: &SweepPoint) -> Result<String, LabError> {
        let settings = [&self.scenes.settings[..], &point.arguments()].concat();
        Ok(Scene::text(&self.scenes.path, &settings)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::point::{Knob, points};

    #[test]
    fn a_scene_that_moves_is_swept_with_both_of_its_cores() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("scene.toml");
        let text = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 30, near = 1, far = 10 }\n\
                    image = { width = 24, height = 16, background = [0.9, 0.9, 0.9] }\n\
                    shutter = { open = 0, close = 1 }\n\
                    [[object]]\nkind = \"plane\"\npoints = 100\nsize = 2\nrotate_degrees = [90, 0, 0]\ntranslate = [0, 0, -1]\n\
                    [[object]]\nkind = \"sphere\"\npoints = 200\nouter_radius = 0.5\nmotion = { velocity = [1.5, 0, 0] }\n";
        std::fs::write(&path, text).expect("a temporary folder can be written");
        let sweep = Sweep::open(&path, &[], folder.path().join("points"), PointEngine::Golden).expect("a scene");
        assert!(sweep.moves());
        let knobs = ["motion=bins:1,bins:8", "table=4,12"].map(|text| Knob::parse(text).expect("a knob"));
        let (planned, refused) = sweep.plan(points(&knobs));
        assert!(!refused.is_empty() && refused.iter().all(|(point, _)| point.name.contains("table 12")));
        let measured = |name: &str| {
            let planned = planned.iter().find(|planned| planned.point.name == name).expect("it is a point");
            assert_eq!(
                planned.hardware().matches("kind").count(),
                2,
                "a core for what moves, and one for what does not"
            );
            sweep.measure(planned).unwrap_or_else(|error| panic!("{error}")).figures
        };
        let [one, eight] = ["motion bins:1", "motion bins:8"].map(measured);
        assert!(one.surface_differences.is_none() && one.hardware.is_some_and(|hardware| hardware.cycles > 0));
        assert!(eight.psnr_db > one.psnr_db + 1.0, "{} dB and {} dB", one.psnr_db, eight.psnr_db);
    }
}
