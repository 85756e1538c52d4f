"""Dual quaternions: the motor of each joint is c + s L, c = cos θ/2, s = sin θ/2, and each step gives the ratio c : s.

An object X moved by a joint, (c + s L) X (c + s L)*, is quadratic in c and s. The condition that the joint moves X to
Y, (c + s L) X = Y (c + s L), is linear. For the PUMA, the Movemaster and similar arms.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import atan2, hypot, pi, sqrt

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.geometry.incidence import point_line_distance
from helicoide.ik.families.elbow_wrist import ElbowWrist
from helicoide.ik.families.listed import Steps, theta
from helicoide.ik.families.six_or_five import neither_kind, postures_by_kind
from helicoide.ik.families.turret import Turret
from helicoide.ik.postures.answer import Found
from helicoide.kinematics.forward import joint_motor
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="dual quaternions: half angles", pt_BR="quatérnios duais: meios-ângulos")
SOURCE = "Campos 1998, s.37 (names the family); Cerbaro 2022, §5.1 (motors of the joints); the steps are ours"
RANK, OF_POINTS = 5, False
EQUATIONS = (
    r"m_i = c_i + s_i L_i,\quad c_i = \cos\tfrac{\theta_i}{2},\; s_i = \sin\tfrac{\theta_i}{2},\quad"
    r" m_1 \cdots m_n = Q\,Q_0^{*}",
    r"W \in m_1 \pi m_1^{*}:\; A c_1^2 + B c_1 s_1 + C s_1^2 = 0,\quad"
    r" \tfrac{s_1}{c_1} = \frac{-B \pm \sqrt{B^2 - 4AC}}{2C}",
    r"n\cdot(m_3 W_0 m_3^{*} - p_3) = \frac{\delta^2 - \rho^2 - a^2}{2a}:\; A c_3^2 + B c_3 s_3 + C s_3^2 = 0",
    r"m_2\,(m_3 W_0 m_3^{*}) = (m_1^{*} W m_1)\,m_2:\; c_2 (X - Y) + s_2 (L_2 X - Y L_2) = 0",
    r"n = 6:\; (m_1 m_2 m_3)^{*} Q\,Q_0^{*} = c_5 \cos\sigma + c_5 \sin\sigma\,\hat s_4 + s_5 \cos\tau\,\hat s_5"
    r" + s_5 \sin\tau\,\hat s_4 \hat s_5,\quad \sigma, \tau = \tfrac{\theta_4 \pm \theta_6}{2}",
    r"n = 5:\; m_1^{*} Q\,Q_0^{*} = (c_\alpha + s_\alpha \hat s_2)(c_5 + s_5 \hat s_5)",
)
NONE, ROUNDING, FREE = 1e-20, 1e-12, 1e-10


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return neither_kind(robot)


def find(robot: Robot, T_world_tool: Array, q: Array) -> Found:
    """Every posture for a tool pose (4, 4), m. q (n,), rad: a joint that the pose leaves free keeps its value.

    Raises HelicoideError if T_world_tool is not a pose or if the form does not apply.
    """
    return postures_by_kind(robot, T_world_tool, q, _six, _five)


def halves(L: Array, measure: Callable[[Array], float], kept: float) -> list[float]:
    """The angles θ, rad, none, one or two, for which measure(c + s L) = A c² + B c s + C s² = 0.

    A and C are the values at c = 1 and at s = 1; B follows from the value at c = s. Returns [kept] if A, B and C are
    zero. Args: L (16,), a unit line; measure: an affine function of the object that the motor moves.
    """
    A, C = measure(CL031.blade("1")), measure(L)
    B = 2 * measure(sqrt(0.5) * (CL031.blade("1") + L)) - A - C
    size = A * A + B * B + C * C
    if size < NONE:
        return [kept]
    radicand = B * B - 4 * A * C
    if radicand < -ROUNDING * size:
        return []
    roots = (1, -1) if radicand > ROUNDING * size else (0,)
    halves = [-B + sign * sqrt(max(radicand, 0.0)) for sign in roots]
    return [2 * (atan2(2 * A, x) if abs(A) > abs(C) else atan2(x, 2 * C)) for x in halves]


def turning(L: Array, X: Array, Y: Array, kept: float) -> float:
    """θ, rad, of the motor m = c + s L with m X = Y m: c a + s b = 0 for a = X − Y, b = L X − Y L, all (16,).

    By least squares, tan θ = −2 a·b / (b·b − a·a). Returns kept if a = b = 0, where every θ satisfies the equation.
    """
    a, b = X - Y, CL031.product(L, X) - CL031.product(Y, L)
    if a @ a + b @ b < NONE:
        return kept
    return atan2(-2 * (a @ b), b @ b - a @ a)


def _six(robot: Robot, arm: ElbowWrist, T: Array, q: Array) -> Iterator[Steps]:
    """Waist and elbow from quadratic equations, shoulder from a linear one, wrist from σ and τ of `_wrist`."""
    lines, Q, s = _lines(robot), _displacement(robot, T), robot.directions
    W_0, plane = rigid.point(arm.wrist), rigid.plane(s[1], s[1] @ arm.wrist)
    W = rigid.move(Q, W_0)
    for theta1 in halves(lines[0], lambda m: float(rigid.point_plane_distance(rigid.move(m, plane), W)), q[0]):
        m1 = joint_motor(robot.joints[0], theta1)
        for theta2, theta3, level in _elbow(robot, lines, W_0, rigid.move(CL031.conjugate(m1), W), q):
            arm_motor = _product(m1, *(joint_motor(robot.joints[i], t) for i, t in ((1, theta2), (2, theta3))))
            for theta4, theta5, theta6 in _wrist(s, CL031.product(CL031.conjugate(arm_motor), Q), q):
                yield theta(theta1, theta2, theta3, theta4, theta5, theta6, k=level)


def _five(robot: Robot, arm: Turret, T: Array, q: Array) -> Iterator[Steps]:
    """Waist, shoulder and bend from linear equations, elbow from a quadratic one, roll from the rotor."""
    lines, Q, R, s = _lines(robot), _displacement(robot, T), arm.T_world_base, robot.directions
    y, M = R[:3, 1], R[:3, :3] @ arm.normal(arm.seen(T), float(q[0]))[0]
    W_0 = rigid.point(robot.points[3] - ((robot.points[3] - R[:3, 3]) @ y) * y)
    hand_0 = _direction(s[4])
    for normal in (M, -M):
        theta1 = turning(_direction(s[0]), _direction(y), _direction(normal), q[0])
        plane = CL031.product(CL031.conjugate(joint_motor(robot.joints[0], theta1)), Q)
        w, across, roll, both = _parts(plane, s[1], s[4])
        theta5 = 2 * (atan2(roll, w) if hypot(roll, w) > hypot(across, both) else atan2(both, across))
        hand = CL031.product(plane, CL031.conjugate(joint_motor(robot.joints[4], theta5)))
        for theta2, theta3, level in _elbow(robot, lines, W_0, rigid.move(hand, W_0), q):
            links = _product(*(joint_motor(robot.joints[i], t) for i, t in ((1, theta2), (2, theta3))))
            bend = CL031.product(CL031.conjugate(links), hand)
            theta4 = turning(_direction(s[3]), hand_0, _direction(rotation.rotate(_rotor(bend), s[4])), q[3])
            yield theta(theta1, theta2, theta3, theta4, theta5, k=level)


def _elbow(robot: Robot, lines: list[Array], W_0: Array, W: Array, q: Array) -> Iterator[tuple[float, float, float]]:
    """θ₂, θ₃, rad, for which m₂ m₃ moves W₀ to W, and k = (δ² − ρ² − a²)/2a, m. Axes 2 and 3 are parallel.

    a, ρ, δ, m: from axis 2 to axis 3, from axis 3 to W₀, from axis 2 to W.
    """
    s2, between = robot.directions[1], robot.points[2] - robot.points[1]
    between = between - (between @ s2) * s2
    a = float(np.linalg.norm(between))
    rho, delta = float(point_line_distance(lines[2], W_0)), float(point_line_distance(lines[1], W))
    level = (delta**2 - rho**2 - a**2) / (2 * a)
    goal = rigid.plane(between / a, between @ robot.points[2] / a + level)
    for theta3 in halves(lines[2], lambda m: float(rigid.point_plane_distance(goal, rigid.move(m, W_0))), q[2]):
        bent = rigid.move(joint_motor(robot.joints[2], theta3), W_0)
        yield turning(lines[1], bent, W, q[1]), theta3, level


def _wrist(s: Array, M: Array, q: Array) -> Iterator[tuple[float, float, float]]:
    """θ₄, θ₅, θ₆, rad, of the rotation M about the wrist, with σ = (θ₄ + θ₆)/2 and τ = (θ₄ − θ₆)/2.

    φ is the angle about axis 5 from axis 4 to axis 6 at q = 0; it is subtracted from θ₅.
    """
    phi = atan2(s[4] @ np.cross(s[3], s[5]), s[3] @ s[5])
    w, x, y, z = _parts(CL031.product(M, rigid.rotor(s[4], phi)), s[3], s[4])
    bend, sigma, tau = 2 * atan2(hypot(y, z), hypot(w, x)), atan2(x, w), atan2(z, y)
    if hypot(y, z) < FREE:
        tau = float(q[3]) - sigma
    elif hypot(w, x) < FREE:
        sigma = float(q[3]) - tau
    yield sigma + tau, bend - phi, sigma - tau
    if min(hypot(y, z), hypot(w, x)) >= FREE:
        yield sigma + tau + pi, -bend - phi, sigma - tau - pi


def _parts(M: Array, i: Array, j: Array) -> tuple[float, float, float, float]:
    """The components along 1, i, j and i j of the rotor of a motor (16,), for orthogonal unit vectors i and j (3,)."""
    w, *v = _rotor(M)
    return float(w), float(i @ v), float(j @ v), float(np.cross(i, j) @ v)


def _rotor(M: Array) -> Array:
    return rigid.dual_quaternion(M)[:4]


def _direction(v: Array) -> Array:
    """The line (16,) through the origin in a direction (3,)."""
    return rigid.line(v, np.zeros(3))


def _lines(robot: Robot) -> list[Array]:
    return [rigid.line(joint.direction, joint.point) for joint in robot.joints]


def _displacement(robot: Robot, T: Array) -> Array:
    """The motor Q Q₀* (16,) from the tool pose at q = 0 to the goal T (4, 4), m."""
    return rigid.motor_from_pose(T @ np.linalg.inv(robot.T_world_tool_0))


def _product(*motors: Array) -> Array:
    M, *others = motors
    for other in others:
        M = CL031.product(M, other)
    return M
