"""Programs on neighborhoods: what numpy makes of the same steps bit by bit, and the same by every back end."""

import threading

import numpy as np
import pointcore
import pytest

K = 6
BACK_ENDS = [{}, {"backend": "golden"}, {"backend": "verilog"}, {"backend": "verilog", "lockstep": True}]

SPREAD = """.program spread
.setting gain: float
.setting pull: float3
.query weight: float
.neighbor weight: float
.neighbor velocity: float3
.neighbor kind: int
.kernel
d = sub neighbor.position, query.position
squared = length2 d
share = mul squared, neighbor.weight
flow = add neighbor.velocity, d
accumulate shares, share
accumulate flows, flow
accumulate kinds, neighbor.kind
.final
scaled = mul shares, gain
spread = add scaled, query.weight
pulled = add flows, pull
heavy = less query.weight, spread
place = add query.position, pulled
output spread, spread
output flow, pulled
output kinds, kinds
output valid, heavy
output position, place
"""


@pytest.fixture
def cloud():
    """Points whose coordinates are float32, with a weight, a velocity and a kind each."""
    random = np.random.default_rng(5)
    points = random.random((300, 3), dtype=np.float32)
    return points, {
        "weight": random.random(300, dtype=np.float32),
        "velocity": random.normal(size=(300, 3)).astype(np.float32),
        "kind": random.integers(-5, 5, 300),
    }


def tree_sum(terms):
    """The sum over axis 1 in the order that is part of its value (docs/programs.md)."""
    sums = np.zeros((terms.shape[0], 8, *terms.shape[2:]), terms.dtype)
    for place in range(terms.shape[1]):
        sums[:, place % 8] += terms[:, place]
    while sums.shape[1] > 1:
        sums = sums[:, 0::2] + sums[:, 1::2]
    return sums[:, 0]


def spread(points, attributes, gain, pull):
    """The program SPREAD in numpy, in float32."""
    near = pointcore.search(points, points, K).indices
    d = points[near] - points[:, None, :]
    squared = d[..., 0] * d[..., 0] + d[..., 1] * d[..., 1] + d[..., 2] * d[..., 2]
    result = tree_sum(squared * attributes["weight"][near]) * np.float32(gain) + attributes["weight"]
    flow = tree_sum(attributes["velocity"][near] + d) + np.asarray(pull, np.float32)
    kinds = attributes["kind"][near].sum(axis=1)
    return {"spread": result, "flow": flow, "kinds": kinds, "valid": attributes["weight"] < result}


@pytest.mark.parametrize("settings", BACK_ENDS, ids=str)
def test_a_program_is_numpy_bit_by_bit(cloud, settings):
    points, attributes = cloud
    given = {"gain": 3.0, "pull": (0.5, 0.25, -1)}
    found = pointcore.process(points, SPREAD, K, attributes=attributes, settings=given, **settings)
    expected = spread(points, attributes, **given)
    assert list(found.outputs) == ["spread", "flow", "kinds", "valid", "position"]
    types = {"spread": np.float32, "flow": np.float32, "kinds": np.int32, "valid": bool, "position": np.float64}
    for name, dtype in types.items():
        assert found[name].dtype == dtype and len(found[name]) == len(points)
    for name, values in expected.items():
        np.testing.assert_array_equal(found[name], values, err_msg=name)
    np.testing.assert_array_equal(found.valid, expected["valid"])
    np.testing.assert_array_equal(found.positions, points + expected["flow"])
    assert not found.capped.any() and (found.iterations == 1).all()
    if settings:
        assert found.cycles > len(points) and found.neighbors is None
        assert found.report["timings"][0]["cycles"] == found.cycles
    else:
        assert found.cycles is None and (found.neighbors == K).all()


@pytest.mark.parametrize("program, k", [("normals", 12), ("mls", 16), ("smooth", 9), ("sph", 20), ("resample", 10)])
def test_the_model_of_the_hardware_answers_as_the_interpreter(program, k):
    place = np.random.default_rng(6).uniform(-1, 1, (400, 2))
    points = np.column_stack([place, 0.2 * np.sin(3 * place[:, 0])])
    interpreted, modelled = (pointcore.process(points, program, k, backend=by) for by in ("interpreter", "golden"))
    assert interpreted.outputs.keys() == modelled.outputs.keys() and interpreted.outputs
    for name, values in interpreted.outputs.items():
        np.testing.assert_array_equal(values, modelled[name], err_msg=name)
        assert np.any(values)
    np.testing.assert_array_equal(interpreted.iterations, modelled.iterations)
    np.testing.assert_array_equal(interpreted.capped, modelled.capped)
    assert modelled.cycles == sum(timing["cycles"] for timing in modelled.report["timings"]) > 400


