"""Sim. 5 of Vargas 2013: the planar arm passes near the origin, where it is almost singular."""

from __future__ import annotations

from collections.abc import Mapping

from helicoide.studies.study import Progress, Reading, Result, Row, printed
from helicoide.studies.vargas.paths import path_3, places
from helicoide.studies.vargas.planar import Five as Options
from helicoide.studies.vargas.planar import below, ellipses, followers, ours, result
from helicoide.studies.vargas.runs import Run, sizes
from helicoide.studies.vargas.table import row
from helicoide.text import Text

TITLE = Text(en="Simulation 5: past a singular posture", pt_BR="Simulação 5: rente a uma postura singular")
SOURCE = "Vargas 2013, §3.5, sim. 5, figs. 3.10–3.11; §3.1, fig. 3.1"
ABOUT = Text(
    en="""The path passes the axis of the shoulder at 0.07 of its length, after about 26 s. Look at the joint \
velocities there: the pseudoinverse stays on the path and is the fastest, all others give up some accuracy for slower \
joints. The ellipses show what the joints can do: on the way to the axis they become flat.""",
    pt_BR="""O caminho passa a 0,07 do eixo do ombro após cerca de 26 s. Observe ali as velocidades das juntas: a \
pseudoinversa não sai do caminho e é a mais rápida; todas as outras trocam um pouco de exatidão por juntas mais \
lentas. As elipses mostram o que as juntas conseguem: a caminho do eixo, elas se achatam.""",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

ROBOT = "planar3r"
PATH, START, PLACE = path_3, (0.5, 0.6, 0.6), "sim. 5, figs. 3.10–3.11"
BEGUN = Reading(
    Text(en="start (0.5, 0.6, 0.6), near the path", pt_BR="partida (0,5; 0,6; 0,6), perto do caminho"),
    Text(
        en="it holds from 4 of 20 random starts, since the others begin with faster joints, and from all of 20 within "
        "0.2 rad of it",
        pt_BR="vale em 4 de 20 partidas aleatórias, pois as outras começam com juntas mais rápidas, e em todas as 20 a "
        "menos de 0,2 rad dela",
    ),
)


def statements(runs: Mapping[str, Run]) -> list[Row]:
    """How fast the joints become, and when the path is nearest to the origin."""
    t = runs["damping"].t
    when = float(t[sizes(places(PATH, t)).argmin()])
    nearest = Text(en="desired path nearest to the origin", pt_BR="caminho desejado mais próximo da origem")
    return [*below("< 1.2", PLACE, runs, BEGUN), row(nearest, None, when, "s", printed("≈ 26", PLACE))]


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 3."""
    dt, ways = max(options.dt, 1e-2) if short else options.dt, options.ways
    runs = followers(PATH, START, ways, dt, progress)
    more = (ellipses(PATH, runs["damping"], (2, 10, 18, 24, 26, 28)),)
    return result(statements(runs) + ours(ways, runs), PATH, ways, runs, "figs. 3.10–3.11", more)
