"""What many windows cost the arm: its ticks, its frames, its Stop, and the processor, beside a bare viser."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from time import perf_counter, sleep
from typing import Any

import numpy as np
import psutil
from tests.benchmarks.report import verdict
from tests.benchmarks.served import ADDRESS, ROOT

TITLE = "Many windows on one arm, and many arms"
WINDOWS, SECONDS, STOPS, DRAGS = (1, 5, 10, 30, 60), 8.0, 30, 40
PRIVATE, JOINING, WATCHERS = 30, 100, 10


class Child:
    """A process that answers each line with a line of JSON."""

    def __init__(self, *command: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", *command], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self.usage = psutil.Process(self.process.pid)

    def line(self) -> str:
        assert self.process.stdout is not None
        return self.process.stdout.readline()

    def ask(self, *words: object) -> Any:
        assert self.process.stdin is not None
        self.process.stdin.write(" ".join(map(str, words)) + "\n")
        self.process.stdin.flush()
        return json.loads(self.line())

    def processor(self) -> float:
        """Seconds of processor so far."""
        times = self.usage.cpu_times()
        return float(times.user + times.system)


@contextmanager
def child(*command: str) -> Iterator[Child]:
    one = Child(*command)
    try:
        yield one
    finally:
        one.process.kill()
        one.process.communicate()


@contextmanager
def lab(module: str = "tests.benchmarks.watched") -> Iterator[tuple[Child, str]]:
    """A lab or its peer, and its port."""
    with child(module) as server:
        found = ADDRESS.search(server.line())
        assert found is not None
        yield server, found[1]


@dataclass(frozen=True)
class Span:
    """What a server and a crowd did within `SECONDS`: ticks, frames, processor and duration, s, the longest gap, s, and
    the changes that the slowest page saw.
    """

    ticks: float
    frames: float
    used: float
    took: float
    gap: float
    changes: float


def _watched(server: Child, crowd: Child) -> Span:
    before, used, began = server.ask("tell"), server.processor(), perf_counter()
    changes = np.array(crowd.ask("count"))
    sleep(SECONDS)
    changes = np.array(crowd.ask("count")) - changes
    after, used, took = server.ask("tell"), server.processor() - used, perf_counter() - began
    ticks, frames = (after.get(what, 0) - before.get(what, 0) for what in ("ticks", "frames"))
    return Span(ticks, max(1, frames), used, took, after["gap"], float(changes.min()))


def _said(span: Span) -> str:
    return (
        f"longest gap {1000 * span.gap:.0f} ms, {span.frames / span.took:.0f} frames/s, "
        f"{span.changes / span.took:.0f} changes/s at the slowest page, "
        f"{1000 * span.used / span.frames:.2f} ms of processor a frame"
    )


def _shared(server: Child, port: str, count: int) -> None:
    with child("tests.benchmarks.crowd", port) as crowd:
        joined = crowd.ask("join", count, 0)
        crowd.ask("play", 0)
        sleep(2.0)
        span = _watched(server, crowd)
        ticks = span.ticks / span.took
        print(
            f"  {count} windows, joined in {joined:.1f} s: {ticks:.1f} ticks/s, "
            f"{1000 * span.used / max(1, span.ticks):.2f} ms of processor a tick, {_said(span)}"
        )
        drags = 1000 * np.array(crowd.ask("drag", DRAGS))
        stops = 1000 * np.array(crowd.ask("stop", STOPS))
        print(
            f"    drag shown p50 {np.percentile(drags, 50):.0f}, p95 {np.percentile(drags, 95):.0f} ms; "
            f"stop heard p50 {np.percentile(stops, 50):.1f}, p95 {np.percentile(stops, 95):.1f} ms"
        )
        if count == 60:
            verdict("60 windows: time of a tick over a hundredth of a second", 100 / ticks, 100 / 99, "×")
            verdict("60 windows: stop heard p95", float(np.percentile(stops, 95)), 50.0, " ms")
        if count == 30:
            verdict("30 windows: time of a frame", 1000 * span.took / span.frames, 1000 / 15, " ms")
        crowd.ask("leave")


def _bare(server: Child, port: str, count: int) -> None:
    with child("tests.benchmarks.crowd", port) as crowd:
        crowd.ask("watch", count)
        sleep(2.0)
        print(f"  bare viser, {count} windows: {_said(_watched(server, crowd))}")
        crowd.ask("leave")


def _joins(server: Child, port: str) -> None:
    with child("tests.benchmarks.crowd", port) as crowd:
        crowd.ask("join", 1, 0)
        crowd.ask("play", 0)
        server.ask("tell")
        joined = crowd.ask("join", JOINING, 10)
        verdict(f"{JOINING} joins in {joined:.1f} s: longest gap", 1000 * server.ask("tell")["gap"], 50.0, " ms")


def _all_shown(server: Child, port: str) -> None:
    with child("tests.benchmarks.crowd", port) as crowd:
        crowd.ask("join", WATCHERS, 1)
        crowd.ask("show_all")
        crowd.ask("play", 0)
        sleep(4.0)
        span = _watched(server, crowd)
        what = f"{WATCHERS} windows with all layers and every tab"
        print(f"  {what}: {_said(span)}, {span.used / span.took:.0%} of a processor")
        verdict(f"{what}: time of a tick over a hundredth of a second", 100 * span.took / span.ticks, 100 / 99, "×")
        verdict(f"{what}: time of a frame", 1000 * span.took / span.frames, 1000 / 15, " ms")


def _private(server: Child, port: str) -> None:
    with child("tests.benchmarks.crowd", port) as crowd:
        crowd.ask("join", PRIVATE, 3)
        crowd.ask("private")
        crowd.ask("play", 1)
        sleep(4.0)
        span = _watched(server, crowd)
        print(f"  {PRIVATE} arms: longest gap {1000 * span.gap:.0f} ms, {span.used / span.took:.0%} of a processor")
        slowest = 1000 * span.took / span.changes
        verdict(f"{PRIVATE} arms of one's own: time between changes, slowest", slowest, 1000 / 30, " ms")


def run() -> None:
    """Each part on a lab of its own, which has just been started."""
    with lab() as (server, port):
        for count in WINDOWS:
            _shared(server, port, count)
    with lab("tests.benchmarks.bare") as (server, port):
        for count in WINDOWS:
            _bare(server, port, count)
    for part in (_joins, _all_shown, _private):
        with lab() as (server, port):
            part(server, port)
