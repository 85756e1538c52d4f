"""The time line of a start, with the kernel cache full and empty, beside the start of a bare viser."""

from __future__ import annotations

import asyncio
import http.client
import tempfile
from contextlib import closing
from http import HTTPStatus
from itertools import zip_longest
from time import perf_counter, sleep

from tests.benchmarks.report import p50, verdict
from tests.benchmarks.served import served
from tests.pages import opened

TITLE = "From the command to the page, with and without the kernel cache"
RUNS = 3
GOAL = 2.5
STAGES = ("address printed", "/healthz answers", "page up", "arm ready")


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


async def _arm_ready(port: int) -> None:
    async with opened(port) as page:
        await page.ready()


def _start(cache: str, to_the_end: bool = True) -> list[float]:
    """Seconds from the command to each stage; the last is left out unless it is asked for."""
    begun, line = perf_counter(), []
    with served("helicoide", "--port", "0", env={"NUMBA_CACHE_DIR": cache}) as port:
        line.append(perf_counter() - begun)
        for path in ("/healthz", "/"):
            _wait_for(port, path)
            line.append(perf_counter() - begun)
        if to_the_end:
            asyncio.run(_arm_ready(port))
            line.append(perf_counter() - begun)
    return line


def _bare_start() -> float:
    """Seconds from the command to the page of a bare viser."""
    begun = perf_counter()
    with served("tests.benchmarks.echo") as port:
        _wait_for(port, "/")
        return perf_counter() - begun


def _time_line(name: str, runs: list[list[float]], bare: float) -> None:
    medians = [p50(list(filter(None, stage))) for stage in zip_longest(*runs)]
    print(f"  {name}: " + " · ".join(f"{stage} {at:.2f} s" for stage, at in zip(STAGES, medians, strict=True)))
    page = medians[STAGES.index("page up")]
    print(f"    {page / bare:.2f} × the page of a bare viser ({bare:.2f} s)")
    verdict(f"page up, {name}", page, GOAL, " s")


def run() -> None:
    """Compiling every kernel takes half a minute, so only the last empty cache is filled to the end."""
    empty, full, bare = [], [], []
    for run in range(RUNS):
        with tempfile.TemporaryDirectory() as cache:
            empty.append(_start(cache, to_the_end=run == RUNS - 1))
            if run == RUNS - 1:
                full = [_start(cache) for _ in range(RUNS)]
        bare.append(_bare_start())
    _time_line("full cache", full, p50(bare))
    _time_line("empty cache", empty, p50(bare))
