"""A slab that the tool does not leave, after the joint limits of Vargas 2013, §4.7."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from helicoide.ik.secondary import augmented
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import path_1, places
from helicoide.studies.vargas.runs import Run, each, largest
from helicoide.studies.vargas.secondary import ASSUMED, SECONDS, chosen, filtered, follow, tool
from helicoide.studies.vargas.table import (
    FASTEST_AFTER_3,
    Gain,
    Sheet,
    Step,
    is_changed,
    planar_motion,
    rates_chart,
    thinned,
)
from helicoide.studies.vargas.table import SECONDS as IN_SECONDS
from helicoide.text import Text, same

TITLE = Text(en="A slab that the tool does not leave", pt_BR="Uma faixa de onde o efetuador não sai")
SOURCE = "cf. Vargas 2013, §4.7, eq. 4.73"
ABOUT = Text(
    en="""The path swings between y = −0.5 and 0.5, and a barrier asks the tool to stay within |y| < 0.3. Look at y: \
the steeper the barrier the nearer to its face the tool goes, but it never touches it, and x is followed all the \
while.""",
    pt_BR="""O caminho oscila entre y = −0,5 e 0,5, e uma barreira pede que o efetuador fique em |y| < 0,3. Observe \
y: quanto mais íngreme a barreira, mais perto da face o efetuador chega, mas nunca a toca, e x é seguido o tempo \
todo.""",
)
ROBOT = "planar3r"
NOT_THERE = Text(en="not in the source: of the digest", pt_BR="não está na fonte: é da síntese")
# α and k; of the digest: the largest |y| from 3 s on and of all
CASES = {
    (0.0, 10): ("0.500", "0.5"),
    (5.0, 10): ("0.249", "0.249"),
    (1.0, 10): ("0.270", "0.270"),
    (5.0, 3): ("0.178", "0.198"),
}
HALF = 0.3
ALWAYS = Text(en="largest |y|", pt_BR="maior |y|")


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 5.0
    dt: Step = 5e-4


def in_a_slab(weight: float, steepness: int, gain: float, dt: float, seconds: float, progress: Progress) -> Run:
    """|y| < 0.3 asked of the tool on trajectory 1."""
    aiming, across = follow(path_1), {"azimuth": np.pi / 2, "elevation": 0.0, "offset": 0.0, "half": HALF}
    if weight:
        aiming = augmented(planar(), chosen("slab", weight=weight, steepness=steepness, **across), aiming)
    return filtered(aiming, (0.45, -1, 0.4), gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Without a barrier, and with three; for 17 s in the short form."""
    sheet = Sheet(short, is_changed(options))
    dt, seconds = (max(options.dt, 1e-2), 17.0) if short else (options.dt, SECONDS)
    runs = each({key: partial(in_a_slab, *key, options.gain, dt, seconds) for key in CASES}, progress)
    names = {key: same(f"α = {key[0]:g}, k = {key[1]}") for key in CASES}
    rows = [row for key in CASES for row in _rows(sheet, key, runs[key], names[key])]
    kept = runs[5.0, 10]
    heights = tuple(Line(names[key], thinned(one.t), thinned(tool(one, path_1)[:, 1])) for key, one in runs.items())
    wished = Line(Text(en="wished", pt_BR="desejado"), thinned(kept.t), thinned(places(path_1, kept.t)[:, 1]))
    across = Chart(Text(en="across the slab", pt_BR="através da faixa"), IN_SECONDS, same("y, ℓ"), (wished, *heights))
    return Result(tuple(rows), (across, rates_chart(kept, names[5.0, 10])), planar_motion(kept))


def _rows(sheet: Sheet, key: tuple[float, int], run: Run, of: Text) -> list[Row]:
    """|y|, and how the usual barrier is paid for."""
    (later, ever), late, y = CASES[key], run.t >= 3.0, np.abs(tool(run, path_1)[:, 1])
    given: Any = {"source": NOT_THERE, "assumed": ASSUMED}
    after = Text(en="largest |y| after 3 s", pt_BR="maior |y| após 3 s")
    rows = [
        sheet.row(after, of, float(y[late].max()), later, "ℓ", within=6e-4, coarse=0.0, **given),
        sheet.row(ALWAYS, of, float(y.max()), ever, "ℓ", within=6e-4, coarse=0.0, **given),
    ]
    if key == (5.0, 10):
        along = Text(en="largest |e_x| after 3 s", pt_BR="maior |e_x| após 3 s")
        off = largest(run.e[:, 0], late)
        rows += [
            sheet.row(FASTEST_AFTER_3, of, largest(run.rates, late), "0.111", "rad/s", **given),
            sheet.row(along, of, off, "5e-4", "ℓ", within=6e-5, relation="≤", coarse=1.0, **given),
        ]
    return rows
