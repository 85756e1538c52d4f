"""One arm and its scene at one instant: where the arm is, what it is asked, what stands around it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.command import Command, HoldPosition, PathChoice
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem
from helicoide.ik.controller import Controller
from helicoide.ik.goal import Goal, tool_pose
from helicoide.ik.postures.answer import Answer
from helicoide.ik.postures.choice import Ranked
from helicoide.kernels import python_function
from helicoide.kinematics.ball import GolfBall
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import MapKind, WorkspaceMap, plane_normal
from helicoide.text import Text, join_texts, untranslated
from helicoide.trajectory.waypoints import WaypointList


@dataclass(frozen=True)
class Drag:
    """What somebody holds with the pointer: the target, or the plane of that number."""

    seat: str
    handle: str


@dataclass(frozen=True, eq=False)
class ActiveSet:
    """What held the last guarded step back: the multipliers of its rows, and the pull of the task against them."""

    multipliers: Array
    pull: float


@dataclass(frozen=True, eq=False)
class ArmState:
    """Where an arm is: q (n,), rad; velocities (n,), rad/s; poses: Ts_world_link (m + 1, 4, 4), m.

    gripper: 0 closed to 1 open; parked: planes off, between `home` and `ready`; active_set: what held the last step
    back.
    """

    q: Array
    velocities: Array
    poses: Array
    gripper: float = 0.0
    parked: bool = False
    active_set: ActiveSet | None = None

    @property
    def moving(self) -> bool:
        """Whether any joint moves faster than a thousandth of a radian per second."""
        return bool(np.max(np.abs(self.velocities)) > 1e-3)


@dataclass(frozen=True, eq=False)
class Request:
    """What is asked of the arm, by which method, and what has come of it so far.

    controller: the method that brings the tool to poses; gripper: what its gripper is asked to be, 0 closed to 1 open;
    path_choice: the path that Play follows, and path_s, where on it the target stands, s; drag: what somebody holds;
    unchanged: s since the wish last changed; searched: whether another posture was looked for, and detour, its joints
    to pass through; goal: where the command leads.
    """

    command: Command = field(default_factory=HoldPosition)
    controller: Controller = field(default_factory=Controller)
    with_orientation: bool = True
    gripper: float = 0.0
    path_choice: PathChoice = field(default_factory=PathChoice)
    path_s: float = 0.0
    drag: Drag | None = None
    unchanged: float = 0.0
    searched: bool = False
    detour: Array | None = None
    goal: Goal | None = None

    def renewed(self) -> Request:
        """The same request as if it had just been made: the search for another posture starts anew."""
        return replace(self, unchanged=0.0, searched=False, detour=None)


@dataclass(frozen=True, eq=False)
class ComparedArm:
    """A second arm of the same kind that follows the same target by another method."""

    arm: ArmState
    controller: Controller


@dataclass(frozen=True, eq=False)
class FittedCloud:
    """A cloud of points (k, 3), m, which of them lie on the plane that was found (k,), and what was found in words."""

    points: Array
    on_plane: NDArray[np.bool_]
    words: Text


@dataclass(frozen=True)
class MapProgress:
    """A map of the workspace that is being counted: its kind, and how much of it is, 0 to 1."""

    kind: MapKind
    share: float = 0.0


@dataclass(frozen=True, eq=False)
class WorkspaceMaps:
    """What is mapped of where the tool comes: what is being counted, and the last map that was finished."""

    progress: MapProgress | None = None
    map: WorkspaceMap | None = None


@dataclass(frozen=True, eq=False)
class PostureList:
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
    listing: PostureList | None = None


@dataclass(frozen=True, eq=False)
class State:
    """One arm and its scene at one instant; every field is replaced, never changed.

    problem: the arm, its limits, and the planes, obstacles and entry point around it; t, s; taught: the waypoints;
    postures: those of a goal, and the choice between them; compared: a second arm beside the first; clouds: the clouds
    that were read, by the name of the plane that was looked for; workspace: the maps of where the tool comes; ball:
    what there is to grasp; notice: what the last refusal says, or at first what is to be said of the robot's file.
    """

    problem: Problem
    arm: ArmState
    request: Request
    taught: WaypointList
    postures: Postures
    compared: ComparedArm | None = None
    clouds: Mapping[str, FittedCloud] = field(default_factory=lambda: MappingProxyType({}))
    workspace: WorkspaceMaps = WorkspaceMaps()
    ball: GolfBall | None = None
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
    def compared_state(self) -> State | None:
        """The state in which the second arm stands in for the first."""
        second = self.compared
        if second is None:
            return None
        return replace(
            self,
            arm=second.arm,
            request=replace(self.request, controller=second.controller, detour=None),
            compared=None,
        )


Update = Callable[[State], State]


def points_on(robot: Robot, poses: Array) -> Array:
    """The guarded points for given link poses (m + 1, 4, 4), (p, 3), m, world frame; without a kernel, for the view."""
    carriers = poses[robot.monitored_links]
    return np.asarray((carriers[:, :3, :3] @ robot.monitored_points[:, :, None])[:, :, 0] + carriers[:, :3, 3])


def initial_state(robot: Robot) -> State:
    """The arm at `ready`, holding, inside the planes of its file; what is to be said of the file is its notice.

    Orientation is asked for where joints are left once the place of the tool is given.
    """
    q = robot.poses["ready"]
    limits = Limits(robot.lower, robot.upper, robot.speed, robot.acceleration)
    poses = frozen(python_function(link_poses)(robot.chain, q))
    return State(
        problem=Problem(robot, limits, planes_of(robot.panes)),
        arm=ArmState(q, frozen(np.zeros(len(q))), poses),
        request=Request(with_orientation=len(q) > (3 if plane_normal(robot) is None else 2)),
        taught=WaypointList(robot),
        postures=Postures(frozen(np.ones(len(q)))),
        notice=untranslated("{robot}: {remarks}.").format(robot=robot.title, remarks=join_texts(robot.remarks))
        if robot.remarks
        else None,
    )


def with_command(state: State, command: Command) -> State:
    """The same state under a new command."""
    return replace(state, request=replace(state.request.renewed(), command=command), notice=None)


def with_problem(state: State, problem: Problem, notice: Text | None = None) -> State:
    """The same state inside other planes, obstacles or zones, or through another entry point.

    What held the arm back, now and where its command leads, counts planes and obstacles: with others it is unknown.
    """
    request, arm, compared = state.request.renewed(), state.arm, state.compared
    if _things(problem) != _things(state.problem):
        request, arm = replace(request, goal=None), replace(arm, active_set=None)
        compared = compared and replace(compared, arm=replace(compared.arm, active_set=None))
    return replace(state, problem=problem, arm=arm, request=request, compared=compared, notice=notice)


def _things(problem: Problem) -> tuple[int, int, bool]:
    """How many planes and obstacles there are, and whether there is an entry point."""
    return len(problem.planes.panes), len(problem.obstacles.radii), problem.entry is not None


def with_drag(state: State, grasp: Drag | None) -> State:
    """The same state with that in somebody's hand, or nothing."""
    return replace(state, request=replace(state.request, drag=grasp))
