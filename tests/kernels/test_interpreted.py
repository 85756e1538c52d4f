"""Kernels as Python while their machine code is not there: the same answers, and nothing is compiled."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helicoide.kernels import Kernel, NotCached, kernel, only_cached, run_compiled

Array = NDArray[np.float64]


@pytest.fixture(autouse=True)
def interpreted() -> Iterator[None]:
    Kernel.interpret(True)
    yield
    Kernel.interpret(False)


def halved(x: float) -> float:
    return x / 2.0


def made() -> tuple[Any, Any]:
    """A kernel, and one that calls it."""
    half = kernel(halved)

    def halves(a: Array) -> float:
        total = 0.0
        for x in a:
            total += half(x)
        return total

    return half, Kernel(halves)


def test_nothing_is_compiled() -> None:
    half, halves = made()
    assert halves(np.arange(4.0)) == 3.0
    assert (half.signatures, halves.signatures) == ([], [])


def test_a_thread_loads_and_compiles_meanwhile() -> None:
    half, halves = made()
    with run_compiled():
        with only_cached(), pytest.raises(NotCached):
            halves(np.arange(4.0))
        assert halves(np.arange(4.0)) == 3.0
        other = threading.Thread(target=halves, args=(np.arange(4),))
        other.start()
        other.join()
    assert (len(half.signatures), len(halves.signatures)) == (1, 1), "and none in another thread"


def test_afterwards_calls_go_to_machine_code_at_once() -> None:
    _, halves = made()
    Kernel.interpret(False)
    assert not Kernel.interpreted()
    assert halves(np.arange(4.0)) == 3.0
    assert len(halves.signatures) == 1


def test_it_may_be_said_twice() -> None:
    Kernel.interpret(True)
    assert Kernel.interpreted()
    Kernel.interpret(False)
    Kernel.interpret(False)
    assert not Kernel.interpreted()
