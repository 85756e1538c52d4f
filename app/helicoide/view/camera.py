"""Where the camera of a window stands: presets from the front, the side and the top, and along the tool."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import get_args

import numpy as np

from helicoide.arrays import Array
from helicoide.seat import CameraPreset
from helicoide.state import State
from helicoide.text import Text
from helicoide.view.scene import outlook

PRESETS: Mapping[CameraPreset, Text] = MappingProxyType(
    {
        "front": Text(en="Front", pt_BR="Frente"),
        "side": Text(en="Side", pt_BR="Lado"),
        "top": Text(en="Top", pt_BR="Cima"),
        "tool": Text(en="End effector", pt_BR="Efetuador"),
        "first": Text(en="Initial", pt_BR="Inicial"),
    }
)
# From where the camera looks, and which direction is to the right in the picture. An arm at zero points along x.
FRONT = (np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]))
SIDE = (np.array([0.0, -1.0, 0.0]), np.array([1.0, 0.0, 0.0]))
TOP = (np.array([0.0, -0.001, 1.0]), np.array([1.0, 0.0, 0.0]))  # exactly from above, no direction would be upward
TO_THE_RIGHT = 0.28  # the panel covers the right side of a window; as a share of the size of the arm
BEHIND = 0.45  # distance of the camera from the tool, as a share of the reach


def camera_pose(preset: CameraPreset, state: State, fov: float, aspect: float) -> tuple[Array, Array]:
    """Camera position and the point that it looks at, (3,) m each. fov: vertical, rad; aspect: width by height.

    `tool` looks along the z axis of the tool, from behind it, at the present posture; it does not follow the tool.
    """
    assert preset in get_args(CameraPreset)
    upright = aspect < 1.0
    if preset == "first":
        return outlook(state.robot, upright)
    if preset == "tool":
        return _behind_tool(state)
    points = np.array([[0.0, 0.0, state.robot.floor], *state.monitored_points])
    low, high = points.min(axis=0), points.max(axis=0)
    centre, size = (low + high) / 2, max(state.robot.reach, float(np.linalg.norm(high - low)))
    direction, right = {"front": FRONT, "side": SIDE, "top": TOP}[preset]
    if not upright:
        centre = centre + TO_THE_RIGHT * size * right
    far = 0.85 * size / np.tan(fov / 2 * min(1.0, aspect))
    return centre + far * direction, centre


def _behind_tool(state: State) -> tuple[Array, Array]:
    """The camera behind the tool. If the tool is vertical, it is moved aside a little, since it needs a horizon."""
    T, far = state.T_world_tool, BEHIND * state.robot.reach
    tool, along = T[:3, 3], T[:3, 2]
    aside = 0.02 * far * T[:3, 0] if np.hypot(*along[:2]) < 0.02 else np.zeros(3)
    return tool - far * along + aside, tool
