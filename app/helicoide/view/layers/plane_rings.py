"""The rings that turn the planes, on request."""

from __future__ import annotations

from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.layers.handles import Handles

NAME = "turns"
SHARED = False
TITLE = Text(en="Rings that turn the planes", pt_BR="Anéis para girar os planos")
SHOWN = False


def build(stage: Stage) -> Handles:
    """None to begin with."""
    return Handles(stage, NAME, turns=True)
