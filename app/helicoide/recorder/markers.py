"""Planes, obstacles and point clouds as ROS messages that Foxglove draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from rosbags.typesys.stores import ros2_humble as ros

from helicoide.arrays import Array, frozen
from helicoide.confinement import Obstacles, Planes, pane_axes
from helicoide.recorder.ros import header_message, pose_message

Marker = ros.visualization_msgs__msg__Marker
Colour = tuple[float, float, float, float]
PANE: Colour = (0.26, 0.52, 0.75, 0.15)
BODY: Colour = (0.6, 0.6, 0.6, 0.8)
THIN = 1e-3  # m: the thickness of a pane
FLOAT32, BYTES = ros.sensor_msgs__msg__PointField.FLOAT32, 4
HERE = frozen(np.eye(4))


@dataclass(frozen=True)
class MarkerShape:
    """The kind of a marker, its extent along its own axes, m, and its colour."""

    kind: int
    scale: tuple[float, float, float]
    colour: Colour


NO_SHAPE = MarkerShape(Marker.CUBE, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))


def plane_markers(ns: int, planes: Planes) -> ros.visualization_msgs__msg__MarkerArray:
    """A box for each plane: z of its pose is the inward normal, its position the centre of the pane."""
    markers = [_marker(ns, 0)]
    for normal, centre, pane in zip(planes.normals, planes.centres, planes.panes, strict=True):
        shape = MarkerShape(Marker.CUBE, (*pane.size, THIN), PANE)
        markers.append(_marker(ns, len(markers), pane.name, shape, _at(centre, pane_axes(normal))))
    return _array(markers)


def obstacle_markers(ns: int, obstacles: Obstacles) -> ros.visualization_msgs__msg__MarkerArray:
    """Each capsule as a cylinder with a sphere at both ends; a sphere alone where the ends coincide."""
    markers = [_marker(ns, 0)]
    for number, ((start, end), radius) in enumerate(zip(obstacles.ends, obstacles.radii, strict=True)):
        length, wide = float(np.linalg.norm(end - start)), 2 * float(radius)
        ball = MarkerShape(Marker.SPHERE, (wide, wide, wide), BODY)
        for centre in (start, end) if length else (start,):
            markers.append(_marker(ns, len(markers), str(number), ball, _at(centre)))
        if length:
            rod = MarkerShape(Marker.CYLINDER, (wide, wide, length), BODY)
            between = _at((start + end) / 2, pane_axes(end - start))
            markers.append(_marker(ns, len(markers), str(number), rod, between))
    return _array(markers)


def cloud_message(ns: int, points: Array) -> ros.sensor_msgs__msg__PointCloud2:
    """Points (k, 3), m, in single precision, as cameras give them."""
    data = np.ascontiguousarray(points, dtype="<f4").view(np.uint8).reshape(-1)
    fields = [ros.sensor_msgs__msg__PointField(axis, k * BYTES, FLOAT32, 1) for k, axis in enumerate("xyz")]
    count, step = len(points), 3 * BYTES
    return ros.sensor_msgs__msg__PointCloud2(
        header_message(ns), 1, count, fields, False, step, count * step, data, True
    )


def _array(markers: Sequence[Any]) -> ros.visualization_msgs__msg__MarkerArray:
    """The markers as one message; its type names the markers of an older distribution, which have the same fields."""
    return ros.visualization_msgs__msg__MarkerArray(list(markers))


def _at(position: Array, R: Array | None = None) -> Array:
    T = np.eye(4)
    T[:3, 3] = position
    if R is not None:
        T[:3, :3] = R
    return T


def _marker(ns: int, number: int, name: str = "", shape: MarkerShape | None = None, T: Array = HERE) -> Marker:
    """A marker to draw; without a shape, the one that removes all markers drawn before."""
    drawn = shape or NO_SHAPE
    return Marker(
        header=header_message(ns),
        ns=name,
        id=0 if shape is None else number,
        type=drawn.kind,
        action=Marker.DELETEALL if shape is None else Marker.ADD,
        pose=pose_message(T),
        scale=ros.geometry_msgs__msg__Vector3(*drawn.scale),
        color=ros.std_msgs__msg__ColorRGBA(*drawn.colour),
        lifetime=ros.builtin_interfaces__msg__Duration(0, 0),
        frame_locked=False,
        points=[],
        colors=[],
        texture_resource="",
        texture=ros.sensor_msgs__msg__CompressedImage(header_message(ns), "", np.zeros(0, np.uint8)),
        uv_coordinates=[],
        text="",
        mesh_resource="",
        mesh_file=ros.visualization_msgs__msg__MeshFile("", np.zeros(0, np.uint8)),
        mesh_use_embedded_materials=False,
    )
