"""The curves of figs. 47 to 64: paths from two sides, distances to the planes, joints between their limits."""

from __future__ import annotations

import numpy as np

from helicoide.kinematics.chain import Array
from helicoide.studies.cerbaro_runs.chapter6_runs import CRITICAL, GUARDED, PLANES, WARNING, Runs
from helicoide.studies.cerbaro_runs.confined import Course, confined
from helicoide.studies.cerbaro_runs.runs import few
from helicoide.studies.study import Chart, Line
from helicoide.text import Text, same

TURN = Text(en="share of the turn", pt_BR="fração da volta")


def charts(runs: Runs) -> tuple[Chart, ...]:
    """Paths from above and from the side, distances, joints, of the case that is shown beside others."""
    course = runs.shown
    return (
        _paths(course, runs.guard, 0, same("x (mm)")),
        _paths(course, runs.guard, 2, same("z (mm)")),
        _distances(course, Text(en="Distances by the chosen rule", pt_BR="Distâncias pela regra escolhida")),
        _distances(runs.guard, Text(en="Distances by the guarded step", pt_BR="Distâncias pelo passo guardado")),
        *(_joint(runs, joint) for joint in (1, 2, 3)),
    )


def _share(values: Array) -> Array:
    return np.linspace(0.0, 1.0, len(values))


def _paths(course: Course, guard: Course, axis: int, up: Text) -> Chart:
    named = (
        (Text(en="desired", pt_BR="desejado"), course.desired),
        (Text(en="trimmed", pt_BR="recortado"), course.trimmed),
        (Text(en="by the rules", pt_BR="pelas regras"), course.tool),
        (Text(en="by the guarded step", pt_BR="pelo passo guardado"), guard.tool),
    )
    lines = tuple(Line(title, 1000 * few(p[:, 1]), 1000 * few(p[:, axis])) for title, p in named)
    above = Text(en="The path from above", pt_BR="O caminho visto de cima")
    ahead = Text(en="The path as the arm sees it", pt_BR="O caminho visto pelo braço")
    return Chart(above if axis == 0 else ahead, same("y (mm)"), up, lines)


def _distances(course: Course, title: Text) -> Chart:
    near = 1000 * few(course.near)
    x = _share(near)
    levels = (
        (Text(en="critical", pt_BR="crítica"), CRITICAL),
        (Text(en="warning", pt_BR="alerta"), WARNING),
    )
    lines = [Line(same(name), x, near[:, i]) for i, name in enumerate(PLANES)]
    lines += [Line(name, x[[0, -1]], np.full(2, level)) for name, level in levels]
    return Chart(title, TURN, Text(en="least distance (mm)", pt_BR="menor distância (mm)"), tuple(lines))


def _joint(runs: Runs, joint: int) -> Chart:
    limits = confined().limits
    lines = [
        Line(_case(case), _share(few(c.q)), np.degrees(few(c.q)[:, joint])) for case, c in sorted(runs.planes.items())
    ]
    lines.append(Line(GUARDED, _share(few(runs.guard.q)), np.degrees(few(runs.guard.q)[:, joint])))
    for name, bound in (
        (Text(en="lower limit", pt_BR="limite inferior"), limits.lower[joint]),
        (Text(en="upper limit", pt_BR="limite superior"), limits.upper[joint]),
    ):
        lines.append(Line(name, np.array([0.0, 1.0]), np.full(2, np.degrees(bound))))
    title = Text(en="J{joint} between its limits", pt_BR="J{joint} entre seus limites").format(joint=joint + 1)
    return Chart(title, TURN, same(f"J{joint + 1} (°)"), tuple(lines))


def _case(case: int) -> Text:
    return Text(en="case {case}", pt_BR="caso {case}").format(case=case)
