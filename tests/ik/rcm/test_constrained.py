"""The constrained Jacobian: the same as the printed ones, as the arm's own, and as the entry point demands."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.ik.rcm.runs import START
from tests.kinematics.arms import derivative

from helicoide.arrays import Array, frozen
from helicoide.ik.rcm import wrists
from helicoide.ik.rcm.constrained import Constrained, constrained
from helicoide.ik.rcm.free_motions import Basis, constraint, null_basis
from helicoide.ik.rcm.older import entry_jacobian, older_tool_jacobian
from helicoide.ik.rcm.passage import SLIT, TROCAR, Insertion, Passage, insertion, through
from helicoide.kinematics import differential
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.studies._coutinho_runs import LINK, dia10, entry_on, problem_without_planes, zx_wrist

LENGTH, L_8 = 0.33, 0.21
BASES: tuple[Basis, ...] = ("source", "scaled")
TABLE = pytest.mark.parametrize(
    ("robot", "across", "printed", "w"),
    [
        (dia10, SLIT, wrists.zy_slit, wrists.w_zy_slit),
        (dia10, TROCAR, wrists.zy_trocar, wrists.w_zy_trocar),
        (zx_wrist, TROCAR, wrists.zx_trocar, wrists.w_zx_trocar),
    ],
    ids=["zy slit", "zy trocar", "zx trocar"],
)


def postures(robot: Robot, count: int) -> Array:
    return np.random.default_rng(2015).uniform(robot.lower, robot.upper, (count, len(robot.variables)))


def standing(
    robot: Robot, q: Array, outside: float, across: Array = TROCAR, basis: Basis = "source", scale: float = 1.0
) -> Constrained:
    """The arm at q with the entry point on its shaft."""
    entry = entry_on(robot, q, outside)
    return constrained(problem_without_planes(robot, scale), through(robot, LINK, across), q, entry, basis)


@TABLE
def test_the_general_jacobian_is_the_printed_one(robot, across, printed, w) -> None:
    """Eqs. 3.24, 3.28 and 3.29, the last in one frame, at random postures and depths; largest entries near 10."""
    depths = np.random.default_rng(3).uniform(0.05, 0.4, 100)
    for q, l_a in zip(postures(robot(), 100), depths, strict=True):
        expected = printed(l_a, LENGTH - l_a, L_8, q[6], q[7])
        J = standing(robot(), q, l_a, across).J
        np.testing.assert_allclose(J, expected, rtol=0, atol=1e-12)


@TABLE
def test_manipulability_of_the_tool_is_the_printed_one(robot, across, printed, w) -> None:
    """Eqs. 3.40 (its root), 3.41, 3.42: formula, singular values and determinant."""
    for q, l_a in zip(postures(robot(), 50), np.linspace(0.05, 0.33, 50), strict=True):
        at = standing(robot(), q, l_a, across)
        expected = w(l_a, LENGTH - l_a, q[6])
        assert at.of_tool.w == pytest.approx(expected, rel=1e-9, abs=1e-12)
        assert np.sqrt(abs(np.linalg.det(at.J @ at.J.T))) == pytest.approx(expected, rel=1e-6, abs=1e-6)


def test_manipulability_at_the_start() -> None:
    """§3.5 at l_a = 0.15, l_b = 0.18, θ₇ = −0.6164."""
    assert wrists.w_zy_trocar(0.15, 0.18, -0.6164) == pytest.approx(0.8325, abs=5e-5)
    assert wrists.w_zy_slit(0.15, 0.18, -0.6164) == pytest.approx(1.7124, abs=5e-5)
    at = standing(dia10(), START, 0.15)
    assert at.of_tool.w == pytest.approx(0.8325, abs=5e-5)
    assert at.of_arm.w == pytest.approx(0.02828, abs=5e-6)
    assert at.of_arm.w == pytest.approx(abs(np.linalg.det(at.J_arm)), rel=1e-12)


@pytest.mark.parametrize(
    ("wrist", "q7"),
    [(wrists.w_zy_trocar, 0.0), (wrists.w_zy_trocar, np.pi), (wrists.w_zx_trocar, np.pi / 2)],
)
def test_where_the_wrist_is_singular(wrist, q7: float) -> None:
    """§3.5: zy where axes 6 and 8 align, zx with a bent joint 7; and both at l_b = 0."""
    assert wrist(0.15, 0.18, q7) == pytest.approx(0.0, abs=1e-15)
    assert wrist(0.15, 0.18, q7 + 0.1) == pytest.approx(wrist(0.15, 0.18, q7 - 0.1), rel=1e-9)
    assert wrist(0.33, 0.0, q7 + 0.1) == 0.0


def test_the_slit_stays_free_where_the_wrist_is_stretched() -> None:
    """Eq. 3.40 at θ₇ = 0 is (l_b/l_a)√2; only l_b = 0 is singular."""
    q = START.copy()
    q[6] = 0.0
    at = standing(dia10(), q, 0.15, SLIT)
    assert at.of_tool.w == pytest.approx(0.18 / 0.15 * np.sqrt(2), rel=1e-12)
    assert standing(dia10(), START, 0.33, SLIT).of_tool.w == pytest.approx(0.0, abs=1e-12)


@given(st.floats(-0.3, 0.5), st.floats(-1.9, 1.9))
def test_the_scaled_basis_knows_no_depth(l_a: float, q7: float) -> None:
    """|det J^r| = l_b² |sin θ₇|, through l_a = 0."""
    q = START.copy()
    q[6] = q7
    at = standing(dia10(), q, l_a, basis="scaled")
    assert abs(np.linalg.det(at.J)) == pytest.approx((LENGTH - l_a) ** 2 * abs(np.sin(q7)), abs=1e-13)


def test_the_scaled_basis_is_finite_at_joint_six() -> None:
    at = standing(dia10(), START, 0.0, basis="scaled")
    assert np.isfinite(at.J).all()
    assert at.of_tool.rank == 6


PLACES = [
    Insertion(0.15, 0.18, TROCAR, np.zeros(2)),
    Insertion(0.15, 0.18, SLIT, np.zeros(1)),
    Insertion(0.07, 0.26, frozen([[0.6, 0.0, 0.8]]), np.zeros(1)),
    Insertion(0.07, 0.26, frozen([[0.48, 0.36, 0.8]]), np.zeros(1)),
]


@pytest.mark.parametrize("place", PLACES, ids=["trocar", "slit", "plane along the shaft", "slanting plane"])
@pytest.mark.parametrize("basis", BASES)
def test_free_motions_leave_the_entry_point_alone(place: Insertion, basis: Basis) -> None:
    """Λ Λ# = 0 with 6 − r independent columns, and Λ V = N (v + ω × p_ir). Eqs. 3.6, 3.7."""
    Lambda, null = constraint(place), null_basis(place, basis)
    np.testing.assert_allclose(Lambda @ null, 0.0, atol=1e-14)
    assert np.linalg.matrix_rank(null) == null.shape[1] == 6 - len(place.forbidden)
    v, turn = np.random.default_rng(1).normal(size=(2, 3))
    at_entry = v + np.cross(turn, [0.0, place.outside, 0.0])
    np.testing.assert_allclose(Lambda @ [*v, *turn], place.forbidden @ at_entry, atol=1e-14)


