"""A slab that the tool does not leave, after the joint limits of Vargas 2013, §4.7."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from helicoide.ik.secondary import augmented
from helicoide.studies.study import Progress, Result
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import path_1, path_points
from helicoide.studies.vargas.runs import MethodRun, largest_absolute, run_each
from helicoide.studies.vargas.secondary import (
    FASTEST_LATER,
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
    joint_velocity_chart,
    joints_chart,
    over_time,
    path_chart,
    planar_motions,
    run_row,
    study_result,
)
from helicoide.text import Text, with_decimal_comma

TITLE = Text(en="A slab that the end effector does not leave", pt_BR="Uma faixa de onde o efetuador não sai")
SOURCE = "Vargas 2013, §4.7, eq. 4.73"
ABOUT = Text(
    en="""The path swings between y = −0.5 and 0.5, and a barrier asks the end effector to stay within |y| < 0.3. Look \
at y: the steeper the barrier the nearer to its face the end effector goes, but it never touches it, and x is followed \
all the while.""",
    pt_BR="""O caminho oscila entre y = −0,5 e 0,5, e uma barreira pede que o efetuador fique em |y| < 0,3. Observe \
y: quanto mais íngreme a barreira, mais perto da face o efetuador chega, mas nunca a toca, e x é seguido o tempo \
todo.""",
)
ROBOT = "planar3r"
# α and k
CASES = ((0.0, 10), (5.0, 10), (1.0, 10), (5.0, 3))
USUAL, HALF = CASES[1], 0.3


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 5.0
    dt: Step = 5e-4


def slab_run(weight: float, steepness: int, gain: float, dt: float, seconds: float, progress: Progress) -> MethodRun:
    """|y| < 0.3 asked of the tool on trajectory 1."""
    aiming = planar_tracking(path_1)
    across = {"azimuth": np.pi / 2, "elevation": 0.0, "offset": 0.0, "half": HALF}
    if weight:
        aiming = augmented(
            planar_problem(), single_objective("slab", weight=weight, steepness=steepness, **across), aiming
        )
    return run_modified_filter(aiming, (0.45, -1, 0.4), gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Without a barrier, and with three; for 17 s in a quick run. The source has no slab: all numbers are ours."""
    dt, seconds = (max(options.dt, 1e-2), 17.0) if short else (options.dt, SECONDS)
    runs = run_each({key: partial(slab_run, *key, options.gain, dt, seconds) for key in CASES}, progress)
    names = {key: with_decimal_comma(f"α = {key[0]:g}, k = {key[1]}") for key in CASES}
    titled = {names[key]: one for key, one in runs.items()}
    kept, desired = runs[USUAL], path_points(path_1, runs[USUAL].t)[:, :2]
    farthest = Text(en="largest |y|", pt_BR="maior |y|")
    rows = [
        run_row(farthest, name, largest_absolute(tool_points(one, path_1)[:, 1]), "ℓ") for name, one in titled.items()
    ]
    late = kept.t >= SINCE
    along = Text(en="largest |e_x| from 2 s on", pt_BR="maior |e_x| a partir de 2 s")
    rows += [
        run_row(FASTEST_LATER, names[USUAL], largest_absolute(kept.joint_velocities, late), "rad/s"),
        run_row(along, names[USUAL], largest_absolute(kept.e[:, 0], late), "ℓ"),
    ]
    across = Text(en="across the slab", pt_BR="através da faixa")
    charts = (
        over_time(across, "y, ℓ", titled, lambda run: tool_points(run, path_1)[:, 1]),
        path_chart(
            {DESIRED: desired, **{name: tool_points(one, path_1) for name, one in titled.items()}}, "x, ℓ", "y, ℓ"
        ),
        cost_chart({names[key]: one for key, one in runs.items() if key[0]}, ""),
        joint_velocity_chart(kept, names[USUAL]),
        joints_chart(kept, names[USUAL]),
    )
    return study_result(rows, charts, planar_motions(titled))
