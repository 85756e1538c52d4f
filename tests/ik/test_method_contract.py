"""Every method, on every robot that it applies to, is held to what it says of itself."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from tests.driving import Worst, at, watch

from helicoide import gate
from helicoide.advance import advance
from helicoide.arrays import Array, frozen
from helicoide.command import ToPose
from helicoide.confinement import planes_of
from helicoide.geometry import rotation
from helicoide.ik.drive import Drive, step, task_of
from helicoide.ik.method import OneOf, Promise, Quantity, Task, YesNo, changed, settings
from helicoide.ik.methods import named, names
from helicoide.kinematics import library
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.manipulability import analysed
from helicoide.kinematics.robot import Robot
from helicoide.state import State, initial
from helicoide.text import HelicoideError, Text
from helicoide.view.formula import mathml

ROBOTS = sorted(library.titles())
STILL = np.zeros(3)
GAIN = 5.0
DTS = (0.001, 0.003, 0.01, 0.02, 0.05)

every_method = pytest.mark.parametrize("name", names())
every_robot = pytest.mark.parametrize("robot_name", ROBOTS)
both_tasks = pytest.mark.parametrize("with_orientation", [True, False], ids=["pose", "position"])


@cache
def state_of(robot_name: str) -> State:
    """The arm at `ready`, with nothing around it."""
    state = initial(library.load(robot_name))
    return replace(state, problem=replace(state.problem, planes=planes_of(())))


def answered(state: State, T: Array, with_orientation: bool, drive: Drive, dt: float = 0.01) -> tuple[Array, Drive]:
    """What the method of a drive wishes in one step towards a pose."""
    return step(state.problem, asked(state, T, with_orientation, dt), state.arm.poses, drive)


def asked(state: State, T: Array, with_orientation: bool, dt: float = 0.01, gain: float = GAIN) -> Task:
    return task_of(state.problem, state.arm.q, state.arm.poses, T, with_orientation, STILL, (gain,) * 4, dt)


def tool_at(robot: Robot, q: Array) -> Array:
    return frozen(link_poses(robot.chain, frozen(q))[-1] @ robot.T_link_tool)


def applicable(name: str, state: State, with_orientation: bool) -> bool:
    """Whether the method applies; where it does not, it must say why in both languages."""
    why = named(name).applies(asked(state, state.T_world_tool, with_orientation))
    assert why is None or (why.en and why.pt_BR and why.en != why.pt_BR)
    return why is None


def promises(name: str, promise: Promise) -> bool:
    return promise in named(name).PROMISES


@every_method
def test_a_method_says_all_of_itself(name: str) -> None:
    method = named(name)
    assert isinstance(method.TITLE, Text)
    assert any(year in method.SOURCE for year in map(str, range(1955, 2027)))
    assert "<math" in mathml(method.EQUATION)
    assert method.REMEMBERS is None or isinstance(method.REMEMBERS, Text)
    assert set(Promise) >= method.PROMISES


@every_method
def test_every_setting_can_be_set_and_refuses_what_is_not_valid(name: str) -> None:
    options = named(name).Options()
    for field, setting in settings(type(options)).items():
        default = getattr(options, field)
        assert changed(options, field, default) == options
        match setting:
            case Quantity(_, lower, upper):
                assert lower <= default <= upper
                assert getattr(changed(options, field, upper), field) == upper
                wrong = [lower - 1e-9 - 1e-3 * abs(lower), np.nan, np.inf, "1", None, True]
            case OneOf(_, choices):
                assert {getattr(changed(options, field, key), field) for key in choices} == set(choices)
                wrong = ["", None, 1.0]
            case YesNo():
                wrong = ["yes", 1, None]
        for value in wrong:
            with pytest.raises(HelicoideError):
                changed(options, field, value)
    with pytest.raises(HelicoideError, match="nonsense"):
        changed(options, "nonsense", 1.0)


@every_robot
@every_method
@both_tasks
def test_answers_are_finite_whatever_is_asked(name: str, robot_name: str, with_orientation: bool) -> None:
    """Targets that jump by metres, also out of reach, and steps from 1 to 50 ms; the figures are those of the file."""
    state, rng = state_of(robot_name), np.random.default_rng(1)
    if not applicable(name, state, with_orientation):
        return
    drive, q = Drive().by(name), state.arm.q
    for k in range(40):
        if k % 10 == 0:
            T = np.eye(4)
            T[:3, :3] = rotation.to_matrix(rotation.from_rotation_vector(rng.normal(size=3)))
            T[:3, 3] = 3 * state.robot.reach * rng.normal(size=3)
        wished, drive = answered(at(state, q), T, with_orientation, drive, float(rng.choice(DTS)))
        assert np.isfinite(wished).all()
        assert drive.solution is not None
        assert set(drive.solution.figures) <= set(named(name).FIGURES)
        q = frozen(np.clip(q + np.clip(wished, -0.2, 0.2), state.robot.lower, state.robot.upper))


@every_robot
@every_method
@both_tasks
def test_a_reachable_pose_is_reached(name: str, robot_name: str, with_orientation: bool) -> None:
    """CONVERGES: to a thousandth of the reach and of a radian, or a fiftieth of the way, from a posture not far off."""
    state = state_of(robot_name)
    if not (promises(name, Promise.CONVERGES) and applicable(name, state, with_orientation)):
        return
    robot, rng = state.robot, np.random.default_rng(2)
    q, goal = clear_of_singularities(robot, rng, with_orientation)
    T, drive = tool_at(robot, goal), Drive().by(name)
    way = missing(at(state, q), T, with_orientation)
    for _ in range(200):
        wished, drive = answered(at(state, q), T, with_orientation, drive, 0.02)
        q = frozen(q + wished)
    assert missing(at(state, q), T, with_orientation) < max(1e-3, 0.02 * way)


def missing(state: State, T: Array, with_orientation: bool) -> float:
    """What is left to a pose, in parts of the reach and radians."""
    return float(np.linalg.norm(asked(state, T, with_orientation, gain=1.0).rate))


def clear_of_singularities(robot: Robot, rng: np.random.Generator, with_orientation: bool) -> tuple[Array, Array]:
    """A start and a goal not far from each other, in the middle of the limits and away from singular postures."""
    state, middle, half = state_of(robot.name), (robot.lower + robot.upper) / 2, (robot.upper - robot.lower) / 2
    while True:
        goal = middle + rng.uniform(-0.6, 0.6, len(half)) * half
        start = goal + rng.uniform(-0.1, 0.1, len(half)) * np.minimum(half, 2.0)
        worth = [least(at(state, frozen(q)), with_orientation) for q in np.linspace(start, goal, 5)]
        if min(worth) > 0.05:
            return frozen(start), frozen(goal)


def least(state: State, with_orientation: bool) -> float:
    """The least singular value that belongs to what the arm can usually do."""
    here = analysed(asked(state, state.T_world_tool, with_orientation).J)
    return float(here.sigma[usual(state.robot.name, with_orientation) - 1])


@cache
def usual(robot_name: str, with_orientation: bool) -> int:
    state, rng = state_of(robot_name), np.random.default_rng(3)
    q = frozen(rng.uniform(state.robot.lower, state.robot.upper))
    return analysed(asked(at(state, q), state.T_world_tool, with_orientation).J).rank


@every_robot
@every_method
@both_tasks
def test_the_asked_velocity_is_met_exactly(name: str, robot_name: str, with_orientation: bool) -> None:
    """EXACT: J q̇ = ν for every ν that the arm can do at all, away from singular postures."""
    state = state_of(robot_name)
    if not (promises(name, Promise.EXACT) and applicable(name, state, with_orientation)):
        return
    rng = np.random.default_rng(4)
    for _ in range(10):
        q, _ = clear_of_singularities(state.robot, rng, with_orientation)
        task = asked(at(state, q), state.T_world_tool, with_orientation)
        task = replace(task, rate=task.J @ rng.normal(size=len(q)))
        _, drive = step(state.problem, task, state.arm.poses, Drive().by(name))
        assert drive.solution is not None
        np.testing.assert_allclose(task.J @ drive.solution.rates, task.rate, rtol=0, atol=1e-9)


def singular_starts(state: State, with_orientation: bool) -> list[Array]:
    """Named postures and those with every joint at zero or a right angle in which the rank is lower than usual."""
    n, robot = len(state.arm.q), state.robot
    rng = np.random.default_rng(5)
    grid = [np.zeros(n), *(rng.integers(-2, 3, n) * np.pi / 2 for _ in range(200)), *robot.poses.values()]
    expected = usual(robot.name, with_orientation)
    lost = [q for q in grid if analysed(asked(at(state, q), state.T_world_tool, with_orientation).J).rank < expected]
    return [frozen(q) for q in lost[:4]]


@every_robot
@every_method
@both_tasks
def test_rates_stay_bounded_from_singular_starts(name: str, robot_name: str, with_orientation: bool) -> None:
    """BOUNDED: ‖q̇‖ ≤ 100 ‖ν‖ in every step of a motion that begins in a singular posture."""
    state = state_of(robot_name)
    if not (promises(name, Promise.BOUNDED) and applicable(name, state, with_orientation)):
        return
    rng = np.random.default_rng(6)
    for start in singular_starts(state, with_orientation):
        q, drive = start, Drive().by(name)
        T = tool_at(state.robot, start + 0.3 * rng.normal(size=len(start)))
        for _ in range(40):
            task = asked(at(state, q), T, with_orientation)
            wished, drive = step(state.problem, task, state.arm.poses, drive)
            assert drive.solution is not None
            assert np.linalg.norm(drive.solution.rates) <= 100 * np.linalg.norm(task.rate) + 1e-12
            q = frozen(q + wished)


@pytest.mark.parametrize("robot_name", ["planar2r", "planar3r", "movemaster", "puma560", "zebra_zero"])
@every_method
def test_a_singular_start_is_left_or_not_as_promised(name: str, robot_name: str) -> None:
    """The stretched arm asked to move along itself, with a step's worth of a second: along the lost direction only."""
    state = state_of(robot_name)
    start = stretched(state)
    task = asked(at(state, start), state.T_world_tool, False)
    lost = analysed(task.J).lost[:, -1]
    if named(name).applies(task) is not None:
        return
    drive, q = Drive().by(name), start
    for _ in range(200):
        task = asked(at(state, q), state.T_world_tool, False)
        wished, drive = step(state.problem, replace(task, rate=-0.1 * lost), state.arm.poses, drive)
        q = frozen(q + wished)
    moved = np.abs(q - start).max()
    if promises(name, Promise.LEAVES_SINGULAR):
        assert moved > 1e-3
    if promises(name, Promise.STAYS_SINGULAR):
        assert moved < 1e-6


