"""The arms, aims and runs that the tests of secondary objectives share."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from itertools import takewhile
from typing import Any

import numpy as np
from tests.kinematics.arms import arm

from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem, methods, objectives
from helicoide.ik.clik import Aim, Aiming, Moment, tool_aim
from helicoide.ik.converge import Tolerance, by_method, converged, still
from helicoide.ik.secondary import Chosen
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses
from helicoide.trajectory import Ellipse

Path = Callable[[float], tuple[Array, Array]]
PINV, DAMPED = methods.named("pseudoinverse"), methods.named("damped")
PLAIN = PINV.Options()


def problem(name: str, scale: float | None = None, **limits: tuple[float, float]) -> Problem:
    """An arm without planes; limits: of joints by name, where they are not its own, rad."""
    robot = arm(name)
    lower, upper = robot.lower.copy(), robot.upper.copy()
    for i, joint in enumerate(robot.variables):
        lower[i], upper[i] = limits.get(joint.name, (lower[i], upper[i]))
    return Problem(robot, Limits(lower, upper, robot.speed), planes_of(()), scale=scale)


def chosen(name: str, **options: Any) -> Chosen:
    """One objective with some of its options."""
    objective = objectives.named(name)
    return [(objective, replace(objective.Options(), **options))]


def at(x: float, y: float, z: float = 0.0) -> Array:
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


def position(problem: Problem, path: Path, rows: int = 3) -> Aiming:
    """The tool's position along a path p(t), v(t), m and m/s; two rows for an arm in a plane."""

    def aim(q: Array, t: float) -> Aim:
        point, velocity = path(t)
        ahead = np.array([*velocity, 0, 0, 0])
        whole = tool_aim(problem, link_poses(problem.robot.chain, q), at(*point), False, ahead)
        return Aim(whole.J[:rows], whole.error[:rows], whole.ahead[:rows])

    return aim


def standing(x: float, y: float, z: float = 0.0) -> Path:
    return lambda t: (np.array([x, y, z]), np.zeros(3))


def along(ellipse: Ellipse) -> Path:
    return lambda t: (ellipse.point(t), ellipse.velocity(t))


def start_at(problem: Problem, aiming: Aiming, q: Array) -> Array:
    """The posture of an aim to rounding, by Newton's steps from q."""
    newton = by_method(problem, PINV, PINV.Options(), 1.0)
    report = converged(problem, newton, still(aiming, 0.0), q, Tolerance(1e-12, 1e-12))
    assert report.reached
    return report.q


@dataclass(frozen=True, eq=False)
class Run:
    """A run step by step: t (s,), q (s, n), error of position in ℓ (s,), fastest joint (s,), and its last moment."""

    t: Array
    q: Array
    error: Array
    fastest: Array
    last: Moment

    def since(self, t0: float) -> Run:
        s = self.t >= t0 - 1e-9
        return Run(self.t[s], self.q[s], self.error[s], self.fastest[s], self.last)


def ran(moments: Iterable[Moment], seconds: float) -> Run:
    kept = list(takewhile(lambda moment: moment.t < seconds, moments))
    return Run(
        np.array([moment.t for moment in kept]),
        np.array([moment.q for moment in kept]),
        np.array([np.linalg.norm(moment.aim.error[:3]) for moment in kept]),
        np.array([np.abs(moment.solution.rates).max() for moment in kept]),
        kept[-1],
    )


def tool(problem: Problem, q: Array) -> Array:
    return np.asarray((link_poses(problem.robot.chain, q)[-1] @ problem.robot.T_link_tool)[:3, 3])
