"""The eight postures of the PUMA: the source's table, there and back again, and what happens where postures merge."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin

import numpy as np
import pytest
from tests.ik.closed.rows import distance, worst

from helicoide.arrays import Array
from helicoide.ik import closed
from helicoide.ik.closed import pieper, puma560
from helicoide.ik.families import puma_arm
from helicoide.ik.families.frames import pose_rows
from helicoide.ik.postures.branch import tool_at, wrap
from helicoide.kernels import run_interpreted
from helicoide.kinematics.forward import dh_frames, link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import LENGTHS, arm_from_dh, puma_rows, puma_with_lengths, puma_wrist_pose
from helicoide.studies.campos_puma import EXAMPLE, puma_round_trip
from helicoide.text import HelicoideError, untranslated

HERE = np.zeros(6)


# The pose of EXAMPLE and its postures, degrees, recomputed from the formulas of the book by other code.
POINT = (0.262305, 0.211356, -0.220210)
TABLE = [
    [17.1887, -28.6479, 40.1070, 22.9183, 51.5662, -63.0254],
    [17.1887, -28.6479, 40.1070, -157.0817, -51.5662, 116.9746],
    [17.1887, 98.8955, 145.2762, 79.3309, 161.9162, 30.4899],
    [17.1887, 98.8955, 145.2762, -100.6691, -161.9162, -149.5101],
    [-119.4674, 81.1045, 40.1070, -103.7593, 125.3785, 52.1355],
    [-119.4674, 81.1045, 40.1070, 76.2407, -125.3785, -127.8645],
    [-119.4674, -151.3521, 145.2762, -113.4273, 59.6660, -64.3108],
    [-119.4674, -151.3521, 145.2762, 66.5727, -59.6660, 115.6892],
]


@pytest.fixture(scope="module")
def arm() -> Robot:
    return load_robot("puma560")


def rows_for(lengths: tuple[float, ...], theta: Array, now: Array = HERE) -> Array:
    """Postures of the kernel for the pose at θ."""
    rows = np.empty((8, 7))
    return rows[
        : puma_arm.puma_wrist_postures(
            np.array(lengths), pose_rows(puma_wrist_pose(lengths, theta)), (now[0], now[1], now[3]), rows
        ),
        :6,
    ]


def test_the_eight_postures_of_the_example(arm: Robot) -> None:
    assert np.allclose(puma_wrist_pose(LENGTHS[0], EXAMPLE)[:3, 3], POINT, rtol=0, atol=5e-7)
    np.testing.assert_allclose(np.degrees(wrap(rows_for(LENGTHS[0], EXAMPLE))), TABLE, rtol=0, atol=5.1e-5)
    answer = closed.solve_closed_form(puma560, arm, tool_at(arm, EXAMPLE), HERE)
    off = wrap([branch.q for branch in answer.branches] - np.radians(TABLE))
    assert np.abs(np.degrees(off)).max() < 5.1e-5


@pytest.mark.parametrize(
    ("weights", "least", "others"), [([1] * 6, 0.7, 8.18), ([6, 5, 4, 3, 2, 1], 2.4, 17.2)], ids=["alike", "falling"]
)
def test_the_nearest_posture_of_the_source(weights: list[float], least: float, others: float) -> None:
    away = np.abs(wrap(rows_for(LENGTHS[0], EXAMPLE) - [0.2, -0.4, 0.8, 0.2, 1.0, -1.0]))
    costs = away @ weights
    assert costs[0] == pytest.approx(least, abs=1e-9)
    assert costs[1:].min() == pytest.approx(others, abs=0.06)


@pytest.mark.parametrize("lengths", LENGTHS)
def test_the_printed_equations_are_the_product_of_the_rows(lengths: tuple[float, ...]) -> None:
    a2, a3, d3, d4 = lengths
    for theta in np.random.default_rng(1).uniform(-pi, pi, (50, 6)):
        (c1, c2, _, c4, c5, c6), (s1, s2, _, s4, s5, s6) = np.cos(theta), np.sin(theta)
        c23, s23 = cos(theta[1] + theta[2]), sin(theta[1] + theta[2])
        x, y = c4 * c5 * c6 - s4 * s6, s4 * c5 * c6 + c4 * s6
        v, w = -c4 * c5 * s6 - s4 * c6, c4 * c6 - s4 * c5 * s6
        out = a2 * c2 + a3 * c23 - d4 * s23
        expected = [
            [c1 * (c23 * x - s23 * s5 * c6) + s1 * y, c1 * (c23 * v + s23 * s5 * s6) + s1 * w,
             -c1 * (c23 * c4 * s5 + s23 * c5) - s1 * s4 * s5, c1 * out - d3 * s1],
            [s1 * (c23 * x - s23 * s5 * c6) - c1 * y, s1 * (c23 * v + s23 * s5 * s6) - c1 * w,
             -s1 * (c23 * c4 * s5 + s23 * c5) + c1 * s4 * s5, s1 * out + d3 * c1],
            [-s23 * x - c23 * s5 * c6, -s23 * v + c23 * s5 * s6,
             s23 * c4 * s5 - c23 * c5, -a3 * s23 - a2 * s2 - d4 * c23],
        ]  # fmt: skip
        np.testing.assert_allclose(puma_wrist_pose(lengths, theta)[:3], expected, rtol=0, atol=2e-15)


@pytest.mark.parametrize("lengths", LENGTHS)
def test_there_and_back_again(lengths: tuple[float, ...]) -> None:
    """Eight postures each time, all there, among them the one that made the pose; base and tool anywhere."""
    robot = puma_with_lengths(*lengths)
    for q in np.random.default_rng(2).uniform(-pi, pi, (30, 6)):
        answer = closed.solve_closed_form(puma560, robot, tool_at(robot, q), HERE)
        assert len(answer.branches) == 8
        assert worst(robot, answer) < 1e-12
        assert distance(answer, q) < 1e-9
        assert (answer.short, answer.free, answer.moved, answer.turned) == (0, (), 0, 0)


def test_there_and_back_again_by_the_kernel(arm: Robot) -> None:
    """The short form of the count in the soak tests."""
    missed, apart, least, most = puma_round_trip(arm, 2_000, seed=3)
    assert missed < 1e-12
    assert apart < 1e-8
    assert (least, most) == (8, 8)


def test_the_kernel_is_its_plain_function() -> None:
    for theta in [*np.random.default_rng(4).uniform(-pi, pi, (20, 6)), HERE]:
        found = rows_for(LENGTHS[1], theta, theta)
        with run_interpreted():
            expected = rows_for(LENGTHS[1], theta, theta)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


def test_the_flip_keeps_the_tool_still(arm: Robot) -> None:
    for q in np.random.default_rng(5).uniform(-pi, pi, (20, 6)):
        flipped = q * [1, 1, 1, 1, -1, 1] + [0, 0, 0, pi, 0, pi]
        np.testing.assert_allclose(tool_at(arm, flipped), tool_at(arm, q), rtol=0, atol=2e-15)
        names = {branch.name.en for branch in closed.solve_closed_form(puma560, arm, tool_at(arm, q), HERE).branches}
        assert len(names) == 8


@pytest.mark.parametrize("lengths", LENGTHS)
def test_names_say_where_shoulder_and_elbow_are(lengths: tuple[float, ...]) -> None:
    """Seen from the waist towards the wrist, upper arm left or right; the elbow above or below shoulder and wrist."""
    robot = puma_with_lengths(*lengths)
    up = robot.dh.T_world_dh[:3, 2]
    for q in np.random.default_rng(6).uniform(-pi, pi, (10, 6)):
        for branch in closed.solve_closed_form(puma560, robot, tool_at(robot, q), HERE).branches:
            frames = dh_frames(robot, branch.q)
            axis = frames[3][:3, 2]
            elbow, centre = (frames[i][:3, 3] - frames[2][:3, 3] - lengths[2] * axis for i in (3, 6))
            ahead = centre - (centre @ up) * up
            above = (centre @ ahead) * (elbow @ up) > (centre @ up) * (elbow @ ahead)
            left = (lengths[2] or 1) * axis @ np.cross(up, ahead) > 0
            assert ("elbow up" in branch.name.en) == ("cotovelo para cima" in branch.name.pt_BR) == above
            assert ("shoulder left" in branch.name.en) == ("ombro à esquerda" in branch.name.pt_BR) == left


def shoulder_singular(lengths: tuple[float, ...], theta3: float) -> Array:
    """θ with the wrist centre above or below the shoulder, in the plane of the arm: u = 0."""
    a2, a3, _, d4 = lengths
    x, y = a2 + a3 * cos(theta3) - d4 * sin(theta3), a3 * sin(theta3) + d4 * cos(theta3)
    return np.array([0.4, atan2(x, y), theta3, 0.3, 0.8, -0.2])


def stretched(lengths: tuple[float, ...], way: int) -> Array:
    """θ with the elbow stretched, or folded."""
    _, a3, _, d4 = lengths
    return np.array([0.4, -0.7, atan2(a3, d4) - way * pi / 2, 0.3, 0.8, -0.2])


def test_at_the_shoulder_singularity_the_pairs_merge(arm: Robot) -> None:
    q = shoulder_singular(LENGTHS[0], 0.9)
    answer = closed.solve_closed_form(puma560, arm, tool_at(arm, q), HERE)
    assert len(answer.branches) == 4
    assert worst(arm, answer) < 1e-12
    assert distance(answer, q) < 1e-6


@pytest.mark.parametrize(("way", "known"), [(1, 1e-6), (-1, 1e-4)], ids=["stretched", "folded"])
def test_at_the_elbow_singularity_the_pairs_merge(arm: Robot, way: int, known: float) -> None:
    """Folded, the wrist centre is half a millimetre from the shoulder, and θ2 that much less certain."""
    q = stretched(LENGTHS[0], way)
    answer = closed.solve_closed_form(puma560, arm, tool_at(arm, q), HERE)
    assert len(answer.branches) == 4
    assert worst(arm, answer) < 1e-12
    assert distance(answer, q) < known


@pytest.mark.parametrize("theta5", [0, pi])
def test_a_singular_wrist_keeps_joint_4(arm: Robot, theta5: float) -> None:
    q = np.array([0.3, -0.5, 0.7, 0.4, theta5, -1.1])
    for kept in (0.0, 1.3):
        answer = closed.solve_closed_form(puma560, arm, tool_at(arm, q), np.array([0, 0, 0, kept, 0, 0]))
        assert answer.free == (3, 5)
        assert "joint 4 keeps" in answer.words.en
        assert "junta 4 mantém" in answer.words.pt_BR
        assert len(answer.branches) == 7
        assert worst(arm, answer) < 1e-12
        singular = [branch for branch in answer.branches if abs(sin(branch.q[4])) < 1e-9]
        assert [branch.q[3] for branch in singular] == [kept]
    assert distance(closed.solve_closed_form(puma560, arm, tool_at(arm, q), q), q) < 1e-9


def test_a_wrist_centre_on_the_waist_keeps_joint_1() -> None:
    lengths = LENGTHS[2]
    robot = puma_with_lengths(*lengths)
    q = shoulder_singular(lengths, 0.9) - [row.theta for row in robot.dh.rows]
    for kept in (0.5, -2.0):
        answer = closed.solve_closed_form(puma560, robot, tool_at(robot, q), np.array([kept, 0, 0, 0, 0, 0]))
        assert answer.free == (0,)
        assert [branch.q[0] for branch in answer.branches] == pytest.approx([kept] * 4)
        assert worst(robot, answer) < 1e-12


def test_equal_links_folded_onto_the_shoulder_keep_joint_2() -> None:
    lengths = (0.4, 0.0, 0.1, 0.4)
    robot = puma_with_lengths(*lengths)
    q = stretched(lengths, -1) - [row.theta for row in robot.dh.rows]
    answer = closed.solve_closed_form(puma560, robot, tool_at(robot, q), q)
    assert 1 in answer.free
    assert worst(robot, answer) < 1e-9
    assert distance(answer, q) < 1e-6


def test_rounding_does_not_put_an_edge_out_of_reach(arm: Robot) -> None:
    T = tool_at(arm, stretched(LENGTHS[0], 1))
    outer = hypot(0.1244, 0.4318 + hypot(0.0203, 0.4318))
    assert np.linalg.norm(T[:3, 3]) == pytest.approx(outer, abs=1e-12)
    beyond = T.copy()
    beyond[:3, 3] *= 1 + 1e-13
    assert closed.solve_closed_form(puma560, arm, beyond, HERE).branches
    beyond[:3, 3] *= 1 + 1e-9
    answer = closed.solve_closed_form(puma560, arm, beyond, HERE)
    assert answer.branches == ()
    assert answer.short == pytest.approx(1e-9 * outer, rel=1e-3)


@pytest.mark.parametrize("lengths", LENGTHS)
def test_out_of_reach_by_how_much(lengths: tuple[float, ...]) -> None:
    """As far as a search over all postures says; in words too."""
    robot = puma_with_lengths(*lengths)
    centre, up = robot.dh.T_world_dh[:3, 3], robot.dh.T_world_dh[:3, 2]
    draw = np.random.default_rng(7)
    places = [centre + draw.normal(size=3) for _ in range(4)] + [centre + 2 * up + 0.01 * draw.normal(size=3)]
    for place in [*places, centre + 0.3 * up, centre]:
        T = np.eye(4)
        T[:3, 3] = place
        T = T @ robot.dh.T_dh_tool
        answer, by_search = (
            closed.solve_closed_form(puma560, robot, T, HERE),
            closed.solve_closed_form(pieper, robot, T, HERE),
        )
        assert (len(answer.branches) == 0) == (answer.short > 0) == ("Out of reach" in answer.words.en)
        assert answer.short == pytest.approx(by_search.short, abs=1e-8)
        assert (untranslated("{short:.1f} mm").format(short=1000 * answer.short).pt_BR in answer.words.pt_BR) == (
            answer.short > 0
        )


def test_the_range_of_the_source() -> None:
    assert np.round(puma_arm.wrist_range(np.array(LENGTHS[0])), 4).tolist() == [0.0005, 0.8641]


def test_two_of_the_eight_keep_the_limits(arm: Robot) -> None:
    """The robot's file names both."""
    answer = closed.solve_closed_form(puma560, arm, tool_at(arm, arm.poses["example"]), HERE)
    within = [branch.q for branch in answer.branches if branch.within]
    expected = [arm.poses["example"], arm.poses["example_other"]]
    np.testing.assert_allclose(within, expected, rtol=0, atol=2e-6)


