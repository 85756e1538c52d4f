"""The scalar examples of Vargas 2013: the k that fades just slowly enough, and the crossing of zero."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import scalar_filter
from helicoide.ik.method import Quantity
from helicoide.studies.study import BY_CONSTRUCTION, Chart, ChartLine, Progress, Result, Row, Statement
from helicoide.studies.vargas.scalar import scalar_filter_steps
from helicoide.studies.vargas.table import SECONDS, run_row, sentence_statement, study_result, subsampled
from helicoide.studies.vargas_08 import Beta
from helicoide.text import Text, untranslated

TITLE = Text(en="How large θ can become", pt_BR="Até onde θ pode crescer")
SOURCE = "Vargas 2013, §4.1, eqs. 4.6, 4.11–4.15, figs. 4.1–4.2; eq. 4.64, fig. 4.28"
ABOUT = Text(
    en="""Two ways to make θ large. If k fades just slowly enough, the error S stays at −½ and θ grows for ever, but \
only with the root of the time. If k crosses zero at a constant speed, θ is 0.94 (β/|k̇|)^⅓ at the crossing, no more: \
the curve of θ over k is horizontal there, and the modified θ²k passes through the origin.""",
    pt_BR="""Duas maneiras de fazer θ crescer. Se k se esvai devagar o bastante, o erro S fica em −½ e θ cresce para \
sempre, mas só com a raiz do tempo. Se k cruza o zero a velocidade constante, θ vale ali 0,94 (β/|k̇|)^⅓, não mais: a \
curva de θ em função de k é horizontal nesse ponto, e a modificada θ²k passa pela origem.""",
)
ROBOT = "planar3r"
C, PLACE = 0.25, "eqs. 4.11–4.15"


@dataclass(frozen=True)
class Options:
    """beta: β; speed: |k̇| of the crossing."""

    beta: Beta = 5.0
    speed: Annotated[
        float, Quantity(Text(en="speed of k", pt_BR="velocidade de k"), 0.01, 10.0, "1/s", decades=True)
    ] = 1.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The worst case followed for 1000 s, 100 s in a quick run, and the crossing in steps of its own length."""
    worst_rows, worst_chart = _worst(options.beta, 100.0 if short else 1000.0)
    progress(0.5)
    crossing_rows, crossing_charts = _crossing(options, 5e-3 if short else 5e-4)
    progress(1.0)
    return study_result((*worst_rows, *crossing_rows), (worst_chart, *crossing_charts))


def _worst(beta: float, seconds: float) -> tuple[list[Row], Chart]:
    """k of eq. 4.13 from k₀ = 1; θ from the law of the filter, not from the formula."""
    dt = 5e-3
    k: Array = np.array([scalar_filter.worst_case(dt * i, 1.0, beta, C)[0] for i in range(round(seconds / dt) + 1)])
    theta = scalar_filter_steps(
        lambda t: scalar_filter.worst_case(t, 1.0, beta, C)[0], 1 - np.sqrt(C), beta, dt, 0.0, seconds
    )
    t, S, last = dt * np.arange(float(theta.size)), k * theta - 1, theta.size // 10
    power = float(np.log10(theta[-1] / theta[last]))
    ends = {at: float(theta[round(at / dt)]) for at in (10.0, 100.0, 1000.0) if at <= seconds}
    title = Text(en="θ at {at:g} s in the worst case", pt_BR="θ em {at:g} s no pior caso")
    rows = [run_row(title.format(at=at), None, end, "", _formula(at, beta)) for at, end in ends.items()]
    rows += [
        run_row(
            Text(en="largest difference of S² from c = 1/4 there", pt_BR="maior diferença entre S² e c = 1/4 ali"),
            None,
            float(np.abs(S**2 - C).max()),
            "",
            sentence_statement("S² = c", "S² = c", PLACE, 0.0, "=", 1e-4),
        ),
        run_row(
            Text(en="power of t with which θ grows there", pt_BR="potência de t com que θ cresce ali"),
            None,
            power,
            "",
            sentence_statement("θ grows as √t: 1/2", "θ cresce como √t: 1/2", PLACE, 0.5, "=", 0.01),
        ),
    ]
    lines = (
        ChartLine(untranslated("θ"), subsampled(t), subsampled(theta)),
        ChartLine(untranslated("S"), subsampled(t), subsampled(S)),
    )
    return rows, Chart(Text(en="the worst case", pt_BR="o pior caso"), SECONDS, untranslated("θ, S"), lines)


