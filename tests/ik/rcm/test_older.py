"""The older ways as oracles of the constrained Jacobian, and obstacle avoidance by its identities."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.rcm.runs import START

from helicoide.arrays import Array
from helicoide.ik.rcm.constrained import Constrained, constrained
from helicoide.ik.rcm.free_motions import Basis
from helicoide.ik.rcm.older import avoiding, by_priority, entry_first, entry_jacobian, extended, older_tool_jacobian
from helicoide.ik.rcm.passage import through
from helicoide.kinematics import differential
from helicoide.kinematics.forward import link_poses
from helicoide.studies._coutinho_runs import LINK, dia10, entry_on, problem_without_planes

BASES: tuple[Basis, ...] = ("source", "scaled")


def scenes(basis: Basis, count: int) -> list[tuple[Constrained, Array, Array]]:
    """Arms off their singularities, with what their tools and entry points are asked."""
    rng, robot = np.random.default_rng(5), dia10()
    found: list[tuple[Constrained, Array, Array]] = []
    while len(found) < count:
        q = rng.uniform(robot.lower, robot.upper)
        at = constrained(
            problem_without_planes(robot), through(robot, LINK), q, entry_on(robot, q, rng.uniform(0.08, 0.2)), basis
        )
        command, entry_rate = rng.normal(size=6), 0.1 * rng.normal(size=2)
        if at.of_arm.w > 0.01 and abs(np.sin(q[6])) > 0.2:
            found.append((at, command, entry_rate))
    return found


def by_constrained_jacobian(at: Constrained, command: Array, entry_rate: Array) -> Array:
    task = at.task(command, entry_rate, 0.01)
    u = np.linalg.solve(task.J, task.rate)
    return at.rates(np.linalg.solve(at.J_arm, at.shaft_velocity(u, entry_rate)), u)


def difference(a: Array, b: Array) -> float:
    return float(np.linalg.norm(a - b) / np.linalg.norm(b))


@pytest.mark.parametrize("basis", BASES)
def test_the_stacked_jacobian_gives_the_same_rates(basis: Basis) -> None:
    """The 8 × 8 stack."""
    worst = max(difference(by_constrained_jacobian(*scene), extended(*scene)) for scene in scenes(basis, 100))
    assert worst < 1e-12


@pytest.mark.parametrize("basis", BASES)
def test_the_entry_point_first_gives_the_same_rates(basis: Basis) -> None:
    worst = max(difference(by_constrained_jacobian(*scene), entry_first(*scene)) for scene in scenes(basis, 100))
    assert worst < 1e-12


def test_at_the_start_they_agree_to_rounding() -> None:
    """Relative difference 4e-14 for the stack and 1e-13 for priority."""
    at = constrained(
        problem_without_planes(dia10()), through(dia10(), LINK), START, entry_on(dia10(), START, 0.15), "source"
    )
    command, entry_rate = np.array([0.02, -0.01, 0.03, 0.1, -0.2, 0.15]), np.array([0.004, -0.003])
    rates = by_constrained_jacobian(at, command, entry_rate)
    assert difference(extended(at, command, entry_rate), rates) < 4e-14
    assert difference(entry_first(at, command, entry_rate), rates) < 1e-13


def test_singularities_of_the_stack_are_those_of_arm_and_wrist() -> None:
    """|det [J_e; J_c]| = l_a² w_i w_r = w_i l_b² |sin θ₇|."""
    for at, _, _ in scenes("source", 50):
        stack = np.vstack([older_tool_jacobian(at), entry_jacobian(at)])
        l_a, l_b = at.place.outside, at.place.inside
        determinant = abs(np.linalg.det(stack))
        assert determinant == pytest.approx(l_a**2 * at.of_arm.w * at.of_tool.w, rel=1e-9)
        assert determinant == pytest.approx(at.of_arm.w * l_b**2 * abs(np.sin(at.q[6])), rel=1e-9)


def obstacle_scene() -> tuple[Array, Array, Array, Array]:
    """The tool's velocity, and that of the elbow away from an obstacle."""
    robot = dia10()
    J_tool = differential.frame_jacobian(robot, START)[:3]
    elbow = link_poses(robot.chain, START)[5, :3, 3]
    away = elbow / np.linalg.norm(elbow)
    J_elbow = (away @ differential.point_jacobian(robot, START, np.zeros(3), 5)[:3])[None, :]
    return J_tool, np.array([0.05, -0.02, 0.01]), J_elbow, np.array([0.1])


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
def test_the_tool_does_not_feel_an_avoided_obstacle(share: float) -> None:
    """Eq. 1.1: J_e θ̇ = ẋ_e whatever the gains; the point does its share of what is missing."""
    J_tool, command, J_point, away = obstacle_scene()
    rates = avoiding(J_tool, command, J_point, away, share, 0.8)
    np.testing.assert_allclose(J_tool @ rates, command, atol=1e-14)
    alone = np.linalg.pinv(J_tool) @ command
    np.testing.assert_allclose(J_point @ rates, (1 - share) * J_point @ alone + share * 0.8 * away, atol=1e-14)


def test_far_from_obstacles_it_is_the_pseudoinverse() -> None:
    J_tool, command, J_point, away = obstacle_scene()
    rates = avoiding(J_tool, command, J_point, away, share=0.0)
    np.testing.assert_allclose(rates, np.linalg.pinv(J_tool) @ command, atol=1e-14)


def test_with_as_many_rows_as_joints_it_is_the_stack() -> None:
    """Eq. 1.3: where [J_e; J_o] has rank n, θ̇ = [J_e; J_o]⁻¹ [ẋ_e; ẋ_o]."""
    rng = np.random.default_rng(9)
    J_tool, J_point, command, away = rng.normal(size=(6, 8)), rng.normal(size=(2, 8)), rng.normal(size=6), np.ones(2)
    stacked = np.linalg.solve(np.vstack([J_tool, J_point]), np.concatenate([command, away]))
    np.testing.assert_allclose(avoiding(J_tool, command, J_point, away), stacked, atol=1e-12)


def test_the_second_task_yields() -> None:
    """Two tasks that contradict each other: the first is met, the second comes as near as what is left allows."""
    J = np.array([[1.0, 1.0, 0.0]])
    second = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 2.0]])
    rates = by_priority(J, np.array([1.0]), second, np.array([5.0, 3.0]))
    np.testing.assert_allclose(rates, [0.5, 0.5, 1.5], atol=1e-14)
