"""S3: through a singularity of the wrist beyond the entry point, with damping."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.method import OneOf
from helicoide.ik.postures.branch import tool_at
from helicoide.studies._coutinho_rows import (
    FITTED_START,
    NULL,
    OF,
    SAMPLED,
    SLIP,
    SMALL,
    STEP,
    STEPS,
    TIMES,
    measure_rows,
    run_charts,
    run_motions,
)
from helicoide.studies._coutinho_runs import DLS, ROBOT, Run, dia10, sign_changes, source_control
from helicoide.studies._coutinho_runs import run_path as run_along
from helicoide.studies._coutinho_simulation import SHORT, curve_figures, share_of_progress
from helicoide.studies.study import BY_CONSTRUCTION, INPUT_VALUE, Interpretation, Progress, Result, Row, Statement
from helicoide.text import Text

TITLE = Text(en="S3: through a singularity", pt_BR="S3: através de uma singularidade")
SOURCE = "Coutinho 2015, §4.1.2, eqs. 4.3, 4.4; tabs. 4.1, 4.2"
ABOUT = Text(
    en="The end effector is turned so that the two axes around the bend beyond the trocar come into line, θ₇ = 0, "
    "where one motion of the end effector is lost; damping keeps the joints calm. If only J^r is damped, as eq. 3.46 "
    "has it, the entry point notices nothing; table 4.1 prints J_0i, the Jacobian of the arm up to the entry point, "
    "J_i for short: if it is damped too, the velocity of the entry point is disturbed by 0.54 mm/s at most, near θ₇ = "
    "0, and by more than 0.1 mm/s in two thirds of the run, so that the shaft drifts by 17 mm. The source reports a "
    "small disturbance.",
    pt_BR="A ponta gira até que os dois eixos em torno da flexão além do trocarte se alinhem, θ₇ = 0, onde se perde um "
    "movimento; o amortecimento mantém as juntas calmas. Se só J^r é amortecido, como na eq. 3.46, o ponto de entrada "
    "nada sente; a tabela 4.1 traz J_0i, o Jacobiano do braço até o ponto de entrada, aqui J_i: se ele também é "
    "amortecido, a velocidade do ponto de entrada é perturbada em no máximo 0,54 mm/s, perto de θ₇ = 0, e em mais de "
    "0,1 mm/s em dois terços da execução, de modo que a haste se afasta 17 mm. A fonte relata uma perturbação pequena.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

OF_WRIST = Text(en="J^r damped", pt_BR="J^r amortecido")
OF_BOTH = Text(en="J^r and J_i damped", pt_BR="J^r e J_i amortecidos")
CROSSES = Statement(Text(en="made to cross θ₇ = 0", pt_BR="feita para cruzar θ₇ = 0"), "§4.1.2", 1.0, "≥")
TURN = Statement(Text(en="φ = −π/8 sin ωt", pt_BR="φ = −π/8 sen ωt"), "eq. 4.4", 22.5, "=", 0.5)
DISTURBED = Text(
    en="the velocity of the entry point is disturbed", pt_BR="a velocidade do ponto de entrada é perturbada"
)
SLIGHTLY = Text(en="the disturbance is small", pt_BR="a perturbação é pequena")
NEARBY = Text(en="near the singularity", pt_BR="perto da singularidade")
LEAST = Text(en="smallest l_a", pt_BR="menor l_a")
TURNED = Text(en="largest turn of the end effector", pt_BR="maior giro do efetuador")
DURING = Text(
    en="share of the run with a forbidden velocity above 0.1 mm/s, {which}",
    pt_BR="parte da execução com velocidade proibida acima de 0,1 mm/s, {which}",
)
WHERE = Text(
    en="|θ₇| where the forbidden velocity is largest, {which}",
    pt_BR="|θ₇| onde a velocidade proibida é maior, {which}",
)
MEASURED = ("tip", "angle", "lateral", "q7_min", "q7_max", "rate")
DAMPED_TOO = Interpretation(
    Text(
        en="J_i, which table 4.1 prints, is damped beside J^r, by the κ_r of J^r",
        pt_BR="J_i, que a tabela 4.1 traz, é amortecido junto com J^r, com o κ_r de J^r",
    ),
    Text(
        en="with J^r damped alone, as eq. 3.46 has it, nothing disturbs the entry point",
        pt_BR="só com J^r amortecido, como na eq. 3.46, nada perturba o ponto de entrada",
    ),
)
DISTURBED_BY = (*FITTED_START, SAMPLED, DAMPED_TOO)
AS_VELOCITY = Interpretation(
    Text(en="small as a velocity", pt_BR="pequena como velocidade"),
    Text(en="in 200 s it carries the shaft 17 mm away", pt_BR="em 200 s ela afasta a haste 17 mm"),
)
AT_ITS_LARGEST = Interpretation(
    Text(en="where the disturbance is largest", pt_BR="onde a perturbação é maior"),
    Text(
        en="it is above 0.1 mm/s in 65 % of the run, far from the singularity too",
        pt_BR="passa de 0,1 mm/s em 65 % da execução, também longe da singularidade",
    ),
)
FIGURES = "figs. 4.15–4.19"


@dataclass(frozen=True)
class Options:
    """The sample time, ms."""

    step: Annotated[str, OneOf(STEP, STEPS)] = "20"


def run(options: Options, short: bool, progress: Progress) -> Result:
    """With J^r damped, and with J_i damped too; short: at 100 ms."""
    dt = SHORT if short else int(options.step) / 1000
    wrist = run_along("S3", source_control(of_tool=DLS), dt, progress=share_of_progress(progress, 0, 2))
    both = run_along("S3", source_control(of_tool=DLS, of_arm=DLS), dt, progress=share_of_progress(progress, 1, 2))
    runs = {OF_WRIST: wrist, OF_BOTH: both}
    return Result(
        rows=(
            *s3_rows(wrist, both),
            Row(OF.format(what=SLIP, which=OF_WRIST), float(wrist["slip_mm_s"].max()), "mm/s", given=BY_CONSTRUCTION),
            *(one for which, got in runs.items() for one in measure_rows(got, which, dt, FIGURES, MEASURED)),
        ),
        charts=run_charts(runs, {**curve_figures(FIGURES, "fig. 4.16b"), "entry": "fig. 4.17"}, ("tip",)),
        motions=run_motions(runs),
    )


def s3_rows(wrist: Run, both: Run) -> list[Row]:
    """What the source prints of S3, of the runs without and with J_i damped."""
    least = 1e3 * float(wrist["outside"].min())
    return [
        *_disturbed(both),
        Row(OF.format(what=TIMES, which=OF_WRIST), sign_changes(wrist["q7"]), "", CROSSES, given=INPUT_VALUE),
        Row(TURNED, _turned_deg(wrist["q"]), "°", TURN, given=INPUT_VALUE),
        Row(OF.format(what=LEAST, which=OF_WRIST), least, "mm"),
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
            (*DISTURBED_BY, AS_VELOCITY),
        ),
        Row(
            WHERE.format(which=OF_BOTH),
            where,
            "rad",
            Statement(NEARBY, "fig. 4.17", 0.1, "≤"),
            (*DISTURBED_BY, AT_ITS_LARGEST),
        ),
    ]


def _turned_deg(q: Array) -> float:
    """The largest angle of the tool against its start, degrees."""
    R = tool_at(dia10(), q[0])[:3, :3]
    return float(np.degrees(max(np.linalg.norm(rotation.logarithm(R.T @ tool_at(dia10(), one)[:3, :3])) for one in q)))
