"""Sim. 9 of Vargas 2013: a closed loop whose k crosses zero again and again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated

from helicoide.arrays import Array
from helicoide.ik import scalar_filter
from helicoide.ik.method import Quantity
from helicoide.studies.study import Chart, ChartLine, Figure, Progress, Result, Row
from helicoide.studies.vargas.runs import largest_absolute
from helicoide.studies.vargas.scalar import ScalarLoop, plain_law, scalar_closed_loop
from helicoide.studies.vargas.table import (
    SECONDS,
    run_row,
    sentence_statement,
    study_result,
    subsampled,
    symbol_value,
    transient_end,
)
from helicoide.text import Text, untranslated

TITLE = Text(en="Simulation 9: k crosses zero", pt_BR="Simulação 9: k cruza o zero")
SOURCE = "Vargas 2013, §4.2, sim. 9, figs. 4.4–4.5; eq. 4.64"
ABOUT = Text(
    en="""Every 2.5 seconds k is zero and nothing can be steered. Look at θ there: it does not run away as 1/k would, \
and grows only with the cube root of β. A larger β follows better. The modified law θ²k has the right sign at once, \
and needs less of u.""",
    pt_BR="""A cada 2,5 segundos k é zero e nada se pode comandar. Observe θ ali: não dispara como 1/k faria, e \
cresce só com a raiz cúbica de β. Um β maior acompanha melhor. A lei modificada θ²k acerta logo o sinal e exige menos \
de u.""",
)
ROBOT = "planar3r"
LAWS = {"filtered": plain_law, "modified": scalar_filter.modified}
NAMES = {
    "filtered": Text(en="u = θν", pt_BR="u = θν"),
    "modified": Text(en="u = θ²kν", pt_BR="u = θ²kν"),
}
BETAS, PLACE = (10.0, 100.0, 1000.0), "sim. 9, figs. 4.4–4.5"
RATE = 10.0
SINCE = transient_end(RATE)


@dataclass(frozen=True)
class Options:
    """rate: λ; dt, s, of Runge and Kutta."""

    rate: Annotated[float, Quantity(Text(en="gain λ", pt_BR="ganho λ"), 0.1, 20.0, "1/s")] = RATE
    dt: Annotated[float, Quantity(Text(en="step", pt_BR="passo"), 1e-4, 2e-3, "s", decades=True)] = 5e-4


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three β and both laws, for 20 s."""
    dt = max(options.dt, 2e-3) if short else options.dt
    loops: dict[tuple[float, str], ScalarLoop] = {}
    for beta in BETAS:
        for name, law in LAWS.items():
            loops[beta, name] = scalar_closed_loop(law, beta, dt, 20.0, options.rate)
            progress(len(loops) / (len(BETAS) * len(LAWS)))
    rows = _statements([loops[beta, "filtered"] for beta in BETAS])
    for (beta, name), loop in loops.items():
        of, late = (
            Text(en="{law}, {beta}", pt_BR="{law}, {beta}").format(law=NAMES[name], beta=symbol_value("β", beta)),
            loop.t >= SINCE,
        )
        shown = Figure(PLACE) if name == "filtered" else None
        rows += [
            run_row(Text(en="largest error", pt_BR="maior erro"), of, largest_absolute(loop.e, late), "", shown),
            run_row(Text(en="largest u", pt_BR="maior u"), of, largest_absolute(loop.u, late), "", shown),
        ]
        if shown:
            rows.append(
                run_row(Text(en="largest θ", pt_BR="maior θ"), of, largest_absolute(loop.theta, late), "", shown)
            )
    return study_result(rows, _charts(loops))


def _statements(loops: list[ScalarLoop]) -> list[Row]:
    """What a ten times larger β does, each time."""
    peaks = [largest_absolute(loop.theta, loop.t >= SINCE) for loop in loops]
    errors = [largest_absolute(loop.e, loop.t >= SINCE) for loop in loops]
    larger = sentence_statement("larger β: larger θ near k = 0", "β maior: θ maior perto de k = 0", PLACE, 1.0, ">")
    better = sentence_statement("larger β: better tracking", "β maior: melhor rastreamento", PLACE, 1.0, "<")
    of_theta = Text(
        en="largest θ with 10β over that with β, at least",
        pt_BR="maior θ com 10β sobre o maior com β, no mínimo",
    )
    of_error = Text(
        en="largest error with 10β over that with β, at most",
        pt_BR="maior erro com 10β sobre o maior com β, no máximo",
    )
    return [
        run_row(of_theta, None, min(b / a for a, b in pairwise(peaks)), "", larger),
        run_row(of_error, None, max(b / a for a, b in pairwise(errors)), "", better),
    ]


def _charts(loops: dict[tuple[float, str], ScalarLoop]) -> tuple[Chart, ...]:
    """Over time, and θ over k. Of the modified law, what the source does not show, u alone."""

    def chart(
        title: Text, up: str, value: Callable[[ScalarLoop], Array], law: str = "filtered", over_k: bool = False
    ) -> Chart:
        lines = tuple(
            ChartLine(symbol_value("β", beta), subsampled(loop.k if over_k else loop.t), subsampled(value(loop)))
            for (beta, name), loop in loops.items()
            if name == law
        )
        return Chart(
            title, untranslated("k") if over_k else SECONDS, untranslated(up), lines, PLACE if law == "filtered" else ""
        )

    of = Text(en="{what}, {law}", pt_BR="{what}, {law}")
    missed, control = Text(en="error", pt_BR="erro"), Text(en="control", pt_BR="controle")
    plain_one, modified = NAMES["filtered"], NAMES["modified"]
    return (
        chart(of.format(what=missed, law=plain_one), "e", lambda loop: loop.e),
        chart(Text(en="output", pt_BR="saída"), "y", lambda loop: loop.y),
        chart(Text(en="filtered inverse", pt_BR="inversa filtrada"), "θ", lambda loop: loop.theta),
        chart(Text(en="inversion error", pt_BR="erro de inversão"), "S = kθ − 1", lambda loop: loop.k * loop.theta - 1),
        chart(of.format(what=control, law=plain_one), "u", lambda loop: loop.u),
        chart(of.format(what=control, law=modified), "u", lambda loop: loop.u, "modified"),
        chart(of.format(what=missed, law=modified), "e", lambda loop: loop.e, "modified"),
        chart(Text(en="θ over k", pt_BR="θ em função de k"), "θ", lambda loop: loop.theta, over_k=True),
    )
