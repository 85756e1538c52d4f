"""Forward kinematics joint by joint: what Cerbaro 2022 prints, and that every kind leads to one pose."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from helicoide import content
from helicoide.arrays import Array
from helicoide.geometry import euler, rigid
from helicoide.kinematics.forward import screw_displacements, tool_by_screws
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.stages import JointStage, dh_stages, in_source_units, product_stages, screw_stages

Stages = Callable[[Robot, Array], list[JointStage]]

# Eqs. 4 and 8; the lengths of eq. 8 are cut after three decimals.
EQ_4 = [[0.5, -0.75, 0.433, 470.429], [-0.866, -0.433, 0.25, 271.602], [0, -0.5, -0.866, 300], [0, 0, 0, 1]]
EQ_8 = [[0.433, 0.75, 0.5, -84.641], [0.25, 0.433, -0.866, 413.012], [-0.866, 0.5, 0, 1010.14], [0, 0, 0, 1]]
EQ_7 = [[1, 0, 0, -336.86], [0, 1, 0, 309.321], [0, 0, 1, 0], [0, 0, 0, 1]]


@pytest.mark.parametrize(
    ("name", "stages", "printed"),
    [("movemaster", dh_stages, EQ_4), ("movemaster", screw_stages, EQ_8), ("orca", screw_stages, EQ_7)],
    ids=["eq. 4", "eq. 8", "eq. 7"],
)
def test_the_matrices_of_the_source(name: str, stages: Stages, printed: list[list[float]]) -> None:
    robot = load_robot(name)
    last = in_source_units(stages(robot, robot.poses["example"])[-1])
    np.testing.assert_allclose(last.partial, printed, rtol=0, atol=1e-3)


def test_the_angles_of_eq_6_are_those_of_the_dh_frame() -> None:
    """(−1.047, 0, −2.618); those of the tool frame are others."""
    movemaster = load_robot("movemaster")
    H = dh_stages(movemaster, movemaster.poses["example"])[-1].partial
    turns = euler.euler_angles(H[:3, :3], euler.ROLL_PITCH_YAW).values
    np.testing.assert_allclose(turns, [-1.047, 0, -2.618], rtol=0, atol=5e-4)
    of_tool = euler.euler_angles(tool_by_screws(movemaster, movemaster.poses["example"])[:3, :3], euler.ROLL_PITCH_YAW)
    assert np.abs(of_tool.values - turns).max() > 1


def test_the_numbers_of_a_row_and_of_a_screw() -> None:
    """Tabs. 6 and 8 with the example's angles in them."""
    movemaster = load_robot("movemaster")
    row = in_source_units(dh_stages(movemaster, movemaster.poses["example"])[3])
    assert row.angles == pytest.approx({"θ": 60.0, "α": 90.0})
    assert {name: float(value) for name, value in row.lengths.items()} == pytest.approx({"d": 0.0, "a": 0.0}, abs=1e-9)
    screw = in_source_units(screw_stages(movemaster, movemaster.poses["example"])[3])
    assert screw.angles == pytest.approx({"θ": -30.0})
    np.testing.assert_allclose(screw.lengths["s₀"], [570, 0, 400])
    np.testing.assert_array_equal(screw.direction, [0, -1, 0])


@pytest.mark.parametrize("name", sorted(content.content_folders("robots")))
def test_every_kind_leads_to_the_tool(name: str) -> None:
    robot = load_robot(name)
    q = np.asarray(robot.poses["ready"])
    T = tool_by_screws(robot, q)
    np.testing.assert_allclose(dh_stages(robot, q)[-1].partial @ robot.dh.T_dh_tool, T, rtol=0, atol=1e-9)
    H = screw_displacements(robot, q)
    for stage, product, displacement in zip(screw_stages(robot, q), product_stages(robot, q), H[1:], strict=True):
        np.testing.assert_array_equal(stage.partial, displacement)
        moved = rigid.pose_from_motor(rigid.motor_from_dual_quaternion(product.partial))
        np.testing.assert_allclose(moved, displacement, rtol=0, atol=1e-12)


def test_a_product_of_the_example() -> None:
    """h₁ … h₅ of the Movemaster, recomputed from eqs. 96–103; lengths in mm."""
    movemaster = load_robot("movemaster")
    last = in_source_units(product_stages(movemaster, movemaster.poses["example"])[-1]).partial
    turn, shift = [0.683013, 0.5, 0.5, -0.183013], [10.341380, -319.233938, 385.836478, 220.556080]
    np.testing.assert_allclose(last, [*turn, *shift], rtol=0, atol=6e-7)
