"""The guarded step: what it keeps, what gives way to what, and what it says of itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.ik.walks import ARMS, left, scene, walked
from tests.kinematics.arms import arm

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes
from helicoide.ik import (
    AtAcceleration,
    AtEntryPoint,
    AtLimit,
    AtSpeed,
    Contact,
    Limits,
    ObstacleContact,
    Problem,
    SelfContact,
    entry_point,
    reasons,
)
from helicoide.ik.goal import goal_at_joints, goal_at_pose
from helicoide.ik.guard.guarded import ONE_LEVEL, indices
from helicoide.ik.guard.rows import Task
from helicoide.ik.guard.work import work_for
from helicoide.ik.method import Task as MethodTask
from helicoide.ik.methods import guarded as method
from helicoide.ik.packing import packed
from helicoide.ik.step import STILL, step_task, task_at
from helicoide.ik.task import ORIENTATION_LENGTH, joint_task, rotation_error
from helicoide.kinematics.differential import point_jacobian
from helicoide.kinematics.forward import link_poses
from helicoide.text import HelicoideError

DT = 0.01
STEPS = 1_700
ROUNDING = 1e-9
NONE = Planes(frozen(np.zeros((0, 3))), frozen(np.zeros((0, 3))))


def free(name: str, acceleration: float = np.inf) -> Problem:
    """An arm with nothing around it."""
    robot = arm(name)
    limits = Limits(robot.lower, robot.upper, robot.speed, frozen(np.full(len(robot.lower), acceleration)))
    return Problem(robot, limits, NONE)


def towards(problem: Problem, q: Array, T: Array, with_orientation: bool = True, dt: float = DT) -> Task:
    """The task of a tool pose (4, 4)."""
    arm = packed(problem, turn=ORIENTATION_LENGTH if with_orientation else 0.0)
    return task_at(arm, q, T, STILL, dt)


def ticked(
    problem: Problem, q: Array, task: Task, rates: Array | None = None, begins: Array = ONE_LEVEL, dt: float = DT
) -> tuple[Array, Array, float]:
    """The posture after one tick, its multipliers and the share taken."""
    after, work = q.copy(), work_for(packed(problem))
    work.rates[:] = 0.0 if rates is None else rates
    step_task(packed(problem), after, *task, begins, dt, work.memory)
    return after, work.multipliers, work.share


def turned(q: Array, angle: float) -> Array:
    """The same posture with the first joint turned on."""
    return q + angle * np.eye(len(q))[0]


def tool(problem: Problem, q: Array) -> Array:
    return np.asarray(link_poses(problem.robot.chain, frozen(q))[-1] @ problem.robot.T_link_tool)


@pytest.mark.parametrize("acceleration", [np.inf, 8.0])
@pytest.mark.parametrize("name", ARMS)
def test_no_promise_is_broken_in_a_walk(name: str, acceleration: float) -> None:
    """20,000 steps in all; the million of them is in tests/soak."""
    found = walked(scene(name, ARMS.index(name), acceleration=acceleration), STEPS, 5)
    print(name, acceleration, found)
    assert found.steps == STEPS
    assert found.unfinished == 0
    assert max(found.closer, found.outside, found.too_fast) <= ROUNDING
    assert found.too_fast > -0.1, "the walk was never fast: it shows nothing"
    assert found.shortened + found.stopped <= 0.1 * STEPS
    assert found.gave_way <= (0.1 if acceleration < np.inf else 0.0) * STEPS


# What gives way to what: planes and collisions, position, speed, acceleration, the entry point, the task.


def test_acceleration_gives_way_to_a_plane() -> None:
    """Fast towards a wall, with brakes that are too weak: the wall is kept, the joints brake harder than they may."""
    problem = free("movemaster", 0.5)
    q, rates = problem.robot.poses["ready"], np.array([0.9, 0, 0, 0, 0])
    y = max(point[1] for point in link_poses(problem.robot.chain, q)[1:, :3, 3])
    wall = Planes(frozen([[0, -1, 0]]), frozen([[0, y + 0.080 + 1e-4, 0]]))
    problem = replace(problem, planes=wall)
    after, _, share = ticked(problem, q, joint_task(q.copy(), turned(q, 1.0), -1, DT), rates)
    assert share == 1.0
    assert left(problem, after).min() >= -ROUNDING
    assert np.abs((after - q) / DT - rates).max() > 0.5 * DT * 10


def test_acceleration_gives_way_to_an_obstacle() -> None:
    problem = free("movemaster", 0.5)
    q, rates = problem.robot.poses["ready"], np.array([0.9, 0, 0, 0, 0])
    beside = tool(problem, q)[:3, 3] + [0, 0.065 + 0.05 + 0.011, 0]
    problem = replace(problem, obstacles=problem.obstacles.with_sphere(beside, 0.05))
    assert 0 < left(problem, q).min() < 0.01
    after, _, share = ticked(problem, q, joint_task(q.copy(), turned(q, 1.0), -1, DT), rates)
    assert share > 0
    assert left(problem, after).min() >= -ROUNDING
    assert np.abs((after - q) / DT - rates).max() > 0.5 * DT * 10


def test_acceleration_gives_way_to_a_position_limit() -> None:
    problem = free("puma560", 0.5)
    q, rates = problem.robot.poses["ready"].copy(), np.zeros(6)
    q[0], rates[0] = problem.limits.upper[0] - 1e-4, 1.0
    after, _, _ = ticked(problem, q, joint_task(q, q + 1.0, -1, DT), rates)
    assert after[0] <= problem.limits.upper[0]
    assert rates[0] - (after[0] - q[0]) / DT > 0.5 * DT * 10


def test_acceleration_gives_way_to_a_speed_limit() -> None:
    problem = free("puma560", 0.5)
    q, rates = problem.robot.poses["ready"], np.zeros(6)
    rates[1] = 3 * problem.limits.speed[1]
    after, _, _ = ticked(problem, q, joint_task(q.copy(), q + 1.0, -1, DT), rates)
    assert abs(after[1] - q[1]) / DT <= problem.limits.speed[1] + ROUNDING


def test_a_joint_stops_before_its_limit_within_its_acceleration() -> None:
    """Every tick of any length keeps both: v ≤ √(2 a room) leaves enough to brake."""
    problem, rng = free("planar3r", 4.0), np.random.default_rng(2)
    q, rates = np.array([0.5, 0.5, 0.5]), np.zeros(3)
    far, fastest = problem.limits.upper + 5.0, 0.0
    for _ in range(900):
        dt = float(rng.uniform(0.001, 0.05))
        after, _, _ = ticked(problem, q, joint_task(q, far, -1, dt), rates, dt=dt)
        now = (after - q) / dt
        assert np.abs(now - rates).max() <= 4.0 * dt + ROUNDING
        fastest = max(fastest, float(now.max()))
        q, rates = after, now
    assert fastest > 1.5
    np.testing.assert_allclose(q, problem.limits.upper, atol=1e-3)


def with_rod() -> Problem:
    """The rod at `ready`, through the point of its frame `rcm`."""
    problem = free("dia10_rod")
    frame = problem.robot.frames["rcm"]
    poses = link_poses(problem.robot.chain, problem.robot.poses["ready"])
    return replace(problem, entry=entry_point(problem.robot, (poses[frame.link] @ frame.T_link_frame)[:3, 3]))


def beside_rod(problem: Problem, q: Array) -> float:
    """Distance of the entry point from the line through the frame `rcm` and the tool, m."""
    assert problem.entry is not None
    frame = problem.robot.frames["rcm"]
    point = (link_poses(problem.robot.chain, frozen(q))[frame.link] @ frame.T_link_frame)[:3, 3]
    along = tool(problem, q)[:3, 3] - point
    return float(np.linalg.norm(np.cross(problem.entry.point - point, along)) / np.linalg.norm(along))


def test_the_rod_passes_through_its_entry_point_while_the_tip_moves() -> None:
    """0.01 mm, in ticks of 1 to 50 ms towards tips that jump, and the tip gets there."""
    problem, rng = with_rod(), np.random.default_rng(4)
    q = problem.robot.poses["ready"].copy()
    centre, worst, missing = tool(problem, q), 0.0, []
    for _ in range(12):
        T, dt = centre.copy(), float(np.exp(rng.uniform(np.log(0.001), np.log(0.05))))
        T[:3, 3] += rng.uniform(-0.05, 0.05, 3)
        for _ in range(int(min(400, 1.0 / dt))):
            q, held, share = ticked(problem, q, towards(problem, q, T, False, dt), dt=dt)
            active = [r for r in reasons(problem, q, held, 1e-9) if not isinstance(r, AtEntryPoint | AtSpeed)]
            assert share == 1.0
            assert active == []
            worst = max(worst, beside_rod(problem, q))
        missing.append(np.linalg.norm(tool(problem, q)[:3, 3] - T[:3, 3]))
    assert worst <= 1e-5
    assert np.median(missing) < 1e-3


def test_a_rod_beside_its_entry_point_comes_back() -> None:
    """Fed back (after Coutinho 2015, §3.4): 5 mm beside, under a thousandth of it within a second."""
    problem = with_rod()
    assert problem.entry is not None
    q = problem.robot.poses["ready"].copy()
    problem = replace(
        problem, entry=replace(problem.entry, point=frozen(problem.entry.point + np.array([0.003, 0, 0.004])))
    )
    assert beside_rod(problem, q) > 2e-3
    T = tool(problem, q)
    for _ in range(100):
        q, _, _ = ticked(problem, q, towards(problem, q, T, False))
    assert beside_rod(problem, q) < 5e-6


def test_the_task_gives_way_to_the_entry_point_and_it_is_said() -> None:
    problem = with_rod()
    q = problem.robot.poses["ready"].copy()
    T = tool(problem, q)
    T[:3, :3] = np.roll(T[:3, :3], 1, axis=1)
    for _ in range(60):
        q, held, _ = ticked(problem, q, towards(problem, q, T))
    assert beside_rod(problem, q) <= 1e-5
    assert any(isinstance(reason, AtEntryPoint) and reason.multiplier > 0 for reason in reasons(problem, q, held, 1e-9))


def test_the_entry_point_gives_way_to_acceleration() -> None:
    problem = with_rod()
    limits = replace(problem.limits, acceleration=frozen(np.full(7, 1.0)))
    problem = replace(problem, limits=limits)
    q = problem.robot.poses["ready"].copy()
    rates = np.array([0.5, -0.4, 0.3, 0.2, -0.5, 0.4, 0.1])
    after, _, share = ticked(problem, q, towards(problem, q, tool(problem, q), False), rates)
    assert share == 1.0
    assert np.abs((after - q) / DT - rates).max() <= 1.0 * DT + ROUNDING
    assert beside_rod(problem, after) > 1e-4


def test_an_arm_without_an_instrument_is_refused_in_words() -> None:
    with pytest.raises(HelicoideError, match="PUMA 560"):
        entry_point(arm("puma560"), [0, 0, 0])


def test_a_pushed_joint_motion_gives_way_to_the_task() -> None:
    """A last level Δq = q̇₀ dt turns the elbow of a redundant arm; the tool moves as without it."""
    problem = free("dia10")
    q = problem.robot.poses["ready"]
    T = tool(problem, q)
    T[:3, 3] += [0.02, -0.03, 0.01]
    J, v, weights, damping = towards(problem, q, T)
    push = np.zeros(8)
    push[3] = 0.5 * DT
    pushed = (np.vstack((J, np.eye(8))), np.concatenate((v, push)), np.concatenate((weights, np.ones(8))), damping)
    alone, _, _ = ticked(problem, q, (J, v, weights, damping))
    both, _, _ = ticked(problem, q, pushed, begins=indices([6]))
    np.testing.assert_allclose(J @ (both - q), J @ (alone - q), rtol=0, atol=1e-8)
    assert (both - alone)[3] > 0.1 * push[3]


def test_position_before_orientation() -> None:
    """Two levels: where five joints cannot do both, the position is met as if orientation did not count."""
    problem = free("movemaster")
    q = problem.robot.poses["ready"]
    T = tool(problem, q)
    T[:3, 3] += [0.01, 0.005, 0]
    T[:3, :3] = np.roll(T[:3, :3], 1, axis=1)
    J, v, weights, _ = towards(problem, q, T)
    task = (J, v, np.where(weights < 1, 1.0, weights), np.full(5, 1e-9))
    split, _, _ = ticked(problem, q, task, begins=indices([3]))
    mixed, _, _ = ticked(problem, q, task)
    assert np.linalg.norm(J[:3] @ (split - q) - v[:3]) < 1e-6
    assert np.linalg.norm(J[:3] @ (mixed - q) - v[:3]) > 1e-4


# What it says.


@pytest.mark.parametrize("seed", range(4))
def test_the_multipliers_balance_the_task(seed: int) -> None:
    """H Δq − g = Σ μ row over the planes' points, position and speed limits: nothing else holds the step."""
    problem = scene("zebra_zero", seed, obstacles=0)
    rng, n = np.random.default_rng(seed), 6
    q, balanced = problem.robot.poses["ready"].copy(), 0
    for k in range(200):
        if k % 40 == 0:
            T = tool(problem, rng.uniform(problem.limits.lower, problem.limits.upper))
        task = towards(problem, q, T)
        before, (q, held, share) = q, ticked(problem, q, task)
        J, v, weights, damping = task
        gradient = J.T @ (weights**2 * (J @ (q - before) - v)) + damping * (q - before)
        pushes = [(held[:n] - held[n : 2 * n]) + (held[-4 * n - 1 : -3 * n - 1] - held[-3 * n - 1 : -2 * n - 1])]
        for reason in reasons(problem, before, held, 0.0):
            if isinstance(reason, Contact):
                point, link = problem.robot.monitored_points[reason.point], problem.robot.monitored_links[reason.point]
                normal = problem.planes.normals[reason.plane]
                row = normal @ point_jacobian(problem.robot, before, point, int(link))[:3]
                pushes.append(reason.multiplier * row)
        if share == 1.0:
            np.testing.assert_allclose(gradient, sum(pushes), rtol=0, atol=1e-7 * (1 + np.abs(gradient).max()))
            balanced += held.any()
    assert balanced > 50


