"""Distances between capsules: the nearest points, how the distance changes, and what the robots say of themselves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize
from tests.ik.walks import ARMS, left, scene
from tests.kinematics.arms import NAMES, arm, derivative

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes
from helicoide.ik import Limits, Problem
from helicoide.ik.guard.collision import closest_shares, gap, place_bodies, witness_distance, witness_row
from helicoide.ik.guard.packed import GUARDED, LEAST, LINK, POINTS, SETTING, PlacedArm, array_parts, place_links
from helicoide.ik.guard.rows import DAMPER_GAIN, FAR, add_point, damper, unmoved_rows
from helicoide.ik.packing import packed

seeds = st.integers(0, 2**32 - 1)
NONE = Planes(frozen(np.zeros((0, 3))), frozen(np.zeros((0, 3))))


def pieces(seed: int) -> list[Array]:
    """The four ends of two pieces: far, near, crossing, parallel, or a point."""
    rng = np.random.default_rng(seed)
    a, b, c, d = rng.normal(size=(4, 3))
    match rng.integers(5):
        case 0:
            d = c + rng.choice([-1.0, 0.3]) * (b - a)
        case 1:
            d = c.copy()
        case 2:
            a = b.copy()
        case 3:
            c, d = a + b - d, d
    return [a, b, c, d]


def distance(ends: list[Array], shares: Array) -> float:
    a, b, c, d = ends
    return float(np.linalg.norm(a + shares[0] * (b - a) - c - shares[1] * (d - c)))


@settings(max_examples=100)
@given(seed=seeds)
def test_no_points_of_two_pieces_are_nearer(seed: int) -> None:
    """A convex problem: a search from the best of a grid finds nothing shorter."""
    ends = pieces(seed)
    found = np.array(closest_shares(*map(tuple, ends)))
    assert ((found >= 0) & (found <= 1)).all()
    grid = [np.array([s, t]) for s in np.linspace(0, 1, 7) for t in np.linspace(0, 1, 7)]
    best = min(grid, key=lambda shares: distance(ends, shares))
    searched = minimize(lambda x: distance(ends, x) ** 2, best, bounds=[(0, 1)] * 2, method="L-BFGS-B", tol=1e-14)
    assert distance(ends, found) ** 2 <= searched.fun + 1e-9


def standing(table: Array, q: Array) -> tuple[PlacedArm, Array]:
    """A packed arm in a posture, and its points in the world."""
    at = array_parts(table)
    placed = PlacedArm(table, at, q, np.empty((at.m + 1, 4, 4)), np.empty((at.m, 4)))
    place_links(placed)
    points = np.empty((at.planes - at.points, 4))
    place_bodies(placed, points)
    return placed, points


@settings(max_examples=30)
@given(seed=seeds, name=st.sampled_from(ARMS))
def test_a_row_is_the_derivative_of_the_distance_of_its_witnesses(seed: int, name: str) -> None:
    problem = scene(name, seed % 7, planes=0)
    rng, table = np.random.default_rng(seed), packed(problem)
    q = rng.uniform(problem.limits.lower, problem.limits.upper)
    which = int(rng.integers(len(problem.pairs)))
    pair = array_parts(table).pairs + which
    placed, points = standing(table, q)
    _, witnesses = gap(table, pair, points)
    row = np.empty(len(q))
    there = witness_row(row, placed, points, witnesses)
    assert there == pytest.approx(left(problem, q)[which], abs=1e-12)
    if there + table[pair, LEAST] > 1e-2:
        by_differences = derivative(
            lambda q: np.array(witness_distance(table, standing(table, q)[1], witnesses)[0]), q, 1e-4
        )
        np.testing.assert_allclose(row, by_differences, rtol=0, atol=1e-6)


def test_a_gap_is_what_is_left_between_surfaces() -> None:
    """By hand: a sphere of 50 mm, 300 mm above the stretched Movemaster's forearm of 65 mm, 10 mm kept free."""
    robot = arm("movemaster")
    problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), NONE)
    problem = Problem(robot, problem.limits, NONE, obstacles=problem.obstacles.with_sphere([0.45, 0, 0.7], 0.05))
    forearm = [body.name for body in robot.bodies].index("forearm")
    pair = problem.pairs.index((forearm, len(robot.bodies)))
    assert left(problem, np.zeros(5))[pair] == pytest.approx(0.3 - 0.065 - 0.05 - 0.01, abs=1e-12)


