"""A simulation of Coutinho as a study: once as the source has it, and once with the drift fed back."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from helicoide.studies._coutinho_rows import (
    NO_FEEDBACK,
    Options,
    charts_of,
    formula_row,
    motion_of,
    rows_of,
    samples_of,
    with_feedback,
)
from helicoide.studies._coutinho_runs import control, run
from helicoide.studies.study import Progress, Result

# What the digest prints of a run, by sample time, ms, and gain Kr, 1/s.
Table = Mapping[tuple[int, float], Mapping[str, str]]
Samples = Mapping[int, tuple[str, str, str, str]]
Formula = tuple[Callable[[float, float, float], float], str]


@dataclass(frozen=True)
class Beginning:
    """The short form of a simulation: its first seconds at 20 ms, and what holds of them."""

    seconds: float
    table: Table


def simulated(
    path: str,
    options: Options,
    short: Beginning | None,
    progress: Progress,
    table: Table,
    formula: Formula,
    samples: Samples | None = None,
) -> Result:
    """Both runs along a path: the whole period, or what `short` says. samples: of the run with feedback at 20 ms."""
    seconds = None
    if short is not None:
        seconds, table, options = short.seconds, short.table, replace(options, step="20")
    step = int(options.step)
    dt = step / 1000
    plain = run(path, control(), dt, seconds=seconds, progress=lambda share: progress(share / 2))
    fed_back = run(
        path, control(options.feedback), dt, seconds=seconds, progress=lambda share: progress((1 + share) / 2)
    )
    name = with_feedback(options.feedback)
    known = (samples or {}) if (step, options.feedback) == (20, 5.0) else {}
    return Result(
        rows=(
            *rows_of(plain, NO_FEEDBACK, table.get((step, 0.0), {})),
            *rows_of(fed_back, name, table.get((step, options.feedback), {})),
            *samples_of(fed_back, dt, known),
            formula_row(plain, dt, *formula),
        ),
        charts=charts_of({NO_FEEDBACK: plain, name: fed_back}),
        motion=motion_of(fed_back),
    )
