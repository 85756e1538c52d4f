"""The arm: a frame for each URDF link with its meshes; our own forward kinematics writes the frames."""

from __future__ import annotations

import numpy as np
import viser

from helicoide.geometry import rotation
from helicoide.kinematics.chain import Array
from helicoide.view.layers import Stage
from helicoide.view.rows import View
from helicoide.view.shapes import Shape

NAME = "arm"
SHARED = True


def build(stage: Stage) -> Arm:
    """The solid arm."""
    frames = []
    for shape in stage.shapes:
        frames.append(stage.scene.add_frame(f"/arm/{shape.name}", show_axes=False))
        stage.scene.add_glb(f"/arm/{shape.name}/mesh", shape.glb)
    return Arm(stage.shapes, frames)


def place(shapes: list[Shape], frames: list[viser.FrameHandle], poses: Array, gripper: float) -> None:
    """Write the pose of every link's frame. Args: poses (n + 1, 4, 4), m; gripper: 0 closed to 1 open."""
    quats = rotation.from_matrix(poses[:, :3, :3])
    for shape, frame in zip(shapes, frames, strict=True):
        pose = poses[shape.link]
        frame.wxyz = quats[shape.link]
        frame.position = pose[:3, 3] + pose[:3, :3] @ (shape.T_link_shape[:3, 3] + gripper * shape.slide)


class Arm:
    """The frames of the solid arm."""

    def __init__(self, shapes: list[Shape], frames: list[viser.FrameHandle]) -> None:
        self.shapes, self.frames = shapes, frames

    def update(self, old: View | None, new: View) -> None:
        """Follow joints and gripper."""
        state = new.state
        if old is None or old.state.q is not state.q or old.state.gripper != state.gripper:
            place(self.shapes, self.frames, np.asarray(state.poses), state.gripper)
