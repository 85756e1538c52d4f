"""What the three studies of chapter 6 say: the rows of the digest's table 5.5, and the curves of figs. 47 to 64."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik.adaptation import CAP, NONE, Rule, everywhere
from helicoide.ik.method import OneOf, Quantity
from helicoide.kinematics.chain import Array
from helicoide.studies.cerbaro_runs.confined import (
    CEILING,
    SAMPLES,
    SAMPLES_SHORT,
    Course,
    Gains,
    by_rule,
    confined,
    guarded,
    margins,
    source_rule,
)
from helicoide.studies.cerbaro_runs.runs import few, part
from helicoide.studies.study import FIGURE_ONLY, Chart, Line, Motion, Progress, Result, Row
from helicoide.text import Text, same
from helicoide.trajectory import Ellipse

CASES = (1, 2, 3)
PLANES = ("+z", "+y", "-y", "-z")
CRITICAL, WARNING = 80.0, 110.0
NEVER_BELOW = Text(en="never below 80 mm", pt_BR="nunca abaixo de 80 mm")
UNKNOWN_GAINS = Text(
    en="other gains than the digest’s; the source gives none (D7)",
    pt_BR="ganhos diferentes dos da síntese; a fonte não dá nenhum (D7)",
)
ORDER = Text(
    en="in which order planes hold a target back is not given, and it counts here",
    pt_BR="não se informa em que ordem os planos retêm o alvo, e aqui ela conta",
)
TURN = Text(en="share of the turn", pt_BR="fração da volta")
GUARDED = Text(en="cases 2 and 3, guarded step", pt_BR="casos 2 e 3, passo guardado")


@dataclass(frozen=True)
class Options:
    """What the source does not give (D7), by default as the digest assumed it; rule, case: of the run that is shown."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 0.0, 2000.0, "1/s")] = 500.0
    factor: Annotated[float, Quantity(Text(en="step factor κ", pt_BR="fator de passo κ"), 0.1, 1.0)] = 0.5
    tolerance: Annotated[float, Quantity(Text(en="inner tolerance", pt_BR="tolerância interna"), 0.1, 10.0, "mm")] = 1.0
    rule: Annotated[
        str,
        OneOf(
            Text(en="rule in the curves", pt_BR="regra nas curvas"),
            {
                "planes": Text(en="all points and planes", pt_BR="todos os pontos e planos"),
                "ceiling": Text(en="ceiling alone, eq. 36 corrected", pt_BR="só o teto, eq. 36 corrigida"),
                "printed": Text(en="ceiling alone, eq. 36 as printed", pt_BR="só o teto, eq. 36 como impressa"),
            },
        ),
    ] = "planes"
    case: Annotated[
        str,
        OneOf(
            Text(en="case in the curves", pt_BR="caso nas curvas"),
            {
                "1": Text(en="1, orientation held", pt_BR="1, orientação mantida"),
                "2": Text(en="2, one gain", pt_BR="2, um só ganho"),
                "3": Text(en="3, Algorithm 1", pt_BR="3, Algoritmo 1"),
            },
        ),
    ] = "3"

    @property
    def gains(self) -> Gains:
        """As the runs take them."""
        return Gains(self.gain, self.factor, self.tolerance * 1e-3)


DEFAULT = Options().gains
PRINTED = Rule((CEILING,), corrected=False, level=True)


@dataclass(frozen=True)
class Told:
    """A path in the digest's table 5.5, mm; by case.

    untouched: +z, trimmed only; ceiling: +z and +y by the source's rule; planes: +z, +y, −y, −z by the rule for all;
    deviation: mean, with that rule; ceiling_deviation: of case 1, with the source's; turned_down: how many samples eq.
    36 as printed gives up; undamped: deviation of case 3 without eq. 37; j3: worst margin of J3, degrees.
    """

    untouched: tuple[float, float, float]
    ceiling: tuple[tuple[float, float], ...]
    planes: Mapping[int, tuple[float, float, float, float]]
    deviation: Mapping[int, float]
    turned_down: int
    undamped: float
    ceiling_deviation: float | None = None
    j3: Mapping[int, float] | None = None
    far: bool = False


