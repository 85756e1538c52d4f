"""The guarded step as a call: what it leaves in its work space, and that nothing else is kept from step to step."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.walks import ARMS, left, scene

from helicoide.arrays import Array
from helicoide.ik.guard.guarded import ONE_LEVEL
from helicoide.ik.guard.work import Work, work_for
from helicoide.ik.packing import packed
from helicoide.ik.step import STILL, step, step_task, task_at
from helicoide.kernels import run_interpreted
from helicoide.kinematics.forward import link_poses

DT = 0.01


def targets(arm_name: str, seed: int) -> tuple[Array, Array, list[Array]]:
    """A packed arm among planes and bodies, where it stands, and poses for its tool, some of them out of reach."""
    problem, rng = scene(arm_name, seed, acceleration=20.0), np.random.default_rng(seed)
    robot = problem.robot
    drawn = rng.uniform(robot.lower, robot.upper, (6, len(robot.variables)))
    poses = [np.asarray(link_poses(robot.chain, q)[-1] @ robot.T_link_tool) for q in drawn]
    poses[2][:3, 3] *= 3.0
    return packed(problem), robot.poses["ready"].copy(), [pose for pose in poses for _ in range(25)]


def fresh(arm: Array, rates: Array) -> Work:
    work = work_for(arm)
    work.rates[:] = rates
    return work


@pytest.mark.parametrize("name", ARMS)
def test_a_work_space_holds_the_rates_and_nothing_else_of_the_steps_before(name: str) -> None:
    arm, q, path = targets(name, 3)
    work, moved = work_for(arm), 0.0
    for T in path:
        again, before = q.copy(), fresh(arm, work.rates)
        assert step(arm, q, T, STILL, DT, work.memory) == step(arm, again, T, STILL, DT, before.memory)
        np.testing.assert_array_equal(q, again)
        np.testing.assert_array_equal(work.rates, before.rates)
        np.testing.assert_array_equal(work.multipliers, before.multipliers)
        moved += float(np.abs(work.rates).max())
    assert moved > 1.0, "the arm hardly moved: this shows nothing"


@pytest.mark.parametrize("name", ARMS)
def test_the_links_are_where_the_step_ended_and_where_somebody_put_the_arm(name: str) -> None:
    arm, q, path = targets(name, 4)
    chain, work, rng = scene(name, 4).robot.chain, work_for(arm), np.random.default_rng(4)
    for k, T in enumerate(path[:60]):
        if k % 10 == 5:
            q += 0.01 * rng.normal(size=len(q))
        before = q.copy()
        step(arm, q, T, STILL, DT, work.memory)
        np.testing.assert_allclose(work.poses, link_poses(chain, q), rtol=0, atol=1e-12)
        np.testing.assert_allclose(work.rates, (q - before) / DT, rtol=0, atol=1e-12)
    assert work.share == 1.0
    assert work.pull > 0.0


@pytest.mark.parametrize("name", ARMS)
def test_a_pose_is_the_task_that_it_is_said_to_be(name: str) -> None:
    arm, q, path = targets(name, 5)
    for T in path[::5]:
        one, other = q.copy(), q.copy()
        step(arm, one, T, STILL, DT, work_for(arm).memory)
        step_task(arm, other, *task_at(arm, q, T, STILL, DT), ONE_LEVEL, DT, work_for(arm).memory)
        np.testing.assert_array_equal(one, other)
        q = one


@pytest.mark.parametrize("name", ARMS)
def test_as_python_it_comes_to_the_same(name: str) -> None:
    """The arm lives so until its kernels are there."""
    arm, q, path = targets(name, 6)
    work, problem = work_for(arm), scene(name, 6)
    for T in path[::10]:
        plain, rates = q.copy(), work.rates.copy()
        with run_interpreted():
            step(arm, plain, T, STILL, DT, fresh(arm, rates).memory)
        step(arm, q, T, STILL, DT, work.memory)
        np.testing.assert_allclose(q, plain, rtol=0, atol=1e-9)
        assert left(problem, plain).min() >= -1e-9
