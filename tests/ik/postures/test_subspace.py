"""Goals taken to the subspace of arms with fewer than six joints, and the edges of workspaces: Campos 1998, s.6–36."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.ik.closed.small_arms import moved

from helicoide.arrays import Array, frozen
from helicoide.geometry import euler, rotation
from helicoide.ik.families.turret import turret
from helicoide.ik.postures import subspace, workspace
from helicoide.ik.postures.branch import between, tool_at
from helicoide.ik.postures.nearest import nearest_posture
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._campos_arms import planar_pose
from helicoide.text import LANGUAGES, HelicoideError

SMALL = ["planar2r", "planar3r", "orca", "polar_rp", "motoman_l3", "scara", "movemaster"]
ROBOTS = {name: load_robot(name) for name in SMALL}
angles = st.floats(-np.pi, np.pi)
turns = st.tuples(angles, st.floats(-1.5, 1.5), angles)


def posture(robot: Robot, shares: tuple[float, ...]) -> Array:
    """A posture at parts of the joints' ranges."""
    part = np.array(shares[: len(robot.variables)])
    return robot.lower + part * (robot.upper - robot.lower)


@pytest.mark.parametrize("name", SMALL)
@given(shares=st.tuples(*[st.floats(0, 1)] * 5))
@settings(max_examples=30)
def test_a_pose_that_the_arm_takes_stays(name: str, shares: tuple[float, ...]) -> None:
    robot = ROBOTS[name]
    T = tool_at(robot, posture(robot, shares))
    projection = subspace.project_to_subspace(robot, T, robot.poses["ready"])
    # nearer to its edge than 10⁻¹² of its reach a 2R counts as stretched or folded, an angle of some 10⁻⁶
    near = 1e-5 if name == "planar2r" else 1e-9
    assert projection.moved < 1e-9
    assert projection.turned < near
    np.testing.assert_allclose(projection.T_world_goal, T, atol=near)


@pytest.mark.parametrize("name", SMALL)
@given(p=st.tuples(*[st.floats(-0.6, 0.6)] * 3), turn=turns)
@settings(max_examples=30)
def test_a_projected_pose_stays_and_says_how_far_it_went(
    name: str, p: tuple[float, ...], turn: tuple[float, ...]
) -> None:
    robot = ROBOTS[name]
    T = planar_pose(*p[:2], z=p[2])
    T[:3, :3] = euler.euler_matrix(list(turn), "zyx")
    now = robot.poses["ready"]
    first = subspace.project_to_subspace(robot, T, now)
    assert (first.moved, first.turned) == pytest.approx(between(T, first.T_world_goal), abs=1e-12)
    again = subspace.project_to_subspace(robot, first.T_world_goal, now)
    np.testing.assert_allclose(again.T_world_goal, first.T_world_goal, atol=1e-7)
    assert (first.words is None) == (max(first.moved, first.turned) < 1e-9)


def test_what_was_done_is_said_with_its_numbers() -> None:
    T = planar_pose(0.9, 0.4, 0.3, z=0.05)
    T[:3, :3] = T[:3, :3] @ euler.euler_matrix([0, np.radians(20), 0], "zyx")
    words = subspace.project_to_subspace(ROBOTS["planar3r"], T, np.zeros(3)).words
    assert words is not None
    for language in LANGUAGES:
        assert "50 mm" in words[language]
        assert "20°" in words[language]


@given(p=st.tuples(st.floats(0.2, 0.5), st.floats(-0.4, 0.4), st.floats(0.1, 0.7)), turn=turns)
def test_the_movemaster_turns_its_hand_into_its_plane(p: tuple[float, ...], turn: tuple[float, ...]) -> None:
    """As the L-3: the point is kept, |θ| = asin |M·Ẑ|, Ẑ the roll axis, which is the x axis of this tool."""
    T = planar_pose(*p[:2], z=p[2])
    T[:3, :3] = euler.euler_matrix(list(turn), "zyx")
    projection = subspace.project_to_subspace(ROBOTS["movemaster"], T, np.zeros(5))
    M = np.array([-p[1], p[0], 0]) / np.hypot(*p[:2])
    assert projection.moved == 0
    assert np.sin(projection.turned) == pytest.approx(abs(M @ T[:3, 0]), abs=1e-9)
    assert M @ projection.T_world_goal[:3, 0] == pytest.approx(0, abs=1e-9)


@given(p=st.tuples(*[st.floats(-0.4, 0.4)] * 3), turn=turns)
@settings(max_examples=40)
def test_the_scara_keeps_its_quill_upright(p: tuple[float, ...], turn: tuple[float, ...]) -> None:
    T = planar_pose(*p[:2], z=p[2])
    T[:3, :3] = euler.euler_matrix(list(turn), "zyx")
    projection = subspace.project_to_subspace(ROBOTS["scara"], T, np.zeros(4))
    np.testing.assert_allclose(projection.T_world_goal[:3, 3], p)
    np.testing.assert_allclose(projection.T_world_goal[:3, 2], [0, 0, -1], atol=1e-12)
    down = euler.euler_matrix([0, 0, np.pi], "zyx")
    others = [
        planar_pose(*p[:2], phi, p[2]) @ np.block([[down, np.zeros((3, 1))], [0, 0, 0, 1]]) for phi in np.arange(32) / 5
    ]
    assert projection.turned <= min(between(T, other)[1] for other in others) + 1e-6