@dataclass(frozen=True, eq=False)
class Runs:
    """Every run of a path, those of a kind by case; shown: that of the options; guard: cases 2 and 3, guarded."""

    untouched: Mapping[int, Course]
    ceiling: Mapping[int, Course]
    planes: Mapping[int, Course]
    guard: Course
    shown: Course
    printed: Course | None = None
    undamped: Course | None = None


def study(path: Ellipse, told: Told, options: Options, short: bool, progress: Progress) -> Result:
    """All runs of a path and what they say; short: 121 samples, one case, a third of the guarded turn."""
    runs = _short(path, options, progress) if short else _whole(path, options, progress)
    rows = promises(runs) if short else (*table(runs, told, options), *promises(runs))
    times = np.linspace(0.0, path.period, len(runs.shown.q))
    return Result(rows, charts(runs), Motion("movemaster", times, runs.shown.q))


def _whole(path: Ellipse, options: Options, progress: Progress) -> Runs:
    every, gains = everywhere(confined().planes), options.gains
    kinds = [(NONE, case) for case in CASES] + [(source_rule(), case) for case in CASES] + [(every, c) for c in CASES]
    kinds += [(PRINTED, 3), (Rule(every.watched, damps=False), 3)]
    count = len(kinds) + 1
    runs = [by_rule(path, case, gains, rule, SAMPLES, part(progress, i, count)) for i, (rule, case) in enumerate(kinds)]
    untouched, ceiling, planes = (dict(zip(CASES, runs[i : i + 3], strict=True)) for i in (0, 3, 6))
    guard = guarded(path, gains.k0, path.period, part(progress, count - 1, count))
    known = {"planes": planes, "ceiling": ceiling, "printed": {3: runs[9]}}[options.rule]
    case = int(options.case)
    shown = known[case] if case in known else by_rule(path, case, gains, PRINTED, SAMPLES, _unheard)
    return Runs(untouched, ceiling, planes, guard, shown, printed=runs[9], undamped=runs[10])


def _short(path: Ellipse, options: Options, progress: Progress) -> Runs:
    every, case, gains = everywhere(confined().planes), int(options.case), options.gains
    untouched = by_rule(path, case, gains, NONE, SAMPLES_SHORT, part(progress, 0, 4))
    planes = by_rule(path, case, gains, every, SAMPLES_SHORT, part(progress, 1, 4))
    guard = guarded(path, options.gain, path.period / 3, part(progress, 2, 4))
    other = {"ceiling": source_rule(), "printed": PRINTED}.get(options.rule)
    shown = by_rule(path, case, gains, other, SAMPLES_SHORT, part(progress, 3, 4)) if other else planes
    return Runs({case: untouched}, {}, {case: planes}, guard, shown)


def _unheard(share: float) -> None:
    """The progress of one run more than was counted on."""


def table(runs: Runs, told: Told, options: Options) -> tuple[Row, ...]:
    """The rows of the digest's table, with its assumed gains."""
    excuse = None if options.gains == DEFAULT else UNKNOWN_GAINS
    order = excuse or (ORDER if told.far else None)
    rows = []
    for case in CASES:
        doubt = "D6" if told.far and case == 1 else ""
        rows.append(_least(case, _TRIMMED, runs.untouched[case], 0, told.untouched[case - 1], excuse, doubt))
        for plane in (0, 1):
            rows.append(_least(case, _CEILING, runs.ceiling[case], plane, told.ceiling[case - 1][plane], excuse, doubt))
        for plane, value in enumerate(told.planes.get(case, ())):
            rows.append(_least(case, _PLANES, runs.planes[case], plane, value, order))
        if case in told.deviation:
            rows.append(_deviation(case, _PLANES, runs.planes[case], told.deviation[case], order))
        if told.j3 and case in told.j3:
            margin = float(margins(confined(), runs.planes[case].q)[2])
            rows.append(Row(_margin(case, "J3"), margin, told.j3[case], 0.06, "°", FIGURE_ONLY, assumed=excuse))
    if told.ceiling_deviation is not None:
        rows.append(_deviation(1, _CEILING, runs.ceiling[1], told.ceiling_deviation, excuse))
    return (*rows, *_one_rule_less(runs, told, excuse))