@pytest.mark.parametrize("name", ["movemaster", "zebra_zero", "scara", "planar3r", "dia10"])
def test_other_arms_are_refused(name: str) -> None:
    other = load_robot(name)
    assert puma560.applies(other) is not None
    with pytest.raises(HelicoideError):
        closed.solve_closed_form(puma560, other, np.eye(4), np.zeros(len(other.variables)))


@pytest.mark.parametrize(("row", "column"), [(1, 0), (3, 0), (4, 0), (1, 1), (4, 1), (1, 2), (4, 2)])
def test_rows_of_another_pattern_are_refused(row: int, column: int) -> None:
    rows = np.array(puma_rows(*LENGTHS[0]))
    assert puma560.applies(arm_from_dh(rows, np.eye(4), np.eye(4))) is None  # type: ignore[arg-type]
    rows[row, column] += 0.1
    assert puma560.applies(arm_from_dh(rows, np.eye(4), np.eye(4))) is not None  # type: ignore[arg-type]


def test_the_form_is_known_by_its_rows(arm: Robot) -> None:
    assert puma560.applies(arm) is None
    for lengths in LENGTHS:
        robot = puma_with_lengths(*lengths)
        assert puma560.applies(robot) is None
        np.testing.assert_array_equal(puma_arm.lengths_of(robot), lengths)


def test_what_the_equations_gave_on_the_way(arm: Robot) -> None:
    answer = closed.solve_closed_form(puma560, arm, tool_at(arm, EXAMPLE), HERE)
    for branch, values in zip(answer.branches, answer.values, strict=True):
        a2, a3, d3, d4 = LENGTHS[0]
        p, theta = link_poses(arm.chain, branch.q)[-1][:3, 3], [values[f"θ_{i + 1}"] for i in range(6)]
        assert p @ p == pytest.approx(2 * a2 * values["K"] + a2**2 + a3**2 + d3**2 + d4**2)
        assert np.abs(wrap(branch.q - theta)).max() < 1e-12
        assert values["θ_23"] == pytest.approx(theta[1] + theta[2])
