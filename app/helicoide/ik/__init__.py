"""Inverse kinematics: what an arm may do (Problem), where a wish leads (Goal), and the guarded step that gets there."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.confinement import Obstacles, Planes, Zones
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

NOTICEABLE = 0.02
NEAR = 1e-4


@dataclass(frozen=True, eq=False)
class Limits:
    """Joint limits, (n,) each: lower and upper, rad; speed, rad/s; acceleration, rad/s², without limit unless given."""

    lower: Array
    upper: Array
    speed: Array
    acceleration: Array = field(default_factory=lambda: frozen([]))

    def __post_init__(self) -> None:
        if not self.acceleration.size:
            object.__setattr__(self, "acceleration", frozen(np.full(len(self.lower), np.inf)))


@dataclass(frozen=True, eq=False)
class EntryPoint:
    """A point that a straight instrument must pass through: the remote centre of motion.

    point (3,), m, world; link: the one that carries the instrument; shaft (2, 3): a point of it, m, and its direction,
    unit, in the frame of that link.
    """

    point: Array
    link: int
    shaft: Array


def entry_point(robot: Robot, point: ArrayLike) -> EntryPoint:
    """An entry point (3,), m, for the shaft of a robot: along the axis of the joint that carries its frame `rcm`.

    Raises HelicoideError for a robot without such a frame.
    """
    if "rcm" not in robot.frames:
        raise HelicoideError(
            Text(
                en="{robot} has no frame rcm, which says where its instrument is; there is: {frames}.",
                pt_BR="{robot} não tem o referencial rcm, que diz onde está o instrumento; há: {frames}.",
            ).format(robot=robot.title, frames=", ".join(robot.frames))
        )
    frame = robot.frames["rcm"]
    return EntryPoint(
        frozen(point), frame.link, frozen([frame.T_link_frame[:3, 3], robot.joints[frame.link - 1].direction])
    )


@dataclass(frozen=True, eq=False)
class Problem:
    """What an arm may do here: its geometry, its limits, planes and obstacles around it, where it must pass through.

    scale: the characteristic length ℓ, m, where it is not the arm's reach: weights, gains and damping depend on it.
    """

    robot: Robot
    limits: Limits
    planes: Planes
    zones: Zones = field(default_factory=Zones)
    scale: float | None = None
    obstacles: Obstacles = field(default_factory=Obstacles)
    entry: EntryPoint | None = None

    @property
    def length(self) -> float:
        """The characteristic length ℓ, m."""
        return self.robot.reach if self.scale is None else self.scale

    @cached_property
    def joint_units(self) -> Array:
        """What a rate without unit stands for in each joint, (n,): 1 rad, or ℓ where it slides."""
        return frozen([self.length if joint.is_prismatic else 1.0 for joint in self.robot.variables])

    @cached_property
    def plane_arrays(self) -> tuple[Array, Array, float]:
        """Normals (k, 3), offsets (k,), m, and the critical distance, m."""
        return self.planes.normals, frozen(self.planes.offsets), self.zones.critical

    @cached_property
    def pairs(self) -> tuple[tuple[int, int], ...]:
        """Bodies that are kept apart, by number, obstacles after those of the arm: pairs of the arm's, then each moving
        one and each obstacle.
        """
        bodies = self.robot.bodies
        moving = [i for i, body in enumerate(bodies) if max(body.links) > 0]
        behind = range(len(bodies), len(bodies) + len(self.obstacles.radii))
        return *self.robot.self_collision, *((i, j) for i in moving for j in behind)

    @cached_property
    def without_acceleration_limits(self) -> Problem:
        """The same without limits of acceleration: where the arm comes to rest does not depend on them."""
        return replace(self, limits=Limits(self.limits.lower, self.limits.upper, self.limits.speed))


@dataclass(frozen=True)
class ActiveConstraint:
    """What holds a step back, and how hard: its multiplier, in the unit of the task's cost per m or rad."""

    multiplier: float = field(default=0.0, compare=False, kw_only=True)


@dataclass(frozen=True)
class Contact(ActiveConstraint):
    """A guarded point held at the critical distance by a plane; numbers as in the robot and its planes."""

    plane: int
    point: int


@dataclass(frozen=True)
class ObstacleContact(ActiveConstraint):
    """A body of the arm held by an obstacle; numbers as in `Robot.bodies` and the obstacles."""

    obstacle: int
    body: int


@dataclass(frozen=True)
class SelfContact(ActiveConstraint):
    """A body of the arm held by another; numbers as in `Robot.bodies`."""

    first: int
    second: int


@dataclass(frozen=True)
class AtLimit(ActiveConstraint):
    """A joint held by its position limit."""

    joint: int


@dataclass(frozen=True)
class AtSpeed(ActiveConstraint):
    """A joint that cannot move faster."""

    joint: int


@dataclass(frozen=True)
class AtAcceleration(ActiveConstraint):
    """A joint that cannot become faster or slower sooner, or must slow down to stop before its limit."""

    joint: int


@dataclass(frozen=True)
class AtEntryPoint(ActiveConstraint):
    """The instrument held by its entry point."""


Reason = Contact | ObstacleContact | SelfContact | AtLimit | AtEntryPoint | AtSpeed | AtAcceleration


def reason_of(problem: Problem, row: int, multiplier: float = 0.0) -> Reason:
    """What a slot of `Work.held` stands for: 2 n limits, then those of `collision.clearances`."""
    n, k = len(problem.limits.lower), len(problem.planes.normals)
    points, bodies = k * len(problem.robot.monitored_points), len(problem.robot.bodies)
    joint, row = row % n, row - 2 * n
    if row < 0:
        return AtLimit(joint, multiplier=multiplier)
    if row < points:
        return Contact(row % k, row // k, multiplier=multiplier)
    row -= points
    if row < len(problem.pairs):
        a, b = problem.pairs[row]
        if b < bodies:
            return SelfContact(a, b, multiplier=multiplier)
        return ObstacleContact(b - bodies, a, multiplier=multiplier)
    row -= len(problem.pairs)
    if row == 4 * n:
        return AtEntryPoint(multiplier=multiplier)
    return (AtSpeed if row < 2 * n else AtAcceleration)(row % n, multiplier=multiplier)


_ORDER = (Contact, ObstacleContact, SelfContact, AtLimit, AtEntryPoint, AtSpeed, AtAcceleration)


def reasons(problem: Problem, q: Array, multipliers: Array, pull: float) -> tuple[Reason, ...]:
    """What held a guarded step back at q: planes, obstacles, the arm itself, position limits, the entry point, speed,
    acceleration, and the hardest of each kind first.

    A row that carries less than `NOTICEABLE` of the task's pull does not count: a stretched arm rests on the limit of
    its elbow without being held by it.
    """
    n = len(q)
    room = np.concatenate((q - problem.limits.lower, problem.limits.upper - q))
    found = [
        reason_of(problem, int(row), float(multipliers[row]))
        for row in np.argsort(-multipliers)
        if multipliers[row] > NOTICEABLE * pull and not (row < 2 * n and room[row] >= NEAR)
    ]
    return tuple(sorted(found, key=lambda reason: _ORDER.index(type(reason))))
