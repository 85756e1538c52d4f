"""Screws: the product of exponentials, split into the subproblems of Paden and Kahan.

For the PUMA, the Movemaster and similar arms. With g = T T₀⁻¹, e^(ξ̂₁θ₁) … e^(ξ̂ₙθₙ) = g is applied to a point on an
axis: that joint does not move it, so its exponential drops out.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.families.elbow_wrist import ElbowWrist
from helicoide.ik.families.listed import Steps, theta
from helicoide.ik.families.paden_kahan import Axis, angles_to_distance, angles_to_point, axis_of, turn_to
from helicoide.ik.families.six_or_five import neither_kind, postures_by_kind
from helicoide.ik.families.turret import Turret
from helicoide.ik.postures.answer import Found
from helicoide.kinematics.forward import screw_transform
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="screws: Paden–Kahan subproblems", pt_BR="helicoides: subproblemas de Paden–Kahan")
SOURCE = "Campos 1998, s.37 (names the family); Paden 1986; Kahan 1983; Murray, Li and Sastry 1994, ch. 3"
RANK, OF_POINTS = 4, False
EQUATIONS = (
    r"g = T\,T_0^{-1} = e^{\hat\xi_1\theta_1} \cdots e^{\hat\xi_n\theta_n}",
    r"n = 6:\; \| e^{\hat\xi_3\theta_3} p_W - p_O \| = \| g\,p_W - p_O \| \;(3)",
    r"e^{\hat\xi_1\theta_1} e^{\hat\xi_2\theta_2} (e^{\hat\xi_3\theta_3} p_W) = g\,p_W \;(2)",
    r"e^{\hat\xi_4\theta_4} e^{\hat\xi_5\theta_5} p_6 = e^{-\hat\xi_3\theta_3} e^{-\hat\xi_2\theta_2}"
    r" e^{-\hat\xi_1\theta_1} g\,p_6 \;(2)",
    r"e^{\hat\xi_6\theta_6} p_5 = e^{-\hat\xi_5\theta_5} \cdots e^{-\hat\xi_1\theta_1} g\,p_5 \;(1)",
    r"n = 5:\; e^{\hat\xi_1\theta_1} \hat y = \pm M,\quad e^{\hat\xi_2\alpha} \hat s_5 = e^{-\hat\xi_1\theta_1} g\,"
    r"\hat s_5,\quad e^{\hat\xi_5\theta_5} \hat s_2 = e^{-\hat\xi_2\alpha} e^{-\hat\xi_1\theta_1} g\,\hat s_2 \;(1)",
    r"p = e^{-\hat\xi_1\theta_1} g\,e^{-\hat\xi_5\theta_5} p_4,\quad \| e^{\hat\xi_3\theta_3} p_4 - p_2 \| ="
    r" \| p - p_2 \| \;(3),\quad e^{\hat\xi_2\theta_2} (e^{\hat\xi_3\theta_3} p_4) = p \;(1)",
)


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return neither_kind(robot)


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m. q (n,), rad: a joint that the pose leaves free keeps its value.

    Raises HelicoideError if T_world_tool is not a pose or if the form does not apply.
    """
    return postures_by_kind(robot, T_world_tool, q, _six, _five)


def _six(robot: Robot, arm: ElbowWrist, T: Array, q: Array) -> Iterator[Steps]:
    """Subproblem 3 for the elbow, 2 for waist and shoulder, 2 and 1 for the wrist.

    Source: Murray, Li and Sastry 1994, §3.3.2.
    """
    axes, g, W = [axis_of(joint) for joint in robot.joints], T @ np.linalg.inv(robot.T_world_tool_0), arm.wrist
    s5, s6, there = axes[4].direction, axes[5].direction, _moved(g, W)
    waist, roll, far = Axis(axes[0].direction, arm.shoulder), Axis(axes[3].direction, W), _distance(there, arm.shoulder)
    for theta3 in angles_to_distance(axes[2], W, arm.shoulder, far, q[2]):
        bent = _moved(screw_transform(robot.joints[2], theta3), W)
        for theta1, theta2 in angles_to_point(waist, axes[1], bent, there, (q[0], q[1])):
            wrist = _undone(robot, (theta1, theta2, theta3), 0) @ g
            for theta4, theta5 in angles_to_point(roll, axes[4], W + s6, _moved(wrist, W + s6), (q[3], q[4])):
                last = _undone(robot, (theta4, theta5), 3) @ wrist
                theta6 = turn_to(axes[5], W + s5, _moved(last, W + s5), q[5])
                yield theta(theta1, theta2, theta3, theta4, theta5, theta6, δ=far)


def _five(robot: Robot, arm: Turret, T: Array, q: Array) -> Iterator[Steps]:
    """Subproblem 1 on directions for waist, hand and roll; 3 for the elbow; 1 for shoulder and bend."""
    axes, g, R = [axis_of(joint) for joint in robot.joints], T @ np.linalg.inv(robot.T_world_tool_0), arm.T_world_base
    s, y, M = robot.directions, R[:3, 1], R[:3, :3] @ arm.normal(arm.seen(T), float(q[0]))[0]
    p2, p4 = (p - ((p - R[:3, 3]) @ y) * y for p in robot.points[[1, 3]])
    for normal in (M, -M):
        theta1 = _turned(s[0], y, normal, q[0])
        plane = _undone(robot, (theta1,), 0) @ g
        alpha = _turned(s[1], s[4], plane[:3, :3] @ s[4], 0.0)
        theta5 = _turned(s[4], s[1], rotation.exponential(-alpha * s[1]) @ plane[:3, :3] @ s[1], q[4])
        hand = plane @ screw_transform(robot.joints[4], -theta5)
        p = _moved(hand, p4)
        far = _distance(p, p2)
        for theta3 in angles_to_distance(axes[2], p4, p2, far, q[2]):
            bent = _moved(screw_transform(robot.joints[2], theta3), p4)
            theta2 = turn_to(axes[1], bent, p, q[1])
            bend = _undone(robot, (theta2, theta3), 1) @ hand
            theta4 = _turned(s[3], s[4], bend[:3, :3] @ s[4], q[3])
            yield theta(theta1, theta2, theta3, theta4, theta5, α=alpha, δ=far)


def _turned(direction: Array, a: Array, b: Array, kept: float) -> float:
    """Subproblem 1 for directions (3,): θ, rad. kept: θ where a lies on the axis."""
    return turn_to(Axis(direction, np.zeros(3)), a, b, kept)


def _moved(T: Array, p: Array) -> Array:
    return np.asarray(T[:3, :3] @ p + T[:3, 3])


def _distance(p: Array, q: Array) -> float:
    return float(np.linalg.norm(p - q))


def _undone(robot: Robot, angles: tuple[float, ...], first: int) -> Array:
    """e^(−ξ̂ₖθₖ) … e^(−ξ̂ᵢθᵢ), (4, 4), for consecutive joints from index i = first."""
    T = np.eye(4)
    for joint, angle in zip(robot.joints[first:], angles, strict=False):
        T = screw_transform(joint, -angle) @ T
    return T
