"""The DH frames of the arm, and the four parameters of each row between them."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from helicoide.kinematics.dh_parts import DhParts, dh_parts
from helicoide.kinematics.forward import dh_frames
from helicoide.text import Language, Text
from helicoide.view.figures import BLUE, GREEN, ORANGE, PURPLE, FrameSet, Names, Segments, polyline
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.rows import View

NAME = "dh"
SHARED = False
TITLE = Text(en="DH frames and parameters", pt_BR="Referenciais e parâmetros de DH")
SHOWN = False
KIND = "algebra"
SAID = Text(
    en="The DH frames in the convention of this arm's file. Between two frames: θ (orange arc) about z, d (blue) along "
    "z, a (green) along x, α (purple arc) about x, in degrees and mm; what is zero is left out.",
    pt_BR="Os referenciais de DH na convenção do arquivo deste braço. Entre dois referenciais: θ (arco laranja) em "
    "torno de z, d (azul) ao longo de z, a (verde) ao longo de x, α (arco púrpura) em torno de x, em graus e mm; o que "
    "é nulo não aparece.",
)

AXES, RADIUS = 0.08, 0.07  # length of the axes and radius of the arcs, × size, m
NOTHING = 1e-9  # rad or m: what is smaller is not drawn
ANGLE = Text(en="{symbol}{n} {value:.1f}°", pt_BR="{symbol}{n} {value:.1f}°")
LENGTH = Text(en="{symbol}{n} {value:.0f} mm", pt_BR="{symbol}{n} {value:.0f} mm")
COLOURS = {"θ": ORANGE, "d": BLUE, "a": GREEN, "α": PURPLE}


def build(stage: Stage) -> DhLayer:
    """The layer."""
    return DhLayer(stage, NAME)


class DhLayer(OptionalLayer):
    """The frames in one node, the parts of each kind in one node, and their names."""

    def __init__(self, stage: Stage, name: str) -> None:
        super().__init__(stage, name)
        self.frames = FrameSet(stage, f"/{name}/frames", AXES)
        self.parts = {
            symbol: Segments(stage, f"/{name}/{key}", COLOURS[symbol])
            for key, symbol in (("theta", "θ"), ("d", "d"), ("a", "a"), ("alpha", "α"))
        }
        self.names = Names(stage, f"/{name}")

    def draw(self, view: View) -> None:
        """Draw frames and parts."""
        robot, q, size = self.stage.robot, view.state.arm.q, self.stage.size
        self.frames.write(np.array(dh_frames(robot, q)))
        rows = dh_parts(robot, q, RADIUS * size)
        for place, lines in enumerate(self.parts.values()):
            drawn = [polyline(row.drawn[place]) for row in rows if abs(row.values[place]) > NOTHING]
            lines.write(np.concatenate([np.zeros((0, 2, 3)), *drawn]))
        named = [_named(row, n + 1, view.seat.language) for n, row in enumerate(rows)]
        self.names.write([text for row in named for text, _ in row], [at for row in named for _, at in row])


def _named(row: DhParts, n: int, language: Language) -> list[tuple[str, np.ndarray]]:
    """The names of the parts of row n that are not zero, each at the middle of its part."""
    named = []
    for symbol, part, value in zip(COLOURS, row.drawn, row.values, strict=True):
        if abs(value) > NOTHING:
            angle = len(part) > 2
            shown = round(np.degrees(value), 1) if angle else round(1000 * value)
            middle = part[len(part) // 2] if angle else (part[0] + part[1]) / 2
            named.append((_words(symbol, n, float(shown), angle)[language], middle))
    return named


@lru_cache(maxsize=1024)
def _words(symbol: str, n: int, shown: float, angle: bool) -> Text:
    """The name of a part with its value. Cached, since most values stay the same."""
    return (ANGLE if angle else LENGTH).format(symbol=symbol, n=n, value=shown)
