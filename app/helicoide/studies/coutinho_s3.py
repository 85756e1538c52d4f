"""S3: through a singularity of the wrist beyond the entry point, with damping."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.geometry import rotation
from helicoide.ik.method import OneOf
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics.chain import Array
from helicoide.studies._coutinho_rows import (
    NEAR,
    NULL,
    OF,
    SAMPLED,
    SLIP,
    SMALL,
    STARTED,
    STEP,
    STEPS,
    TIMES,
    charts_of,
    motions_of,
    rows_of,
)
from helicoide.studies._coutinho_runs import DLS, ROBOT, Run, control, crossings, dia10
from helicoide.studies._coutinho_runs import run as run_along
from helicoide.studies._coutinho_simulation import SHORT, charted, part
from helicoide.studies.study import CONSTRUCTED, PUT_IN, Progress, Reading, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="S3: through a singularity", pt_BR="S3: através de uma singularidade")
SOURCE = "Coutinho 2015, §4.1.2, eqs. 4.3, 4.4; tabs. 4.1, 4.2"
ABOUT = Text(
    en="The tool is turned so that the two axes around the bend beyond the trocar come into line, θ₇ = 0, where one "
    "motion of the tool is lost; damping keeps the joints calm. If only J^r is damped, as eq. 3.46 has it, the entry "
    "point notices nothing. If J_i is damped too, as table 4.1 has it, its velocity is disturbed a little, most of all "
    "near the singularity, which is what the source reports.",
    pt_BR="A ponta gira até que os dois eixos em torno da flexão além do trocarte se alinhem, θ₇ = 0, onde se perde um "
    "movimento; o amortecimento mantém as juntas calmas. Se só J^r é amortecido, como na eq. 3.46, o ponto de entrada "
    "nada sente. Se J_i também é, como na tabela 4.1, a velocidade dele é perturbada um pouco, sobretudo perto da "
    "singularidade, e é isso que a fonte relata.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

OF_WRIST = Text(en="J^r damped", pt_BR="J^r amortecido")
OF_BOTH = Text(en="J^r and J_i damped", pt_BR="J^r e J_i amortecidos")
CROSSES = Statement(Text(en="made to cross θ₇ = 0", pt_BR="feita para cruzar θ₇ = 0"), "§4.1.2", 1.0, "≥")
COMES = Statement(Text(en="comes to small l_a", pt_BR="chega a l_a pequeno"), "§4.1.2", NEAR, "≤")
TURN = Statement(Text(en="φ = −π/8 sin ωt", pt_BR="φ = −π/8 sen ωt"), "eq. 4.4", 22.5, "=", 0.5)
DISTURBED = Text(
    en="the velocity of the entry point is disturbed", pt_BR="a velocidade do ponto de entrada é perturbada"
)
SLIGHTLY = Text(en="the disturbance is small", pt_BR="a perturbação é pequena")
NEARBY = Text(en="near the singularity", pt_BR="perto da singularidade")
LEAST = Text(en="smallest l_a", pt_BR="menor l_a")
TURNED = Text(en="largest turn of the tool", pt_BR="maior giro do efetuador")
DURING = Text(
    en="share of the run with a forbidden velocity above 0.1 mm/s, {which}",
    pt_BR="parte da execução com velocidade proibida acima de 0,1 mm/s, {which}",
)
WHERE = Text(
    en="|θ₇| where the forbidden velocity is largest, {which}",
    pt_BR="|θ₇| onde a velocidade proibida é maior, {which}",
)
MEASURED = ("tip", "angle", "lateral", "q7_min", "q7_max", "rate")
DAMPED_TOO = Reading(
    Text(en="J_i is damped too, as table 4.1 has it", pt_BR="J_i também é amortecido, como na tabela 4.1"),
    Text(
        en="with J^r damped alone, as eq. 3.46 has it, nothing disturbs the entry point",
        pt_BR="só com J^r amortecido, como na eq. 3.46, nada perturba o ponto de entrada",
    ),
)
DISTURBED_BY = (*STARTED, SAMPLED, DAMPED_TOO)
FIGURES = "figs. 4.15–4.19"


@dataclass(frozen=True)
class Options:
    """The sample time, ms."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "20"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """With J^r damped, and with J_i damped too; short: at 100 ms."""
    dt = SHORT if short else int(options.step) / 1000
    wrist = run_along("S3", control(of_tool=DLS), dt, progress=part(progress, 0, 2))
    both = run_along("S3", control(of_tool=DLS, of_arm=DLS), dt, progress=part(progress, 1, 2))
    runs = {OF_WRIST: wrist, OF_BOTH: both}
    return Result(
        rows=(
            *stated(wrist, both),
            Row(OF.format(what=SLIP, which=OF_WRIST), float(wrist["slip_mm_s"].max()), "mm/s", given=CONSTRUCTED),
            *(one for which, got in runs.items() for one in rows_of(got, which, dt, FIGURES, MEASURED)),
        ),
        charts=charts_of(runs, {**charted(FIGURES, "fig. 4.16b"), "entry": "fig. 4.17"}, ("tip",)),
        motions=motions_of(runs),
    )


def stated(wrist: Run, both: Run) -> list[Row]:
    """What the source prints of S3, of the runs without and with J_i damped."""
    turned = Row(TURNED, _turned_deg(wrist["q"]), "°", TURN, given=PUT_IN)
    return [*_crossed(wrist, OF_WRIST), *_crossed(both, OF_BOTH), *_disturbed(both), turned]


def _crossed(got: Run, which: Text) -> list[Row]:
    least = 1e3 * float(got["outside"].min())
    return [
        Row(OF.format(what=TIMES, which=which), crossings(got["q7"]), "", CROSSES, STARTED),
        Row(OF.format(what=LEAST, which=which), least, "mm", COMES, STARTED),
    ]


def _disturbed(got: Run) -> list[Row]:
    slip = got["slip_mm_s"]
    most, where = float(slip.max()), float(abs(got["q7"][slip.argmax()]))
    return [
        Row(
            DURING.format(which=OF_BOTH),
            float(np.mean(slip > NULL)),
            "",
            Statement(DISTURBED, "fig. 4.17", 0.0, ">"),
            DISTURBED_BY,
        ),
        Row(
            OF.format(what=SLIP, which=OF_BOTH),
            most,
            "mm/s",
            Statement(SLIGHTLY, "fig. 4.17", SMALL, "≤"),
            DISTURBED_BY,
        ),
        Row(WHERE.format(which=OF_BOTH), where, "rad", Statement(NEARBY, "fig. 4.17", 0.1, "≤"), DISTURBED_BY),
    ]


def _turned_deg(q: Array) -> float:
    """The largest angle of the tool against its start, degrees."""
    R = tool_at(dia10(), q[0])[:3, :3]
    return float(np.degrees(max(np.linalg.norm(rotation.logarithm(R.T @ tool_at(dia10(), one)[:3, :3])) for one in q)))
