"""The runs of a path of chapter 6: by each rule in each case, and by the guarded step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
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
GUARDED = Text(en="cases 2 and 3, guarded step", pt_BR="casos 2 e 3, passo guardado")


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

    PLANES = Text(en="all points and planes", pt_BR="todos os pontos e planos")
    TRIMMED = Text(en="trimmed only", pt_BR="só recortado")
    CEILING = Text(en="ceiling alone", pt_BR="só o teto")
    PRINTED = Text(en="ceiling alone, eq. 36 as printed", pt_BR="só o teto, eq. 36 como impressa")
    UNDAMPED = Text(en="all planes without eq. 37", pt_BR="todos os planos, sem a eq. 37")
    OTHER = Text(en="eq. 37 read the other way", pt_BR="eq. 37 na outra leitura")


def title(kind: Kind, case: int) -> Text:
    """Such as "case 3, trimmed only"."""
    return Text(en="case {case}, {kind}", pt_BR="caso {case}, {kind}").format(case=case, kind=kind.value)


def rule(kind: Kind, options: Options) -> Rule:
    """The rule of a kind, with eq. 37 as the options read it."""
    every, ratchets = everywhere(confined().planes), options.former == "adapted"
    match kind:
        case Kind.TRIMMED:
            return NONE
        case Kind.CEILING:
            return replace(source_rule(), ratchets=ratchets)
        case Kind.PRINTED:
            return Rule((CEILING,), corrected=False, level=True, ratchets=ratchets)
        case Kind.UNDAMPED:
            return replace(every, damps=False)
        case Kind.OTHER:
            return replace(every, ratchets=not ratchets)
    return replace(every, ratchets=ratchets)


@dataclass(frozen=True, eq=False)
class Runs:
    """Every run of a path, by its kind and case, and cases 2 and 3 by the guarded step; s of the whole turn."""

    courses: Mapping[tuple[Kind, int], Course]
    guard: Course
    period: float

    @property
    def cases(self) -> dict[int, Course]:
        """The three cases by the rule for all planes."""
        return {case: self.courses[Kind.PLANES, case] for case in CASES}


WHOLE = (*((kind, case) for kind in (Kind.PLANES, Kind.TRIMMED, Kind.CEILING, Kind.OTHER) for case in CASES),)
WHOLE += ((Kind.PRINTED, 3), (Kind.UNDAMPED, 3))
SHORT = tuple((Kind.PLANES, case) for case in CASES)


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