def rests(problem: Problem, q_target: Array) -> set[type]:
    """What holds the arm back at the end of the way to other joint values."""
    return {type(reason) for reason in goal_at_joints(problem, problem.robot.poses["ready"], q_target).reasons}


def test_it_is_said_what_holds_the_arm() -> None:
    problem = free("movemaster")
    q = problem.robot.poses["ready"]
    folded = np.array([0, np.radians(-30), np.radians(-120), np.radians(-100), 0])
    assert rests(problem, folded) >= {SelfContact}
    walled = replace(problem, planes=Planes(frozen([[0, -1, 0]]), frozen([[0, 0.3, 0]])))
    assert rests(walled, turned(q, 1.2)) == {Contact}
    inside = tool(problem, turned(q, 0.8))[:3, 3]
    blocked = replace(problem, obstacles=problem.obstacles.with_sphere(inside, 0.1))
    assert rests(blocked, turned(q, 0.8)) == {ObstacleContact}
    assert rests(problem, turned(q, 2.0)) == {AtLimit}


def test_it_is_said_that_a_joint_is_at_its_speed_or_its_acceleration() -> None:
    q = arm("movemaster").poses["ready"].copy()
    task = joint_task(q, turned(q, 0.6), -1, DT)
    for acceleration, kind in ((np.inf, AtSpeed), (1.0, AtAcceleration)):
        problem = free("movemaster", acceleration)
        _, held, _ = ticked(problem, q, task)
        (reason,) = reasons(problem, q, held, 1e-6)
        assert reason == kind(0)
        assert reason.multiplier > 0


