"""The curves of figs. 47 to 64: paths, joints between their limits, errors and distances, three cases in one chart."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.studies.cerbaro_runs.chapter6_runs import (
    CASES,
    CONSTRAINED_STEP,
    CRITICAL,
    PLANES,
    WARNING,
    ConfinedRuns,
)
from helicoide.studies.cerbaro_runs.confined import CONTROL_PERIOD, ConfinedRun, confined_problem
from helicoide.studies.cerbaro_runs.runs import subsampled_loop
from helicoide.studies.study import Chart, ChartLine
from helicoide.text import Text, untranslated
from helicoide.trajectory import Ellipse

SHARE = Text(en="share of the path", pt_BR="fração do caminho")
ABOVE = Text(en="The path from above", pt_BR="O caminho visto de cima")
AHEAD = Text(en="The path as the arm sees it", pt_BR="O caminho visto pelo braço")
SPACE = Text(en="The path in space", pt_BR="O caminho no espaço")
# From where the pictures of a run in space are looked at: turned about z and from above, without perspective.
AZIMUTH, ELEVATION = np.radians(-50), np.radians(25)


def confined_charts(runs: ConfinedRuns, path: Ellipse, figures: tuple[int, int]) -> tuple[Chart, ...]:
    """All charts, the most important first. figures: numbers of the first and last figure of the source."""
    first, last = figures
    shown, whole = f"figs. {first}–{first + 2}", f"figs. {first}–{last}"
    turned = Text(en="across (mm)", pt_BR="na horizontal (mm)"), Text(en="up (mm)", pt_BR="na vertical (mm)")
    near = tuple(_distances(runs, _case(case), runs.cases[case], whole) for case in reversed(CASES))
    return (
        _paths(runs, ABOVE, np.eye(3)[[1, 0]], (untranslated("y (mm)"), untranslated("x (mm)")), shown),
        _paths(runs, SPACE, _seen(), turned, shown),
        _errors(runs, shown),
        *(_joints(runs, joints, shown) for joints in ((0, 4), (1,), (2,), (3,))),
        *near,
        _orientation(runs, path, shown),
        _paths(runs, AHEAD, np.eye(3)[[1, 2]], (untranslated("y (mm)"), untranslated("z (mm)")), shown),
        _distances(runs, CONSTRAINED_STEP, runs.constrained),
    )


def _case(case: int) -> Text:
    return Text(en="case {case}", pt_BR="caso {case}").format(case=case)


def _share(runs: ConfinedRuns, course: ConfinedRun) -> Array:
    """The share of the path at each sample; the constrained step may end before the whole turn."""
    end = CONTROL_PERIOD * len(course.q) / runs.period if course is runs.constrained else 1.0
    return subsampled_loop(np.linspace(0.0, end, len(course.q)))


def _seen() -> Array:
    """The horizontal and vertical axes of the view in space, (2, 3)."""
    (c, s), (c2, s2) = ((np.cos(angle), np.sin(angle)) for angle in (AZIMUTH, ELEVATION))
    return np.array([[-s, c, 0.0], [-s2 * c, -s2 * s, c2]])


def _paths(runs: ConfinedRuns, name: Text, view: Array, axes: tuple[Text, Text], figure: str) -> Chart:
    """The desired path, the trimmed path and the tool's paths, projected by the axes of a view (2, 3)."""
    first = runs.cases[1]
    named = [
        (Text(en="desired", pt_BR="desejado"), first.desired),
        (Text(en="trimmed", pt_BR="recortado"), first.trimmed),
        *((_case(case), course.tool) for case, course in runs.cases.items()),
        (CONSTRAINED_STEP, runs.constrained.tool),
    ]
    lines = tuple(ChartLine(title, *(1000 * view @ subsampled_loop(points).T)) for title, points in named)
    return Chart(name, *axes, lines, figure)


def _errors(runs: ConfinedRuns, figure: str) -> Chart:
    lines = []
    for case, course in runs.cases.items():
        x, name = _share(runs, course), _case(case)
        missed = Text(en="{case}: error", pt_BR="{case}: erro").format(case=name)
        left = Text(en="{case}: off the desired path", pt_BR="{case}: fora do caminho desejado").format(case=name)
        lines += [
            ChartLine(missed, x, 1000 * subsampled_loop(course.errors)),
            ChartLine(left, x, subsampled_loop(course.deviations)),
        ]
    lines.append(_level(untranslated("10 mm"), 10.0))
    name = Text(
        en="Position error, and how far the end effector is off the path",
        pt_BR="Erro de posição, e quanto o efetuador se desvia",
    )
    return Chart(name, SHARE, untranslated("mm"), tuple(lines), figure, log=True)


def _level(title: Text, value: float) -> ChartLine:
    return ChartLine(title, np.array([0.0, 1.0]), np.full(2, value))


def _joints(runs: ConfinedRuns, joints: tuple[int, ...], figure: str) -> Chart:
    limits, lines = confined_problem().limits, []
    for joint in joints:
        of = "" if len(joints) == 1 else f"J{joint + 1}, "
        for name, course in (
            *((_case(case), course) for case, course in runs.cases.items()),
            (CONSTRAINED_STEP, runs.constrained),
        ):
            q = np.degrees(subsampled_loop(course.q)[:, joint])
            lines.append(ChartLine(untranslated("{of}{name}").format(of=of, name=name), _share(runs, course), q))
        for name, bound in (
            (Text(en="{of}lower limit", pt_BR="{of}limite inferior"), limits.lower[joint]),
            (Text(en="{of}upper limit", pt_BR="{of}limite superior"), limits.upper[joint]),
        ):
            lines.append(_level(name.format(of=of), float(np.degrees(bound))))
    which = " ".join(f"J{joint + 1}" for joint in joints)
    title = Text(en="{which} between limits", pt_BR="{which} entre os limites").format(which=which)
    return Chart(title, SHARE, untranslated(f"{which} (°)"), tuple(lines), figure)


def _distances(runs: ConfinedRuns, of: Text, course: ConfinedRun, figure: str = "") -> Chart:
    near, x = 1000 * subsampled_loop(course.distances), _share(runs, course)
    lines = [ChartLine(name, x, near[:, i]) for i, name in enumerate(PLANES)]
    lines.append(_level(Text(en="safety distance", pt_BR="distância de segurança"), CRITICAL))
    lines.append(_level(Text(en="warning distance", pt_BR="distância de aviso"), WARNING))
    title = Text(en="Distances to the planes, {of}", pt_BR="Distâncias aos planos, {of}").format(of=of)
    return Chart(title, SHARE, Text(en="least distance (mm)", pt_BR="menor distância (mm)"), tuple(lines), figure)


def _orientation(runs: ConfinedRuns, path: Ellipse, figure: str) -> Chart:
    """‖vector part of Δq‖ of case 1, sin(θ/2); the error is a rotation about y and one about x (eqs. 91, 92)."""
    q = subsampled_loop(runs.cases[1].q)
    cosine = np.cos((path.pitch - q[:, 1:4].sum(axis=1)) / 2) * np.cos((path.roll - q[:, 4]) / 2)
    line = ChartLine(_case(1), _share(runs, runs.cases[1]), np.sqrt(np.maximum(0.0, 1 - cosine**2)))
    title = Text(en="Orientation error in case 1", pt_BR="Erro de orientação no caso 1")
    return Chart(title, SHARE, untranslated("‖Δq‖"), (line,), figure)
