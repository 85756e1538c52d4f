"""For which gains k₀ the sentences of chapter 6 hold on its paths: `python -m tests.studies.fits.cerbaro_confined`.

What depends on k₀: case 2 crosses no joint limit, case 3 stays farther from them and on the border, and case 1 deviates
more on the ellipse and the circle. On the circle the wrist comes near a wall with all of them.
"""

from __future__ import annotations

from helicoide.studies.cerbaro_runs.chapter6_rows import sentence_rows
from helicoide.studies.cerbaro_runs.chapter6_runs import SHORT, ConfinedRuns, Options, rule_of
from helicoide.studies.cerbaro_runs.confined import CIRCLE, ELLIPSE, LINE, SAMPLES, run_by_rule
from helicoide.studies.study import Verdict
from helicoide.trajectory import Ellipse

PATHS = {"ellipse": ELLIPSE, "line": LINE, "circle": CIRCLE}
GAINS = (500, 1000, 1100, 1200, 1300, 1400, 1500, 1700, 1900, 2000, 2100, 2300, 2500, 2750, 3000)


def differing(path: Ellipse, gain: float) -> list[str]:
    """The rows that differ on a path."""
    options = Options(gain=gain)
    cases = {
        run: run_by_rule(path, run[1], options.gains, rule_of(run[0], options), SAMPLES, lambda share: None)
        for run in SHORT
    }
    first = next(iter(cases.values()))
    rows = sentence_rows(ConfinedRuns(cases, first, path.period), path, options)
    return [row.quantity.en for row in rows if row.verdict is Verdict.DIFFERS]


if __name__ == "__main__":
    for gain in GAINS:
        print(gain, {name: differing(path, gain) for name, path in PATHS.items()}, flush=True)
