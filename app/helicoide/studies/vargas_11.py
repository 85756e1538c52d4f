"""Sim. 11 of Vargas 2013: through singular postures of the shoulder, where the filtered inverse is at its best."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from helicoide.studies.study import Figure, Interpretation, Progress, Result, Row
from helicoide.studies.vargas.arms import FOLDED, REACH
from helicoide.studies.vargas.crossing import axis_crossing_rows
from helicoide.studies.vargas.paths import path_7
from helicoide.studies.vargas.position_arm import (
    DAMPING,
    FASTEST_LATER,
    LARGEST_ACCELERATION,
    PSEUDOINVERSE,
    SINCE,
    SQUARED,
    Drawing,
    position_result,
    run_on_zebra,
)
from helicoide.studies.vargas.readings import EXACT_STEP, EXPONENT
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute, method_settings
from helicoide.studies.vargas.table import (
    NULL,
    SIMILAR_CORRELATION,
    GainInCm,
    Step,
    run_row,
    sentence_statement,
    with_step,
)
from helicoide.text import Text

TITLE = Text(en="Simulation 11: through singular postures", pt_BR="Simulação 11: através de singularidades")
SOURCE = "Vargas 2013, §4.5, sim. 11, figs. 4.12–4.17"
ABOUT = Text(
    en="""The path crosses the axis of the waist every five seconds, where the shoulder is singular and the \
pseudoinverse asks for ten thousand radians a second. Look at the error at those instants: damping leaves the path by \
millimetres, the filtered inverse by a quarter of one, at the same joint velocities. Compare δ with V_c, which tells \
how far Θ is from an inverse: both rise where J is badly conditioned.""",
    pt_BR="""O caminho cruza o eixo da cintura a cada cinco segundos, onde o ombro é singular e a pseudoinversa pede \
dez mil radianos por segundo. Observe o erro nesses instantes: a inversa amortecida sai do caminho por milímetros, a \
filtrada por um quarto de milímetro, com as mesmas velocidades de junta. Compare δ com V_c, que mede quanto Θ está \
longe de uma inversa: ambos crescem onde J é mal condicionado.""",
)
ROBOT = "zebra_zero"
PLACE = "sim. 11, figs. 4.12–4.17"
# s: a tenth of the time from one singular point to the next
SHIFT = 0.5
SHIFTED = Interpretation(
    Text(
        en="V_c moved by 0.24 s, by which its peaks come after those of δ",
        pt_BR="V_c deslocada de 0,24 s, o atraso dos seus picos em relação aos de δ",
    ),
    Text(en="the correlation without moving it is 0.61", pt_BR="a correlação sem deslocá-la é 0,61"),
)


@dataclass(frozen=True)
class Options:
    """gain: γ, 1/(cm² s); dt, s."""

    gain: GainInCm = 1.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The filtered inverses with their γ, and the others."""
        filtered, modified = (
            method_settings(name, f"γ = {self.gain:g}", gain=self.gain) for name in ("filtered", "filtered_modified")
        )
        rest = {"damping": DAMPING, "squared": SQUARED, "pseudoinverse": PSEUDOINVERSE}
        return {"filtered": filtered, "modified": modified, **rest}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Five methods on trajectory 7, for 20 s."""
    ways, dt = options.ways, max(options.dt, 5e-3) if short else options.dt
    runs = run_on_zebra(path_7, FOLDED, ways, dt, 20.0, progress)
    follows = sentence_statement(
        "practically null error, also at the singular points",
        "erro praticamente nulo, também nos pontos singulares",
        PLACE,
        NULL * REACH,
        "≤",
    )
    rows = [*_statements(runs), *axis_crossing_rows(ways, runs, PLACE, follows), *_of_the_step(ways, runs, dt)]
    if not short:  # how near to the singularity the pseudoinverse steps depends on the step
        plain = runs["pseudoinverse"]
        title = with_step(FASTEST_LATER, dt)
        rows.append(
            run_row(title, PSEUDOINVERSE.title, largest_absolute(plain.joint_velocities, plain.t >= SINCE), "rad/s")
        )
    drawing = Drawing(path_7, (1, 2), PLACE, "figs. 4.13–4.14")
    return position_result(rows, ways, runs, drawing, ("filtered", "damping"))


def _statements(runs: Mapping[str, MethodRun]) -> list[Row]:
    """How far off the damped is, beside the filtered inverse; V_c beside δ; how large Θ becomes."""
    filtered, damped = runs["filtered"], runs["damping"]
    later, shown = filtered.t >= SINCE, filtered.figure_times >= SINCE
    V_c, delta = filtered.figure("V_c"), damped.figure("δ")
    errors = [largest_absolute(one.error_norm, later) for one in (filtered, damped)]
    worse = Text(
        en="largest error from 5 s on, damped over filtered",
        pt_BR="maior erro a partir de 5 s, amortecida sobre filtrada",
    )
    alike = Text(
        en="correlation of V_c and δ from 5 s on, V_c moved by at most 0.5 s",
        pt_BR="correlação de V_c e δ a partir de 5 s, V_c deslocada no máximo 0,5 s",
    )
    most = round(SHIFT / (filtered.figure_times[1] - filtered.figure_times[0]))
    at = np.flatnonzero(shown)[:-most]
    correlations = [np.corrcoef(V_c[at + i], delta[at])[0, 1] for i in range(most + 1)]
    return [
        run_row(
            worse,
            None,
            errors[1] / errors[0],
            "",
            sentence_statement("the damped one is worse", "a amortecida é pior", PLACE, 1.0, ">"),
            fitted=(EXACT_STEP, EXPONENT),
        ),
        run_row(
            alike,
            None,
            float(max(correlations)),
            "",
            sentence_statement("V_c and δ look alike", "V_c e δ são parecidos", PLACE, SIMILAR_CORRELATION, ">"),
            fitted=(SHIFTED, EXACT_STEP, EXPONENT),
        ),
        run_row(Text(en="largest ‖Θ‖", pt_BR="maior ‖Θ‖"), None, float(filtered.figure("‖Θ‖").max()), "1/cm"),
        run_row(Text(en="largest V_c", pt_BR="maior V_c"), None, float(V_c[shown].max()), "", Figure(PLACE)),
    ]


def _of_the_step(ways: Mapping[str, MethodSettings], runs: Mapping[str, MethodRun], dt: float) -> list[Row]:
    """How smooth the joint velocities are; where the damping comes on, the acceleration depends on the step."""
    pushes = {
        key: largest_absolute(runs[key].joint_acceleration, runs[key].t[1:] >= SINCE)
        for key in ("filtered", "modified", "damping")
    }
    smoother = Text(en="{what}, filtered over damped", pt_BR="{what}, filtrada sobre amortecida")
    title, said = with_step(LARGEST_ACCELERATION, dt), sentence_statement("smoother q̇", "q̇ mais suave", PLACE, 1.0, "<")
    return [
        run_row(
            smoother.format(what=title),
            None,
            pushes["filtered"] / pushes["damping"],
            "",
            said,
            fitted=(EXACT_STEP, EXPONENT),
        ),
        *(run_row(title, ways[key].title, push, "rad/s²") for key, push in pushes.items()),
    ]
