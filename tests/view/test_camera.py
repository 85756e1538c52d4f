"""The presets of the camera show every arm, from where they say."""

from __future__ import annotations

import numpy as np
import pytest

from helicoide.advance import advance
from helicoide.gate import set_joint
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.state import initial_state
from helicoide.view.camera import PRESETS, camera_pose

FOV = 1.2


def view_axes(position: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Right, up and forward of a camera with the z axis upward."""
    forward = (target - position) / np.linalg.norm(target - position)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    return right, np.cross(right, forward), forward


@pytest.mark.parametrize("name", robot_titles())
@pytest.mark.parametrize("aspect", [1.6, 0.5])
def test_the_whole_arm_is_in_front_side_and_top(name: str, aspect: float) -> None:
    state = initial_state(load_robot(name))
    for preset in ("front", "side", "top"):
        position, target = camera_pose(preset, state, FOV, aspect)  # type: ignore[arg-type]
        right, up, forward = view_axes(position, target)
        for point in state.monitored_points:
            x, y, z = right @ (point - position), up @ (point - position), forward @ (point - position)
            assert z > 0
            assert abs(y / z) < np.tan(FOV / 2)
            assert abs(x / z) < aspect * np.tan(FOV / 2)


@pytest.mark.parametrize("name", robot_titles())
@pytest.mark.parametrize("preset", PRESETS)
def test_every_preset_has_a_horizon(name: str, preset: str) -> None:
    position, target = camera_pose(preset, initial_state(load_robot(name)), FOV, 1.6)  # type: ignore[arg-type]
    forward = view_axes(position, target)[2]
    assert np.isfinite([position, target]).all()
    assert np.hypot(*forward[:2]) > 5e-4, "viser needs a direction that is upward"


def test_the_tool_is_seen_from_behind_also_in_the_middle_of_a_motion() -> None:
    state = set_joint(0, 0.5)(initial_state(load_robot("movemaster")))
    for _ in range(10):
        state = advance(state, 0.01)
    assert state.arm.moving
    position, target = camera_pose("tool", state, FOV, 1.6)
    T = state.T_world_tool
    np.testing.assert_allclose(target, T[:3, 3])
    assert (target - position) @ T[:3, 2] > 0.999 * np.linalg.norm(target - position)
