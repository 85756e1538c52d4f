"""The methods of inverse kinematics, a file each; `method.Method` says what such a file holds."""

from __future__ import annotations

import importlib
from functools import cache
from typing import cast

from helicoide import content
from helicoide.ik.method import Method
from helicoide.text import HelicoideError, Text

NEEDS = ("TITLE", "SOURCE", "EQUATION", "REMEMBERS", "PROMISES", "FIGURES", "Options", "applies", "start", "step")
__path__.append(str(content.user_folder() / "methods"))


@cache
def names() -> tuple[str, ...]:
    """The names of all methods: those of their files."""
    return content.modules(__name__, __path__, NEEDS)


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
