"""The methods of inverse kinematics, a file each; `method.Method` says what such a file holds."""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache
from typing import cast

from helicoide.ik.method import Method
from helicoide.text import HelicoideError, Text


@cache
def names() -> tuple[str, ...]:
    """The names of all methods: those of their files."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@cache
def named(name: str) -> Method:
    """A method by its name; raises HelicoideError, which lists the names."""
    if name not in names():
        raise HelicoideError(
            Text(
                en="There is no method {name!r}; there is: {known}.", pt_BR="Não há método {name!r}; há: {known}."
            ).format(name=name, known=", ".join(names()))
        )
    return cast(Method, importlib.import_module(f"{__name__}.{name}"))
