"""What an arm may be asked to do."""

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
    """Nothing moves."""

    stopped: bool = False


@dataclass(frozen=True, eq=False)
class MoveToPose:
    """Bring the tool to T_world_target (4, 4), m.

    snaps: whether the target goes to where the arm can come, once that has been searched for.
    """

    T_world_target: Array
    snaps: bool = False


@dataclass(frozen=True, eq=False)
class MoveToJoints:
    """Bring the joints to q (n,), rad; `first_to_stop`: the joint that stops first at a plane, or every one alike."""

    q: Array
    first_to_stop: int = EVERY


@dataclass(frozen=True)
class PathChoice:
    """The path that Play follows: its key among those of the arm, its time scaling, and how long it takes, s.

    None: the first of the arm, and as long as it takes of its own.
    """

    name: str | None = None
    shape: TimingShape = "constant speed"
    duration: float | None = None


@dataclass(frozen=True)
class FollowPath:
    """Follow a path from its parameter s, s; the parameter waits until the arm has come to the path.

    nearest: how near it has come so far, m; waiting_since: since when it has come no nearer, s;
    title: what the path is called.
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
    """Go along a path of the joints from s on, after coming to where it begins; title: what is said of it.

    slows_down: whether its time slows down where the arm cannot keep up; gripper_events: what the gripper is asked to
    be, 0 closed to 1 open, from which s on.
    """

    path: JointPath
    title: Text
    slows_down: bool = True
    gripper_events: tuple[tuple[float, float], ...] = ()
    s: float = 0.0
    arrived: bool = False


@dataclass(frozen=True)
class Park:
    """Go to `ready`, then with the planes off to `home`."""


@dataclass(frozen=True)
class GetReady:
    """Go to `ready`; from `home` with the planes off."""


Command = HoldPosition | MoveToPose | MoveToJoints | FollowPath | Replay | Park | GetReady
