"""A simulation of Coutinho as a study: once as the source has it, and once with the drift fed back."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.branch import tool_at
from helicoide.studies._coutinho_rows import NO_FEEDBACK, Options, charts_of, motions_of, rows_of, with_feedback
from helicoide.studies._coutinho_runs import Run, control, dia10, run
from helicoide.studies.study import Progress, Result, Row

# The short form takes the whole path, at 100 ms.
SHORT = 0.1


def simulated(
    path: str,
    options: Options,
    short: bool,
    progress: Progress,
    stated: Callable[[Run, float], Sequence[Row]],
    figures: str,
    depth: str,
) -> Result:
    """Both runs along a path; what the source states is about the first.

    stated: its rows, by that run and its sample time, s; figures: those in which the source shows the run; depth: that
    of l_a.
    """
    dt = SHORT if short else int(options.step) / 1000
    gains = {0.0: NO_FEEDBACK, options.feedback: with_feedback(options.feedback)}
    runs = {
        which: run(path, control(gain), dt, progress=part(progress, done, len(gains)))
        for done, (gain, which) in enumerate(gains.items())
    }
    plain, *others = runs.items()
    return Result(
        rows=(
            *stated(plain[1], dt),
            *rows_of(plain[1], plain[0], dt, figures),
            *(one for which, got in others for one in rows_of(got, which, dt, names=("tip", "lateral"))),
        ),
        charts=charts_of(runs, charted(figures, depth)),
        motions=motions_of(runs),
    )


def part(progress: Progress, done: int, parts: int) -> Progress:
    """The progress of one of several runs, as a part of the whole."""
    return lambda share: progress((done + share) / parts)


def charted(figures: str, depth: str) -> dict[str, str]:
    """The curves of a simulation with the figures of the source beside which they stand."""
    names = ("tip", "entry", "command", "outside", "rate", "q7", "w", "lateral")
    return {name: depth if name == "outside" else figures for name in names}


def displaced_mm(got: Run) -> Array:
    """Where the tool of a run is at its times t_w from its start, along its axes there, (k, 3), mm."""
    poses = np.array([tool_at(dia10(), q) for q in got["q"]])
    return np.asarray(1e3 * (poses[:, :3, 3] - poses[0, :3, 3]) @ poses[0, :3, :3])
