"""An entry point under the methods of the page: the same laws as in the source's closed loops."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.rcm.runs import START
from tests.kinematics.arms import derivative

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.ik import EntryPoint, Problem
from helicoide.ik.controller import Controller, ToolTarget
from helicoide.ik.guard.entry import GAIN
from helicoide.ik.objective import posture_at
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.follow import body_velocity, pose_error
from helicoide.ik.rcm.passage import insertion
from helicoide.ik.rcm.tip_task import passage_of, rcm_step, tip_task, tool_velocity
from helicoide.kinematics.forward import link_poses
from helicoide.studies._coutinho_runs import LINK, dia10, entry_on, problem_without_planes

GAINS = (3.0, 3.0, 3.0, 5.0)
STILL = np.zeros(3)


@pytest.fixture(scope="module")
def entry() -> EntryPoint:
    return EntryPoint(entry_on(dia10(), START, 0.15), LINK, frozen([[0, 0, 0], [0, 1, 0]]))


@pytest.fixture(scope="module")
def problem(entry: EntryPoint) -> Problem:
    here = problem_without_planes(dia10())
    return Problem(here.robot, here.limits, here.planes, scale=1.0, entry=entry)


def near(T: Array) -> Array:
    """A target near by."""
    moved = T.copy()
    moved[:3, 3] += [0.01, -0.02, 0.015]
    moved[:3, :3] = T[:3, :3] @ rotation.to_matrix(rotation.from_axis_angle(np.array([0.6, 0.0, 0.8]), 0.05))
    return moved


def test_the_velocity_of_the_tool_is_that_of_the_source(problem: Problem, entry: EntryPoint) -> None:
    """Coutinho 2015, eq. 2.66, with Ko for the angle and not for its half sine."""
    at = constrained(problem, passage_of(problem.robot, entry), START, entry.point)
    target, ahead = near(at.T_world_tool), np.array([0.01, 0.02, -0.01])
    source = body_velocity(
        at.T_world_tool[:3, :3], np.append(ahead, STILL), pose_error(target, at.T_world_tool), GAINS[0], 2 * GAINS[3]
    )
    np.testing.assert_allclose(tool_velocity(at, ToolTarget(target, True, ahead), GAINS), source, atol=1e-12)


def test_tip_and_entry_point_are_one_task_of_derivatives(problem: Problem, entry: EntryPoint) -> None:
    passage = passage_of(problem.robot, entry)

    def residuals(q: Array) -> Array:
        place = insertion(passage, link_poses(problem.robot.chain, q)[LINK] @ passage.T_link_shaft, entry.point)
        return np.concatenate([tool_at(problem.robot, q)[:3, 3], -place.lateral])

    target = near(tool_at(problem.robot, START))
    task = tip_task(problem, entry, START, ToolTarget(target, False, STILL), GAINS, 0.01)
    np.testing.assert_allclose(task.J, derivative(residuals, START), atol=1e-9)
    np.testing.assert_allclose(task.rate[:3], 3.0 * (target - tool_at(problem.robot, START))[:3, 3], atol=1e-12)
    np.testing.assert_allclose(task.rate[3:], -GAIN * residuals(START)[3:], atol=1e-12)


@pytest.mark.parametrize("method", ["pseudoinverse", "damped", "filtered_modified"])
def test_whatever_inverts_for_the_tool_the_shaft_keeps_its_entry_point(problem: Problem, method: str) -> None:
    """Λ J_i θ̇ = Kr e_r whether the tool is met or not (Coutinho 2015, §3.4)."""
    q, drive = START, Controller(method=method, gains=GAINS)
    assert problem.entry is not None
    passage, target = passage_of(problem.robot, problem.entry), near(tool_at(problem.robot, START))
    for _ in range(50):
        at = constrained(problem, passage, q, problem.entry.point)
        step, drive = rcm_step(problem, posture_at(problem, q), ToolTarget(target, True, STILL), drive, 0.01)
        np.testing.assert_allclose(at.at_entry(step / 0.01), GAIN * at.place.lateral, atol=1e-9)
        q = q + step
    if method == "pseudoinverse":
        missed = pose_error(target, tool_at(problem.robot, q))
        assert np.linalg.norm(missed) < 0.3 * np.linalg.norm(pose_error(target, tool_at(problem.robot, START)))