@pytest.mark.parametrize("r", [0.1, 0.9, 2.5])
def test_a_goal_of_two_links_lies_in_their_plane_out_of_reach_too(r: float) -> None:
    T = planar_pose(r, 0, z=0.2)
    T[:3, :3] = euler.euler_matrix([0.7, 0.4, -0.3], "zyx")
    projection = subspace.project_to_subspace(ROBOTS["planar2r"], T, np.zeros(2))
    np.testing.assert_allclose(projection.T_world_goal[:, 2:], [[0, r], [0, 0], [1, 0], [0, 1]], atol=1e-12)
    assert projection.moved == pytest.approx(0.2)


def test_upside_down_every_heading_is_as_near_and_the_present_one_is_kept() -> None:
    T = planar_pose(0.5, 0.2)
    T[:3, :3] = np.diag([1.0, -1, -1])
    q = np.array([0.3, 0.4, 0.5])
    projection = subspace.project_to_subspace(ROBOTS["orca"], T, q)
    np.testing.assert_allclose(projection.T_world_goal, planar_pose(0.5, 0.2, 1.2), atol=1e-12)
    assert projection.turned == pytest.approx(np.pi)


@pytest.mark.parametrize("name", ["planar2r", "polar_rp", "motoman_l3", "scara", "movemaster"])
def test_no_posture_at_the_point_turns_less(name: str) -> None:
    """Position first: of the postures that a search finds for the point, none comes nearer in orientation."""
    robot, rng = ROBOTS[name], np.random.default_rng(4)
    for q in rng.uniform(robot.lower, robot.upper, (2, robot.lower.size)):
        T = tool_at(robot, q)
        T[:3, :3] = T[:3, :3] @ rotation.exponential(rng.normal(scale=0.3, size=3))
        projection = subspace.project_to_subspace(robot, T, q)
        assert projection.moved == pytest.approx(0, abs=1e-12)
        for start in rng.normal(q, 0.1, (5, q.size)):
            gap, turn = between(T, tool_at(robot, nearest_posture(robot, T, frozen(start), with_orientation=False)))
            assert gap < 1e-6
            assert turn >= projection.turned - 1e-6


def test_arms_with_six_joints_take_every_pose() -> None:
    robot = load_robot("puma560")
    T = planar_pose(0.5, 0.1, 0.3, z=0.2)
    projection = subspace.project_to_subspace(robot, T, robot.poses["ready"])
    np.testing.assert_array_equal(projection.T_world_goal, T)
    assert projection.words is None


def skewed() -> Robot:
    """A Movemaster whose tool point stands beside its last axis: no closed projection."""
    robot = ROBOTS["movemaster"]
    T = robot.T_world_tool_0.copy()
    T[:3, 3] += [0, 0.05, 0.02]
    return replace(robot, T_world_tool_0=frozen(T))


def test_other_arms_are_searched() -> None:
    robot, rng = skewed(), np.random.default_rng(5)
    assert turret(robot) is None
    for q in rng.uniform(robot.lower, robot.upper, (4, 5)):
        T = tool_at(robot, q)
        exact = subspace.project_to_subspace(robot, T, robot.poses["ready"])
        assert (exact.moved, exact.turned) == pytest.approx((0, 0), abs=1e-7)
        T[:3, :3] = T[:3, :3] @ rotation.exponential(rng.normal(scale=0.2, size=3))
        found = subspace.project_to_subspace(robot, T, q)
        cost = (found.moved / robot.reach) ** 2 + found.turned**2
        for near in rng.normal(q, 0.05, (50, 5)):
            gap, turn = between(T, tool_at(robot, frozen(near)))
            assert (gap / robot.reach) ** 2 + turn**2 >= cost - 1e-12


