"""Fig. 4.42 of Vargas 2013: the links make way for an obstacle while the tool keeps to its path."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.method import OneOf
from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.runs import Run, each
from helicoide.studies.vargas.secondary import SECONDS, beside_the_links
from helicoide.studies.vargas.table import (
    NEAREST_AFTER_3,
    WORST_AFTER_3,
    Gain,
    Sheet,
    Step,
    errors_chart,
    is_changed,
    planar_motion,
    rates_chart,
)
from helicoide.text import Text, same

TITLE = Text(en="An obstacle beside the links", pt_BR="Um obstáculo ao lado dos elos")
SOURCE = "Vargas 2013, §4.7, fig. 4.42"
ABOUT = Text(
    en="""The obstacle stands beside the arm, not beside the path. Play the run: with eight points on each link that \
see it, the arm folds out of the way and the tool hardly leaves its path. With the ends of the links alone the \
obstacle slips in between.""",
    pt_BR="""O obstáculo está ao lado do braço, não do caminho. Veja a simulação: com oito pontos em cada elo que o \
percebem, o braço se dobra para dar passagem e o efetuador quase não sai do caminho. Só com as pontas dos elos, o \
obstáculo passa entre elas.""",
)
ROBOT = "planar3r"
ASSUMED = Text(
    en="lengths, start, places of the obstacle, α = 5", pt_BR="comprimentos, partida, lugares do obstáculo, α = 5"
)
# μ and how many points of a link see it; of the digest from 3 s on: least distance and largest error. The errors
# without a term and with one point are ours.
Key = tuple[tuple[float, float], int]
CASES: dict[Key, tuple[str, str]] = {
    ((0.6, 1.15), 0): ("0.084", "1e-4"),
    ((0.6, 1.15), 8): ("0.413", "0.0075"),
    ((0.6, 1.15), 1): ("0.084", "1e-4"),
    ((0.85, 1.55), 0): ("0.151", "1e-4"),
    ((0.85, 1.55), 8): ("0.437", "0.011"),
    ((0.85, 1.55), 1): ("0.337", "0.006"),
    ((1.5, 1.75), 0): ("0.002", "1e-4"),
    ((1.5, 1.75), 8): ("0.409", "0.025"),
    ((1.5, 1.75), 1): ("0.030", "0.017"),
}
SEEN = {
    0: Text(en="nobody looks", pt_BR="ninguém olha"),
    1: Text(en="link ends look", pt_BR="as pontas dos elos olham"),
    8: Text(en="8 points a link look", pt_BR="8 pontos por elo olham"),
}
SHOWN = OneOf(
    Text(en="obstacle of the run that the arm shows", pt_BR="obstáculo da simulação que o braço mostra"),
    {f"{mu[0]:g}, {mu[1]:g}": same(f"μ = ({mu[0]:g}, {mu[1]:g})") for mu, points in CASES if points == 8},
)


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s; shown: the obstacle of the run, seen by eight points a link, that the arm shows."""

    gain: Gain = 5.0
    dt: Step = 1e-3
    shown: Annotated[str, SHOWN] = "0.6, 1.15"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three obstacles, seen by none, one and eight points on each link; for 16 s, half the time, in the short form."""
    sheet, seconds = Sheet(short, is_changed(options)), SECONDS / 2 if short else SECONDS
    dt, distances = max(options.dt, 1e-2) if short else options.dt, {}

    def one(key: Key) -> Callable[[Progress], Run]:
        def go(told: Progress) -> Run:
            found, distances[key] = beside_the_links(*key, options.gain, dt, seconds, told)
            return found

        return go

    runs = each({key: one(key) for key in CASES}, progress)
    rows = []
    names = {key: _name(key) for key in CASES}
    for key, (near, error) in CASES.items():
        found, size = distances[key], float(runs[key].size[runs[key].t >= 3.0 - 1e-9].max())
        coarse = (0.01, 3e-4 / float(error)) if key[0] == (0.6, 1.15) else (None, None)
        rows.append(sheet.row(NEAREST_AFTER_3, names[key], found, near, "ℓ", coarse=coarse[0], assumed=ASSUMED))
        rows.append(
            sheet.row(WORST_AFTER_3, names[key], size, error, "ℓ", within=6e-4, coarse=coarse[1], assumed=ASSUMED)
        )
    shown = next(key for key in CASES if key[1] == 8 and f"{key[0][0]:g}, {key[0][1]:g}" == options.shown)
    charts = (
        errors_chart({names[key]: found for key, found in runs.items()}, "ℓ"),
        rates_chart(runs[shown], names[shown]),
    )
    return Result(tuple(rows), charts, planar_motion(runs[shown]))


def _name(key: Key) -> Text:
    (x, y), points = key
    return Text(en="μ = ({x:g}, {y:g}), {seen}", pt_BR="μ = ({x:g}, {y:g}), {seen}").format(x=x, y=y, seen=SEEN[points])
