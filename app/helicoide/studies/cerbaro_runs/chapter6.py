"""What the three studies of chapter 6 say: the sentences of §6.2 and §6.3, and the curves of figs. 47 to 64."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import Array
from helicoide.studies.cerbaro_runs.chapter6_charts import charts
from helicoide.studies.cerbaro_runs.chapter6_rows import numbers, sentences
from helicoide.studies.cerbaro_runs.chapter6_runs import GUARDED, Options, Runs, runs, title
from helicoide.studies.cerbaro_runs.runs import few
from helicoide.studies.study import Motion, Progress, Result
from helicoide.text import Text
from helicoide.trajectory import Ellipse

CASES_TOLD = Text(
    en="Case 1 holds the orientation, so that no freedom is left; case 2 leaves it free and keeps off the joint limits "
    "by one gain, case 3 by the gains of Algorithm 1. The guarded step is ours: each step is the best one within the "
    "limits of every joint and every distance. The error is how far the tool is from its target, the deviation how far "
    "from the path that was wanted.",
    pt_BR="O caso 1 mantém a orientação, e não sobra liberdade; o caso 2 a deixa livre e se afasta dos limites de "
    "junta com um só ganho, o caso 3 com os ganhos do Algoritmo 1. O passo vigiado é nosso: cada passo é o melhor que "
    "respeita os limites de todas as juntas e de todas as distâncias. O erro é quanto falta ao efetuador até o seu "
    "alvo; o desvio, até o caminho desejado.",
)


def study(path: Ellipse, figures: tuple[int, int], options: Options, short: bool, progress: Progress) -> Result:
    """All runs of a path and what they say. figures: the first and last of the source.

    short: 121 samples by one rule, a third of the guarded turn.
    """
    found = runs(path, options, short, progress)
    rows = sentences(found, path, options)
    if not short:
        rows += numbers(found)
    return Result(rows, charts(found, path, figures), motions(found))


def motions(found: Runs) -> tuple[Motion, ...]:
    """Every run by its name."""
    named = [(title(*run), course.q, found.period) for run, course in found.courses.items()]
    named.append((GUARDED, found.guard.q, len(found.guard.q) / 100))
    return tuple(_motion(name, q, seconds) for name, q, seconds in named)


def _motion(name: Text, q: Array, seconds: float) -> Motion:
    shown = few(q)
    return Motion("movemaster", np.linspace(0.0, seconds, len(shown)), shown, title=name)
