"""The commands of an arm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.task import EVERY
from helicoide.text import Text
from helicoide.trajectory import Path
from helicoide.trajectory.path import JointPath
from helicoide.trajectory.time_optimal import TimingShape

THE_PATH = Text(en="the path", pt_BR="a trajetória")


@dataclass(frozen=True)
class HoldPosition:
    """Hold the present position. stopped: after a stop, which also holds the gripper."""

    stopped: bool = False


@dataclass(frozen=True, eq=False)
class MoveToPose:
    """Bring the tool to T_world_target (4, 4), m.

    snaps: whether the target moves to the accepted goal after the search for another posture.
    """

    T_world_target: Array
    snaps: bool = False


@dataclass(frozen=True, eq=False)
class MoveToJoints:
    """Bring the joints to q (n,), rad or m. first_to_stop: the joint that yields first to a constraint, or EVERY."""

    q: Array
    first_to_stop: int = EVERY


@dataclass(frozen=True)
class PathChoice:
    """The path that Play follows.

    name: its key among the paths of the arm, None for the first; shape: its time scaling; duration, s, None for its own
    duration.
    """

    name: str | None = None
    shape: TimingShape = "constant speed"
    duration: float | None = None


@dataclass(frozen=True)
class FollowPath:
    """Follow a path from its parameter s, s.

    The parameter waits until the arm has arrived at the path, or cannot come nearer. nearest: smallest distance to the
    path so far, m; waiting_since: time without coming nearer, s.
    """

    path: Path
    s: float
    playing: bool
    arrived: bool = False
    nearest: float = np.inf
    waiting_since: float = 0.0
    title: Text = THE_PATH


@dataclass(frozen=True, eq=False)
class Replay:
    """Replay a joint path from its parameter s, s, after a motion to its start.

    title: shown in the status; slows_down: whether time slows down where the arm cannot keep up; gripper_events: pairs
    of a parameter s, s, and the target opening of the gripper from there on, 0 closed to 1 open.
    """

    path: JointPath
    title: Text
    slows_down: bool = True
    gripper_events: tuple[tuple[float, float], ...] = ()
    s: float = 0.0
    arrived: bool = False


@dataclass(frozen=True)
class Park:
    """Go to `ready`, then to `home` with the planes off."""


@dataclass(frozen=True)
class GetReady:
    """Go to `ready`; if the arm is parked, with the planes off."""


Command = HoldPosition | MoveToPose | MoveToJoints | FollowPath | Replay | Park | GetReady
