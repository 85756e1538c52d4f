"""The tabs of a window. The module of each defines TITLE, ORDER, ICON and `rows(robot)`."""

from __future__ import annotations

from types import ModuleType

from helicoide import content


def all_panels() -> list[ModuleType]:
    """Every panel, sorted by ORDER."""
    return sorted(content.modules(__name__).values(), key=lambda panel: panel.ORDER)


def panel_names() -> list[str]:
    """The names of the modules of all panels, sorted by ORDER."""
    return [panel.__name__.rpartition(".")[2] for panel in all_panels()]
