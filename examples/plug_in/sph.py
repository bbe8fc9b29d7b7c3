"""A fluid in a plane (SPH): a solver with its own loops over neighbors, and the same solver with two calls instead.

    pip install ./bindings/python
    python examples/plug_in/sph.py

A column of water falls in a narrow basin (Müller, Charypar and Gross 2003, with the factors of two dimensions).
The loops and the programs `sph_density` and `sph_forces` compute the same sums; time steps and walls are the solver's.
"""

import sys

import numpy as np
import pointcore

COLUMNS, ROWS = 12, 18
SPACING = 0.02
H = 1.9 * SPACING
REST_DENSITY, STIFFNESS, VISCOSITY = 1000.0, 60.0, 6.0
GRAVITY = np.array([0.0, -9.81, 0.0])
MASS = REST_DENSITY * SPACING**2
STEP = 1e-3
STEPS = 100
# The basin's width, and the share of its speed that a particle keeps at a wall.
WIDTH, BOUNCE = 0.4, 0.1
# Factors of the kernels in two dimensions: density, gradient of pressure, Laplacian of viscosity.
DENSITY_FACTOR, PRESSURE_FACTOR, VISCOSITY_FACTOR = 4 / (np.pi * H**2), 30 / (np.pi * H**5), 40 / (np.pi * H**5)

# Programs round each operation to float32. A term of a sum is rounded some ten times, and five times on its way through
# the sum, each time by up to 2^-24: this share of the terms' magnitudes is more.
ROUNDING = 2.0**-20
# How far apart both solvers may be after all steps, as a share of the spacing: each goes on from its own results.
POSITION_BOUND = 0.01


def column():
    """The column at rest; coordinates are float32, as the programs see them."""
    place = np.stack(np.meshgrid(np.arange(COLUMNS), np.arange(ROWS)), axis=-1).reshape(-1, 2)
    return np.column_stack([(place + 0.5) * SPACING, np.zeros(len(place))]).astype(np.float32).astype(float)


def forces_by_loop(points, velocities):
    """Densities and accelerations as they were computed: float64, loops over all particles."""
    densities = np.empty(len(points))
    for index, point in enumerate(points):
        ratio = ((points - point) ** 2).sum(axis=1) / H**2
        densities[index] = DENSITY_FACTOR * MASS * (np.maximum(1 - ratio, 0) ** 3).sum()
    pressures = STIFFNESS * (densities - REST_DENSITY)
    accelerations = np.empty_like(points)
    for index, point in enumerate(points):
        d = points - point
        distance = np.sqrt((d**2).sum(axis=1))
        inside = H - distance
        near = (distance < H) & (distance > 0)
        d, inside, volume = d[near], inside[near], MASS / densities[near]
        mean_pressure = (pressures[index] + pressures[near]) / 2
        push = (PRESSURE_FACTOR * volume * mean_pressure * inside**2 / distance[near])[:, None] * d
        drag = (VISCOSITY_FACTOR * VISCOSITY * volume * inside)[:, None] * (velocities[near] - velocities[index])
        accelerations[index] = (drag - push).sum(axis=0) / densities[index] + GRAVITY
    return densities, accelerations


def forces_by_pointcore(points, velocities):
    """The same, without the loops."""
    settings = {"normalization": DENSITY_FACTOR, "stiffness": STIFFNESS, "rest_density": REST_DENSITY}
    settings |= {"inverse_radius2": 1 / H**2}
    found = pointcore.process(points, "sph_density", radius=H, attributes={"mass": MASS}, settings=settings)
    if found.neighbors.max() == 64:
        sys.exit("a particle may have more than 64 neighbors")
    # One factor is for both forces: the quotient of the two goes into the viscosity.
    viscosity = VISCOSITY * VISCOSITY_FACTOR / PRESSURE_FACTOR
    settings = {"normalization": PRESSURE_FACTOR, "viscosity": viscosity, "radius": H, "gravity": GRAVITY}
    attributes = {"mass": MASS, "velocity": velocities, "density": found["density"], "pressure": found["pressure"]}
    forces = pointcore.process(points, "sph_forces", radius=H, attributes=attributes, settings=settings)
    return found["density"], forces["acceleration"]


def moved(points, velocities, accelerations):
    """A time step, and the walls."""
    velocities = velocities + STEP * accelerations
    points = points + STEP * velocities
    outside = (points < 0) | (points > [WIDTH, np.inf, 0.0])
    velocities = np.where(outside, -BOUNCE * velocities, velocities)
    points = np.clip(points, 0.0, [WIDTH, np.inf, 0.0])
    # Both solvers see coordinates of float32.
    return points.astype(np.float32).astype(float), velocities.astype(np.float32).astype(float)


def bound(points, velocities, densities):
    """How far apart accelerations from the same state may be, for each particle.

    Pressures are STIFFNESS times a small difference of densities, and what is inside H is a difference of lengths: both
    are off by a share of what they are the differences of.
    """
    distance = np.linalg.norm(points[None] - points[:, None], axis=2)
    near = (distance < H) & (distance > 0)
    pressures = STIFFNESS * (densities + REST_DENSITY)
    push = PRESSURE_FACTOR * (pressures[None] + pressures[:, None]) / 2 * (H - distance) * H
    drag = VISCOSITY_FACTOR * VISCOSITY * H * np.linalg.norm(velocities[None] - velocities[:, None], axis=2)
    magnitude = (near * MASS / densities[None] * (push + drag)).sum(axis=1) / densities
    return ROUNDING * (magnitude + np.linalg.norm(GRAVITY))


def main():
    own = other = column(), np.zeros((COLUMNS * ROWS, 3))
    largest, of_density, of_acceleration = 0.0, 0.0, 0.0
    for _ in range(STEPS):
        densities, accelerations = forces_by_loop(*own)
        # One evaluation from the same state; then each goes on from its own.
        density, acceleration = forces_by_pointcore(*own)
        apart = np.linalg.norm(acceleration - accelerations, axis=1)
        largest = max(largest, np.max(apart / np.linalg.norm(accelerations, axis=1).max()))
        of_density = max(of_density, np.max(np.abs(density / densities - 1) / ROUNDING))
        of_acceleration = max(of_acceleration, np.max(apart / bound(*own, densities)))
        own = moved(*own, accelerations)
        other = moved(*other, forces_by_pointcore(*other)[1])
    apart = np.linalg.norm(own[0] - other[0], axis=1).max() / SPACING
    fallen = np.linalg.norm(own[0] - column(), axis=1).max() / SPACING
    print(f"densities are apart by {of_density:.2f} of the bound, accelerations by {of_acceleration:.2f}:")
    print(f"by {largest:.1e} of the largest; after {STEPS} steps particles have moved by up to {fallen:.1f} spacings,")
    print(f"and those of both solvers are {apart:.1e} spacings apart at most (bound: {POSITION_BOUND})")
    if not (of_density <= 1 and of_acceleration <= 1 and apart <= POSITION_BOUND):
        sys.exit("they are further apart than the bounds")
    if fallen < 1:
        sys.exit("nothing has moved")


if __name__ == "__main__":
    main()
