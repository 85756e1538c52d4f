"""Figs. 4.43 and 4.44 of Vargas 2013: the arm makes way for a second arm in motion."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from helicoide.ik.arm_points import watched
from helicoide.ik.secondary import augmented
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses
from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arms import planar
from helicoide.studies.vargas.paths import path_1
from helicoide.studies.vargas.runs import Run, each, largest
from helicoide.studies.vargas.secondary import SECONDS, chosen, filtered, follow, nearest
from helicoide.studies.vargas.table import (
    NEAREST_AFTER_3,
    WORST_AFTER_3,
    Gain,
    Step,
    errors_chart,
    planar_motions,
    rates_chart,
)
from helicoide.text import Text, same

TITLE = Text(en="Two arms", pt_BR="Dois braços")
SOURCE = "Vargas 2013, §4.7, figs. 4.43–4.44"
ABOUT = Text(
    en="""A second arm works on the other side of the table and reaches into the path of the first. Each of its \
points carries a hill of cost that moves with it. Look at the least distance: without the term the arms meet; with α \
= 5 the first one gives way, and leaves its path by half a link while it does.""",
    pt_BR="""Um segundo braço trabalha do outro lado da mesa e invade o caminho do primeiro. Cada um de seus pontos \
carrega uma colina de custo que se move com ele. Observe a menor distância: sem o termo os braços se encontram; com α \
= 5 o primeiro cede e, enquanto cede, sai do caminho por meio elo.""",
)
ROBOT = "planar3r"
ASSUMED = Text(
    en="the second arm, its motion and points; between which points the distance counts",
    pt_BR="o segundo braço, seu movimento e pontos; entre quais pontos se mede a distância",
)
# α: of the digest from 3 s on, least distance, largest error, fastest joint, rad/s; how far the distance may be off:
# the digest does not say between which points it measures. With α = 5 it is that at 3 s, where the arms are parting.
# Last: the share of the distance that the short form may miss.
CASES: dict[float, tuple[str, str, str, float, float | None]] = {
    0.0: ("0.001", "0", "0.11", 2e-3, 19.0),
    1.0: ("0.011", "0.94", "2.6", 0.011, None),
    5.0: ("0.133", "0.50", "1.0", 2e-3, 0.24),
}


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 5.0
    dt: Step = 2e-3


def second_arm(t: float, per_link: int = 4) -> Array:
    """Points of the second arm, a planar 3R on a base at (4.5, 0), (3 · per_link, 3), m."""
    robot = planar().robot
    q = np.array([np.pi - 0.5 + 0.3 * np.sin(0.3 * t), 0.6 + 0.2 * np.sin(0.4 * t), 0.4])
    points: Array = watched(robot, "links", per_link).at(link_poses(robot.chain, q))
    return np.asarray(points + np.array([4.5, 0, 0]))


def beside_it(weight: float, gain: float, dt: float, seconds: float, progress: Progress) -> Run:
    """Four points on each link see twelve points of the other arm."""
    hills = chosen("second_arm", weight=weight, radius=0.2)
    aiming = augmented(planar(), hills, follow(path_1), second_arm)
    return filtered(aiming, (0.6, -1.2, 0.4), gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Without a hill and with two heights; for 16 s, half the time, in the short form."""
    sheet, seconds = Sheet(short, is_changed(options)), SECONDS / 2 if short else SECONDS
    dt = max(options.dt, 5e-3) if short else options.dt
    plans = {alpha: partial(beside_it, alpha, options.gain, dt, seconds) for alpha in CASES}
    runs = each(plans, progress)
    rows = []
    for alpha, (near, error, fastest, off, coarse) in CASES.items():
        of, late = same(f"α = {alpha:g}"), runs[alpha].t >= 3.0 - 1e-9
        distance = nearest(runs[alpha], 3.0, second_arm)
        worst, rates = float(runs[alpha].size[late].max()), largest(runs[alpha].rates, late)
        rows += [
            sheet.row(NEAREST_AFTER_3, of, distance, near, "ℓ", within=off, coarse=coarse, assumed=ASSUMED),
            sheet.row(WORST_AFTER_3, of, worst, error, "ℓ", within=5e-3, assumed=ASSUMED),
            sheet.row(FASTEST_AFTER_3, of, rates, fastest, "rad/s", within=0.05, assumed=ASSUMED),
        ]
    names = {same(f"α = {alpha:g}"): one for alpha, one in runs.items()}
    return Result(
        tuple(rows), (errors_chart(names, "ℓ"), rates_chart(runs[5.0], same("α = 5"))), planar_motion(runs[5.0])
    )
