"""The tabs of a window, a file each: TITLE, ORDER, ICON, and `rows(robot)`."""

from __future__ import annotations

import importlib
import pkgutil
from types import ModuleType


def found() -> list[ModuleType]:
    """Every panel there is, in its order."""
    names = [module.name for module in pkgutil.iter_modules(__path__)]
    return sorted((importlib.import_module(f"{__name__}.{name}") for name in names), key=lambda panel: panel.ORDER)
