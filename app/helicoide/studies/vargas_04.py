"""Sim. 4 of Vargas 2013: a path of the planar arm without singular postures."""

from __future__ import annotations

from math import pi

from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.paths import path_2
from helicoide.studies.vargas.planar import DAMPING, Found, compared_rows, followers, result, ways_of
from helicoide.studies.vargas.planar import Five as Options
from helicoide.studies.vargas.runs import largest
from helicoide.studies.vargas.table import APART, Sheet, is_changed
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
START = (pi / 6, pi / 6, pi / 6)
FOUND: dict[str, Found] = {
    "pseudoinverse": ("0.0469", "1.1e-4", 0.01, 1.0),
    "damping": ("0.0469", "1.1e-4", 0.01, 1.0),
    "feedback": ("0.0469", "2.3e-4", 0.01, 1.0),
    "filtered": ("0.0470", "9.7e-5", 0.01, 1.0),
    "modified": ("0.0470", "1.1e-4", 0.01, 1.0),
}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 2."""
    ways = ways_of(options.gain)
    runs = followers(path_2, START, ways, options.dt, short, progress)
    sheet = Sheet(short, is_changed(options))
    rows = compared_rows(sheet, ways, runs, FOUND)
    alike = largest(runs["damping"].q - runs["pseudoinverse"].q)
    rows += (sheet.row(APART, DAMPING.title, alike, "0", "rad", within=1e-12, coarse=0.0),)
    return result(rows, path_2, ways, runs, options.shown)
