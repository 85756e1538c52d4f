"""Sim. 4 of Vargas 2013: a path of the planar arm without singular postures."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi

from helicoide.studies.study import Interpretation, Progress, Result, Row
from helicoide.studies.vargas.paths import path_2
from helicoide.studies.vargas.planar import (
    COMPARED,
    FITTED,
    LENGTH,
    SINCE,
    VALUES,
    computed_rows,
    planar_result,
    rows_of_both,
    run_on_planar,
)
from helicoide.studies.vargas.planar import FiveMethods as Options
from helicoide.studies.vargas.readings import LINKS
from helicoide.studies.vargas.runs import MethodRun, largest_absolute
from helicoide.studies.vargas.table import ERROR_FROM, TRACKED, run_row, sentence_statement
from helicoide.text import Text

TITLE = Text(en="Simulation 4: nothing in the way", pt_BR="Simulação 4: nada no caminho")
SOURCE = "Vargas 2013, §3.5, sim. 4, figs. 3.8–3.9"
ABOUT = Text(
    en="""Five methods follow a path that stays away from singular postures: the pseudoinverse; damped least squares, \
whose damping δ comes on where J is nearly singular; the feedback, which inverts nothing, but feeds the velocity error \
ν − Jq̇ back; and two filtered inverses. Look at how alike they are: the damping never comes on, so that damped least \
squares is the pseudoinverse, and the filtered inverse has long become it.""",
    pt_BR="""Cinco métodos seguem um caminho longe de posturas singulares: a pseudoinversa; a inversa amortecida, cujo \
amortecimento δ entra onde J é quase singular; a realimentada, que nada inverte, mas realimenta o erro de velocidade ν \
− Jq̇; e duas inversas filtradas. Veja como são parecidos: o amortecimento nunca entra, de modo que a amortecida é a \
pseudoinversa, e a filtrada já se tornou igual a ela.""",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

ROBOT = "planar3r"
PATH, START, PLACE = path_2, (pi / 6, pi / 6, pi / 6), "sim. 4, figs. 3.8–3.9"
BEGUN = Interpretation(
    Text(en="start (π/6, π/6, π/6)", pt_BR="partida (π/6; π/6; π/6)"),
    Text(
        en="the sentences hold from 16 of 20 random starts, and from all of 20 within 0.2 rad of it",
        pt_BR="as frases valem em 16 de 20 partidas aleatórias, e em todas as 20 a menos de 0,2 rad dela",
    ),
)


def following_rows(runs: Mapping[str, MethodRun]) -> list[Row]:
    """That both methods follow, and that the damping never comes on."""
    follows = sentence_statement("both methods track", "ambos os métodos rastreiam", PLACE, TRACKED * LENGTH, "≤")
    errors = {key: largest_absolute(runs[key].error_norm, runs[key].t >= SINCE) for key in COMPARED}
    never = sentence_statement("δ = 0 throughout", "δ = 0 o tempo todo", PLACE, 0.0)
    largest_damping = float(runs["damping"].figure("δ").max())
    return [
        run_row(Text(en="largest damping δ", pt_BR="maior amortecimento δ"), None, largest_damping, "ℓ²", never,
            fitted=(*FITTED["damping"], LINKS, BEGUN)),
        *rows_of_both(ERROR_FROM.format(since=SINCE), errors, "ℓ", follows, LINKS, BEGUN),
    ]  # fmt: skip


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 2."""
    dt, ways = max(options.dt, 1e-2) if short else options.dt, options.methods
    runs = run_on_planar(PATH, START, ways, dt, progress, VALUES.rate)
    return planar_result(following_rows(runs) + computed_rows(ways, runs), PATH, ways, runs, "figs. 3.8–3.9")
