"""A straight rod through an entry point, its tip on a circle."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from helicoide.studies._coutinho_circle import PERIOD, ROBOT, run_circle_once
from helicoide.studies._coutinho_rows import (
    BY_STEP,
    NO_FEEDBACK,
    OF,
    TIME,
    Options,
    peaks,
    run_motions,
    with_feedback,
)
from helicoide.studies._coutinho_runs import Run
from helicoide.studies._coutinho_simulation import SHORT, share_of_progress
from helicoide.studies.study import Chart, ChartLine, Progress, Result, Row
from helicoide.text import Text, untranslated

TITLE = Text(en="A circle through an entry point", pt_BR="Um círculo através de um ponto de entrada")
SOURCE = "Coutinho 2015, cf. §3.4, §5.1"
ABOUT = Text(
    en="An example of ours, which the source does not have: most arms have no wrist beyond the entry point, only a "
    "straight rod, whose tip can be led anywhere, but not turned. The tip goes once around a circle of 30 mm radius; "
    "afterwards the joints are not quite where they were, since two of the seven are free to drift.",
    pt_BR="Um exemplo nosso, que a fonte não tem: a maioria dos braços não tem punho além do ponto de entrada, só uma "
    "haste reta, cuja ponta pode ser levada a qualquer lugar, mas não girada. A ponta dá uma volta num círculo de "
    "30 mm de raio; depois as juntas não voltam bem ao lugar, pois duas das sete ficam livres para derivar.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

BY_ITS_STEP = ("tip", "rms", "lateral", "end")
QUANTITIES: Mapping[str, tuple[Text, str]] = {
    "tip": (Text(en="largest error of the tip", pt_BR="maior erro da ponta"), "mm"),
    "rms": (Text(en="error of the tip, root mean square", pt_BR="erro da ponta, valor eficaz"), "mm"),
    "lateral": (
        Text(
            en="largest distance of the rod from the entry point", pt_BR="maior distância da haste ao ponto de entrada"
        ),
        "mm",
    ),
    "end": (Text(en="the same at the end", pt_BR="a mesma no fim"), "mm"),
    "depth_min": (Text(en="smallest depth of the tip", pt_BR="menor profundidade da ponta"), "m"),
    "depth_max": (Text(en="largest depth of the tip", pt_BR="maior profundidade da ponta"), "m"),
    "rate": (Text(en="largest joint velocity", pt_BR="maior velocidade de junta"), "rad/s"),
    "of_limits": (Text(en="largest share of a joint's limit", pt_BR="maior fração de um limite de junta"), ""),
    "sigma": (Text(en="smallest singular value of J_a", pt_BR="menor valor singular de J_a"), ""),
    "closure": (Text(en="joints after the turn, from the start", pt_BR="juntas após a volta, até o início"), "rad"),
}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both turns; short: at 100 ms."""
    dt = SHORT if short else int(options.step) / 1000
    gains = {0.0: NO_FEEDBACK, options.feedback: with_feedback(options.feedback)}
    runs = {
        which: run_circle_once(gain, dt, PERIOD, share_of_progress(progress, done, len(gains)))
        for done, (gain, which) in enumerate(gains.items())
    }
    return Result(
        rows=tuple(one for which, got in runs.items() for one in _rows(got, which, dt)),
        charts=_charts(runs),
        motions=run_motions(runs, ROBOT),
    )


def _rows(got: Run, which: Text, dt: float) -> list[Row]:
    values = {
        "tip": got["tip_mm"].max(),
        "rms": np.sqrt(np.mean(got["tip_mm"] ** 2)),
        "lateral": got["lateral_mm"].max(),
        "end": got["lateral_mm"][-1],
        "depth_min": got["depth"].min(),
        "depth_max": got["depth"].max(),
        "rate": got["rate"].max(),
        "of_limits": got["of_limits"].max(),
        "sigma": got["smallest_sigma"].min(),
        "closure": got["closure"][-1],
    }
    found = []
    for name, (title, unit) in QUANTITIES.items():
        title = BY_STEP.format(what=title, step=1e3 * dt) if name in BY_ITS_STEP else title
        found.append(Row(OF.format(what=title, which=which), float(values[name]), unit))
    return found


CURVES = {
    "tip_mm": (Text(en="Error of the tip", pt_BR="Erro da ponta"), untranslated("|e_p|, mm")),
    "lateral_mm": (
        Text(en="Distance of the rod from the entry point", pt_BR="Distância da haste ao ponto de entrada"),
        untranslated("|e_r|, mm"),
    ),
    "depth": (Text(en="Depth of the tip", pt_BR="Profundidade da ponta"), untranslated("m")),
}


def _charts(runs: Mapping[Text, Run]) -> tuple[Chart, ...]:
    return tuple(
        Chart(
            title,
            TIME,
            up,
            tuple(ChartLine(which, *peaks(got["t"], got[name])) for which, got in runs.items()),
            log=name == "lateral_mm",
        )
        for name, (title, up) in CURVES.items()
    )
