"""Each mistake is one clear error."""

import numpy as np
import pointcore
import pytest

POINTS = np.random.default_rng(4).random((50, 3))


@pytest.mark.parametrize(
    "points, message",
    [
        (POINTS[:, :2], r"points has shape \(50, 2\): expected \(N, 3\)"),
        (POINTS.ravel(), r"points has shape \(150,\): expected \(N, 3\)"),
        (POINTS.astype(int), "points has dtype int64: expected float32 or float64"),
        (POINTS.astype(np.float16), "points has dtype float16"),
        (POINTS.astype(complex), "points has dtype complex128"),
        (POINTS.tolist(), "points is of type list: expected a numpy array of float32 or float64"),
        (None, "points is of type NoneType"),
        (POINTS[:0], "the point set is empty"),
        (np.where(POINTS == POINTS[3], np.nan, POINTS), "vertex 3"),
    ],
    ids=str,
)
def test_arrays(points, message):
    with pytest.raises(pointcore.InputError, match=message):
        pointcore.search(points, POINTS, 2)


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"k": 0}, "k is 0"),
        ({"k": -1}, "k is -1"),
        ({"k": 65}, "k is 65"),
        ({"radius": -1.0}, "the radius is -1"),
        ({"backend": "gpu"}, 'back end is "gpu": expected "golden" or "verilog"'),
        ({"lockstep": True}, 'lockstep goes with the back end "verilog"'),
        ({"config": "kind = 3"}, "line 1"),
        ({"config": 'kind = "splat"'}, "is for the renderer"),
    ],
    ids=str,
)
def test_settings_of_a_search(settings, message):
    with pytest.raises(pointcore.InputError, match=message):
        pointcore.search(POINTS, POINTS, **settings)


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"radii": 0.0}, "radius 0 is 0"),
        ({"radii": np.ones(3)}, "there are 3 radii: expected 50"),
        ({"radii": "large"}, "radii is of type str"),
        ({"normals": POINTS[:4]}, "there are 4 normals: expected 50"),
        ({"colors": POINTS * 255}, "expected sRGB from 0 to 1"),
        ({"width": -4}, "width is -4"),
        ({"width": 0}, "image.width"),
        ({"eye": (0, 0, 0), "target": (0, 0, 0)}, "camera"),
        ({"eye": (0, 0, 5), "direction": (0, 0, 1)}, "both given"),
        ({"target": (0, 0, 5)}, "go with an eye"),
        ({"frames": 0}, "is 0: expected 1 to 2000 frames"),
    ],
    ids=str,
)
def test_settings_of_a_scene(settings, message):
    with pytest.raises(pointcore.InputError, match=message):
        pointcore.Scene(POINTS, **{"radii": 0.1, **settings})


def test_kinds_are_those_of_python():
    assert issubclass(pointcore.InputError, ValueError) and issubclass(pointcore.FileError, OSError)
    assert issubclass(pointcore.HardwareError, RuntimeError) and issubclass(pointcore.InternalError, RuntimeError)
    with pytest.raises(OSError, match="no/such.toml"):
        pointcore.Scene.load("no/such.toml")


def test_a_missing_tool_is_named(monkeypatch):
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(pointcore.HardwareError, match="(?i)verilator"):
        pointcore.search(POINTS, POINTS, 2, backend="verilog")


def test_plans_are_text_and_files(tmp_path):
    plan = pointcore.plan(POINTS, k=20)
    assert str(plan) == plan.text and "tree_depth" in plan.text and "neighbors = 20" in plan.toml
    paths = pointcore.generate(plan, tmp_path / "verilog", name="mine")
    names = {str(path).rsplit("/", 1)[1] for path in paths}
    assert {"search_top.v", "search_axi.v", "config.toml", "mine.core"} <= names
    assert (tmp_path / "verilog" / "config.toml").read_text() == plan.toml
    assert "module search_top" in (tmp_path / "verilog" / "search_top.v").read_text()
    scene = pointcore.Scene(POINTS, 0.1, width=32, height=32)
    assert "back-face culling" in pointcore.plan(scene).text and 'kind = "splat"' in pointcore.plan(scene).toml
    with pytest.raises(pointcore.FileError):
        pointcore.generate(plan, tmp_path / "verilog" / "config.toml")
    with pytest.raises(pointcore.InputError):
        pointcore.generate(plan, tmp_path, name="../up")
