"""Peers beside ourselves: each in an environment and a process of its own, asked in turn with us in one run."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from tests.benchmarks.children.answer import Task
from tests.benchmarks.report import beside, p50
from tests.benchmarks.served import ROOT

HERE = Path(__file__).parent
ENVIRONMENTS = ROOT / ".venv-bench"
# Peers and we have the same threads: none but our own.
SINGLE = {f"{library}_NUM_THREADS": "1" for library in ("OMP", "OPENBLAS", "MKL", "NUMBA")}
BLOCK = 0.01
ROUNDS_AT_LEAST, ROUNDS_AT_MOST, PATIENCE = 7, 41, 4.0
AGREEMENT = 1e-9


@dataclass(frozen=True)
class Peer:
    """A package on the index, the file in `children` that answers for it, and what else that file imports.

    pins: the versions that go together; a peer that asks for others than the rest has a file of its own.
    """

    package: str
    child: str
    also: tuple[str, ...] = ()
    pins: str = "peers.txt"

    @property
    def versions(self) -> str:
        return (HERE / self.pins).read_text()


class LeftOut(Exception):
    """A peer that cannot take part, and why."""


@dataclass(frozen=True)
class Way:
    """One of a peer's ways to a figure, as a `Task` in its process."""

    child: Child
    index: int
    figure: str
    statement: str

    def seconds(self, calls: int) -> float:
        return float(self.child.ask({"seconds": self.index, "calls": calls}))

    def values(self) -> Any:
        return self.child.ask({"values": self.index})


@dataclass(frozen=True)
class Child:
    """A peer's process."""

    name: str
    process: subprocess.Popen[str]

    def ask(self, question: object) -> Any:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        try:
            print(json.dumps(question), file=self.process.stdin, flush=True)
            return json.loads(self.process.stdout.readline())
        except (BrokenPipeError, json.JSONDecodeError) as error:
            raise LeftOut(f"{self.name} ended with {self.process.wait()} when it was asked") from error

    def given(self, **given: object) -> list[Way]:
        """What the peer can do with these."""
        return [Way(self, index, *way) for index, way in enumerate(self.ask({"given": given}))]


def interpreter(peer: Peer) -> Path:
    """The interpreter of an environment that holds the peer; it is made when there is none with these pins.

    Raises LeftOut when it cannot be made.
    """
    folder, pins = ENVIRONMENTS / peer.package, peer.versions
    python, ready = folder / "bin" / "python", folder / "ready"
    if ready.exists() and ready.read_text() == pins:
        return python
    print(f"  Installing {peer.package} in {folder.relative_to(ROOT)}; this happens once.", flush=True)
    shutil.rmtree(folder, ignore_errors=True)
    pip = [str(python), "-m", "pip", "install", "-qq", "--disable-pip-version-check", "-c", str(HERE / peer.pins)]
    pip += [peer.package, *peer.also]
    for command in ([sys.executable, "-m", "venv", str(folder)], pip):
        made = subprocess.run(command, capture_output=True, text=True)
        if made.returncode:
            raise LeftOut((made.stderr or made.stdout).strip().splitlines()[-1])
    ready.write_text(pins)
    return python


@contextmanager
def _started(peer: Peer) -> Iterator[Child]:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    process = subprocess.Popen(
        [interpreter(peer), HERE / "children" / peer.child],
        env=environment | SINGLE,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    with process:
        yield Child(peer.package, process)


@contextmanager
def started(peers: Sequence[Peer]) -> Iterator[list[Child]]:
    """The processes of those peers that can be had; the others are named."""
    with ExitStack() as stack:
        children = []
        for peer in peers:
            try:
                children.append(stack.enter_context(_started(peer)))
            except LeftOut as reason:
                print(f"  {peer.package} is LEFT OUT: {reason}")
        taking_part = {child.name for child in children}
        pinned = [(peer, line.split("==")) for peer in peers for line in peer.versions.split()]
        versions = [" ".join(pin) for peer, pin in pinned if pin[0] == peer.package and pin[0] in taking_part]
        print("  " + " · ".join(versions))
        yield children


def ways_of(children: Sequence[Child], **given: object) -> list[Way]:
    """All that the peers can do with these; who cannot is named."""
    ways = []
    for child in children:
        try:
            ways += child.given(**given)
        except LeftOut as reason:
            print(f"  {child.name} is LEFT OUT: {reason}")
    return ways


def _calls(task: Task | Way) -> int:
    """How many calls make a block, found by steps: the first calls compile and load."""
    calls = 1
    for _ in range(3):
        calls = max(1, round(BLOCK / task.seconds(calls)))
    return calls


def _agree(ours: Task, ways: Sequence[Way]) -> list[Way]:
    """Those that come to the same numbers as we do; only they are timed, the others are named."""
    expected, agreeing = np.array(ours.values()), []
    for way in ways:
        error = float(np.max(np.abs(np.array(way.values()) - expected)))
        if error <= AGREEMENT:
            agreeing.append(way)
        else:
            print(f"  {way.child.name} is LEFT OUT of {ours.figure}: {way.statement} differs by {error:.1e}")
    return agreeing


def compare(ours: Task, ways: Sequence[Way]) -> dict[Way, float]:
    """Print ours, and beside it each way of the peers to the same figure; gives the medians of ours/peer.

    Blocks alternate: ours, the first way, ours, the second, and again from the start.
    """
    ways = _agree(ours, [way for way in ways if way.figure == ours.figure])
    if not ways:
        return {}
    counted = [(way, _calls(way)) for way in ways]
    rounds: list[list[tuple[float, float]]] = []
    our_calls, begun = _calls(ours), perf_counter()
    while len(rounds) < ROUNDS_AT_LEAST or (len(rounds) < ROUNDS_AT_MOST and perf_counter() < begun + PATIENCE):
        rounds.append([(ours.seconds(our_calls), way.seconds(calls)) for way, calls in counted])
    beside("ours", ours.statement, [mine for turn in rounds for mine, _ in turn])
    ratios = {}
    for way, turns in zip(ways, zip(*rounds, strict=True), strict=True):
        ratios[way] = p50([mine / theirs for mine, theirs in turns])
        beside(way.child.name, way.statement, [theirs for _, theirs in turns], f"{ratios[way]:.3f}")
    return ratios
