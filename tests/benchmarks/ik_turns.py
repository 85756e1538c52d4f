"""Two who solve the same problems in turn, a few at a time: what each took for a single call, and what it came to."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
from tests.benchmarks.peers import Child, LeftOut, Peer, started
from tests.benchmarks.report import p50

from helicoide.arrays import Array

Turn = Callable[[int, int], tuple[list[float], list[Any]]]
WARM = 20


@dataclass(frozen=True)
class Run:
    """Seconds of the single calls, (rounds, count), and all answers, round after round."""

    seconds: Array
    answers: list[Any]

    @property
    def medians(self) -> Array:
        """The median of the single calls of each round, s."""
        return np.asarray(np.median(self.seconds, axis=1))


def turn_of(child: Child) -> Turn:
    """The turns of a peer, in its own process."""

    def turn(first: int, beyond: int) -> tuple[list[float], list[Any]]:
        seconds, answers = child.ask({"first": first, "beyond": beyond})
        return seconds, answers

    return turn


@contextmanager
def taking_part(peers: Sequence[Peer]) -> Iterator[list[Child]]:
    """The processes of those peers that can be had; that there is none is said."""
    with started(peers) as children:
        if not children:
            print("  not measured, as no peer took part · MISSED")
        yield children


@contextmanager
def or_left_out(child: Child, figure: str) -> Iterator[None]:
    """A peer that ends in the middle is named, and the others go on."""
    try:
        yield
    except LeftOut as reason:
        print(f"  {child.name} is LEFT OUT of {figure}: {reason} · MISSED")


def in_turn(ours: Turn, theirs: Turn, count: int, length: int, rounds: int) -> tuple[Run, Run]:
    """Calls 0 to `count` of both, `length` of ours, then as many of theirs, and so on; the whole many rounds.

    The first calls of a process, which compile and load, are made before.
    """
    taken: tuple[list[Any], list[Any]] = ([], [])
    for party in (ours, theirs):
        party(0, WARM)
    for first in [*range(0, count, length)] * rounds:
        for party, turns in zip((ours, theirs), taken, strict=True):
            turns.append(party(first, min(first + length, count)))
    mine, others = (
        Run(
            np.reshape([s for seconds, _ in turns for s in seconds], (rounds, count)),
            [answer for _, answers in turns for answer in answers],
        )
        for turns in taken
    )
    return mine, others


def line(who: str, run: Run, said: str) -> None:
    """Median and spread over the rounds, the tail, and what came of the answers."""
    low, high = 1e6 * run.medians.min(), 1e6 * run.medians.max()
    tail = 1e6 * np.percentile(run.seconds, 99)
    middle, mean = 1e6 * p50(run.medians), 1e6 * run.seconds.mean()
    print(f"    {who:22} p50 {middle:8.2f} µs ({low:.2f} to {high:.2f})  mean {mean:8.2f}  p99 {tail:8.1f}  {said}")


def faster(figure: str, ours: Run, theirs: Run, goal: float | None) -> None:
    """How many times as fast we are: the median of the rounds, their spread, and the verdict where there is a goal."""
    _judged(figure, theirs.medians / ours.medians, goal)


def faster_on_average(figure: str, ours: Run, theirs: Run, goal: float) -> None:
    """The same by the mean of the calls of each round."""
    _judged(f"{figure}, on average", theirs.seconds.mean(axis=1) / ours.seconds.mean(axis=1), goal)


def _judged(figure: str, ratios: Array, goal: float | None) -> None:
    ratio, spread = p50(ratios), f"{ratios.min():.2f} to {ratios.max():.2f}"
    verdict = "" if goal is None else f" · goal at least {goal:g} × · {'met' if ratio >= goal else 'MISSED'}"
    print(f"  {figure}: {ratio:.2f} × as fast ({spread}){verdict}")


def judged(figure: str, is_true: bool) -> None:
    """The verdict on what has no degrees."""
    print(f"  {figure} · {'met' if is_true else 'MISSED'}")
