"""One arm and its scene (State), one person in front of it (Seat), and what the arm may be asked to do (Command)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem
from helicoide.ik.drive import Drive
from helicoide.ik.goal import Goal, tool_pose
from helicoide.ik.task import EVERY
from helicoide.kernels import plain
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.workspace import Kind, Map
from helicoide.text import Language, Text
from helicoide.trajectory import Path
from helicoide.trajectory.fastest import Shape
from helicoide.trajectory.path import JointPath
from helicoide.trajectory.waypoints import Taught, Waypoint


@dataclass(frozen=True)
class Hold:
    """Nothing moves."""

    stopped: bool = False


@dataclass(frozen=True, eq=False)
class ToPose:
    """Bring the tool to T_world_target (4, 4), m.

    settles: whether the target goes to where the arm can come, once that has been searched for.
    """

    T_world_target: Array
    settles: bool = False


@dataclass(frozen=True, eq=False)
class ToJoints:
    """Bring the joints to q (n,), rad; `yielding`: the joint that stops first at a plane, or every one alike."""

    q: Array
    yielding: int = EVERY


@dataclass(frozen=True)
class Course:
    """The path that Play follows: its key among those of the arm, its time scaling, and how long it takes, s.

    None: the first of the arm, and as long as it takes of its own.
    """

    name: str | None = None
    shape: Shape = "constant speed"
    duration: float | None = None


@dataclass(frozen=True)
class Along:
    """Follow a path from its parameter s, s; the parameter waits until the arm has come to the path.

    nearest: how near it has come so far, m; waited: since when it has come no nearer, s.
    """

    path: Path
    s: float
    playing: bool
    arrived: bool = False
    nearest: float = np.inf
    waited: float = 0.0


@dataclass(frozen=True, eq=False)
class Replay:
    """Go along a path of the joints from s on, after coming to where it begins; title: what is said of it.

    waits: whether its time slows down where the arm cannot keep up.
    """

    path: JointPath
    title: Text
    waits: bool = True
    s: float = 0.0
    arrived: bool = False


@dataclass(frozen=True)
class Park:
    """Go to `ready`, then with the planes off to `home`."""


@dataclass(frozen=True)
class GetReady:
    """Go to `ready`; from `home` with the planes off."""


Command = Hold | ToPose | ToJoints | Along | Replay | Park | GetReady


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
class Beside:
    """A second arm of the same kind that follows the same target by another method; fields as in State."""

    q: Array
    speeds: Array
    poses: Array
    drive: Drive
    held: Held | None = None


@dataclass(frozen=True, eq=False)
class Seen:
    """A cloud of points (k, 3), m, which of them lie on the plane that was found (k,), and what was found in words."""

    points: Array
    on_it: NDArray[np.bool_]
    words: Text


@dataclass(frozen=True, eq=False)
class Workspace:
    """What is mapped of where the tool comes: which kind is chosen, the share that is counted, None while nothing is,
    and the last map that was finished.
    """

    kind: Kind = "reachable"
    progress: float | None = None
    map: Map | None = None


@dataclass(frozen=True, eq=False)
class State:
    """One arm and its scene at one instant; every field is replaced, never changed.

    q (n,), rad; speeds (n,), rad/s; poses: Ts_world_link (m + 1, 4, 4), m; t, s; gripper and its target: 0 closed to
    1 open; course: the path that Play follows, and path_s, where on it the target stands, s; rested: s since the wish
    last changed; detour: joints of another posture to pass through, and whether one was searched; parked: planes off,
    between `home` and `ready`; goal: where the command leads. drive: the method that brings the tool to poses; held:
    what held it back; beside: a second arm to compare with; seen: the clouds that were read, by the name of the plane
    that was looked for; waypoints: those that were taught, and leg_shape, the time scaling of the way to each;
    workspace: its map.
    """

    problem: Problem
    q: Array
    speeds: Array
    poses: Array
    t: float = 0.0
    gripper: float = 0.0
    gripper_target: float = 0.0
    command: Command = Hold()
    course: Course = Course()
    path_s: float = 0.0
    with_orientation: bool = True
    rested: float = 0.0
    detour: Array | None = None
    searched: bool = False
    parked: bool = False
    grasp: Grasp | None = None
    goal: Goal | None = None
    notice: Text | None = None
    drive: Drive = field(default_factory=Drive)
    held: Held | None = None
    beside: Beside | None = None
    seen: Mapping[str, Seen] = field(default_factory=lambda: MappingProxyType({}))
    waypoints: tuple[Waypoint, ...] = ()
    leg_shape: Shape = "trapezoid"
    workspace: Workspace = Workspace()

    @property
    def robot(self) -> Robot:
        """The arm."""
        return self.problem.robot

    @property
    def taught(self) -> Taught:
        """The waypoints as a list of this arm's."""
        return Taught(self.robot, self.waypoints)

    @property
    def T_world_tool(self) -> Array:
        """Pose of the tool, (4, 4), m."""
        return tool_pose(self.problem, self.poses)

    @property
    def guarded_points(self) -> Array:
        """The guarded points where they are, (p, 3), m."""
        return points_on(self.robot, self.poses)

    @property
    def axes(self) -> Array:
        """The joint axes where they are, (m, 3), unit, world frame."""
        return np.asarray((self.poses[1:, :3, :3] @ self.robot.directions[:, :, None])[:, :, 0])

    @cached_property
    def of_beside(self) -> State | None:
        """The state in which the second arm stands in for the first."""
        other = self.beside
        if other is None:
            return None
        return replace(
            self,
            q=other.q,
            speeds=other.speeds,
            poses=other.poses,
            drive=other.drive,
            held=other.held,
            beside=None,
            detour=None,
        )

    @property
    def moving(self) -> bool:
        """Whether any joint moves faster than a thousandth of a radian per second."""
        return bool(np.max(np.abs(self.speeds)) > 1e-3)


