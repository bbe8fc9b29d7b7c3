use super::demand::{Demand, Load};
use super::*;
use pointcore_contract::Format;
use std::path::Path;

const HEAD: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10 }\n\
                    image = { width = 64, height = 48 }\n";
/// Half of its splats face away, and those at its rim are narrower than the screen filter.
const SPHERE: &str = "[[object]]\nkind = \"sphere\"\npoints = 500\nouter_radius = 1\n";
/// Faces the eye, with splats of a tenth of a pixel.
const DUST: &str = "[[object]]\nkind = \"plane\"\npoints = 100\nsize = 1\nrotate_degrees = [90, 0, 0]\nradius = 0.01\n";

fn plan(text: &str) -> Result<Plan, PlanError> {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("the folder is writable");
    Plan::of(&Scene::load(Path::new(&path), &[]).unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn parts_are_generated_where_the_scene_needs_them() {
    let sphere = plan(&format!("{HEAD}{SPHERE}")).expect("the scene is good").config;
    assert_eq!((sphere.culling, sphere.screen_filter), (Feature::On, Feature::On));
    let dust = plan(&format!("{HEAD}{DUST}")).expect("the scene is good").config;
    assert_eq!((dust.culling, dust.screen_filter), (Feature::Off, Feature::On));
    let plates = plan(&format!("{HEAD}{}", DUST.replace("0.01", "0.2"))).expect("the scene is good").config;
    assert_eq!((plates.culling, plates.screen_filter), (Feature::Off, Feature::Off));
    assert_eq!((dust.width, dust.height, dust.cardinal), (64, 48, 0));
}

#[test]
fn overrides_have_the_last_word() {
    let text = format!("{HEAD}{DUST}[overrides]\nculling = \"on\"\nheap_levels = 9\ngeometry = \"f24-ftz\"\n");
    let plan = plan(&text).expect("the overrides are good");
    assert_eq!((plan.config.culling, plan.config.heap_levels), (Feature::On, 9));
    assert_eq!(plan.config.geometry, Format::F24.flushed());
    assert_eq!(plan.choices.iter().filter(|choice| choice.part == "override").count(), 3);
}

#[test]
fn materials_fit_the_format_of_attributes() {
    let scene = |material: usize, format: &str| {
        let materials: String = (0..=material).map(|i| format!("[[material]]\nshininess = {i}\n")).collect();
        plan(&format!("{HEAD}{SPHERE}material = {material}\n{materials}[overrides]\nattribute = \"{format}\"\n"))
    };
    assert!(scene(255, "fixed8").is_ok() && scene(256, "fixed12").is_ok() && scene(256, "f16").is_ok());
    let message = scene(256, "fixed8").expect_err("it has 8 bits").to_string();
    assert!(
        message.contains("`overrides.attribute` = \"fixed8\"") && message.contains("256") && message.contains("9 bits"),
        "{message}"
    );
}

#[test]
fn overrides_that_do_not_fit_name_key_and_remedy() {
    for (object, setting, parts) in [
        (SPHERE, "frob = 1", ["`overrides.frob`", "`heap_levels`"]),
        (SPHERE, "implementation.heap_levels = 9", ["`overrides.implementation`", "`overrides.heap_levels`"]),
        (SPHERE, "bus.stream_bits = 32", ["`overrides.bus`", "without the table"]),
        (SPHERE, "stream_bits = 48", ["`stream_bits` = 48", "32, 64"]),
        (SPHERE, "width = 64", ["`overrides.width`", "`image.width`"]),
        (SPHERE, "height = 48", ["`overrides.height`", "`image.height`"]),
        (SPHERE, "sampling = \"flipquad\"", ["`overrides.sampling`", "`image.sampling`"]),
        (SPHERE, "kernel_gamma = 2.0", ["`overrides.kernel_gamma`", "`splatting.kernel_gamma`"]),
        (SPHERE, "continuous = 1", ["`overrides.continuous`", "normal and color"]),
        (SPHERE, "cardinal = 1", ["`overrides.cardinal`", "`material`"]),
        (SPHERE, "heap_levels = 99", ["`heap_levels` = 99", "2 to 14"]),
        (SPHERE, "heap_levels = -1", ["`overrides.heap_levels` = -1", "u32"]),
        (SPHERE, "heap_levels = \"9\"", ["`overrides.heap_levels` = \"9\"", "such as"]),
        (SPHERE, "geometry = \"f8\"", ["`overrides.geometry` = \"f8\"", "f24"]),
        (SPHERE, "attribute = \"fixed9\"", ["`overrides.attribute` = \"fixed9\"", "fixed12"]),
        (SPHERE, "rasterizer = \"fixed20\"", ["`overrides.rasterizer` = \"fixed20\"", "fixed18"]),
        (SPHERE, "culling = false", ["`overrides.culling` = false", "\"on\""]),
        (SPHERE, "culling = \"maybe\"", ["`overrides.culling` = \"maybe\"", "`off`"]),
        (SPHERE, "culling = \"off\"", ["`overrides.culling` = \"off\"", "face away"]),
        (DUST, "screen_filter = \"off\"", ["`overrides.screen_filter` = \"off\"", "filter_radius_px"]),
    ] {
        let message = plan(&format!("{HEAD}{object}[overrides]\n{setting}\n")).expect_err(setting).to_string();
        for part in parts {
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    let unfiltered = format!("{HEAD}{DUST}[splatting]\nfilter_radius_px = 0\n[overrides]\nscreen_filter = \"on\"\n");
    let message = plan(&unfiltered).expect_err("the scene has no filter").to_string();
    assert!(message.contains("screen_filter") && message.contains("filter_radius_px"), "{message}");
}

#[test]
fn a_rasterizer_in_fixed_point_says_what_it_has_no_numbers_for() {
    for (splatting, parts) in [
        ("filter_radius_px = 4.5", ["`overrides.rasterizer` = \"fixed18\"", "filter of 4.5 px", "at most 4 px"]),
        ("filter_radius_px = 0.25", ["`overrides.rasterizer` = \"fixed18\"", "filter of 0.25 px", "wider than ¼ px"]),
        ("depth = \"plane\"", ["`rasterizer` = \"fixed18\"", "`depth` = \"center\"", "floating-point"]),
    ] {
        let text = |format| format!("{HEAD}{SPHERE}[splatting]\n{splatting}\n[overrides]\nrasterizer = \"{format}\"\n");
        assert!(plan(&text("f24-ftz")).is_ok(), "{splatting}");
        let message = plan(&text("fixed18")).expect_err(splatting).to_string();
        for part in parts {
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
    }
    for radius in [0.0, 0.3, 4.0] {
        let text = format!("[splatting]\nfilter_radius_px = {radius:?}\n[overrides]\nrasterizer = \"fixed18\"\n");
        assert!(plan(&format!("{HEAD}{SPHERE}{text}")).is_ok(), "{radius} px");
    }
}

#[test]
fn what_a_rasterizer_in_fixed_point_needs_is_found_sample_by_sample() {
    for (object, screen_filter, eye_plane) in [
        (format!("{HEAD}{DUST}"), Feature::On, Feature::Off),
        (format!("{HEAD}{}", DUST.replace("0.01", "0.2")), Feature::Off, Feature::Off),
        (FLOOR.to_owned(), Feature::On, Feature::On),
    ] {
        let config = plan(&format!("{object}[overrides]\nrasterizer = \"fixed18\"\n")).expect("it is good").config;
        assert_eq!((config.screen_filter, config.eye_plane), (screen_filter, eye_plane));
    }
}

/// A floor below the eye, whose nearest splats reach behind it.
const FLOOR: &str = "camera = { eye = [0, 0.1, 0], target = [0, 0, -5], fov_degrees = 60, near = 0.05, far = 20 }\n\
                     image = { width = 64, height = 48 }\n\
                     [[object]]\nkind = \"plane\"\npoints = 100\nsize = 4\n";

#[test]
fn no_extent_of_an_effect_is_more_than_hardware_has() {
    let plan = plan(&format!("{HEAD}{SPHERE}[overrides]\ncontinuous = 14\n")).expect("the scene is good");
    let extents = Effect::STILL
        .into_iter()
        .flat_map(|effect| [EffectExtent::Least, EffectExtent::Most].map(|extent| (effect, extent)));
    let plans = extents.map(|(effect, extent)| plan.at(effect, extent)).chain([plan.with_everything()]);
    plans.for_each(|plan| assert_eq!(plan.config.validate(), Ok(())));
    assert_eq!(plan.with_everything().config.continuous, 14);
}

#[test]
fn the_eye_plane_is_seen_to_where_a_splat_reaches_it() {
    let floor = plan(FLOOR).expect("the scene is good").config;
    assert_eq!(floor.eye_plane, Feature::On);
    for object in [SPHERE, DUST] {
        let plan = plan(&format!("{HEAD}{object}")).expect("the scene is good");
        assert_eq!(plan.config.eye_plane, Feature::Off, "{:?}", plan.choices);
        assert_eq!(plan.with_everything().config.eye_plane, Feature::On);
    }
    let message = plan(&format!("{FLOOR}[overrides]\neye_plane = \"off\"\n")).expect_err("it is needed").to_string();
    for part in ["`overrides.eye_plane` = \"off\"", "reach the near, far or eye plane", "splat ", "remove the override"]
    {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

#[test]
fn no_more_tiles_are_held_than_there_are() {
    let tiny = plan(&format!("{HEAD}{SPHERE}").replace("width = 64, height = 48", "width = 8, height = 8"));
    assert_eq!(tiny.expect("the scene is good").config.tile_slots, 2);
    let usual = plan(&format!("{HEAD}{SPHERE}")).expect("the scene is good");
    assert_eq!((usual.config.tile_slots, usual.at(Effect::TileSlots, EffectExtent::Least).config.tile_slots), (8, 2));
}

#[test]
fn what_shading_does_not_read_is_left_out() {
    let checks = "color = [1, 0, 0.5]\nchecks = [4, 4]\nchecker_color = [0, 1, 0.2]\n";
    let materials = "[[material]]\nspecular = 0.5\n[[material]]\nspecular = 0.2\n";
    let two = format!("{HEAD}{materials}{SPHERE}{checks}{SPHERE}material = 1\n");
    let attributes = |text: &str| plan(text).map(|plan| (plan.attributes, plan.config.cardinal));
    assert_eq!(attributes(&two), Ok((vec![0, 1, 2, 3, 4, 5], 1)));
    assert_eq!(attributes(&format!("{two}[light]\ndiffuse = 0\nambient = 1\n")), Ok((vec![3, 4, 5], 0)));
    let alike = two.replace("0.2", "0.5");
    assert_eq!(attributes(&alike), Ok((vec![0, 1, 2, 3, 4, 5], 0)));
}

#[test]
fn more_attributes_may_be_carried_than_shading_reads() {
    let more = plan(&format!("{HEAD}{SPHERE}[overrides]\ncontinuous = 14\n")).expect("the scene is good");
    let usual = plan(&format!("{HEAD}{SPHERE}")).expect("the scene is good");
    assert_eq!((more.config.continuous, &more.attributes), (14, &usual.attributes));
}

#[test]
fn hardware_that_excludes_an_effect_is_named_with_the_remedy() {
    let scene = |text: &str| {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("scene.toml");
        std::fs::write(&path, text).expect("the folder is writable");
        Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"))
    };
    let sphere = scene(&format!("{HEAD}{SPHERE}"));
    let two =
        format!("{HEAD}[[material]]\nspecular = 0.5\n[[material]]\nspecular = 0.2\n{SPHERE}{SPHERE}material = 1\n");
    let (floor, two) = (scene(FLOOR), scene(&two));
    let unfiltered = scene(&format!("{HEAD}{SPHERE}[splatting]\nfilter_radius_px = 0\n"));
    let shared = scene(&format!("{HEAD}{SPHERE}").replace("height = 48", "height = 48, sampling = \"flipquad\""));
    let held = Config::default();
    assert!(Plan::on(&sphere, &held).is_ok(), "the default hardware renders it");
    assert!(Plan::on(&floor, &held).is_ok());
    type Change = fn(Config) -> Config;
    let excluded: [(&Scene, Change, [&str; 3]); 9] = [
        (
            &sphere,
            |c| Config { culling: Feature::Off, ..c },
            ["back-face culling", "`culling` = \"off\"", "`culling = \"on\"`"],
        ),
        (
            &sphere,
            |c| Config { screen_filter: Feature::Off, ..c },
            ["screen filter", "`screen_filter` = \"off\"", "filter_radius_px = 0"],
        ),
        (&unfiltered, |c| c, ["no screen filter", "`screen_filter` = \"on\"", "`screen_filter = \"off\"`"]),
        (
            &floor,
            |c| Config { eye_plane: Feature::Off, ..c },
            ["eye plane", "`eye_plane` = \"off\"", "`eye_plane = \"on\"`"],
        ),
        (&sphere, |c| Config { continuous: 2, ..c }, ["continuous attributes", "`continuous` = 2", "`continuous = 3`"]),
        (&two, |c| c, ["cardinal attributes", "`cardinal` = 0", "`cardinal = 1`"]),
        (&sphere, |c| Config { height: 40, ..c }, ["larger image", "`height` = 40", "`height = 48`"]),
        (&sphere, |c| Config { kernel_gamma: 1.5, ..c }, ["kernel", "`kernel_gamma` = 1.5", "`kernel_gamma = 2.0`"]),
        (&shared, |c| c, ["sampling", "`sampling` = \"center\"", "`sampling = \"flipquad\"`"]),
    ];
    for (scene, change, parts) in excluded {
        let message = Plan::on(scene, &change(held.clone())).expect_err(parts[0]).to_string();
        for part in parts {
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
        assert_eq!(message.lines().count(), 1, "{message}");
    }
}

#[test]
fn a_splat_takes_as_long_as_its_samples_leave() {
    let interval = |object: &str| {
        let config = plan(&format!("{HEAD}{object}")).expect("the scene is good").config;
        assert_eq!(config.transform_interval, config.setup_interval);
        config.setup_interval
    };
    assert_eq!(interval(&DUST.replace("0.01", "0.2")), 8, "more than ten samples a splat");
    assert_eq!(interval(&DUST.replace("size = 1", "size = 30")), 1, "most of them beside the image");
    assert_eq!(
        [(1, 0), (1, 1), (1, 2), (1, 3), (2, 11), (0, 0)].map(|(splats, samples)| Load { splats, samples }.interval(1)),
        [1, 1, 1, 2, 4, 1]
    );
    assert_eq!([1, 2, 4, 8].map(|rasterizers| Load { splats: 1, samples: 30 }.interval(rasterizers)), [8, 8, 4, 2]);
}

#[test]
fn copies_wait_while_a_frame_leaves() {
    let levels = |tiles: u32, copies, samples| {
        let load = Load { splats: 1, samples };
        Demand { copies, load, tiles: Some([[0, tiles - 1]; 2]), ..Demand::default() }.copy_levels()
    };
    // 64 pixels, and 1,024 tiles of them.
    assert_eq!([levels(1, 100, 100), levels(32, 1000, 30_000), levels(32, 1000, 60_000)], [10, 12, 11]);
    assert_eq!([levels(32, 1, 1_000_000), levels(32, 1000, 1000)], [10, 12], "what costs much block RAM is left out");
}

#[test]
fn ports_let_pixels_leave_while_samples_are_drawn() {
    let ports = |rasterizers: u32, tiles: u32, samples| {
        let load = Load { splats: 1, samples };
        Demand { load, tiles: Some([[0, tiles - 1]; 2]), ..Demand::default() }.memory_ports(rasterizers)
    };
    // 65,536 pixels beside 400,000 samples, and beside few and many.
    assert_eq!([1, 2, 4, 8].map(|rasterizers| ports(rasterizers, 32, 400_000)), [1, 2, 4, 4]);
    assert_eq!([1, 4, 8].map(|rasterizers| ports(rasterizers, 32, 1000)), [1, 4, 4]);
    assert_eq!([1, 4, 8].map(|rasterizers| ports(rasterizers, 32, 4_000_000)), [1, 1, 1]);
    assert_eq!([4, 8].map(|rasterizers| ports(rasterizers, 1, 4000)), [1, 1]);
}

#[test]
fn lanes_have_their_share_of_all_copies() {
    let planned = |rasterizers: u32| {
        let text = format!("{HEAD}{DUST}[overrides]\nrasterizers = {rasterizers}\n");
        let config = plan(&text).expect("the scene is good").config;
        (config.heap_levels, config.splat_levels)
    };
    let (copies, splats) = planned(1);
    assert_eq!(planned(4), (copies - 2, splats - 2));
}
