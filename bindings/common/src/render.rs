//! Rendering: a scene in, arrays of a frame out.

use crate::search::CONFIGURATION;
use crate::{BackEnd, BindingError, Scene};
use pointcore::configuration::{self, Configuration};
use pointcore::plan::Plan;
use pointcore::shading;
use pointcore::splat::{Drawn, RenderSession, SplatReport, SplatRun};
use pointcore_tb::verilated::Trace;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

/// A scene, and the core that renders it.
pub struct Render {
    /// A session shows one frame at a time.
    session: Mutex<RenderSession>,
    frames: usize,
    back_end: BackEnd,
}

/// A frame: arrays row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Samples a row: those of a pixel are one, unless a scene file asks for more.
    pub width: usize,
    /// Rows of samples.
    pub height: usize,
    /// Linear RGB of the surface, three a sample, not shaded; zero where there is none.
    pub color: Vec<f32>,
    /// Distance from the eye's plane; infinite where there is no surface.
    pub depth: Vec<f32>,
    /// World-space normal, three a sample, of a length up to one; zero where there is no surface.
    pub normal: Vec<f32>,
    /// 1 where there is a surface, 0 elsewhere.
    pub mask: Vec<u8>,
    /// Pixels a row of the picture, and its rows.
    pub picture_size: [usize; 2],
    /// The shaded picture on its background, sRGB, three bytes a pixel.
    pub picture: Vec<u8>,
    /// Cycles from the first splat to the end of the frame.
    pub cycles: u64,
    /// The report's figures, a JSON object.
    pub report: String,
}

impl Render {
    /// Generates the core of a scene, or of a configuration given as TOML, and builds it if it is to run.
    ///
    /// # Errors
    /// The configuration is none of the renderer's, or does not go with the scene; tools are missing or fail.
    pub fn open(scene: &Scene, configuration: Option<&str>, back_end: BackEnd) -> Result<Self, BindingError> {
        let Scene(scene) = scene;
        let plan = match configuration.map(|text| configuration::parse(Path::new(CONFIGURATION), text)).transpose()? {
            None => Plan::of(scene)?,
            Some(Configuration::Splat(config)) => Plan::on(scene, &config)?,
            Some(Configuration::Search(_) | Configuration::Points(_)) => {
                let problem = "is not for the renderer: rendering needs one with the line `kind = \"splat\"`";
                return Err(configuration::wrong(Path::new(CONFIGURATION), problem).into());
            }
        };
        let session = RenderSession::on(scene.clone(), plan, back_end.render()?, Trace::Off)?;
        Ok(Self { frames: session.frames(), session: Mutex::new(session), back_end })
    }

    /// Frames of the scene's sequence, one at least.
    #[must_use]
    pub const fn frames(&self) -> usize {
        self.frames
    }

    /// Renders a frame of the sequence, which counts from 0.
    ///
    /// # Errors
    /// There is no such frame; hardware and model differ.
    pub fn frame(&self, index: usize) -> Result<Frame, BindingError> {
        // A session renders every frame from its scene: a panic leaves nothing behind that another frame would read.
        let mut session = self.session.lock().unwrap_or_else(PoisonError::into_inner);
        let rendered = session.frame(index)?;
        let reference = session.reference();
        let (samples, outcome) = (&rendered.samples, &rendered.outcome);
        let report = SplatReport::new(&SplatRun {
            scene: "scene in memory",
            engine: self.back_end.name(),
            config: &session.plan().config,
            memory: *session.memory(),
            fates: rendered.fates,
            outcome,
            drawn: Drawn::Frame { frame: samples, reference: &reference },
            psnr_db: rendered.picture.psnr_db(&shading::picture(&reference, session.scene())),
            // A difference would end the run.
            mismatches: (self.back_end == BackEnd::VerilogInLockstep).then_some(0),
        });
        let count = samples.pixels.len();
        let mut frame = Frame {
            width: samples.width,
            height: samples.height,
            color: vec![0.0; 3 * count],
            depth: vec![f32::INFINITY; count],
            normal: vec![0.0; 3 * count],
            mask: vec![0; count],
            picture_size: [rendered.picture.width, rendered.picture.height],
            picture: rendered.picture.bytes(),
            cycles: report.cycles,
            report: serde_json::to_string(&report).expect("reports have string keys"),
        };
        for fragment in &rendered.fragments {
            let place = fragment.row * samples.width + fragment.column;
            frame.color[3 * place..][..3].copy_from_slice(&fragment.color);
            frame.depth[place] = fragment.depth as f32;
            frame.normal[3 * place..][..3].copy_from_slice(&fragment.normal);
            frame.mask[place] = 1;
        }
        Ok(frame)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ErrorKind, Mesh, Plan, Sides, Splats, View, Viewpoint};