def test_a_reason_names_the_pair() -> None:
    problem = free("movemaster")
    folded = np.array([0, np.radians(-30), np.radians(-120), np.radians(-100), 0])
    goal = goal_at_joints(problem, problem.robot.poses["ready"], folded)
    contact = next(reason for reason in goal.reasons if isinstance(reason, SelfContact))
    pair = problem.pairs.index((contact.first, contact.second))
    assert 0 <= left(problem, goal.q)[pair] < 2e-3


# Where it gets.


@pytest.mark.parametrize("name", ARMS)
def test_clear_goals_are_reached(name: str) -> None:
    """At least 95 of 100 tool positions of clear postures with a clear joint path are met to a millimetre."""
    reached = []
    for seed in range(4):
        problem, rng = scene(name, 50 + seed), np.random.default_rng(seed)
        start = problem.robot.poses["ready"]
        while len(reached) < 5 * (seed + 1):
            end = start + rng.uniform(-0.7, 0.7, len(start)) * (problem.limits.upper - problem.limits.lower) / 2
            end = np.clip(end, problem.limits.lower, problem.limits.upper)
            if min(left(problem, q).min() for q in np.linspace(start, end, 20)) > 0.03:
                reached.append(goal_at_pose(problem, start, frozen(tool(problem, end)), False).position_error < 1e-3)
    assert np.mean(reached) >= 0.95


