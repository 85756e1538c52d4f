"""PlaCo; the planes are half spaces of its joints, all rows at once; its gain is a target part of the way."""

from __future__ import annotations

from tempfile import NamedTemporaryFile
from xml.etree import ElementTree

import numpy as np
import placo
from turns import Numbers, Turn, following, take_turns

# What its vectors hold for the base, which is masked.
BASE_POSITIONS, BASE_SPEEDS = 7, 6


def urdf_with_points(urdf: str, links: list[int], points: Numbers) -> str:
    """The chain with a fixed link on every point."""
    root = ElementTree.fromstring(urdf)
    for j, (link, point) in enumerate(zip(links, points, strict=True)):
        ElementTree.SubElement(root, "link", name=f"point{j}")
        joint = ElementTree.SubElement(root, "joint", name=f"to_point{j}", type="fixed")
        ElementTree.SubElement(joint, "parent", link=f"link{link - 1}" if link else "base")
        ElementTree.SubElement(joint, "child", link=f"point{j}")
        ElementTree.SubElement(joint, "origin", xyz=" ".join(map(repr, point)), rpy="0 0 0")
    return ElementTree.tostring(root, encoding="unicode")


def read(urdf: str) -> placo.RobotWrapper:
    with NamedTemporaryFile("w", suffix=".urdf") as file:
        file.write(urdf)
        file.flush()
        return placo.RobotWrapper(file.name, placo.Flags.ignore_collisions)


def solver_of(robot: placo.RobotWrapper, damping: float, dt: float) -> placo.KinematicsSolver:
    solver = placo.KinematicsSolver(robot)
    solver.mask_fbase(True)
    solver.dt = dt
    solver.enable_joint_limits(True)
    solver.enable_velocity_limits(True)
    solver.add_regularization_task(damping)
    return solver


class Dampers:
    """n·J Δq ≥ −decay · l of every point and plane, as A (q + Δq) ≤ b."""

    def __init__(self, robot: placo.RobotWrapper, solver: placo.KinematicsSolver, given: dict) -> None:
        self.robot, self.decay = robot, given["decay"]
        self.normals, self.offsets = np.array(given["normals"]), np.array(given["offsets"])
        self.frames = sorted(name for name in robot.frame_names() if name.startswith("point"))
        self.A = np.zeros((len(self.frames) * len(self.offsets), len(robot.state.q)))
        self.rows = solver.add_joint_space_half_spaces_constraint(self.A, np.ones(len(self.A)))
        self.rows.configure("planes", "hard", 1.0)

    def update(self) -> None:
        robot, world = self.robot, "local_world_aligned"
        J = np.array([robot.frame_jacobian(frame, world)[:3, BASE_SPEEDS:] for frame in self.frames])
        points = np.array([robot.get_T_world_frame(frame)[:3, 3] for frame in self.frames])
        near = points @ self.normals.T - self.offsets
        self.A[:, BASE_POSITIONS:] = -(self.normals @ J).reshape(near.size, -1)
        self.rows.A = self.A
        self.rows.b = self.decay * np.maximum(near, 0.0).ravel() + self.A @ robot.state.q


def prepared(urdf: str, start: Numbers, targets: Numbers, links: list[int], points: Numbers, **given) -> Turn:
    robot = read(urdf_with_points(urdf, links, points))
    solver = solver_of(robot, given["damping"], given["dt"])
    desired, gain = [np.array(T) for T in targets], given["gain"]
    task = solver.add_frame_task("tool", desired[0])
    task.configure("tool", "soft", 1.0, 1.0)
    dampers = Dampers(robot, solver, given) if given["normals"] else None

    def begin() -> None:
        for i, value in enumerate(start):
            robot.set_joint(f"to_link{i}", value)
        robot.update_kinematics()

    def step(k: int) -> np.ndarray:
        task.T_world_frame = placo.interpolate_frames(robot.get_T_world_frame("tool"), desired[k], gain)
        if dampers is not None:
            dampers.update()
        solver.solve(True)
        robot.update_kinematics()
        return robot.state.q[BASE_POSITIONS:].copy()

    return following(begin, step)


take_turns(prepared)
