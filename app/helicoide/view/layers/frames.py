"""The frames of the links and of the tool; hidden by default."""

from __future__ import annotations

import viser

from helicoide.text import Text
from helicoide.view.layers import Stage
from helicoide.view.pose import place_node
from helicoide.view.window_view import View

NAME = "frames"
SHARED = False
TITLE = Text(en="Link frames", pt_BR="Referenciais dos elos")
SHOWN = False
KIND = "algebra"
SAID = Text(
    en="The frames of the base, the links and the end effector: x red, y green, z blue.",
    pt_BR="Os referenciais da base, dos elos e do efetuador: x vermelho, y verde, z azul.",
)


def build(stage: Stage) -> Frames:
    """A frame for the base, each link and the tool."""
    names = ["base", *(joint.name for joint in stage.robot.joints), "tool"]
    return Frames(
        [
            stage.scene.add_frame(
                f"/frames/{name}", axes_length=0.09 * stage.size, axes_radius=0.0035 * stage.size, visible=False
            )
            for name in names
        ]
    )


class Frames:
    """The frames."""

    def __init__(self, frames: list[viser.FrameHandle]) -> None:
        self.frames = frames

    def update(self, old: View | None, new: View) -> None:
        """Follow the links while shown."""
        shown = new.seat.visible_layers[NAME]
        for frame in self.frames:
            if frame.visible != shown:
                frame.visible = shown
        if shown:
            for frame, pose in zip(self.frames, [*new.state.arm.poses, new.state.T_world_tool], strict=True):
                place_node(frame, pose)
