"""The arm: a frame for each URDF link with its meshes, placed by our own forward kinematics.

All windows of a workcell share these nodes. Whether the arm is transparent belongs to a seat, so the pages themselves
change the materials of the meshes (static/transparent.js). A second, transparent copy in each window would be one more
object to move at every frame, and viser has no opacity for GLB meshes.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import viser

from helicoide.arrays import Array
from helicoide.view.layers import Stage
from helicoide.view.pose import place_node
from helicoide.view.shapes import Shape
from helicoide.view.window_view import View

NAME = "arm"
SHARED = True


def build(stage: Stage) -> ArmLayer:
    """The solid arm."""
    frames = []
    for shape in stage.shapes:
        frames.append(stage.scene.add_frame(f"/arm/{shape.name}", show_axes=False))
        stage.scene.add_glb(f"/arm/{shape.name}/mesh", shape.glb)
    return ArmLayer(LinkNodes(stage.shapes, frames))


class LinkNodes:
    """Frames in the scene that follow the links which carry their shapes."""

    def __init__(self, shapes: Sequence[Shape], frames: Sequence[viser.FrameHandle]) -> None:
        self.frames = frames
        self.links = [shape.link for shape in shapes]
        self.Ts_link_shape = np.array([shape.T_link_shape for shape in shapes]).reshape(-1, 4, 4)
        self.slides = np.array([shape.slide for shape in shapes]).reshape(-1, 3, 1)

    def write(self, Ts_world_link: Array, gripper: float) -> None:
        """Move the frames to link poses (m + 1, 4, 4), m; gripper: 0 closed to 1 open."""
        carriers = Ts_world_link[self.links]
        Ts = carriers @ self.Ts_link_shape
        Ts[:, :3, 3:] += gripper * carriers[:, :3, :3] @ self.slides
        for frame, T in zip(self.frames, Ts, strict=True):
            place_node(frame, T)


class ArmLayer:
    """The solid arm's frames."""

    def __init__(self, placement: LinkNodes) -> None:
        self.placed = placement

    def update(self, old: View | None, new: View) -> None:
        """Follow joints and gripper."""
        state = new.state
        if old is None or old.state.arm.q is not state.arm.q or old.state.arm.gripper != state.arm.gripper:
            self.placed.write(np.asarray(state.arm.poses), state.arm.gripper)
