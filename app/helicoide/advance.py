"""One tick of the arm, from a State and a time step to the next State, and where it leads. Pure."""

from __future__ import annotations

from dataclasses import replace
from math import dist, hypot

import numpy as np

from helicoide.ik import drive as drives
from helicoide.ik.drive import GUARDED
from helicoide.ik.goal import allowed_point
from helicoide.ik.guard.collision import clearances
from helicoide.ik.guard.guarded import ONE_LEVEL, guarded_tick
from helicoide.ik.guard.rows import Indices
from helicoide.ik.rcm.at_work import by_method
from helicoide.ik.task import EVERY, GAIN, joint_task, pose_task
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.state import Along, Beside, GetReady, Held, Hold, Park, Replay, State, ToJoints, ToPose
from helicoide.trajectory.path import placed

ARRIVED_JOINTS = 1e-3
ARRIVED_PATH = 0.010
RESTS = 0.1
# What comes no nearer to the path, as a share of the reach, in so many seconds has come as near as it can.
NEARER, PATIENCE = 1e-3, 2.0
GRIPPER_SPEED = 2.0
IMPERCEPTIBLE = 1e-10
# How near to its path an arm is that follows it, rad or m, and the shares of the time that are tried for that.
ON_PATH = 2e-4
SLOWER = (1.0, 0.5, 0.25, 0.12, 0.06, 0.03)

_STILL = frozen(np.zeros(3))
Task = tuple[Array, Array, Array, Array]


def advance(state: State, dt: float) -> State:
    """The state dt seconds later; joints, planes and speeds stay within what `guarded_tick` promises."""
    moved = _advanced(_gripper_moved(state, dt), dt)
    return moved if state.beside is None else replace(moved, beside=_beside(state, moved, dt))


def _advanced(state: State, dt: float) -> State:
    if state.parked:
        return _parked(state, dt)
    match state.command:
        case Hold():
            return _still(state)
        case ToJoints(q, yielding):
            return _stepped(state, joint_task(state.q, q, yielding, dt), dt)
        case Park() | GetReady():
            return _to_ready(state, dt)
        case ToPose(T):
            return _to_pose(state, T, _STILL, dt)
        case Along():
            return _along(state, state.command, dt)
        case Replay():
            return _replayed(state, state.command, dt)


def _gripper_moved(state: State, dt: float) -> State:
    """Time goes on; the gripper closes or opens at its own speed unless the arm was stopped."""
    step = 0.0
    if not (isinstance(state.command, Hold) and state.command.stopped):
        step = min(max(state.gripper_target - state.gripper, -GRIPPER_SPEED * dt), GRIPPER_SPEED * dt)
    return replace(state, t=state.t + dt, rested=state.rested + dt, gripper=state.gripper + step)


def _beside(state: State, moved: State, dt: float) -> Beside:
    """The arm beside: after the same target by its own method, else back to where the first arm is."""
    other = state.of_beside
    assert other is not None
    if state.parked or moved.parked:
        return Beside(moved.q, moved.speeds, moved.poses, other.drive)
    match moved.command:
        case ToPose(T):
            other = _to_pose(other, T, _STILL, dt)
        case Along(path, s, playing, arrived):
            ahead = frozen(path.twist(s)[:3]) if playing and arrived else _STILL
            other = _to_pose(other, frozen(path.pose(s)), ahead, dt)
        case Hold():
            other = _still(other)
        case _:
            other = _stepped(other, joint_task(other.q, moved.q, EVERY, dt), dt)
    return Beside(other.q, other.speeds, other.poses, other.drive, other.held)


def _still(state: State) -> State:
    return state if not state.speeds.any() else replace(state, speeds=frozen(np.zeros(len(state.q))))


def _stepped(state: State, task: Task, dt: float, begins: Indices = ONE_LEVEL) -> State:
    """The guarded tick towards a task."""
    guard = drives.guard(state.problem, state.drive)
    q, poses, multipliers, _ = guarded_tick(guard, state.q, state.speeds, state.poses, task, begins, dt)
    state = replace(state, held=Held(multipliers, hypot(*(task[2] * task[1]))))
    if np.max(np.abs(q - state.q)) < IMPERCEPTIBLE:
        return _still(state)
    speeds = (q - state.q) / dt
    for array in (q, poses, speeds):
        array.flags.writeable = False
    return replace(state, q=q, poses=poses, speeds=speeds)


def _to_pose(state: State, T_world_target: Array, ahead: Array, dt: float) -> State:
    """Towards a tool pose; a detour through another posture comes first."""
    if state.detour is not None:
        blocked = state.rested > RESTS and not state.moving
        if not blocked and np.max(np.abs(state.detour - state.q)) > ARRIVED_JOINTS:
            return _stepped(state, joint_task(state.q, state.detour, EVERY, dt), dt)
        state = replace(state, detour=None)
    if state.drive.method != GUARDED:
        return _by_method(state, T_world_target, ahead, dt)
    robot, allowed = state.robot, allowed_point(state.problem, T_world_target[:3, 3])
    tool = (robot.T_link_tool, T_world_target, allowed, state.with_orientation, robot.reach)
    task = pose_task(state.poses, robot.chain, tool, ahead, dt)
    task, begins = drives.levels(state.problem, state.q, state.poses, task, state.drive, dt)
    return _stepped(state, task, dt, begins)


