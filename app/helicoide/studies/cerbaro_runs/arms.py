"""The two arms of Cerbaro 2022 and their tasks, in mm, so that λ and K have the values of the source."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem, methods, objectives
from helicoide.ik.clik import Aim, Aiming, tool_aim
from helicoide.ik.converge import Tolerance, by_method, converged, still
from helicoide.ik.method import Method
from helicoide.ik.secondary import Chosen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load
from helicoide.trajectory import Ellipse

MM = 1e-3
WAIST = np.radians(100)

Path = Callable[[float], tuple[Array, Array]]


def orca(limits: float = 1.0) -> Problem:
    """The ORCA without planes; its joint limits are assumed, times a factor, as the source only draws them."""
    robot = load("orca")
    return Problem(robot, Limits(limits * robot.lower, limits * robot.upper, robot.speed), planes_of(()), scale=MM)


def movemaster() -> Problem:
    """The Movemaster without planes and with the limits of table 3, ±100° at the waist."""
    robot = load("movemaster")
    lower, upper = robot.lower.copy(), robot.upper.copy()
    lower[0], upper[0] = -WAIST, WAIST
    return Problem(robot, Limits(lower, upper, robot.speed), planes_of(()), scale=MM)


def inverse(damping: float) -> tuple[Method, Any]:
    """Damped least squares with λ in mm/rad, or the pseudoinverse where that is 0, each with its options."""
    method = methods.named("damped" if damping > 0 else "pseudoinverse")
    return method, method.Options(damping) if damping > 0 else method.Options()


def limit_distance() -> Chosen:
    """The objective that keeps joints away from their limits (Cerbaro 2022, eqs. 12 and 14)."""
    objective = objectives.named("limit_distance")
    return [(objective, objective.Options())]


def standing(x: float, y: float, z: float = 0.0) -> Path:
    """A fixed point, m, with zero velocity."""
    return lambda t: (np.array([x, y, z]), np.zeros(3))


def along(ellipse: Ellipse, velocity: Callable[[float], Array] | None = None) -> Path:
    """A point that moves along an ellipse; velocity: the ẋ_d of the control law, m/s, by default that of the point."""
    return lambda t: (ellipse.point(t), (velocity or ellipse.velocity)(t))


def position(problem: Problem, path: Path, rows: int = 3) -> Aiming:
    """The task of tool position along a path; rows: 3, or 2 for a planar arm."""
    T = np.eye(4)

    def aim(q: Array, t: float) -> Aim:
        T[:3, 3], velocity = path(t)
        ahead = np.append(velocity, np.zeros(3))
        whole = tool_aim(problem, link_poses(problem.robot.chain, q), T, False, ahead)
        return Aim(whole.J[:rows], whole.error[:rows], whole.ahead[:rows])

    return aim


def with_heading(problem: Problem, path: Path, phi: float = 0.0) -> Aiming:
    """Position and heading φ = q₁ + q₂ + q₃, rad, of a planar arm; the third row is zero."""
    plain = position(problem, path)

    def aim(q: Array, t: float) -> Aim:
        three = plain(q, t)
        return Aim(np.vstack([three.J, [1, 1, 1]]), np.append(three.error, phi - q.sum()), np.append(three.ahead, 0))

    return aim


def with_pitch_and_roll(problem: Problem, path: Path, pitch: float, roll: float = 0.0) -> Aiming:
    """Position, pitch q₂ + q₃ + q₄ and roll q₅ of the Movemaster, rad; the source leaves the rows of J open."""
    return with_sums(problem, path, np.array([[0, 1, 1, 1, 0], [0, 0, 0, 0, 1]]), np.array([pitch, roll]))


def with_sums(problem: Problem, path: Path, sums: Array, wanted: Array) -> Aiming:
    """Position and joint sums: `sums` (k, n) times q equals `wanted` (k,), rad."""
    plain = position(problem, path)

    def aim(q: Array, t: float) -> Aim:
        three = plain(q, t)
        error = np.append(three.error, wanted - sums @ q)
        return Aim(np.vstack([three.J, sums]), error, np.append(three.ahead, np.zeros(len(sums))))

    return aim


def start_at(problem: Problem, aiming: Aiming, q: Array) -> Array:
    """The joint values that solve a task to rounding, by Newton's method from q (n,), rad."""
    newton = by_method(problem, *inverse(0.0), 1.0)
    report = converged(problem, newton, still(aiming, 0.0), q, Tolerance(1e-12, 1e-12))
    assert report.reached
    return report.q


def tool(problem: Problem, q: Array) -> Array:
    """The tool position (3,), m, at q (n,), rad."""
    return np.asarray((link_poses(problem.robot.chain, q)[-1] @ problem.robot.T_link_tool)[:3, 3])
