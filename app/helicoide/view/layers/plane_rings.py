"""The rings that rotate the planes; hidden by default."""

from __future__ import annotations

from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.layers.handles import Handles

NAME = "turns"
SHARED = False
TITLE = Text(en="Plane rotation rings", pt_BR="Anéis de rotação dos planos")
SHOWN = False


def build(stage: Stage) -> Handles:
    """The layer, without rings at first."""
    return Handles(stage, NAME, rotates=True)
