"""Products of the algebras in use, as generated code: a file each, from `python -m tests.geometry.write_products`."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

from helicoide.geometry.signature import Array, Signature

Into = Callable[[Array, Array, Array], None]


class OfTwo(NamedTuple):
    """Functions that multiply two multivectors a and b, each (2ⁿ,), into a third."""

    product: Into
    """The geometric product a b."""

    sandwich: Into
    """The sandwich a b a* with the Clifford conjugate."""


def module_of(algebra: Signature) -> str:
    """The name of an algebra's file, such as cl_0_3_1."""
    return f"cl_{algebra.p}_{algebra.q}_{algebra.r}"


def written_out(algebra: Signature) -> OfTwo | None:
    """The generated kernels of an algebra; None if there are none."""
    name = f"{__name__}.{module_of(algebra)}"
    if find_spec(name) is None:
        return None
    module = import_module(name)
    return OfTwo(module.product, module.sandwich)
