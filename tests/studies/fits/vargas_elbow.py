"""From which q₂ Sim. 15 of Vargas 2013 may begin while what he prints holds.

`python -m tests.studies.fits.vargas_elbow` prints which statements fail, for starts up to 15 % away. Half a minute.
"""

from __future__ import annotations

from helicoide.studies.study import Statement
from helicoide.studies.vargas.secondary import SECONDS, no_progress
from helicoide.studies.vargas_15 import MIDDLE, ZETAS, Options, barrier_rows, joint_barrier_run

FACTORS = (0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.15)


def main(dt: float = 1e-2) -> None:
    """A line for each start."""
    for elbow in (MIDDLE * factor for factor in FACTORS):
        rows = [
            row
            for zeta in ZETAS
            for row in barrier_rows(zeta, joint_barrier_run(zeta, Options().gain, dt, SECONDS, no_progress, elbow))
        ]
        failed = [row for row in rows if isinstance(row.source, Statement) and not row.source.holds(row.computed)]
        print(f"{elbow:.3g}: {[row.quantity.en for row in failed] or 'everything holds'}", flush=True)


if __name__ == "__main__":
    main()
