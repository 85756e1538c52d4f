"""Iterating to a pose and along a path: the counts of the sources, every method, and what is said where it fails."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from tests.ik.secondary_runs import (
    DAMPED,
    PINV,
    at,
    fixed_point,
    point_along,
    position_task,
    problem,
    solved_posture,
    tool_position,
)

from helicoide.arrays import Array
from helicoide.ik import Problem, converge, methods
from helicoide.ik.clik import to_pose
from helicoide.ik.converge import (
    INNER,
    Convergence,
    IterativeSolver,
    Report,
    StoppingCriterion,
    Tolerance,
    converged,
    frozen_reference,
    solver_of,
)
from helicoide.ik.method import ConfiguredMethod, Method, Promise, Solution, Task
from helicoide.ik.methods import configured_method
from helicoide.kinematics.forward import link_poses
from helicoide.studies.cerbaro_runs.setups import movemaster, orca
from helicoide.trajectory import EQ_33

# The counts of the sources are in the studies cerbaro_orca_convergence and cerbaro_movemaster_convergence.


def home(problem: Problem) -> Array:
    return problem.robot.poses["home"]


def test_a_report_ends_with_the_first_error_within_the_tolerance_and_says_so() -> None:
    here = orca()
    report = converged(solver_of(here, PINV, 0.55), to_pose(here, at(0.26, 0.18)), home(here))
    assert report.reached
    assert report.iterations == 7
    assert report.words.en.startswith("Converged after 7 iterations")
    assert len(report.errors) == 8
    assert Tolerance().holds(*report.errors[-1])
    assert not Tolerance().holds(*report.errors[-2])


def test_a_tolerance_is_kept_by_both_errors() -> None:
    near = Tolerance(1e-3, 0.01)
    assert near.holds(1e-3, 0.01)
    assert not near.holds(1.1e-3, 0.0)
    assert not near.holds(0.0, 0.011)


def test_how_long_an_iteration_lasts_makes_no_difference_without_memory() -> None:
    here = orca()
    solver = solver_of(here, PINV, 0.55, dt=0.02)
    assert converged(solver, to_pose(here, at(0.26, 0.18)), home(here)).iterations == 7


def test_a_moving_target_can_be_taken_as_it_is_at_one_instant() -> None:
    here = movemaster()
    moving = frozen_reference(position_task(here, point_along(EQ_33)), 7.5)
    newton = solver_of(here, PINV, 1.0, StoppingCriterion(Tolerance(1e-9, 0)))
    report = converged(newton, moving, here.robot.poses["path_start"])
    assert report.reached
    np.testing.assert_allclose(tool_position(here, report.q), EQ_33.point(7.5), rtol=0, atol=2e-9)


# What else may happen.


CONVERGENT = [name for name in methods.names() if Promise.CONVERGES in methods.named(name).PROMISES]


@pytest.mark.parametrize("name", CONVERGENT)
@pytest.mark.parametrize("robot_name", ["puma560", "scara", "dia10"])
def test_every_method_comes_to_a_reachable_pose(robot_name: str, name: str) -> None:
    here, inverse = problem(robot_name), configured_method(name)
    q = here.robot.poses["ready"]
    reachable = link_poses(here.robot.chain, q + 0.15 * here.joint_units)[-1] @ here.robot.T_link_tool
    aiming = to_pose(here, reachable)
    aim = aiming(q, 0.0)
    if inverse.method.applies(Task(q, aim.J, aim.error, 1.0)) is None:
        report = converged(solver_of(here, inverse, 0.5, StoppingCriterion(cap=400)), aiming, q)
        assert report.reached, report.words.en
        np.testing.assert_array_less(report.errors[-1], [1e-3, 0.01])
        assert report.iterations > 3


def test_an_arm_at_a_singular_posture_says_that_it_cannot_move() -> None:
    """Stretched along y and called to fold, damped least squares have nowhere to go: Jᵀ e = 0."""
    here = problem("planar3r")
    start = np.array([np.pi / 2, 0, 0])
    report = converged(solver_of(here, DAMPED, 0.5), position_task(here, fixed_point(0, 3)), start)
    assert report.outcome is Convergence.UNFELT
    assert not report.reached
    assert report.iterations == converge.PAUSES
    np.testing.assert_allclose(report.errors, [[1.0, 0.0]] * 6, rtol=0, atol=1e-9)
    assert "singular" in report.words.en
    assert "1×10³ mm" in report.words.pt_BR


def test_a_method_that_gives_nothing_is_told_from_a_singular_posture() -> None:
    here = orca()
    idle = SimpleNamespace(
        start=lambda task, options: None,
        step=lambda problem, task, memory, options: (Solution(np.zeros(3)), None),
    )
    inverse = ConfiguredMethod(cast(Method, idle), None)
    report = converged(solver_of(here, inverse, 0.5), to_pose(here, at(0.26, 0.18)), home(here))
    assert report.outcome is Convergence.HELD
    assert "method" in report.words.en


def test_a_pause_is_not_rest() -> None:
    """The filtered inverse begins with Θ = 0 and stands still for one step."""
    here = orca()
    solver = solver_of(here, configured_method("filtered"), 0.5)
    errors = converged(solver, to_pose(here, at(0.26, 0.18)), home(here)).errors
    np.testing.assert_array_equal(errors[0], errors[1])
    assert (errors[2] < errors[1]).all()


def test_what_is_out_of_reach_is_tried_until_the_cap() -> None:
    here = problem("puma560")
    solver = solver_of(here, configured_method("damped", damping=0.1), 0.5, StoppingCriterion(cap=30))
    report = converged(solver, position_task(here, fixed_point(0.6, 1.0, 0.0)), here.robot.poses["ready"])
    assert report.outcome is Convergence.CAPPED
    assert report.iterations == 30
    assert "30" in report.words.pt_BR
    assert report.errors[-1, 0] > 0.1


def test_a_goal_that_is_met_needs_no_step() -> None:
    here = movemaster()
    q = here.robot.poses["ready"]
    aiming = to_pose(here, link_poses(here.robot.chain, q)[-1] @ here.robot.T_link_tool)
    report = converged(solver_of(here, PINV, 0.5), aiming, q)
    assert report.reached
    assert report.iterations == 0
    np.testing.assert_array_equal(report.q, q)


def test_the_memory_of_a_report_goes_on_where_it_stopped() -> None:
    """Twenty steps in one go, or ten and then ten more."""
    here = orca()
    aiming, never = to_pose(here, at(0.26, 0.18)), Tolerance(0, 0)
    twenty, ten = (
        solver_of(here, configured_method("filtered", gain=0.1), 0.2, StoppingCriterion(never, cap)) for cap in (20, 10)
    )
    whole = converged(twenty, aiming, home(here))
    half = converged(ten, aiming, home(here))
    rest = converged(ten, aiming, half.q, half.memory)
    np.testing.assert_allclose(rest.q, whole.q, rtol=0, atol=1e-13)
    np.testing.assert_allclose(np.vstack([half.errors, rest.errors[1:]]), whole.errors, rtol=0, atol=1e-12)


# Along a path with the inner rule (Cerbaro 2022, §6.1, step 3): 10 mm, and no point is left before.


def along(solver: IterativeSolver, points: list[Array], q: Array) -> list[Report]:
    """The iteration to each of the points, (3,), m, from where the one before ended."""
    reports: list[Report] = []
    memory = None
    for point in points:
        reports.append(converged(solver, position_task(solver.problem, fixed_point(*point)), q, memory))
        q, memory = reports[-1].q, reports[-1].memory
    return reports


def test_no_point_of_a_path_is_left_before_the_tool_is_within_10_mm() -> None:
    """The ellipse of eq. 33 in 61 points, up to 29 mm apart, one step or more for each."""
    here = movemaster()
    points = [EQ_33.point(s) for s in np.linspace(0, 30, 61)]
    solver = solver_of(here, configured_method("damped", damping=0.1), 0.5, INNER)
    reports = along(solver, points, here.robot.poses["path_start"])
    assert all(report.reached for report in reports)
    steps = [report.iterations for report in reports]
    assert min(steps) == 1
    assert 2 <= max(steps) < 10
    for point, report in zip(points, reports, strict=True):
        tool = (link_poses(here.robot.chain, report.q)[-1] @ here.robot.T_link_tool)[:3, 3]
        assert report.errors[-1, 0] == pytest.approx(np.linalg.norm(tool - point), abs=1e-9)
        assert report.errors[-1, 0] <= 0.010


def test_what_a_method_has_learnt_is_kept_from_point_to_point() -> None:
    """Only at the first point does the filtered inverse begin with Θ = 0 and stand still for a step."""
    here = movemaster()
    solver = solver_of(here, configured_method("filtered", gain=5.0), 0.5, INNER)
    points = [EQ_33.point(s) for s in (2.0, 4.0, 6.0)]
    first, *rest = along(solver, points, here.robot.poses["path_start"])
    assert first.errors[0, 0] == first.errors[1, 0]
    for report in rest:
        assert report.errors[1, 0] < report.errors[0, 0]


def test_points_out_of_reach_are_reported_with_what_is_missing() -> None:
    """Straight out along x at the height of the shoulder: beyond 0.82 m plus 10 mm no point is met."""
    here = movemaster()
    xs = np.arange(0.70, 0.901, 0.02)
    solver = solver_of(here, configured_method("damped", damping=50.0), 0.5, INNER)
    start = solved_posture(here, position_task(here, fixed_point(0.70, 0, 0.4)), here.robot.poses["ready"])
    reports = along(solver, [np.array([x, 0, 0.4]) for x in xs], start)
    assert [report.reached for report in reports] == [x < 0.83 for x in xs]
    for x, report in zip(xs, reports, strict=True):
        if not report.reached:
            assert report.errors[-1, 0] == pytest.approx(x - 0.82, abs=1e-3)
            assert report.iterations <= converge.CAP_PER_POINT
    assert INNER.tolerance.orientation == inf