@given(r=st.floats(0, 3), heading=angles)
def test_distance_to_the_edge_of_a_planar_arm(r: float, heading: float) -> None:
    T = planar_pose(r * np.cos(heading), r * np.sin(heading))
    expected = max(r - 1.7, 0.3 - r, 0)
    assert subspace.distance_beyond(ROBOTS["planar2r"], T, np.zeros(2)) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(
    ("name", "p", "expected"),
    [
        ("motoman_l3", (0.9, 0.9, 0.9), np.sqrt(3) * 0.9 - 0.9),
        ("motoman_l3", (0.03, 0.02, 0.01), 0.1 - np.sqrt(14e-4)),
        ("motoman_l3", (0.3, 0.2, 0.1), 0.0),
        ("polar_rp", (0.6, 0.8, 0.0), 0.2),
        ("polar_rp", (0.0, 0.1, 0.0), 0.2),
        ("scara", (0.6, 0.0, 0.2), 0.05),
        ("scara", (0.3, 0.0, 0.3), 0.07),
        ("movemaster", (1.0, 0.0, 0.4), 0.18),
        ("movemaster", (40.0, 0.0, 0.4), 39.18),
        ("orca", (0.0, 1.0, 0.0), np.hypot(1, 0.17) - 0.485),
    ],
)
def test_distance_to_the_edge_of_other_arms(name: str, p: tuple[float, ...], expected: float) -> None:
    """The search finds what geometry says: a shell, a ring, a cylinder; ORCA with its wrist 170 mm behind the tool."""
    robot = ROBOTS[name]
    T = robot.T_world_tool_0.copy()
    T[:3, 3] = p
    assert subspace.distance_beyond(robot, T, robot.poses["ready"]) == pytest.approx(expected, abs=1e-8)


def test_edges_of_planar_workspaces() -> None:
    """s.8–10: radii |L1 − L2| and L1 + L2; a disc of 2 L1 where they are equal."""
    assert workspace.reachable(np.array([1, 0.7])) == pytest.approx((0.3, 1.7))
    assert workspace.reachable(np.array([0.8, 0.8])) == (0, 1.6)
    assert workspace.reachable(np.array([1, 0.7, 0.2])) == pytest.approx((0.1, 1.9))
    assert workspace.reachable(np.array([2.0, 1, 1])) == (0, 4)


def test_dexterous_points() -> None:
    """s.8–10: none for two unequal links, the centre for equal ones; 0.5 to 1.5 for L = (1, 0.7, 0.2)."""
    assert workspace.dexterous(np.array([1, 0.7])) == ()
    assert workspace.dexterous(np.array([0.8, 0.8])) == ((0, 0),)
    ((inner, outer),) = workspace.dexterous(np.array([1, 0.7, 0.2]))
    assert (inner, outer) == pytest.approx((0.5, 1.5))
    assert workspace.dexterous(np.array([0.8, 0.8, 0.3])) == (pytest.approx((0, 1.3)),)
    assert workspace.dexterous(np.array([0.3, 0.3, 0.7])) == ()
    ((inner, outer),) = workspace.dexterous(np.array([1.9, 1.6, 1.6]))[1:]
    assert inner == outer == pytest.approx(1.9)


@given(lengths=st.tuples(*[st.floats(0.1, 2)] * 3), r=st.floats(0, 4))
def test_dexterous_rings_hold_the_points_whose_wrist_circle_is_reached(lengths: tuple[float, ...], r: float) -> None:
    l1, l2, l3 = lengths
    hole, widest = abs(l1 - l2), l1 + l2 - l3
    assume(min(abs(hole + l3 - widest), abs(l3 - hole), abs(widest)) > 1e-6)
    phis = np.linspace(0, np.pi, 721)
    far = np.hypot(r - l3 * np.cos(phis), l3 * np.sin(phis))
    every = bool(np.all((far >= abs(l1 - l2) - 1e-9) & (far <= l1 + l2 + 1e-9)))
    rings = workspace.dexterous(np.array(lengths))
    inside = any(inner - 1e-9 <= r <= outer + 1e-9 for inner, outer in rings)
    on_an_edge = any(abs(r - edge) < 1e-6 for ring in rings for edge in ring)
    assert inside == every or on_an_edge


@pytest.mark.parametrize("name", SMALL)
def test_an_arm_that_stands_elsewhere_projects_alike(name: str) -> None:
    robot, place = ROBOTS[name], planar_pose(0.3, -0.2, 0.9, z=0.5)
    place[:3, :3] = euler.euler_matrix([0.4, -0.9, 2.0], "zyx")
    T = planar_pose(0.31, 0.22, z=0.4)
    T[:3, :3] = euler.euler_matrix([0.3, 0.5, -0.2], "zyx")
    now = robot.poses["ready"]
    here = subspace.project_to_subspace(robot, T, now)
    there = subspace.project_to_subspace(moved(robot, place), place @ T, now)
    np.testing.assert_allclose(there.T_world_goal, place @ here.T_world_goal, atol=1e-9)


@pytest.mark.parametrize("function", [subspace.project_to_subspace, subspace.distance_beyond])
def test_what_is_no_pose_is_refused(function: object) -> None:
    with pytest.raises(HelicoideError, match="pose"):
        function(ROBOTS["orca"], planar_pose(np.nan, 0), np.zeros(3))  # type: ignore[operator]
    with pytest.raises(HelicoideError, match="finite joint values"):
        function(ROBOTS["orca"], planar_pose(0.2, 0), np.zeros(2))  # type: ignore[operator]
