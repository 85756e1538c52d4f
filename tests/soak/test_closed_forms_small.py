"""The full counts of the closed forms with fewer than six joints: 20,000 postures each. Run with `make soak`."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from tests.ik.closed.small_arms import recovered, worst

from helicoide.ik.closed import motoman_l3, planar3r, polar
from helicoide.ik.postures.branch import Answer, tool_at
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar

pytestmark = pytest.mark.soak

COUNT = 20_000


def answers(form: object, robot: Robot, lower: Array, upper: Array) -> Iterator[tuple[Array, Answer]]:
    for q in np.random.default_rng(20).uniform(lower, upper, (COUNT, lower.size)):
        yield q, form.solve(robot, tool_at(robot, frozen(q)), robot.poses["ready"])  # type: ignore[attr-defined]


def test_planar_3r() -> None:
    """Section 3.2: both postures by forward kinematics, and both roads to them."""
    robot, half = planar("planar3r", 1.0, 0.7, 0.2), np.full(3, np.pi)
    missed, apart, lost = 0.0, 0.0, 0.0
    for q, answer in answers(planar3r, robot, -half, half):
        assert len(answer.branches) == 2
        missed, lost = max(missed, worst(answer)), max(lost, recovered(answer, q))
        for steps in answer.values:
            psi = steps["ψ"] if steps["θ₂"] < 0 else -steps["ψ"]
            apart = max(apart, abs(np.exp(1j * (steps["β"] + psi)) - np.exp(1j * steps["θ₁"])))
    print(f"planar 3R: missed {missed:.1e}, roads apart {apart:.1e}, generating posture within {lost:.1e}")
    assert missed < 1e-9
    assert apart < 1e-9
    assert lost < 1e-9


def test_motoman_l3() -> None:
    """Section 3.4: four postures, forward kinematics, the generating posture."""
    robot, half = load("motoman_l3"), np.full(5, np.pi)
    missed, lost = 0.0, 0.0
    for q, answer in answers(motoman_l3, robot, -half, half):
        assert len(answer.branches) == 4
        missed, lost = max(missed, worst(answer)), max(lost, recovered(answer, q))
    print(f"Motoman L-3: missed {missed:.1e}, generating posture within {lost:.1e}")
    assert missed < 1e-9
    assert lost < 1e-9


def test_polar() -> None:
    robot = load("polar_rp")
    missed, lost = 0.0, 0.0
    for q, answer in answers(polar, robot, robot.lower, robot.upper):
        missed, lost = max(missed, worst(answer)), max(lost, recovered(answer, q))
    print(f"polar arm: missed {missed:.1e}, generating posture within {lost:.1e}")
    assert missed < 1e-12
    assert lost < 1e-12
