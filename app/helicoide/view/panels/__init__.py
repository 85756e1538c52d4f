"""The tabs of a window. The module of each defines TITLE, ORDER, ICON and `rows(robot)`."""

from __future__ import annotations

from types import ModuleType

from helicoide import content


def all_panels() -> list[ModuleType]:
    """Every panel, sorted by ORDER."""
    return sorted(content.modules(__name__).values(), key=lambda panel: panel.ORDER)
