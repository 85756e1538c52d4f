"""Pieper's test: which arms have a closed form, by which three axes, and how many postures there can be."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from tests.ik.closed.rows import backwards
from tests.kinematics.arms import NAMES, arm, postures
from tests.kinematics.test_packages import ARMS, packaged_arm

from helicoide.arrays import Array, frozen
from helicoide.ik import closed
from helicoide.ik.closed import pieper
from helicoide.ik.postures import solvability
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.postures.solvability import Ground
from helicoide.kinematics.forward import link_poses, screw_displacements
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import LENGTHS, puma_rows, puma_with_lengths, random_spherical_arm
from helicoide.studies.campos_table import POSTURE, count_postures, known_arm, with_zeros

HERE = np.zeros(6)
# by hand: axes from 1
GROUNDS = {
    "puma560": (Ground.MEETING, (4, 5, 6)),
    "zebra_zero": (Ground.MEETING, (4, 5, 6)),
    "kinova": (Ground.MEETING, (4, 5, 6)),
    "kr16_2": (Ground.MEETING, (4, 5, 6)),
    "kr210l150": (Ground.MEETING, (4, 5, 6)),
    "movemaster": (Ground.PARALLEL, (2, 3, 4)),
    "motoman_l3": (Ground.PARALLEL, (2, 3, 4)),
    "ur5": (Ground.PARALLEL, (2, 3, 4)),
    "ur10": (Ground.PARALLEL, (2, 3, 4)),
    "planar3r": (Ground.PARALLEL, (1, 2, 3)),
    "orca": (Ground.PARALLEL, (1, 2, 3)),
    "planar2r": (Ground.FEW, ()),
    "polar_rp": (Ground.FEW, ()),
    "scara": (Ground.FEW, ()),
    "panda": (Ground.REDUNDANT, ()),
    "dia10": (Ground.REDUNDANT, ()),
    "lbr_iiwa_14_r820": (Ground.REDUNDANT, ()),
    "irb140": (Ground.NONE, ()),
}


def named(name: str) -> Robot:
    return arm(name) if name in NAMES else packaged_arm(name)


@pytest.mark.parametrize("name", GROUNDS)
def test_the_verdict_on_known_arms(name: str) -> None:
    ground, axes = GROUNDS[name]
    verdict = solvability.verdict(named(name))
    assert verdict.ground == ground
    assert tuple(axis + 1 for axis in verdict.axes) == axes
    assert verdict.closed == (ground in (Ground.MEETING, Ground.PARALLEL, Ground.FEW))
    for words in (verdict.words.en, verdict.words.pt_BR):
        assert ", ".join(map(str, axes)) in words
        assert "{" not in words
    assert ("Closed form" in verdict.words.en) == ("Forma fechada" in verdict.words.pt_BR) == verdict.closed


@pytest.mark.parametrize("name", [*NAMES, *ARMS])
def test_every_form_that_applies_is_in_the_verdict(name: str) -> None:
    robot = named(name)
    assert not closed.of(robot) or solvability.verdict(robot).closed
    meets = solvability.verdict(robot).axes in ((3, 4, 5), (0, 1, 2)) and solvability.verdict(robot).point is not None
    turns = len(robot.joints) == 6 and not any(joint.is_prismatic for joint in robot.joints)
    assert ("pieper" in closed.of(robot)) == (meets and turns)


def general(draw: np.random.Generator, points: Array) -> Robot:
    """Six axes through points (6, 3), m, in random directions."""
    robot = random_spherical_arm(draw, "general")
    directions = draw.normal(size=(6, 3))
    joints = tuple(
        replace(joint, direction=frozen(s / np.linalg.norm(s)), point=frozen(p))
        for joint, s, p in zip(robot.joints, directions, points, strict=True)
    )
    return replace(robot, joints=joints)


@pytest.mark.parametrize("first", range(4))
def test_closed_if_and_only_if_three_adjacent_axes_meet(first: int) -> None:
    """Moved off the point by 10 µm they do not; the first and the last of four that meet are not adjacent."""
    draw = np.random.default_rng(first)
    for _ in range(10):
        points = draw.uniform(-1, 1, (6, 3))
        points[first : first + 3] = points[first]
        robot = general(draw, points)
        verdict = solvability.verdict(robot)
        assert (verdict.ground, verdict.axes) == (Ground.MEETING, (first, first + 1, first + 2))
        np.testing.assert_allclose(verdict.point, points[first], rtol=0, atol=1e-9)
        for axis in verdict.axes:
            aside = np.cross(robot.directions[axis], robot.directions[first + (axis - first + 1) % 3])
            joints = list(robot.joints)
            joints[axis] = replace(joints[axis], point=frozen(points[axis] + 1e-5 * aside / np.linalg.norm(aside)))
            assert solvability.verdict(replace(robot, joints=tuple(joints))).ground == Ground.NONE
        points[first + 1] += draw.normal(size=3)
        assert solvability.verdict(general(draw, points)).ground == Ground.NONE


@pytest.mark.parametrize("first", range(4))
def test_three_parallel_axes_are_found_whichever_way_they_point(first: int) -> None:
    draw = np.random.default_rng(first)
    robot = general(draw, draw.uniform(-1, 1, (6, 3)))
    joints = list(robot.joints)
    for axis, sign in zip(range(first, first + 3), (1, -1, 1), strict=True):
        joints[axis] = replace(joints[axis], direction=frozen(sign * robot.directions[first]))
    verdict = solvability.verdict(replace(robot, joints=tuple(joints)))
    assert (verdict.ground, verdict.axes, verdict.point) == (Ground.PARALLEL, (first, first + 1, first + 2), None)


@pytest.mark.parametrize("name", ["puma560", "zebra_zero", "kinova", "kr16_2"])
def test_the_axes_meet_in_every_posture(name: str) -> None:
    robot = named(name)
    verdict = solvability.verdict(robot)
    for q in postures(robot, 10):
        poses, moved = link_poses(robot.chain, q), screw_displacements(robot, q)
        for axis in verdict.axes:
            point = moved[verdict.axes[1] + 1] @ [*verdict.point, 1]  # type: ignore[misc]
            way = point[:3] - poses[axis + 1, :3, 3]
            direction = poses[axis + 1, :3, :3] @ robot.directions[axis]
            assert np.linalg.norm(np.cross(way, direction)) < 1e-6


@pytest.mark.parametrize(
    ("zeros", "row"), [((1, 3, 5), 4), ((3, 5), 8), ((3,), 16), ((), 16), ((1, 4, 5), 16), ((1, 3), 16)]
)
def test_the_rows_of_the_table(zeros: tuple[int, ...], row: int) -> None:
    """s.22; of the PUMA, a1 = a4 = a5 = 0, there is none, and it counts as the last."""
    robot = with_zeros(zeros, np.random.default_rng(1))
    lengths = solvability.link_lengths(robot)
    assert {number for number, length in enumerate(lengths, start=1) if length < 1e-9} == set(zeros)
    assert solvability.table_row(robot) == row
    assert solvability.solution_bound(robot) == 16


def test_the_first_row_of_the_table_does_not_hold_for_the_puma_without_a3() -> None:
    """s.22 gives at most 4 postures for a1 = a3 = a5 = 0; the source's own check of that arm counts 8."""
    robot = puma_with_lengths(*LENGTHS[2])
    answer = closed.solve_closed_form(pieper, robot, tool_at(robot, np.array([0.3, -0.5, 0.7, 0.4, 0.9, -1.1])), HERE)
    assert len(answer.branches) == 8
    assert all(max(branch.missed, branch.turned) < 1e-12 for branch in answer.branches)
    assert solvability.table_row(robot) == 4
    assert solvability.verdict(robot).bound == 8


