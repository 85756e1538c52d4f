"""What Coutinho's simulations come to from the start of `tests.ik.rcm.runs`, recomputed from the source's formulas.

The numbers are of a program of its own, by explicit Euler, to the last digit that is written.
"""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from helicoide.studies._coutinho_runs import Run

# By path, sample time, ms, and gain Kr, 1/s, or inverse.
FOUND: Mapping[tuple[str, int, float | str], Mapping[str, str]] = {
    ("S1", 20, 0.0): {
        "tip": "0.0028", "angle": "0.0003", "lateral": "0.191", "q7_min": "-1.430", "q7_max": "-0.571",
        "outside_min": "0.147", "outside_max": "0.240", "w_r": "0.539", "rate": "0.0462",
    },
    ("S1", 20, 5.0): {"tip": "0.0028", "lateral": "0.0009", "w_r": "0.539", "rate": "0.0463"},
    ("S1", 2, 0.0): {"tip": "0.0003", "lateral": "0.023", "outside_max": "0.240", "rate": "0.0463"},
    ("S2", 20, 0.0): {
        "tip": "0.0037", "angle": "0.0004", "lateral": "0.471", "q7_min": "-1.344", "q7_max": "-0.556",
        "outside_min": "0.142", "outside_max": "0.235", "w_r": "0.157", "rate": "0.0530",
    },
    ("S2", 2, 0.0): {"tip": "0.0004", "lateral": "0.047", "q7_min": "-1.346", "q7_max": "-0.558", "rate": "0.0531"},
    ("S2", 2, 5.0): {"tip": "0.0004", "lateral": "0.00016", "q7_min": "-1.347", "q7_max": "-0.558", "rate": "0.0531"},
    ("S3", 20, "damped"): {"lateral": "0.042"},
    ("S3", 2, "plain"): {"tip": "0.0135", "angle": "0.0037", "lateral": "0.0042"},
    ("S3", 2, "damped"): {
        "tip": "0.0784", "angle": "0.0016", "lateral": "0.0042", "q7_min": "-1.169", "q7_max": "0.269",
        "outside_min": "0.063", "outside_max": "0.163",
    },
    ("S3", 2, "variable"): {"tip": "0.0541", "angle": "0.0012", "lateral": "0.0042", "q7_max": "0.269"},
    ("S4", 2, 0.0): {
        "tip": "0.0014", "angle": "0.0001", "lateral": "0.233", "q7_min": "-2.075", "q7_max": "-0.600",
        "outside_min": "0.146", "outside_max": "0.205", "w_r": "0.374", "rate": "0.115",
    },
    ("S4", 2, 5.0): {"tip": "0.0014", "lateral": "0.0005", "q7_max": "-0.601", "w_r": "0.374", "rate": "0.115"},
    ("E1", 2, "plain"): {"tip": "0.0001", "q7_min": "0.010", "lateral": "0.072", "rate": "2.38"},
    ("E1", 2, "damped"): {"tip": "0.92", "q7_min": "0.009", "lateral": "0.072", "rate": "2.35"},
}  # fmt: skip
# l_a, θ₇, w_r and w_i by seconds, of S2 with Kr = 5 and of S3 with κ = 0.05, at 20 ms.
SAMPLED: Mapping[str, Mapping[int, tuple[float, float, float, float]]] = {
    "S2": {
        0: (0.1500, -0.6164, 0.8325, 0.02828),
        25: (0.2299, -1.1107, 0.1698, 0.04441),
        50: (0.1936, -0.8802, 0.3825, 0.04012),
        100: (0.2225, -1.3181, 0.2258, 0.04622),
        150: (0.1936, -0.8802, 0.3825, 0.03940),
        200: (0.1500, -0.6164, 0.8325, 0.02828),
    },
    "S3": {
        0: (0.1500, -0.6164, 0.8325, 0.02828),
        25: (0.1607, -0.0009, 0.0010, 0.02483),
        50: (0.1387, 0.2685, 0.5051, 0.02334),
        100: (0.1038, -0.4778, 2.1849, 0.02028),
        150: (0.0653, -1.1636, 15.0794, 0.01793),
        200: (0.1500, -0.6170, 0.8332, 0.02829),
    },
}
# The rod's circle, by sample time, ms, and gain Kr, 1/s: tip, its root mean square, shaft, shaft at the end, mm.
CIRCLED: Mapping[tuple[int, float], tuple[str, str, str, str]] = {
    (20, 0.0): ("0.047", "0.021", "0.473", "0.395"),
    (20, 5.0): ("0.047", "0.021", "0.028", "0.0065"),
    (2, 0.0): ("0.0047", "0.0021", "0.047", "0.039"),
    (2, 5.0): ("0.0047", "0.0021", "0.0028", "0.0007"),
}


def digits(written: str) -> object:
    """What a number that is written to its last digit may be."""
    return pytest.approx(float(written), abs=0.6 * 10.0 ** -len(written.partition(".")[2]))


def at(run: Run, t: int, dt: float) -> tuple[float, float, float, float]:
    """l_a, θ₇, w_r and w_i at a time, s."""
    step, seldom = round(t / dt), 2 * t
    return (run["outside"][step], run["q7"][step], run["w_r"][seldom], run["w_i"][seldom])
