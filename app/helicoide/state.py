"""One arm and its scene at one instant: where the arm is, what it is asked, what stands around it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.command import Command, Course, Hold
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem
from helicoide.ik.drive import Drive
from helicoide.ik.goal import Goal, tool_pose
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.choice import Ranked
from helicoide.kernels import plain
from helicoide.kinematics.ball import Ball
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import Kind, Map, normal_of
from helicoide.text import Text, joined, same
from helicoide.trajectory.waypoints import Taught


@dataclass(frozen=True)
class Grasp:
    """What somebody holds with the pointer: the target, or the plane of that number."""

    seat: str
    handle: str


@dataclass(frozen=True, eq=False)
class Held:
    """What held the last guarded step back: the multipliers of its rows, and the pull of the task against them."""

    multipliers: Array
    pull: float


@dataclass(frozen=True, eq=False)
class ArmState:
    """Where an arm is: q (n,), rad; speeds (n,), rad/s; poses: Ts_world_link (m + 1, 4, 4), m.

    gripper: 0 closed to 1 open; parked: planes off, between `home` and `ready`; held: what held the last step back.
    """

    q: Array
    speeds: Array
    poses: Array
    gripper: float = 0.0
    parked: bool = False
    held: Held | None = None

    @property
    def moving(self) -> bool:
        """Whether any joint moves faster than a thousandth of a radian per second."""
        return bool(np.max(np.abs(self.speeds)) > 1e-3)


@dataclass(frozen=True, eq=False)
class Request:
    """What is asked of the arm, by which method, and what has come of it so far.

    drive: the method that brings the tool to poses; gripper: what its gripper is asked to be, 0 closed to 1 open;
    course: the path that Play follows, and path_s, where on it the target stands, s; grasp: what somebody holds;
    rested: s since the wish last changed; searched: whether another posture was looked for, and detour, its joints to
    pass through; goal: where the command leads.
    """

    command: Command = field(default_factory=Hold)
    drive: Drive = field(default_factory=Drive)
    with_orientation: bool = True
    gripper: float = 0.0
    course: Course = field(default_factory=Course)
    path_s: float = 0.0
    grasp: Grasp | None = None
    rested: float = 0.0
    searched: bool = False
    detour: Array | None = None
    goal: Goal | None = None

    def afresh(self) -> Request:
        """The same request as if it had just been made: the search for another posture starts anew."""
        return replace(self, rested=0.0, searched=False, detour=None)


@dataclass(frozen=True, eq=False)
class Compared:
    """A second arm of the same kind that follows the same target by another method."""

    arm: ArmState
    drive: Drive


@dataclass(frozen=True, eq=False)
class Seen:
    """A cloud of points (k, 3), m, which of them lie on the plane that was found (k,), and what was found in words."""

    points: Array
    on_it: NDArray[np.bool_]
    words: Text


@dataclass(frozen=True)
class Counting:
    """A map of the workspace that is being counted: its kind, and how much of it is, 0 to 1."""

    kind: Kind
    share: float = 0.0


@dataclass(frozen=True, eq=False)
class Workspace:
    """What is mapped of where the tool comes: what is being counted, and the last map that was finished."""

    counting: Counting | None = None
    map: Map | None = None


@dataclass(frozen=True, eq=False)
class Listed:
    """The postures that were found for T_world_goal (4, 4), m, with or without its orientation, in their order.

    q (n,), rad or m: where the arm was then; answer: what was found; rows: the same in the order of the choice.
    """

    T_world_goal: Array
    with_orientation: bool
    q: Array
    answer: Answer
    rows: tuple[Ranked, ...]


@dataclass(frozen=True, eq=False)
class Postures:
    """The choice between postures: what the motion of each joint costs beside the others, (n,), and the last list."""

    weights: Array
    listed: Listed | None = None


@dataclass(frozen=True, eq=False)
class State:
    """One arm and its scene at one instant; every field is replaced, never changed.

    problem: the arm, its limits, and the planes, obstacles and entry point around it; t, s; taught: the waypoints;
    postures: those of a goal, and the choice between them; compared: a second arm beside the first; seen: the clouds
    that were read, by the name of the plane that was looked for; workspace: the maps of where the tool comes; ball:
    what there is to grasp; notice: what the last refusal says, or at first what is to be said of the robot's file.
    """

    problem: Problem
    arm: ArmState
    request: Request
    taught: Taught
    postures: Postures
    compared: Compared | None = None
    seen: Mapping[str, Seen] = field(default_factory=lambda: MappingProxyType({}))
    workspace: Workspace = Workspace()
    ball: Ball | None = None
    t: float = 0.0
    notice: Text | None = None

    @property
    def robot(self) -> Robot:
        """The arm."""
        return self.problem.robot

    @property
    def T_world_tool(self) -> Array:
        """Pose of the tool, (4, 4), m."""
        return tool_pose(self.problem, self.arm.poses)

    @property
    def guarded_points(self) -> Array:
        """The guarded points where they are, (p, 3), m."""
        return points_on(self.robot, self.arm.poses)

    @property
    def axes(self) -> Array:
        """The joint axes where they are, (m, 3), unit, world frame."""
        return np.asarray((self.arm.poses[1:, :3, :3] @ self.robot.directions[:, :, None])[:, :, 0])

    @cached_property
    def of_compared(self) -> State | None:
        """The state in which the second arm stands in for the first."""
        second = self.compared
        if second is None:
            return None
        return replace(
            self, arm=second.arm, request=replace(self.request, drive=second.drive, detour=None), compared=None
        )


Update = Callable[[State], State]


def points_on(robot: Robot, poses: Array) -> Array:
    """The guarded points for given link poses (m + 1, 4, 4), (p, 3), m, world frame; without a kernel, for the view."""
    carriers = poses[robot.guarded_joints]
    return np.asarray((carriers[:, :3, :3] @ robot.guarded_points[:, :, None])[:, :, 0] + carriers[:, :3, 3])


def initial(robot: Robot) -> State:
    """The arm at `ready`, holding, inside the planes of its file; what is to be said of the file is its notice.

    Orientation is asked for where joints are left once the place of the tool is given.
    """
    q = robot.poses["ready"]
    limits = Limits(robot.lower, robot.upper, robot.speed, robot.acceleration)
    poses = frozen(plain(link_poses)(robot.chain, q))
    return State(
        problem=Problem(robot, limits, planes_of(robot.panes)),
        arm=ArmState(q, frozen(np.zeros(len(q))), poses),
        request=Request(with_orientation=len(q) > (3 if normal_of(robot) is None else 2)),
        taught=Taught(robot),
        postures=Postures(frozen(np.ones(len(q)))),
        notice=same("{robot}: {remarks}.").format(robot=robot.title, remarks=joined(robot.remarks))
        if robot.remarks
        else None,
    )


def commanded(state: State, command: Command) -> State:
    """The same state under a new command."""
    return replace(state, request=replace(state.request.afresh(), command=command), notice=None)


def enclosed(state: State, problem: Problem, notice: Text | None = None) -> State:
    """The same state inside other planes, obstacles or zones, or through another entry point.

    What held the arm back, now and where its command leads, counts planes and obstacles: with others it is unknown.
    """
    request, arm, compared = state.request.afresh(), state.arm, state.compared
    if _things(problem) != _things(state.problem):
        request, arm = replace(request, goal=None), replace(arm, held=None)
        compared = compared and replace(compared, arm=replace(compared.arm, held=None))
    return replace(state, problem=problem, arm=arm, request=request, compared=compared, notice=notice)


def _things(problem: Problem) -> tuple[int, int, bool]:
    """How many planes and obstacles there are, and whether there is an entry point."""
    return len(problem.planes.panes), len(problem.obstacles.radii), problem.entry is not None


def grasped(state: State, grasp: Grasp | None) -> State:
    """The same state with that in somebody's hand, or nothing."""
    return replace(state, request=replace(state.request, grasp=grasp))
