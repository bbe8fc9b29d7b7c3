use super::*;
use pointcore_spec::Format;
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
fn overrides_that_do_not_fit_name_key_and_remedy() {
    for (object, setting, parts) in [
        (SPHERE, "frob = 1", ["`overrides.frob`", "`heap_levels`"]),
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
