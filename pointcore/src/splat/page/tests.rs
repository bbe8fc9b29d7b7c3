use super::*;
use crate::scene::{Disc, Scene};
use crate::splat::activity::{State, Unit};
use crate::splat::{Drawn, RenderEngine, RenderSession, RenderedFrame, SplatRun};
use serde_json::Value;

/// A wall of discs that cover each other, on hardware whose tile cache is too small for it.
fn session() -> RenderSession {
    let disc = |index: u16| {
        let [column, row] = [index % 24, index / 24].map(|place| f64::from(place) * 0.25);
        let depth = f64::from(index % 3) * 0.01;
        Disc::new([column, row, depth].into(), [0.0, 0.0, 1.0].into(), 0.4).colored([1.0, 0.5, f32::from(index % 2)])
    };
    let scene =
        Scene::of((0..24 * 16).map(disc).collect()).image(70, 44).camera([3.0, 2.0, 9.0], [3.0, 2.0, 0.0], 30.0);
    let mut scene = scene.build().expect("the scene is right");
    scene.overrides.insert("tile_slots".into(), 2.into());
    RenderSession::open(scene, RenderEngine::Golden).expect("the golden model needs no tools")
}

fn report(session: &RenderSession, frame: &RenderedFrame) -> SplatReport {
    SplatReport::new(&SplatRun {
        scene: "a < b",
        engine: "golden",
        config: &session.plan().config,
        memory: *session.memory(),
        fates: frame.fates,
        outcome: &frame.outcome,
        drawn: Drawn::Frame { frame: &frame.samples, reference: &session.reference() },
        psnr_db: 31.25,
        mismatches: None,
    })
}

fn html(session: &RenderSession, frame: &RenderedFrame) -> String {
    let mut reference = frame.picture.clone();
    reference.pixels[0][1] += 1.0 / 300.0;
    let pictures = FramePictures { frame: frame.picture.clone(), reference };
    RunPage {
        report: &report(session, frame),
        pictures: &pictures,
        activity: &frame.outcome.activity,
        plan: session.plan(),
        still: None,
        notes: &["one point is <no> number".to_owned()],
        sequence: &[],
        animation: None,
    }
    .html()
}

fn data(html: &str, id: &str) -> Value {
    let (_, rest) = html.split_once(&format!("id=\"{id}\">")).expect("the data are there");
    let (json, _) = rest.split_once("</script>").expect("a script ends");
    serde_json::from_str(&json.replace("<\\/", "</")).expect("the data are JSON")
}

/// The counts in the image of a map, as the page's script reads them.
fn counts(map: &Value) -> Vec<u64> {
    use base64::Engine as _;
    let address = map["image"].as_str().expect("a map has an image");
    let text = address.strip_prefix("data:image/png;base64,").expect("it is its own address");
    let bytes = base64::engine::general_purpose::STANDARD.decode(text).expect("it is base64");
    let image = image::load_from_memory(&bytes).expect("it is a PNG").to_rgb8();
    let size = [image.width(), image.height()].map(Value::from);
    assert_eq!(map["size"], Value::from(size.to_vec()));
    image.pixels().map(|pixel| pixel.0.iter().fold(0, |count, digit| count << 8 | u64::from(*digit))).collect()
}

