"""The methods of inverse kinematics, a file each; `method.Method` says what such a file holds."""

from __future__ import annotations

from functools import cache
from typing import cast

from helicoide import content
from helicoide.ik.method import Method
from helicoide.text import Text

NEEDS = ("TITLE", "SOURCE", "EQUATION", "REMEMBERS", "PROMISES", "FIGURES", "Options", "applies", "start", "step")
__path__.append(str(content.user_folder() / "methods"))


def names() -> tuple[str, ...]:
    """The names of all methods: those of their files."""
    return content.module_names(__name__, NEEDS)


@cache
def named(name: str) -> Method:
    """A method by its name; raises HelicoideError, which lists the names."""
    return cast(Method, content.module(__name__, name, names(), Text(en="method", pt_BR="método")))
