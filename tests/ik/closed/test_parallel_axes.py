"""Arms with three parallel axes: the UR family by its published rows and from files, skewed ones, edges, refusals."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.ik.closed.rows import distance, worst

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler, rotation
from helicoide.ik import closed
from helicoide.ik.closed import parallel_axes
from helicoide.ik.families.parallel_arm import parallel_arm
from helicoide.ik.families.parallel_postures import parallel_joint_values
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.ik.postures.solve import solve, solve_by
from helicoide.kernels import run_interpreted
from helicoide.kinematics import dh
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError

HERE = np.zeros(6)
# d₁, a₂, a₃, d₄, d₅, d₆, mm, as Universal Robots publishes them; α = 90°, 0, 0, 90°, −90°, 0.
PUBLISHED = {
    "ur3": (151.9, -243.65, -213.25, 112.35, 85.35, 81.9),
    "ur3e": (151.85, -243.55, -213.2, 131.05, 85.35, 92.1),
    "ur5": (89.159, -425, -392.25, 109.15, 94.65, 82.3),
    "ur5e": (162.5, -425, -392.2, 133.3, 99.7, 99.6),
    "ur10": (127.3, -612, -572.3, 163.941, 115.7, 92.2),
    "ur10e": (180.7, -612.7, -571.55, 174.15, 119.85, 116.55),
    "ur16e": (180.7, -478.4, -360, 174.15, 119.85, 116.55),
}
TWISTS = (pi / 2, 0.0, 0.0, pi / 2, -pi / 2, 0.0)
URDF = """<robot name="{name}"><link name="base_link"/><link name="link0"/>
<joint name="turned" type="fixed"><parent link="base_link"/><child link="link0"/><origin rpy="0 0 {yaw}"/></joint>
{joints}</robot>"""
JOINT = """<link name="link{n}"/><joint name="joint{n}" type="revolute"><parent link="link{before}"/>
<child link="link{n}"/><origin xyz="{x} {y} {z}" rpy="{roll} 0 0"/><axis xyz="0 0 {sign}"/>
<limit lower="-6.283185" upper="6.283185" velocity="3" effort="1"/></joint>"""
LAST = """<link name="tool0"/><joint name="flange" type="fixed"><parent link="link6"/><child link="tool0"/>
<origin xyz="0 0 {z}"/></joint>"""


def ur(name: str, folder: Path, digits: int = 16, sign: int = 1) -> Robot:
    """An arm of the family read from a file whose base is turned by 180°, with angles of so many digits."""
    d1, a2, a3, d4, d5, d6 = (f"{length / 1000:.9g}" for length in PUBLISHED[name])
    places = [(0, 0, d1), (0, 0, 0), (a2, 0, 0), (a3, 0, d4), (0, f"-{d5}", 0), (0, 0, 0)]
    rolls = [0.0, *TWISTS[:5]]
    joints = "".join(
        JOINT.format(n=i + 1, before=i, x=x, y=y, z=z, roll=f"{roll:.{digits}g}", sign=sign if i % 2 else 1)
        for i, ((x, y, z), roll) in enumerate(zip(places, rolls, strict=True))
    )
    file = folder / f"{name}.urdf"
    file.write_text(URDF.format(name=name, yaw=f"{pi:.{digits}g}", joints=joints + LAST.format(z=d6)))
    return load_robot(str(file))


def by_rows(lengths: tuple[float, ...], theta: Array) -> Array:
    """The wrist's pose by the published rows, (4, 4), m."""
    d1, a2, a3, d4, d5, d6 = (length / 1000 for length in lengths)
    T = np.eye(4)
    rows = zip(theta, (d1, 0, 0, d4, d5, d6), (0, a2, a3, 0, 0, 0), TWISTS, strict=True)
    for angle, d, a, alpha in rows:
        T = T @ dh._about_z(angle, d) @ dh._about_x_and_y(a, alpha, 0.0)
    return T


