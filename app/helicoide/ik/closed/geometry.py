"""Geometry: plane triangles for the arm, seen from above and from the side, then the wrist. For PUMA-like arms."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, hypot, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.families import elbow
from helicoide.ik.families.elbow_wrist import ELSE, ElbowWrist, elbow_wrist
from helicoide.ik.families.listed import Steps, distinct_branches, theta
from helicoide.ik.postures.answer import Found
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="geometry: two triangles and a wrist", pt_BR="geometria: dois triângulos e um punho")
SOURCE = "Campos 1998, s.24, s.37 and s.50–54 (plane triangles); the cut of this arm is ours"
RANK, OF_POINTS = 2, False
EQUATIONS = (
    r"u = \pm\sqrt{x^2 + y^2 - d^2},\quad \theta_1 = \operatorname{Atan2}(y, x) - \operatorname{Atan2}(d, u)",
    r"\beta = \operatorname{Atan2}(-z, u),\quad \cos\psi = \frac{u^2 + z^2 + l_1^2 - l_2^2}{2 l_1 \sqrt{u^2 + z^2}},"
    r"\quad \vartheta_2 = \beta \pm \psi",
    r"\cos\vartheta_3 = \frac{u^2 + z^2 - l_1^2 - l_2^2}{2 l_1 l_2}",
    r"\hat n = \pm \frac{\hat s_4 \times \hat s_6}{|\hat s_4 \times \hat s_6|}:\;"
    r" \theta_4 = \angle_{\hat s_4}(\hat s_5, \hat n),\quad \theta_5 = \angle_{\hat n}(\hat s_6(0), \hat s_6),"
    r"\quad \theta_6 = \angle_{\hat s_6}(R^T \hat n, \hat s_5)",
)
# Square of a side, m², that counts as zero: the wrist is as near to the waist as possible. Sine of a stretched wrist.
TOUCHES, STRETCHED = 1e-12, 1e-10


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return ELSE if elbow_wrist(robot) is None else None


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m. q (6,), rad: a joint that the pose leaves free keeps its value.

    Raises HelicoideError if T_world_tool is not a pose or if the form does not apply.
    """
    if (arm := elbow_wrist(robot)) is None:
        raise HelicoideError(ELSE)
    return distinct_branches(robot, T_world_tool, q, lambda T, now: _postures(robot, arm, T, now))


def _postures(robot: Robot, arm: ElbowWrist, T: Array, q: Array) -> Iterator[Steps]:
    """From above, a right triangle with side d gives θ₁. From the side, one with sides l₁ and l₂ gives θ₂ and θ₃."""
    g, base, s = T @ np.linalg.inv(robot.T_world_tool_0), arm.T_world_shoulder, robot.directions
    (e_x, _, e_z), (w_x, d, w_z) = (_seen(base, p) for p in (robot.points[2], arm.wrist))
    x, y, z = _seen(base, g[:3, :3] @ arm.wrist + g[:3, 3])
    links = elbow.Annulus(hypot(e_x, e_z), hypot(w_x - e_x, w_z - e_z))
    upper, fore = atan2(-e_z, e_x), atan2(e_z - w_z, w_x - e_x)
    square = x * x + y * y - d * d
    if square < -TOUCHES:
        return
    side = sqrt(max(square, 0.0))
    for u in (side, -side) if square > TOUCHES else (0.0,):
        theta1 = atan2(y, x) - atan2(d, u) if hypot(x, y) > 0 else float(q[0])
        for sign in links.elbows(hypot(u, z)):
            two = elbow.geometric(u, -z, links, sign, upper + float(q[1]))
            theta2 = two.theta1 - upper
            theta3 = float(s[1] @ s[2]) * (two.theta2 - (fore - upper))
            R = _turn(theta1, s[0]) @ _turn(theta2, s[1]) @ _turn(theta3, s[2])
            for theta4, theta5, theta6 in _wrist(s, R.T @ g[:3, :3], q):
                yield theta(theta1, theta2, theta3, theta4, theta5, theta6, u=u, β=two.beta, ψ=two.psi)


def _wrist(s: Array, R: Array, q: Array) -> Iterator[tuple[float, float, float]]:
    """θ₄, θ₅, θ₆, rad, of the rotation R (3, 3): axis 5 is normal to axis 4 and to the required direction of axis 6."""
    normal = np.cross(s[3], R @ s[5])
    if (sine := float(np.linalg.norm(normal))) < STRETCHED:
        normal, sine = _turn(float(q[3]), s[3]) @ s[4], 0.0
    for n in (normal, -normal) if sine else (normal,):
        theta4 = _angle(s[3], s[4], n)
        theta5 = _angle(n, _turn(theta4, s[3]) @ s[5], R @ s[5])
        yield theta4, theta5, _angle(s[5], R.T @ n, s[4])


def _angle(axis: Array, a: Array, b: Array) -> float:
    """The angle from a to b about an axis, all (3,), rad."""
    return atan2(axis @ np.cross(a, b) / np.linalg.norm(axis), a @ b)


def _seen(base: Array, p: Array) -> tuple[float, float, float]:
    x, y, z = base[:3, :3].T @ (p - base[:3, 3])
    return float(x), float(y), float(z)


def _turn(angle: float, axis: Array) -> Array:
    return rotation.exponential(angle * axis)
