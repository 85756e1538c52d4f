"""Sim. 5 of Vargas 2013: the planar arm passes near the origin, where it is almost singular."""

from __future__ import annotations

from collections.abc import Mapping

from helicoide.studies.study import Interpretation, Progress, Result, Row, printed_statement
from helicoide.studies.vargas.paths import path_3, path_points
from helicoide.studies.vargas.planar import FiveMethods as Options
from helicoide.studies.vargas.planar import (
    computed_rows,
    ellipse_chart,
    planar_result,
    run_on_planar,
    velocity_bound_rows,
)
from helicoide.studies.vargas.readings import LINKS
from helicoide.studies.vargas.runs import MethodRun, row_norms
from helicoide.studies.vargas.table import run_row
from helicoide.text import Text

TITLE = Text(en="Simulation 5: past a singular posture", pt_BR="Simulação 5: rente a uma postura singular")
SOURCE = "Vargas 2013, §3.5, sim. 5, figs. 3.10–3.11; §3.1, fig. 3.1"
ABOUT = Text(
    en="""The path passes the axis of the shoulder at a distance of 0.07 ℓ, after about 26 s. Look at the joint \
velocities there: the pseudoinverse stays on the path and is the fastest, all others give up accuracy for slower \
joints, the filtered inverses up to 0.54 ℓ, 13 % of the reach. The ellipses show what the joints can do: on the way to \
the axis they become flat.""",
    pt_BR="""O caminho passa a 0,07 ℓ do eixo do ombro após cerca de 26 s. Observe ali as velocidades das juntas: a \
pseudoinversa não sai do caminho e é a mais rápida; todas as outras trocam exatidão por juntas mais lentas, as \
filtradas até 0,54 ℓ, 13 % do alcance. As elipses mostram o que as juntas conseguem: a caminho do eixo, elas se \
achatam.""",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

ROBOT = "planar3r"
PATH, START, PLACE = path_3, (0.5, 0.6, 0.6), "sim. 5, figs. 3.10–3.11"
BEGUN = Interpretation(
    Text(en="start (0.5, 0.6, 0.6), near the path", pt_BR="partida (0,5; 0,6; 0,6), perto do caminho"),
    Text(
        en="it holds from 4 of 20 random starts, since the others begin with faster joints, and from all of 20 within "
        "0.2 rad of it",
        pt_BR="vale em 4 de 20 partidas aleatórias, pois as outras começam com juntas mais rápidas, e em todas as 20 a "
        "menos de 0,2 rad dela",
    ),
)


def velocity_rows(runs: Mapping[str, MethodRun]) -> list[Row]:
    """How fast the joints become, and when the path is nearest to the origin."""
    t = runs["damping"].t
    when = float(t[row_norms(path_points(PATH, t)).argmin()])
    nearest = Text(en="desired path nearest to the origin", pt_BR="caminho desejado mais próximo da origem")
    return [
        *velocity_bound_rows("< 1.2", PLACE, runs, LINKS, BEGUN),
        run_row(nearest, None, when, "s", printed_statement("≈ 26", PLACE)),
    ]


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 3."""
    dt, ways = max(options.dt, 1e-2) if short else options.dt, options.methods
    runs = run_on_planar(PATH, START, ways, dt, progress)
    more = (ellipse_chart(PATH, runs["damping"], (2, 10, 18, 24, 26, 28)),)
    return planar_result(velocity_rows(runs) + computed_rows(ways, runs), PATH, ways, runs, "figs. 3.10–3.11", more)
