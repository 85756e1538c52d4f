"""Prediction of where a command leads: its goal, a better posture, and whether the arm stays at rest."""

from __future__ import annotations

from dataclasses import replace

from helicoide.advance import advance
from helicoide.arrays import frozen
from helicoide.command import FollowPath, GetReady, MoveToJoints, MoveToPose, Park
from helicoide.ik.controller import GUARDED
from helicoide.ik.goal import Goal, best_goal, goal_at_joints, goal_at_pose
from helicoide.state import ArmState, State, Update

# Time with an unchanged request after which another posture is searched for, s.
SETTLED = 0.5
# Time with an unchanged request after which an arm counts as at rest, s. Status texts about waiting appear earlier.
RESTED = 2.0


def foreseen(state: State) -> State:
    """The state with the goal of its command. It is computed at the rate of the scene, not in every tick."""
    return replace(state, request=replace(state.request, goal=_goal(state)))


def _goal(state: State) -> Goal | None:
    """The goal of the command; None without one, and for poses and paths under other methods than the guarded step."""
    problem, request, q = state.problem, state.request, state.arm.q
    with_orientation, guarded = request.with_orientation, request.controller.method == GUARDED
    before = q if request.detour is None else request.detour
    match request.command:
        case MoveToPose(T) if guarded:
            return goal_at_pose(problem, before, T, with_orientation)
        case FollowPath(path, s) if guarded:
            return goal_at_pose(problem, before, frozen(path.pose(s)), with_orientation)
        case MoveToJoints(asked, yielding):
            return goal_at_joints(problem, q, asked, yielding)
        case Park() | GetReady() if not state.arm.parked:
            return goal_at_joints(problem, q, state.robot.poses["ready"])
        case _:
            return None


def wants_search(state: State) -> bool:
    """Whether a search for another posture that comes nearer to the target is due.

    It is due once for each request of a pose or path under the guarded step: when the drag of the target has ended, or
    when the request has been unchanged for `SETTLED`. The arm may still move, because the search predicts its goal.
    """
    request, command = state.request, state.request.command
    if request.searched or state.arm.parked or request.controller.method != GUARDED:
        return False
    if isinstance(command, MoveToPose):
        return command.snaps or request.unchanged >= SETTLED
    return (
        isinstance(command, FollowPath) and not (command.playing and command.arrived) and request.unchanged >= SETTLED
    )


def search_posture(state: State) -> Update:
    """Search for a better posture. The update sets it as the detour, or moves a target that snaps to the goal.

    A search takes as long as some hundred ticks, so it runs outside them. The update does nothing if the request has
    changed meanwhile.
    """
    command = state.request.command
    assert isinstance(command, MoveToPose | FollowPath)
    T = command.T_world_target if isinstance(command, MoveToPose) else frozen(command.path.pose(command.s))
    goal, detour = best_goal(state.problem, state.arm.q, T, state.request.with_orientation)

    def found(now: State) -> State:
        if now.request.searched or not _asks_the_same(now, state):
            return now
        command = now.request.command
        if isinstance(command, MoveToPose) and command.snaps:
            command = MoveToPose(goal.T_world_tool if detour is None else T)
        return replace(now, request=replace(now.request, command=command, searched=True, unchanged=0.0, detour=detour))

    return found


def _asks_the_same(new: State, old: State) -> bool:
    """Whether command, problem and method are the same in both states and the arm is not parked."""
    now, then = new.request, old.request
    if isinstance(now.command, FollowPath) and isinstance(then.command, FollowPath):
        asked = now.command.path is then.command.path and now.command.s == then.command.s
    else:
        asked = now.command is then.command
    same = new.problem is old.problem and now.with_orientation == then.with_orientation
    return asked and same and now.controller.method == then.controller.method and not new.arm.parked


def advance_with_search(state: State, dt: float) -> State:
    """As `advance`, but a search that is due runs first. For use without real time."""
    return advance(search_posture(state)(state) if wants_search(state) else state, dt)


def at_rest(old: State, new: State) -> bool:
    """Whether a tick has changed nothing but the time, and later ticks will not either until the request changes."""
    was, now = old.request, new.request
    kept = (
        new.problem is old.problem
        and _stands(old.arm, new.arm)
        and now.command is was.command
        and now.controller is was.controller
        and now.detour is was.detour
        and (now.searched, now.path_s) == (was.searched, was.path_s)
    )
    if old.compared is None or new.compared is None:
        kept = kept and old.compared is new.compared
    else:
        kept = (
            kept and _stands(old.compared.arm, new.compared.arm) and new.compared.controller is old.compared.controller
        )
    return kept and now.unchanged > RESTED and not wants_search(new)


def _stands(old: ArmState, new: ArmState) -> bool:
    """Whether an arm is the same in both states."""
    still = new.q is old.q and new.velocities is old.velocities
    return still and (new.gripper, new.parked) == (old.gripper, old.parked)


def leads_elsewhere(old: State | None, new: State) -> bool:
    """Whether the goal of the new state may differ from that of the old one, so that it has to be computed again."""
    if old is None:
        return True
    was, now = old.request, new.request
    return not (
        new.problem is old.problem
        and new.arm.q is old.arm.q
        and new.arm.parked == old.arm.parked
        and now.command is was.command
        and now.controller is was.controller
        and now.detour is was.detour
        and now.with_orientation == was.with_orientation
    )
