"""Arms with six revolute joints and a spherical wrist, for Pieper's solution: modified DH rows, the wrist last."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import cos, hypot, sin

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.solvability import meeting_point
from helicoide.kinematics import dh
from helicoide.kinematics.chain import Chain, Joint
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# A sine, and a length in m, that count as zero.
NONE = 1e-6
# The step of finite differences, rad, and the fraction of the cubed arm size below which a determinant is zero.
STEP, STILL = 1e-5, 1e-9


# An arm as the argument of the kernels.
PIEPER = np.dtype(
    [
        ("alpha", "f8", 5),
        ("a", "f8", 3),
        ("d", "f8", 4),
        ("f", "f8", (3, 3)),
        ("size", "f8", 3),
        ("k", "f8", (2, 3)),
        ("shifts", "f8", 6),
        ("frames", "f8", (2, 4, 4)),
        ("backwards", "?"),
    ],
    align=True,
)


@dataclass(frozen=True, eq=False)
class Arm:
    """An arm with the wrist last, in modified rows: α₁ … α₅, a₁ … a₃, d₁ … d₄, θ at q = 0 (6,), rad and m.

    T_base_world, T_tool_wrist (4, 4), m. backwards: whether the chain runs from the tool to the base, for a robot whose
    wrist is first.
    """

    alpha: tuple[float, ...]
    a: tuple[float, ...]
    d: tuple[float, ...]
    shifts: Array
    T_base_world: Array
    T_tool_wrist: Array
    backwards: bool

    def wrist(self, T_world_tool: Array) -> Array:
        """The pose of the last DH frame, origin at the wrist centre, moved by −d₁ along z, (4, 4), m."""
        T = np.linalg.inv(T_world_tool) if self.backwards else T_world_tool
        T = self.T_base_world @ T @ self.T_tool_wrist
        T[2, 3] -= self.d[0]
        return np.asarray(T)

    def turned(self, q: Array) -> Array:
        """q in the joint order of this arm, or from it back to that of the robot."""
        return q[::-1] if self.backwards else q

    @cached_property
    def packed(self) -> Chain:
        """The arm as an array (1,) of PIEPER."""
        packed = np.zeros(1, PIEPER)
        for name in ("alpha", "a", "d", "f", "size", "k", "shifts", "backwards"):
            packed[name] = getattr(self, name)
        packed["frames"] = [self.T_base_world, self.T_tool_wrist]
        return packed

    @cached_property
    def f(self) -> Array:
        """f₁, f₂, f₃: their constant part and the factors of c₃ and s₃, (3, 3), m."""
        (_, sa2, sa3), (_, ca2, ca3) = np.sin(self.alpha[:3]), np.cos(self.alpha[:3])
        (_, a2, a3), (_, _, d3, d4) = self.a, self.d
        return frozen(
            [
                [a2, a3, d4 * sa3],
                [-d4 * sa2 * ca3 - d3 * sa2, -d4 * sa3 * ca2, a3 * ca2],
                [d4 * ca2 * ca3 + d3 * ca2, -d4 * sa3 * sa2, a3 * sa2],
            ]
        )

    @cached_property
    def size(self) -> Array:
        """f₁² + f₂² + f₃² in the same form, (3,), m²: c₃² and s₃² have the same factor and add up to a constant."""
        (_, a2, a3), (_, _, d3, d4) = self.a, self.d
        ca3, sa3 = cos(self.alpha[2]), sin(self.alpha[2])
        constant = a2**2 + a3**2 + d3**2 + d4**2 + 2 * d3 * d4 * ca3
        return frozen([constant, 2 * a2 * a3, 2 * a2 * d4 * sa3])

    @cached_property
    def k(self) -> tuple[Array, Array]:
        """k₃, m², and k₄, m, in the same form, (3,)."""
        a1, d2 = self.a[0], self.d[1]
        k3 = self.size + 2 * d2 * self.f[2] + [a1**2 + d2**2, 0, 0]
        return frozen(k3), frozen(cos(self.alpha[0]) * (self.f[2] + [d2, 0, 0]))


@lru_cache(maxsize=64)
def arm_of(robot: Robot) -> Arm | Text:
    """The robot as an `Arm`, or why it is not one."""
    if len(robot.joints) != 6 or any(joint.is_prismatic or joint.mimic for joint in robot.joints):
        return JOINTS
    ends = {False: (3, 4, 5), True: (0, 1, 2)}
    arms = [_rows(robot, backwards) for backwards, axes in ends.items() if meeting_point(robot, axes) is not None]
    return next(
        (arm for arm in arms if _reaches_every_angle(arm) and _moves_everywhere(arm)), PLACES if arms else WRIST
    )


def _rows(robot: Robot, backwards: bool) -> Arm:
    """The modified rows, from the standard ones of the axes: row i has α and a of standard row i − 1.

    β of nearly parallel axes is ignored, since the postures found from these rows are polished afterwards.
    """
    joints, T_0 = robot.joints, robot.T_world_tool_0
    if backwards:
        T_0 = np.asarray(np.linalg.inv(T_0), dtype=np.float64)
        joints = tuple(_seen(joint, T_0) for joint in reversed(joints))
    table = dh.dh_from_screws(joints, T_0)
    rows = table.rows
    return Arm(
        alpha=tuple(row.alpha for row in rows[:5]),
        a=tuple(row.a for row in rows[:3]),
        d=tuple(row.d for row in rows[:4]),
        shifts=frozen([row.theta for row in rows]),
        T_base_world=frozen(np.linalg.inv(table.T_world_dh)),
        T_tool_wrist=frozen(np.linalg.inv(table.T_dh_tool)),
        backwards=backwards,
    )


def _seen(joint: Joint, T_tool_world: Array) -> Joint:
    """A joint at q = 0 in the tool frame, with its direction reversed, as the chain runs from the tool to the base."""
    R, p = T_tool_world[:3, :3], T_tool_world[:3, 3]
    return replace(joint, direction=frozen(-R @ joint.direction), point=frozen(R @ joint.point + p))


def _reaches_every_angle(arm: Arm) -> bool:
    return min(abs(sin(arm.alpha[3])), abs(sin(arm.alpha[4]))) > NONE


def _moves_everywhere(arm: Arm) -> bool:
    """Whether det ∂(ρ², z)/∂(θ2, θ3) is not zero everywhere: the wrist centre then moves in three dimensions."""
    theta2, theta3 = np.random.default_rng(0).uniform(-np.pi, np.pi, (2, 20))

    def at(step2: float, step3: float) -> Array:
        out, up = meridian(arm, theta2 + step2, theta3 + step3)
        return np.array([out**2, up])

    by_2, by_3 = at(STEP, 0) - at(-STEP, 0), at(0, STEP) - at(0, -STEP)
    largest = sum(map(abs, (*arm.a, *arm.d[1:])))
    return bool(np.abs(by_2[0] * by_3[1] - by_2[1] * by_3[0]).max() > (2 * STEP) ** 2 * STILL * largest**3)


def meridian(arm: Arm, theta2: Array, theta3: Array) -> tuple[Array, Array]:
    """The wrist centre at angles (...), rad: its distance √(g₁² + g₂²) from the first axis, and z along it, m."""
    f1, f2, f3 = (row[0] + row[1] * np.cos(theta3) + row[2] * np.sin(theta3) for row in arm.f)
    c2, s2, ca1, sa1 = np.cos(theta2), np.sin(theta2), cos(arm.alpha[0]), sin(arm.alpha[0])
    across, up = s2 * f1 + c2 * f2, f3 + arm.d[1]
    return np.hypot(c2 * f1 - s2 * f2 + arm.a[0], ca1 * across - sa1 * up), sa1 * across + ca1 * up


def pieper_distance_beyond(arm: Arm, p: Array) -> float:
    """The distance of a point (3,), m, from the workspace of the wrist centre, m, by a refined grid of θ2 and θ3."""
    out, (theta2, theta3), span = hypot(p[0], p[1]), np.zeros(2), np.pi
    far = np.zeros(0)
    while span > 1e-9:
        grid = span * np.linspace(-1, 1, 61)
        angles2, angles3 = np.meshgrid(theta2 + grid, theta3 + grid)
        rho, z = meridian(arm, angles2, angles3)
        far = np.hypot(rho - out, z - p[2])
        best = np.unravel_index(np.argmin(far), far.shape)
        theta2, theta3, span = angles2[best], angles3[best], span / 8
    return float(far.min())


JOINTS = Text(
    en="This form needs six revolute joints, each moving independently.",
    pt_BR="Esta forma exige seis juntas de revolução, cada uma com movimento independente.",
)
WRIST = Text(
    en="This form needs the first three or the last three axes to intersect at a point.",
    pt_BR="Esta forma exige que os três primeiros ou os três últimos eixos se cruzem num ponto.",
)
PLACES = Text(
    en="Three axes intersect at a point, but that wrist does not take every orientation, or the other joints do not "
    "move its centre in three dimensions.",
    pt_BR="Há três eixos que se cruzam num ponto, mas esse punho não assume toda orientação, ou as outras juntas não "
    "movem o centro dele em três dimensões.",
)