@pytest.mark.parametrize("name", PUBLISHED)
def test_the_files_are_the_published_arms(name: str, tmp_path: Path) -> None:
    robot = ur(name, tmp_path)
    turned = np.diag([-1.0, -1, 1, 1])
    for q in np.random.default_rng(1).uniform(-pi, pi, (5, 6)):
        np.testing.assert_allclose(tool_at(robot, q), turned @ by_rows(PUBLISHED[name], q), rtol=0, atol=1e-9)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("digits", [16, 7])
@pytest.mark.parametrize("name", PUBLISHED)
def test_there_and_back_again(name: str, digits: int, sign: int, tmp_path: Path) -> None:
    """Each listed once with a name of its own, and among them the one that made the pose; mostly eight."""
    robot, counts = ur(name, tmp_path, digits, sign), []
    assert next(iter(closed.of(robot))) == "parallel_axes"
    for q in np.random.default_rng(2).uniform(-pi, pi, (40, 6)):
        answer = closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), HERE)
        assert worst(robot, answer) < 1e-9
        assert distance(answer, q) < 1e-6
        assert len({branch.name.en for branch in answer.branches}) == len(answer.branches) == len(answer.values)
        counts.append(len(answer.branches))
    assert set(counts) <= {2, 4, 6, 8}
    assert counts.count(8) > 20


@pytest.mark.parametrize("name", ["ur3e", "ur5"])
def test_the_searches_find_no_others(name: str, tmp_path: Path) -> None:
    robot = ur(name, tmp_path)
    for q in np.random.default_rng(3).uniform(-pi, pi, (6, 6)):
        T = tool_at(robot, q)
        answer = solve(robot, T, q, every=True)
        expected = solve_by("numeric", robot, T, q, every=True)
        assert len(answer.branches) == len(expected.branches)
        assert max(distance(answer, branch.q) for branch in expected.branches) < 1e-6


def skewed(seed: int) -> Robot:
    """An arm of the kind with axes at any angles, standing anywhere."""
    draw = np.random.default_rng(seed)
    robot = load_robot("zebra_zero")
    h, *others = rotation.unit_vector(draw.normal(size=(4, 3)))
    directions = [others[0], h, h * draw.choice([-1, 1]), h * draw.choice([-1, 1]), others[1], others[2]]
    points = draw.uniform(-0.5, 0.5, (6, 3))
    points[5] = points[4] + draw.uniform(-0.2, 0.2) * others[2]
    joints = tuple(
        replace(joint, direction=frozen(s), point=frozen(p), lower=-2 * pi, upper=2 * pi)
        for joint, s, p in zip(robot.joints, directions, points, strict=True)
    )
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = euler.euler_matrix(draw.uniform(-1.5, 1.5, 3), "zyx"), draw.uniform(-1, 1, 3)
    return replace(robot, joints=joints, T_world_tool_0=frozen(T), dh=dh.dh_from_screws(joints, T))


@given(st.integers(0, 2**32 - 1))
def test_axes_at_any_angles(seed: int) -> None:
    robot = skewed(seed)
    q = np.random.default_rng(seed).uniform(-pi, pi, 6)
    assert parallel_axes.applies(robot) is None
    answer = closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), HERE)
    assert worst(robot, answer) < 1e-8
    assert distance(answer, q) < 1e-3
    assert len(answer.branches) <= 8


def test_names_say_where_shoulder_elbow_and_wrist_are(tmp_path: Path) -> None:
    """The arm's plane left or right of the waist, seen towards the wrist; the elbow above shoulder and fourth axis."""
    robot = ur("ur5", tmp_path)
    seen = set()
    for q in np.random.default_rng(4).uniform(-pi, pi, (40, 6)):
        for branch in closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), HERE).branches:
            poses = link_poses(robot.chain, branch.q)
            along = poses[2, :3, :3] @ robot.directions[1]
            flat = np.eye(3) - np.outer(along, along)
            shoulder, elbow, wrist = (flat @ p for p in poses[2:5, :3, 3])
            centre = poses[5, :3, 3]
            ahead = (wrist - shoulder) * [1, 1, 0]
            above = ((wrist - shoulder) @ ahead) * (elbow - shoulder)[2] > (wrist - shoulder)[2] * (
                (elbow - shoulder) @ ahead
            )
            left = (along @ centre) * along @ np.cross([0, 0, 1], centre * [1, 1, 0]) > 0
            assert ("elbow up" in branch.name.en) == ("cotovelo para cima" in branch.name.pt_BR) == above
            assert ("shoulder left" in branch.name.en) == ("ombro à esquerda" in branch.name.pt_BR) == left
            seen.add(branch.name.en)
    assert len(seen) == 8