def stretched(state: State) -> Array:
    """The first singular start of the position task."""
    return singular_starts(state, with_orientation=False)[0]


@pytest.mark.parametrize("robot_name", ["movemaster", "planar3r", "scara", "puma560", "dia10"])
def test_under_the_guard_no_method_breaks_a_promise_and_switching_never_jumps(robot_name: str) -> None:
    """Wishes near and far, another method or setting every few ticks, another arm beside it: q moves by q̇ dt only."""
    rng, state, worst = np.random.default_rng(8), initial(library.load(robot_name)), Worst()
    for _ in range(60):
        state = gate.choose_method(str(rng.choice(names())))(state)
        state = gate.compare_with(rng.choice([None, *names()]))(state)
        state = gate.hold_orientation(bool(rng.random() < 0.5))(state)
        far = state.robot.reach * rng.choice([0.3, 1.0, 3.0]) * rng.normal(size=3)
        state = replace(state, request=replace(state.request, command=ToPose(tool_moved(state, far, rng))))
        dt = float(rng.choice(DTS))
        for _ in range(int(rng.integers(1, 15))):
            new = advance(state, dt)
            watch(worst, state, new, dt)
            if new.of_compared is not None and state.of_compared is not None:
                watch(worst, state.of_compared, new.of_compared, dt)
            state = new


def tool_moved(state: State, way: Array, rng: np.random.Generator) -> Array:
    T = state.T_world_tool.copy()
    T[:3, :3] = T[:3, :3] @ rotation.to_matrix(rotation.from_rotation_vector(rng.normal(size=3)))
    T[:3, 3] = T[:3, 3] + way
    return frozen(T)


def test_an_unknown_method_is_refused_in_words(state: State) -> None:
    refused = gate.choose_method("magic")(state)
    assert refused.request.drive is state.request.drive
    assert refused.notice is not None
    assert all(name in refused.notice.en for name in names())


@every_method
def test_what_is_remembered_fits_any_task(name: str) -> None:
    """Orientation on and off in the middle of a motion changes the shape of the task."""
    state, drive = state_of("puma560"), Drive().by(name)
    for k in range(20):
        T = tool_moved(state, np.full(3, 0.1), np.random.default_rng(k))
        if not applicable(name, state, k % 3 > 0):
            continue
        _, drive = answered(state, T, k % 3 > 0, drive)
        assert drive.solution is not None
        assert np.isfinite(drive.solution.rates).all()
