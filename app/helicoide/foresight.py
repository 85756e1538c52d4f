"""Where a command leads, before the arm is there: its goal, another posture that reaches farther, or that it rests."""

from __future__ import annotations

from dataclasses import replace

from helicoide.advance import advance
from helicoide.ik.drive import GUARDED
from helicoide.ik.goal import best_goal, goal_at_joints, goal_at_pose
from helicoide.kinematics.chain import frozen
from helicoide.state import Along, GetReady, Park, State, ToJoints, ToPose, Update

SETTLED = 0.5
# For how long nothing must have been asked until an arm rests, s: all that is said of waiting is said before.
RESTED = 2.0


def foreseen(state: State) -> State:
    """The same state with the goal that its command leads to; solved at the scene's rate, not in every tick.

    Where a method of the sources will come to rest is not foreseen.
    """
    problem, q = state.problem, state.q if state.detour is None else state.detour
    if isinstance(state.command, ToPose | Along) and state.drive.method != GUARDED:
        return replace(state, goal=None)
    match state.command:
        case ToPose(T):
            return replace(state, goal=goal_at_pose(problem, q, T, state.with_orientation))
        case Along(path, s):
            return replace(state, goal=goal_at_pose(problem, q, frozen(path.pose(s)), state.with_orientation))
        case ToJoints(wished, yielding):
            return replace(state, goal=goal_at_joints(problem, state.q, wished, yielding))
        case Park() | GetReady() if not state.parked:
            return replace(state, goal=goal_at_joints(problem, state.q, state.robot.poses["ready"]))
        case _:
            return replace(state, goal=None)


def wants_search(state: State) -> bool:
    """Whether to look for another posture that reaches what this one does not: once, when a wish has rested for a while
    or its target was let go.

    The search foresees where the arm will stop, so it need not wait: along a wall the arm may creep for a minute.
    """
    command = state.command
    if state.searched or state.parked or state.drive.method != GUARDED:
        return False
    if isinstance(command, ToPose):
        return command.settles or state.rested >= SETTLED
    return isinstance(command, Along) and not (command.playing and command.arrived) and state.rested >= SETTLED


def search(state: State) -> Update:
    """What a search comes to: the posture to pass through, if any, and the place on which a target settles.

    It takes as long as some hundred ticks, and so is no part of one; it is worth nothing once something else is asked.
    """
    command = state.command
    assert isinstance(command, ToPose | Along)
    T = command.T_world_target if isinstance(command, ToPose) else frozen(command.path.pose(command.s))
    goal, detour = best_goal(state.problem, state.q, T, state.with_orientation)

    def found(now: State) -> State:
        if now.searched or not _asks_the_same(now, state):
            return now
        now = replace(now, searched=True, rested=0.0, detour=detour)
        if not isinstance(now.command, ToPose) or not now.command.settles:
            return now
        return replace(now, command=ToPose(goal.T_world_tool if detour is None else T))

    return found


def _asks_the_same(new: State, old: State) -> bool:
    """Whether the same is asked of the arm, and under the same conditions."""
    if isinstance(new.command, Along) and isinstance(old.command, Along):
        asked = new.command.path is old.command.path and new.command.s == old.command.s
    else:
        asked = new.command is old.command
    same = new.problem is old.problem and new.with_orientation == old.with_orientation
    return asked and same and new.drive.method == old.drive.method and not new.parked


def lived(state: State, dt: float) -> State:
    """As `advance`, with a search that is due done at once: for whoever need not keep time."""
    return advance(search(state)(state) if wants_search(state) else state, dt)


def rests(old: State, new: State) -> bool:
    """Whether a tick has changed nothing but the time, and none will before something else is asked."""
    still = new.rested > RESTED and not wants_search(new) and new.gripper == old.gripper
    kept = ("q", "speeds", "command", "problem", "drive", "detour", "parked", "searched", "path_s")
    beside = (old.beside is None) == (new.beside is None) and (
        old.beside is None
        or new.beside is None
        or (new.beside.q is old.beside.q and new.beside.drive is old.beside.drive)
    )
    return still and beside and all(getattr(new, name) is getattr(old, name) for name in kept)


def leads_elsewhere(old: State | None, new: State) -> bool:
    """Whether the goal may be another than the one foreseen."""
    return old is None or any(
        getattr(old, name) is not getattr(new, name)
        for name in ("q", "command", "problem", "detour", "with_orientation", "parked", "drive")
    )
