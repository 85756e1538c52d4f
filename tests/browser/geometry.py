"""Where the nodes of a scene are on the page: points on what they draw, projected to pixels."""

from __future__ import annotations

from typing import Any

import numpy as np
import viser
from playwright.sync_api import Page
from scipy.ndimage import distance_transform_edt

from helicoide.arrays import Array
from helicoide.geometry import rotation

PROJECT_ALL = """(points) => {
  const m = window.__viserMutable, v = m.camera.position.clone(), r = m.canvas.getBoundingClientRect();
  return points.map(p => {
    v.set(p[0], p[1], p[2]); m.nodeRefFromName[''].localToWorld(v); v.project(m.camera);
    return [r.left + (v.x + 1) / 2 * r.width, r.top + (1 - v.y) / 2 * r.height];
  });
}"""
SHOWN = """(names) => names.map(name => {
  let node = window.__viserMutable.nodeRefFromName[name];
  if (!node) return false;
  for (; node; node = node.parent) if (!node.visible) return false;
  return true;
})"""
BETWEEN = np.linspace(0, 1, 61)[:, None]
CHARACTER, LINE = 9.0, 34.0  # px: a character of a name and its height, with a margin


def sphere() -> Array:
    """Points on a unit sphere, spread evenly."""
    k = np.arange(600) + 0.5
    z, turn = 1 - 2 * k / 600, np.pi * (1 + 5**0.5) * k
    return np.column_stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z])


def segments(ends: Array) -> Array:
    """Points along segments (k, 2, 3)."""
    return np.asarray((ends[:, :1] + BETWEEN * (ends[:, 1:] - ends[:, :1])).reshape(-1, 3))


def local_points(handle: Any) -> Array:
    """Points on what a node draws, (k, 3), m, in its own frame."""
    match handle:
        case viser.LineSegmentsHandle() | viser.ArrowsHandle():
            return segments(np.asarray(handle.points, dtype=float))
        case viser.IcosphereHandle():
            return sphere() * handle.radius * np.asarray(handle.scale)
        case viser.BatchedAxesHandle():
            axes = rotation.to_matrix(np.asarray(handle.batched_wxyzs, dtype=float)).transpose(0, 2, 1)
            centres = np.asarray(handle.batched_positions, dtype=float)[:, None]
            ends = np.broadcast_to(centres, axes.shape) + handle.axes_length * axes
            return segments(np.stack([np.broadcast_to(centres, axes.shape), ends], axis=2).reshape(-1, 2, 3))
        case viser.FrameHandle():
            return segments(handle.axes_length * np.array([[np.zeros(3), axis] for axis in np.eye(3)]))[
                : handle.show_axes * 10**6
            ]
        case viser.BatchedMeshHandle():
            R = rotation.to_matrix(np.asarray(handle.batched_wxyzs, dtype=float))
            scales = np.asarray(handle.batched_scales, dtype=float)[:, None]
            corners = np.asarray(handle.vertices, dtype=float) * scales
            lines = np.stack([corners * [1, 1, share] for share in np.linspace(-1, 1, 41)], axis=1)
            turned = lines @ R.transpose(0, 2, 1)[:, None]
            return (turned + np.asarray(handle.batched_positions, dtype=float)[:, None, None]).reshape(-1, 3)
        case viser.PointCloudHandle():
            return np.asarray(handle.points, dtype=float)
        case viser.TransformControlsHandle():
            return np.concatenate([sphere() * handle.scale * share for share in np.linspace(0, 1.3, 14)])
        case _:
            return np.zeros((0, 3))


def world_points(scene: viser.SceneApi, name: str) -> Array:
    """Points on what a node draws, (k, 3), m, world: through the poses of the nodes above it."""
    nodes = scene._handle_from_node_name
    points, parts = local_points(nodes[name]), name.split("/")
    for end in range(len(parts), 1, -1):
        node = nodes.get("/".join(parts[:end]))
        if node is not None:
            points = points @ rotation.to_matrix(np.asarray(node.wxyz)).T + np.asarray(node.position)
    return points


def visible(scene: viser.SceneApi, name: str) -> bool:
    """Whether a node and all nodes above it are visible."""
    nodes, parts = scene._handle_from_node_name, name.split("/")
    above = (nodes.get("/".join(parts[:end])) for end in range(2, len(parts) + 1))
    return all(node is None or node.visible for node in above)


def seen_as_sent(page: Page, scene: viser.SceneApi) -> bool:
    """Whether the page shows and hides every node as it was asked to; names have no node of their own on the page."""
    names = [name for name, node in scene._handle_from_node_name.items() if not isinstance(node, viser.LabelHandle)]
    return list(page.evaluate(SHOWN, names)) == [visible(scene, name) for name in names]


def covered(page: Page, scene: viser.SceneApi, root: str, margin: float, shape: tuple[int, int]) -> Array:
    """The pixels (height, width) at most `margin` from what the visible nodes of a layer draw, and behind its names."""
    marked = np.zeros(shape, dtype=bool)
    boxes = np.zeros(shape, dtype=bool)
    box = page.locator("canvas").first.bounding_box()
    assert box is not None
    names = [name for name in scene._handle_from_node_name if name == root or name.startswith(f"{root}/")]
    for name in names:
        handle: Any = scene._handle_from_node_name[name]
        if not visible(scene, name):
            continue
        if isinstance(handle, viser.LabelHandle):
            ((x, y),) = page.evaluate(PROJECT_ALL, [[float(value) for value in handle.position]])
            x, y, half = x - box["x"], y - box["y"], 12 + CHARACTER * len(handle.text) / 2
            boxes[max(0, int(y - LINE)) : max(0, int(y + LINE / 2)), max(0, int(x - half)) : max(0, int(x + half))] = 1
            continue
        points = world_points(scene, name)
        if len(points):
            found = np.asarray(page.evaluate(PROJECT_ALL, points.tolist())) - [box["x"], box["y"]]
            x, y = found.round().astype(int).T
            inside = (x >= 0) & (x < shape[1]) & (y >= 0) & (y < shape[0])
            marked[y[inside], x[inside]] = True
    return np.asarray((distance_transform_edt(~marked) <= margin) | boxes)
