"""Products of the algebras in use, as generated code: a file each, from `python -m tests.geometry.write_products`."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from typing import NamedTuple

from helicoide.geometry.signature import Array, Signature

WriteProduct = Callable[[Array, Array, Array], None]


class PairProducts(NamedTuple):
    """Functions that multiply two multivectors a and b, each (2ⁿ,), into a third."""

    product: WriteProduct
    """The geometric product a b."""

    sandwich: WriteProduct
    """The sandwich a b a* with the Clifford conjugate."""


def generated_module_name(algebra: Signature) -> str:
    """The name of an algebra's file, such as cl_0_3_1."""
    return f"cl_{algebra.p}_{algebra.q}_{algebra.r}"


def generated_products(algebra: Signature) -> PairProducts | None:
    """The generated kernels of an algebra; None if there are none."""
    name = f"{__name__}.{generated_module_name(algebra)}"
    if find_spec(name) is None:
        return None
    module = import_module(name)
    return PairProducts(module.product, module.sandwich)
