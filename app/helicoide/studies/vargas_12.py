"""Sim. 12 of Vargas 2013: a path that leaves the workspace, by the filtered inverse and the others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from helicoide.studies.study import Progress, Result, Row
from helicoide.studies.vargas.arm import DAMPING, PSEUDOINVERSE, dips, followers, hertz, result, unreachable
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.paths import path_8
from helicoide.studies.vargas.reach import Found, reach_rows
from helicoide.studies.vargas.runs import Run, Way, largest, way
from helicoide.studies.vargas.table import FASTEST_LATER, Gain, Sheet, Step, choice, is_changed
from helicoide.text import Text

TITLE = Text(en="Simulation 12: out of reach", pt_BR="Simulação 12: fora do alcance")
SOURCE = "Vargas 2013, §4.5, sim. 12, figs. 4.20–4.27"
ABOUT = Text(
    en="""For a quarter of the time the path is up to 13 mm beyond the stretched arm. Look at what the elbow does \
there: with the filtered inverse it swings through the stretched arm again and again, faster and by less the larger γ \
is. Damped least squares races when the damping comes on, and takes a long way back to the path.""",
    pt_BR="""Durante um quarto do tempo o caminho fica até 13 mm além do braço esticado. Observe o cotovelo: com a \
inversa filtrada ele oscila através do braço esticado, mais rápido e com menor amplitude quanto maior γ. Os mínimos \
quadrados amortecidos disparam quando o amortecimento entra e fazem um grande desvio na volta.""",
)
ROBOT = "zebra_zero"
LATE = ("0.20", "0.12", "0.05")
FOUND = {
    "damping": Found("45.0", "3.74", "0.851", ("0.57", "1.21", "2.66"), "372", None, (None, None, None, None)),
    "filtered_1": Found("1.07", "0.137", "0.030", ("0.13", "0.10", "0.04"), "1.2", "10", (0.02, None, None, None)),
    "filtered_25": Found("2.21", "0.320", "0.046", LATE, "1.1", "89", (0.02, 0.02, None, 0.05)),
}
# depth of the first dip, cm, and how often a second the elbow swings
SWINGS = {"filtered_1": ("0.135", "1.3"), "filtered_5": ("0.056", "2.9"), "filtered_25": ("0.024", "6.6")}
DIP = Text(en="first dip behind the border", pt_BR="primeiro recuo atrás da fronteira")
SWING = Text(en="swings of the elbow", pt_BR="oscilação do cotovelo")


def ways_of(gain: float) -> dict[str, Way]:
    """The filtered inverse with γ and five and twenty-five times it, and the others."""
    filtered = {
        f"filtered_{times}": way("filtered", f"γ = {times * gain:g}", gain=times * gain) for times in (1, 5, 25)
    }
    return {"pseudoinverse": PSEUDOINVERSE, "damping": DAMPING, **filtered}


@dataclass(frozen=True)
class Options:
    """gain: the smallest γ, 1/(cm² s); dt, s; shown: whose motion the arm shows."""

    gain: Gain = 1.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(1.0))] = "filtered_1"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 8 for 20 s, 15 s in the short form."""
    ways, sheet = ways_of(options.gain), Sheet(short, is_changed(options))
    dt, seconds = (max(options.dt, 2e-3), 15.0) if short else (options.dt, 20.0)
    runs = followers(path_8, FOLDED, ways, dt, seconds, progress)
    rows = [row for key, found in FOUND.items() for row in reach_rows(sheet, ways[key], runs[key], found)]
    for key, (dip, often) in SWINGS.items():
        of, run = ways[key].title, runs[key]
        rows.append(sheet.row(DIP, of, float(dips(run)[1][0]), dip, "cm", within=0.04 * float(dip), coarse=0.15))
        rows.append(sheet.row(SWING, of, hertz(run), often, "Hz", within=0.1 * float(often), coarse=0.1))
    rows += _undamped(sheet, runs["pseudoinverse"])
    beyond = Text(en="largest error out of reach, never less than", pt_BR="maior erro fora do alcance, nunca menor que")
    out = runs["damping"].t >= 11
    out &= unreachable(runs["damping"].t)
    far = largest(runs["damping"].size, out)
    rows.append(sheet.row(beyond, DAMPING.title, far, "1.27", "cm", within=6e-3, relation="≥", coarse=0.0))
    return result(rows, ways, runs, options.shown)


def _undamped(sheet: Sheet, run: Run) -> list[Row]:
    """Rounding decides how near to the singularity the pseudoinverse steps: its peak is of the order of 1281 rad/s."""
    of, later = PSEUDOINVERSE.title, run.t >= 5
    inside = later & ~unreachable(run.t)
    error = Text(en="largest error where the path is within reach", pt_BR="maior erro onde o caminho está ao alcance")
    return [
        sheet.row(FASTEST_LATER, of, largest(run.rates, later), "1281", "rad/s", within=881, relation="≥"),
        sheet.row(error, of, largest(run.size, inside), "0.33", "cm", within=0.066),
    ]
