"""Straight-line products of the algebras in use: a file for each, which `python -m tests.geometry.write_products` writes.

An algebra without a file is multiplied by its table, which takes some two to four times as long.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from typing import cast

from helicoide.geometry.signature import Array, Signature

Product = Callable[[Array, Array, Array], None]


def module_of(algebra: Signature) -> str:
    """The name of an algebra's file, such as cl_0_3_1."""
    return f"cl_{algebra.p}_{algebra.q}_{algebra.r}"


def straight(algebra: Signature) -> Product | None:
    """The kernel that writes a b into a third array, each of shape (2ⁿ,); None where no file holds one."""
    name = f"{__name__}.{module_of(algebra)}"
    return cast(Product, import_module(name).product) if find_spec(name) else None
