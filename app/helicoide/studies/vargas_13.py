"""Sim. 13 of Vargas 2013: a path that leaves the workspace, by the modified filtered inverse."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from helicoide.studies.study import Figure, Interpretation, Progress, Result, Row
from helicoide.studies.vargas.arms import FOLDED
from helicoide.studies.vargas.paths import path_8
from helicoide.studies.vargas.position_arm import (
    DAMPING,
    FASTEST_LATER,
    LARGEST_ACCELERATION,
    SINCE,
    Drawing,
    border_dips,
    border_distance,
    errors_after_return,
    position_result,
    run_on_zebra,
)
from helicoide.studies.vargas.reach import AFTER, reach_rows
from helicoide.studies.vargas.readings import EXACT_STEP, EXPONENT
from helicoide.studies.vargas.runs import MethodRun, MethodSettings, largest_absolute, method_settings
from helicoide.studies.vargas.table import MUCH, SIMILAR, GainInCm, Step, run_row, sentence_statement, with_step
from helicoide.text import Text

TITLE = Text(en="Simulation 13: out of reach, at rest", pt_BR="Simulação 13: fora do alcance, em repouso")
SOURCE = "Vargas 2013, §4.6, sim. 13, figs. 4.29–4.33"
ABOUT = Text(
    en="""The path of simulation 12 by the modified law, q̇ = ΘΘᵀJᵀν, which drops what the arm cannot reach. Look at \
the error out of reach: the elbow does not swing any more, and the effector rests on the border at the point nearest \
to the path. Half a second after the return the larger γ has the arm back on the path, the smaller one has not.""",
    pt_BR="""O caminho da simulação 12 pela lei modificada, q̇ = ΘΘᵀJᵀν, que descarta o que o braço não alcança. \
Observe o erro fora do alcance: o cotovelo já não oscila e o efetuador repousa na fronteira, no ponto mais próximo do \
caminho. Meio segundo depois da volta o γ maior já o tem de novo no caminho; o menor, não.""",
)
ROBOT = "zebra_zero"
PLACE, TIMES = "sim. 13, figs. 4.29–4.33", (1, 25)
SIMILAR_THEN = Interpretation(
    Text(en="0.5 s after coming back, no longer at 1 s", pt_BR="0,5 s após a volta, a 1 s não mais"),
    Text(en="1.0 times at 0.25 s and 0.07 times at 1 s", pt_BR="1,0 vez a 0,25 s e 0,07 vez a 1 s"),
)
SMALL_THEN = Interpretation(
    Text(en="0.5 s after coming back", pt_BR="0,5 s após a volta"),
    Text(en="0.04 times at 0.25 s and 0.06 times at 1 s", pt_BR="0,04 vez a 0,25 s e 0,06 vez a 1 s"),
)


@dataclass(frozen=True)
class Options:
    """gain: the smaller γ, 1/(cm² s), beside twenty-five times it; dt, s."""

    gain: GainInCm = 1.0
    dt: Step = 2.5e-4

    @property
    def ways(self) -> dict[str, MethodSettings]:
        """The modified filtered inverse with each γ, and what it is compared with."""
        modified = {
            f"modified_{times}": method_settings(
                "filtered_modified", f"γ = {times * self.gain:g}", gain=times * self.gain
            )
            for times in TIMES
        }
        return {**modified, "damping": DAMPING}


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three methods on trajectory 8 for 20 s, 15 s in a quick run."""
    ways = options.ways
    dt, seconds = (max(options.dt, 2e-3), 15.0) if short else (options.dt, 20.0)
    runs = run_on_zebra(path_8, FOLDED, ways, dt, seconds, progress)
    rows = _statements(runs, dt)
    for times in TIMES:
        rows += reach_rows(ways[f"modified_{times}"], runs[f"modified_{times}"], Figure(PLACE), dt)
    off = Text(
        en="largest distance from the nearest point of the border", pt_BR="maior distância ao ponto da fronteira"
    )
    rows.append(run_row(off, ways["modified_25"].title, border_distance(runs["modified_25"]), "cm"))
    drawing = Drawing(path_8, (0, 1), PLACE, "figs. 4.29–4.30")
    return position_result(rows, ways, runs, drawing, ("modified_25", "modified_1"))


def _statements(runs: Mapping[str, MethodRun], dt: float) -> list[Row]:
    """No oscillation; the smaller γ beside the damped; the larger one beside the smaller."""
    small, large, damped = (runs[key] for key in ("modified_1", "modified_25", "damping"))
    later = small.t >= SINCE

    def fastest(run: MethodRun) -> float:
        return largest_absolute(run.joint_velocities, later)

    def push(run: MethodRun) -> float:
        return largest_absolute(run.joint_acceleration, later[1:])

    dip = Text(en="dips behind the border, with both γ", pt_BR="recuos atrás da fronteira, com os dois γ")
    swings = sentence_statement("no oscillation", "sem oscilação", PLACE, 0.0)
    similar = sentence_statement(
        "γ = 1: similar to the damped one", "γ = 1: semelhante à amortecida", PLACE, 1.0, "=", SIMILAR
    )
    smoother = sentence_statement(
        "γ = 1: smoother than the damped one", "γ = 1: mais suave que a amortecida", PLACE, 1.0, "<"
    )
    detour = sentence_statement("γ = 25: small detour", "γ = 25: pequeno desvio", PLACE, 1 / MUCH, "<")
    unchanged = sentence_statement(
        "amplitude of q̇ not significantly changed", "amplitude de q̇ sem mudança significativa", PLACE, 1.0, "=", SIMILAR
    )
    ratios = (
        (
            TO_DAMPED,
            AFTER,
            error_after_return(small) / error_after_return(damped),
            similar,
            (SIMILAR_THEN, EXACT_STEP, EXPONENT),
        ),
        (TO_DAMPED, LARGEST_ACCELERATION, push(small) / push(damped), smoother, (EXACT_STEP, EXPONENT)),
        (TO_SMALLER, AFTER, error_after_return(large) / error_after_return(small), detour, (SMALL_THEN, EXACT_STEP)),
        (TO_SMALLER, FASTEST_LATER, fastest(large) / fastest(small), unchanged, (EXACT_STEP,)),
    )
    rows = [
        run_row(
            dip, None, float(border_dips(large)[0].size + border_dips(small)[0].size), "", swings, fitted=(EXACT_STEP,)
        ),
        *(
            run_row(with_step(of.format(what=what), dt), None, value, "", said, fitted=chosen)
            for of, what, value, said, chosen in ratios
        ),
    ]
    if dt <= 1e-3:  # how near to 0 it comes, a longer step does not tell
        least = [float(one.w[later].min()) for one in (large, small)]
        lower = sentence_statement("γ = 25: lower w is reached", "γ = 25: w menor é atingida", PLACE, 1.0, "<")
        w = Text(en="least w from 5 s on", pt_BR="menor w a partir de 5 s")
        title = with_step(TO_SMALLER.format(what=w), dt)
        rows.append(run_row(title, None, least[0] / least[1], "", lower, fitted=(EXACT_STEP,)))
    return rows


TO_DAMPED = Text(en="{what}, smaller γ over damped", pt_BR="{what}, γ menor sobre amortecida")
TO_SMALLER = Text(en="{what}, larger γ over smaller γ", pt_BR="{what}, γ maior sobre γ menor")


def error_after_return(run: MethodRun) -> float:
    """‖e‖, cm, half a second after the path has come back."""
    return errors_after_return(run)[1]
