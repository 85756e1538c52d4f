"""Sim. 16 of Vargas 2013: the tool goes round an obstacle beside its path."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from helicoide.ik.secondary import augmented
from helicoide.studies.study import Interpretation, Progress, Result
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import path_1, path_points
from helicoide.studies.vargas.readings import EXACT_STEP, LINKS
from helicoide.studies.vargas.runs import MethodRun, largest_absolute, run_each
from helicoide.studies.vargas.secondary import (
    ERROR_LATER,
    SECONDS,
    SINCE,
    cost_chart,
    planar_tracking,
    run_modified_filter,
    single_objective,
    tool_points,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    Gain,
    Step,
    errors_chart,
    fastest_chart,
    joint_velocity_chart,
    joints_chart,
    path_chart,
    planar_motions,
    run_row,
    sentence_statement,
    study_result,
    symbol_value,
)
from helicoide.text import Text

TITLE = Text(en="Simulation 16: round an obstacle", pt_BR="Simulação 16: contornando um obstáculo")
SOURCE = "Vargas 2013, §4.7, sim. 16, fig. 4.41"
ABOUT = Text(
    en="""The path of simulation 1 passes an obstacle at 0.25. A hill of cost around it, of height α, pushes the end \
effector away as one more row of the task. Look at where the end effector goes: it keeps farther off the higher the \
hill is.""",
    pt_BR="""O caminho da simulação 1 passa a 0,25 de um obstáculo. Uma colina de custo em torno dele, de altura α, \
afasta o efetuador como mais uma linha da tarefa. Observe o percurso do efetuador: quanto mais alta a colina, mais \
longe ele passa.""",
)
ROBOT = "planar3r"
START, MU, PLACE = (0.6, -1.2, 0.4), (2.0, 0.75), "sim. 16, fig. 4.41"
HEIGHTS = Interpretation(
    Text(en="heights α from 0.1 to 10, which are not printed", pt_BR="alturas α de 0,1 a 10, que não estão impressas"),
    Text(en="with 20 and 50 it detours still more", pt_BR="com 20 e 50 o desvio é ainda maior"),
)
BEGUN = Interpretation(
    Text(en="start (0.6, −1.2, 0.4)", pt_BR="partida (0,6; −1,2; 0,4)"),
    Text(
        en="20 random starts come to the same distances within 3 %",
        pt_BR="20 partidas aleatórias chegam às mesmas distâncias, a menos de 3 %",
    ),
)
# α: the source shows several, whose values it does not print; 0: no obstacle
WEIGHTS, FEW = (0.0, 0.1, 0.5, 1.0, 2.0, 5.0, 10.0), (0.0, 0.1, 1.0, 10.0)
CLOSEST = Text(en="least distance from the obstacle from 2 s on", pt_BR="menor distância ao obstáculo a partir de 2 s")


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3


def obstacle_run(weight: float, gain: float, dt: float, seconds: float, progress: Progress) -> MethodRun:
    """A hill of height α and radius 0.2 at μ = (2, 0.75), felt by the tool."""
    hill = single_objective("ellipsoid", weight=weight, x=MU[0], y=MU[1], z=0.0, a=0.2, b=0.2, c=0.2, where="tool")
    return run_modified_filter(
        augmented(planar_problem(), hill, planar_tracking(path_1)), START, gain, dt, progress, seconds
    )


def least_obstacle_distance(run: MethodRun) -> float:
    """How near to the obstacle the tool comes after the transient, ℓ."""
    return float(np.linalg.norm(tool_points(run, path_1)[run.t >= SINCE - 1e-9] - MU, axis=1).min())


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Six heights of the hill and none, three in a quick run."""
    dt = max(options.dt, 1e-2) if short else options.dt
    weights = FEW if short else WEIGHTS
    runs = run_each({alpha: partial(obstacle_run, alpha, options.gain, dt, SECONDS) for alpha in weights}, progress)
    names, near = (
        {symbol_value("α", alpha): one for alpha, one in runs.items()},
        [least_obstacle_distance(one) for one in runs.values()],
    )
    more = Text(
        en="{closest}: with each α over that with the one before, at least",
        pt_BR="{closest}: com cada α sobre a com o anterior, no mínimo",
    )
    detours = sentence_statement(
        "the end effector detours, the more the larger α",
        "o efetuador desvia, tanto mais quanto maior α",
        PLACE,
        1.0,
        ">",
    )
    chosen_ones = (HEIGHTS, BEGUN, LINKS, EXACT_STEP)
    least = min(b / a for a, b in pairwise(near))
    rows = [run_row(more.format(closest=CLOSEST), None, least, "", detours, fitted=chosen_ones)]
    for (name, one), distance in zip(names.items(), near, strict=True):
        rows += [
            run_row(CLOSEST, name, distance, "ℓ"),
            run_row(ERROR_LATER, name, largest_absolute(one.error_norm, one.t >= SINCE - 1e-9), "ℓ"),
        ]
    ways = {
        DESIRED: path_points(path_1, runs[0.0].t)[:, :2],
        **{name: tool_points(one, path_1) for name, one in names.items()},
    }
    highest = symbol_value("α", weights[-1])
    charts = (
        path_chart(ways, "x, ℓ", "y, ℓ", "fig. 4.41"),
        cost_chart(names, "fig. 4.41b"),
        errors_chart(names, "ℓ"),
        joint_velocity_chart(names[highest], highest),
        joints_chart(names[highest], highest),
        fastest_chart(names),
    )
    return study_result(rows, charts, planar_motions(names))
