"""Drawing of an arm without meshes: links as lines, revolute joints as cylinders, prismatic joints as bars."""

from __future__ import annotations

import numpy as np
import trimesh

from helicoide.kinematics.chain import Joint
from helicoide.kinematics.robot import Robot

# Radii and lengths as shares of the reach.
LINE, CYLINDER, BAR = 0.01, (0.03, 0.1), (0.025, 0.16)
OF_LINES, OF_JOINTS = (150, 155, 165, 255), (235, 130, 60, 255)


def skeleton_meshes(robot: Robot) -> list[tuple[str, trimesh.Scene]]:
    """The base and each moving link: its URDF name, and its drawing in the frame of the arm's link."""
    names = [robot.base_link, *(joint.link for joint in robot.joints)]
    origins = np.array([np.zeros(3), *robot.points])
    ends = np.array([*robot.points, robot.T_world_tool_0[:3, 3]]) - origins
    found = []
    for name, end, joint in zip(names, ends, [None, *robot.joints], strict=True):
        scene = trimesh.Scene()
        if np.linalg.norm(end) > LINE * robot.reach:
            line = trimesh.creation.cylinder(LINE * robot.reach, segment=[np.zeros(3), end], sections=12)
            scene.add_geometry(_painted(line, OF_LINES))
        if joint is not None:
            scene.add_geometry(_painted(_solid(joint, robot.reach), OF_JOINTS))
        found.append((name, scene))
    return found


def _solid(joint: Joint, size: float) -> trimesh.Trimesh:
    radius, height = size * np.array(BAR if joint.is_prismatic else CYLINDER)
    ends = np.outer([-height / 2, height / 2], joint.direction)
    solid: trimesh.Trimesh = trimesh.creation.cylinder(radius, segment=ends, sections=4 if joint.is_prismatic else 24)
    return solid


def _painted(mesh: trimesh.Trimesh, colour: tuple[int, int, int, int]) -> trimesh.Trimesh:
    """The mesh in one colour, flat shaded at its edges."""
    flat = mesh.smooth_shaded
    colours = np.tile(np.array(colour, dtype=np.uint8), (len(flat.vertices), 1))
    return trimesh.Trimesh(flat.vertices, flat.faces, vertex_colors=colours, process=False)
