"""The open recording: the recorded arm as an outline at the time shown, the path of its tool, and its planes."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.confinement import Planes, pane_axes
from helicoide.recorder.panel_state import RecordingPanelState
from helicoide.recorder.read_back import ReadBack, poses_at
from helicoide.view.colours import GREEN, ORANGE
from helicoide.view.layers import Stage
from helicoide.view.layers.planes import border
from helicoide.view.outline import Outline
from helicoide.view.window_view import View

NAME = "recorded"
SHARED = False

COLOUR, SENT, PLANES = ORANGE, GREEN, ORANGE
NO_LINE = np.zeros((1, 2, 3), np.float32)


def build(stage: Stage) -> RecordedLayer:
    """The layer, empty until a recording is open."""
    return RecordedLayer(stage)


class RecordedLayer:
    """The outline, the path that was read back, the path that was sent, and the borders of the planes."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.outline: Outline | None = None
        self.lines: dict[str, viser.LineSegmentsHandle] = {}
        self.drawn: ReadBack | None = None
        self.planes: Planes | None = None

    def update(self, old: View | None, new: View) -> None:
        """Follow the open recording and its time."""
        if old is not None and old.recordings is new.recordings and old.state.robot is new.state.robot:
            return
        shown = _fitting(new)
        if shown is None and self.outline is None:
            return
        if self.outline is None:
            self._make()
        if shown is not self.drawn:
            self.drawn = shown
            self._draw_paths(shown)
        self._place(shown, new.recordings)

    def _make(self) -> None:
        """Add the outline and the lines, which most windows never need."""
        self.outline = Outline(self.stage, NAME, COLOUR)
        for name, colour in (("trail", COLOUR), ("sent", SENT), ("planes", PLANES)):
            self.lines[name] = self.stage.scene.add_line_segments(
                f"/{NAME}/{name}", NO_LINE, colour, thickness=0.002 * self.stage.size
            )

    def _draw_paths(self, shown: ReadBack | None) -> None:
        paths = {"trail": None, "sent": None} if shown is None else {"trail": shown.trail, "sent": shown.sent_trail}
        for name, points in paths.items():
            self._draw(name, None if points is None else np.stack([points[:-1], points[1:]], axis=1))

    def _place(self, shown: ReadBack | None, panel: RecordingPanelState) -> None:
        assert self.outline is not None
        self.outline.show(shown is not None)
        planes = None
        if shown is not None:
            poses = poses_at(self.stage.robot, shown.samples, panel.instant)
            self.outline.write(poses, shown.recording.gripper_at(panel.instant))
            planes = shown.recording.planes_at(panel.instant)
        if planes is not self.planes:
            self.planes = planes
            self._draw("planes", None if planes is None else _borders(planes))

    def _draw(self, name: str, segments: Array | None) -> None:
        line = self.lines[name]
        line.visible = segments is not None and len(segments) > 0
        if segments is not None and len(segments):
            line.points = segments.astype(np.float32)


def _fitting(view: View) -> ReadBack | None:
    shown = view.recordings.shown
    return shown if shown is not None and shown.fits(view.state.robot) else None


def _borders(planes: Planes) -> Array:
    """The borders of all panes, (4 k, 2, 3), m, world frame."""
    borders = [
        border(pane.size) @ pane_axes(normal).T + centre
        for pane, normal, centre in zip(planes.panes, planes.normals, planes.centres, strict=True)
    ]
    return np.concatenate([np.zeros((0, 2, 3)), *borders])
