"""The methods of inverse kinematics, one module each; `method.Method` describes such a module."""

from __future__ import annotations

from functools import cache
from typing import Any, cast

from helicoide import content
from helicoide.ik.method import ConfiguredMethod, Method
from helicoide.text import Text

NEEDS = ("TITLE", "SOURCE", "EQUATION", "REMEMBERS", "PROMISES", "FIGURES", "Options", "applies", "start", "step")
__path__.append(str(content.user_folder() / "methods"))


def names() -> tuple[str, ...]:
    """The names of all methods, which are their module names."""
    return content.module_names(__name__, NEEDS)


@cache
def named(name: str) -> Method:
    """The method with this name. Raises HelicoideError, which lists the known names."""
    return cast(Method, content.module(__name__, name, names(), Text(en="method", pt_BR="método")))


def configured_method(name: str, **options: Any) -> ConfiguredMethod:
    """The method with this name, with the given options. Raises HelicoideError for an unknown name."""
    method = named(name)
    return ConfiguredMethod(method, method.Options(**options))
