"""A hundred thousand rewritten lines are accepted; a verdict on any line takes less than 200 ms."""

from __future__ import annotations

import gc
import random
from time import thread_time

import pytest
from tests.console.lines import fuzzed
from tests.lines.exercises import EXERCISES
from tests.lines.recorded import wrong_lines
from tests.lines.rewriting import rewritten
from tests.lines.test_fuzz import TASKS, answered

from helicoide.lines import Accepted, check_line

REWRITTEN, FUZZED = 100_000, 20_000
LONGEST = 0.2  # s


@pytest.mark.soak
def test_a_hundred_thousand_rewritten_lines_are_accepted() -> None:
    source, names = random.Random(17), sorted(EXERCISES)
    for n in range(REWRITTEN):
        name = names[n % len(names)]
        text = rewritten(EXERCISES[name], source, 2 + n % 12)
        assert check_line(EXERCISES[name], text) == Accepted(), (name, text)


@pytest.mark.soak
def test_a_verdict_takes_less_than_the_blink_of_an_eye() -> None:
    source, times = random.Random(18), []
    lines = [(EXERCISES[line.exercise], line.text) for line in wrong_lines()]
    lines += [(TASKS[n % len(TASKS)], fuzzed(source)) for n in range(FUZZED)]
    for task, text in lines[:1_000]:  # loads the kernels
        answered(task, text)
    gc.freeze()  # as the commands do: otherwise the collector walks through all imported packages meanwhile
    for task, text in lines:
        begins = thread_time()
        answered(task, text)
        times.append(thread_time() - begins)
    gc.unfreeze()
    times.sort()
    print(f"median {1e3 * times[len(times) // 2]:.1f} ms, 99 % {1e3 * times[-len(times) // 100]:.0f} ms, "
          f"longest {1e3 * times[-1]:.0f} ms")  # fmt: skip
    assert times[-1] < LONGEST
