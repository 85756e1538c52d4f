"""Distances between capsules: the nearest points, how the distance changes, and what the robots say of themselves."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize
from tests.ik.walks import ARMS, left, scene
from tests.kinematics.arms import NAMES, arm, derivative

from helicoide.confinement import Planes
from helicoide.ik import Limits, Problem
from helicoide.ik.guard.collision import apart, clearances, closest_shares, witness_row
from helicoide.ik.guard.rows import DAMPER_GAIN, add_point, damper, unfelt
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.jacobian import joint_axes

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


@settings(max_examples=30)
@given(seed=seeds, name=st.sampled_from(ARMS))
def test_a_row_is_the_derivative_of_the_distance_of_its_witnesses(seed: int, name: str) -> None:
    problem = scene(name, seed % 7, planes=0)
    rng, chain = np.random.default_rng(seed), problem.robot.chain
    q = rng.uniform(problem.limits.lower, problem.limits.upper)
    pair = int(rng.integers(len(problem.pairs)))

    def here(q: Array) -> tuple[Array, Array, Array]:
        poses = link_poses(chain, frozen(q))
        return poses, *clearances(poses, problem.points, problem.plane_arrays, problem.pair_arrays)[1:]

    poses, shares, points = here(q)
    row, corners = np.empty((1, len(q))), problem.pair_arrays[1]
    there = witness_row(
        row, 0, points, problem.points[2], problem.pair_arrays, pair, *shares[pair], poses, chain,
        joint_axes(poses, chain),
    )  # fmt: skip
    assert there == pytest.approx(left(problem, q)[pair], abs=1e-12)
    if there + problem.pair_arrays[2][pair] > 1e-2:
        by_differences = derivative(lambda q: np.array(apart(here(q)[2], corners, pair, *shares[pair])[0]), q, 1e-4)
        np.testing.assert_allclose(row[0], by_differences, rtol=0, atol=1e-6)


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
        assert {tuple(end) for end in body.ends} <= {tuple(point) for point in robot.guarded_points}
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
    chain, n = robot.chain.copy(), len(robot.variables)
    poses = link_poses(chain, rng.uniform(robot.lower, robot.upper))
    links = rng.integers(1, len(robot.joints) + 1, 6)
    points = poses[links, :3, 3] + rng.normal(size=(6, 3)) * 0.2 * robot.reach
    speed, accelerations = robot.speed.copy(), np.full(n, acceleration)
    far = unfelt(chain, links, speed, accelerations, gain, poses, points, dt)
    axes = joint_axes(poses, chain)
    for k, (link, point) in enumerate(zip(links, points, strict=True)):
        normal = rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        row = np.zeros((1, n))
        add_point(row, 0, tuple(normal), tuple(point), link, poses, chain, axes)
        fastest = float(np.abs(row[0]) @ speed * dt)
        assert -damper(far[k], row, 0, accelerations, gain, dt) >= fastest * (1 - 1e-9)
        assert far[k] < 50 * robot.reach * max(1.0, 1.0 / (gain * dt)) * max(1.0, 10 / acceleration)
