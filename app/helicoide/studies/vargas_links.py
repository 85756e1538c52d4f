"""Fig. 4.42 of Vargas 2013: the links make way for an obstacle while the tool keeps to its path."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from helicoide.studies.study import Fitted, Interpretation, Progress, Result, Row
from helicoide.studies.vargas.paths import path_5, path_points
from helicoide.studies.vargas.readings import EXACT_STEP, links
from helicoide.studies.vargas.runs import MethodRun, largest_absolute, run_each
from helicoide.studies.vargas.secondary import (
    ERROR_LATER,
    LENGTH,
    NEAREST_LATER,
    SECONDS,
    SINCE,
    cost_chart,
    obstacle_near_links,
    tool_points,
)
from helicoide.studies.vargas.table import (
    DESIRED,
    NULL,
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
)
from helicoide.text import Text, untranslated

TITLE = Text(en="An obstacle beside the links", pt_BR="Um obstáculo ao lado dos elos")
SOURCE = "Vargas 2013, §4.7, fig. 4.42"
ABOUT = Text(
    en="""The obstacle stands beside the arm, not beside the path. Play the run: with eight points on each link that \
see it, the arm folds out of the way and the end effector hardly leaves its path. Seen by the ends of the links alone, \
it slips in between them in two of the three places.""",
    pt_BR="""O obstáculo está ao lado do braço, não do caminho. Veja a simulação: com oito pontos em cada elo que o \
percebem, o braço se dobra para dar passagem e o efetuador quase não sai do caminho. Visto só pelas pontas dos elos, \
ele passa entre elas em dois dos três lugares.""",
)
ROBOT = "planar3r"
PLACE = "fig. 4.42"
# places of the obstacle, which the source does not print, the last of them near the path; points of a link that see it
FAR, NEAR = ((0.6, 1.15), (0.85, 1.55)), (1.8, 1.4)
POINTS = (0, 8, 1)
CHOSEN = (
    Fitted(untranslated("α"), 2.0, 0.5, 3.0, "s⁻¹"),
    Fitted(untranslated("γ"), 100.0, 25.0, 1000.0, "ℓ⁻² s⁻¹"),
    Interpretation(
        Text(
            en="start (0.9, −1.2, −0.6) and these places of the obstacle",
            pt_BR="partida (0,9; −1,2; −0,6) e estes lugares do obstáculo",
        ),
        Text(
            en="at (1.8, 1.4), near the path, the error is 0.011 ℓ",
            pt_BR="em (1,8; 1,4), perto do caminho, o erro é 0,011 ℓ",
        ),
    ),
    links(
        Text(
            en="with 1, 2, 1 the error is 0.083 ℓ with the obstacle at (0.6, 1.15)",
            pt_BR="com 1; 2; 1 o erro é 0,083 ℓ com o obstáculo em (0,6; 1,15)",
        )
    ),
    EXACT_STEP,
)
Key = tuple[tuple[float, float], int]
CASES: tuple[Key, ...] = tuple((mu, points) for mu in (*FAR, NEAR) for points in POINTS)
SEEN = {
    0: Text(en="without the term", pt_BR="sem o termo"),
    1: Text(en="seen by the ends of the links", pt_BR="visto pelas pontas dos elos"),
    8: Text(en="seen by 8 points on each link", pt_BR="visto por 8 pontos em cada elo"),
}


@dataclass(frozen=True)
class Options:
    """gain: γ; dt, s."""

    gain: Gain = 100.0
    dt: Step = 1e-3


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Three obstacles, seen by none, one and eight points on each link; for 16 s, half the time, in a quick run."""
    dt, seconds = (max(options.dt, 1e-2), SECONDS / 2) if short else (options.dt, SECONDS)
    distances: dict[Key, float] = {}

    def one(key: Key) -> Callable[[Progress], MethodRun]:
        def go(reported: Progress) -> MethodRun:
            found, distances[key] = obstacle_near_links(*key, options.gain, dt, seconds, reported)
            return found

        return go

    runs = run_each({key: one(key) for key in CASES}, progress)
    names, seen = {key: _name(key) for key in CASES}, {key: _name(key) for key in CASES if key[1] == 8}
    rows = _statements(runs, distances)
    rows += [run_row(NEAREST_LATER, names[key], distance, "ℓ") for key, distance in distances.items()]
    rows.append(
        run_row(ERROR_LATER, names[NEAR, 8], largest_absolute(runs[NEAR, 8].error_norm, runs[NEAR, 8].t >= SINCE), "ℓ")
    )
    first, shown = next(iter(seen)), {name: runs[key] for key, name in seen.items()}
    desired = path_points(path_5, runs[first].t)[:, :2]
    charts = (
        errors_chart(shown, "ℓ", PLACE, log=True),
        cost_chart(shown, PLACE),
        path_chart(
            {DESIRED: desired, **{name: tool_points(one, path_5) for name, one in shown.items()}}, "x, ℓ", "y, ℓ", PLACE
        ),
        joints_chart(runs[first], names[first], PLACE),
        joint_velocity_chart(runs[first], names[first], PLACE),
        fastest_chart(shown),
    )
    return study_result(rows, charts, planar_motions({names[key]: run for key, run in runs.items()}))


def _statements(runs: dict[Key, MethodRun], distances: dict[Key, float]) -> list[Row]:
    """The arm folds out of the way, and the tool keeps to its path while the obstacle is far from it."""
    folds = sentence_statement("internal reconfiguration", "reconfiguração interna", PLACE, 1.0, ">")
    null = sentence_statement(
        "null error while the obstacle is far from the target",
        "erro nulo com o obstáculo longe do alvo",
        PLACE,
        NULL * LENGTH,
        "≤",
    )
    ratio = Text(en="{near}, over that without the term", pt_BR="{near}, sobre a sem o termo")
    return [
        found
        for mu in FAR
        for found in (
            run_row(
                ratio.format(near=NEAREST_LATER),
                _name((mu, 8)),
                distances[mu, 8] / distances[mu, 0],
                "",
                folds,
                fitted=CHOSEN,
            ),
            run_row(
                ERROR_LATER,
                _name((mu, 8)),
                largest_absolute(runs[mu, 8].error_norm, runs[mu, 8].t >= SINCE),
                "ℓ",
                null,
                fitted=CHOSEN,
            ),
        )
    ]


def _name(key: Key) -> Text:
    (x, y), points = key
    named = Text(en="μ = ({x:g}, {y:g}), {seen}", pt_BR="μ = ({x:g}; {y:g}), {seen}")
    return named.format(x=x, y=y, seen=SEEN[points])
