"""The arm: a frame for each URDF link with its meshes; our own forward kinematics writes the frames."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import viser
from viser._messages import SetOrientationMessage, SetPositionMessage

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
    return Arm(Placed(stage.scene, stage.shapes, frames))


class Placed:
    """Frames in the scene that follow the links which carry their shapes.

    Their poses are said by viser's messages directly: its handles compare each value, which takes ten times as long.
    """

    def __init__(self, scene: viser.SceneApi, shapes: Sequence[Shape], frames: Sequence[viser.FrameHandle]) -> None:
        self.scene, self.frames = scene, frames
        self.written = np.full((len(shapes), 4, 4), np.nan)
        self.links = [shape.link for shape in shapes]
        self.Ts_link_shape = np.array([shape.T_link_shape for shape in shapes]).reshape(-1, 4, 4)
        self.slides = np.array([shape.slide for shape in shapes]).reshape(-1, 3, 1)

    def poses(self, Ts_world_link: Array, gripper: float) -> Array:
        """Where the shapes are, (s, 4, 4), m. Args: Ts_world_link (m + 1, 4, 4), m; gripper: 0 closed to 1 open."""
        carriers = Ts_world_link[self.links]
        Ts = carriers @ self.Ts_link_shape
        Ts[:, :3, 3:] += gripper * carriers[:, :3, :3] @ self.slides
        return np.asarray(Ts)

    def write(self, Ts_world_link: Array, gripper: float) -> None:
        """Bring the frames there, those that stand elsewhere."""
        Ts = self.poses(Ts_world_link, gripper)
        moved = np.flatnonzero((Ts != self.written).any(axis=(1, 2))).tolist()
        self.written = Ts
        quats, places = rotation.from_matrix(Ts[moved, :3, :3]).tolist(), Ts[moved, :3, 3].tolist()
        for k, quat, place in zip(moved, quats, places, strict=True):
            self.scene._queue_scene_message(SetOrientationMessage(self.frames[k].name, tuple(quat)))
            self.scene._queue_scene_message(SetPositionMessage(self.frames[k].name, tuple(place)))


class Arm:
    """The solid arm's frames."""

    def __init__(self, placed: Placed) -> None:
        self.placed = placed

    def update(self, old: View | None, new: View) -> None:
        """Follow joints and gripper."""
        state = new.state
        if old is None or old.state.arm.q is not state.arm.q or old.state.arm.gripper != state.arm.gripper:
            self.placed.write(np.asarray(state.arm.poses), state.arm.gripper)
