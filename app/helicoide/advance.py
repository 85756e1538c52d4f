"""One tick of the arm, from a State and a time step to the next State, and where it leads. Pure."""

from __future__ import annotations

from dataclasses import replace
from math import dist

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.command import Command, FollowPath, GetReady, HoldPosition, MoveToJoints, MoveToPose, Park, Replay
from helicoide.ik import controller as drives
from helicoide.ik.controller import GUARDED
from helicoide.ik.guard.collision import clearances
from helicoide.ik.guard.guarded import ONE_LEVEL
from helicoide.ik.guard.work import Work, work_for
from helicoide.ik.packing import packed
from helicoide.ik.rcm.tip_task import rcm_step
from helicoide.ik.step import step, step_task, task_at
from helicoide.ik.task import EVERY, GAIN, joint_task
from helicoide.kinematics.forward import link_poses
from helicoide.state import ActiveSet, ComparedArm, State
from helicoide.trajectory.path import wrapped_parameter
from helicoide.trajectory.waypoints import GRIPPER_TIME

ARRIVED_JOINTS = 1e-3
ARRIVED_PATH = 0.010
RESTS = 0.1
# What comes no nearer to the path, as a share of the reach, in so many seconds has come as near as it can.
NEARER, PATIENCE = 1e-3, 2.0
IMPERCEPTIBLE = 1e-10
# How near to its path an arm is that follows it, rad or m, and the shares of the time that are tried for that.
ON_PATH = 2e-4
SLOWER = (1.0, 0.5, 0.25, 0.12, 0.06, 0.03)

_STILL = frozen(np.zeros(3))
Task = tuple[Array, Array, Array, Array]


def advance(state: State, dt: float) -> State:
    """The state dt seconds later; joints, planes and speeds stay within what `guarded.guarded_tick` promises."""
    moved = _advanced(_with_time(state, dt), dt)
    if moved.ball is not None and moved.ball.grasp_offset is not None:
        moved = replace(moved, ball=moved.ball.moved_with_tool(moved.T_world_tool))
    return moved if state.compared is None else replace(moved, compared=_compared(state, moved, dt))


def _advanced(state: State, dt: float) -> State:
    if state.arm.parked:
        return _parked(state, dt)
    match state.request.command:
        case HoldPosition():
            return _still(state)
        case MoveToJoints(q, yielding):
            return _stepped(state, joint_task(state.arm.q, q, yielding, dt), dt)
        case Park() | GetReady():
            return _to_ready(state, dt)
        case MoveToPose(T):
            return _to_pose(state, T, _STILL, dt)
        case FollowPath() as command:
            return _along(state, command, dt)
        case Replay() as command:
            return _replayed(state, command, dt)


def _under(state: State, command: Command) -> State:
    """The same request, a step further."""
    return replace(state, request=replace(state.request, command=command))


def _with_time(state: State, dt: float) -> State:
    """Time goes on; the gripper closes or opens at its own speed, unless the arm was stopped or a ball stops it."""
    arm, request, ball = state.arm, state.request, state.ball
    if not (isinstance(request.command, HoldPosition) and request.command.stopped) and request.gripper != arm.gripper:
        most = dt / GRIPPER_TIME
        opening = arm.gripper + min(max(request.gripper - arm.gripper, -most), most)
        if ball is not None and state.robot.gripper is not None:
            ball, opening = ball.with_gripper(state.robot.gripper, arm.gripper, opening, state.T_world_tool)
        arm = replace(arm, gripper=opening)
    request = replace(request, unchanged=request.unchanged + dt)
    return replace(state, arm=arm, request=request, ball=ball, t=state.t + dt)