@pytest.mark.parametrize("place", PLACES[:2], ids=["trocar", "slit"])
def test_the_null_bases_are_those_of_the_source(place: Insertion) -> None:
    """Eqs. 3.23, 3.27, and v_x = l_a ω_z, v_z = −l_a ω_x."""
    l_a = place.outside
    slit = np.vstack([np.eye(5), [1 / l_a, 0, 0, 0, 0]])
    trocar = [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [0, 0, -1 / l_a, 0],
        [0, 0, 0, 1],
        [1 / l_a, 0, 0, 0],
    ]
    scaled_trocar = np.zeros((6, 4))
    scaled_trocar[1, 0] = scaled_trocar[3, 1] = scaled_trocar[4, 2] = scaled_trocar[5, 3] = 1.0
    scaled_trocar[0, 3], scaled_trocar[2, 1] = l_a, -l_a
    expected = slit if len(place.forbidden) == 1 else trocar
    np.testing.assert_allclose(null_basis(place, "source"), expected, atol=1e-15)
    if len(place.forbidden) == 2:
        np.testing.assert_allclose(null_basis(place, "scaled"), scaled_trocar, atol=1e-15)


def test_the_constraint_is_that_of_the_source() -> None:
    """Eqs. 3.22, 3.26."""
    np.testing.assert_allclose(constraint(PLACES[1]), [[1, 0, 0, 0, 0, -0.15]], atol=1e-15)
    np.testing.assert_allclose(constraint(PLACES[0]), [[1, 0, 0, 0, 0, -0.15], [0, 0, 1, 0.15, 0, 0]], atol=1e-15)


def passages(robot: Robot) -> list[Passage]:
    """Every link that has a length, as a trocar and as a slit."""
    ends = [*robot.points, robot.T_world_tool_0[:3, 3]]
    links = [i for i in range(1, len(robot.joints) + 1) if np.linalg.norm(ends[i] - ends[i - 1]) > 0]
    return [one for i in links for one in (through(robot, i), through(robot, i, SLIT))]


def sliding_torso() -> Robot:
    joints = dia10().joints
    return replace(dia10(), joints=(replace(joints[0], kind="prismatic"), *joints[1:]))


ARMS = {
    "dia10": dia10,
    "puma560": lambda: load_robot("puma560"),
    "scara": lambda: load_robot("scara"),
    "slide": sliding_torso,
}


