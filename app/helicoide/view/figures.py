"""The parts of optional layers: lines, arrows and names, each added to the scene when it is first needed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.view.colours import Colour
from helicoide.view.layers import Stage
from helicoide.view.pose import place_point


class Segments:
    """Line segments of one colour."""

    def __init__(self, stage: Stage, name: str, colour: Colour, thickness: float = 0.004) -> None:
        self.stage, self.name, self.colour, self.thickness = stage, name, colour, thickness
        self.handle: viser.LineSegmentsHandle | viser.ArrowsHandle | None = None

    def write(self, points: Array) -> None:
        """Draw these segments (k, 2, 3), m, and no others."""
        drawn = len(points) > 0
        if drawn and self.handle is None:
            self.handle = self._add(np.asarray(points, dtype=np.float32))
        elif drawn and self.handle is not None:
            self.handle.points = np.asarray(points, dtype=np.float32)
        if self.handle is not None and self.handle.visible != drawn:
            self.handle.visible = drawn

    def _add(self, points: Array) -> viser.LineSegmentsHandle | viser.ArrowsHandle:
        thickness = self.thickness * self.stage.size
        return self.stage.scene.add_line_segments(self.name, points, self.colour, thickness=thickness)


class Arrows(Segments):
    """Arrows of one colour, from the first to the second point of each segment."""

    HEAD: ClassVar[tuple[float, float]] = (2.75, 8.75)  # radius and length of the heads, in thicknesses of the shaft

    def _add(self, points: Array) -> viser.ArrowsHandle:
        thickness = self.thickness * self.stage.size
        radius, length = (thickness * share for share in self.HEAD)
        return self.stage.scene.add_arrows(
            self.name, points, self.colour, shaft_radius=thickness, head_radius=radius, head_length=length
        )


class FrameSet:
    """Frames with their axes, all of one size."""

    def __init__(self, stage: Stage, name: str, length: float) -> None:
        self.stage, self.name, self.length = stage, name, length
        self.handle: viser.BatchedAxesHandle | None = None

    def write(self, Ts: Array) -> None:
        """Draw frames at these poses (k, 4, 4), m; k stays the same."""
        wxyzs = rotation.from_matrix(Ts[:, :3, :3]).astype(np.float32)
        positions = Ts[:, :3, 3].astype(np.float32)
        if self.handle is None:
            length = self.length * self.stage.size
            self.handle = self.stage.scene.add_batched_axes(
                self.name, wxyzs, positions, axes_length=length, axes_radius=0.035 * length
            )
        else:
            self.handle.batched_wxyzs, self.handle.batched_positions = wxyzs, positions


NEAR, BETWEEN = 0.06, " · "  # × size, m: how near two names would overlap; what stands between joined ones


class Names:
    """Names and numbers at points of the scene; those that would overlap are joined into one label."""

    def __init__(self, stage: Stage, root: str) -> None:
        self.stage, self.root = stage, root
        self.labels: list[viser.LabelHandle] = []

    def write(self, texts: Sequence[str], places: Array | Sequence[Array]) -> None:
        """Show these texts at their places (k, 3), m, and no others."""
        texts, places = joined_names(texts, np.reshape(places, (-1, 3)), NEAR * self.stage.size)
        for k, (text, place) in enumerate(zip(texts, places, strict=True)):
            if k == len(self.labels):
                added = self.stage.scene.add_label(f"{self.root}/name {k}", text, anchor="bottom-center")
                self.labels.append(added)
            label, text = self.labels[k], text.replace("-", "−")
            if label.text != text:
                label.text = text
            place_point(label, place)
        for k, label in enumerate(self.labels):
            if label.visible != (k < len(texts)):
                label.visible = k < len(texts)


def joined_names(texts: Sequence[str], places: Array, near: float) -> tuple[list[str], Array]:
    """Texts and their places (k, 3), m, with each one that is nearer than `near` to an earlier one joined to it."""
    groups: list[list[int]] = []
    for k, place in enumerate(places):
        first = places[[group[0] for group in groups]]
        close = np.flatnonzero(((first - place) ** 2).sum(axis=1) < near**2)
        if len(close):
            groups[close[0]].append(k)
        else:
            groups.append([k])
    return [BETWEEN.join(texts[k] for k in group) for group in groups], places[[group[0] for group in groups]]


def polyline(points: Array) -> Array:
    """The segments (s, 2, 3) between successive points of one line (k, 3), or of each of several (m, k, 3)."""
    return np.stack([points[..., :-1, :], points[..., 1:, :]], axis=-2).reshape(-1, 2, 3)