def _formula(at: float, beta: float) -> Statement:
    """θ = (1 − √c)/k, with k = k₀/√(2 a k₀² t + 1) and a = β √c/(1 − √c)."""
    theta = scalar_filter.worst_case(at, 1.0, beta, C)[1]
    return sentence_statement("θ = (1 − √c)/k", "θ = (1 − √c)/k", PLACE, theta, "=", 1e-3 * theta)


def _crossing(options: Options, part: float) -> tuple[list[Row], tuple[Chart, ...]]:
    """From a converged θ through zero. Lengths of k are (β/|k̇|)^(−⅓), and steps a part of the time for one of them."""
    size = float((options.beta / options.speed) ** (1 / 3))
    unit = 1 / (size * options.speed)
    dt, far = part * unit, 40 * unit
    theta = scalar_filter_steps(lambda t: -options.speed * t, size / 40, options.beta, dt, -far, far)
    k: Array = -options.speed * (np.arange(float(theta.size)) * dt - far)
    modified: Array = theta * theta * k
    S, middle = k * theta - 1, theta.size // 2
    between = (k[1:] + k[:-1]) / 2 * theta[:-1] - 1  # S by k in the middle of each step
    grown = (np.diff(theta) * theta[:-1])[(between >= 0) | (between <= -1)]
    grows = sentence_statement(
        "|θ| grows only while −1 < S < 0", "|θ| só cresce com −1 < S < 0", "§4.1", 0.0, "≤", 1e-12
    )
    quantities = (
        (Text(en="θ at k = 0, times (|k̇|/β)^⅓", pt_BR="θ em k = 0, vezes (|k̇|/β)^⅓"), theta[middle] / size),
        (Text(en="largest |θ²k|, times the same", pt_BR="maior |θ²k|, vezes o mesmo"), np.abs(modified).max() / size),
        (Text(en="least S", pt_BR="menor S"), S.min()),
        (Text(en="greatest S", pt_BR="maior S"), S.max()),
    )
    growth = Text(
        en="largest θ dθ in a step with S outside (−1, 0)",
        pt_BR="maior θ dθ em um passo com S fora de (−1, 0)",
    )
    rows = [run_row(growth, CROSSING, float(grown.max()), "", grows, given=BY_CONSTRUCTION)]
    rows += [run_row(title, CROSSING, float(ours)) for title, ours in quantities]
    return rows, (_plane(k, theta, 6 / size, "θ", "figs. 4.1–4.2"), _plane(k, modified, 6 / size, "θ²k", "fig. 4.28"))


CROSSING = Text(en="crossing", pt_BR="cruzamento")


def _plane(k: Array, values: Array, width: float, symbol: str, figure: str) -> Chart:
    """A phase plane, and the hyperbola 1/k as far as the curve goes."""
    near, top = np.abs(k) < width, float(np.abs(values).max())
    away: Array = np.linspace(1 / top, width, 200)
    lines = (
        ChartLine(untranslated(symbol), subsampled(k[near]), subsampled(values[near])),
        ChartLine(untranslated("1/k, k > 0"), away, 1 / away),
        ChartLine(untranslated("1/k, k < 0"), -away, -1 / away),
    )
    title = Text(en="{symbol} over k, through zero", pt_BR="{symbol} em função de k, através do zero")
    return Chart(title.format(symbol=symbol), untranslated("k"), untranslated(symbol), lines, figure)
