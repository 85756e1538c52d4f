"""How a peer answers in a process of its own: a line of JSON for each line of JSON. Nothing here knows Helicoide."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import process_time
from timeit import Timer
from typing import Any

Rows = list[list[float]]
Blades = list[list[int]]


@dataclass(frozen=True)
class Task:
    """One way to one figure: the statement that is timed, and the expression that shows what it comes to."""

    figure: str
    statement: str
    shown: str
    names: dict[str, Any]

    def seconds(self, calls: int) -> float:
        """CPU time of one call, of so many in a row; other processes on the machine do not count."""
        return Timer(self.statement, globals=self.names, timer=process_time).timeit(calls) / calls

    def values(self) -> Any:
        """The numbers behind the figure, in lists."""
        return plain(eval(self.shown, self.names))


def plain(values: Any) -> Any:
    """Arrays in arrays as lists in lists."""
    if hasattr(values, "tolist"):
        return values.tolist()
    return [plain(value) for value in values] if isinstance(values, list) else values


def answer(tasks_of: Callable[..., Sequence[Task]]) -> None:
    """Answer until the other side closes the pipe; what the peer itself prints goes to the error stream."""
    out, sys.stdout = sys.stdout, sys.stderr
    tasks: Sequence[Task] = ()
    for line in sys.stdin:
        said: Any
        match json.loads(line):
            case {"given": given}:
                tasks = tasks_of(**given)
                said = [(task.figure, task.statement) for task in tasks]
            case {"values": index}:
                said = tasks[index].values()
            case {"seconds": index, "calls": calls}:
                said = tasks[index].seconds(calls)
        print(json.dumps(said), file=out, flush=True)
