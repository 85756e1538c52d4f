"""Two hundred thousand lines of the console: none raises but an error of ours, none exceeds its bounds."""

from __future__ import annotations

import gc
import random
import tracemalloc
from time import thread_time

import pytest
from tests.console.lines import fuzzed
from tests.console.test_fuzz import check

from helicoide.state import State

COUNT = 200_000
LONGEST, MOST_MEMORY = 0.050, 1_000_000  # s and bytes


@pytest.mark.soak
def test_two_hundred_thousand_lines_stay_within_their_bounds(state: State) -> None:
    source, given, times = random.Random(5), 0, []
    for _ in range(1_000):  # loads the kernels
        check(fuzzed(source), state)
    gc.freeze()  # as the commands do: otherwise the collector walks through all imported packages meanwhile
    for _ in range(COUNT):
        line = fuzzed(source)
        begins = thread_time()
        given += check(line, state)
        times.append(thread_time() - begins)
    gc.unfreeze()
    times.sort()
    middle, most = times[COUNT // 2], times[-COUNT // 10_000]
    print(
        f"{given} values; median {1e3 * middle:.2f} ms, 99.99 % {1e3 * most:.2f} ms, longest {1e3 * times[-1]:.2f} ms"
    )
    assert given > COUNT / 10
    assert most < LONGEST


@pytest.mark.soak
def test_a_line_takes_little_memory(state: State) -> None:
    source, largest = random.Random(6), 0
    tracemalloc.start()
    for _ in range(2_000):
        line = fuzzed(source)
        before = tracemalloc.get_traced_memory()[0]
        tracemalloc.reset_peak()
        check(line, state)
        largest = max(largest, tracemalloc.get_traced_memory()[1] - before)
    tracemalloc.stop()
    print(f"at most {largest / 1e3:.0f} kB")
    assert largest < MOST_MEMORY
