"""Sim. 9 of Vargas 2013: a closed loop whose k crosses zero again and again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import scalar_filter
from helicoide.ik.method import Quantity
from helicoide.studies.study import Chart, Line, Progress, Result, Row
from helicoide.studies.vargas.runs import largest, rms
from helicoide.studies.vargas.scalar import Loop, closed_loop, plain
from helicoide.studies.vargas.table import SECONDS, Sheet, is_changed, thinned
from helicoide.text import Text, same

TITLE = Text(en="Simulation 9: k crosses zero", pt_BR="Simulação 9: k cruza o zero")
SOURCE = "Vargas 2013, §4.2, sim. 9, figs. 4.4–4.5; eq. 4.64 (modified)"
ABOUT = Text(
    en="""Every 2.5 seconds k is zero and nothing can be steered. Look at θ there: it does not run away as 1/k would, \
and grows only with the cube root of β. A larger β follows better. The modified law θ²k has the right sign at once, \
and needs less of u.""",
    pt_BR="""A cada 2,5 segundos k é zero e nada se pode comandar. Observe θ ali: não dispara como 1/k faria, e \
cresce só com a raiz cúbica de β. Um β maior acompanha melhor. A lei modificada θ²k acerta logo o sinal e exige menos \
de u.""",
)
ROBOT = "planar3r"
LAWS = {"filtered": plain, "modified": scalar_filter.modified}
NAMES = {
    "filtered": Text(en="u = θν", pt_BR="u = θν"),
    "modified": Text(en="u = θ²kν", pt_BR="u = θ²kν"),
}
# β: of the digest from 1 s on: largest θ, and largest and rms error and largest u of both laws
Numbers = tuple[str, str, str]
CASES: dict[float, tuple[str, dict[str, Numbers]]] = {
    10.0: ("1.951", {"filtered": ("1.363", "0.349", "8.96"), "modified": ("0.368", "0.123", "2.36")}),
    100.0: ("4.069", {"filtered": ("0.379", "0.077", "7.67"), "modified": ("0.222", "0.052", "4.44")}),
    1000.0: ("8.715", {"filtered": ("0.150", "0.024", "9.95"), "modified": ("0.120", "0.021", "7.43")}),
}


@dataclass(frozen=True)
class Options:
    """rate: λ; dt, s, of Runge and Kutta."""

    rate: Annotated[float, Quantity(Text(en="gain λ", pt_BR="ganho λ"), 0.1, 20.0, "1/s")] = 10.0
    dt: Annotated[float, Quantity(Text(en="step", pt_BR="passo"), 1e-4, 2e-3, "s", decades=True)] = 5e-4


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three β and both laws, for 20 s."""
    sheet, dt = Sheet(short, is_changed(options)), max(options.dt, 2e-3) if short else options.dt
    loops: dict[tuple[float, str], Loop] = {}
    for beta in CASES:
        for name, law in LAWS.items():
            loops[beta, name] = closed_loop(law, beta, dt, 20.0, options.rate)
            progress(len(loops) / (len(CASES) * len(LAWS)))
    rows = [row for beta in CASES for name in LAWS for row in _rows(sheet, beta, name, loops[beta, name])]
    return Result(tuple(rows), _charts(loops))


def _rows(sheet: Sheet, beta: float, name: str, loop: Loop) -> list[Row]:
    of, late = (
        Text(en="{law}, β = {beta:g}", pt_BR="{law}, β = {beta:g}").format(law=NAMES[name], beta=beta),
        loop.t >= 1,
    )
    peak, (error, mean, most) = CASES[beta][0], CASES[beta][1][name]
    return [
        sheet.row(Text(en="largest θ", pt_BR="maior θ"), of, largest(loop.theta, late), peak, coarse=1e-3),
        sheet.row(Text(en="largest error", pt_BR="maior erro"), of, largest(loop.e, late), error, coarse=5e-3),
        sheet.row(Text(en="rms error", pt_BR="erro rms"), of, rms(loop.e[late]), mean, coarse=5e-3),
        sheet.row(Text(en="largest u", pt_BR="maior u"), of, largest(loop.u, late), most, coarse=5e-3),
    ]


def _charts(loops: dict[tuple[float, str], Loop]) -> tuple[Chart, ...]:
    def lines(what: str, law: str) -> tuple[Line, ...]:
        of_law = {beta: loop for (beta, name), loop in loops.items() if name == law}
        return tuple(
            Line(same(f"β = {beta:g}"), thinned(loop.t), thinned(np.asarray(getattr(loop, what))))
            for beta, loop in of_law.items()
        )

    plane = tuple(
        Line(same(f"β = {beta:g}"), thinned(loop.k), thinned(loop.theta))
        for (beta, name), loop in loops.items()
        if name == "filtered"
    )
    return (
        *(
            Chart(Text(en=f"error, {one.en}", pt_BR=f"erro, {one.pt_BR}"), SECONDS, same("e"), lines("e", name))
            for name, one in NAMES.items()
        ),
        *(
            Chart(Text(en=f"u, {one.en}", pt_BR=f"u, {one.pt_BR}"), SECONDS, same("u"), lines("u", name))
            for name, one in NAMES.items()
        ),
        Chart(Text(en="θ over k", pt_BR="θ em função de k"), same("k"), same("θ"), plane),
    )
