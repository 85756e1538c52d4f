"""From which starts of J3 what Cerbaro 2022 says of figs. 37 and 38 comes out with k₀ = 500 counted in degrees.

`python -m tests.studies.fits.cerbaro_algorithm_1`: the first seconds from every start, then the whole turn from the
least, the usual and the greatest, with gains about 500. In radians none does: J3 does not pass its limit.
"""

from __future__ import annotations

from helicoide.studies.cerbaro_algorithm_1 import (
    BENT,
    SETTLED,
    SHORT,
    Options,
    error_ratio,
    gain_runs,
    margin_after_start,
)
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.runs import mean_cost
from helicoide.studies.cerbaro_runs.tracking import TURN, ignore_progress

STARTS = (0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.25, 0.3, 0.5, 1.0, 5.0)
GAINS = (400.0, 500.0, 690.0)


def comes_out(gain: float, inside: float, short: bool) -> bool:
    """Whether J3 passes with one gain, all stay inside by Algorithm 1, farther off, and the error is unchanged."""
    runs, movemaster = gain_runs(Options(gain, inside), SHORT if short else TURN, ignore_progress), setups.movemaster()
    one, grown = runs.one_in_degrees, runs.grown_in_degrees
    unchanged = abs(error_ratio(grown.since(SETTLED), one.since(SETTLED)) - 1) <= 0.1
    farther = short or mean_cost(movemaster, grown.q) < mean_cost(movemaster, one.q)
    return margin_after_start(one, 2) < 0 and margin_after_start(grown, *BENT) >= -1e-9 and unchanged and farther


if __name__ == "__main__":
    print("first seconds: comes out from", [at for at in STARTS if comes_out(500.0, at, True)], flush=True)
    for gain in GAINS:
        for inside in (0.02, 0.1, 0.2):
            print(f"whole turn, k₀ = {gain:g}, {inside:g}°:", comes_out(gain, inside, False), flush=True)
