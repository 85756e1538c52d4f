"""Sim. 4 of Vargas 2013: a path of the planar arm without singular postures."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi

from helicoide.studies.study import Progress, Reading, Result, Row
from helicoide.studies.vargas.paths import path_2
from helicoide.studies.vargas.planar import COMPARED, FITTED, LENGTH, SINCE, VALUES, followers, of_both, ours, result
from helicoide.studies.vargas.planar import Five as Options
from helicoide.studies.vargas.runs import Run, largest
from helicoide.studies.vargas.table import ERROR_FROM, TRACKED, row, stated
from helicoide.text import Text

TITLE = Text(en="Simulation 4: nothing in the way", pt_BR="Simulação 4: nada no caminho")
SOURCE = "Vargas 2013, §3.5, sim. 4, figs. 3.8–3.9"
ABOUT = Text(
    en="""Five methods follow a path that stays away from singular postures. Look at how alike they are: the damping \
never comes on, so that damped least squares is the pseudoinverse, and the filtered inverse has long become it.""",
    pt_BR="""Cinco métodos seguem um caminho longe de posturas singulares. Veja como são parecidos: o amortecimento \
nunca entra, de modo que os mínimos quadrados amortecidos são a pseudoinversa, e a inversa filtrada já se tornou \
igual a ela.""",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

ROBOT = "planar3r"
PATH, START, PLACE = path_2, (pi / 6, pi / 6, pi / 6), "sim. 4, figs. 3.8–3.9"
BEGUN = Reading(
    Text(en="start (π/6, π/6, π/6)", pt_BR="partida (π/6; π/6; π/6)"),
    Text(
        en="the sentences hold from 16 of 20 random starts, and from all of 20 within 0.2 rad of it",
        pt_BR="as frases valem em 16 de 20 partidas aleatórias, e em todas as 20 a menos de 0,2 rad dela",
    ),
)


def statements(runs: Mapping[str, Run]) -> list[Row]:
    """That both methods follow, and that the damping never comes on."""
    follows = stated("both methods track", "ambos os métodos rastreiam", PLACE, TRACKED * LENGTH, "≤")
    errors = {key: largest(runs[key].size, runs[key].t >= SINCE) for key in COMPARED}
    never = stated("δ = 0 throughout", "δ = 0 o tempo todo", PLACE, 0.0)
    largest_damping = float(runs["damping"].figure("δ").max())
    return [
        row(Text(en="largest damping δ", pt_BR="maior amortecimento δ"), None, largest_damping, "ℓ²", never,
            fitted=(*FITTED["damping"], BEGUN)),
        *of_both(ERROR_FROM.format(since=SINCE), errors, "ℓ", follows, BEGUN),
    ]  # fmt: skip


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 2."""
    dt, ways = max(options.dt, 1e-2) if short else options.dt, options.ways
    runs = followers(PATH, START, ways, dt, progress, VALUES.rate)
    return result(statements(runs) + ours(ways, runs), PATH, ways, runs, "figs. 3.8–3.9")
