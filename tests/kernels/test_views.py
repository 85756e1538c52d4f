"""Kernels that make no array do not count who holds one: what they hand on may be counted by nobody else."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator
from types import ModuleType
from typing import Any, get_args, get_origin, get_type_hints

import numpy as np

import helicoide
from helicoide.arrays import Array
from helicoide.kernels import KERNELS, Kernel, kernel, kernel_into, python_function


def holds_an_array(kind: Any) -> bool:
    """Whether a value of an annotated type is an array, or has one."""
    if get_origin(kind) is np.ndarray or kind is np.ndarray:
        return True
    if isinstance(kind, type) and hasattr(kind, "_fields"):
        return any(map(holds_an_array, get_type_hints(kind).values()))
    return any(map(holds_an_array, get_args(kind)))


def counting(kernels: list[Kernel]) -> list[Kernel]:
    return [one for one in kernels if one.targetoptions["_nrt"]]


def called_by(caller: Kernel) -> Iterator[Kernel]:
    """Kernels that a kernel names, by themselves or in a module."""
    function = python_function(caller)
    named = function.__code__.co_names
    known = [function.__globals__.get(name) for name in named]
    inside = [getattr(module, name, None) for module in known if isinstance(module, ModuleType) for name in named]
    return (one for one in (*known, *inside) if isinstance(one, Kernel))


def misused(kernels: list[Kernel]) -> Iterator[str]:
    """Kernels that count arrays and call one that hands on arrays without counting."""
    for caller in counting(kernels):
        for called in called_by(caller):
            if not counting([called]) and holds_an_array(get_type_hints(python_function(called))["return"]):
                yield f"{caller.__name__} calls {called.__name__}"


def test_what_hands_on_views_is_called_by_its_own_kind_alone() -> None:
    for module in pkgutil.walk_packages(helicoide.__path__, "helicoide."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    every = [one for name, one in KERNELS.items() if name.startswith("helicoide.")]
    assert KERNELS["helicoide.ik.guard.qp.solve_into"] in called_by(KERNELS["helicoide.ik.guard.qp.solve_qp"])
    assert holds_an_array(get_type_hints(python_function(KERNELS["helicoide.ik.guard.work.opened"]))["return"])
    assert [*misused(every)] == []


@kernel_into
def halves(a: Array) -> tuple[Array, Array]:
    return a[:1], a[1:]


@kernel
def first(a: Array) -> float:
    return float(halves(a)[0][0])


def test_a_misuse_is_found() -> None:
    assert [*misused([halves, first])] == ["first calls halves"]