def test_orientation_yields_gradually_near_a_plane_and_comes_back() -> None:
    """The tool rises with its pitch held until the wrist is under the ceiling; then it tilts while it goes on."""
    problem = free("movemaster")
    q = problem.robot.poses["ready"].copy()
    T, ceiling = tool(problem, q), link_poses(problem.robot.chain, q)[1:, 2, 3].max() + 0.080 + 0.03
    problem = replace(problem, planes=Planes(frozen([[0, 0, -1]]), frozen([[0, 0, ceiling]])))
    tilted, off = [], []
    for height in (*np.linspace(0, 0.09, 300), *np.full(100, 0.09), *np.linspace(0.09, 0, 300), *np.zeros(150)):
        aim = T.copy()
        aim[2, 3] += height
        q, _, _ = ticked(problem, q, towards(problem, q, aim))
        now = tool(problem, q)
        tilted.append(float(np.linalg.norm(rotation_error(T[:3, :3].copy(), now[:3, :3].copy()))))
        off.append(float(np.linalg.norm(now[:3, 3] - aim[:3, 3])))
    assert max(tilted[:50]) < np.radians(0.2)
    assert max(tilted) > np.radians(5)
    assert np.abs(np.diff(tilted)).max() < np.radians(1.2)
    assert tilted[-1] < np.radians(0.1)
    assert max(off[399], off[-1]) < 2e-3


# As a method.


@pytest.mark.parametrize("name", ["scara", "puma560", "planar3r"])
@pytest.mark.parametrize("split", [False, True])
def test_the_rates_of_the_method_lead_to_the_guarded_posture(name: str, split: bool) -> None:
    problem = scene(name, 9, acceleration=20.0)
    options = method.Options(levels=split)
    rng, units = np.random.default_rng(1), problem.joint_units
    q, memory = problem.robot.poses["ready"], frozen(np.zeros(len(units)))
    for _ in range(30):
        J, _, _, _ = towards(problem, q, tool(problem, q))
        J = J * units
        J[:3] /= problem.length
        solution, after = method.step(problem, MethodTask(q, J, rng.normal(size=6), 0.02), memory, options)
        moved = q + units * solution.rates * 0.02
        np.testing.assert_allclose(after, units * solution.rates, rtol=0, atol=1e-12)
        assert (np.abs(after) <= problem.limits.speed + ROUNDING).all()
        assert (moved <= problem.limits.upper + ROUNDING).all()
        assert (moved >= problem.limits.lower - ROUNDING).all()
        assert left(problem, moved).min() >= min(0.0, left(problem, q).min()) - ROUNDING
        q, memory = frozen(moved), after
