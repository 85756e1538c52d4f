"""Sim. 8 of Vargas 2013: the filtered inverse of one number that stands still, is zero, or fades."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import e, exp
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import scalar_filter
from helicoide.ik.method import Quantity
from helicoide.studies.study import BY_CONSTRUCTION, Chart, ChartLine, Figure, Progress, Result, Row, Statement
from helicoide.studies.vargas.scalar import scalar_filter_steps
from helicoide.studies.vargas.table import SECONDS, Step, run_row, sentence_statement, study_result, subsampled
from helicoide.text import Text, untranslated, with_decimal_comma

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
CASES: dict[str, Callable[[float], float]] = {
    "k = 2": lambda t: 2.0,
    "k = 0.5": lambda t: 0.5,
    "k = 0": lambda t: 0.0,
    "k = 2 e^(−t/2)": lambda t: 2 * exp(-0.5 * t),
}
STILL, FADING, FIGURE = {"k = 2": 2.0, "k = 0.5": 0.5}, "k = 2 e^(−t/2)", "fig. 4.3"


@dataclass(frozen=True)
class Options:
    """beta: β; dt, s."""

    beta: Beta = 5.0
    dt: Step = 1e-3


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Four k, 10 s each, and 60 s of the one that fades."""
    dt = max(options.dt, 1e-2) if short else options.dt
    t: Array = dt * np.arange(round(10 / dt) + 1.0)
    thetas = {}
    for name, k in CASES.items():
        thetas[name] = scalar_filter_steps(k, 1.0, options.beta, dt, 0.0, 10.0)
        progress(len(thetas) / (len(CASES) + 1))
    long = scalar_filter_steps(CASES[FADING], 1.0, options.beta, dt, 0.0, 60.0)
    rows = [_constant(name, k, options.beta) for name, k in STILL.items()]
    frozen = sentence_statement("k = 0: θ(t) = θ(0)", "k = 0: θ(t) = θ(0)", "§4.1, fig. 4.3", 1.0)
    after_ten = Text(en="θ after 10 s", pt_BR="θ após 10 s")
    rows += [
        run_row(after_ten, with_decimal_comma("k = 0"), float(thetas["k = 0"][-1]), "", frozen, given=BY_CONSTRUCTION),
        *(
            run_row(after_ten, with_decimal_comma(name), float(thetas[name][-1]), "", Figure(FIGURE))
            for name in ("k = 0.5", FADING)
        ),
        run_row(Text(en="θ after 60 s", pt_BR="θ após 60 s"), with_decimal_comma(FADING), float(long[-1])),
    ]
    progress(1.0)
    errors = {name: np.array([k(now) for now in t.tolist()]) * thetas[name] - 1 for name, k in CASES.items()}
    charts = (
        _chart(Text(en="θ on its way to 1/k", pt_BR="θ a caminho de 1/k"), "θ", t, thetas),
        _chart(Text(en="inversion error", pt_BR="erro de inversão"), "S = kθ − 1", t, errors),
    )
    return study_result(rows, charts)


def _constant(name: str, k: float, beta: float) -> Row:
    """How long θ takes for all but 1/e of its way to 1/k, by Euler's rule on the law of θ, beside 1/(β k²)."""
    tau, theta, taken = 1 / (beta * k * k), 1.0, 0
    while abs(theta - 1 / k) > abs(1.0 - 1 / k) / e:
        theta += 1e-3 * tau * scalar_filter.scalar_slope(k, theta, beta)
        taken += 1
    law = Statement(untranslated("τ = 1/(βk²)"), "eq. 4.10", tau, "=", 0.01 * tau)
    title = Text(en="time constant, in a thousand steps", pt_BR="constante de tempo, em mil passos")
    return run_row(title, with_decimal_comma(name), 1e-3 * tau * taken, "s", law)


def _chart(title: Text, up: str, t: Array, values: dict[str, Array]) -> Chart:
    lines = tuple(
        ChartLine(with_decimal_comma(name), subsampled(t), subsampled(value)) for name, value in values.items()
    )
    return Chart(title, SECONDS, untranslated(up), lines, FIGURE)
