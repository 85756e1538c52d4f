"""The rings that rotate the planes; hidden by default."""

from __future__ import annotations

from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.layers.handles import Handles

NAME = "turns"
SHARED = False
TITLE = Text(en="Plane rotation rings", pt_BR="Anéis de rotação dos planos")
SHOWN = False
KIND = "confinement"
SAID = Text(
    en="Rings on each plane that can be moved: drag one to rotate the plane.",
    pt_BR="Anéis em cada plano móvel: arraste um deles para girar o plano.",
)


def build(stage: Stage) -> Handles:
    """The layer, without rings at first."""
    return Handles(stage, NAME, rotates=True)
