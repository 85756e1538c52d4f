"""Sim. 5 of Vargas 2013: the planar arm passes near the origin, where it is almost singular."""

from __future__ import annotations

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.paths import path_3
from helicoide.studies.vargas.planar import Five as Options
from helicoide.studies.vargas.planar import Found, compared_rows, followers, result, ways_of
from helicoide.studies.vargas.table import Sheet, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 5: past a singular posture", pt_BR="Simulação 5: rente a uma postura singular")
SOURCE = "Vargas 2013, §3.5, sim. 5, figs. 3.10–3.11"
ABOUT = Text(
    en="""The path passes the axis of the shoulder at 0.07 of its length, after about 26 s. Look at the joint \
rates there: the pseudoinverse stays on the path and is the fastest, all others give up some accuracy for slower \
joints.""",
    pt_BR="""O caminho passa a 0,07 do eixo do ombro após cerca de 26 s. Observe ali as velocidades das juntas: a \
pseudoinversa não sai do caminho e é a mais rápida; todas as outras trocam um pouco de exatidão por juntas mais \
lentas.""",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

ROBOT = "planar3r"
START = (0.5, 0.6, 0.6)
FOUND: dict[str, Found] = {
    "pseudoinverse": ("1.84", "7e-5", None, None),
    "damping": ("0.93", "0.187", 0.03, 0.03),
    "feedback": ("1.40", "0.086", None, None),
    "filtered": ("1.19", "0.310", 0.03, 0.03),
    "modified": ("1.73", "0.443", 0.03, 0.03),
}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 3."""
    ways = ways_of(options.gain)
    runs = followers(path_3, START, ways, options.dt, short, progress)
    rows = compared_rows(Sheet(short, is_changed(options)), ways, runs, FOUND, "< 1.2")
    return result(rows, path_3, ways, runs, options.shown)
