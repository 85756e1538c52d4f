"""The free body's files describe a box that six joints shift and turn about its middle, with the faces of a die."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.kinematics.forward import FORMULATIONS, link_motors
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder

ROBOT = Path(__file__).parents[2] / "robots" / "free_body"
shifts = st.lists(st.floats(-0.25, 0.25), min_size=3, max_size=3).map(np.array)
turns = st.lists(st.floats(-12.0, 12.0), min_size=3, max_size=3).map(np.array)


@pytest.fixture(scope="module")
def free_body() -> Robot:
    return robot_from_folder(ROBOT)


@given(shift=shifts, turn=turns, road=st.sampled_from(list(FORMULATIONS.values())))
def test_pose_is_the_shift_after_three_turns(free_body: Robot, shift: Array, turn: Array, road: object) -> None:
    """T = shift(x, y, z) Rz Ry Rx, and the product of the joints' motors is that of the factors, with its sign."""
    assert callable(road)
    q = np.concatenate([shift[::-1], turn[::-1]])
    motor = rigid.translator(shift)
    for axis in (2, 1, 0):
        motor = rigid.CL031.product(motor, rigid.rotor(np.eye(3)[axis], turn[axis]))
    np.testing.assert_allclose(road(free_body, q), rigid.pose_from_motor(motor), rtol=0, atol=1e-12)
    np.testing.assert_allclose(link_motors(free_body, q)[-1], motor, rtol=0, atol=1e-12)


def test_box_stands_around_the_tool(free_body: Robot) -> None:
    """The tool frame is in the middle of the box, parallel to its edges."""
    body = trimesh.load_scene(ROBOT / "meshes" / "body.glb").to_mesh()
    np.testing.assert_allclose(body.bounds.sum(axis=0), 0, atol=1e-9)
    np.testing.assert_allclose(free_body.T_world_tool_0, np.eye(4), atol=1e-12)
