"""Sim. 6 of Vargas 2013: the stretched planar arm is asked to draw in along itself, which no joint can begin."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi
from typing import Annotated, Any

from helicoide.studies.study import Progress, Result, Row
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import path_4
from helicoide.studies.vargas.planar import ASSUMED, DAMPING, FED_BACK, FEEDBACK
from helicoide.studies.vargas.runs import IN_PLANE, Run, Way, each, largest, left_at, record, tracking, way
from helicoide.studies.vargas.table import (
    Gain,
    Sheet,
    Step,
    choice,
    errors_chart,
    is_changed,
    planar_motion,
    rates_chart,
    titled,
)
from helicoide.text import Text

TITLE = Text(en="Simulation 6: a singular start", pt_BR="Simulação 6: partida singular")
SOURCE = "Vargas 2013, §3.5, sim. 6, figs. 3.12–3.13"
ABOUT = Text(
    en="""The arm is stretched, and the path leads straight inwards: at first no joint moves the tool that way. \
Look at who leaves: damped least squares and the modified filtered inverse never do, since their answer has no \
part along the lost direction. A coupling of the rows leaves, and so does the filtered inverse whose Θ is not \
zero at the start.""",
    pt_BR="""O braço está esticado e o caminho aponta direto para dentro: no início nenhuma junta move o efetuador \
nessa direção. Veja quem sai: os mínimos quadrados amortecidos e a inversa filtrada modificada nunca saem, pois sua \
resposta não tem componente na direção perdida. O acoplamento das linhas sai, e também a inversa filtrada cujo Θ \
inicial não é zero.""",
)
ROBOT = "planar3r"
START = (pi / 2, 0, 0)
LEAVES = Text(en="some joint has moved by 0.01 rad after", pt_BR="alguma junta moveu 0,01 rad após")
STAYS = Text(en="largest motion of a joint", pt_BR="maior movimento de uma junta")
# What the digest has, s, for those that leave at once, and for those that leave by rounding alone: other orders of
# adding differ by seconds, so that only leaving later than 2 s is held, and later than 1 s in the short form.
AT_ONCE = {"feedback": "0.66", "ones": "0.65"}
BY_ROUNDING = {"damping": "5.3", "uncoupled": "3.1", "zero": "10.3"}
NEVER = ("modified", "modified_ones")


def ways_of(gain: float) -> dict[str, Way]:
    """The methods, with γ of the filtered inverses."""
    ones, zero = f"γ = {gain:g}, Θ(0) = 0.1", f"γ = {gain:g}, Θ(0) = 0"
    return {
        "feedback": FED_BACK,
        "ones": way("filtered", ones, gain=gain, start="ones"),
        "modified": way("filtered_modified", zero, gain=gain),
        "modified_ones": way("filtered_modified", ones, gain=gain, start="ones"),
        "damping": DAMPING,
        "uncoupled": way("feedback", "c = 0", **{**FEEDBACK, "coupling": 0.0}),
        "zero": way("filtered", zero, gain=gain),
    }


@dataclass(frozen=True)
class Options:
    """gain: γ of the filtered inverse; dt, s; shown: whose motion the arm shows."""

    gain: Gain = 5.0
    dt: Step = 1e-3
    shown: Annotated[str, choice(ways_of(5.0))] = "ones"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Seven methods on trajectory 4; those that leave by rounding are watched for 15 s, the others for 40 s."""
    arm, ways = planar(), ways_of(options.gain)
    aiming, dt = tracking(arm, path_4, IN_PLANE), max(options.dt, 4e-3) if short else options.dt
    runs = each(
        {
            key: partial(record, arm, one, aiming, 2.0, START, dt, 15.0 if short or key in BY_ROUNDING else 40.0)
            for key, one in ways.items()
        },
        progress,
    )
    rows = _rows(Sheet(short, is_changed(options)), ways, runs)
    names = titled(ways, runs)
    charts = (errors_chart(names, "ℓ"), rates_chart(runs[options.shown], ways[options.shown].title))
    return Result(rows, charts, planar_motion(runs[options.shown]))


def _rows(sheet: Sheet, ways: dict[str, Way], runs: dict[str, Run]) -> tuple[Row, ...]:
    rows = []
    for key, when in AT_ONCE.items():
        found = left_at(runs[key])
        rows.append(sheet.row(LEAVES, ways[key].title, found, when, "s", within=0.006, coarse=0.01, assumed=ASSUMED))
    for key, when in BY_ROUNDING.items():
        of, found, digest = ways[key].title, left_at(runs[key]), float(when)
        late: Any = {"within": digest - 2, "coarse": 1 - 1 / digest, "relation": "≥"}
        rows.append(sheet.row(LEAVES, of, found, when, "s", **late, assumed=ASSUMED))
    for key in NEVER:
        moved = largest(runs[key].q - runs[key].q[0])
        rows.append(sheet.row(STAYS, ways[key].title, moved, "0.01", "rad", coarse=0.0, relation="≤"))
    return tuple(rows)