#[test]
fn maps_and_timeline_sum_to_the_figures_of_the_report() {
    let mut session = session().randomized(pointcore_tb::lockstep::Stall::Random(0.1), 3);
    let frame = session.frame(0).expect("the frame ends");
    let (report, events) = (report(&session, &frame), frame.outcome.counters.events);
    let html = html(&session, &frame);
    let maps = data(&html, "maps")["maps"].clone();
    let written = frame.outcome.counters.buffer.written;
    let expected = [report.samples, report.accumulated, events.hazard, written];
    assert!(expected.iter().all(|sum| *sum > 0), "{expected:?} would show nothing");
    for (index, sum) in expected.into_iter().enumerate() {
        assert_eq!(counts(&maps[index]).iter().sum::<u64>(), sum, "{}", maps[index]["title"]);
        assert_eq!(maps[index]["sum"], sum);
    }

    let activity = &frame.outcome.activity;
    assert_eq!(activity.samples().expect("the model shows its units").copies, report.copies);
    assert!(report.bound_fraction < 1.0 && report.bounds.iter().all(|bound| bound.cycles <= report.bound.cycles));
    let timeline = activity.timeline();
    assert_eq!(timeline.cycles(), frame.outcome.simulated_cycles);
    for (unit, state, cycles) in [
        (Unit::Rasterizer, State::Busy, report.samples),
        (Unit::Rasterizer, State::Starved, events.starved),
        (Unit::Rasterizer, State::Held, events.blocked),
        (Unit::Accumulator, State::Busy, report.accumulated),
        (Unit::Accumulator, State::Pixel, events.hazard),
        (Unit::Accumulator, State::Tile, events.slot_wait),
    ] {
        assert_eq!(timeline.total(unit, state), cycles, "{unit:?} {state:?}");
    }
    for unit in Unit::ALL {
        let all: u64 = State::ALL.iter().map(|state| timeline.total(unit, *state)).sum();
        assert_eq!(all, timeline.cycles(), "{unit:?}");
        assert!(timeline.total(unit, State::Busy) > 0, "{unit:?} is never busy");
    }
    // Every unit works on what the frame has of its items, for its interval.
    let config = &session.plan().config;
    let records = report.splats + 1;
    assert_eq!(timeline.total(Unit::Transform, State::Busy), records * u64::from(config.transform_interval));
    assert_eq!(timeline.total(Unit::Normalizer, State::Busy), report.fragments + 1);
    let strips = data(&html, "timeline");
    let rasterizer =
        strips["units"].as_array().expect("units are a list").iter().find(|row| row["name"] == "rasterizer");
    let busy = rasterizer.expect("it is there")["states"][0].as_array().expect("slices are a list").clone();
    assert_eq!(busy.iter().filter_map(Value::as_u64).sum::<u64>(), report.samples);
}

#[test]
fn a_page_has_the_figures_of_its_report() {
    let mut session = session();
    let frame = session.frame(0).expect("the frame ends");
    let (report, html) = (report(&session, &frame), html(&session, &frame));
    assert!(
        html.contains("<title>a &lt; b, drawn by the renderer</title>") && html.contains("one point is &lt;no&gt;")
    );
    let utilisation = format!("{:.1} %", 100.0 * report.rasterizer_utilisation);
    for figure in [
        report.fates.drawn.to_string(),
        report.cycles.to_string(),
        format!("{:.3}", report.cycles_per_sample),
        "31.2 dB".to_owned(),
        "–".to_owned(),
        utilisation.clone(),
    ] {
        assert!(html.contains(&format!("<dd>{figure}</dd>")), "{figure}");
    }
    assert!(html.contains(&format!("aria-label=\"rasterizer\"></canvas><b>{utilisation}</b>")));
    for choice in &session.plan().choices {
        assert!(html.contains(&crate::page::escape(&choice.reason)), "{}", choice.part);
    }
    assert!(
        html.contains("magnified 256 times; the largest is 0.333 % of the range") && !html.contains("://"),
        "it needs nothing besides"
    );
}

#[test]
fn hardware_alone_tells_what_its_ports_do_and_says_what_is_missing() {
    let mut session = session();
    let frame = session.frame(0).expect("the frame ends");
    let mut seen = Activity::at_ports(&session.plan().config);
    seen.see_ports(&Default::default(), &Default::default());
    let page = maps::add(timeline::add(Page::new(""), &seen, &report(&session, &frame)), &seen).html();
    assert!(page.contains("run with --model golden") && page.contains("shows its ports alone: of the other units"));
    assert_eq!(
        (data(&page, "maps")["maps"].as_array().map(Vec::len), page.matches("data-unit=").count()),
        (Some(1), 3)
    );
}
