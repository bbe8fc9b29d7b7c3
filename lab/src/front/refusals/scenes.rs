//! Scenes that are no scenes, and values of their keys that make no sense.

use super::{File, Rows};

pub(super) const ROWS: Rows = &[
    // The file.
    ("run gone.toml", "gone.toml", "cannot be read"),
    ("run folder.toml", "folder.toml", "Is a directory"),
    ("run empty.toml", "empty.toml", "missing field `camera`"),
    ("run prose.toml", "prose.toml: ", "line 1"),
    ("run cut.toml", "cut.toml: ", "line 3"),
    ("run latin.toml", "latin.toml", "UTF-8"),
    ("run unknown-key.toml", "unknown-key.toml: ", "unknown field `colour`"),
    ("run unknown-table.toml", "unknown-table.toml: ", "unknown field `lights`"),
    ("run no-object.toml", "no-object.toml: ", "missing field `object`"),
    ("run no-kind.toml", "no-kind.toml: ", "missing field `kind`"),
    ("run no-path.toml", "no-path.toml: `object.0.path`", "is missing"),
    ("run gone-model.toml", "gone-model.toml: `object.0.path`", "--set object.0.path=FILE"),
    ("plan gone.toml", "gone.toml", "cannot be read"),
    ("gen gone.toml -o out", "gone.toml", "cannot be read"),
    // Types.
    ("run good.toml --set image.width=wide", "image.width", "a whole number from 0 up"),
    ("run good.toml --set image.width=-3", "image.width", "a whole number from 0 up"),
    ("run good.toml --set image.width=64.5", "image.width", "a whole number from 0 up"),
    ("run good.toml --set camera.fov_degrees=wide", "camera.fov_degrees", "a number"),
    ("run good.toml --set camera.eye=5", "camera.eye", "an array of length 3"),
    ("run good.toml --set camera.eye=[0,5]", "camera.eye", "an array of length 3"),
    ("run good.toml --set camera.eye=[0,0,0,5]", "camera.eye", "fewer elements"),
    ("run good.toml --set camera.fit=yes", "camera.fit", "a boolean"),
    ("run good.toml --set camera=7", "camera", "a table"),
    ("run good.toml --set object.0.kind=cube", "object", "`sphere`"),
    ("run good.toml --set object.0.radius=large", "object", "\"spacing\""),
    ("run good.toml --set object.0.points=many", "object", "\"auto\""),
    ("run good.toml --set object.0.two_sided=maybe", "object", "\"estimated\""),
    ("run good.toml --set light.direction=sun", "light.direction", "\"camera\""),
    ("run good.toml --set image.sampling=random", "image.sampling", "`flipquad`"),
    // Keys.
    ("run good.toml --set image.widht=64", "unknown field `widht`", "`width`"),
    ("run good.toml --set frob.nicate=1", "unknown field `frob`", "`camera`"),
    ("run good.toml --set object.7.points=9", "object.7.points=9", "an index below 1"),
    ("run good.toml --set object.one.points=9", "object.one.points=9", "an index below 1"),
    ("run good.toml --set image.width.x=9", "image.width.x=9", "`image.width` is no table"),
    ("run good.toml --set image.width", "image.width", "key=value"),
    ("run good.toml --set =9", "=9", "key=value"),
    ("run good.toml --set image..width=9", "image..width=9", "key=value"),
    ("run good.toml --set overrides.frobs=9", "overrides.frobs", "`tile_slots`"),
    ("run good.toml --set overrides.tile_slots=1", "`tile_slots` = 1", "2 to 64"),
    ("run good.toml --set overrides.tile_slots=many", "`overrides.tile_slots`", "a value such as 8"),
    ("run good.toml --set overrides.width=64", "`overrides.width`", "`image.width`"),
    ("run good.toml --set overrides.geometry=f99", "overrides.geometry", "expected f32, f24"),
    // The image.
    ("run good.toml --set image.width=0", "`image.width` is 0", "expected 1 to"),
    ("run good.toml --set image.height=0", "`image.height` is 0", "expected 1 to"),
    ("run good.toml --set image.width=1000000", "`image.width` is 1000000", "expected 1 to"),
    ("run good.xyz --set image.height=99999999", "`image.height` is 99999999", "expected 1 to"),
    ("run good.toml --set image.samples=0", "`image.samples` is 0", "expected 1 to 8"),
    ("run good.toml --set image.samples=9", "`image.samples` is 9", "expected 1 to 8"),
    ("run good.toml --set image.width=4096 --set image.samples=8", "`image.samples` is 8", "expected up to"),
    ("run good.toml --set image.sampling=flipquad --set image.samples=2", "`image.sampling`", "`image.samples` = 1"),
    ("run good.toml --set image.background=[0,0,2]", "`image.background`", "0 to 1"),
    // The camera.
    ("run good.toml --set camera.target=[0,0,5]", "`camera.target`", "expected another point"),
    ("run good.toml --set camera.up=[0,0,1]", "`camera.up`", "across the viewing direction"),
    ("run good.toml --set camera.up=[0,0,0]", "`camera.up`", "across the viewing direction"),
    ("run good.toml --set camera.eye=[0,0,nan]", "`camera.eye`", "expected numbers up to"),
    ("run good.toml --set camera.eye=[0,0,1e300]", "`camera.eye`", "expected numbers up to"),
    ("run good.toml --set camera.near=10", "`camera.far` is 10", "expected more than near"),
    ("run good.toml --set camera.near=11", "`camera.far` is 10", "expected more than near"),
    ("run good.toml --set camera.near=0", "`camera.near` is 0", "expected 1e-9"),
    ("run good.toml --set camera.near=-1", "`camera.near` is -1", "expected 1e-9"),
    ("run good.toml --set camera.far=inf", "`camera.far` is inf", "to 1000000000000"),
    ("run good.toml --set camera.fov_degrees=0", "`camera.fov_degrees` is 0", "0.01 to 179"),
    ("run good.toml --set camera.fov_degrees=180", "`camera.fov_degrees` is 180", "0.01 to 179"),
    ("run good.toml --set camera.fit=true", "`camera.eye`", "give either"),
    ("run good.toml --set camera.from=[1,0,0]", "`camera.from`", "`fit = true`"),
    ("run good.toml --set camera.turntable=0", "`camera.turntable` is 0", "1 to 2000"),
    ("run good.toml --set camera.frames=5", "`camera.frames`", "two keyframes or more"),
    ("run good.xyz --set camera.from=[0,0,0]", "`camera.from`", "other than zero"),
    ("run good.xyz --set camera.up=[0,0,0]", "`camera.up`", "other than zero"),
    ("run good.xyz --set camera.near=1e9", "`camera.near`", "expected less"),
    ("run good.xyz --set camera.far=1e-9", "`camera.far`", "expected more"),
    // Light, materials, splatting.
    ("run good.toml --set light.direction=[0,0,0]", "`light.direction`", "other than zero"),
    ("run good.toml --set light.diffuse=-1", "`light.diffuse` is -1", "expected 0"),
    ("run good.toml --set light.ambient=nan", "`light.ambient` is NaN", "expected 0"),
    ("run good.toml --set object.0.material=3", "`object.0.material` is 3", "an index below 1"),
    ("run good.toml --set object.0.material=-1", "object", "a whole number from 0 up"),
    ("run good.toml --set material=[{specular=2}]", "`material.0.specular` is 2", "expected 0"),
    ("run good.toml --set splatting.cutoff=9", "`splatting.cutoff` is 9", "0.25 to 2"),
    ("run good.toml --set splatting.filter_radius_px=-1", "`splatting.filter_radius_px` is -1", "expected 0"),
    ("run good.toml --set splatting.kernel_gamma=0", "`splatting.kernel_gamma` is 0", "expected"),
    ("run good.toml --set splatting.epsilon_bias=7", "`splatting.epsilon_bias` is 7", "expected 0"),
    // Objects.
    ("run good.toml --set object.0.points=0", "`object.0.points` is 0", "expected 1 to 4000000"),
    ("run good.toml --set object.0.points=5000000", "`object.0.points` is 5000000", "expected 1 to 4000000"),
    ("run good.toml --set object.0.points=-5", "object", "\"auto\""),
    ("run good.toml --set object.0.radius=0", "`object.0.radius` is 0", "expected"),
    ("run good.toml --set object.0.radius=-1", "`object.0.radius` is -1", "expected"),
    ("run good.toml --set object.0.radius_scale=nan", "`object.0.radius_scale` is NaN", "expected"),
    ("run good.toml --set object.0.outer_radius=-1", "`object.0.outer_radius` is -1", "expected"),
    ("run good.toml --set object.0.scale=0", "`object.0.scale`", "expected"),
    ("run good.toml --set object.0.translate=[inf,0,0]", "`object.0.translate`", "expected"),
    ("run good.toml --set object.0.color=[1,1,9]", "`object.0.color`", "0 to 1"),
    ("run good.toml --set object.0.tube_radius=1", "`object.0.tube_radius`", "`sphere`"),
    ("run good.toml --set object.0.path=good.xyz", "`object.0.path`", "`sphere`"),
    ("run good.xyz --set object.0.radius_limit=-1", "`object.0.radius_limit` is -1", "expected"),
    ("run good.xyz --set object.0.points=0", "`object.0.points` is 0", "expected 1 to 4000000"),
    ("run good.toml --set object=[]", "`object` is empty", "at least one object"),
    // What is not to be seen.
    ("run good.toml --set camera.target=[0,0,9] --model reference", "good.toml", "camera.fit"),
];

