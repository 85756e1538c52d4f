"""Six turning joints with a spherical wrist, last or first: every posture, by Pieper's polynomial of degree 4."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import atan2, cos, hypot, sin, sqrt

import numpy as np
from numpy.typing import NDArray

from helicoide.geometry import rotation
from helicoide.ik.families.pieper_arm import NONE, Arm, arm_of, beyond
from helicoide.ik.postures.branch import Answer, Branch, branch_of, check_pose, sentences, tool_at, wrap
from helicoide.kinematics.chain import Array
from helicoide.kinematics.differential import geometric
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

Complex = NDArray[np.complex128]

TITLE = Text(en="spherical wrist: Pieper's solution", pt_BR="punho esférico: solução de Pieper")
SOURCE = "Pieper 1968; Campos 1998, s.26, after Craig, Introduction to Robotics"
RANK, OF_POINTS = 1, False
EQUATIONS = (
    r"f_1 = a_3 c_3 + d_4 s\alpha_3 s_3 + a_2",
    r"f_2 = a_3 c\alpha_2 s_3 - d_4 s\alpha_3 c\alpha_2 c_3 - d_4 s\alpha_2 c\alpha_3 - d_3 s\alpha_2",
    r"f_3 = a_3 s\alpha_2 s_3 - d_4 s\alpha_3 s\alpha_2 c_3 + d_4 c\alpha_2 c\alpha_3 + d_3 c\alpha_2",
    r"k_1 = f_1, \quad k_2 = -f_2, \quad k_3 = f_1^2 + f_2^2 + f_3^2 + a_1^2 + d_2^2 + 2 d_2 f_3, \quad"
    r"k_4 = (f_3 + d_2) c\alpha_1",
    r"r = p_x^2 + p_y^2 + p_z^2 = 2 a_1 (k_1 c_2 + k_2 s_2) + k_3, \quad"
    r"z = p_z = s\alpha_1 (k_1 s_2 - k_2 c_2) + k_4",
    r"a_1 = 0: r = k_3; \quad s\alpha_1 = 0: z = k_4; \quad"
    r"\text{else } \frac{(r - k_3)^2}{4 a_1^2} + \frac{(z - k_4)^2}{s^2\alpha_1} = k_1^2 + k_2^2",
    r"g_1 = c_2 f_1 - s_2 f_2 + a_1, \quad g_2 = c\alpha_1 (s_2 f_1 + c_2 f_2) - s\alpha_1 (f_3 + d_2), \quad"
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) - \operatorname{Atan2}(g_2, g_1)",
    r"c_5 = \frac{c\alpha_4 c\alpha_5 - m_{33}}{s\alpha_4 s\alpha_5}, \quad M = R_x(\alpha_3)^T ({}^0_3 R)^T R",
    r"R_z(\theta_4) R_x(\alpha_4) R_z(\theta_5) R_x(\alpha_5) R_z(\theta_6) = M",
)

# Sines, and lengths in m, that leave an angle free.
FREE = 1e-10
# How far from the unit circle a root may lie, and what rounding takes from a radicand, of its largest value.
CIRCLE, ROUNDING = 1e-3, 1e-12
# Postures closer than this in every joint are one, rad; what one may miss, m and rad, and what it may without polish.
MERGED, ACCEPTED, EXACT = 1e-5, 1e-9, 1e-12


@dataclass(frozen=True, eq=False)
class Posture:
    """One solution θ (6,), rad: the posture of the arm by its first three angles, the wrist flipped or not.

    free: the joints that are free in it; values: what the equations gave on the way, by symbol.
    """

    theta: Array
    arm: tuple[float, ...]
    flipped: bool
    free: tuple[int, ...]
    values: Mapping[str, float]


def applies(robot: Robot) -> Text | None:
    """To six turning joints whose last or first three axes meet at a point, and whose others place it in space."""
    arm = arm_of(robot)
    return arm if isinstance(arm, Text) else None


def solve(robot: Robot, T_world_tool: Array, q: Array) -> Answer:
    """Every posture for a tool pose (4, 4), m, polished by Newton's method and verified by forward kinematics.

    q (6,), rad: kept where a joint is free. Raises HelicoideError for what is no pose and for another kind of arm.
    """
    arm, goal, q = arm_of(robot), check_pose(T_world_tool), robot.check_joints(q)
    if isinstance(arm, Text):
        raise HelicoideError(arm)
    T = arm.wrist(goal)
    found = list[tuple[Branch, Posture]]()
    for posture in postures(arm, T, arm.turned(q) + arm.shifts):
        there = polished(robot, goal, arm.turned(posture.theta - arm.shifts))
        branch = branch_of(robot, _name(found, posture), there, goal)
        if max(branch.missed, branch.turned) < ACCEPTED and not any(_is_same(branch, other) for other, _ in found):
            found.append((branch, posture))
    short = 0.0 if found else beyond(arm, T[:3, 3])
    free = tuple(sorted({5 - joint if arm.backwards else joint for _, posture in found for joint in posture.free}))
    return Answer(
        branches=tuple(branch for branch, _ in found),
        T_world_goal=goal,
        words=_words(len(found), short, free),
        short=short,
        free=free,
        values=tuple(posture.values for _, posture in found),
    )


def postures(arm: Arm, T: Array, kept: Array) -> Iterator[Posture]:
    """Every θ for a pose of the wrist (4, 4), m; kept (6,), rad: θ that is kept where it is free."""
    p, R = T[:3, 3], T[:3, :3]
    r, z = float(p @ p), float(p[2])
    for theta3 in third_angles(arm, r, z, kept[2]):
        f1, f2, f3 = map(float, arm.f @ [1, cos(theta3), sin(theta3)])
        for theta2 in second_angles(arm, theta3, r, z, kept[1]):
            ca1, sa1, c2, s2 = cos(arm.alpha[0]), sin(arm.alpha[0]), cos(theta2), sin(theta2)
            g1 = c2 * f1 - s2 * f2 + arm.a[0]
            g2 = ca1 * (s2 * f1 + c2 * f2) - sa1 * (f3 + arm.d[1])
            over = hypot(g1, g2) < FREE
            theta1 = float(kept[0]) if over else atan2(p[1], p[0]) - atan2(g2, g1)
            first = (theta1, theta2, theta3)
            free = (0,) * over + (1,) * (hypot(f1, f2) < FREE)
            values = {"r": r, "z": z, "f_1": f1, "f_2": f2, "f_3": f3, "g_1": g1, "g_2": g2}
            M = _after_arm(arm, first).T @ R
            for flipped, (last, undetermined) in enumerate(wrist_angles(arm, M, float(kept[3]))):
                theta = np.array([*first, *last])
                named = {f"θ_{i + 1}": float(angle) for i, angle in enumerate(theta)}
                yield Posture(theta, first, bool(flipped), free + (3, 5) * undetermined, {**values, **named})


def third_angles(arm: Arm, r: float, z: float, kept: float) -> list[float]:
    """θ₃ from r = k₃ where a₁ = 0, z = k₄ where sα₁ = 0, else the quartic, as roots w = e^(iθ₃) on the unit circle.

    tan(θ₃/2) would have a root at infinity where θ₃ = π; w has none.
    """
    (k3, k4), a1, sa1 = arm.k, arm.a[0], sin(arm.alpha[0])
    if a1 < NONE:
        return linear(k3[1], k3[2], r - k3[0], kept)
    if abs(sa1) < NONE:
        return linear(k4[1], k4[2], z - k4[0], kept)
    ways = (sa1 * ([r, 0, 0] - k3), 2 * a1 * ([z, 0, 0] - k4), 2 * a1 * sa1 * arm.f[2])
    n = 4 * (a1 * sa1) ** 2 * arm.size
    quartic = _squared(ways[0]) + _squared(ways[1]) + _squared(ways[2]) - _powers(n[0], n[1], n[2], 0, 0)
    return [float(np.angle(w)) for w in np.roots(quartic) if abs(abs(w) - 1) < CIRCLE]


def _squared(way: Array) -> Complex:
    """The square of l₀ + l₁ cos θ + l₂ sin θ, as `_powers`."""
    l0, l1, l2 = way
    return _powers(l0**2 + (l1**2 + l2**2) / 2, 2 * l0 * l1, 2 * l0 * l2, (l1**2 - l2**2) / 2, l1 * l2)


def _powers(l0: float, c1: float, s1: float, c2: float, s2: float) -> Complex:
    """w² (l₀ + c₁ cos θ + s₁ sin θ + c₂ cos 2θ + s₂ sin 2θ) as a polynomial of w = e^(iθ), complex (5,)."""
    return np.array([c2 - 1j * s2, c1 - 1j * s1, 2 * l0, c1 + 1j * s1, c2 + 1j * s2], dtype=np.complex128) / 2


def second_angles(arm: Arm, theta3: float, r: float, z: float, kept: float) -> list[float]:
    """θ₂ from k₁c₂ + k₂s₂ = (r − k₃)/2a₁ and k₁s₂ − k₂c₂ = (z − k₄)/sα₁: from both, or from the one that is there."""
    a1, sa1 = arm.a[0], sin(arm.alpha[0])
    k1, minus_k2, k3, k4 = (float(row @ [1, cos(theta3), sin(theta3)]) for row in (*arm.f[:2], *arm.k))
    if a1 < NONE:
        return linear(minus_k2, k1, (z - k4) / sa1, kept)
    x = (r - k3) / (2 * a1)
    if abs(sa1) < NONE:
        return linear(k1, -minus_k2, x, kept)
    y = (z - k4) / sa1
    return [kept if hypot(k1, minus_k2) < FREE else atan2(k1 * y - minus_k2 * x, k1 * x + minus_k2 * y)]


def linear(A: float, B: float, C: float, kept: float) -> list[float]:
    """θ of A cos θ + B sin θ = C: Atan2(B, A) ± Atan2(√(A² + B² − C²), C); the one kept where every θ solves it."""
    size = A * A + B * B
    if size < FREE**2:
        return [kept] if abs(C) < FREE else []
    radicand = size - C * C
    if radicand < -ROUNDING * size:
        return []
    middle, aside = atan2(B, A), atan2(sqrt(max(radicand, 0.0)), C)
    return [middle + aside, middle - aside]


def wrist_angles(arm: Arm, M: Array, kept: float) -> Iterator[tuple[tuple[float, float, float], bool]]:
    """θ₄, θ₅, θ₆ of Rz(θ₄) Rx(α₄) Rz(θ₅) Rx(α₅) Rz(θ₆) = M for both signs of θ₅, and whether θ₄ is free and kept.

    c₅ = (cα₄ cα₅ − m₃₃) / sα₄ sα₅, θ₄ from the last column of M, θ₆ from what is left. None where |c₅| > 1.
    """
    ca4, ca5, sa4, sa5 = cos(arm.alpha[3]), cos(arm.alpha[4]), sin(arm.alpha[3]), sin(arm.alpha[4])
    c5 = (ca4 * ca5 - M[2, 2]) / (sa4 * sa5)
    y = -ca4 * sa5 * c5 - sa4 * ca5
    sine2 = (M[0, 2] ** 2 + M[1, 2] ** 2 - y**2) / sa5**2
    if sine2 < -ROUNDING:
        return
    for s5 in (sqrt(max(sine2, 0.0)), -sqrt(max(sine2, 0.0))):
        theta5, free = atan2(s5, c5), hypot(sa5 * s5, y) < FREE
        theta4 = kept if free else atan2(M[1, 2], M[0, 2]) - atan2(y, sa5 * s5)
        N = (_rz(theta4) @ _rx(arm.alpha[3]) @ _rz(theta5) @ _rx(arm.alpha[4])).T @ M
        yield (theta4, theta5, atan2(N[1, 0], N[0, 0])), free


def polished(robot: Robot, T_world_goal: Array, q: Array) -> Array:
    """q (6,), rad, after Newton steps Δq = J† e, where it misses the goal (4, 4), m: axes may meet inexactly."""
    for _ in range(5):
        T = tool_at(robot, q)
        turn = rotation.logarithm(T_world_goal[:3, :3] @ T[:3, :3].T)
        e = np.concatenate([T_world_goal[:3, 3] - T[:3, 3], turn])
        if np.abs(e).max() < EXACT:
            break
        q = q + np.linalg.lstsq(geometric(robot, q), e, rcond=1e-8)[0]
    return q


def _after_arm(arm: Arm, theta: tuple[float, ...]) -> Array:
    """⁰R₃ Rx(α₃), (3, 3)."""
    R = np.eye(3)
    for angle, alpha in zip(theta, arm.alpha, strict=False):
        R = R @ _rz(angle) @ _rx(alpha)
    return np.asarray(R)


def _rz(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def _rx(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def _is_same(one: Branch, other: Branch) -> bool:
    return bool(np.abs(wrap(one.q - other.q)).max() < MERGED)


def _name(found: list[tuple[Branch, Posture]], posture: Posture) -> Text:
    n = len({other.arm for _, other in found} | {posture.arm})
    return (FLIPPED if posture.flipped else POSTURE).format(n=n)


def _words(count: int, short: float, free: tuple[int, ...]) -> Text:
    joints = ", ".join(str(joint + 1) for joint in free)
    return sentences(
        COUNTED.format(n=count) if count else OUTSIDE.format(short=1000 * short) if short > ACCEPTED else TURNED,
        KEPT.format(joints=joints) if free else None,
    )


POSTURE = Text(en="arm posture {n}", pt_BR="postura {n} do braço")
FLIPPED = Text(en="arm posture {n}, wrist flipped", pt_BR="postura {n} do braço, punho virado")
COUNTED = Text(
    en="Postures: {n}; each posture of the arm with the wrist as it is and flipped.",
    pt_BR="Posturas: {n}; cada postura do braço com o punho como está e virado.",
)
OUTSIDE = Text(
    en="Out of reach: the wrist centre lies {short:.3g} mm beyond the edge of its workspace.",
    pt_BR="Fora de alcance: o centro do punho fica {short:.3g} mm além da borda do espaço de trabalho dele.",
)
TURNED = Text(
    en="The wrist centre can be where it has to be, but the wrist cannot take this orientation there.",
    pt_BR="O centro do punho chega aonde precisa, mas ali o punho não assume esta orientação.",
)
KEPT = Text(
    en="Singular: the goal alone does not determine joints {joints}; what may take any value keeps its own.",
    pt_BR="Singular: o alvo sozinho não determina as juntas {joints}; a que aceita qualquer valor mantém o atual.",
)
