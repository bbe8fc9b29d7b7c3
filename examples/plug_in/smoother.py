"""A smoother of point clouds: its own loop over neighbors, and the one call that takes the loop's place.

    pip install ./bindings/python
    python examples/plug_in/smoother.py

A torus whose points are off it at random is smoothed as of Jones, Durand and Desbrun (2003): each neighbor predicts
where a point lies on the neighbor's plane, and predictions count by a Gaussian of how far they are.
"""

import sys

import numpy as np
import pointcore

POINTS = 3000
NOISE = 0.02
K = 20
# Standard deviations of distances from neighbors, and from their predictions.
REACH, INFLUENCE = 0.15, 0.06


def torus():
    """Points beside a torus with radii 1 and 0.4, and the torus's normals."""
    random = np.random.default_rng(1)
    around, across = random.uniform(0, 2 * np.pi, (2, POINTS))
    outwards = np.column_stack([np.cos(around), np.sin(around), np.zeros(POINTS)])
    normals = np.cos(across)[:, None] * outwards + np.sin(across)[:, None] * [0.0, 0.0, 1.0]
    off = NOISE * random.normal(size=POINTS)
    return outwards + (0.4 + off)[:, None] * normals, normals


def distance_from_torus(points):
    """Root of the mean squared distance of points from the torus."""
    ring = np.hypot(points[:, 0], points[:, 1]) - 1.0
    return np.sqrt(np.mean((np.hypot(ring, points[:, 2]) - 0.4) ** 2))


def smooth_by_loop(points, normals):
    """The smoother as it was: float64, and a loop over all points."""
    smoothed = np.empty_like(points)
    for index, point in enumerate(points):
        d = points - point
        near = np.argsort((d**2).sum(axis=1))[:K]
        d, n = d[near], normals[near]
        height = (n * d).sum(axis=1)
        weight = np.exp(-(d**2).sum(axis=1) / (2 * REACH**2) - height**2 / (2 * INFLUENCE**2))
        smoothed[index] = point + ((weight * height)[:, None] * n).sum(axis=0) / weight.sum()
    return smoothed


def smooth_by_pointcore(points, normals):
    """The same, without the loop."""
    settings = {"spatial": 1 / (2 * REACH**2), "influence": 1 / (2 * INFLUENCE**2)}
    attributes = {"normal": normals, "area": 1.0}
    return pointcore.process(points, "smooth", K, attributes=attributes, settings=settings)["position"]


def bound(points, normals):
    """How far apart both may be, for each point.

    The program's exponential is off by up to 2^-13 (docs/programs.md), its other steps by 2^-24 each of what they
    compute. A step is a mean of heights h with weights w: weights that are off by e move it by up to the sum of
    e (|h| + |step|), over the sum of the weights less their errors. Some 64 roundings of numbers as large as the
    points are more than all others.
    """
    error = 2.0**-13
    bounds = np.empty(len(points))
    for index, point in enumerate(points):
        d = points - point
        near = np.argsort((d**2).sum(axis=1))[:K]
        height = np.abs((normals[near] * d[near]).sum(axis=1))
        weight = np.exp(-(d[near] ** 2).sum(axis=1) / (2 * REACH**2) - height**2 / (2 * INFLUENCE**2))
        bounds[index] = error * (height + height.max()).sum() / (weight.sum() - K * error)
    return bounds + 64 * 2.0**-24 * np.abs(points).max()


def main():
    points, normals = torus()
    by_loop, by_pointcore = smooth_by_loop(points, normals), smooth_by_pointcore(points, normals)
    apart, limit = np.linalg.norm(by_loop - by_pointcore, axis=1), bound(points, normals)
    moved = np.linalg.norm(by_loop - points, axis=1)
    off = [distance_from_torus(cloud) for cloud in (points, by_loop, by_pointcore)]
    print(f"off the torus: {off[0]:.5f}, smoothed by the loop {off[1]:.5f}, by pointcore {off[2]:.5f}")
    share = np.max(apart / limit)
    print(f"points move by up to {moved.max():.1e}; both are {apart.max():.1e} apart at most, {share:.3f} of the bound")
    if not (apart <= limit).all():
        sys.exit(f"point {np.argmax(apart / limit)} is further apart than the bound")
    if limit.max() > 0.05 * moved.max() or off[2] > 0.8 * off[0]:
        sys.exit("nothing was smoothed, or the bound says nothing")


if __name__ == "__main__":
    main()
