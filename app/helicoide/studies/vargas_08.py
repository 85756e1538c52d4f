"""Sim. 8 of Vargas 2013: the filtered inverse of one number that stands still, is zero, or fades."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp
from typing import Annotated

import numpy as np

from helicoide.ik import scalar_filter
from helicoide.ik.method import Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies.study import Chart, Line, Progress, Result
from helicoide.studies.vargas.scalar import filtered
from helicoide.studies.vargas.table import SECONDS, Sheet, Step, is_changed, thinned
from helicoide.text import Text, same

TITLE = Text(en="Simulation 8: the inverse of one number", pt_BR="Simulação 8: a inversa de um número")
SOURCE = "Vargas 2013, §4.1, sim. 8, fig. 4.3"
ABOUT = Text(
    en="""θ follows 1/k without dividing. Look at the four curves: the smaller k is, the slower θ comes to 1/k, four \
times for half of k; where k is zero, θ stays where it is. Even where k fades away θ does not run off, but stops \
short of four.""",
    pt_BR="""θ segue 1/k sem dividir. Observe as quatro curvas: quanto menor k, mais devagar θ chega a 1/k, quatro \
vezes para a metade de k; onde k é zero, θ fica parado. Mesmo onde k se esvai, θ não dispara: para antes de quatro.""",
)
ROBOT = "planar3r"
Beta = Annotated[float, Quantity(Text(en="update gain β", pt_BR="ganho β"), 0.1, 1e4, "1/s", decades=True)]
# k; of the digest: θ after 1, 5 and 10 s, from 1
CASES = {
    "k = 2": (lambda t: 2.0, ("0.5", "0.5", "0.5")),
    "k = 0.5": (lambda t: 0.5, ("1.7135", "1.9981", "2.000")),
    "k = 0": (lambda t: 0.0, ("1", "1", "1")),
    "k = 2 e^(−t/2)": (lambda t: 2 * exp(-0.5 * t), ("0.7771", "2.7376", "3.8321")),
}
TIMES = (1.0, 5.0, 10.0)


@dataclass(frozen=True)
class Options:
    """beta: β; dt, s."""

    beta: Beta = 5.0
    dt: Step = 1e-3


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Four k, 10 s each, and 60 s of the one that fades."""
    sheet, dt = Sheet(short, is_changed(options)), max(options.dt, 1e-2) if short else options.dt
    t: Array = dt * np.arange(round(10 / dt) + 1.0)
    rows, lines = [], []
    for i, (name, (k, ends)) in enumerate(CASES.items()):
        theta = filtered(k, 1.0, options.beta, dt, 0.0, 10.0)
        lines.append(Line(same(name), thinned(t), thinned(theta)))
        for at, end in zip(TIMES, ends, strict=True):
            after = Text(en="θ after {at:g} s", pt_BR="θ após {at:g} s").format(at=at)
            rows.append(sheet.row(after, same(name), float(np.interp(at, t, theta)), end, within=6e-5, coarse=1e-4))
        progress((i + 1) / (len(CASES) + 1))
    last = filtered(CASES["k = 2 e^(−t/2)"][0], 1.0, options.beta, dt, 0.0, 60.0)[-1]
    limit = Text(en="θ after 60 s", pt_BR="θ após 60 s")
    rows.append(sheet.row(limit, same("k = 2 e^(−t/2)"), float(last), "3.963", coarse=1e-4))
    for value, tau in ((2.0, "0.05"), (0.5, "0.8")):
        left = (scalar_filter.stepped(value, 0.0, options.beta, 0.01) - 1 / value) * -value
        constant = Text(en="time constant", pt_BR="constante de tempo")
        rows.append(
            sheet.row(constant, same(f"k = {value:g}"), float(-0.01 / np.log(left)), tau, "s", within=1e-9, coarse=0.0)
        )
    progress(1.0)
    return Result(
        tuple(rows),
        (Chart(Text(en="θ on its way to 1/k", pt_BR="θ a caminho de 1/k"), SECONDS, same("θ"), tuple(lines)),),
    )
