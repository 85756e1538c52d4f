"""Joint paths that the arm replays: taught waypoints, or a motion recorded in a study."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import frozen
from helicoide.command import Replay
from helicoide.gate.check import driven, finite
from helicoide.state import State, Update, with_command
from helicoide.text import HelicoideError, Text
from helicoide.trajectory.path import JointPath
from helicoide.trajectory.spline import JointSpline

MOST, KNOTS = 500_000, 1500


def replay(path: JointPath, title: Text, grips: tuple[tuple[float, float], ...] = ()) -> Update:
    """Replay a joint path of this arm under all limits of the guarded step. grips: `Replay.gripper_events`."""

    def change(state: State) -> State:
        finite(path.q(0.0), state.arm.q.shape)
        return with_command(state, Replay(path, title, gripper_events=grips))

    return driven(change)


def replay_motion(times: ArrayLike, q: ArrayLike, title: Text) -> Update:
    """Replay joint values q (k, n), rad or m, at increasing times (k,), s: a spline through at most `KNOTS` of them.

    Time does not slow down: an arm that is limited lags behind.
    """

    def change(state: State) -> State:
        n, count = len(state.arm.q), len(np.atleast_1d(times))
        if not 2 <= count <= MOST:
            raise HelicoideError(
                Text(
                    en="A motion has 2 to {most} samples, not {count}.",
                    pt_BR="Um movimento tem de 2 a {most} amostras, não {count}.",
                ).format(most=MOST, count=count)
            )
        kept = np.unique(np.linspace(0, count - 1, min(count, KNOTS)).round().astype(int))
        at, values = finite(times, (count,))[kept], finite(q, (count, n))[kept]
        return with_command(state, Replay(JointSpline(frozen(at - at[0]), frozen(values)), title, slows_down=False))

    return driven(change)
