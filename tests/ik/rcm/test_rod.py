"""A straight instrument on an arm with seven joints: the tip goes around a circle, the shaft stays in its entry."""

from __future__ import annotations

import numpy as np
import pytest
from tests.kinematics.arms import derivative

from helicoide.arrays import Array
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm import rod
from helicoide.ik.rcm.passage import SLIT, insertion, through
from helicoide.ik.rcm.residuals import depth, lateral_distance
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.studies._coutinho_circle import START, rod_arm, scene, tip_reference
from helicoide.studies._coutinho_runs import dia10, problem_without_planes
from helicoide.text import HelicoideError


def test_the_start_of_the_circle() -> None:
    """Tip, shaft and entry point 0.15 m up the shaft; the base is at the height of the shoulder."""
    T, entry, d = scene()
    floor = np.array([0.0, 0.0, rod_arm().floor])
    np.testing.assert_allclose(T[:3, 3] - floor, [0.199762, 1.296680, 0.511625], atol=6e-7)
    np.testing.assert_allclose(d, [0.144749, 0.785870, -0.601212], atol=6e-7)
    np.testing.assert_allclose(entry - floor, [0.178049, 1.178800, 0.601807], atol=6e-7)


def test_rows_are_derivatives_of_tip_and_lateral_error() -> None:
    """J_a by differences, with the entry point on the shaft, over ℓ."""
    robot, (_, entry, _) = rod_arm(), scene()
    passage = through(robot, 7)

    def residuals(q: Array) -> Array:
        place = insertion(passage, link_poses(robot.chain, q)[7] @ passage.T_link_shaft, entry)
        return np.concatenate([tool_at(robot, q)[:3, 3], -place.lateral])

    aim = rod.aim(problem_without_planes(robot, 0.5), passage, START, tip_reference(0.0))
    np.testing.assert_allclose(0.5 * aim.J, derivative(residuals, START), atol=1e-10)
    assert aim.J.shape == (5, 7)


def test_errors_are_those_that_are_displayed() -> None:
    """The lateral rows of e have the length |d × (p_rcm − o)|, whatever the depth."""
    robot, (T, entry, d) = rod_arm(), scene()
    beside = entry + np.array([0.002, -0.001, 0.003])
    reference = rod.TipTask(T[:3, 3], np.zeros(3), beside, np.zeros(2))
    aim = rod.aim(problem_without_planes(robot, 2.0), through(robot, 7), START, reference)
    assert 2.0 * np.linalg.norm(aim.error[3:]) == pytest.approx(lateral_distance(d, T[:3, 3], beside), rel=1e-9)
    np.testing.assert_allclose(aim.error[:3], 0.0, atol=1e-12)
    assert depth(d, T[:3, 3], entry) == pytest.approx(0.15, abs=1e-12)


def test_seven_joints_keep_two_motions_free() -> None:
    """Roll and elbow: the null space turns joints while tip and entry point stay."""
    robot, (T, entry, _) = rod_arm(), scene()
    J = rod.aim(problem_without_planes(robot), through(robot, 7), START, tip_reference(0.0)).J
    analysis = analyse_jacobian(J)
    assert analysis.null_space.shape == (7, 2)
    push = analysis.null_projector @ np.array([0.3, -0.2, 0.5, 0.1, -0.4, 0.2, 0.6])
    np.testing.assert_allclose(J @ push, 0.0, atol=1e-12)
    h = 1e-5 / np.linalg.norm(push)
    moved = tool_at(robot, START + h * push)
    assert np.linalg.norm(moved[:3, 3] - T[:3, 3]) < 1e-9
    assert lateral_distance(moved[:3, 1], moved[:3, 3], entry) < 1e-9
    assert np.linalg.norm(link_poses(robot.chain, START + h * push)[4, :3, 3] - elbow()) > 1e-7


def elbow() -> Array:
    poses: Array = link_poses(rod_arm().chain, START)
    return poses[4, :3, 3]


def test_an_entry_point_that_moves_is_asked_for() -> None:
    robot, (T, entry, _) = rod_arm(), scene()
    reference = rod.TipTask(T[:3, 3], np.array([0.01, 0.0, 0.02]), entry, np.array([0.004, -0.003]))
    aim = rod.aim(problem_without_planes(robot, 0.5), through(robot, 7), START, reference)
    np.testing.assert_allclose(0.5 * aim.feedforward, [0.01, 0.0, 0.02, 0.004, -0.003], atol=1e-15)


@pytest.mark.parametrize("name", ["dia10", "movemaster", "zebra_zero"])
def test_any_arm_with_five_joints_may_hold_a_rod(name: str) -> None:
    """Its last link is the rod; one joint less behind a trocar is refused in words."""
    robot = dia10() if name == "dia10" else load_robot(name)
    passage = through(robot, len(robot.joints))
    assert rod.rod_refusal(robot, passage) is None
    q = robot.poses["ready"]
    T = link_poses(robot.chain, q)[-1] @ passage.T_link_shaft
    tip = tool_at(robot, q)[:3, 3]
    reference = rod.TipTask(tip, np.zeros(3), T[:3, 3] + 0.5 * passage.length * T[:3, 1], np.zeros(2))
    aim = rod.to_points(problem_without_planes(robot), passage, lambda t: reference)(q, 0.0)
    assert aim.J.shape == (5, len(robot.variables))
    np.testing.assert_allclose(aim.error, 0.0, atol=1e-12)


def test_too_few_joints_are_refused() -> None:
    robot = load_robot("scara")
    passage = through(robot, 2)
    said = rod.rod_refusal(robot, passage)
    assert said is not None
    assert "4 joints" in said.en
    assert "pelo menos 5" in said.pt_BR
    with pytest.raises(HelicoideError, match="at least 5"):
        rod.to_points(problem_without_planes(robot), passage, tip_reference)
    assert rod.rod_refusal(robot, through(robot, 2, SLIT)) is None
