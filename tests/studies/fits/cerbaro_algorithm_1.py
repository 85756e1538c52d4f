"""Where J3 must begin, and how small k₀ must be, for what Cerbaro 2022 says of figs. 37 and 38 to hold.

`python -m tests.studies.fits.cerbaro_algorithm_1`: the first seconds over a grid, then the whole turn for the pairs
five per cent beside the chosen one.
"""

from __future__ import annotations

from itertools import product

from helicoide.studies.cerbaro_algorithm_1 import GAIN, INSIDE, SHORT, Options, made, rows
from helicoide.studies.cerbaro_runs.tracking import TURN, nothing
from helicoide.studies.study import Statement

GAINS = (0.05, 0.1, 0.15, 0.18, 0.2, 0.25, 0.3, 0.32, 0.35, 0.5, 1.0, 10.0, 500.0)
STARTS = (0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.25, 0.3, 0.5, 1.0, 5.0)


def broken(gain: float, inside: float, short: bool) -> list[str]:
    """What does not hold of the rows that are fitted."""
    found = rows(made(Options(gain, inside), SHORT if short else TURN, nothing), short)
    return [
        row.quantity.en
        for row in found
        if row.fitted and isinstance(row.source, Statement) and not row.source.holds(row.ours)
    ]


if __name__ == "__main__":
    for gain in GAINS:
        print(f"k₀ = {gain:g}: holds at", [at for at in STARTS if not broken(gain, at, True)], flush=True)
    for gain, inside in product(*((0.95 * v.value, v.value, 1.05 * v.value) for v in (GAIN, INSIDE))):
        print(f"whole turn, k₀ = {gain:g}, {inside:g}°:", broken(gain, inside, False) or "holds", flush=True)