def _one_rule_less(runs: Runs, told: Told, excuse: Text | None) -> tuple[Row, ...]:
    assert runs.printed is not None
    assert runs.undamped is not None
    given_up = Text(
        en="case 3, eq. 36 as printed: samples given up", pt_BR="caso 3, eq. 36 como impressa: amostras abandonadas"
    )
    return (
        _least(3, _PRINTED, runs.printed, CEILING, 72.75, excuse),
        Row(given_up, int((runs.printed.moved >= CAP).sum()), told.turned_down, assumed=excuse),
        _at_least(_of(3, _UNDAMPED), runs.undamped),
        _deviation(3, _UNDAMPED, runs.undamped, told.undamped, excuse),
    )


def promises(runs: Runs) -> tuple[Row, ...]:
    """What has to hold whatever the gains: 80 mm to every plane, 10 mm to the target; and what case 1 costs."""
    rows: list[Row] = []
    for kind, courses in ((_CEILING, runs.ceiling), (_PLANES, runs.planes)):
        for case, course in courses.items():
            least = course.least[:1] if kind is _CEILING else course.least
            rows.append(_at_least(_of(case, kind), course, float(least.min())))
    rows += [_error(case, course) for case, course in runs.planes.items() if case != 1]
    if 1 in runs.planes:
        worst = margins(confined(), runs.planes[1].q)
        joint = f"J{int(worst.argmin()) + 1}"
        outside = Text(en="joint limits left", pt_BR="limites de junta violados")
        rows.append(Row(_margin(1, joint), float(worst.min()), unit="°", source=outside))
    guard = runs.guard
    inside = Text(en="{of}: least joint margin", pt_BR="{of}: menor folga de junta").format(of=GUARDED)
    mean = Text(en="{of}: mean deviation from the path", pt_BR="{of}: desvio médio do caminho").format(of=GUARDED)
    rows.append(_at_least(GUARDED, guard))
    rows.append(Row(inside, float(margins(confined(), guard.q).min()), unit="°"))
    rows.append(Row(mean, guard.deviation, unit="mm"))
    return tuple(rows)


_TRIMMED = Text(en="trimmed only", pt_BR="só recortado")
_CEILING = Text(en="rule for the ceiling", pt_BR="regra do teto")
_PLANES = Text(en="rule for all planes", pt_BR="regra de todos os planos")
_PRINTED = Text(en="eq. 36 as printed", pt_BR="eq. 36 como impressa")
_UNDAMPED = Text(en="all planes, without eq. 37", pt_BR="todos os planos, sem a eq. 37")


def _of(case: int, kind: Text) -> Text:
    return Text(en="case {case}, {kind}", pt_BR="caso {case}, {kind}").format(case=case, kind=kind)


def _least(
    case: int, kind: Text, course: Course, plane: int, digest: float, assumed: Text | None, doubt: str = ""
) -> Row:
    quantity = Text(en="{of}: least distance to {plane}", pt_BR="{of}: menor distância a {plane}")
    named = quantity.format(of=_of(case, kind), plane=PLANES[plane])
    ours = float(course.least[plane])
    return Row(named, ours, digest, 0.16, "mm", FIGURE_ONLY, doubt=doubt, assumed=assumed)


def _deviation(case: int, kind: Text, course: Course, digest: float, assumed: Text | None) -> Row:
    quantity = Text(en="{of}: mean deviation from the path", pt_BR="{of}: desvio médio do caminho")
    named = quantity.format(of=_of(case, kind))
    return Row(named, course.deviation, digest, 0.6, "mm", FIGURE_ONLY, assumed=assumed)


def _margin(case: int, joint: str) -> Text:
    return Text(
        en="case {case}: least margin of {joint} to its limits", pt_BR="caso {case}: menor folga de {joint} aos limites"
    ).format(case=case, joint=joint)


def _at_least(of: Text, course: Course, least: float | None = None) -> Row:
    quantity = Text(en="{of}: least distance", pt_BR="{of}: menor distância").format(of=of)
    ours = float(course.least.min()) if least is None else least
    return Row(quantity, ours, CRITICAL, 1e-6, "mm", NEVER_BELOW, "≥")


def _error(case: int, course: Course) -> Row:
    quantity = Text(en="case {case}: largest position error", pt_BR="caso {case}: maior erro de posição")
    return Row(quantity.format(case=case), float(1000 * course.errors.max()), 10.0, 0.0, "mm", "< 10 mm", "≤")


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
