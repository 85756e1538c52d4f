"""A recorded motion, played again on the arm."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from helicoide.gate.check import driven, finite
from helicoide.kinematics.chain import frozen
from helicoide.state import Replay, State, Update, commanded
from helicoide.text import HelicoideError, Text

MOST = 200_000


def replay(times: ArrayLike, q: ArrayLike) -> Update:
    """Joint values (k, n), rad or m, at times (k,) that grow, s; the guard keeps every limit on the way."""

    def wish(state: State) -> State:
        n, count = len(state.q), len(np.atleast_1d(times))
        if not 2 <= count <= MOST:
            raise HelicoideError(
                Text(
                    en="A motion has 2 to {most} instants, not {count}.",
                    pt_BR="Um movimento tem de 2 a {most} instantes, não {count}.",
                ).format(most=MOST, count=count)
            )
        at, values = finite(times, (count,)), finite(q, (count, n))
        if not (np.diff(at) > 0).all():
            raise HelicoideError(
                Text(en="The times of a motion must grow.", pt_BR="Os tempos de um movimento devem crescer.")
            )
        return commanded(state, Replay(frozen(at - at[0]), values))

    return driven(wish)
