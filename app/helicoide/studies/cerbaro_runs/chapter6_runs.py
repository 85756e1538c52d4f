"""The runs of a path of chapter 6: by each rule in each case, and by the guarded step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

from helicoide.ik.adaptation import NONE, Rule, everywhere
from helicoide.ik.method import OneOf, Quantity
from helicoide.studies.cerbaro_runs.confined import (
    CEILING,
    SAMPLES,
    SAMPLES_SHORT,
    Course,
    Gains,
    by_rule,
    confined,
    guarded,
    source_rule,
)
from helicoide.studies.cerbaro_runs.runs import part
from helicoide.studies.study import Progress
from helicoide.text import Text
from helicoide.trajectory import Ellipse

CASES = (1, 2, 3)
PLANES = ("+z", "+y", "-y", "-z")
CRITICAL, WARNING = 80.0, 110.0
PRINTED = Rule((CEILING,), corrected=False, level=True)
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


def whole(path: Ellipse, options: Options, progress: Progress) -> Runs:
    """All of them, at every sample."""
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


def in_short(path: Ellipse, options: Options, progress: Progress) -> Runs:
    """Of one case, at 121 samples, and a third of the guarded turn."""
    every, case, gains = everywhere(confined().planes), int(options.case), options.gains
    untouched = by_rule(path, case, gains, NONE, SAMPLES_SHORT, part(progress, 0, 4))
    planes = by_rule(path, case, gains, every, SAMPLES_SHORT, part(progress, 1, 4))
    guard = guarded(path, options.gain, path.period / 3, part(progress, 2, 4))
    other = {"ceiling": source_rule(), "printed": PRINTED}.get(options.rule)
    shown = by_rule(path, case, gains, other, SAMPLES_SHORT, part(progress, 3, 4)) if other else planes
    return Runs({case: untouched}, {}, {case: planes}, guard, shown)


def _unheard(share: float) -> None:
    """The progress of one run more than was counted on."""
