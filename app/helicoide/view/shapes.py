"""A robot's meshes, read from its URDF once: for each URDF link its shape, its edges, and its pose on the arm."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import trimesh
import yourdfpy

from helicoide.arrays import Array
from helicoide.kinematics import urdf_file
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_xml import urdf_error
from helicoide.text import Text
from helicoide.view import skeleton

SHARP = np.radians(50.0)
SHORTEST_EDGE = 0.015
FEWEST_EDGES = 8
NO_GRIPPER = Text(
    en="it has no joint {name!r} for the gripper; its moving joints are: {known}",
    pt_BR="ele não tem junta {name!r} para a garra; as juntas móveis são: {known}",
)


@dataclass(frozen=True, eq=False)
class Shape:
    """One URDF link: its GLB, its sharp edges (e, 2, 3) m, the arm's link that carries it, and its pose on that link.

    T_link_shape (4, 4), m, with the gripper closed; `slide` (3,), m: displacement when the gripper opens fully.
    """

    name: str
    glb: bytes
    edges: Array
    link: int
    T_link_shape: Array
    slide: Array


@lru_cache(maxsize=32)
def load_shapes(robot: Robot) -> list[Shape]:
    """The shapes of a robot. If fewer than half of its moving links have meshes, the others get lines and cylinders.

    Raises HelicoideError if the URDF is broken.
    """
    closed = _urdf(robot)
    opened = closed
    if robot.gripper:
        opened = _urdf(robot)
        if robot.gripper.joint not in opened.actuated_joint_names:
            known = ", ".join(opened.actuated_joint_names)
            raise urdf_error(robot.urdf, NO_GRIPPER.format(name=robot.gripper.joint, known=known))
        upper = float(opened.joint_map[robot.gripper.joint].limit.upper)
        opened.update_cfg({robot.gripper.joint: upper})
    drawn = {link.name: _visuals(closed, link.name) for link in closed.robot.links if link.visuals}
    shapes = [_shape(robot, closed, opened, name, scene) for name, scene in drawn.items() if not scene.is_empty]
    seen = {shape.link for shape in shapes}
    moving = len(seen - {0})
    return shapes if 2 * moving >= len(robot.joints) else [*shapes, *_lines(robot, seen)]


def _lines(robot: Robot, seen: Set[int]) -> list[Shape]:
    """Lines and cylinders for the links without a mesh. seen: the links that have one."""
    shortest = SHORTEST_EDGE * robot.reach
    return [
        Shape(name, _glb(scene), _edges(scene, shortest), i, np.eye(4), np.zeros(3))
        for i, (name, scene) in enumerate(skeleton.skeleton_meshes(robot))
        if not scene.is_empty and i not in seen
    ]


def _glb(scene: trimesh.Scene) -> bytes:
    """The scene as GLB; opaque textures as JPEG, which is written 25 times as fast as PNG."""
    materials = [getattr(mesh.visual, "material", None) for mesh in scene.geometry.values()]
    for texture in (getattr(material, name, None) for material in materials for name in ("image", "baseColorTexture")):
        if texture is not None and texture.mode == "RGB":
            texture.format = "JPEG"
    return bytes(scene.export(file_type="glb", include_normals=True))


def _urdf(robot: Robot) -> yourdfpy.URDF:
    """The URDF with its meshes. Mimic rules of the arm's joints are removed, so that all joints are at zero."""
    urdf = urdf_file.read_urdf(robot.urdf, robot.parameters).robot
    of_arm = {joint.name for joint in robot.joints}
    for joint in urdf.joints:
        if joint.name in of_arm:
            joint.mimic = None
    return urdf_file.with_meshes(robot.urdf, urdf)


def _carrier(robot: Robot, urdf: yourdfpy.URDF, link: str) -> int:
    """The number of the arm's link that carries a URDF link; 0 for the base."""
    numbers = {joint.link: i + 1 for i, joint in enumerate(robot.joints)}
    parents = {joint.child: joint.parent for joint in urdf.robot.joints}
    while link not in numbers and link in parents:
        link = parents[link]
    return numbers.get(link, 0)


def _shape(robot: Robot, closed: yourdfpy.URDF, opened: yourdfpy.URDF, name: str, scene: trimesh.Scene) -> Shape:
    link = _carrier(robot, closed, name)
    T_link_shape = np.array(closed.get_transform(name, robot.base_link))
    slide = opened.get_transform(name, robot.base_link)[:3, 3] - T_link_shape[:3, 3]
    if link > 0:
        T_link_shape[:3, 3] -= robot.points[link - 1]
    return Shape(name, _glb(scene), _edges(scene, SHORTEST_EDGE * robot.reach), link, T_link_shape, slide)


def _visuals(urdf: yourdfpy.URDF, name: str) -> trimesh.Scene:
    """The meshes of one URDF link, in its frame, without those that have no surface."""
    tree, scene = urdf.scene.graph, trimesh.Scene()
    for node in tree.nodes_geometry:
        if tree.transforms.parents[node] == name:
            mesh = urdf.scene.geometry[tree[node][1]]
            if isinstance(mesh, trimesh.Trimesh) and mesh.area > 0:
                scene.add_geometry(_plain(mesh), transform=urdf.get_transform(node, name))
    return scene


def _plain(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """A box, cylinder or sphere as an editable mesh with sharp edges; any other mesh unchanged."""
    return mesh.smooth_shaded if isinstance(mesh, trimesh.primitives.Primitive) else mesh


def _bare(scene: trimesh.Scene) -> trimesh.Trimesh:
    """The meshes of a scene as one mesh, without colours and textures, which are slow to join."""
    bare = trimesh.Scene()
    for T, name in (scene.graph[node] for node in scene.graph.nodes_geometry):
        mesh = scene.geometry[name]
        bare.add_geometry(trimesh.Trimesh(mesh.vertices, mesh.faces, process=False), transform=T)
    whole: trimesh.Trimesh = bare.to_mesh()
    return whole


def _edges(scene: trimesh.Scene, shortest: float) -> Array:
    """The sharp edges (e, 2, 3), m, longer than `shortest`; for a smooth shape the sharpest and longest edges."""
    mesh = _bare(scene)
    mesh.merge_vertices()
    edges, angles = mesh.vertices[mesh.face_adjacency_edges], mesh.face_adjacency_angles
    lengths = np.linalg.norm(edges[:, 0] - edges[:, 1], axis=1)
    sharp = (angles > SHARP) & (lengths > shortest)
    if sharp.sum() >= FEWEST_EDGES:
        return np.asarray(edges[sharp])
    return np.asarray(edges[np.argsort(-angles * lengths)[: 4 * FEWEST_EDGES]])
