"""Kernels run as plain Python until their machine code is ready: slower, with the same results.

A tick of the arm then takes half a millisecond, of the ten available: the arm need not wait for the compiler.
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

    Calls go directly to C, at no extra cost, unless `interpret` has replaced them by a Python method.
    """

    @staticmethod
    def interpret(enabled: bool) -> None:
        """Run every kernel as Python from now on, except within `run_compiled`; or run compiled kernels again."""
        if enabled and not Interpretable.interpreted():
            Interpretable.__call__ = _interpreted  # type: ignore[method-assign, assignment]
        elif not enabled and Interpretable.interpreted():
            del Interpretable.__call__

    @staticmethod
    def interpreted() -> bool:
        """Whether kernels currently run as Python."""
        return "__call__" in vars(Interpretable)


def _interpreted(kernel: Any, *args: Any) -> Any:
    return CPUDispatcher.__call__(kernel, *args) if _by_machine_code.get() else kernel.py_func(*args)


@contextmanager
def run_compiled() -> Iterator[None]:
    """Within this context, in this thread, kernels run as machine code, whatever other threads do."""
    before = _by_machine_code.set(True)
    try:
        yield
    finally:
        _by_machine_code.reset(before)


@contextmanager
def run_interpreted() -> Iterator[None]:
    """Within this context kernels run as Python, for work that is shorter than loading their machine code."""
    before = Interpretable.interpreted()
    Interpretable.interpret(True)
    try:
        yield
    finally:
        Interpretable.interpret(before)


@contextmanager
def run_none(refusal: Exception) -> Iterator[None]:
    """Within this context no kernel runs: each call of one raises `refusal`, in every thread."""

    def refused(kernel: Any, *args: Any) -> Any:
        raise refusal

    before = vars(Interpretable).get("__call__")
    Interpretable.__call__ = refused  # type: ignore[method-assign, assignment]
    try:
        yield
    finally:
        del Interpretable.__call__
        if before is not None:
            Interpretable.__call__ = before  # type: ignore[method-assign]