def test_whole_turns_lead_into_the_limits(tmp_path: Path) -> None:
    """Within ±2π the nearest posture stays where the arm stands, more than half a turn away from zero."""
    robot = ur("ur3e", tmp_path)
    q = np.array([4.0, -1.2, 1.5, -5.0, 1.1, 6.0])
    answer = solve(robot, tool_at(robot, q), q)
    np.testing.assert_allclose(answer.branches[0].q, q, atol=1e-9)
    listed = closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), q)
    assert all(branch.within and (np.abs(branch.q) <= pi).all() for branch in listed.branches)


def test_a_singular_wrist_keeps_joint_6(tmp_path: Path) -> None:
    robot = ur("ur5", tmp_path)
    q = np.array([0.3, -1.2, 1.4, 0.6, 0.0, 0.7])
    for kept in (0.7, -1.0):
        answer = closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), np.array([0, 0, 0, 0, 0, kept]))
        assert answer.free == (5,)
        assert "joint 6" in answer.words.en
        assert "junta 6" in answer.words.pt_BR
        assert worst(robot, answer) < 1e-9
        singular = [branch.q[5] for branch in answer.branches if abs(np.sin(branch.q[4])) < 1e-6]
        np.testing.assert_allclose(singular, kept, atol=1e-9)
    assert distance(closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), q), q) < 1e-6


@pytest.mark.parametrize("q", [HERE, np.array([0.2, -0.8, 0, 0.5, 1, 0.3])], ids=["home", "stretched"])
def test_a_stretched_arm_is_found_on_its_edge(q: Array, tmp_path: Path) -> None:
    robot = ur("ur5e", tmp_path)
    answer = closed.solve_closed_form(parallel_axes, robot, tool_at(robot, q), q)
    assert distance(answer, q) < 1e-5
    assert worst(robot, answer) < 1e-9


def test_out_of_reach_is_said_and_told_from_an_orientation_that_is_not_taken(tmp_path: Path) -> None:
    robot = ur("ur5", tmp_path)
    T = tool_at(robot, robot.poses["ready"]).copy()
    T[:3, 3] += [3, 1, 0]
    answer = closed.solve_closed_form(parallel_axes, robot, T, HERE)
    assert answer.branches == ()
    assert answer.short > 2
    assert f"{1000 * answer.short:.1f} mm" in answer.words.en
    near = tool_at(robot, np.array([0.1, -0.5, 0.02, 0.3, 1.2, 0.4])).copy()
    near[:3, :3] = near[:3, :3] @ np.diag([1, -1, -1])
    turned = closed.solve_closed_form(parallel_axes, robot, near, HERE)
    assert turned.branches == ()
    assert turned.short == 0
    assert "orientation" in turned.words.en
    assert "orientação" in turned.words.pt_BR


def test_the_kernel_is_its_plain_function(tmp_path: Path) -> None:
    robot = ur("ur10e", tmp_path)
    arm = parallel_arm(robot)
    assert arm is not None
    for q in [*np.random.default_rng(5).uniform(-pi, pi, (5, 6)), HERE]:
        rows = parallel_joint_values(arm, tool_at(robot, q), q)
        with run_interpreted():
            expected = parallel_joint_values(arm, tool_at(robot, q), q)
        np.testing.assert_allclose(wrap(rows[:, :6] - expected[:, :6]), 0, atol=1e-7)
        np.testing.assert_array_equal(rows[:, 6:], expected[:, 6:])


@pytest.mark.parametrize("name", ["puma560", "zebra_zero", "movemaster", "scara"])
def test_other_arms_are_refused(name: str) -> None:
    other = load_robot(name)
    assert parallel_axes.applies(other) is not None
    with pytest.raises(HelicoideError):
        closed.solve_closed_form(parallel_axes, other, np.eye(4), np.zeros(len(other.variables)))
