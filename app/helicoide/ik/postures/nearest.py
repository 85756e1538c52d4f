"""The posture whose tool comes nearest to a goal, by least squares: for arms without a closed form."""

from __future__ import annotations

import numpy as np

from helicoide.geometry import rotation
from helicoide.kinematics import jacobian
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot

# Postures that the search starts from besides two; steps of each; the least gain of a step, as a part of what is left.
STARTS, STEPS, GAIN = 10, 200, 1e-13


def nearest(robot: Robot, T_world_goal: Array, q: Array, with_orientation: bool) -> Array:
    """The best of several minima of ‖Δp‖²/ℓ² + ‖Δθ‖², ℓ the reach, or of ‖Δp‖² alone: (n,), rad or m.

    Slides keep their stroke, angles are free. The search starts at q (n,), at `ready` and at postures drawn once and
    for all; what it finds is reached, but another minimum could lie nearer still.
    Args: T_world_goal (4, 4), m. Source: Levenberg 1944, Marquardt 1963.
    """
    lower, upper = robot.lower.clip(-np.pi), robot.upper.clip(max=np.pi)
    drawn = np.random.default_rng(0).uniform(lower, upper, (STARTS, q.size))
    best, left = q, np.inf
    for start in [q, robot.poses["ready"], *drawn]:
        found, missing = _descended(robot, T_world_goal, start, with_orientation)
        if missing < left:
            best, left = found, missing
        if left < GAIN**2:
            break
    return frozen(best)


def _descended(robot: Robot, T_world_goal: Array, q: Array, with_orientation: bool) -> tuple[Array, float]:
    """The minimum below q, and its value, by damped steps (JᵀJ + λI) Δq = Jᵀe."""
    slides = np.array([joint.slides for joint in robot.variables])
    units, damping = np.where(slides, robot.reach, 1.0), 1e-2
    J, e = _linear(robot, T_world_goal, q, with_orientation)
    for _ in range(STEPS):
        J = J * units
        there = q + units * np.linalg.solve(J.T @ J + damping * np.eye(q.size), J.T @ e)
        there = np.where(slides, there.clip(robot.lower, robot.upper), there)
        J_there, e_there = _linear(robot, T_world_goal, there, with_orientation)
        gain = e @ e - e_there @ e_there
        if abs(gain) <= GAIN * (e @ e):
            break
        if gain > 0:
            q, J, e, damping = there, J_there, e_there, max(damping / 4, 1e-12)
        else:
            J, damping = J / units, damping * 8
    return q, float(e @ e)


def _linear(robot: Robot, T_world_goal: Array, q: Array, with_orientation: bool) -> tuple[Array, Array]:
    """Jacobian (r, n) and error (r,), lengths over the reach."""
    chain, poses = robot.chain, link_poses(robot.chain, q)
    T = poses[-1] @ robot.T_link_tool
    J = jacobian.geometric(poses, chain, jacobian.joint_axes(poses, chain), T[:3, 3].copy(), len(chain))
    J[:3] /= robot.reach
    error = (T_world_goal[:3, 3] - T[:3, 3]) / robot.reach
    if not with_orientation:
        return J[:3], error
    return J, np.concatenate([error, rotation.logarithm(T_world_goal[:3, :3] @ T[:3, :3].T)])
