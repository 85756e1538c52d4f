"""The tabs of a window, a file each: TITLE, ORDER, ICON, and `rows(robot)`."""

from __future__ import annotations

from types import ModuleType

from helicoide import content


def all_panels() -> list[ModuleType]:
    """Every panel there is, in its order."""
    return sorted(content.modules(__name__).values(), key=lambda panel: panel.ORDER)
