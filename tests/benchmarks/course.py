"""A closed loop around a circle: our step in it, the planes that cut into it, and what a peer must know of both."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from tests.benchmarks.children.turns import following
from tests.benchmarks.ik_arm import points_on_links, standard_rows, urdf_with_limits
from tests.benchmarks.ik_turns import Turn

from helicoide.arrays import Array, frozen
from helicoide.confinement import Planes, Zones
from helicoide.ik import Limits, Problem
from helicoide.ik.guard.rows import DAMPER_GAIN
from helicoide.ik.guard.work import work_for
from helicoide.ik.packing import packed
from helicoide.ik.step import STILL, step
from helicoide.ik.task import GAIN
from helicoide.kinematics.forward import link_poses, points_in_world
from helicoide.kinematics.robot import Robot

DT, LAP, LAPS, RADIUS = 0.01, 500, 3, 0.1
STEPS = LAP * LAPS
SHARE, DAMPING = 1.0 - np.exp(-GAIN * DT), 1e-6


@dataclass(frozen=True, eq=False)
class Course:
    """A robot, where it starts, a circle around its tool, and the planes, none or three, that cut into the circle."""

    robot: Robot
    q_start: Array
    is_confined: bool

    def __str__(self) -> str:
        return f"{self.robot.name}, one step, {'three planes' if self.is_confined else 'no planes'}"

    @cached_property
    def arm(self) -> Array:
        """The arm, packed: 1 m counts as much as 1 rad, and no bodies are kept apart, as with the peers."""
        robot, reach = replace(self.robot, self_collision=()), self.robot.reach
        normals, offsets, _ = self.planes
        planes = Planes(frozen(normals), frozen(normals * offsets[:, None]))
        problem = Problem(robot, Limits(robot.lower, robot.upper, robot.speed), planes, Zones(critical=0.0))
        return packed(problem, DAMPING / reach**2, 1.0 / reach)

    @cached_property
    def targets(self) -> Array:
        """T_world_target of each step, (steps, 4, 4), m."""
        T = link_poses(self.robot.chain, self.q_start)[-1] @ self.robot.T_link_tool
        angles = 2 * np.pi * np.arange(STEPS) / LAP
        targets = np.repeat(T[None], STEPS, axis=0)
        targets[:, 0, 3] += RADIUS * np.sin(angles)
        targets[:, 1, 3] -= RADIUS * np.cos(angles)
        return targets

    @cached_property
    def planes(self) -> tuple[Array, Array, float]:
        """Normals (k, 3) into the allowed side, offsets (k,), m, and the distance to be kept, m."""
        if not self.is_confined:
            return np.empty((0, 3)), np.empty(0), 0.0
        points = self.points(self.q_start)
        x, y, _ = points[-1] + 0.5 * RADIUS
        normals = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
        return normals, np.array([points[:, 2].min() - 0.1, -x, -y]), 0.0

    def points(self, q: Array) -> Array:
        robot = self.robot
        return np.asarray(points_in_world(link_poses(robot.chain, q), robot.monitored_points, robot.monitored_links))

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
            "links": robot.monitored_links,
        }
        known = {name: array.tolist() for name, array in numbers.items()}
        law = {"gain": float(SHARE), "damping": DAMPING, "decay": DAMPER_GAIN * DT, "dt": DT}
        return {"urdf": urdf_with_limits(robot), "dh": standard_rows(robot), **known, **law}

    def turn(self) -> Turn:
        """Our closed loop."""
        arm, targets, work = self.arm, list(self.targets), work_for(self.arm)
        memory, q = work.memory, self.q_start.copy()

        def start() -> None:
            q[:], work.rates[:] = self.q_start, 0.0

        def once(k: int) -> Array:
            step(arm, q, targets[k], STILL, DT, memory)
            return q.copy()

        return following(start, once)
