"""Arms with a spherical wrist: random ones, those of packages, those with the wrist first; singular and unreachable."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest
from tests.ik.closed.rows import backwards, distance, worst
from tests.kinematics.test_packages import packaged_arm

from helicoide.arrays import frozen
from helicoide.ik import closed
from helicoide.ik.closed import pieper, puma560
from helicoide.ik.families import pieper_arm
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.ik.postures.solve import solve, solve_by
from helicoide.kinematics import dh
from helicoide.kinematics.forward import dh_frames
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import LENGTHS, arm_from_dh, puma_with_lengths, random_pose, random_spherical_arm
from helicoide.text import HelicoideError

HERE = np.zeros(6)
FAMILIES = ["general", "a1 = 0", "sin α1 = 0"]
PACKAGED = ["puma560", "kinova", "anymal-kinova", "kr16_2", "kr120r2500pro", "kr210l150"]


def there_and_back(arms: list[Robot], draw: np.random.Generator, poses: int = 1) -> tuple[float, float, set[int]]:
    """The worst miss of any posture, the worst distance of the generating one, rad, and the numbers of postures."""
    missed, apart, counts = 0.0, 0.0, set[int]()
    for robot in arms:
        assert pieper.applies(robot) is None
        for q in draw.uniform(-pi, pi, (poses, 6)):
            answer = closed.solve_closed_form(pieper, robot, tool_at(robot, q), HERE)
            missed, apart = max(missed, worst(robot, answer)), max(apart, distance(answer, q))
            counts.add(len(answer.branches))
    return missed, apart, counts


@pytest.mark.parametrize("right_wrist", [True, False], ids=["wrist ±90°", "any wrist"])
@pytest.mark.parametrize("family", FAMILIES)
def test_random_arms_there_and_back_again(family: str, right_wrist: bool) -> None:
    """The short form of the count in the soak tests."""
    draw = np.random.default_rng(1)
    missed, apart, counts = there_and_back([random_spherical_arm(draw, family, right_wrist) for _ in range(60)], draw)
    assert missed < 1e-9
    assert apart < 1e-6
    assert max(counts) <= 8
    assert not right_wrist or counts <= {2, 4, 6, 8}


@pytest.mark.parametrize("sine", [5e-5, 1e-6])
def test_axes_that_are_nearly_parallel_have_all_postures(sine: float) -> None:
    """A PUMA of a package whose third axis leans a little, as where a file rounds its angles."""
    robot, draw = packaged_arm("puma560"), np.random.default_rng(4)
    leaning = robot.joints[2].direction + sine * robot.joints[0].direction
    joints = (
        *robot.joints[:2],
        replace(robot.joints[2], direction=frozen(leaning / np.linalg.norm(leaning))),
        *robot.joints[3:],
    )
    arm = replace(robot, joints=joints)
    missed, apart, counts = there_and_back([arm], draw, poses=20)
    assert missed < 1e-9
    assert apart < 1e-6
    assert counts <= {4, 8}


@pytest.mark.parametrize("family", FAMILIES)
def test_the_wrist_may_be_first(family: str) -> None:
    draw = np.random.default_rng(2)
    arms = [backwards(random_spherical_arm(draw, family)) for _ in range(20)]
    assert all(pieper_arm.arm_of(arm).backwards for arm in arms)  # type: ignore[union-attr]
    missed, apart, counts = there_and_back(arms, draw)
    assert missed < 1e-9
    assert apart < 1e-6
    assert max(counts) <= 8


@pytest.mark.parametrize("name", PACKAGED)
def test_arms_of_packages(name: str) -> None:
    missed, apart, counts = there_and_back([packaged_arm(name)], np.random.default_rng(3), poses=15)
    assert missed < 1e-9
    assert apart < 1e-8
    assert counts <= {4, 8}


def test_the_zebra() -> None:
    missed, apart, counts = there_and_back([load_robot("zebra_zero")], np.random.default_rng(4), poses=30)
    assert missed < 1e-12
    assert apart < 1e-8
    assert counts == {8}


@pytest.mark.parametrize("lengths", LENGTHS)
def test_the_puma_by_both_forms(lengths: tuple[float, ...]) -> None:
    robot = puma_with_lengths(*lengths)
    for q in np.random.default_rng(5).uniform(-pi, pi, (20, 6)):
        T = tool_at(robot, q)
        one, other = closed.solve_closed_form(pieper, robot, T, HERE), closed.solve_closed_form(puma560, robot, T, HERE)
        assert len(one.branches) == len(other.branches) == 8
        assert max(distance(one, branch.q) for branch in other.branches) < 1e-8


@pytest.mark.parametrize("lengths", LENGTHS)
def test_rows_that_are_mirrored_have_the_postures_of_the_puma(lengths: tuple[float, ...]) -> None:
    """Shoulder and elbow counted the other way, as the Robotics Toolbox has them: θ₂ and θ₃ with other signs."""
    signs = np.array([1, -1, -1, 1, 1, 1])
    robot = puma_with_lengths(*lengths)
    joints = tuple(
        replace(joint, direction=frozen(sign * joint.direction))
        for joint, sign in zip(robot.joints, signs, strict=True)
    )
    mirrored = replace(robot, joints=joints, dh=dh.dh_from_screws(joints, robot.T_world_tool_0))
    assert puma560.applies(mirrored) is not None
    assert next(iter(closed.of(mirrored))) == "pieper"
    for q in np.random.default_rng(8).uniform(-pi, pi, (20, 6)):
        T = tool_at(mirrored, q)
        one, other = (
            closed.solve_closed_form(pieper, mirrored, T, HERE),
            closed.solve_closed_form(puma560, robot, T, HERE),
        )
        assert len(one.branches) == len(other.branches) == 8
        assert max(distance(one, signs * branch.q) for branch in other.branches) < 1e-8


URDF = """<robot name="kr6"><link name="link0"/>{joints}<link name="tool0"/><joint name="flange" type="fixed">
<parent link="link6"/><child link="tool0"/><origin xyz="0.08 0 0" rpy="0 1.5707963 0"/></joint></robot>"""
JOINT = """<link name="link{n}"/><joint name="joint{n}" type="revolute"><parent link="link{before}"/>
<child link="link{n}"/><origin xyz="{place}"/><axis xyz="{axis}"/>
<limit lower="{low}" upper="{high}" velocity="3" effort="1"/></joint>"""
# KUKA KR 6 R900 sixx, as its ROS package has it: axes that count either way, m and rad.
KR6 = [
    ("0 0 0.4", "0 0 -1", -2.967, 2.967),
    ("0.025 0 0", "0 1 0", -3.316, 0.785),
    ("0.455 0 0", "0 1 0", -2.094, 2.723),
    ("0 0 0.035", "-1 0 0", -3.229, 3.229),
    ("0.42 0 0", "0 1 0", -2.094, 2.094),
    ("0 0 0", "-1 0 0", -6.108, 6.108),
]


def test_an_arm_from_a_file_whose_axes_count_either_way(tmp_path: Path) -> None:
    joints = "".join(
        JOINT.format(n=i + 1, before=i, place=place, axis=axis, low=low, high=high)
        for i, (place, axis, low, high) in enumerate(KR6)
    )
    (tmp_path / "kr6.urdf").write_text(URDF.format(joints=joints))
    robot = load_robot(str(tmp_path / "kr6.urdf"))
    missed, apart, counts = there_and_back([robot], np.random.default_rng(10), poses=40)
    assert missed < 1e-9
    assert apart < 1e-8
    assert counts <= {4, 8}
    assert next(iter(closed.of(robot))) == "pieper"
    for q in np.random.default_rng(11).uniform(robot.lower, robot.upper, (20, 6)):
        answer = solve(robot, tool_at(robot, q), q, every=True)
        np.testing.assert_allclose(answer.branches[0].q, q, atol=1e-8)
        expected = solve_by("numeric", robot, tool_at(robot, q), q, every=True)
        assert len(expected.branches) == len(answer.branches) == len({branch.name.en for branch in answer.branches})


@pytest.mark.parametrize("family", FAMILIES)
def test_the_wrist_centre_is_where_the_equations_say(family: str) -> None:
    """r and z of f and k, and the meridian, against the frames of the rows the robot was made of."""
    draw = np.random.default_rng(6)
    robot = random_spherical_arm(draw, family)
    arm = pieper_arm.arm_of(robot)
    for q in draw.uniform(-pi, pi, (10, 6)):
        T = arm.wrist(tool_at(robot, q))  # type: ignore[union-attr]
        frames, base = dh_frames(robot, q), dh_frames(robot, q)[1]
        centre = frames[6][:3, 3]
        axis, foot = base[:3, 2], base[:3, 3]
        _, theta2, theta3, *_ = q + arm.shifts  # type: ignore[union-attr]
        out, up = pieper_arm.meridian(arm, theta2, theta3)  # type: ignore[arg-type]
        assert out == pytest.approx(np.linalg.norm(np.cross(centre - foot, axis)), abs=1e-12)
        assert up == pytest.approx(T[2, 3], abs=1e-12)
        f1, f2, f3 = arm.f @ [1, np.cos(theta3), np.sin(theta3)]  # type: ignore[union-attr]
        k3, k4 = (row @ [1, np.cos(theta3), np.sin(theta3)] for row in arm.k)  # type: ignore[union-attr]
        a1, d2, alpha1 = arm.a[0], arm.d[1], arm.alpha[0]  # type: ignore[union-attr]
        assert k3 == pytest.approx(f1**2 + f2**2 + f3**2 + a1**2 + d2**2 + 2 * d2 * f3)
        c2, s2 = np.cos(theta2), np.sin(theta2)
        assert T[:3, 3] @ T[:3, 3] == pytest.approx(2 * a1 * (f1 * c2 - f2 * s2) + k3)
        assert T[2, 3] == pytest.approx(np.sin(alpha1) * (f1 * s2 + f2 * c2) + k4)


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("theta3", [0, pi, pi / 2])
def test_a_root_at_infinity_of_the_tangent_is_found(family: str, theta3: float) -> None:
    """θ3 = π, where tan(θ3/2) is infinite."""
    draw = np.random.default_rng(7)
    robot = random_spherical_arm(draw, family)
    q = draw.uniform(-pi, pi, 6)
    q[2] = theta3 - pieper_arm.arm_of(robot).shifts[2]  # type: ignore[union-attr]
    answer = closed.solve_closed_form(pieper, robot, tool_at(robot, q), HERE)
    assert distance(answer, q) < 1e-8
    assert worst(robot, answer) < 1e-9


def test_axes_that_meet_inexactly_are_solved_exactly() -> None:
    """The wrist's axes pass each other at 0.2 µm, which the form does not see and Newton's method does."""
    draw = np.random.default_rng(8)
    robot = random_spherical_arm(draw, "general")
    moved = replace(robot.joints[4], point=frozen(robot.joints[4].point + 2e-7 * draw.normal(size=3)))
    robot = replace(robot, joints=(*robot.joints[:4], moved, robot.joints[5]))
    missed, apart, counts = there_and_back([robot], draw, poses=20)
    assert missed < 1e-9
    assert apart < 1e-6
    assert max(counts) <= 8


def test_a_singular_wrist_keeps_joint_4() -> None:
    """The forearm lies along the last axis in two of the four arm postures, one for each shoulder."""
    robot = load_robot("zebra_zero")
    q = np.array([0.3, 0.8, -1.9, 0.4, 0, -1.1])
    for kept in (0.0, 1.3):
        answer = closed.solve_closed_form(pieper, robot, tool_at(robot, q), np.array([0, 0, 0, kept, 0, 0]))
        assert answer.free == (3, 5)
        assert "4, 6" in answer.words.en
        assert "4, 6" in answer.words.pt_BR
        assert len(answer.branches) == 6
        singular = [branch for branch in answer.branches if abs(np.sin(branch.q[4])) < 1e-9]
        assert [branch.q[3] for branch in singular] == pytest.approx([kept, kept])
        assert worst(robot, answer) < 1e-9


def test_a_singular_wrist_that_is_first_keeps_joint_3() -> None:
    robot = backwards(load_robot("zebra_zero"))
    q = np.array([0.3, 0.8, -1.9, 0.4, 0, -1.1])[::-1]
    answer = closed.solve_closed_form(pieper, robot, tool_at(robot, q), q)
    assert answer.free == (0, 2)
    assert distance(answer, q) < 1e-9


def test_a_wrist_centre_on_the_waist_keeps_joint_1() -> None:
    """The elbow of the Zebra bends so that its wrist stands over its waist: l₁ c₂ = l₂ s₂₃."""
    robot = load_robot("zebra_zero")
    q = np.array([0.3, 0.8, 0, 0.4, 0.7, -1.1])
    q[2] = np.arcsin(0.2794 * np.cos(q[1]) / 0.2286) - q[1]
    for kept in (0.3, -2.0):
        answer = closed.solve_closed_form(pieper, robot, tool_at(robot, q), np.array([kept, 0, 0, 0, 0, 0]))
        assert answer.free == (0,)
        assert "joints 1;" in answer.words.en
        assert np.abs(wrap([branch.q[0] - kept for branch in answer.branches])).max() < 1e-9
        assert worst(robot, answer) < 1e-9


def test_where_postures_merge_each_is_listed_once() -> None:
    robot = load_robot("zebra_zero")
    q = np.array([0.3, 0.8, -pi / 2, 0.4, 0.7, -1.1])
    answer = closed.solve_closed_form(pieper, robot, tool_at(robot, q), HERE)
    assert len(answer.branches) == 4
    assert distance(answer, q) < 1e-6
    assert len({branch.name.en for branch in answer.branches}) == 4


def test_out_of_reach_by_how_much() -> None:
    """The stretched Zebra comes to 508 mm from its shoulder."""
    robot = load_robot("zebra_zero")
    T = robot.T_world_tool_0.copy()
    T[:3, 3] = [0.6, 0, 0.165]
    answer = closed.solve_closed_form(pieper, robot, T, HERE)
    assert answer.branches == ()
    assert answer.short == pytest.approx(0.6 - 0.508, abs=1e-9)
    assert "92 mm" in answer.words.en
    assert "92 mm" in answer.words.pt_BR


def test_the_edge_of_a_general_arm_is_where_postures_end() -> None:
    """No posture out of many comes nearer to a goal beyond it, and some come nearly as near."""
    draw = np.random.default_rng(9)
    robot = random_spherical_arm(draw, "general")
    far = robot.dh.T_world_dh[:3, 3] + np.array([4.0, 3.0, 1.0])
    T = np.eye(4)
    T[:3, 3] = far
    T = T @ robot.dh.T_dh_tool
    short = closed.solve_closed_form(pieper, robot, T, HERE).short
    centres = np.array([dh_frames(robot, q)[6][:3, 3] for q in draw.uniform(-pi, pi, (3000, 6))])
    nearest = np.linalg.norm(centres - far, axis=1).min()
    assert nearest - 0.2 < short <= nearest


@pytest.mark.parametrize(("beyond", "postures"), [(-1e-6, 4), (1e-8, 0)])
def test_a_root_just_off_the_circle_is_no_posture(beyond: float, postures: int) -> None:
    """A stretched arm of 1 m whose waist carries the shoulder 200 mm away; its goal is beyond by 10 nm, or within."""
    right = pi / 2
    rows = [
        (0.0, 0.0, 0.0),
        (-right, 0.2, 0.0),
        (0.0, 0.4, 0.0),
        (-right, 0.0, 0.4),
        (right, 0.0, 0.0),
        (-right, 0.0, 0.0),
    ]
    robot = arm_from_dh(rows, np.eye(4), np.eye(4))
    T = tool_at(robot, np.array([0.3, 0, -right, 0.4, 0.7, 0.2])).copy()
    assert np.linalg.norm(T[:3, 3]) == pytest.approx(1, abs=1e-12)
    T[:3, 3] *= 1 + beyond
    answer = closed.solve_closed_form(pieper, robot, T, HERE)
    assert len(answer.branches) == postures
    assert answer.short == pytest.approx(max(beyond, 0), abs=1e-11)


def test_a_wrist_that_cannot_turn_that_way_is_told_from_reach() -> None:
    """Wrist angles of 40°: the last axis stays within 80° of the forearm, which the stretched arm cannot turn."""
    right = pi / 2
    rows = [
        (0, 0, 0),
        (-right, 0, 0),
        (0, 0.4, 0.1),
        (-right, 0.02, 0.4),
        (right * 4 / 9, 0, 0),
        (-right * 4 / 9, 0, 0),
    ]
    robot = arm_from_dh([tuple(map(float, row)) for row in rows], np.eye(4), np.eye(4))  # type: ignore[misc]
    T = tool_at(robot, np.array([0.2, -0.5, -1.4, 0.1, 0.6, 0.3])).copy()
    assert closed.solve_closed_form(pieper, robot, T, HERE).branches
    T[:3, :3] = T[:3, :3] @ np.diag([1, -1, -1])
    answer = closed.solve_closed_form(pieper, robot, T, HERE)
    assert answer.branches == ()
    assert answer.short < 1e-9
    assert "orientation" in answer.words.en
    assert "orientação" in answer.words.pt_BR


def test_within_the_limits() -> None:
    robot = load_robot("puma560")
    answer = closed.solve_closed_form(pieper, robot, tool_at(robot, robot.poses["example"]), HERE)
    expected = [bool(np.all((robot.lower <= branch.q) & (branch.q <= robot.upper))) for branch in answer.branches]
    assert [branch.within for branch in answer.branches] == expected
    assert sum(expected) == 2


@pytest.mark.parametrize("name", ["ur5", "panda", "movemaster", "scara", "z1"])
def test_other_arms_are_refused(name: str) -> None:
    robot = packaged_arm(name) if name in ("ur5", "panda", "z1") else load_robot(name)
    assert pieper.applies(robot) is not None
    with pytest.raises(HelicoideError):
        closed.solve_closed_form(pieper, robot, np.eye(4), np.zeros(len(robot.variables)))


def test_a_wrist_that_cannot_be_moved_everywhere_is_refused() -> None:
    """Three parallel axes before the wrist move it in a plane only; a wrist centre on axis 3 does not move with it."""
    draw = np.random.default_rng(10)
    right = pi / 2
    wrist = [(right, 0.0, 0.0), (-right, 0.0, 0.0)]
    flat = [(0.0, 0.0, 0.1), (0.0, 0.4, 0.0), (0.0, 0.3, 0.0), (right, 0.2, 0.0)]
    still = [(0.0, 0.0, 0.1), (right, 0.2, 0.0), (right, 0.4, 0.1), (right, 0.0, 0.0)]
    for rows in (flat, still):
        robot = arm_from_dh(rows + wrist, random_pose(draw), random_pose(draw))
        assert pieper.applies(robot) == pieper_arm.PLACES
