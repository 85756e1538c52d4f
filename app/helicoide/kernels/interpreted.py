"""Kernels as plain Python while their machine code is not there yet: slower, with the same answers.

A tick of the arm takes half a millisecond so, and a tick is due every ten: an arm need not wait for a compiler.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from numba.core.registry import CPUDispatcher

_by_machine_code: ContextVar[bool] = ContextVar("by_machine_code", default=False)


class Interpretable(CPUDispatcher):
    """A compiled function that can be run as Python instead.

    Calls go through C, and cost nothing more, unless `interpret` has put a method of Python in their way.
    """

    @staticmethod
    def interpret(enabled: bool) -> None:
        """Run every kernel as Python from now on, but in threads that are `run_compiled`; or as ever again."""
        if enabled and not Interpretable.interpreted():
            Interpretable.__call__ = _interpreted  # type: ignore[method-assign, assignment]
        elif not enabled and Interpretable.interpreted():
            del Interpretable.__call__

    @staticmethod
    def interpreted() -> bool:
        """Whether kernels run as Python."""
        return "__call__" in vars(Interpretable)


def _interpreted(kernel: Any, *args: Any) -> Any:
    return CPUDispatcher.__call__(kernel, *args) if _by_machine_code.get() else kernel.py_func(*args)


@contextmanager
def run_compiled() -> Iterator[None]:
    """Within, in this thread, kernels are loaded, compiled and run by their machine code whatever others do."""
    before = _by_machine_code.set(True)
    try:
        yield
    finally:
        _by_machine_code.reset(before)


@contextmanager
def run_interpreted() -> Iterator[None]:
    """Within, kernels run as Python, for what is done in less time than their machine code takes to load."""
    before = Interpretable.interpreted()
    Interpretable.interpret(True)
    try:
        yield
    finally:
        Interpretable.interpret(before)
