"""Inverse kinematics: what an arm may do (`Problem`), and the constraints that limit it (`ActiveConstraint`)."""

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
    """Joint limits, (n,) each: lower and upper, rad or m; speed, per s; acceleration, per s², infinite unless given."""

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

    point (3,), m, world; link: number of the one that carries the instrument; shaft (2, 3): a point of it, m, and its
    unit direction, in the frame of that link.
    """

    point: Array
    link: int
    shaft: Array


def entry_point(robot: Robot, point: ArrayLike) -> EntryPoint:
    """The entry point at `point` (3,), m, world, for the instrument of a robot.

    The shaft passes through the origin of its frame `rcm`, along the axis of the joint that moves the link of this
    frame. Raises HelicoideError for a robot without it.
    """
    if "rcm" not in robot.frames:
        raise HelicoideError(
            Text(
                en="{robot} has no frame rcm, which gives the pose of its instrument; frames: {frames}.",
                pt_BR="{robot} não tem o referencial rcm, que dá a pose do instrumento; referenciais: {frames}.",
            ).format(robot=robot.title, frames=", ".join(robot.frames))
        )
    frame = robot.frames["rcm"]
    return EntryPoint(
        frozen(point), frame.link, frozen([frame.T_link_frame[:3, 3], robot.joints[frame.link - 1].direction])
    )


@dataclass(frozen=True, eq=False)
class Problem:
    """What an arm may do: its geometry and limits, the planes and obstacles around it, its entry point.

    scale: the characteristic length ℓ, m, if it is not the reach. Weights, gains and damping depend on it.
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
        """The unit of each dimensionless joint variable, (n,): 1 rad, or ℓ, m, for a prismatic joint."""
        return frozen([self.length if joint.is_prismatic else 1.0 for joint in self.robot.variables])

    @cached_property
    def plane_arrays(self) -> tuple[Array, Array, float]:
        """Normals (k, 3), offsets (k,), m, and the critical distance, m."""
        return self.planes.normals, frozen(self.planes.offsets), self.zones.critical

    @cached_property
    def pairs(self) -> tuple[tuple[int, int], ...]:
        """Pairs of bodies that are kept apart, by number: those of the arm, then each moving body with each obstacle.

        Obstacles are numbered after the bodies of the arm.
        """
        bodies = self.robot.bodies
        moving = [i for i, body in enumerate(bodies) if max(body.links) > 0]
        behind = range(len(bodies), len(bodies) + len(self.obstacles.radii))
        return *self.robot.self_collision, *((i, j) for i in moving for j in behind)

    @cached_property
    def without_acceleration_limits(self) -> Problem:
        """The same problem without acceleration limits, to compute where the arm comes to rest."""
        return replace(self, limits=Limits(self.limits.lower, self.limits.upper, self.limits.speed))


@dataclass(frozen=True)
class ActiveConstraint:
    """A constraint that limits a step, with its multiplier: units of the task's cost per m or rad."""

    multiplier: float = field(default=0.0, compare=False, kw_only=True)


@dataclass(frozen=True)
class Contact(ActiveConstraint):
    """A monitored point limited by a plane at the critical distance; numbers as in the robot and its planes."""

    plane: int
    point: int


@dataclass(frozen=True)
class ObstacleContact(ActiveConstraint):
    """A body of the arm limited by an obstacle; numbers as in `Robot.bodies` and the obstacles."""

    obstacle: int
    body: int


@dataclass(frozen=True)
class SelfContact(ActiveConstraint):
    """A body of the arm limited by another; numbers as in `Robot.bodies`."""

    first: int
    second: int


@dataclass(frozen=True)
class AtLimit(ActiveConstraint):
    """A joint at its position limit."""

    joint: int


@dataclass(frozen=True)
class AtSpeed(ActiveConstraint):
    """A joint at its speed limit."""

    joint: int


@dataclass(frozen=True)
class AtAcceleration(ActiveConstraint):
    """A joint at its acceleration limit, or slowed down so that it can stop before its position limit."""

    joint: int


@dataclass(frozen=True)
class AtEntryPoint(ActiveConstraint):
    """The instrument limited by its entry point."""


Reason = Contact | ObstacleContact | SelfContact | AtLimit | AtEntryPoint | AtSpeed | AtAcceleration


def reason_of(problem: Problem, row: int, multiplier: float = 0.0) -> Reason:
    """The constraint of one row of `Work.held`.

    The rows: 2 n position limits, the distances of `collision.clearances`, 2 n speeds, 2 n accelerations, the entry
    point.
    """
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
    """The constraints that limited a guarded step at q, ordered by `_ORDER`, then by decreasing multiplier.

    Multipliers up to `NOTICEABLE` times `pull`, the weighted size of the task, do not count: a stretched arm touches
    the limit of its elbow without being limited by it. Position limits count only within `NEAR`, rad or m.
    Args: q (n,), rad or m; multipliers: `Work.held`.
    """
    n = len(q)
    room = np.concatenate((q - problem.limits.lower, problem.limits.upper - q))
    found = [
        reason_of(problem, int(row), float(multipliers[row]))
        for row in np.argsort(-multipliers)
        if multipliers[row] > NOTICEABLE * pull and not (row < 2 * n and room[row] >= NEAR)
    ]
    return tuple(sorted(found, key=lambda reason: _ORDER.index(type(reason))))