/// A scene whose frame is small.
const SCENE: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10 }\n\
                     image = { width = 64, height = 48 }\n\
                     [[object]]\nkind = \"sphere\"\npoints = 500\nouter_radius = 1\n";

pub(super) fn files() -> Vec<File> {
    let scene = |from: &str, to: &str| SCENE.replacen(from, to, 1).into_bytes();
    let (before, object) = SCENE.split_once("[[object]]").expect("a scene has an object");
    vec![
        ("good.toml", SCENE.into()),
        ("empty.toml", Vec::new()),
        ("prose.toml", b"Dear reader,\nthis is no scene.\n".to_vec()),
        ("cut.toml", scene(" }\n[[", "\n[[")),
        ("latin.toml", [b"# caf\xe9\n", SCENE.as_bytes()].concat()),
        ("unknown-key.toml", scene("points", "colour = [1, 0, 0]\npoints")),
        ("unknown-table.toml", [SCENE, "[lights]\nambient = 1\n"].concat().into()),
        ("no-object.toml", before.into()),
        ("no-kind.toml", [before, "[[object]]", &object.replace("kind = \"sphere\"\n", "")].concat().into()),
        ("no-path.toml", [before, "[[object]]\nkind = \"file\"\n"].concat().into()),
        ("gone-model.toml", [before, "[[object]]\nkind = \"file\"\npath = \"gone.ply\"\n"].concat().into()),
    ]
}