def test_normals_of_a_sphere_far_from_zero_point_at_the_viewpoint():
    directions = np.random.default_rng(7).normal(size=(2000, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    center = np.array([4e5, 5e6, 100.0])
    found = pointcore.process(center + directions, "normals", settings={"viewpoint": center})
    assert found.valid.all() and ((found["normal"] * directions).sum(axis=1) < -0.98).all()
    np.testing.assert_array_equal(found.positions, center + directions)


def test_queries_have_attributes_of_their_own(cloud):
    points, attributes = cloud
    settings = {"gain": 3.0, "pull": np.zeros(3)}
    everywhere = pointcore.process(points, SPREAD, K, attributes=attributes, settings=settings)
    own = {"weight": attributes["weight"][::7]}
    asked = {"attributes": attributes, "query_attributes": own, "settings": settings}
    found = pointcore.process(points, SPREAD, K, queries=points[::7], **asked)
    for name, values in everywhere.outputs.items():
        np.testing.assert_array_equal(found[name], values[::7], err_msg=name)
    light = pointcore.process(points, SPREAD, K, queries=points[::7], **(asked | {"query_attributes": {"weight": 0}}))
    assert (light["spread"] < found["spread"]).all()
    none = pointcore.process(points, SPREAD, K, queries=points[:0], **(asked | {"query_attributes": {}}))
    assert none["spread"].shape == (0,) and none["flow"].shape == none.positions.shape == (0, 3)


def test_a_radius_and_iterations_count():
    points = np.random.default_rng(8).random((500, 3))
    radius = 0.15
    exact = ((points[:, None] - points[None]) ** 2).sum(axis=2) < radius**2
    found = pointcore.process(points, "sph_density", radius=radius)
    np.testing.assert_array_equal(found.neighbors, exact.sum(axis=1))
    once, often = (pointcore.process(points, "mls", 30, iterations=limit) for limit in (1, 50))
    assert once.iterations.max() == 1 and once.capped.any() and often.iterations.max() > 1
    assert often.capped.sum() < once.capped.sum()


def test_passes_begin_where_the_one_before_ended():
    random = np.random.default_rng(9)
    points = np.column_stack([random.random((400, 2)), 0.01 * random.normal(size=400)])
    twice = pointcore.process(points, "smooth", 12, passes=2)
    once = pointcore.process(points, "smooth", 12)
    assert twice.report["passes"] == 2
    assert np.abs(twice.positions[:, 2]).mean() < np.abs(once.positions[:, 2]).mean()


def test_a_pattern_is_spread_around_each_point():
    points = np.column_stack([np.random.default_rng(10).random((200, 2)), np.zeros(200)])
    assert len(pointcore.process(points, "resample")["position"]) == 4 * len(points)
    assert len(pointcore.process(points, "resample", pattern=(3, 1))["position"]) == 3 * len(points)
    own = pointcore.process(points, "resample", attributes={"u": np.full(200, 0.01), "v": 0.0})
    assert len(own["position"]) == len(points)


def test_given_normals_are_made_ones_of_length_1():
    points = np.random.default_rng(11).random((300, 3))
    given = [np.tile([0.0, 0.0, length], (300, 1)) for length in (1.0, 4.0)] + [(0, 0, 7)]
    unit, long, shared = (pointcore.process(points, "smooth", attributes={"normal": normal}) for normal in given)
    np.testing.assert_array_equal(unit["position"], long["position"])
    np.testing.assert_array_equal(unit["position"], shared["position"])
    assert (unit["position"] != points).any()


def test_programs_are_files_too(cloud, tmp_path):
    points, attributes = cloud
    asked = {"attributes": attributes, "settings": {"gain": 1, "pull": [0, 0, 0]}}
    path = tmp_path / "spread.pasm"
    path.write_text(SPREAD)
    expected = pointcore.process(points, SPREAD, K, **asked)["spread"]
    for program in (path, str(path)):
        np.testing.assert_array_equal(pointcore.process(points, program, K, **asked)["spread"], expected)


def test_a_configuration_says_which_hardware_it_is(cloud):
    points, _ = cloud
    asked = {"k": 8, "backend": "golden"}
    narrow = 'kind = "points"\nprocess.rate = 8\n'
    usual = pointcore.process(points, "covariance", **asked)
    slow = pointcore.process(points, "covariance", config=narrow, **asked)
    assert slow.cycles > 2 * usual.cycles
    np.testing.assert_array_equal(slow["normal"], usual["normal"])


def test_a_session_carries_out_again_while_other_threads_go_on():
    random = np.random.default_rng(12)
    session = pointcore.ProcessSession("normals", backend="golden")
    clouds, found = [random.random((800, 3)) for _ in range(2)], [None, None]

    def process(number):
        found[number] = session.process(clouds[number], 20)

    threads = [threading.Thread(target=process, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    # With the interpreter's lock held throughout, nothing would be counted before both have ended.
    steps = 0
    while any(thread.is_alive() for thread in threads):
        steps += 1
        threads[0].join(0.001)
    for thread in threads:
        thread.join()
    assert steps > 2
    for own, result in zip(clouds, found):
        np.testing.assert_array_equal(result["normal"], pointcore.process(own, "normals", 20)["normal"])


NOT_ADDED = SPREAD.replace("add neighbor.velocity, d", "add neighbor.velocity, 1")
HOLED = np.full((300, 3), 0.5)
HOLED[7, 1] = np.nan


@pytest.mark.parametrize(
    "program, changed, message",
    [
        ("smoothe", {}, "there is no operation `smoothe`: expected normals, "),
        (NOT_ADDED, {}, r"program:12:8: `add` of float3, int: expected"),
        ("normals", {"points": np.zeros((300, 2))}, r"points has shape \(300, 2\): expected \(N, 3\)"),
        ("normals", {"points": np.zeros((0, 3))}, "the point set is empty"),
        ("normals", {"points": HOLED}, "vertex 7"),
        ("normals", {"points": np.zeros((300, 3))}, "all points lie in one place.*expected a radius"),
        ("normals", {"queries": HOLED}, "vertex 7"),
        ("normals", {"queries": np.zeros(3)}, r"queries has shape \(3,\)"),
        ("normals", {"k": 0}, "k is 0: expected 1 to 64"),
        ("normals", {"k": 65}, "k is 65: expected 1 to 64"),
        ("normals", {"k": -1}, "k is -1"),
        ("normals", {"radius": 0.0}, "radius is 0"),
        ("normals", {"radius": np.nan}, "radius is NaN"),
        ("normals", {"iterations": 0}, "0 iterations: expected 1 to 65535"),
        ("normals", {"passes": 0}, "passes is 0"),
        ("normals", {"passes": 2}, "expected an operation that moves points"),
        ("normals", {"pattern": (2, 2)}, "carry no offsets"),
        ("resample", {"pattern": (0, 2)}, "expected 1 to 64 columns and rows"),
        ("normals", {"settings": {"speed": 1}}, "`normals` has no setting `speed`: its settings are inverse_radius2"),
        ("normals", {"settings": {"viewpoint": 1}}, "`viewpoint` of `normals` has 1 numbers: expected 3 for a float3"),
        ("normals", {"settings": {"least_spread": np.nan}}, "`least_spread` of `normals` is NaN"),
        ("normals", {"settings": {"least_spread": "small"}}, "`least_spread` of settings is of type str"),
        (SPREAD, {"settings": {"pull": (0, 0, 0)}}, "setting `gain` of `spread` does not follow from the points"),
        (SPREAD, {"settings": {"pull": (0, 0, 0), "gain": 1}}, "reads neighbor.weight .float.: expected an attribute `weight`"),
        ("sph", {"attributes": {"density": 1000.0}}, "`density` of `sph` is what its program `sph_density` finds"),
        ("smooth", {"attributes": {"heat": 1.0}}, "reads no field `heat`: its fields are normal"),
        ("smooth", {"attributes": {"area": np.ones(3)}}, r"`area` of points.*\(3,\): expected \(300,\), or a number"),
        ("smooth", {"attributes": {"normal": np.ones((3, 300))}}, r"shape \(3, 300\): expected \(300, 3\)"),
        ("smooth", {"attributes": {"normal": HOLED}}, "normal.*vertex 7"),
        ("smooth", {"attributes": {"normal": np.zeros((300, 3))}}, "zero at all points"),
        ("smooth", {"attributes": {"area": HOLED[:, 1]}}, "points: area of vertex 7 is NaN: expected a number"),
        ("smooth", {"attributes": {"area": np.ones(300, complex)}}, "`area` of attributes has dtype complex128"),
        ("smooth", {"attributes": {3: 1.0}}, "attributes has the key 3"),
        ("smooth", {"query_attributes": {"area": 1.0}}, "query_attributes go with queries"),
        ("normals", {"backend": "gpu"}, 'back end is "gpu"'),
        ("normals", {"lockstep": True}, 'lockstep goes with the back end "verilog"'),
        ("normals", {"config": 'kind = "points"'}, "the interpreter knows no hardware"),
        ("normals", {"config": 'kind = "search"', "backend": "golden"}, "is not for the point processor"),
    ],
    ids=lambda value: None if isinstance(value, dict) else str(value)[:30],
)
def test_each_mistake_is_one_clear_error(program, changed, message):
    asked = {"points": np.random.default_rng(13).random((300, 3)), "program": program, **changed}
    with pytest.raises(pointcore.InputError, match=message) as raised:
        pointcore.process(**asked)
    assert "--" not in str(raised.value), "an option of the command"


def test_what_is_no_text_or_file_is_refused():
    points = np.random.default_rng(13).random((300, 3))
    with pytest.raises(pointcore.FileError, match="no/such.pasm: cannot be read"):
        pointcore.process(points, "no/such.pasm")
    with pytest.raises(TypeError):
        pointcore.process(points, 3)
    with pytest.raises(KeyError):
        pointcore.process(points, "normals")["position"]
    with pytest.raises(pointcore.InputError, match="the interpreter carries out programs alone"):
        pointcore.search(points, points, backend="interpreter")
