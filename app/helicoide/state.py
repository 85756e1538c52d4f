"""One arm and its scene at one instant: the posture of the arm, the request, and the objects around it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from helicoide.arrays import Array, frozen
from helicoide.command import Command, HoldPosition, PathChoice
from helicoide.comparison import Trace
from helicoide.confinement import planes_of
from helicoide.history import History
from helicoide.ik import Limits, Problem
from helicoide.ik.controller import Controller
from helicoide.ik.goal import Goal, pose_of_tool
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
    """What a pointer holds. seat: whose pointer; handle: the object, such as "target", "entry" or "plane 0"."""

    seat: str
    handle: str


@dataclass(frozen=True, eq=False)
class ActiveSet:
    """The constraints that were active in the last guarded step.

    multipliers: the Lagrange multiplier of each row of its constraints; pull: the weighted size of the task.
    """

    multipliers: Array
    pull: float


@dataclass(frozen=True, eq=False)
class ArmState:
    """The state of an arm: q (n,), rad or m; velocities (n,), rad/s or m/s; poses: Ts_world_link (m + 1, 4, 4), m.

    gripper: 0 closed to 1 open; parked: planes off, between `home` and `ready`; active_set: that of the last guarded
    step, None if unknown.
    """

    q: Array
    velocities: Array
    poses: Array
    gripper: float = 0.0
    parked: bool = False
    active_set: ActiveSet | None = None

    @property
    def moving(self) -> bool:
        """Whether any joint moves faster than 0.001 rad/s or m/s."""
        return bool(np.max(np.abs(self.velocities)) > 1e-3)


@dataclass(frozen=True, eq=False)
class Request:
    """What is asked of the arm, by which method, and its result so far.

    controller: the method that brings the tool to poses; gripper: target opening, 0 closed to 1 open; path_choice: the
    path that Play follows; path_s: the parameter of the target on it, s; drag: what a pointer holds; unchanged: time
    since the request last changed, s; searched: whether the search for another posture is done; detour (n,): the
    posture to pass through, rad or m; goal: where the command leads, None if unknown.
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
        """The request as if just made: its time restarts and another posture may be searched for again."""
        return replace(self, unchanged=0.0, searched=False, detour=None)


@dataclass(frozen=True, eq=False)
class ComparedArm:
    """A second arm of the same kind that follows the same target by another method. trace: effort of both arms."""

    arm: ArmState
    controller: Controller
    trace: Trace = field(default_factory=Trace)


@dataclass(frozen=True, eq=False)
class FittedCloud:
    """A cloud of points (k, 3), m, which of them lie on the fitted plane, (k,), and the result of the fit in words."""

    points: Array
    on_plane: NDArray[np.bool_]
    words: Text


@dataclass(frozen=True)
class MapProgress:
    """A map of the workspace that is being computed: its kind and the finished fraction, 0 to 1."""

    kind: MapKind
    share: float = 0.0


@dataclass(frozen=True, eq=False)
class WorkspaceMaps:
    """Maps of the workspace: the one that is being computed, and the last finished one."""

    progress: MapProgress | None = None
    map: WorkspaceMap | None = None


@dataclass(frozen=True, eq=False)
class PostureList:
    """The postures found for T_world_goal (4, 4), m, with or without its orientation.

    q (n,), rad or m: the posture of the arm at that time; answer: the postures; rows: the same in the order shown.
    """

    T_world_goal: Array
    with_orientation: bool
    q: Array
    answer: Answer
    rows: tuple[Ranked, ...]


@dataclass(frozen=True, eq=False)
class Postures:
    """The choice between postures: the relative cost of each joint's motion, (n,), and the last list."""

    weights: Array
    listing: PostureList | None = None


@dataclass(frozen=True, eq=False)
class Plan:
    """A motion that is planned and not yet made: joint values q (k, n), rad or m, at times (k,), s, from rest to rest.

    problem: the planes, obstacles and limits for which it was planned; title: where it leads.
    """

    title: Text
    times: Array
    q: Array
    problem: Problem


@dataclass(frozen=True, eq=False)
class State:
    """One arm and its scene at one instant. Immutable: a change makes a new State.

    problem: the arm, its limits, and the planes, obstacles and entry point; t: time, s; taught: the waypoints;
    postures: those of a goal, and the choice between them; compared: the second arm; clouds: the clouds that were read,
    by the name of the plane; workspace: its maps; ball: the ball to grasp; plan: a motion that is shown before it is
    made; history: what can be undone and redone; notice: why the last request was refused, another message, or None.
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
    plan: Plan | None = None
    history: History = field(default_factory=History)
    t: float = 0.0
    notice: Text | None = None

    @property
    def robot(self) -> Robot:
        """The robot of the problem."""
        return self.problem.robot

    @property
    def T_world_tool(self) -> Array:
        """Pose of the tool, (4, 4), m."""
        return pose_of_tool(self.problem, self.arm.poses)

    @property
    def monitored_points(self) -> Array:
        """The monitored points at the present posture, (p, 3), m, world frame."""
        return points_on(self.robot, self.arm.poses)

    @property
    def axes(self) -> Array:
        """The joint axes at the present posture, (m, 3), unit vectors, world frame."""
        return np.asarray((self.arm.poses[1:, :3, :3] @ self.robot.directions[:, :, None])[:, :, 0])

    @cached_property
    def compared_state(self) -> State | None:
        """The state with the second arm in place of the first; None without a second arm."""
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
    """The monitored points for link poses (m + 1, 4, 4), as (p, 3), m, world frame. Uses no compiled kernel."""
    carriers = poses[robot.monitored_links]
    return np.asarray((carriers[:, :3, :3] @ robot.monitored_points[:, :, None])[:, :, 0] + carriers[:, :3, 3])


def initial_state(robot: Robot) -> State:
    """The arm at rest at `ready` with the planes of its file. The remarks of the file are the notice.

    Orientation is controlled if the arm has more joints than the position of its tool needs.
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


def with_joints(state: State, q: Array) -> State:
    """The state with the arm at other joint values, q (n,), rad or m."""
    own = frozen(q)
    return replace(state, arm=replace(state.arm, q=own, poses=frozen(link_poses(state.robot.chain, own))))


def with_command(state: State, command: Command) -> State:
    """The state with a new command and no notice."""
    return replace(state, request=replace(state.request.renewed(), command=command), notice=None)


def with_problem(state: State, problem: Problem, notice: Text | None = None) -> State:
    """The state with another problem: other planes, obstacles, zones or another entry point.

    The goal and the active sets refer to planes and obstacles by their number, so a change of their count clears them.
    """
    request, arm, compared = state.request.renewed(), state.arm, state.compared
    if _things(problem) != _things(state.problem):
        request, arm = replace(request, goal=None), replace(arm, active_set=None)
        compared = compared and replace(compared, arm=replace(compared.arm, active_set=None))
    return replace(state, problem=problem, arm=arm, request=request, compared=compared, notice=notice)


def _things(problem: Problem) -> tuple[int, int, bool]:
    """The number of planes and of obstacles, and whether there is an entry point."""
    return len(problem.planes.panes), len(problem.obstacles.radii), problem.entry is not None


def with_drag(state: State, drag: Drag | None) -> State:
    """The state with another drag, or none."""
    return replace(state, request=replace(state.request, drag=drag))
