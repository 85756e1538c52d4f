"""Starts of the source's arm from which its formulas were recomputed independently, the tool as in table 4.2."""

from __future__ import annotations

import numpy as np

from helicoide.arrays import frozen

START = frozen([0.731912, -0.229593, -1.110216, -1.636104, 0.676517, 1.117805, -0.616407, 1.5708])
E1_START = frozen([*START[:6], np.pi / 4, -np.pi / 2])
