"""The runs of a path of chapter 6: by each rule in each case, and by the guarded step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from typing import Annotated

from helicoide.ik.adaptation import NONE, Rule, everywhere
from helicoide.ik.method import OneOf, Quantity
from helicoide.studies.cerbaro_runs.confined import (
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
GUARDED = Text(en="guarded step, orientation free", pt_BR="passo vigiado, orientação livre")


@dataclass(frozen=True)
class Options:
    """What the source does not give, k₀ so that its sentences hold; former: how eq. 37 is read."""

    gain: Annotated[float, Quantity(Text(en="gain k₀", pt_BR="ganho k₀"), 0.0, 3000.0, "1/s")] = 2000.0
    factor: Annotated[float, Quantity(Text(en="step factor κ", pt_BR="fator de passo κ"), 0.1, 1.0)] = 0.5
    tolerance: Annotated[float, Quantity(Text(en="inner tolerance", pt_BR="tolerância interna"), 0.1, 10.0, "mm")] = 1.0
    former: Annotated[
        str,
        OneOf(
            Text(en="former point in eq. 37", pt_BR="ponto anterior na eq. 37"),
            {
                "wanted": Text(en="of the wanted path", pt_BR="do caminho desejado"),
                "adapted": Text(en="the former target as it ended", pt_BR="o alvo anterior já adaptado"),
            },
        ),
    ] = "wanted"

    @property
    def gains(self) -> Gains:
        """As the runs take them."""
        return Gains(self.gain, self.factor, self.tolerance * 1e-3)


class Kind(Enum):
    """By which rule targets give way."""

    SOURCE = Text(en="by the source’s rule", pt_BR="pela regra da fonte")
    PRINTED = Text(en="with eq. 36 as printed", pt_BR="com a eq. 36 como impressa")
    OTHER = Text(en="with eq. 37 read the other way", pt_BR="com a eq. 37 na outra leitura")
    UNDAMPED = Text(en="without eq. 37", pt_BR="sem a eq. 37")
    TRIMMED = Text(en="only trimmed beforehand", pt_BR="só com o recorte prévio")
    PLANES = Text(en="every point watched against every plane", pt_BR="todo ponto vigiado contra todo plano")


def title(kind: Kind, case: int) -> Text:
    """Such as "case 3, without eq. 37"."""
    return Text(en="case {case}, {kind}", pt_BR="caso {case}, {kind}").format(case=case, kind=kind.value)


def rule(kind: Kind, options: Options) -> Rule:
    """The rule of a kind, with eq. 37 as the options read it."""
    source = replace(source_rule(), ratchets=options.former == "adapted")
    match kind:
        case Kind.PRINTED:
            return replace(source, corrected=False)
        case Kind.OTHER:
            return replace(source, ratchets=not source.ratchets)
        case Kind.UNDAMPED:
            return replace(source, damps=False)
        case Kind.TRIMMED:
            return NONE
        case Kind.PLANES:
            return replace(everywhere(confined().planes), ratchets=source.ratchets)
    return source


@dataclass(frozen=True, eq=False)
class Runs:
    """Every run of a path, by its kind and case, and one by the guarded step; s of the whole turn."""

    courses: Mapping[tuple[Kind, int], Course]
    guard: Course
    period: float

    @property
    def cases(self) -> dict[int, Course]:
        """The three cases by the source's rule."""
        return {case: self.courses[Kind.SOURCE, case] for case in CASES}


SHORT = tuple((Kind.SOURCE, case) for case in CASES)
WHOLE = (*((kind, case) for kind in (Kind.SOURCE, Kind.OTHER, Kind.TRIMMED) for case in CASES),)
WHOLE += ((Kind.PRINTED, 3), (Kind.UNDAMPED, 3), (Kind.PLANES, 3))


def runs(path: Ellipse, options: Options, short: bool, progress: Progress) -> Runs:
    """All of them; short: by one rule, at fewer samples, and a third of the guarded turn."""
    asked, samples = (SHORT, SAMPLES_SHORT) if short else (WHOLE, SAMPLES)
    count = len(asked) + 1
    courses = {
        (kind, case): by_rule(path, case, options.gains, rule(kind, options), samples, part(progress, i, count))
        for i, (kind, case) in enumerate(asked)
    }
    seconds = path.period / 3 if short else path.period
    return Runs(courses, guarded(path, options.gain, seconds, part(progress, count - 1, count)), path.period)