def _compared(state: State, moved: State, dt: float) -> ComparedArm:
    """The second arm: after the same target by its own method, else back to where the first arm is."""
    second = state.compared_state
    assert second is not None
    second = replace(second, arm=replace(second.arm, gripper=moved.arm.gripper))
    if state.arm.parked or moved.arm.parked:
        return ComparedArm(moved.arm, second.request.controller)
    match moved.request.command:
        case MoveToPose(T):
            second = _to_pose(second, T, _STILL, dt)
        case FollowPath(path, s, playing, arrived):
            ahead = frozen(path.twist(s)[:3]) if playing and arrived else _STILL
            second = _to_pose(second, frozen(path.pose(s)), ahead, dt)
        case HoldPosition():
            second = _still(second)
        case _:
            second = _stepped(second, joint_task(second.arm.q, moved.arm.q, EVERY, dt), dt)
    return ComparedArm(second.arm, second.request.controller)


def _still(state: State) -> State:
    speeds = state.arm.velocities
    return replace(state, arm=replace(state.arm, velocities=frozen(np.zeros(len(speeds))))) if speeds.any() else state


def _stepped(state: State, task: Task, dt: float) -> State:
    """The guarded tick towards a task in the joints."""
    q, arm = state.arm.q.copy(), drives.packed_arm(state.problem, state.request.controller)
    work = _from_here(state, arm)
    step_task(arm, q, *task, ONE_LEVEL, dt, work.memory)
    return _after(state, q, work)


def _from_here(state: State, arm: Array) -> Work:
    """A work space for the tick."""
    work = work_for(arm)
    work.rates[:] = state.arm.velocities
    return work


def _after(state: State, q: Array, work: Work) -> State:
    """The state after a tick."""
    arm, held = state.arm, ActiveSet(work.held, work.pull)
    if np.abs(q - arm.q).max() < IMPERCEPTIBLE:
        return _still(replace(state, arm=replace(arm, active_set=held)))
    for array in (q, work.poses, work.rates):
        array.flags.writeable = False
    return replace(state, arm=replace(arm, q=q, poses=work.poses, velocities=work.rates, active_set=held))


def _to_pose(state: State, T_world_target: Array, ahead: Array, dt: float) -> State:
    """Towards a tool pose; a detour through another posture comes first."""
    arm, request = state.arm, state.request
    if request.detour is not None:
        blocked = request.unchanged > RESTS and not arm.moving
        if not blocked and np.max(np.abs(request.detour - arm.q)) > ARRIVED_JOINTS:
            return _stepped(state, joint_task(arm.q, request.detour, EVERY, dt), dt)
        state = replace(state, request=replace(request, detour=None))
    if request.controller.method != GUARDED:
        return _by_method(state, T_world_target, ahead, dt)
    drive, problem, q = request.controller, state.problem, arm.q.copy()
    packed_arm = drives.packed_arm(problem, drive, request.with_orientation)
    work = _from_here(state, packed_arm)
    if drive.secondary is None:
        step(packed_arm, q, T_world_target, ahead, dt, work.memory)
    else:
        task, split = (
            task_at(packed_arm, q, T_world_target, ahead, dt),
            drives.level_starts(drive, request.with_orientation),
        )
        task, begins = drives.with_objective(problem, arm.q, arm.poses, task, split, drive.secondary, dt)
        step_task(packed_arm, q, *task, begins, dt, work.memory)
    return _after(state, q, work)


def _by_method(state: State, T_world_target: Array, ahead: Array, dt: float) -> State:
    """By a method that knows of no limits: the guard lets through what it may of the rates that it wishes."""
    problem, request, posture = state.problem, state.request, (state.arm.q, state.arm.poses)
    drive, with_orientation = request.controller, request.with_orientation
    if problem.entry is not None:
        wished, drive = rcm_step(problem, *posture, T_world_target, with_orientation, ahead, drive, dt)
    else:
        task = drives.closed_loop_task(problem, *posture, T_world_target, with_orientation, ahead, drive.gains, dt)
        wished, drive = drives.step(problem, task, state.arm.poses, drive)
    return _stepped(replace(state, request=replace(request, controller=drive)), drives.displacement_task(wished), dt)