    /// A wall of discs in the plane z = 0, gray, that faces along z.
    fn wall() -> Splats {
        let points: Vec<_> = (0..49_u8).map(|i| [f64::from(i % 7) - 3.0, f64::from(i / 7) - 3.0, 0.0]).collect();
        let normals = Some(vec![[0.0, 0.0, 2.0]; points.len()]);
        let colors = Some(vec![[0.5; 3]; points.len()]);
        Splats { points, normals, radii: vec![0.9], colors, sides: Sides::Front }
    }

    fn view(eye: [f64; 3]) -> View {
        let viewpoint = Viewpoint::At { eye, target: [0.0; 3], fov_degrees: 60.0 };
        View { width: 24, height: 16, viewpoint, up: None, background: [0.0; 3], frames: 1 }
    }

    fn open(splats: &Splats, view: &View) -> Result<Render, BindingError> {
        Render::open(&Scene::new(splats, None, view)?, None, BackEnd::Golden)
    }

    #[test]
    fn a_frame_tells_of_each_sample() {
        let frame = open(&wall(), &view([0.0, 0.0, 10.0])).and_then(|render| render.frame(0)).expect("it can be seen");
        assert_eq!((frame.width, frame.height, frame.picture_size), (24, 16, [24, 16]));
        let middle = 8 * 24 + 12;
        assert_eq!((frame.mask[middle], frame.mask[0]), (1, 0));
        assert!((frame.depth[middle] - 10.0).abs() < 0.01, "{}", frame.depth[middle]);
        assert!(frame.normal[3 * middle + 2] > 0.99);
        let linear = pointcore::color::linear_from_srgb(0.5) as f32;
        assert!((frame.color[3 * middle] - linear).abs() < 0.01, "{}", frame.color[3 * middle]);
        assert_eq!(
            (frame.depth[0], &frame.normal[..3], &frame.picture[..3]),
            (f32::INFINITY, &[0.0; 3][..], &[0; 3][..])
        );
        assert!(frame.cycles > 0 && frame.report.contains(&format!("\"cycles\":{}", frame.cycles)), "{}", frame.report);
    }

    #[test]
    fn sides_and_normals_decide_what_is_seen_from_behind() {
        let covered = |splats: &Splats| {
            let frame = open(splats, &view([0.0, 0.0, -10.0])).and_then(|render| render.frame(0)).expect("it is sound");
            frame.mask.iter().filter(|sample| **sample == 1).count()
        };
        assert_eq!(covered(&wall()), 0);
        assert!(covered(&Splats { sides: Sides::Both, ..wall() }) > 24);
        assert!(covered(&Splats { normals: None, ..wall() }) > 24);
    }

    /// A blue triangle before the upper half of the wall.
    fn curtain() -> Mesh {
        let vertices = vec![[-9.0, 0.0, 1.0], [9.0, 0.0, 1.0], [0.0, 20.0, 1.0]];
        Mesh { vertices, faces: vec![[0, 1, 2]], normals: None, colors: Some(vec![[0.0, 0.0, 1.0]; 3]) }
    }

    #[test]
    fn triangles_hide_splats_and_are_in_the_picture() {
        let view = view([0.0, 0.0, 10.0]);
        let frame = |mesh: Option<&Mesh>| {
            let scene = Scene::new(&wall(), mesh, &view).expect("it is sound");
            Render::open(&scene, None, BackEnd::Golden).and_then(|render| render.frame(0)).expect("it can be seen")
        };
        let (with, without) = (frame(Some(&curtain())), frame(None));
        let [above, below] = [4, 11].map(|row| row * 24 + 12);
        assert_eq!((with.mask[above], with.mask[below], without.mask[above]), (0, 1, 1));
        let [red, green, blue] = [0, 1, 2].map(|channel| with.picture[3 * above + channel]);
        // Its highlight is white.
        assert!(blue > 200 && red < 100 && green < 100, "{red} {green} {blue}");
        assert_eq!(with.picture[3 * below..][..3], without.picture[3 * below..][..3]);
        let counted = "\"hidden\":";
        assert!(with.report.contains(counted) && !with.report.contains(&format!("{counted}0,")), "{}", with.report);
    }

