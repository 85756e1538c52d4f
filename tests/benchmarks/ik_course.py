"""A closed loop around a circle: our step in it, the planes that cut into it, and what a peer must know of both."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from tests.benchmarks.children.turns import following
from tests.benchmarks.ik_arm import points_on_links, standard_rows, urdf_with_limits
from tests.benchmarks.ik_turns import Turn

from helicoide.ik.guard.guarded import guarded_tick, indices
from helicoide.ik.guard.rows import DAMPER_GAIN, Arm, LimitArrays, PlaneArrays
from helicoide.ik.task import rotation_vector
from helicoide.kernels import kernel
from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import carried_points, link_poses
from helicoide.kinematics.robot import Robot

DT, LAP, LAPS, RADIUS = 0.01, 500, 3, 0.1
STEPS = LAP * LAPS
GAIN, DAMPING = 0.25, 1e-6
NO_PAIRS, NOTHING, NOWHERE = indices([], 0, 4), frozen([]), frozen(np.zeros(3))
NO_ENTRY = (0, NOWHERE, NOWHERE, NOWHERE)


@kernel
def follow(
    arm: Arm,
    T_link_tool: Array,
    q: Array,
    poses: Array,
    T_world_target: Array,
    cost: tuple[float, Array, Array],
    limits: LimitArrays,
    planes: PlaneArrays,
    dt: float,
) -> tuple[Array, Array]:
    """The posture and its link poses after one step towards a pose: v is a share of what is missing, world frame."""
    gain, weights, damping = cost
    chain = arm[0]
    last, T, v = poses[-1], np.empty((3, 4)), np.empty(6)
    for a in range(3):
        for b in range(4):
            T[a, b] = last[a, 0] * T_link_tool[0, b] + last[a, 1] * T_link_tool[1, b] + last[a, 2] * T_link_tool[2, b]
        T[a, 3] += last[a, 3]
    turned = rotation_vector(T_world_target, T)
    for a in range(3):
        v[a] = gain * (T_world_target[a, 3] - T[a, 3])
        v[3 + a] = gain * turned[a]
    J = jacobian.geometric(poses, chain, jacobian.joint_axes(poses, chain), T[:, 3], chain.shape[0])
    guard = (arm, limits, planes, (arm[1].shape[0], NO_PAIRS, NOTHING), NO_ENTRY, DAMPER_GAIN)
    task = (J, v, weights, damping)
    q_after, poses_after, _, _ = guarded_tick(guard, q, np.zeros(q.size), poses, task, np.empty(0, dtype=np.int64), dt)
    return q_after, poses_after


@dataclass(frozen=True, eq=False)
class Course:
    """A robot, where it starts, a circle around its tool, and the planes, none or three, that cut into the circle."""

    robot: Robot
    q_start: Array
    is_confined: bool

    def __str__(self) -> str:
        return f"{self.robot.name}, one step, {'three planes' if self.is_confined else 'no planes'}"

    @cached_property
    def arm(self) -> Arm:
        robot = self.robot
        return robot.chain.copy(), robot.guarded_points.copy(), robot.guarded_joints.copy()

    @cached_property
    def targets(self) -> Array:
        """T_world_target of each step, (steps, 4, 4), m."""
        T = link_poses(self.arm[0], self.q_start)[-1] @ self.robot.T_link_tool
        angles = 2 * np.pi * np.arange(STEPS) / LAP
        targets = np.repeat(T[None], STEPS, axis=0)
        targets[:, 0, 3] += RADIUS * np.sin(angles)
        targets[:, 1, 3] -= RADIUS * np.cos(angles)
        return targets

    @cached_property
    def planes(self) -> PlaneArrays:
        """Normals (k, 3) into the allowed side, offsets (k,), m, and the distance to be kept, m."""
        if not self.is_confined:
            return np.empty((0, 3)), np.empty(0), 0.0
        points = self.points(self.q_start)
        x, y, _ = points[-1] + 0.5 * RADIUS
        normals = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
        return normals, np.array([points[:, 2].min() - 0.1, -x, -y]), 0.0

    def points(self, q: Array) -> Array:
        return np.asarray(carried_points(link_poses(self.arm[0], q), *self.arm[1:]))

    def given(self) -> dict[str, object]:
        """What a peer must know."""
        robot = self.robot
        numbers = {
            "lower": robot.lower,
            "upper": robot.upper,
            "speed": robot.speed,
            "start": self.q_start,
            "targets": self.targets,
            "normals": self.planes[0],
            "offsets": self.planes[1],
            "points": np.array(points_on_links(robot)),
            "links": robot.guarded_joints,
        }
        known = {name: array.tolist() for name, array in numbers.items()}
        law = {"gain": GAIN, "damping": DAMPING, "decay": DAMPER_GAIN * DT, "dt": DT}
        return {"urdf": urdf_with_limits(robot), "dh": standard_rows(robot), **known, **law}

    def turn(self) -> Turn:
        """Our closed loop."""
        robot, arm, targets, planes = self.robot, self.arm, list(self.targets), self.planes
        T_link_tool, unlimited = robot.T_link_tool.copy(), np.full(len(robot.variables), np.inf)
        limits = robot.lower.copy(), robot.upper.copy(), robot.speed.copy(), unlimited
        cost = GAIN, np.ones(6), np.full(len(robot.variables), DAMPING)
        q = poses = np.empty(0)

        def start() -> None:
            nonlocal q, poses
            q = self.q_start.copy()
            poses = link_poses(arm[0], q)

        def step(k: int) -> Array:
            nonlocal q, poses
            q, poses = follow(arm, T_link_tool, q, poses, targets[k], cost, limits, planes, DT)
            return q

        return following(start, step)
