"""One tick of the arm: from a State and a time step to the next State. Pure."""

from __future__ import annotations

from dataclasses import replace
from math import dist

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.command import Command, FollowPath, GetReady, HoldPosition, MoveToJoints, MoveToPose, Park, Replay
from helicoide.comparison import Effort
from helicoide.ik import controller as drives
from helicoide.ik.controller import GUARDED, ToolTarget
from helicoide.ik.guard.collision import clearances
from helicoide.ik.guard.guarded import ONE_LEVEL
from helicoide.ik.guard.work import Work, work_for
from helicoide.ik.objective import Posture
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
# An arm that comes no nearer to its path by NEARER times the reach within PATIENCE, s, is as near as it can come.
NEARER, PATIENCE = 1e-3, 2.0
IMPERCEPTIBLE = 1e-10
# In a replay: the largest distance of a joint from the path, rad or m, and the fractions of dt tried to keep to it.
ON_PATH = 2e-4
SLOWER = (1.0, 0.5, 0.25, 0.12, 0.06, 0.03)

_STILL = frozen(np.zeros(3))
Task = tuple[Array, Array, Array, Array]


def advance(state: State, dt: float) -> State:
    """The state dt seconds later, under the limits that `guarded.guarded_tick` keeps."""
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
    """The state with another command in the same request."""
    return replace(state, request=replace(state.request, command=command))


def _with_time(state: State, dt: float) -> State:
    """The state with time and gripper advanced. The gripper takes `GRIPPER_TIME` to open or close.

    It does not move after a stop, and a ball between the fingers limits it.
    """
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
    """The second arm after a tick. It follows the target by its own method, or the first arm if there is no target."""
    second = state.compared_state
    assert state.compared is not None
    assert second is not None
    second = replace(second, arm=replace(second.arm, gripper=moved.arm.gripper))
    if state.arm.parked or moved.arm.parked:
        return replace(state.compared, arm=moved.arm)
    command = moved.request.command
    match command:
        case MoveToPose(T):
            second = _to_pose(second, T, _STILL, dt)
        case FollowPath(path, s):
            T, before = frozen(path.pose(s)), state.request.command
            assert isinstance(before, FollowPath)
            second = _to_pose(second, frozen(path.pose(before.s)), _ahead(before), dt)
        case HoldPosition():
            second = _still(second)
        case _:
            second = _stepped(second, joint_task(second.arm.q, moved.arm.q, EVERY, dt), dt)
    trace = state.compared.trace
    if isinstance(command, MoveToPose | FollowPath) and (moved.arm.moving or second.arm.moving):
        trace = trace.with_tick(_effort(moved, T), _effort(second, T), dt)
    return ComparedArm(second.arm, second.request.controller, trace)


def _effort(state: State, T_world_target: Array) -> Effort:
    """Asked and actual joint speed and the position error. Without a solution the asked speed is the actual one."""
    solution, speed = state.request.controller.solution, float(np.linalg.norm(state.arm.velocities))
    asked = speed if solution is None else float(np.linalg.norm(state.problem.joint_units * solution.rates))
    return Effort(asked, speed, dist(state.T_world_tool[:3, 3], T_world_target[:3, 3]))


def _still(state: State) -> State:
    speeds = state.arm.velocities
    return replace(state, arm=replace(state.arm, velocities=frozen(np.zeros(len(speeds))))) if speeds.any() else state


def _stepped(state: State, task: Task, dt: float) -> State:
    """The state after a guarded step for a task: J, v, weights and damping."""
    q, arm = state.arm.q.copy(), drives.packed_arm(state.problem, state.request.controller)
    work = _from_here(state, arm)
    step_task(arm, q, *task, ONE_LEVEL, dt, work.memory)
    return _after(state, q, work)


def _from_here(state: State, arm: Array) -> Work:
    """The buffers of a guarded step, with the present joint velocities."""
    work = work_for(arm)
    work.rates[:] = state.arm.velocities
    return work