def _by_method(state: State, T_world_target: Array, ahead: Array, dt: float) -> State:
    """By a method that knows of no limits: the guard lets through what it may of the rates that it wishes."""
    problem, drive, posture = state.problem, state.drive, (state.q, state.poses)
    if problem.entry is not None:
        wished, drive = by_method(problem, *posture, T_world_target, state.with_orientation, ahead, drive, dt)
    else:
        asked = drives.task_of(problem, *posture, T_world_target, state.with_orientation, ahead, drive.gains, dt)
        wished, drive = drives.step(problem, asked, state.poses, drive)
    return _stepped(replace(state, drive=drive), drives.displacement(wished), dt)


def _along(state: State, command: Along, dt: float) -> State:
    """Along a path: the parameter runs once the arm has come to the path, or can come no nearer.

    At the end of a path that is open it rests.
    """
    target = frozen(command.path.pose(command.s))
    running = command.playing and command.arrived
    ahead = frozen(command.path.twist(command.s)[:3]) if running else _STILL
    state = _to_pose(state, target, ahead, dt)
    if not command.playing:
        return state
    command = _approached(state, command, target, dt)
    s = placed(command.path, command.s + dt) if command.arrived else command.s
    playing = command.path.is_closed or s < command.path.duration
    return replace(state, command=replace(command, s=s, playing=playing), path_s=s)


def _approached(state: State, command: Along, target: Array, dt: float) -> Along:
    """Whether the arm has come to the path, or can come no nearer: there a method of the sources may tremble."""
    if command.arrived:
        return command
    away = dist(state.T_world_tool[:3, 3], target[:3, 3])
    if away < command.nearest - NEARER * state.robot.reach:
        command = replace(command, nearest=away, waited=0.0)
    waited = command.waited + dt
    in_vain = state.searched and not state.moving if state.drive.method == GUARDED else waited > PATIENCE
    return replace(command, waited=waited, arrived=away < ARRIVED_PATH or in_vain)


def _replayed(state: State, command: Replay, dt: float) -> State:
    """Along a path of the joints, after the way to where it begins.

    Where the guard holds the arm back, the time slows down until the arm is on the path all the same, if it `waits`;
    where that is in vain, or else, the arm goes on beside the path, as near as it may.
    """
    path = command.path
    here = path.q(command.s)
    if not command.arrived:
        state = _stepped(state, joint_task(state.q, here, EVERY, dt), dt)
        near = np.max(np.abs(here - state.q)) < ARRIVED_JOINTS
        arrived = bool(near) or (state.rested > RESTS and not state.moving)
        return replace(state, command=replace(command, arrived=arrived))
    for share in (*SLOWER, 1.0) if command.waits else (1.0,):
        s = min(command.s + share * dt, path.duration)
        there = path.q(s)
        stepped = _stepped(state, drives.displacement(there - here + (1 - np.exp(-GAIN * dt)) * (here - state.q)), dt)
        if np.max(np.abs(stepped.q - there)) < ON_PATH:
            break
    ended = command.s >= path.duration
    return replace(stepped, command=ToJoints(frozen(path.q(s))) if ended else replace(command, s=s))


def _to_ready(state: State, dt: float) -> State:
    """Guarded to `ready`; there a Park command turns the planes off, and a GetReady command ends."""
    ready = state.robot.poses["ready"]
    if np.max(np.abs(ready - state.q)) < ARRIVED_JOINTS:
        if isinstance(state.command, GetReady):
            return _still(replace(state, command=Hold()))
        if _is_clear(state, ready):
            return _parked(replace(state, parked=True), dt)
    return _stepped(state, joint_task(state.q, ready, EVERY, dt), dt)


def _is_clear(state: State, q: Array) -> bool:
    """Whether everything keeps its distance at q: the way back from home ends there exactly."""
    points, _, planes, pairs, _, _ = state.problem.guard
    left, _, _ = clearances(link_poses(state.robot.chain, q), points, planes, pairs)
    return bool((left > -1e-9).all())


def _parked(state: State, dt: float) -> State:
    """With the planes off, on the straight joint path between `home` and `ready`."""
    if not isinstance(state.command, Park | GetReady):
        return _still(state)
    going_home = isinstance(state.command, Park)
    end = state.robot.poses["home" if going_home else "ready"]
    left = end - state.q
    needed = float(np.max(np.abs(left) / (state.problem.limits.speed * dt)))
    if needed <= 1.0:
        state = replace(state, command=Hold(), parked=going_home)
    q = frozen(end if needed <= 1.0 else state.q + left / needed)
    poses = frozen(link_poses(state.robot.chain, q))
    return replace(state, q=q, poses=poses, speeds=frozen((q - state.q) / dt))