Update = Callable[[State], State]


def points_on(robot: Robot, poses: Array) -> Array:
    """The guarded points for given link poses (m + 1, 4, 4), (p, 3), m, world frame; without a kernel, for the view."""
    carriers = poses[robot.guarded_joints]
    return np.asarray((carriers[:, :3, :3] @ robot.guarded_points[:, :, None])[:, :, 0] + carriers[:, :3, 3])


def initial(robot: Robot) -> State:
    """The arm at `ready`, holding, inside the planes of its file."""
    q = robot.poses["ready"]
    return State(
        problem=Problem(
            robot, Limits(robot.lower, robot.upper, robot.speed, robot.acceleration), planes_of(robot.panes)
        ),
        q=q,
        speeds=frozen(np.zeros(len(q))),
        poses=frozen(plain(link_poses)(robot.chain, q)),
    )


def commanded(state: State, command: Command) -> State:
    """The same state under a new command: the search for another posture starts afresh."""
    return replace(state, command=command, rested=0.0, detour=None, searched=False, notice=None)


@dataclass(frozen=True)
class Seat:
    """One person: language, where they are in a lesson, what they selected and what they want to see.

    done: the steps whose goal has been reached; picked: the points, m, world, that they have clicked for a plane, None
    while they do not pick; cut: where maps of the workspace are cut, −1 to 1 of the arm's reach.
    """

    token: str
    language: Language
    lesson: str | None = None
    step: int = 0
    done: frozenset[str] = frozenset()
    hint_open: bool = False
    selected: str | None = None
    picked: tuple[tuple[float, ...], ...] | None = None
    shows: Mapping[str, bool] = field(default_factory=lambda: MappingProxyType({}))
    cut: float = 0.0

    def showing(self, name: str, on: bool) -> Seat:
        """The same seat with one layer of the scene shown or hidden."""
        return replace(self, shows=MappingProxyType({**self.shows, name: on}))


SeatUpdate = Callable[[Seat], Seat]
