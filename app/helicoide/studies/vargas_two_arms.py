"""Figs. 4.43 and 4.44 of Vargas 2013: the arm makes way for a second arm in motion."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.arm_points import watched
from helicoide.ik.secondary import augmented
from helicoide.kinematics.forward import link_poses
from helicoide.studies.study import Chart, ChartLine, Progress, Result
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import path_1, path_points
from helicoide.studies.vargas.runs import MethodRun, largest_absolute, run_each
from helicoide.studies.vargas.secondary import (
    ERROR_LATER,
    FASTEST_LATER,
    NEAREST_LATER,
    SECONDS,
    SINCE,
    cost_chart,
    least_link_distance,
    link_distances,
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
    joint_velocity_chart,
    joints_chart,
    path_chart,
    planar_motions,
    run_row,
    study_result,
    symbol_value,
)
from helicoide.studies.vargas.table import SECONDS as IN_SECONDS
from helicoide.text import Text, untranslated

TITLE = Text(en="Two arms", pt_BR="Dois braços")
SOURCE = "Vargas 2013, §4.7, figs. 4.43–4.44"
ABOUT = Text(
    en="""A second arm works on the other side of the table and reaches into the path of the first. Each of its points \
carries a hill of cost that moves with it. Look at the least distance: without the term the arms touch; with it the \
first one gives way, and leaves its path by 0.24 ℓ while it does. Values and motion are ours: the source shows two \
figures and prints no number.""",
    pt_BR="""Um segundo braço trabalha do outro lado da mesa e invade o caminho do primeiro. Cada um de seus pontos \
carrega uma colina de custo que se move com ele. Observe a menor distância: sem o termo os braços se tocam; com ele o \
primeiro cede e, enquanto cede, sai do caminho por 0,24 ℓ. Valores e movimento são nossos: a fonte mostra duas figuras \
e não imprime números.""",
)
ROBOT = "planar3r"
# The source gives no value: at these the arm gives way, and half the step changes the distance by less than 2 %
# (tests/studies/fits/vargas_two_arms.py). A higher hill, or an arm that reaches farther in, throws the joints.
BASE, RADIUS, ALPHA = 5.8, 0.3, 1.0
WEIGHTS = (0.0, 0.5, ALPHA)


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 5.0
    dt: Step = 2e-3


def second_arm(t: float, per_link: int = 4, base: float = BASE) -> Array:
    """Points (3 · per_link, 3), ℓ, of the second arm at time t, s: a planar 3R with its base at (base, 0)."""
    robot = planar_problem().robot
    q = np.array([np.pi - 0.5 + 0.3 * np.sin(0.3 * t), 0.6 + 0.2 * np.sin(0.4 * t), 0.4])
    points: Array = watched(robot, "links", per_link).at(link_poses(robot.chain, q))
    return np.asarray(points + np.array([base, 0, 0]))


def second_arm_run(
    weight: float,
    gain: float,
    dt: float,
    progress: Progress,
    radius: float = RADIUS,
    base: float = BASE,
) -> MethodRun:
    """A run in which four points on each link keep away from twelve points of the second arm.

    weight: height α of the cost of each point; gain: γ; dt, s; radius: of the cost, ℓ; base: x of the second arm, ℓ.
    """
    hills = single_objective("second_arm", weight=weight, radius=radius)
    aiming = augmented(planar_problem(), hills, planar_tracking(path_1), lambda t: second_arm(t, base=base))
    return run_modified_filter(aiming, (0.6, -1.2, 0.4), gain, dt, progress, SECONDS)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Runs without a cost and with two heights of it."""
    dt = max(options.dt, 8e-3) if short else options.dt
    plans = {(alpha, dt): partial(second_arm_run, alpha, options.gain, dt) for alpha in WEIGHTS}
    if not short:
        plans[ALPHA, dt / 2] = partial(second_arm_run, ALPHA, options.gain, dt / 2)
    runs = run_each(plans, progress)
    near = {key: least_link_distance(one, second_arm) for key, one in runs.items()}
    names = {symbol_value("α", alpha): runs[alpha, dt] for alpha in WEIGHTS}
    rows = []
    for alpha, (name, one) in zip(WEIGHTS, names.items(), strict=True):
        rows += [
            run_row(NEAREST_LATER, name, near[alpha, dt], "ℓ"),
            run_row(ERROR_LATER, name, largest_absolute(one.error_norm, one.t >= SINCE), "ℓ"),
            run_row(FASTEST_LATER, name, largest_absolute(one.joint_velocities, one.t >= SINCE), "rad/s"),
        ]
    if not short:
        half = Text(en="least distance changes with half the step by", pt_BR="menor distância muda com meio passo em")
        rows.append(run_row(half, None, 100 * abs(near[ALPHA, dt / 2] / near[ALPHA, dt] - 1), "%"))
    kept = symbol_value("α", ALPHA)
    desired = path_points(path_1, names[kept].t)[:, :2]
    apart = Text(en="distance between the arms", pt_BR="distância entre os braços")
    charts = (
        Chart(
            apart,
            IN_SECONDS,
            untranslated("ℓ"),
            tuple(ChartLine(name, *link_distances(one, second_arm)) for name, one in names.items()),
        ),
        cost_chart(names, "fig. 4.44"),
        errors_chart(names, "ℓ"),
        path_chart(
            {DESIRED: desired, **{name: tool_points(one, path_1) for name, one in names.items()}}, "x, ℓ", "y, ℓ"
        ),
        joints_chart(names[kept], kept),
        joint_velocity_chart(names[kept], kept),
    )
    return study_result(rows, charts, planar_motions(names))
