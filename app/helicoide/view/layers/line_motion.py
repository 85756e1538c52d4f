"""The motion of a wrong line of an exercise beside the right one: a frame beside the arm after each of them."""

from __future__ import annotations

import viser

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.view.colours import GREEN, ORANGE, Colour
from helicoide.view.layers import Stage
from helicoide.view.line_rows import wrong_term
from helicoide.view.window_view import LineCheck, View

NAME = "line_motion"
SHARED = False

WRONG, RIGHT = ORANGE, GREEN
LENGTH, RADIUS = 0.2, 0.005
BESIDE = -0.75  # y of the frame before the motions, as a share of the reach: free space at the arm's right


def build(stage: Stage) -> LineMotion:
    """The layer, without frames."""
    return LineMotion(stage)


class LineMotion:
    """The two frames of one window."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.frames: list[viser.FrameHandle] = []
        self.shown: LineCheck | None = None

    def update(self, old: View | None, new: View) -> None:
        """Show both motions while the line that was typed last is wrong and is a motion."""
        found = wrong_term(new)
        check = None if found is None else found[0]
        if check is self.shown:
            return
        self.shown = check
        while self.frames:
            self.frames.pop().remove()
        if found is not None and found[1].wrong_pose is not None and found[1].right_pose is not None:
            self._add("wrong", found[1].wrong_pose, WRONG)
            self._add("right", found[1].right_pose, RIGHT)

    def _add(self, name: str, T: Array, colour: Colour) -> None:
        self.frames.append(
            self.stage.scene.add_frame(
                f"/line_motion/{name}",
                axes_length=LENGTH * self.stage.size,
                axes_radius=RADIUS * self.stage.size,
                origin_radius=4 * RADIUS * self.stage.size,
                origin_color=colour,
                wxyz=rotation.from_matrix(T[:3, :3]),
                position=T[:3, 3] + [0.0, BESIDE * self.stage.robot.reach, LENGTH * self.stage.size],
            )
        )
