"""What `solve` says of its answers is measured: judged here by the motors of the joints, which no answer comes from."""

from __future__ import annotations

from collections.abc import Iterable
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.kinematics.arms import arm, postures
from tests.kinematics.chains import random_arm

from helicoide import content
from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.ik import closed
from helicoide.ik.postures import solve as front
from helicoide.ik.postures.answer import Answer, Found
from helicoide.ik.postures.branch import between
from helicoide.ik.postures.measure import left
from helicoide.ik.postures.solve import EXACT, answer_status, reached, solve, solve_by, ways
from helicoide.kinematics.forward import tool_by_dual_quaternions
from helicoide.kinematics.robot import Robot

ARMS = sorted(content.content_folders("robots"))
ROUNDING = 1e-9


def judged(robot: Robot, q: Array, T: Array, with_orientation: bool) -> tuple[float, float]:
    """What a posture leaves of a pose, m and rad."""
    missed, turned = between(T, tool_by_dual_quaternions(robot, q))
    return missed, turned if with_orientation else 0.0


def holds(robot: Robot, T: Array, answer: Answer, with_orientation: bool) -> bool:
    """Whether the answer says reached; fails where it, or a number of it, is not what is judged."""
    there = False
    for branch in answer.branches:
        missed, turned = judged(robot, branch.q, T, with_orientation)
        assert branch.missed == pytest.approx(missed, abs=ROUNDING * max(1.0, robot.reach))
        assert branch.turned == pytest.approx(turned, abs=1e-7)
        within = bool(((branch.q >= robot.lower - 1e-6) & (branch.q <= robot.upper + 1e-6)).all())
        there |= within and EXACT.holds(missed - 1e-8, turned - 1e-7)
    assert not reached(answer) or there, "said to be reached, and is not"
    return reached(answer)


def goals(robot: Robot, seed: int) -> list[Array]:
    """Poses that the arm takes, the same turned by chance, upside down, and moved out of its plane or reach."""
    rng, poses = np.random.default_rng(seed), []
    for q in postures(robot, 2, seed):
        T = tool_by_dual_quaternions(robot, q)
        turned, over, away = T.copy(), T.copy(), T.copy()
        turned[:3, :3] = rotation.exponential(rng.normal(size=3)) @ T[:3, :3]
        over[:3, :3] = rotation.exponential(np.pi * np.eye(3)[rng.integers(3)]) @ T[:3, :3]
        away[:3, 3] += rng.normal(size=3) * robot.reach
        poses += [T, turned, over, away]
    return [frozen(T) for T in poses]


@pytest.mark.parametrize("name", ARMS)
def test_reached_is_never_false(name: str) -> None:
    robot, q = arm(name), arm(name).poses["ready"]
    for T in goals(robot, 5):
        for every in (False, True):
            for with_orientation in (True, False):
                holds(robot, T, solve(robot, T, q, every, with_orientation), with_orientation)
            for way in (*closed.of(robot), "numeric"):
                holds(robot, T, solve_by(way, robot, T, q, every), True)


@pytest.mark.parametrize("name", ["planar2r", "movemaster", "puma560"])
def test_every_way_is_measured(name: str) -> None:
    robot, q = arm(name), arm(name).poses["ready"]
    T = goals(robot, 6)[1]
    for way in ways(robot):
        holds(robot, T, solve_by(way, robot, T, q), True)


def test_two_joints_reach_a_pose_by_the_posture_that_has_its_orientation() -> None:
    robot = arm("planar2r")
    for q in postures(robot, 60, 9):
        T = tool_by_dual_quaternions(robot, q)
        for start in (q, -q, robot.poses["ready"]):
            one = solve(robot, T, start)
            assert holds(robot, T, one, True)
            np.testing.assert_allclose(one.branches[0].q, q, atol=1e-6)
    over = T.copy()
    over[:3, :3] = rotation.exponential(np.array([0, 0, 1.0])) @ T[:3, :3]
    turned = solve(robot, over, q)
    assert not reached(turned)
    assert answer_status(turned).en.startswith("projected by ")
    assert f"{np.degrees(turned.branches[0].turned):.3f}°" in answer_status(turned).en


def test_a_form_that_is_wrong_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    robot = arm("puma560")
    q = postures(robot, 1, 3)[0]
    T = tool_by_dual_quaternions(robot, q)
    form = closed.of(robot)["puma560"]

    def wrong(robot: Robot, T: Array, q: Array) -> Found:
        found = form.find(robot, T, q)
        return found._replace(q=found.q + 0.1)

    lies = SimpleNamespace(**{name: getattr(form, name) for name in ("TITLE", "SOURCE", "EQUATIONS", "applies")})
    lies.find = wrong
    monkeypatch.setattr(front.closed, "of", lambda robot: {"lies": lies})
    every = solve(robot, T, q, every=True)
    assert not reached(every)
    assert all(branch.missed > 0.01 or branch.turned > 0.01 for branch in every.branches)
    assert holds(robot, T, solve(robot, T, q), True), "the searches find it all the same"


@given(st.integers(0, 2**32 - 1))
def test_reached_is_never_false_of_arms_by_chance(seed: int) -> None:
    robot = random_arm(seed)
    q = robot.poses["ready"]
    for T in goals(robot, seed)[:4]:
        for with_orientation in (True, False):
            holds(robot, T, solve(robot, T, q, with_orientation=with_orientation), with_orientation)


@given(st.integers(0, 2**32 - 1))
def test_what_is_left_is_the_same_by_quaternions_and_by_motors(seed: int) -> None:
    robot = random_arm(seed)
    one, other = postures(robot, 2, seed)
    T = tool_by_dual_quaternions(robot, other)
    assert left(robot, one, T) == pytest.approx(judged(robot, one, T, True), abs=1e-7 * max(1.0, robot.reach))


def lost(seeds: Iterable[int], beside: bool = False) -> list[int]:
    """The arms by chance that are not said to reach a pose which they take within their limits.

    beside: those of which some joints follow one beside the arm.
    """
    found = []
    for seed in seeds:
        robot = random_arm(seed, beside)
        T = tool_by_dual_quaternions(robot, postures(robot, 1, seed)[0])
        if not holds(robot, T, solve(robot, T, robot.poses["ready"]), True):
            found.append(seed)
    return found


def test_what_arms_by_chance_take_they_reach() -> None:
    assert lost(range(200)) == []
    assert lost(range(50), beside=True) == []
