"""The DH frames of the arm, and the four parameters of each row between them."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from helicoide.arrays import Array
from helicoide.kinematics.dh_parts import dh_parts
from helicoide.kinematics.forward import dh_frames
from helicoide.readout.signal import subscript
from helicoide.state import State
from helicoide.text import Language, Text, untranslated
from helicoide.view.colours import BLUE, GREEN, ORANGE, PURPLE
from helicoide.view.figures import FrameSet, Names, Segments, polyline
from helicoide.view.layers import Stage
from helicoide.view.optional_layer import OptionalLayer
from helicoide.view.window_view import View

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
ANGLE, LENGTH = untranslated("{part} {value:z.4g}°"), untranslated("{part} {value:z.0f} mm")
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
        drawing = _drawing(view.state, self.stage.size, view.seat.language)
        self.frames.write(drawing.frames)
        for lines, segments in zip(self.parts.values(), drawing.segments, strict=True):
            lines.write(segments)
        self.names.write(drawing.texts, drawing.places)


class _Drawing(NamedTuple):
    """The poses of the frames (m + 1, 4, 4), m; the segments of θ, d, a and α (k, 2, 3), m; the texts and places."""

    frames: Array
    segments: list[Array]
    texts: list[str]
    places: list[Array]


@lru_cache(maxsize=4)
def _drawing(state: State, size: float, language: Language) -> _Drawing:
    """What is drawn for a state. Cached, as windows of one language and size share it."""
    robot, q = state.robot, state.arm.q
    frames = dh_frames(robot, q)
    rows = dh_parts(robot, q, frames, RADIUS * size)
    drawn = np.abs(rows.values) > NOTHING
    segments, texts, places = [], [], []
    for part, values, there, symbol in zip(rows[:4], rows.values.T, drawn.T, COLOURS, strict=True):
        segments.append(polyline(part[there]))
        angle = part.shape[1] > 2
        middles = part[:, part.shape[1] // 2] if angle else part.mean(axis=1)
        shown = (np.degrees(values) if angle else 1000 * values).round(1 if angle else 0)
        for n in np.flatnonzero(there).tolist():
            texts.append(_words(symbol, n + 1, float(shown[n]), angle)[language])
            places.append(middles[n])
    return _Drawing(np.array(frames), segments, texts, places)


@lru_cache(maxsize=1024)
def _words(symbol: str, n: int, shown: float, angle: bool) -> Text:
    """The name of a part with its value. Cached, since most values stay the same."""
    return (ANGLE if angle else LENGTH).format(part=subscript(symbol, n), value=shown)
