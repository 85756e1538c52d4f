"""The scalar examples of Vargas 2013: the k that fades just slowly enough, and the crossing of zero."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import scalar_filter
from helicoide.ik.method import Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.studies.vargas.scalar import filtered
from helicoide.studies.vargas.table import SECONDS, Sheet, is_changed, thinned
from helicoide.studies.vargas_08 import Beta
from helicoide.text import Text, same

TITLE = Text(en="How large θ can become", pt_BR="Até onde θ pode crescer")
SOURCE = "Vargas 2013, §4.1, eqs. 4.11–4.15, figs. 4.1–4.2; eq. 4.6"
ABOUT = Text(
    en="""Two ways to make θ large. If k fades just slowly enough, the error S stays at −½ and θ grows for ever, but \
only with the root of the time. If k crosses zero at a constant speed, θ is 0.94 (β/|k̇|)^⅓ at the crossing, no more: \
the curve of θ over k is horizontal there, and the modified θ²k passes through the origin.""",
    pt_BR="""Duas maneiras de fazer θ crescer. Se k se esvai devagar o bastante, o erro S fica em −½ e θ cresce para \
sempre, mas só com a raiz do tempo. Se k cruza o zero a velocidade constante, θ vale ali 0,94 (β/|k̇|)^⅓, não mais: a \
curva de θ em função de k é horizontal nesse ponto, e a modificada θ²k passa pela origem.""",
)
ROBOT = "planar3r"
WORST = {10.0: "5.025", 100.0: "15.82", 1000.0: "50.00"}
C = 0.25
NOT_THERE = Text(en="not in the source: of the digest", pt_BR="não está na fonte: é da síntese")


@dataclass(frozen=True)
class Options:
    """beta: β; speed: |k̇| of the crossing."""

    beta: Beta = 5.0
    speed: Annotated[
        float, Quantity(Text(en="speed of k", pt_BR="velocidade de k"), 0.01, 10.0, "1/s", decades=True)
    ] = 1.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """The worst case followed for 1000 s, 100 s in the short form, and the crossing in steps of its own length."""
    sheet = Sheet(short, is_changed(options))
    worst_rows, worst_chart = _worst(sheet, options.beta, 100.0 if short else 1000.0)
    progress(0.5)
    crossing_rows, crossing_chart = _crossing(sheet, options, 5e-3 if short else 5e-4)
    progress(1.0)
    return Result((*worst_rows, *crossing_rows), (worst_chart, crossing_chart))


def _worst(sheet: Sheet, beta: float, seconds: float) -> tuple[list[Row], Chart]:
    """k of eq. 4.13 from k₀ = 1; θ from the law of the filter, not from the formula."""

    def k(t: float) -> float:
        return scalar_filter.worst_case(t, 1.0, beta, C)[0]

    dt = 5e-3
    theta = filtered(k, 1 - np.sqrt(C), beta, dt, 0.0, seconds)
    t: Array = dt * np.arange(float(theta.size))
    title = Text(en="θ at {at:g} s where k fades most slowly", pt_BR="θ em {at:g} s com k no esvaimento limite")
    rows = [
        sheet.row(title.format(at=at), None, float(np.interp(at, t, theta)), digest, within=6e-3, coarse=0.0)
        for at, digest in WORST.items()
        if at <= seconds
    ]
    S: Array = np.array([k(float(now)) for now in t[::20]]) * theta[::20] - 1
    error = Text(en="{which} S there", pt_BR="{which} S ali")
    for which, ours in ((Text(en="least", pt_BR="menor"), S.min()), (Text(en="greatest", pt_BR="maior"), S.max())):
        rows.append(sheet.row(error.format(which=which), None, float(ours), "-0.5", within=1e-4, coarse=0.0))
    lines = (Line(same("θ"), thinned(t), thinned(theta)), Line(same("S"), t[::20], S))
    return rows, Chart(Text(en="the worst case", pt_BR="o pior caso"), SECONDS, same("θ, S"), lines)


def _crossing(sheet: Sheet, options: Options, part: float) -> tuple[list[Row], Chart]:
    """From a converged θ through zero. Lengths of k are (β/|k̇|)^(−⅓), and steps a part of the time for one of them."""
    size = float((options.beta / options.speed) ** (1 / 3))
    unit = 1 / (size * options.speed)
    dt, far = part * unit, 40 * unit
    theta = filtered(lambda t: -options.speed * t, size / 40, options.beta, dt, -far, far)
    k = -options.speed * (np.arange(theta.size) * dt - far)
    modified: Array = np.asarray(scalar_filter.modified(k, theta))  # type: ignore[arg-type]
    S, middle = k * theta - 1, theta.size // 2
    of = Text(en="crossing", pt_BR="cruzamento")
    quantities = (
        (Text(en="θ at k = 0, times (|k̇|/β)^⅓", pt_BR="θ em k = 0, vezes (|k̇|/β)^⅓"), theta[middle] / size, "0.9389"),
        (Text(en="largest θ, times the same", pt_BR="maior θ, vezes o mesmo"), theta.max() / size, "0.9389"),
        (
            Text(en="largest |θ²k|, times the same", pt_BR="maior |θ²k|, vezes o mesmo"),
            np.abs(modified).max() / size,
            "0.5124",
        ),
        (Text(en="least S", pt_BR="menor S"), S.min(), "-1.427"),
        (Text(en="greatest S", pt_BR="maior S"), S.max(), "0.077"),
    )
    rows = [
        sheet.row(
            title,
            of,
            float(ours),
            digest,
            within=1e-4 if digest.startswith("0.") and len(digest) > 5 else 1e-3,
            coarse=1e-3,
            source=NOT_THERE,
        )
        for title, ours, digest in quantities
    ]
    near = np.abs(k) * size < 6
    lines = (
        Line(same("θ"), thinned(k[near]), thinned(theta[near])),
        Line(same("θ²k"), thinned(k[near]), thinned(modified[near])),
    )
    return rows, Chart(Text(en="through zero", pt_BR="através do zero"), same("k"), same("θ"), lines)
