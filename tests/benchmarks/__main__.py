"""Measure what the program promises; each measurement ends in its figure, the goal, and whether it is met.

`python -m tests.benchmarks latency tick`, or without names for all in `NAMES`.
"""

from __future__ import annotations

import importlib
import sys

NAMES = (
    "latency",
    "tick",
    "startup",
    "idle",
    "load",
    "kinematics",
    "algebra",
    "ik",
    "step",
    "planes",
    "layers",
    "panels",
    "charts",
    "corpus",
)


def main() -> None:
    for name in sys.argv[1:] or NAMES:
        measurement = importlib.import_module(f"tests.benchmarks.{name}")
        print(f"{name}: {measurement.TITLE}")
        measurement.run()
        print()


if __name__ == "__main__":
    main()
