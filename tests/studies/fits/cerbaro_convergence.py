"""How many iterations both convergences of Cerbaro 2022, §4.4.3 and 4.4.4, take by the step factor.

`python -m tests.studies.fits.cerbaro_convergence`: 7 (ORCA) for 0.532 to 0.59, 17 (Movemaster) for 0.288 to 0.302 only.
"""

from __future__ import annotations

import numpy as np

from helicoide.studies import cerbaro_movemaster_convergence as movemaster
from helicoide.studies import cerbaro_orca_convergence as orca
from helicoide.studies.cerbaro_runs.tracking import ignore_progress

if __name__ == "__main__":
    for factor in np.round(np.arange(0.27, 0.621, 0.002), 3):
        counts = [
            study.run(study.Options(factor=factor), True, ignore_progress).rows[0].ours for study in (orca, movemaster)
        ]
        print(f"κ = {factor:g}: ORCA {counts[0]:g}, Movemaster {counts[1]:g}", flush=True)
