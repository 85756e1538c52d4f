"""How a peer of the inverse kinematics takes its turns: lines of JSON, single calls timed. Nothing knows Helicoide."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable
from time import perf_counter
from typing import Any

Numbers = list[Any]
Turn = Callable[[int, int], tuple[list[float], Numbers]]


def timed(call: Callable[[int], Any], which: Iterable[int]) -> tuple[list[float], Numbers]:
    """Seconds on the wall that each call took, and what it came to; a median does not feel who else was running."""
    seconds, answers = [], []
    for k in which:
        begun = perf_counter()
        answer = call(k)
        seconds.append(perf_counter() - begun)
        answers.append(answer)
    return seconds, answers


def plain(values: Any) -> Any:
    """Arrays as lists."""
    if isinstance(values, (list, tuple)):
        return [plain(value) for value in values]
    return values.tolist() if hasattr(values, "tolist") else values


def take_turns(prepared: Callable[..., Turn]) -> None:
    """Answer until the other side closes the pipe; what the peer itself prints goes to the error stream."""
    out, sys.stdout = sys.stdout, sys.stderr
    turn: Turn | None = None
    for line in sys.stdin:
        match json.loads(line):
            case {"given": given}:
                turn, said = prepared(**given), None
            case {"first": first, "beyond": beyond}:
                said = plain(turn(first, beyond))
        print(json.dumps(said), file=out, flush=True)


def following(start: Callable[[], None], step: Callable[[int], Any]) -> Turn:
    """The turns of a closed loop, which starts anew with the first step."""

    def turn(first: int, beyond: int) -> tuple[list[float], Numbers]:
        if first == 0:
            start()
        return timed(step, range(first, beyond))

    return turn
