"""Poses of nodes of the scene."""

from __future__ import annotations

import viser
from viser._messages import SetOrientationMessage, SetPositionMessage

from helicoide.arrays import Array
from helicoide.geometry import rotation


def place_node(node: viser.SceneNodeHandle, T_parent_node: Array) -> None:
    """Move a node to its pose (4, 4), m, unless it has that pose already.

    This sends viser's messages directly: setting the attributes of its handles takes ten times as long.
    """
    place_point(node, T_parent_node[:3, 3])
    impl = node._impl
    turn = rotation.from_matrix(T_parent_node[:3, :3])
    w, i, j, k = turn.tolist()
    if [w, i, j, k] != impl.wxyz.tolist():
        impl.wxyz[:] = turn
        impl.api._queue_scene_message(SetOrientationMessage(impl.name, (w, i, j, k)))


def place_point(node: viser.SceneNodeHandle, position: Array) -> None:
    """Move the origin of a node to a position (3,), m, unless it is there already; messages as in `place_node`."""
    impl = node._impl
    x, y, z = position.tolist()
    if [x, y, z] != impl.position.tolist():
        impl.position[:] = x, y, z
        impl.api._queue_scene_message(SetPositionMessage(impl.name, (x, y, z)))


def send_pose(node: viser.SceneNodeHandle, position: Array, wxyz: Array) -> None:
    """Give a node a position (3,), m, and an orientation wxyz, also if it has them already on this side."""
    impl = node._impl
    impl.position[:], impl.wxyz[:] = position, wxyz
    x, y, z = position.tolist()
    w, i, j, k = wxyz.tolist()
    impl.api._queue_scene_message(SetPositionMessage(impl.name, (x, y, z)))
    impl.api._queue_scene_message(SetOrientationMessage(impl.name, (w, i, j, k)))
