"""Sim. 15 of Vargas 2013: a limit of the elbow as one more row of the task."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import pi

from helicoide.ik.secondary import augmented
from helicoide.studies.study import Fitted, Progress, Result, Row, Statement
from helicoide.studies.vargas.arms import limited
from helicoide.studies.vargas.paths import path_1, places
from helicoide.studies.vargas.runs import Run, each, largest
from helicoide.studies.vargas.secondary import (
    ERROR_LATER,
    FASTEST_LATER,
    LENGTH,
    SECONDS,
    SINCE,
    chosen,
    cost_chart,
    filtered,
    follow,
    tool,
)
from helicoide.studies.vargas.table import (
    NULL,
    SMALL,
    WISHED,
    Gain,
    Step,
    errors_chart,
    fastest_chart,
    finished,
    joints_chart,
    over_time,
    planar_motions,
    rates_chart,
    row,
    stated,
    valued,
    way_chart,
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


def barrier(
    zeta: float | None, gain: float, dt: float, seconds: float, progress: Progress, elbow: float = MIDDLE
) -> Run:
    """Joint 2 kept at −1 ± ζ; α = 5, k = 10."""
    aiming = follow(path_1)
    if zeta is not None:
        here = limited(1, MIDDLE - zeta, MIDDLE + zeta)
        aiming = augmented(here, chosen("joint_barrier"), aiming)
    return filtered(aiming, (START[0], elbow, START[2]), gain, dt, progress, seconds)


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Without a limit, and with two."""
    dt = max(options.dt, 1e-2) if short else options.dt
    plans = {zeta: partial(barrier, zeta, options.gain, dt, SECONDS) for zeta in (None, *ZETAS)}
    runs = each(plans, progress)
    names = {FREE if zeta is None else valued("ζ", zeta): one for zeta, one in runs.items()}
    rows = [row(AWAY, FREE, largest(runs[None].q[:, 1] - MIDDLE), "rad")]
    for zeta in ZETAS:
        rows += statements(zeta, runs[zeta])
    rows += [row(FASTEST_LATER, name, largest(one.rates, one.t >= SINCE), "rad/s") for name, one in names.items()]
    limited_ones, kept = {name: names[name] for name in names if name is not FREE}, valued("ζ", ZETAS[0])
    wished = places(path_1, runs[None].t)[:, :2]
    charts = (
        over_time(Text(en="the elbow", pt_BR="o cotovelo"), "q₂, rad", names, lambda run: run.q[:, 1], PLACE),
        errors_chart(names, "ℓ", PLACE, log=True),
        cost_chart(limited_ones, PLACE),
        joints_chart(names[kept], kept, PLACE),
        rates_chart(names[kept], kept, PLACE),
        way_chart({WISHED: wished, **{name: tool(one, path_1) for name, one in names.items()}}, "x, ℓ", "y, ℓ"),
        fastest_chart(names),
    )
    return finished(rows, charts, planar_motions(names))


FREE = Text(en="no limit", pt_BR="sem limite")
AWAY = Text(en="largest |q₂ + 1|", pt_BR="maior |q₂ + 1|")


def statements(zeta: float, run: Run) -> list[Row]:
    """That the elbow stays within −1 ± ζ from the first instant, and what the path pays for it."""
    of = valued("ζ", zeta)
    said = Text(en="the limit −1 ± {zeta:g} is kept", pt_BR="o limite −1 ± {zeta:g} é mantido").format(zeta=zeta)
    kept = Statement(said, PLACE, zeta, "≤")
    null = stated("practically null error", "erro praticamente nulo", PLACE, NULL * LENGTH, "≤")
    small = stated("small errors", "erros pequenos", PLACE, SMALL * LENGTH, "≤")
    error = null if zeta == ZETAS[0] else small
    return [
        row(AWAY, of, largest(run.q[:, 1] - MIDDLE), "rad", kept, fitted=(ELBOW,)),
        row(ERROR_LATER, of, largest(run.size, run.t >= SINCE), "ℓ", error, fitted=(ELBOW,)),
    ]
