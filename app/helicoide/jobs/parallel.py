"""The same long work on several inputs, in parallel processes, with the progress of the whole."""

from __future__ import annotations

import pickle
import time
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from dataclasses import dataclass, replace
from multiprocessing import get_context
from typing import Any, Generic, TypeVar

from helicoide.jobs.process import exit_with_parent
from helicoide.jobs.throttle import throttled

Item = TypeVar("Item")
Value = TypeVar("Value")
Progress = Callable[[float], None]

PROGRESS_PERIOD = 0.1

_told: Any = None


@dataclass(frozen=True)
class JobOutcome(Generic[Value]):
    """How one piece of work ended: its value, or the exception it raised; seconds: its duration."""

    value: Value | None
    failure: Exception | None
    seconds: float


def run_timed(work: Callable[[Item, Progress], Value], given: Item, progress: Progress) -> JobOutcome[Value]:
    """Do one piece of work in this process; an exception becomes its outcome. Progress is throttled."""
    began = time.perf_counter()
    value, failure = None, None
    try:
        value = work(given, throttled(progress))
    except Exception as error:
        failure = error
    return JobOutcome(value, failure, time.perf_counter() - began)


def run_parallel(
    work: Callable[[Item, Progress], Value], givens: Sequence[Item], workers: int, progress: Progress
) -> list[JobOutcome[Value]]:
    """Do the same work on each of `givens`, `workers` at a time; outcomes in the order of `givens`.

    work, its arguments and its values must be picklable; progress: called with the completed fraction of the whole,
    0 to 1.
    """
    context = get_context("spawn")
    reports = context.SimpleQueue()
    shares = [0.0] * len(givens)
    pool = ProcessPoolExecutor(workers, context, initializer=_begin, initargs=(reports,))
    try:
        futures = [pool.submit(_work, i, work, given) for i, given in enumerate(givens)]
        waiting = set(futures)
        while waiting:
            _, waiting = wait(waiting, PROGRESS_PERIOD, FIRST_COMPLETED)
            while not reports.empty():
                i, share = reports.get()
                shares[i] = share
            progress(sum(1.0 if f.done() else s for f, s in zip(futures, shares, strict=True)) / max(1, len(futures)))
        return [_ended(future) for future in futures]
    finally:
        pool.shutdown(cancel_futures=True)


def _ended(future: Future[JobOutcome[Value]]) -> JobOutcome[Value]:
    """The outcome of a piece of work, even if its process died."""
    error = future.exception()
    if error is None:
        return future.result()
    if not isinstance(error, Exception):
        raise error
    return JobOutcome(None, error, 0.0)


def _begin(reports: Any) -> None:
    global _told
    _told = reports
    exit_with_parent()


def _work(index: int, work: Callable[[Item, Progress], Value], given: Item) -> JobOutcome[Value]:
    outcome = run_timed(work, given, lambda share: _told.put((index, share)))
    return outcome if outcome.failure is None else replace(outcome, failure=_portable(outcome.failure))


def _portable(error: Exception) -> Exception:
    """An error that can be sent to another process: itself if it can be pickled, else its message."""
    try:
        return error if isinstance(pickle.loads(pickle.dumps(error)), type(error)) else RuntimeError(str(error))
    except Exception:
        return RuntimeError(f"{type(error).__name__}: {error}")