def _after(state: State, q: Array, work: Work) -> State:
    """The state with the results of a guarded step; the arm is at rest if no joint moved by `IMPERCEPTIBLE`."""
    arm, held = state.arm, ActiveSet(work.multipliers, work.pull)
    if np.abs(q - arm.q).max() < IMPERCEPTIBLE:
        return _still(replace(state, arm=replace(arm, active_set=held)))
    for array in (q, work.poses, work.rates):
        array.flags.writeable = False
    return replace(state, arm=replace(arm, q=q, poses=work.poses, velocities=work.rates, active_set=held))


def _to_pose(state: State, T_world_target: Array, ahead: Array, dt: float) -> State:
    """One tick towards a tool pose, after the detour through another posture if there is one."""
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
        task = task_at(packed_arm, q, T_world_target, ahead, dt)
        split = drives.level_starts(drive, request.with_orientation)
        here = Posture(arm.q, arm.poses, problem.obstacles.points)
        task, begins = drives.with_objective(problem, here, task, split, drive.secondary, dt)
        step_task(packed_arm, q, *task, begins, dt, work.memory)
    return _after(state, q, work)


def _by_method(state: State, T_world_target: Array, ahead: Array, dt: float) -> State:
    """One tick by a method without limits; the guarded step limits the joint displacement that it asks for."""
    problem, request, posture = state.problem, state.request, Posture(state.arm.q, state.arm.poses)
    drive, target = request.controller, ToolTarget(T_world_target, request.with_orientation, ahead)
    if problem.entry is not None:
        displacement, drive = rcm_step(problem, posture, target, drive, dt)
    else:
        task = drives.closed_loop_task(problem, posture, target, drive.gains, dt)
        displacement, drive = drives.step(problem, task, state.arm.poses, drive)
    return _stepped(
        replace(state, request=replace(request, controller=drive)), drives.displacement_task(displacement), dt
    )


def _along(state: State, command: FollowPath, dt: float) -> State:
    """One tick along a path. The parameter advances once the arm is at the path or cannot come nearer.

    An open path stops at its end.
    """
    target = frozen(command.path.pose(command.s))
    state = _to_pose(state, target, _ahead(command), dt)
    if not command.playing:
        return state
    command = _approached(state, command, target, dt)
    s = wrapped_parameter(command.path, command.s + dt) if command.arrived else command.s
    playing = command.path.is_closed or s < command.path.duration
    return replace(state, request=replace(state.request, command=replace(command, s=s, playing=playing), path_s=s))


def _ahead(command: FollowPath) -> Array:
    """The velocity of the point that is followed, (3,), m/s; zero while it waits."""
    running = command.playing and command.arrived
    return frozen(command.path.twist(command.s)[:3]) if running else _STILL


def _approached(state: State, command: FollowPath, target: Array, dt: float) -> FollowPath:
    """The command with `arrived` set once the arm is at the path or cannot come nearer.

    Methods other than the guarded step may oscillate there, so the distance decides for them instead of the motion.
    """
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
    """One tick along a joint path, after a motion to its start.

    If the command `slows_down`, the time step is reduced until the arm can stay on the path. If no fraction of
    `SLOWER` is small enough, or without `slows_down`, time runs at its full rate and the arm follows as near as the
    limits allow.
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
    """One guarded tick towards `ready`. There a Park command switches the planes off, and a GetReady command ends."""
    ready, arm = state.robot.poses["ready"], state.arm
    if np.max(np.abs(ready - arm.q)) < ARRIVED_JOINTS:
        if isinstance(state.request.command, GetReady):
            return _still(_under(state, HoldPosition()))
        if _is_clear(state, ready):
            return _parked(replace(state, arm=replace(arm, parked=True)), dt)
    return _stepped(state, joint_task(arm.q, ready, EVERY, dt), dt)


def _is_clear(state: State, q: Array) -> bool:
    """Whether all clearances hold at q, where the motion back from `home` ends."""
    return bool((clearances(packed(state.problem), q) > -1e-9).all())


def _parked(state: State, dt: float) -> State:
    """One tick with the planes off, on the straight line in joint space between `home` and `ready`."""
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
