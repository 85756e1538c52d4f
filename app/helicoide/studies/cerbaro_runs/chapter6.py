"""What the three studies of chapter 6 say: the rows of the digest's table 5.5, and the curves of figs. 47 to 64."""

from __future__ import annotations

import numpy as np

from helicoide.studies.cerbaro_runs.chapter6_charts import charts
from helicoide.studies.cerbaro_runs.chapter6_rows import Told, promises, table
from helicoide.studies.cerbaro_runs.chapter6_runs import Options, in_short, whole
from helicoide.studies.study import Motion, Progress, Result
from helicoide.trajectory import Ellipse


def study(path: Ellipse, told: Told, options: Options, short: bool, progress: Progress) -> Result:
    """All runs of a path and what they say; short: 121 samples, one case, a third of the guarded turn."""
    runs = in_short(path, options, progress) if short else whole(path, options, progress)
    rows = promises(runs) if short else (*table(runs, told, options), *promises(runs))
    times = np.linspace(0.0, path.period, len(runs.shown.q))
    return Result(rows, charts(runs), Motion("movemaster", times, runs.shown.q))