    #[test]
    fn faults_of_a_mesh_are_named() {
        let message = |mesh: Mesh| {
            let error = Scene::new(&wall(), Some(&mesh), &view([0.0, 0.0, 10.0])).expect_err("something is wrong");
            assert_eq!(error.kind, ErrorKind::Input);
            error.message
        };
        let faces = vec![[0, 1, 2], [0, 1, 3]];
        assert_eq!(message(Mesh { faces, ..curtain() }), "face 1 is [0, 1, 3]: expected indices below 3");
        let colors = Some(vec![[0.0; 3]; 2]);
        assert_eq!(message(Mesh { colors, ..curtain() }), "there are 2 vertex colors: expected 3, one for each vertex");
        let colors = Some(vec![[0.0, 0.0, 2.0]; 3]);
        assert!(message(Mesh { colors, ..curtain() }).starts_with("vertex color 0 is [0.0, 0.0, 2.0]"));
        let vertices = vec![[0.0, f64::NAN, 0.0]; 3];
        assert!(message(Mesh { vertices, ..curtain() }).starts_with("vertex 0 is"));
        let flat = Mesh { vertices: vec![[1.0; 3]; 3], ..curtain() };
        assert!(message(flat).starts_with("no face has an area: without one"));
        let normals = Some(vec![[0.0, 0.0, f64::NAN], [0.0; 3], [0.0; 3]]);
        assert!(message(Mesh { normals, ..curtain() }).starts_with("all normals are zero: without any"));
    }

    #[test]
    fn a_plan_is_the_hardware_of_a_scene_and_a_turn_has_its_frames() {
        let view = View { viewpoint: Viewpoint::From([0.0, 0.0, 1.0]), frames: 2, ..view([0.0; 3]) };
        let scene = Scene::new(&wall(), None, &view).expect("it is sound");
        let plan = Plan::scene(&scene).expect("there is hardware for it");
        assert!(plan.text().contains("49 splats") && plan.text().contains("multipliers"), "{}", plan.text());
        let render = Render::open(&scene, Some(&plan.toml()), BackEnd::Golden).expect("its own hardware holds it");
        assert_eq!(render.frames(), 2);
        let covered = |index| render.frame(index).map(|frame| frame.mask.contains(&1));
        assert_eq!([covered(0), covered(1)], [Ok(true), Ok(false)]);
        assert_eq!(covered(2).map_err(|error| error.kind), Err(ErrorKind::Input));
    }

    #[test]
    fn faults_of_the_input_are_named() {
        let message = |splats: Splats| {
            let error = open(&splats, &view([0.0, 0.0, 10.0])).err().expect("something is wrong");
            assert_eq!(error.kind, ErrorKind::Input);
            error.message
        };
        assert!(
            message(Splats {
                radii: vec![1.0, -1.0],
                points: vec![[0.0; 3]; 2],
                normals: None,
                colors: None,
                ..wall()
            })
            .contains("radius 1 is -1")
        );
        assert!(message(Splats { radii: vec![], ..wall() }).contains("0 radii: expected 49"));
        assert!(message(Splats { normals: Some(vec![]), ..wall() }).contains("0 normals"));
        assert!(message(Splats { colors: Some(vec![[2.0; 3]; 49]), ..wall() }).contains("color 0"));
        assert!(message(Splats { points: vec![[f64::NAN; 3]; 49], ..wall() }).contains("discs.0"));
        assert!(!message(Splats { points: vec![], normals: None, colors: None, ..wall() }).is_empty());
        let search = "kind = \"search\"";
        let scene = Scene::new(&wall(), None, &view([0.0, 0.0, 10.0])).expect("it is sound");
        let error = Render::open(&scene, Some(search), BackEnd::Golden).err().expect("it is no renderer's");
        assert!(error.message.contains("is not for the renderer"), "{error}");
        let missing = Scene::load(Path::new("no/such.toml")).expect_err("there is none");
        assert_eq!(missing.kind, ErrorKind::File);
    }
}
