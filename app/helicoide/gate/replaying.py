"""A path of the joints that is played on the arm: one that was taught, or what an arm did in a study."""

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
    """A path of this arm's joints; the guard keeps every limit on the way. grips: as in `Replay`."""

    def change(state: State) -> State:
        finite(path.q(0.0), state.arm.q.shape)
        return with_command(state, Replay(path, title, gripper_events=grips))

    return driven(change)


def replay_motion(times: ArrayLike, q: ArrayLike, title: Text) -> Update:
    """Joint values (k, n), rad or m, at times (k,) that rise, s, by a spline through at most `KNOTS` of them.

    Where the guard holds the arm back, it lags behind: the time goes on as it did.
    """

    def change(state: State) -> State:
        n, count = len(state.arm.q), len(np.atleast_1d(times))
        if not 2 <= count <= MOST:
            raise HelicoideError(
                Text(
                    en="A motion has 2 to {most} instants, not {count}.",
                    pt_BR="Um movimento tem de 2 a {most} instantes, não {count}.",
                ).format(most=MOST, count=count)
            )
        kept = np.unique(np.linspace(0, count - 1, min(count, KNOTS)).round().astype(int))
        at, values = finite(times, (count,))[kept], finite(q, (count, n))[kept]
        return with_command(state, Replay(JointSpline(frozen(at - at[0]), frozen(values)), title, slows_down=False))

    return driven(change)
