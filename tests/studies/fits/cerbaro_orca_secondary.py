"""For which limits of the ORCA, ours times a factor, k₀ = 250 keeps the joints farther from them, as is said.

It does for all; from 0.94 on the start is inside them, and above 1.2 those of J2 are more than half a turn.

`python -m tests.studies.fits.cerbaro_orca_secondary`
"""

from __future__ import annotations

import numpy as np

from helicoide.studies.cerbaro_orca_secondary import Options
from helicoide.studies.cerbaro_runs import setups
from helicoide.studies.cerbaro_runs.runs import mean_cost
from helicoide.studies.cerbaro_runs.tracking import DT_SHORT, run_free_circle

if __name__ == "__main__":
    plain = run_free_circle(0.0, DT_SHORT)
    for limits in np.round(np.geomspace(0.6, 3.0, 17), 3):
        pushed = run_free_circle(Options().gain, DT_SHORT, limits=limits)
        orca = setups.orca(limits)
        share = mean_cost(orca, pushed.q) / mean_cost(orca, plain.q)
        print(f"limits × {limits:g}: {share:.3f}", "holds" if share < 1 else "does not hold", flush=True)