@pytest.mark.parametrize("basis", BASES)
@pytest.mark.parametrize("name", ARMS)
def test_it_maps_what_any_link_may_do_to_the_tool(name: str, basis: Basis) -> None:
    """Of any arm and any restricted link i: V_e = J^r [v; θ̇ after] + Jc v_rd for joint rates with Λ J_i θ̇ = v_rd."""
    robot = ARMS[name]()
    rng = np.random.default_rng(7)
    for passage in passages(robot):
        q = rng.uniform(robot.lower, robot.upper)
        T = link_poses(robot.chain, q)[passage.link] @ passage.T_link_shaft
        at = constrained(problem_without_planes(robot), passage, q, T[:3, 3] + 0.4 * passage.length * T[:3, 1], basis)
        rates = rng.normal(size=len(q))
        of_link = at.J_arm @ rates[: passage.link]
        entry_rate = at.constraint @ of_link
        v = np.linalg.pinv(at.null) @ (of_link - at.push @ entry_rate)
        u = np.concatenate([v, rates[passage.link :]])
        assert at.J.shape == (6, 6 - passage.r + len(q) - passage.link)
        np.testing.assert_allclose(at.J @ u + at.J_entry @ entry_rate, older_tool_jacobian(at) @ rates, atol=1e-12)
        np.testing.assert_allclose(older_tool_jacobian(at), differential.body_jacobian(robot, q), atol=2e-15)
        np.testing.assert_allclose(entry_jacobian(at) @ rates, entry_rate, atol=1e-14)
        np.testing.assert_allclose(at.constraint @ at.push, np.eye(passage.r), atol=1e-14)


@pytest.mark.parametrize("robot", [dia10, sliding_torso])
@pytest.mark.parametrize("basis", BASES)
def test_the_characteristic_length_is_no_matter_to_an_exact_inverse(robot, basis: Basis) -> None:
    """Tasks without lengths come back as the same joint rates, and these do what was asked."""
    command, entry_rate = np.array([0.02, -0.01, 0.03, 0.1, -0.2, 0.15]), np.array([0.004, -0.003])
    for scale in (1.0, 0.1, 2.4):
        at = standing(robot(), START, 0.15, TROCAR, basis, scale)
        asked = at.task(command, entry_rate, 0.01)
        u = np.linalg.solve(asked.J, asked.rate)
        of_arm = at.arm_task(at.shaft_velocity(u, entry_rate), 0.01)
        rates = at.rates(np.linalg.solve(of_arm.J, of_arm.rate), u)
        np.testing.assert_allclose(older_tool_jacobian(at) @ rates, command, atol=1e-14)
        np.testing.assert_allclose(at.at_entry(rates), entry_rate, atol=1e-15)
        np.testing.assert_array_equal(of_arm.q, START)
        assert (asked.dt, of_arm.dt) == (0.01, 0.01)


def test_rows_of_a_task_have_no_lengths() -> None:
    """A drawing of the arm at twice the size, with ℓ twice as long, asks the same."""
    robot = dia10()
    joints = tuple(replace(joint, point=2 * joint.point) for joint in robot.joints)
    T = robot.T_world_tool_0.copy()
    T[:3, 3] *= 2
    frames = {"tool": replace(robot.frames["tool"], T_link_frame=T)}
    large = replace(robot, joints=joints, T_world_tool_0=T, frames=frames)
    command, entry_rate = np.array([0.02, -0.01, 0.03, 0.1, -0.2, 0.15]), np.array([0.004, -0.003])
    twice = np.array([2.0] * 3 + [1.0] * 3)
    for basis in BASES:
        small_task = standing(robot, START, 0.15, TROCAR, basis, 0.5).task(command, entry_rate, 0.01)
        large_at = standing(large, START, 0.30, TROCAR, basis, 1.0)
        large_task = large_at.task(twice * command, 2 * entry_rate, 0.01)
        np.testing.assert_allclose(large_task.J, small_task.J, atol=1e-12)
        np.testing.assert_allclose(large_task.rate, small_task.rate, atol=1e-12)


@pytest.mark.parametrize("across", [TROCAR, SLIT])
def test_depth_and_lateral_error_change_as_the_constraint_says(across: Array) -> None:
    """l̇_a = −v_y and ė_r = −Λ V_i with the entry point at rest on the shaft."""
    robot, passage = dia10(), through(dia10(), LINK, across)
    entry = entry_on(robot, START, 0.15)

    def place(q: Array) -> Array:
        one = insertion(passage, link_poses(robot.chain, q)[LINK] @ passage.T_link_shaft, entry)
        return np.array([one.outside, *one.lateral])

    at = standing(robot, START, 0.15, across)
    expected = np.vstack([-at.J_arm[1], -at.constraint @ at.J_arm])
    np.testing.assert_allclose(derivative(place, START)[:, :LINK], expected, atol=1e-10)
