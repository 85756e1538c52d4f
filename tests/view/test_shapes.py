"""Meshes stand where the URDF puts them, for any q, whatever the frames of its links are."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
import yourdfpy
from viser._messages import Message, SetOrientationMessage, SetPositionMessage

from helicoide import content
from helicoide.geometry import rotation
from helicoide.kinematics import urdf_file
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load
from helicoide.view import shapes
from helicoide.view.layers.arm import Placed

ARMS = [*sorted(content.found("robots")), "ur5", "kr16_2", "so101"]


class Said:
    """A scene that keeps what is said to it."""

    def __init__(self) -> None:
        self.positions: dict[str, tuple[float, ...]] = {}
        self.quaternions: dict[str, tuple[float, ...]] = {}

    def _queue_scene_message(self, message: Message) -> None:
        if isinstance(message, SetPositionMessage):
            self.positions[message.name] = message.position
        elif isinstance(message, SetOrientationMessage):
            self.quaternions[message.name] = message.wxyz


@pytest.mark.parametrize("name", ARMS)
def test_every_mesh_stands_where_the_urdf_has_its_link(name: str) -> None:
    robot = load(name)
    drawn = shapes.load(robot)
    frames, said = [SimpleNamespace(name=shape.name) for shape in drawn], Said()
    oracle = yourdfpy.URDF(urdf_file.parsed(robot.urdf, robot.parameters).robot, load_meshes=False)
    q = np.random.default_rng(3).uniform(robot.lower, robot.upper)
    Placed(cast(Any, said), drawn, cast(Any, frames)).write(link_poses(robot.chain, q), gripper=0.0)
    oracle.update_cfg(dict(zip((joint.name for joint in robot.variables), q, strict=True)))
    for shape in drawn:
        T = oracle.get_transform(shape.name)
        np.testing.assert_allclose(said.positions[shape.name], T[:3, 3], atol=1e-9)
        np.testing.assert_allclose(rotation.to_matrix(np.array(said.quaternions[shape.name])), T[:3, :3], atol=1e-9)
        assert len(shape.edges) > 0 or not shape.glb
