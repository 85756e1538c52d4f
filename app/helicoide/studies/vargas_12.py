"""Sim. 12 of Vargas 2013: a path that leaves the workspace, by the filtered inverse and the others."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import nan

from helicoide.studies.study import Figure, Interpretation, Progress, Result, Row
from helicoide.studies.vargas.arms import FOLDED, REACH
from helicoide.studies.vargas.paths import path_8, path_points
from helicoide.studies.vargas.position_arm import (
    DAMPING,
    SINCE,
    Drawing,
    border_dips,
    elbow_frequency,
    errors_after_return,
    first_border_dip,
    position_result,
    run_on_zebra,
)
from helicoide.studies.vargas.reach import AFTER, reach_rows
from helicoide.studies.vargas.readings import EXACT_STEP, EXPONENT
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute, method_settings, row_norms
from helicoide.studies.vargas.table import MUCH, GainInCm, Step, run_row, sentence_statement, with_step
from helicoide.text import Text

TITLE = Text(en="Simulation 12: out of reach", pt_BR="Simulação 12: fora do alcance")
SOURCE = "Vargas 2013, §4.5, sim. 12, figs. 4.20–4.27"
ABOUT = Text(
    en="""Every ten seconds the path runs up to 13 mm beyond the stretched arm. Look at what the elbow does there: \
with the filtered inverse it swings through the stretched arm again and again, and the effector dips, or draws back \
from the border, each time, more often and by less the larger γ is. Damped least squares races when the damping comes \
on, and takes a long way back to the path.""",
    pt_BR="""A cada dez segundos o caminho passa até 13 mm além do braço esticado. Observe ali o cotovelo: com a \
inversa filtrada ele oscila através do braço esticado, e a cada vez o efetuador recua da fronteira, tanto mais vezes e \
tanto menos quanto maior γ. A inversa amortecida dispara quando o amortecimento entra e faz um grande desvio na \
volta.""",
)
ROBOT = "zebra_zero"
PLACE, TIMES = "sim. 12, figs. 4.20–4.27", (1, 5, 25)
PRINTED = (1, 25)
HALF_A_SECOND = Interpretation(
    Text(en="0.5 s after coming back", pt_BR="0,5 s após a volta"),
    Text(
        en="4.3 times at 0.25 s, which is not yet large, and 63 times at 1 s",
        pt_BR="4,3 vezes a 0,25 s, o que ainda não é grande, e 63 vezes a 1 s",
    ),
)
DIP = Text(en="first dip behind the border", pt_BR="primeiro recuo atrás da fronteira")
SWING = Text(en="swings of the elbow", pt_BR="oscilação do cotovelo")


@dataclass(frozen=True)
class Options:
    """gain: the smallest γ, 1/(cm² s), beside five and twenty-five times it; dt, s."""

    gain: GainInCm = 1.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The filtered inverse with each γ, and what it is compared with."""
        filtered = {
            f"filtered_{times}": method_settings("filtered", f"γ = {times * self.gain:g}", gain=times * self.gain)
            for times in TIMES
        }
        return {**filtered, "damping": DAMPING}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Four methods on trajectory 8 for 20 s, 15 s in a quick run."""
    ways = options.ways
    dt, seconds = (max(options.dt, 2e-3), 15.0) if short else (options.dt, 20.0)
    runs = run_on_zebra(path_8, FOLDED, ways, dt, seconds, progress)
    rows = _statements(runs, dt)
    for times in TIMES:
        of, one = ways[f"filtered_{times}"].title, runs[f"filtered_{times}"]
        shown = Figure(PLACE) if times in PRINTED else None
        rows += [
            run_row(DIP, of, first_border_dip(one), "cm", shown),
            run_row(SWING, of, elbow_frequency(one), "Hz", shown),
            *reach_rows(ways[f"filtered_{times}"], one, shown),
        ]
    rows += reach_rows(DAMPING, runs["damping"], Figure(PLACE), dt)
    beyond = Text(en="path beyond the border, at most", pt_BR="caminho além da fronteira, no máximo")
    rows.append(run_row(beyond, None, float(row_norms(path_points(path_8, runs["damping"].t)).max() - REACH), "cm"))
    drawing = Drawing(path_8, (0, 1), PLACE, "figs. 4.21–4.22, 4.26")
    return position_result(rows, ways, runs, drawing, ("filtered_1", "damping"))


def _statements(runs: Mapping[str, MethodRun], dt: float) -> list[Row]:
    """The oscillation and what a larger γ does to it; how the damped leaves and comes back."""
    filtered, damped = [runs[f"filtered_{times}"] for times in TIMES], runs["damping"]
    depths, often = [first_border_dip(one) for one in filtered], [elbow_frequency(one) for one in filtered]
    fastest = [largest_absolute(one.joint_velocities, one.t >= SINCE) for one in (damped, filtered[0])]
    back = [errors_after_return(one)[1] for one in (damped, filtered[0])]
    count = Text(en="dips behind the border with the smallest γ", pt_BR="recuos atrás da fronteira com o menor γ")
    swings = sentence_statement("oscillates in the unreachable part", "oscila na parte inalcançável", PLACE, 2.0, "≥")
    smaller = sentence_statement("larger γ: smaller amplitude", "γ maior: amplitude menor", PLACE, 1.0, "<")
    higher = sentence_statement("larger γ: higher frequency", "γ maior: frequência maior", PLACE, 1.0, ">")
    peaks = sentence_statement(
        "velocity peaks where the damping switches", "picos de velocidade na comutação", PLACE, MUCH, ">"
    )
    detour = sentence_statement("large detour on re-entry", "grande desvio na volta", PLACE, MUCH, ">")
    times = Text(en="{what}, with 5γ over with γ", pt_BR="{what}, com 5γ sobre com γ")
    at_most, at_least = (
        Text(en="{what}, at most", pt_BR="{what}, no máximo"),
        Text(en="{what}, at least", pt_BR="{what}, no mínimo"),
    )
    beside = Text(
        en="fastest joint from 5 s on, damped over filtered",
        pt_BR="junta mais rápida a partir de 5 s, amortecida sobre filtrada",
    )
    later = Text(en="{what}, damped over filtered", pt_BR="{what}, amortecida sobre filtrada").format(what=AFTER)
    return [
        run_row(count, None, float(border_dips(filtered[0])[0].size), "", swings, fitted=(EXACT_STEP,)),
        run_row(
            at_most.format(what=times.format(what=DIP)), None, max(_times(depths)), "", smaller, fitted=(EXACT_STEP,)
        ),
        run_row(
            at_least.format(what=times.format(what=SWING)), None, min(_times(often)), "", higher, fitted=(EXACT_STEP,)
        ),
        run_row(with_step(beside, dt), None, fastest[0] / fastest[1], "", peaks, fitted=(EXACT_STEP, EXPONENT)),
        run_row(
            with_step(later, dt), None, back[0] / back[1], "", detour, fitted=(HALF_A_SECOND, EXACT_STEP, EXPONENT)
        ),
    ]


def _times(values: list[float]) -> list[float]:
    """Each over the one before, no number where that is zero."""
    return [b / a if a else nan for a, b in pairwise(values)]
