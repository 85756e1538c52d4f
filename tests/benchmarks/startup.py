"""How long people wait: for a command's answer, and from the command `helicoide` to a page on which the arm moves.

Beside a program that only imports Pinocchio, and the page of a bare viser. Bytecode is kept as of an installed package.
"""

from __future__ import annotations

import asyncio
import http.client
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import closing
from http import HTTPStatus
from math import acos, degrees
from time import perf_counter, sleep
from typing import Any

from tests.benchmarks.peers import LeftOut, Peer, interpreter
from tests.benchmarks.report import p50, verdict
from tests.benchmarks.served import ROOT, served
from tests.pages import Page, opened

TITLE = "From a command to its answer, and to an arm that moves, with and without the kernel cache"
RUNS = 5
HELP, FK, WARM, FIRST = 0.4, 0.8, 2.5, 25.0
STAGES = ("address printed", "/healthz answers", "page up", "arm moves", "kernels there")
JOINT, NODE, ANGLE = "1 waist", "/arm/waist", 3.0
# The commands, what their answer says, and the goal where there is one.
ZERO = ("fk", "movemaster", "--q", "0", "0", "0", "0", "0")
REACHED = ("ik", "movemaster", "--position", "0.3", "0", "0.3")
COMMANDS = ((("--help",), "workspace", HELP), (ZERO, "dual_quaternions", FK), (REACHED, "reached", None))
PINOCCHIO = Peer("pin", "with_pinocchio.py")
Environment = Mapping[str, str]


def _answered(command: Sequence[str], expected: str, env: Environment) -> float:
    """Seconds until a program has ended, whose output says what is expected."""
    begun = perf_counter()
    done = subprocess.run(command, cwd=ROOT, env={**os.environ, **env}, capture_output=True, text=True, check=True)
    took = perf_counter() - begun
    if expected not in done.stdout:
        raise RuntimeError(f"{command} answered {done.stdout!r}")
    return took


def _commands(env: Environment) -> None:
    """Each command beside the import of Pinocchio, in turn."""
    try:
        peer = [str(interpreter(PINOCCHIO)), "-c", "import pinocchio; print(pinocchio.__version__)"]
    except LeftOut as reason:
        print(f"  pinocchio is LEFT OUT: {reason}")
        peer = []
    for arguments, expected, goal in COMMANDS:
        ours, theirs = list[float](), list[float]()
        for _ in range(RUNS + 1):
            ours.append(_answered([sys.executable, "-m", "helicoide", *arguments], expected, env))
            if peer:
                theirs.append(_answered(peer, ".", {"PYTHONPATH": ""}))
        name, took = f"helicoide {arguments[0]}", p50(ours[1:])  # the first run fills what is kept
        if goal is None:
            print(f"  {name}: {took:.2f} s")
        else:
            verdict(name, took, goal, " s")
        if theirs:
            beside = p50(theirs[1:])
            print(f"    {took / beside:.2f} × `import pinocchio` ({beside:.2f} s)")


def _wait_for(port: int, path: str) -> None:
    """Ask until the answer is 200."""
    while True:
        with closing(http.client.HTTPConnection("127.0.0.1", port, timeout=10)) as client:
            try:
                client.request("GET", path)
                answer = client.getresponse()
                if answer.read() is not None and answer.status == HTTPStatus.OK:
                    return
            except ConnectionError:
                pass
        sleep(0.01)


async def _moved(page: Page) -> float:
    """Ask for an angle of a joint as soon as the page lets; gives when its link first moved, once it is there."""
    await page.may_drive.wait()
    moved = list[float]()
    arrived = asyncio.Event()

    def heard(message: Any) -> None:
        if message["type"] == "SetOrientationMessage" and message["name"] == NODE:
            angle = degrees(2 * acos(min(1.0, abs(message["wxyz"][0]))))
            if angle > 0.0:
                moved.append(perf_counter())
            if abs(angle - ANGLE) < 0.1:
                arrived.set()

    page.heard = heard
    await page.give(JOINT, ANGLE)
    async with asyncio.timeout(60):
        await arrived.wait()
    return moved[0]


async def _on_page(port: int, to_the_end: bool) -> list[float]:
    """When the arm moved, and when every kernel was there."""
    async with opened(port) as page:
        line = [await _moved(page)]
        if to_the_end:
            await page.ready()
            line.append(perf_counter())
        return line


def _start(cache: str, env: Environment, to_the_end: bool) -> list[float]:
    """Seconds from the command to each stage; the last is left out unless it is asked for."""
    begun, line = perf_counter(), list[float]()
    with served("helicoide", "--port", "0", "--store", "none", env={**env, "NUMBA_CACHE_DIR": cache}) as port:
        line.append(perf_counter())
        for path in ("/healthz", "/"):
            _wait_for(port, path)
            line.append(perf_counter())
        line += asyncio.run(_on_page(port, to_the_end))
    return [when - begun for when in line]


def _bare_start(env: Environment) -> float:
    """Seconds from the command to the page of a bare viser."""
    begun = perf_counter()
    with served("tests.benchmarks.echo", env=env) as port:
        _wait_for(port, "/")
        return perf_counter() - begun


def _time_line(name: str, runs: list[list[float]], bare: float, goal: float) -> None:
    stages = [[run[k] for run in runs if k < len(run)] for k in range(len(STAGES))]
    medians = [p50(stage) for stage in stages if stage]
    print(f"  {name}: " + " · ".join(f"{stage} {at:.2f} s" for stage, at in zip(STAGES, medians, strict=False)))
    page = medians[STAGES.index("page up")]
    print(f"    page up: {page / bare:.2f} × the page of a bare viser ({bare:.2f} s)")
    verdict(f"arm moves, {name}", medians[STAGES.index("arm moves")], goal, " s")


def run() -> None:
    """Compiling every kernel takes a minute, so only the first empty cache is filled to the end."""
    with tempfile.TemporaryDirectory() as bytecode, tempfile.TemporaryDirectory() as kept:
        env = {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": bytecode}
        _bare_start(env)
        first, warm, bare = [_start(kept, env, to_the_end=True)], list[list[float]](), list[float]()
        _commands({**env, "NUMBA_CACHE_DIR": kept})
        for _ in range(RUNS):
            with tempfile.TemporaryDirectory() as empty:
                first.append(_start(empty, env, to_the_end=False))
            warm.append(_start(kept, env, to_the_end=True))
            bare.append(_bare_start(env))
    _time_line("full cache", warm, p50(bare), WARM)
    _time_line("empty cache", first, p50(bare), FIRST)
