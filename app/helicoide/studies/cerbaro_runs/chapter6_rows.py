"""The rows of the digest's table 5.5, and what has to hold whatever the gains are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from helicoide.ik.adaptation import CAP
from helicoide.studies.cerbaro_runs.chapter6_runs import CASES, CRITICAL, GUARDED, PLANES, Options, Runs
from helicoide.studies.cerbaro_runs.confined import CEILING, Course, confined, margins
from helicoide.studies.study import FIGURE_ONLY, Row
from helicoide.text import Text

NEVER_BELOW = Text(en="never below 80 mm", pt_BR="nunca abaixo de 80 mm")
UNKNOWN_GAINS = Text(
    en="other gains than the digest’s; the source gives none (D7)",
    pt_BR="ganhos diferentes dos da síntese; a fonte não dá nenhum (D7)",
)
ORDER = Text(
    en="in which order planes hold a target back is not given, and it counts here",
    pt_BR="não se informa em que ordem os planos retêm o alvo, e aqui ela conta",
)
DEFAULT = Options().gains


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
