"""Frames of a sphere."""

import numpy as np
import pointcore
import pytest

SPLATS = 400


def sphere():
    """Points of a unit sphere, which are their normals."""
    place = np.arange(SPLATS)
    z = 1 - (2 * place + 1) / SPLATS
    around = np.pi * (3 - np.sqrt(5)) * place
    across = np.sqrt(1 - z**2)
    return np.stack([across * np.cos(around), across * np.sin(around), z], axis=1)


def scene(**settings):
    points = sphere()
    colors = np.tile(np.float32([0.0, 1.0, 0.0]), (SPLATS, 1))
    settings = {"width": 40, "height": 32, "eye": (0, 0, 5), **settings}
    return pointcore.Scene(points, 0.17, points, colors, **settings)


@pytest.mark.parametrize("settings", [{}, {"backend": "verilog"}, {"backend": "verilog", "lockstep": True}], ids=str)
def test_a_frame_tells_of_each_sample(settings):
    frame = pointcore.render(scene(background=(0, 0, 1)), **settings)
    assert frame.mask.shape == frame.depth.shape == (32, 40) and frame.mask.dtype == bool
    assert frame.color.shape == frame.normal.shape == frame.picture.shape == (32, 40, 3)
    assert frame.color.dtype == frame.depth.dtype == frame.normal.dtype == np.float32
    assert frame.picture.dtype == np.uint8
    assert 200 < frame.mask.sum() < 32 * 40
    np.testing.assert_array_equal(np.isfinite(frame.depth), frame.mask)
    assert not frame.color[~frame.mask].any() and not frame.normal[~frame.mask].any()
    np.testing.assert_allclose(frame.color[frame.mask], np.tile([0, 1, 0], (frame.mask.sum(), 1)), atol=0.02)
    # The nearest point of the sphere is in the middle.
    assert abs(frame.depth[16, 20] - 4) < 0.05 and frame.normal[16, 20, 2] > 0.9
    assert frame.picture[0, 0].tolist() == [0, 0, 255] and frame.picture[16, 20, 1] > 100
    assert frame.report["cycles"] == frame.cycles > 0
    assert frame.report["fragments"] == frame.mask.sum()
    assert frame.report["mismatches"] == (0 if settings.get("lockstep") else None)


def test_hardware_and_model_make_the_same_frame():
    golden, verilog = (pointcore.render(scene(), backend=backend) for backend in ("golden", "verilog"))
    for name in ("color", "depth", "normal", "mask", "picture"):
        np.testing.assert_array_equal(getattr(golden, name), getattr(verilog, name))
    assert golden.cycles == verilog.cycles


def test_a_sequence_turns_around_the_scene():
    half = sphere()
    half = half[half[:, 2] > 0]
    turning = pointcore.Scene(half, np.full(len(half), 0.17), half, width=32, height=32, direction=(0, 0, 1), frames=2)
    session = pointcore.RenderSession(turning)
    assert len(session) == 2 and len(turning) == len(half)
    assert session.frame(0).mask.sum() > 10 * session.frame(1).mask.sum()
    with pytest.raises(pointcore.InputError, match="frame 2"):
        session.frame(2)


def test_a_camera_finds_the_scene_and_splats_without_normals_face_it():
    frame = pointcore.render(pointcore.Scene(sphere() + 1000.0, 0.17, width=32, height=32))
    assert frame.mask.mean() > 0.4


def curtain():
    """A blue triangle before the right half of the sphere."""
    vertices = np.float32([[0, -9, 2], [9, 0, 2], [0, 9, 2]])
    return {"vertices": vertices, "faces": np.array([[0, 1, 2]]), "vertex_colors": np.tile([0.0, 0.0, 1.0], (3, 1))}


@pytest.mark.parametrize("lockstep", [False, True])
def test_triangles_hide_splats_and_are_in_the_picture(lockstep):
    backend = "verilog" if lockstep else "golden"
    frame = pointcore.render(scene(**curtain()), backend=backend, lockstep=lockstep)
    plain = pointcore.render(scene())
    assert not frame.mask[:, 20:].any() and plain.mask[:, 20:].any()
    np.testing.assert_array_equal(frame.mask[:, :20], plain.mask[:, :20])
    np.testing.assert_array_equal(frame.picture[:, :20], plain.picture[:, :20])
    # Its highlight is white.
    assert (frame.picture[16, 20:30, 2] > 200).all() and (frame.picture[16, 20:30, :2] < 100).all()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"faces": np.array([[0, 1, 3]])}, r"face 0 is \[0, 1, 3\]: expected indices below 3"),
        ({"faces": np.array([[0, 1, -1]])}, "faces has -1: expected indices"),
        ({"faces": np.array([[0.0, 1.0, 2.0]])}, "faces has dtype float64: expected whole numbers"),
        ({"faces": np.array([0, 1, 2])}, r"faces has shape \(3,\): expected \(N, 3\)"),
        ({"faces": [[0, 1, 2]]}, "faces is of type list"),
        ({"faces": None}, "triangles need vertices and faces"),
        ({"vertex_normals": np.zeros((2, 3))}, "there are 2 vertex normals: expected 3"),
    ],
    ids=str,
)
def test_faults_of_triangles_are_named(change, message):
    with pytest.raises(pointcore.InputError, match=message):
        scene(**(curtain() | change))


def test_a_scene_is_loaded_from_a_model(tmp_path):
    model = tmp_path / "sphere.xyz"
    np.savetxt(model, sphere())
    assert len(pointcore.Scene.load(model)) == SPLATS
