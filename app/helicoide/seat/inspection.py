"""What a person inspects in the scene, from where, and the notation in which it is written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from helicoide.geometry.notation import BladeNaming

SelectionKind = Literal["tool", "target", "link", "joint", "plane", "point", "frame", "entry", "path"]
ShownAlgebra = Literal["Cl(0,3,1)", "Cl(3,0,1)"]
"""The algebra of the sources, or that of modern texts."""
CameraPreset = Literal["front", "side", "top", "tool", "first"]
"""Where the camera of a window may go."""


@dataclass(frozen=True)
class Selection:
    """An object of the scene that a person inspects. index: its number among those of its kind, from 0."""

    kind: SelectionKind
    index: int = 0


@dataclass(frozen=True)
class Notation:
    """How multivectors and orientations are written. euler: one of `geometry.euler.CONVENTIONS`."""

    algebra: ShownAlgebra = "Cl(0,3,1)"
    naming: BladeNaming = "factors"
    euler: str = "zyx"
