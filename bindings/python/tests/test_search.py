"""Neighbors against brute force, layouts of arrays, threads."""

import threading

import numpy as np
import pointcore
import pytest

K = 6


def brute_force(points, queries, k):
    """Exact squared distances of the k nearest points, nearest first."""
    distances2 = ((queries[:, None, :].astype(float) - points[None, :, :].astype(float)) ** 2).sum(axis=2)
    return np.sort(distances2, axis=1)[:, :k], distances2


def check(points, queries, found, k):
    nearest, all_distances2 = brute_force(points, queries, k)
    assert found.indices.shape == found.distances2.shape == (len(queries), k)
    assert found.indices.dtype == np.int64 and found.distances2.dtype == np.float32
    assert (found.counts == k).all() and found.cycles > len(queries)
    # Each at its distance, and none left out is nearer.
    own = np.take_along_axis(all_distances2, found.indices, axis=1)
    np.testing.assert_allclose(own, nearest, rtol=1e-5)
    np.testing.assert_allclose(found.distances2, nearest, rtol=1e-5)
    assert all(len(set(row)) == k for row in found.indices.tolist())


@pytest.fixture
def cloud():
    random = np.random.default_rng(1)
    return random.random((1000, 3)), random.random((100, 3))


@pytest.mark.parametrize("settings", [{}, {"backend": "verilog"}, {"backend": "verilog", "lockstep": True}], ids=str)
def test_neighbors_are_those_of_brute_force(cloud, settings):
    points, queries = cloud
    check(points, queries, pointcore.search(points, queries, K, **settings), K)


@pytest.mark.parametrize(
    "layout",
    [
        np.asfortranarray,
        lambda array: np.repeat(array, 2, axis=0)[::2],
        lambda array: array[::-1][::-1],
        lambda array: np.hstack([array, array])[:, :3],
        lambda array: array.astype(array.dtype.newbyteorder()),
        lambda array: np.ascontiguousarray(array[:, ::-1])[:, ::-1],
    ],
)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_arrays_of_any_layout_are_taken(cloud, layout, dtype):
    points, queries = (array.astype(dtype) for array in cloud)
    expected = pointcore.search(points, queries, K)
    found = pointcore.search(layout(points), layout(queries), K)
    np.testing.assert_array_equal(found.indices, expected.indices)
    np.testing.assert_array_equal(found.distances2, expected.distances2)


def test_a_radius_leaves_neighbors_out(cloud):
    points, queries = cloud
    radius = 0.08
    found = pointcore.search(points, queries, 10, radius)
    exact = (brute_force(points, queries, 10)[0] < radius**2).sum(axis=1)
    np.testing.assert_array_equal(found.counts, exact)
    assert 0 < exact.sum() < 10 * len(queries)
    missing = np.arange(10)[None, :] >= found.counts[:, None]
    np.testing.assert_array_equal(found.indices == -1, missing)
    np.testing.assert_array_equal(np.isinf(found.distances2), missing)


def test_a_session_answers_again_and_with_fewer(cloud):
    points, queries = cloud
    session = pointcore.SearchSession(points, k=20)
    check(points, queries, session.search(queries), 20)
    check(points, queries, session.search(queries, k=3), 3)
    empty = session.search(queries[:0])
    assert empty.indices.shape == (0, 20) and empty.counts.shape == (0,) and empty.cycles == 0


def test_coordinates_of_a_map_keep_their_neighbors():
    random = np.random.default_rng(2)
    points = np.array([412_345.67, 5_654_321.09, 120.0]) + random.random((500, 3))
    found = pointcore.search(points, points[:50], 1)
    np.testing.assert_array_equal(found.indices[:, 0], np.arange(50))


def test_other_threads_go_on_and_search_as_well(cloud):
    points, _ = cloud
    random = np.random.default_rng(3)
    session = pointcore.SearchSession(points, K)
    queries, found = [random.random((3000, 3)) for _ in range(2)], [None, None]

    def search(number):
        found[number] = session.search(queries[number])

    threads = [threading.Thread(target=search, args=(number,)) for number in range(2)]
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
    for own, result in zip(queries, found):
        check(points, own, result, K)


def test_a_configuration_is_taken_from_a_plan(cloud):
    points, queries = cloud
    plan = pointcore.plan(points, k=K)
    check(points, queries, pointcore.search(points, queries, K, config=plan), K)
    found = pointcore.search(points, queries, K, config=plan.toml.replace("lanes = 4", "lanes = 1"))
    check(points, queries, found, K)
    assert found.cycles > pointcore.search(points, queries, K, config=plan).cycles
