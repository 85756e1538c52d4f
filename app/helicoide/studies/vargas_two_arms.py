"""Figs. 4.43 and 4.44 of Vargas 2013: the arm makes way for a second arm in motion."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from helicoide.arrays import Array
from helicoide.ik.arm_points import watched
from helicoide.ik.secondary import augmented
from helicoide.kinematics.forward import link_poses
from helicoide.studies.study import Chart, Line, Progress, Result
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import path_1, places
from helicoide.studies.vargas.runs import Run, each, largest
from helicoide.studies.vargas.secondary import (
    ERROR_LATER,
    FASTEST_LATER,
    NEAREST_LATER,
    SECONDS,
    SINCE,
    chosen,
    cost_chart,
    distances,
    filtered,
    follow,
    nearest,
    tool,
)
from helicoide.studies.vargas.table import SECONDS as IN_SECONDS
from helicoide.studies.vargas.table import (
    WISHED,
    Gain,
    Step,
    errors_chart,
    finished,
    joints_chart,
    planar_motions,
    rates_chart,
    row,
    valued,
    way_chart,
)
from helicoide.text import Text, same

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
    robot = planar().robot
    q = np.array([np.pi - 0.5 + 0.3 * np.sin(0.3 * t), 0.6 + 0.2 * np.sin(0.4 * t), 0.4])
    points: Array = watched(robot, "links", per_link).at(link_poses(robot.chain, q))
    return np.asarray(points + np.array([base, 0, 0]))


def beside_it(
    weight: float,
    gain: float,
    dt: float,
    progress: Progress,
    radius: float = RADIUS,
    base: float = BASE,
) -> Run:
    """A run in which four points on each link keep away from twelve points of the second arm.

    weight: height α of the cost of each point; gain: γ; dt, s; radius: of the cost, ℓ; base: x of the second arm, ℓ.
    """
    hills = chosen("second_arm", weight=weight, radius=radius)
    aiming = augmented(planar(), hills, follow(path_1), lambda t: second_arm(t, base=base))
    return filtered(aiming, (0.6, -1.2, 0.4), gain, dt, progress, SECONDS)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Runs without a cost and with two heights of it."""
    dt = max(options.dt, 8e-3) if short else options.dt
    plans = {(alpha, dt): partial(beside_it, alpha, options.gain, dt) for alpha in WEIGHTS}
    if not short:
        plans[ALPHA, dt / 2] = partial(beside_it, ALPHA, options.gain, dt / 2)
    runs = each(plans, progress)
    near = {key: nearest(one, second_arm) for key, one in runs.items()}
    names = {valued("α", alpha): runs[alpha, dt] for alpha in WEIGHTS}
    rows = []
    for alpha, (name, one) in zip(WEIGHTS, names.items(), strict=True):
        rows += [
            row(NEAREST_LATER, name, near[alpha, dt], "ℓ"),
            row(ERROR_LATER, name, largest(one.size, one.t >= SINCE), "ℓ"),
            row(FASTEST_LATER, name, largest(one.rates, one.t >= SINCE), "rad/s"),
        ]
    if not short:
        half = Text(en="least distance changes with half the step by", pt_BR="menor distância muda com meio passo em")
        rows.append(row(half, None, 100 * abs(near[ALPHA, dt / 2] / near[ALPHA, dt] - 1), "%"))
    kept = valued("α", ALPHA)
    wished = places(path_1, names[kept].t)[:, :2]
    apart = Text(en="distance between the arms", pt_BR="distância entre os braços")
    charts = (
        Chart(
            apart,
            IN_SECONDS,
            same("ℓ"),
            tuple(Line(name, *distances(one, second_arm)) for name, one in names.items()),
        ),
        cost_chart(names, "fig. 4.44"),
        errors_chart(names, "ℓ"),
        way_chart({WISHED: wished, **{name: tool(one, path_1) for name, one in names.items()}}, "x, ℓ", "y, ℓ"),
        joints_chart(names[kept], kept),
        rates_chart(names[kept], kept),
    )
    return finished(rows, charts, planar_motions(names))
