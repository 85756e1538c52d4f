"""The result of the three studies of chapter 6: sentences of §6.2 and §6.3, and the curves of figs. 47 to 64."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.studies.cerbaro_runs.chapter6_charts import confined_charts
from helicoide.studies.cerbaro_runs.chapter6_rows import number_rows, sentence_rows
from helicoide.studies.cerbaro_runs.chapter6_runs import (
    CONSTRAINED_STEP,
    ConfinedRuns,
    Options,
    confined_runs,
    run_title,
)
from helicoide.studies.cerbaro_runs.runs import subsampled_loop
from helicoide.studies.study import Motion, Progress, Result
from helicoide.text import Text
from helicoide.trajectory import Ellipse

ABOUT_CASES = Text(
    en="Case 1 keeps the orientation, so that no freedom is left; case 2 leaves it free and keeps the joints off their "
    "limits with one gain, case 3 with the gains of Algorithm 1. The constrained QP step is not in the source: each "
    "step is the best one within the limits of all joints and distances. The error is the distance of the end effector "
    "from its target, the deviation its distance from the desired path.",
    pt_BR="O caso 1 mantém a orientação, e não sobra liberdade; o caso 2 a deixa livre e se afasta dos limites de "
    "junta com um só ganho, o caso 3 com os ganhos do Algoritmo 1. O passo com restrições (QP) não é da "
    "fonte: cada passo é o melhor que respeita os limites de todas as juntas e de todas as distâncias. O erro é a "
    "distância do efetuador ao seu alvo; o desvio, ao caminho desejado.",
)


def confined_study(
    path: Ellipse, figures: tuple[int, int], options: Options, short: bool, progress: Progress
) -> Result:
    """All runs of a path and their result. figures: numbers of the first and last figure of the source.

    short: 121 samples by one rule, a third of the run with the constrained step.
    """
    found = confined_runs(path, options, short, progress)
    rows = sentence_rows(found, path, options)
    if not short:
        rows += number_rows(found)
    return Result(rows, confined_charts(found, path, figures), confined_motions(found))


def confined_motions(found: ConfinedRuns) -> tuple[Motion, ...]:
    """The motion of every run."""
    named = [(run_title(*run), course.q, found.period) for run, course in found.runs.items()]
    named.append((CONSTRAINED_STEP, found.constrained.q, len(found.constrained.q) / 100))
    return tuple(_motion(name, q, seconds) for name, q, seconds in named)


def _motion(name: Text, q: Array, seconds: float) -> Motion:
    shown = subsampled_loop(q)
    return Motion("movemaster", np.linspace(0.0, seconds, len(shown)), shown, title=name)
