"""A simulation of Coutinho 2015 as a study: as in the source, and with drift feedback."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.postures.branch import tool_at
from helicoide.studies._coutinho_rows import NO_FEEDBACK, Options, measure_rows, run_charts, run_motions, with_feedback
from helicoide.studies._coutinho_runs import Run, dia10, run_path, source_control
from helicoide.studies.study import Progress, Result, Row

# Sample time of a quick run, s; it covers the whole path.
SHORT = 0.1


@dataclass(frozen=True)
class Simulation:
    """A simulation of the source: the name of its path, its rows, and the figures that show it.

    stated: the rows, from a run and its sample time, s; figures: of the run; depth: the figure of l_a.
    """

    path: str
    stated: Callable[[Run, float], Sequence[Row]]
    figures: str
    depth: str


def simulation_result(simulation: Simulation, options: Options, short: bool, progress: Progress) -> Result:
    """Both runs of a simulation, without and with drift feedback; the statements of the source are about the first."""
    dt = SHORT if short else int(options.step) / 1000
    gains = {0.0: NO_FEEDBACK, options.feedback: with_feedback(options.feedback)}
    runs = {
        which: run_path(
            simulation.path, source_control(gain), dt, progress=share_of_progress(progress, done, len(gains))
        )
        for done, (gain, which) in enumerate(gains.items())
    }
    plain, *others = runs.items()
    return Result(
        rows=(
            *simulation.stated(plain[1], dt),
            *measure_rows(plain[1], plain[0], dt, simulation.figures),
            *(one for which, got in others for one in measure_rows(got, which, dt, names=("tip", "lateral"))),
        ),
        charts=run_charts(runs, curve_figures(simulation.figures, simulation.depth)),
        motions=run_motions(runs),
    )


def share_of_progress(progress: Progress, done: int, parts: int) -> Progress:
    """The progress of one of `parts` runs, as a part of the whole."""
    return lambda share: progress((done + share) / parts)


def curve_figures(figures: str, depth: str) -> dict[str, str]:
    """The curves of a simulation, each with the figure of the source to compare with."""
    names = ("tip", "entry", "command", "outside", "rate", "q7", "w", "lateral")
    return {name: depth if name == "outside" else figures for name in names}


def tool_displacement(got: Run) -> Array:
    """The displacement of the tool at times t_w, (k, 3), mm, in the axes of its initial frame."""
    poses = np.array([tool_at(dia10(), q) for q in got["q"]])
    return np.asarray(1e3 * (poses[:, :3, 3] - poses[0, :3, 3]) @ poses[0, :3, :3])
