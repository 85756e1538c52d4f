"""The two arms of Cerbaro 2022 and their tasks, in mm, so that λ and K have the values of the source."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from helicoide.arrays import Array
from helicoide.confinement import planes_of
from helicoide.ik import Limits, Problem, objectives
from helicoide.ik.clik import TaskError, TaskFunction, tool_task_error
from helicoide.ik.converge import StoppingCriterion, Tolerance, converged, frozen_reference, solver_of
from helicoide.ik.method import ConfiguredMethod
from helicoide.ik.methods import configured_method
from helicoide.ik.secondary import Chosen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot
from helicoide.trajectory import Ellipse

MM = 1e-3
WAIST = np.radians(100)

PointPath = Callable[[float], tuple[Array, Array]]


def orca(limits: float = 1.0) -> Problem:
    """The ORCA without planes; its joint limits are assumed, times a factor, as the source only draws them."""
    robot = load_robot("orca")
    return Problem(robot, Limits(limits * robot.lower, limits * robot.upper, robot.speed), planes_of(()), scale=MM)


def movemaster() -> Problem:
    """The Movemaster without planes and with the limits of table 3, ±100° at the waist."""
    robot = load_robot("movemaster")
    lower, upper = robot.lower.copy(), robot.upper.copy()
    lower[0], upper[0] = -WAIST, WAIST
    return Problem(robot, Limits(lower, upper, robot.speed), planes_of(()), scale=MM)


def damped_inverse(damping: float) -> ConfiguredMethod:
    """Damped least squares with λ in mm/rad, or the pseudoinverse where that is 0."""
    return configured_method("damped", damping=damping) if damping > 0 else configured_method("pseudoinverse")


def limit_distance() -> Chosen:
    """The objective that keeps joints away from their limits (Cerbaro 2022, eqs. 12 and 14)."""
    objective = objectives.named("limit_distance")
    return [(objective, objective.Options())]


def fixed_point(x: float, y: float, z: float = 0.0) -> PointPath:
    """A fixed point, m, with zero velocity."""
    return lambda t: (np.array([x, y, z]), np.zeros(3))


def point_along(ellipse: Ellipse, velocity: Callable[[float], Array] | None = None) -> PointPath:
    """A point that moves along an ellipse; velocity: the ẋ_d of the control law, m/s, by default that of the point."""
    return lambda t: (ellipse.point(t), (velocity or ellipse.velocity)(t))


def position_task(problem: Problem, path: PointPath, rows: int = 3) -> TaskFunction:
    """The task of tool position along a path; rows: 3, or 2 for a planar arm."""
    T = np.eye(4)

    def aim(q: Array, t: float) -> TaskError:
        T[:3, 3], velocity = path(t)
        ahead = np.append(velocity, np.zeros(3))
        whole = tool_task_error(problem, link_poses(problem.robot.chain, q), T, False, ahead)
        return TaskError(whole.J[:rows], whole.error[:rows], whole.feedforward[:rows])

    return aim


def heading_task(problem: Problem, path: PointPath, phi: float = 0.0) -> TaskFunction:
    """Position and heading φ = q₁ + q₂ + q₃, rad, of a planar arm; the third row is zero."""
    plain = position_task(problem, path)

    def aim(q: Array, t: float) -> TaskError:
        three = plain(q, t)
        return TaskError(
            np.vstack([three.J, [1, 1, 1]]), np.append(three.error, phi - q.sum()), np.append(three.feedforward, 0)
        )

    return aim


def pitch_and_roll_task(problem: Problem, path: PointPath, pitch: float, roll: float = 0.0) -> TaskFunction:
    """Position, pitch q₂ + q₃ + q₄ and roll q₅ of the Movemaster, rad; the source leaves the rows of J open."""
    return joint_sum_task(problem, path, np.array([[0, 1, 1, 1, 0], [0, 0, 0, 0, 1]]), np.array([pitch, roll]))


def joint_sum_task(problem: Problem, path: PointPath, sums: Array, wanted: Array) -> TaskFunction:
    """Position and joint sums: `sums` (k, n) times q equals `wanted` (k,), rad."""
    plain = position_task(problem, path)

    def aim(q: Array, t: float) -> TaskError:
        three = plain(q, t)
        error = np.append(three.error, wanted - sums @ q)
        return TaskError(np.vstack([three.J, sums]), error, np.append(three.feedforward, np.zeros(len(sums))))

    return aim


def solved_posture(problem: Problem, aiming: TaskFunction, q: Array) -> Array:
    """The joint values that solve a task to rounding, by Newton's method from q (n,), rad."""
    newton = solver_of(problem, damped_inverse(0.0), 1.0, StoppingCriterion(Tolerance(1e-12, 1e-12)))
    report = converged(newton, frozen_reference(aiming, 0.0), q)
    assert report.reached
    return report.q


def tool_position(problem: Problem, q: Array) -> Array:
    """The tool position (3,), m, at q (n,), rad."""
    return np.asarray((link_poses(problem.robot.chain, q)[-1] @ problem.robot.T_link_tool)[:3, 3])
