"""Sim. 7 of Vargas 2013: the planar arm passes right through the origin, where it is singular."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

import numpy as np

from helicoide.studies.study import Interpretation, Progress, Result, Row
from helicoide.studies.vargas.paths import path_4
from helicoide.studies.vargas.planar import (
    COMPARED,
    FITTED,
    LENGTH,
    PSEUDOINVERSE,
    SINCE,
    VALUES,
    computed_rows,
    filtered_methods,
    planar_result,
    rows_of_both,
    run_on_planar,
    velocity_bound_rows,
)
from helicoide.studies.vargas.readings import links
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute
from helicoide.studies.vargas.table import FASTEST_FROM, MUCH, NULL, Gain, Step, run_row, sentence_statement, with_step
from helicoide.text import Text

TITLE = Text(en="Simulation 7: through a singular posture", pt_BR="Simulação 7: através de uma postura singular")
SOURCE = "Vargas 2013, §3.5, sim. 7, figs. 3.14–3.15"
ABOUT = Text(
    en="""The path leads through the axis of the shoulder, where no joint moves the end effector along it; the arm \
gets there after 32 s. The pseudoinverse asks for 70 rad/s in steps of 1 ms. Compare the filtered inverses: the larger \
γ is, the smaller the error, and the faster the joints, though never beyond 3 rad/s.""",
    pt_BR="""O caminho passa pelo eixo do ombro, onde nenhuma junta move o efetuador ao longo dele; o braço chega lá \
em 32 s. A pseudoinversa pede 70 rad/s em passos de 1 ms. Compare as inversas filtradas: quanto maior γ, menor o erro, \
e mais rápidas as juntas, embora nunca além de 3 rad/s.""",
)
ROBOT = "planar3r"
PATH, START, PLACE = path_4, (pi / 2, 0.1, 0.1), "sim. 7, figs. 3.14–3.15"
TIMES = (1, 10, 100)
ELSEWHERE = Interpretation(
    Text(
        en="elsewhere: before the damping comes on, and 4 s after it went off",
        pt_BR="no resto: antes de o amortecimento entrar e 4 s depois de ele sair",
    ),
    Text(
        en="just after it went off the error is 0.08 ℓ, and fades with λ",
        pt_BR="logo depois de ele sair o erro é 0,08 ℓ e se apaga com λ",
    ),
)


ON_LINKS = links(
    Text(
        en="with 1, 2, 1 and the same values the feedback has only 2.5 times its error of before; the rest holds",
        pt_BR="com 1; 2; 1 e os mesmos valores a realimentada erra só 2,5 vezes o que errava antes; o resto vale",
    )
)


@dataclass(frozen=True)
class Options:
    """gain: the smallest γ of the filtered inverses, beside ten and a hundred times it; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The compared methods."""
        return {"pseudoinverse": PSEUDOINVERSE, **VALUES.methods, **filtered_methods([k * self.gain for k in TIMES])}


def singularity_rows(runs: Mapping[str, MethodRun]) -> list[Row]:
    """How fast the joints become, and where the methods leave the path: near the singularity, and there alone."""
    damped = runs["damping"]
    before = {key: largest_absolute(runs[key].error_norm, _before(damped)) for key in COMPARED}
    ratios = {key: largest_absolute(runs[key].error_norm, runs[key].t >= SINCE) / before[key] for key in COMPARED}
    leaves = sentence_statement(
        "both deviate near the singularity", "ambos se desviam perto da singularidade", PLACE, MUCH, ">"
    )
    null = sentence_statement("zero elsewhere", "nulo no resto", PLACE, NULL * LENGTH, "≤")
    ratio = Text(en="error near the singularity over that before", pt_BR="erro perto da singularidade sobre o de antes")
    early = Text(en="error from 10 s on, before the damping", pt_BR="erro a partir de 10 s, antes do amortecimento")
    late = Text(en="error at the end, 40 s", pt_BR="erro no fim, 40 s")
    of, chosen = VALUES.methods["damping"].title, (*FITTED["damping"], ON_LINKS, ELSEWHERE)
    return [
        *velocity_bound_rows("< 0.7", PLACE, runs, ON_LINKS),
        *rows_of_both(ratio, ratios, "", leaves, ON_LINKS),
        run_row(early, of, before["damping"], "ℓ", null, fitted=chosen),
        run_row(late, of, float(damped.error_norm[-1]), "ℓ", null, fitted=chosen),
    ]


def _before(damped: MethodRun) -> slice:
    """From where the first error has faded until the damping comes on."""
    first = int(np.argmax(damped.t >= SINCE))
    return slice(first, first + int(np.argmax(damped.w[first:] < VALUES.threshold)))


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Methods on trajectory 4, the filtered inverses with three gains."""
    dt, ways = max(options.dt, 1e-2) if short else options.dt, options.ways
    runs = run_on_planar(PATH, START, ways, dt, progress)
    rows = singularity_rows(runs) + computed_rows(
        ways, {key: one for key, one in runs.items() if key != "pseudoinverse"}
    )
    if not short:  # how near to the origin the pseudoinverse steps depends on the step
        plain = largest_absolute(runs["pseudoinverse"].joint_velocities, runs["pseudoinverse"].t >= SINCE)
        rows.append(run_row(with_step(FASTEST_FROM.format(since=SINCE), dt), PSEUDOINVERSE.title, plain, "rad/s"))
    return planar_result(rows, PATH, ways, runs, "figs. 3.14–3.15")