def _along(state: State, command: FollowPath, dt: float) -> State:
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
    s = wrapped_parameter(command.path, command.s + dt) if command.arrived else command.s
    playing = command.path.is_closed or s < command.path.duration
    return replace(state, request=replace(state.request, command=replace(command, s=s, playing=playing), path_s=s))


def _approached(state: State, command: FollowPath, target: Array, dt: float) -> FollowPath:
    """Whether the arm has come to the path, or can come no nearer: there a method of the sources may tremble."""
    if command.arrived:
        return command
    away = dist(state.T_world_tool[:3, 3], target[:3, 3])
    if away < command.nearest - NEARER * state.robot.reach:
        command = replace(command, nearest=away, waiting_since=0.0)
    waited = command.waiting_since + dt
    guarded, searched = state.request.controller.method == GUARDED, state.request.searched
    in_vain = searched and not state.arm.moving if guarded else waited > PATIENCE
    return replace(command, waiting_since=waited, arrived=away < ARRIVED_PATH or in_vain)


def _replayed(state: State, command: Replay, dt: float) -> State:
    """Along a path of the joints, after the way to where it begins.

    Where the guard holds the arm back, the time slows down until the arm is on the path all the same, if it `waits`;
    where that is in vain, or else, the arm goes on beside the path, as near as it may.
    """
    path, q = command.path, state.arm.q
    here = path.q(command.s)
    if not command.arrived:
        state = _stepped(state, joint_task(q, here, EVERY, dt), dt)
        near = np.max(np.abs(here - state.arm.q)) < ARRIVED_JOINTS
        arrived = bool(near) or (state.request.unchanged > RESTS and not state.arm.moving)
        return _under(state, replace(command, arrived=arrived))
    for share in (*SLOWER, 1.0) if command.slows_down else (1.0,):
        s = min(command.s + share * dt, path.duration)
        there = path.q(s)
        stepped = _stepped(state, drives.displacement_task(there - here + (1 - np.exp(-GAIN * dt)) * (here - q)), dt)
        if np.max(np.abs(stepped.arm.q - there)) < ON_PATH:
            break
    for at, opening in command.gripper_events:
        if command.s <= at < s:
            stepped = replace(stepped, request=replace(stepped.request, gripper=opening))
    ended = command.s >= path.duration
    return _under(stepped, MoveToJoints(frozen(path.q(s))) if ended else replace(command, s=s))


def _to_ready(state: State, dt: float) -> State:
    """Guarded to `ready`; there a Park command turns the planes off, and a GetReady command ends."""
    ready, arm = state.robot.poses["ready"], state.arm
    if np.max(np.abs(ready - arm.q)) < ARRIVED_JOINTS:
        if isinstance(state.request.command, GetReady):
            return _still(_under(state, HoldPosition()))
        if _is_clear(state, ready):
            return _parked(replace(state, arm=replace(arm, parked=True)), dt)
    return _stepped(state, joint_task(arm.q, ready, EVERY, dt), dt)


def _is_clear(state: State, q: Array) -> bool:
    """Whether everything keeps its distance at q: the way back from home ends there exactly."""
    return bool((clearances(packed(state.problem), q) > -1e-9).all())


def _parked(state: State, dt: float) -> State:
    """With the planes off, on the straight joint path between `home` and `ready`."""
    arm, command = state.arm, state.request.command
    if not isinstance(command, Park | GetReady):
        return _still(state)
    going_home = isinstance(command, Park)
    end = state.robot.poses["home" if going_home else "ready"]
    left = end - arm.q
    needed = float(np.max(np.abs(left) / (state.problem.limits.speed * dt)))
    arrives = needed <= 1.0
    q = frozen(end if arrives else arm.q + left / needed)
    poses = frozen(link_poses(state.robot.chain, q))
    arm = replace(arm, q=q, poses=poses, velocities=frozen((q - arm.q) / dt), parked=going_home or not arrives)
    return replace(_under(state, HoldPosition()) if arrives else state, arm=arm)
