"""Saves one step after another into a file, and prints after each how many are saved."""

from __future__ import annotations

import sys

from tests.store.samples import TOKEN

from helicoide.seat import LessonProgress, PredictionAnswer
from helicoide.store.database import Store
from helicoide.store.merging import Progress


def after(count: int) -> Progress:
    """The progress after so many steps, in two lessons that are saved together."""
    steps = [f"step{k}" for k in range(count)]
    answers = {step: PredictionAnswer((float(k),), True) for k, step in enumerate(steps)}
    return {name: LessonProgress(name, count, frozenset(steps), answers=answers) for name in ("screws", "motors")}


if __name__ == "__main__":
    store, before = Store(sys.argv[1]), after(0)
    store.save(TOKEN, before)
    for count in range(1, 500):
        store.save(TOKEN, after(count), before)
        before = after(count)
        print(count, flush=True)
