"""Sim. 15 of Vargas 2013: a limit of the elbow as one more row of the task."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi

from helicoide.ik.secondary import augmented
from helicoide.studies.study import Fitted, Progress, Result, Row, Statement
from helicoide.studies.vargas.arms import planar_with_limits
from helicoide.studies.vargas.paths import path_1, path_points
from helicoide.studies.vargas.readings import EXACT_STEP, LINKS
from helicoide.studies.vargas.runs import MethodRun, largest_absolute, run_each
from helicoide.studies.vargas.secondary import (
    ERROR_LATER,
    FASTEST_LATER,
    LENGTH,
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
    NULL,
    SMALL,
    Gain,
    Step,
    errors_chart,
    fastest_chart,
    joint_velocity_chart,
    joints_chart,
    over_time,
    path_chart,
    planar_motions,
    run_row,
    sentence_statement,
    study_result,
    symbol_value,
)
from helicoide.text import Text

TITLE = Text(en="Simulation 15: a limit of the elbow", pt_BR="Simulação 15: um limite do cotovelo")
SOURCE = "Vargas 2013, §4.7, sim. 15, figs. 4.39–4.40"
ABOUT = Text(
    en="""The arm has a redundant joint, and a steep barrier asks the elbow to stay within −1 ± ζ. Look at q₂: without \
the barrier it runs out of the range; with ζ = 0.5 it stays inside and the path is kept all the same; with ζ = 0.2 \
there is too little room, and the path pays.""",
    pt_BR="""O braço tem uma junta redundante, e uma barreira íngreme pede que o cotovelo fique em −1 ± ζ. Observe q₂: \
sem a barreira ele sai da faixa; com ζ = 0,5 fica dentro dela e o caminho é mantido mesmo assim; com ζ = 0,2 o espaço \
é pouco e o caminho paga.""",
)
ROBOT = "planar3r"
PLACE, MIDDLE = "sim. 15, figs. 4.39–4.40", -1.0
# the elbow begins in the middle of its range, which the source does not say
START = (pi / 6, MIDDLE, -pi / 6)
ELBOW = Fitted(Text(en="q₂ at the start", pt_BR="q₂ na partida"), MIDDLE, -1.15, -0.85, "rad")
ZETAS = (0.5, 0.2)


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 5.0
    dt: Step = 1e-3


def joint_barrier_run(
    zeta: float | None, gain: float, dt: float, seconds: float, progress: Progress, elbow: float = MIDDLE
) -> MethodRun:
    """Joint 2 kept at −1 ± ζ; α = 5, k = 10."""
    aiming = planar_tracking(path_1)
    if zeta is not None:
        here = planar_with_limits(1, MIDDLE - zeta, MIDDLE + zeta)
        aiming = augmented(here, single_objective("joint_barrier"), aiming)
    return run_modified_filter(aiming, (START[0], elbow, START[2]), gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Without a limit, and with two."""
    dt = max(options.dt, 1e-2) if short else options.dt
    plans = {zeta: partial(joint_barrier_run, zeta, options.gain, dt, SECONDS) for zeta in (None, *ZETAS)}
    runs = run_each(plans, progress)
    names = {FREE if zeta is None else symbol_value("ζ", zeta): one for zeta, one in runs.items()}
    rows = [run_row(AWAY, FREE, largest_absolute(runs[None].q[:, 1] - MIDDLE), "rad")]
    for zeta in ZETAS:
        rows += barrier_rows(zeta, runs[zeta])
    rows += [
        run_row(FASTEST_LATER, name, largest_absolute(one.joint_velocities, one.t >= SINCE), "rad/s")
        for name, one in names.items()
    ]
    limited_ones, kept = {name: names[name] for name in names if name is not FREE}, symbol_value("ζ", ZETAS[0])
    desired = path_points(path_1, runs[None].t)[:, :2]
    charts = (
        over_time(Text(en="the elbow", pt_BR="o cotovelo"), "q₂, rad", names, lambda run: run.q[:, 1], PLACE),
        errors_chart(names, "ℓ", PLACE, log=True),
        cost_chart(limited_ones, PLACE),
        joints_chart(names[kept], kept, PLACE),
        joint_velocity_chart(names[kept], kept, PLACE),
        path_chart(
            {DESIRED: desired, **{name: tool_points(one, path_1) for name, one in names.items()}}, "x, ℓ", "y, ℓ"
        ),
        fastest_chart(names),
    )
    return study_result(rows, charts, planar_motions(names))


FREE = Text(en="no limit", pt_BR="sem limite")
AWAY = Text(en="largest |q₂ + 1|", pt_BR="maior |q₂ + 1|")


def barrier_rows(zeta: float, run: MethodRun) -> list[Row]:
    """That the elbow stays within −1 ± ζ from the first instant, and what the path pays for it."""
    of = symbol_value("ζ", zeta)
    said = Text(en="the limit −1 ± {zeta:g} is kept", pt_BR="o limite −1 ± {zeta:g} é mantido").format(zeta=zeta)
    kept = Statement(said, PLACE, zeta, "≤")
    null = sentence_statement("practically null error", "erro praticamente nulo", PLACE, NULL * LENGTH, "≤")
    small = sentence_statement("small errors", "erros pequenos", PLACE, SMALL * LENGTH, "≤")
    error = null if zeta == ZETAS[0] else small
    return [
        run_row(AWAY, of, largest_absolute(run.q[:, 1] - MIDDLE), "rad", kept, fitted=(ELBOW, LINKS, EXACT_STEP)),
        run_row(
            ERROR_LATER,
            of,
            largest_absolute(run.error_norm, run.t >= SINCE),
            "ℓ",
            error,
            fitted=(ELBOW, LINKS, EXACT_STEP),
        ),
    ]