WITH_PAIRS = [name for name in NAMES if arm(name).self_collision]


@pytest.mark.parametrize("name", WITH_PAIRS)
def test_every_named_posture_is_free_of_self_collision(name: str) -> None:
    robot = arm(name)
    problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), NONE)
    assert {"ready", "zero"} <= set(robot.poses)
    for title, q in robot.poses.items():
        assert left(problem, q).min() > 0.0, title


@pytest.mark.parametrize("name", WITH_PAIRS)
def test_every_pair_can_meet_within_the_limits(name: str) -> None:
    robot, rng = arm(name), np.random.default_rng(3)
    problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), NONE)
    drawn = np.array([left(problem, rng.uniform(robot.lower, robot.upper)) for _ in range(4000)])
    assert (drawn.min(axis=0) < 0.0).all()


@pytest.mark.parametrize("name", [name for name in NAMES if not arm(name).capsules])
def test_without_capsules_the_bodies_follow_the_guarded_points(name: str) -> None:
    robot = arm(name)
    problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), NONE)
    assert robot.bodies
    assert not problem.pairs
    for body in robot.bodies:
        assert body.radius == 0.04 * robot.reach
        assert {tuple(end) for end in body.ends} <= {tuple(point) for point in robot.monitored_points}
    sphere = Problem(robot, problem.limits, NONE, obstacles=problem.obstacles.with_sphere([0, 0, 9], 0.1))
    assert len(sphere.pairs) == sum(max(body.links) > 0 for body in robot.bodies)


@settings(max_examples=60)
@given(
    seed=seeds,
    name=st.sampled_from(ARMS),
    acceleration=st.sampled_from([np.inf, 100.0, 20.0, 5.0, 1.0]),
    dt=st.floats(0.001, 0.05),
    gain=st.sampled_from([1.0, DAMPER_GAIN, 50.0]),
)
def test_what_is_not_watched_could_not_have_held_a_tick(
    seed: int, name: str, acceleration: float, dt: float, gain: float
) -> None:
    """From the room of `unfelt` on, the fastest approach in any direction is one that the damper allows."""
    rng, robot = np.random.default_rng(seed), arm(name)
    links = rng.integers(1, len(robot.joints) + 1, 6)
    limits = Limits(robot.lower, robot.upper, robot.speed, frozen(np.full(len(robot.variables), acceleration)))
    bare = packed(Problem(replace(robot, self_collision=()), limits, NONE), gain=gain)
    table = np.vstack([bare[: array_parts(bare).points], np.zeros((6, bare.shape[1]))])
    table[-6:, :3], table[-6:, LINK] = rng.normal(size=(6, 3)) * 0.2 * robot.reach, links
    table[SETTING, [POINTS, GUARDED]] = 6
    at = array_parts(table)
    placed, points = standing(table, rng.uniform(robot.lower, robot.upper))
    unmoved_rows(placed, points, dt, np.empty((at.m + 1, 4)))
    for k, link in enumerate(links):
        normal = rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        row = np.zeros((1, at.n))
        add_point(row[0], tuple(normal), tuple(points[k, :3]), 0, int(link), placed)
        fastest = float(np.abs(row[0]) @ robot.speed * dt)
        far = points[k, FAR]
        assert -damper(far, row, 0, table, at, dt) >= fastest * (1 - 1e-9)
        assert far < 50 * robot.reach * max(1.0, 1.0 / (gain * dt)) * max(1.0, 10 / acceleration)
