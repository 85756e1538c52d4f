"""Secondary objectives, a file each: what the joints do with the freedom that the task leaves them.

`objective.Objective` says what such a file holds.
"""

from __future__ import annotations

import importlib
import pkgutil
from functools import cache
from typing import cast

from helicoide.ik.objective import Objective
from helicoide.text import HelicoideError, Text


def names() -> tuple[str, ...]:
    """The names of all objectives: those of their files."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@cache
def named(name: str) -> Objective:
    """An objective by its name; raises HelicoideError, which lists the names."""
    if name not in names():
        raise HelicoideError(
            Text(
                en="There is no objective {name!r}; there is: {known}.", pt_BR="Não há objetivo {name!r}; há: {known}."
            ).format(name=name, known=", ".join(names()))
        )
    return cast(Objective, importlib.import_module(f"{__name__}.{name}"))
