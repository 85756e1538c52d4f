"""Figures in lines: what was measured, the goal, and whether it is met."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def p50(samples: Sequence[float]) -> float:
    return float(np.percentile(samples, 50))


def spread(name: str, samples: Sequence[float], unit: str, tail: int) -> None:
    """Median and tail of a sample."""
    middle, end = np.percentile(samples, [50, tail])
    print(f"  {name:44} p50 {middle:8.2f}   p{tail} {end:8.2f} {unit}   n {len(samples)}")


def verdict(figure: str, value: float, goal: float, unit: str) -> None:
    """The line that a measurement ends in."""
    said = "met" if value <= goal else "MISSED"
    print(f"  {figure}: {value:.2f}{unit} · goal at most {goal:g}{unit} · {said}")


def beside(who: str, statement: str, seconds: Sequence[float], ratio: str = "") -> None:
    """What one of several took for the same work, and how ours compares."""
    print(f"    {who:22} {1e6 * p50(seconds):10.2f} µs {ratio:>9}  {statement}")


def judge(figure: str, ratios: Sequence[float], goal: float) -> None:
    """The verdict on ours/peer where the peer comes nearest to us, or is furthest ahead."""
    if ratios:
        verdict(f"{figure}, ours/peer", max(ratios), goal, "×")
    else:
        print(f"  {figure}: not measured, as no peer took part · MISSED")
