"""The runs of a path of chapter 6: by each rule in each case, and by the constrained QP step."""

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
    ConfinedRun,
    Gains,
    confined_problem,
    run_by_rule,
    run_constrained,
    source_rule,
)
from helicoide.studies.cerbaro_runs.runs import share_of_runs
from helicoide.studies.study import Progress
from helicoide.text import Text, untranslated
from helicoide.trajectory import Ellipse

CASES = (1, 2, 3)
PLANES = (
    untranslated("+z"),
    Text(en="+y (−y in the source)", pt_BR="+y (−y na fonte)"),
    Text(en="−y (+y in the source)", pt_BR="−y (+y na fonte)"),
    untranslated("−z"),
)
CRITICAL, WARNING = 80.0, 110.0
CONSTRAINED_STEP = Text(en="constrained QP step, orientation free", pt_BR="passo com restrições (QP), orientação livre")


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


class RuleKind(Enum):
    """The rules by which targets are moved away from planes."""

    SOURCE = Text(en="by the source’s rule", pt_BR="pela regra da fonte")
    STEADY = Text(
        en="by the source’s rule, joints clipped but gains that do not grow",
        pt_BR="pela regra da fonte, juntas saturadas mas ganhos que não crescem",
    )
    PRINTED = Text(
        en="with the tenth of eq. 36 as printed, its normal turned inward",
        pt_BR="com o décimo da eq. 36 como impresso e a normal virada para dentro",
    )
    OTHER = Text(en="with eq. 37 read the other way", pt_BR="com a eq. 37 na outra leitura")
    UNDAMPED = Text(en="without eq. 37", pt_BR="sem a eq. 37")
    TRIMMED = Text(
        en="with no rule, its path only kept 110 mm off walls and bench beforehand",
        pt_BR="sem regra, com o caminho apenas afastado antes a 110 mm de paredes e bancada",
    )
    PLANES = Text(en="every point monitored for every plane", pt_BR="todo ponto monitorado para todo plano")


def run_title(kind: RuleKind, case: int) -> Text:
    """Such as "case 3, without eq. 37"."""
    return Text(en="case {case}, {kind}", pt_BR="caso {case}, {kind}").format(case=case, kind=kind.value)


def rule_of(kind: RuleKind, options: Options) -> Rule:
    """The rule of a kind, with eq. 37 as the options read it."""
    source = replace(source_rule(), ratchets=options.former == "adapted")
    match kind:
        case RuleKind.PRINTED:
            return replace(source, corrected=False)
        case RuleKind.OTHER:
            return replace(source, ratchets=not source.ratchets)
        case RuleKind.UNDAMPED:
            return replace(source, damps=False)
        case RuleKind.TRIMMED:
            return NONE
        case RuleKind.PLANES:
            return replace(everywhere(confined_problem().planes), ratchets=source.ratchets)
    return source


def gains_of(kind: RuleKind, options: Options) -> Gains:
    """The gains that go with a kind of rule."""
    return replace(options.gains, growth=1.0) if kind is RuleKind.STEADY else options.gains


@dataclass(frozen=True, eq=False)
class ConfinedRuns:
    """The runs of a path by rule and case, the run with the constrained step, and the period of the path, s."""

    runs: Mapping[tuple[RuleKind, int], ConfinedRun]
    constrained: ConfinedRun
    period: float

    @property
    def cases(self) -> dict[int, ConfinedRun]:
        """The three cases by the source's rule."""
        return {case: self.runs[RuleKind.SOURCE, case] for case in CASES}


SHORT = tuple((RuleKind.SOURCE, case) for case in CASES)
WHOLE = (*((kind, case) for kind in (RuleKind.SOURCE, RuleKind.OTHER, RuleKind.TRIMMED) for case in CASES),)
WHOLE += ((RuleKind.STEADY, 3), (RuleKind.PRINTED, 3), (RuleKind.UNDAMPED, 3), (RuleKind.PLANES, 3))


def confined_runs(path: Ellipse, options: Options, short: bool, progress: Progress) -> ConfinedRuns:
    """All runs; short: one rule, fewer samples, and a third of the run with the constrained step."""
    asked, samples = (SHORT, SAMPLES_SHORT) if short else (WHOLE, SAMPLES)
    count = len(asked) + 1
    courses = {
        (kind, case): run_by_rule(
            path, case, gains_of(kind, options), rule_of(kind, options), samples, share_of_runs(progress, i, count)
        )
        for i, (kind, case) in enumerate(asked)
    }
    seconds = path.period / 3 if short else path.period
    return ConfinedRuns(
        courses, run_constrained(path, options.gain, seconds, share_of_runs(progress, count - 1, count)), path.period
    )
