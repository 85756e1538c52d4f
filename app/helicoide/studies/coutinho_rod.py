"""A straight rod through an entry point, its tip on a circle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from helicoide.studies._coutinho_circle import PERIOD, ROBOT, turn
from helicoide.studies._coutinho_rows import NO_FEEDBACK, OF, TIME, Options, row, thinned, with_feedback
from helicoide.studies._coutinho_runs import Run
from helicoide.studies.study import Chart, Line, Motion, Progress, Result, Row
from helicoide.text import Text, same

TITLE = Text(en="A circle through an entry point", pt_BR="Um círculo através de um ponto de entrada")
SOURCE = "cf. Coutinho 2015, §3.4, §5.1"
ABOUT = Text(
    en="Most arms have no wrist beyond the entry point, only a straight rod: then the tip can be led anywhere, but not "
    "turned. The tip goes once around a circle of 30 mm radius; afterwards the joints are not quite where they were, "
    "since two of the seven are free to drift.",
    pt_BR="A maioria dos braços não tem punho além do ponto de entrada, só uma haste reta: a ponta então pode ser "
    "levada a qualquer lugar, mas não girada. A ponta dá uma volta num círculo de 30 mm de raio; depois as juntas não "
    "voltam bem ao lugar, pois duas das sete ficam livres para derivar.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

OURS = Text(en="not in the source: the digest's own example", pt_BR="não está na fonte: exemplo da própria síntese")
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
    "rate": (Text(en="largest joint rate", pt_BR="maior velocidade de junta"), "rad/s"),
    "of_limits": (Text(en="largest share of a joint's limit", pt_BR="maior fração de um limite de junta"), ""),
    "sigma": (Text(en="smallest singular value of J_a", pt_BR="menor valor singular de J_a"), ""),
    "closure": (Text(en="joints after the turn, from the start", pt_BR="juntas após a volta, até o início"), "rad"),
}
_ALIKE = {"depth_min": "0.1500", "depth_max": "0.1616", "rate": "0.287"}
# By sample time, ms, and gain Kr, 1/s. The digest's 0.616 of the limits is that with feedback, or at 2 ms.
TABLE: Mapping[tuple[int, float], Mapping[str, str]] = {
    (20, 0.0): {
        "tip": "0.047", "rms": "0.021", "lateral": "0.473", "end": "0.395", "of_limits": "0.615", "sigma": "0.020",
        "closure": "0.22", **_ALIKE,
    },
    (20, 5.0): {
        "tip": "0.047", "rms": "0.021", "lateral": "0.028", "end": "0.0065", "of_limits": "0.616", "sigma": "0.020",
        "closure": "0.22", **_ALIKE,
    },
    (2, 0.0): {"tip": "0.0047", "rms": "0.0021", "lateral": "0.047", "end": "0.039", **_ALIKE},
    (2, 5.0): {"tip": "0.0047", "rms": "0.0021", "lateral": "0.0028", "end": "0.0007", **_ALIKE},
}  # fmt: skip
LAST = {"end": 0.6}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Both turns; short: at 20 ms."""
    chosen = replace(options, step="20") if short else options
    step = int(chosen.step)
    gains = {0.0: NO_FEEDBACK, chosen.feedback: with_feedback(chosen.feedback)}
    runs = {
        gain: turn(gain, step / 1000, PERIOD, lambda share, done=done: progress((done + share) / len(gains)))  # type: ignore[misc]
        for done, gain in enumerate(gains)
    }
    rows = [one for gain, got in runs.items() for one in _rows(got, gains[gain], TABLE.get((step, gain), {}))]
    shown = runs[chosen.feedback]
    return Result(tuple(rows), _charts({gains[gain]: got for gain, got in runs.items()}), _motion(shown))


def _rows(got: Run, which: Text, printed: Mapping[str, str]) -> list[Row]:
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
    return [
        row(OF.format(what=title, which=which), values[name], printed.get(name), unit, LAST.get(name, 0.55), OURS)
        for name, (title, unit) in QUANTITIES.items()
    ]


CURVES = {
    "tip_mm": (Text(en="Error of the tip", pt_BR="Erro da ponta"), same("|e_p|, mm")),
    "lateral_mm": (
        Text(en="Distance of the rod from the entry point", pt_BR="Distância da haste ao ponto de entrada"),
        same("|e_r|, mm"),
    ),
    "depth": (Text(en="Depth of the tip", pt_BR="Profundidade da ponta"), same("m")),
}


def _charts(runs: Mapping[Text, Run]) -> tuple[Chart, ...]:
    return tuple(
        Chart(title, TIME, up, tuple(Line(which, *thinned(got["t"], got[name])) for which, got in runs.items()))
        for name, (title, up) in CURVES.items()
    )


def _motion(got: Run) -> Motion:
    return Motion(ROBOT, got["t_w"], got["q"])