@pytest.mark.parametrize(("zeros", "row"), [((1, 3, 5), 4), ((3, 5), 8), ((3,), 16), ((), 16)])
def test_an_arm_of_each_row_with_sixteen_postures(zeros: tuple[int, ...], row: int) -> None:
    """Without a spherical wrist only the last two rows hold."""
    robot = known_arm(zeros)
    assert count_postures(robot, POSTURE) == 16
    assert (solvability.table_row(robot), solvability.verdict(robot).bound) == (row, 16)


@pytest.mark.parametrize("family", ["general", "a1 = 0", "sin α1 = 0"])
def test_no_more_postures_than_the_bound(family: str) -> None:
    draw = np.random.default_rng(2)
    for _ in range(15):
        robot = random_spherical_arm(draw, family, right_wrist=False)
        found = closed.solve_closed_form(pieper, robot, tool_at(robot, draw.uniform(-pi, pi, 6)), HERE).branches
        assert 0 < len(found) <= solvability.verdict(robot).bound == 8  # type: ignore[operator]


def test_the_bound_of_an_arm_is_that_of_the_arm_upside_down() -> None:
    robot = load_robot("puma560")
    assert solvability.solution_bound(backwards(robot)) == solvability.solution_bound(robot) == 8
    assert solvability.verdict(backwards(robot)).axes == (0, 1, 2)


@pytest.mark.parametrize("name", ["movemaster", "panda", "scara", "planar2r"])
def test_only_six_turning_joints_have_a_row(name: str) -> None:
    verdict = solvability.verdict(named(name))
    assert (verdict.bound, verdict.row) == (None, None)


def test_link_lengths_of_the_puma() -> None:
    lengths = solvability.link_lengths(load_robot("puma560"))
    np.testing.assert_allclose(lengths, [a for _, a, _ in puma_rows(*LENGTHS[0])][1:], rtol=0, atol=1e-12)
