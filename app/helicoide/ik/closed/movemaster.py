"""The Movemaster and its kin: five joints, four postures, the waist to the front or turned back, the elbow up or down.

What lies in the plane of the arm is a complex number ζ = x − i z there: a turn by θ about y multiplies it by e^(iθ).
"""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import atan2, cos, pi, sin

import numpy as np

from helicoide.geometry import rotation
from helicoide.ik.families import elbow
from helicoide.ik.families.turret import Turret, turret
from helicoide.ik.postures import subspace
from helicoide.ik.postures.branch import Answer, Branch, branch_of, sentences, wrap
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

TITLE = Text(en="Movemaster and its kin", pt_BR="Movemaster e semelhantes")
SOURCE = "Cerbaro 2022, tabs. 6 and 8 (geometry); Campos 1998, s.36 and s.44–55 (plane of the arm, elbow)"
RANK, OF_POINTS = 0, False
EQUATIONS = (
    r"\theta_1 = \operatorname{Atan2}(p_y, p_x) \;[+\,180^\circ], \quad u = c_1 p_x + s_1 p_y",
    r"\zeta_P = u - i p_z, \quad e^{i\alpha} = \frac{\zeta_{\hat Z}}{\zeta_{\hat Z}(0)}, \quad"
    r"\alpha = \theta_2 + \theta_3 + \theta_4",
    r"\zeta_W = \zeta_P - l_3 e^{i\alpha} - \zeta_S = l_1 e^{i\theta_2} + l_2 e^{i(\theta_2 + \theta_3)}",
    r"\cos(\theta_3 + \delta) = \frac{|\zeta_W|^2 - |l_1|^2 - |l_2|^2}{2 |l_1| |l_2|}, \quad"
    r"\delta = \arg \frac{l_2}{l_1}",
    r"\theta_2 = \arg \frac{\zeta_W}{l_1 + l_2 e^{i\theta_3}}, \quad \theta_4 = \alpha - \theta_2 - \theta_3",
    r"R_{\hat Z}(\theta_5) = R_y(\alpha)^T R_z(\theta_1)^T R R_0^T",
)
NO_LINK = 1e-9


@dataclass(frozen=True, eq=False)
class Side:
    """The arm at q = 0 in its plane, m: the shoulder ζ_S from the waist, the upper arm l₁, the forearm l₂, the hand l₃.

    turret: the frame of the base; signs (3,): ±1, the joints 2, 3 and 4 against its y; hand (3,), home (3, 3): the last
    axis and the tool's orientation at q = 0 in the base.
    """

    turret: Turret
    shoulder: complex
    l1: complex
    l2: complex
    l3: complex
    signs: Array
    hand: Array
    home: Array

    @property
    def links(self) -> elbow.Annulus:
        """The upper arm and the forearm."""
        return elbow.Annulus(abs(self.l1), abs(self.l2))

    def wrist(self, zeta: complex, alpha: float) -> complex:
        """The wrist from the shoulder, ζ_W, where the tool stands at ζ and the hand is turned by α, rad."""
        return zeta - self.l3 * rect(1, alpha) - self.shoulder


def applies(robot: Robot) -> Text | None:
    """Why the form does not apply to a robot; None where it does."""
    return ELSE if side_of(robot) is None else None


@lru_cache(maxsize=16)
def side_of(robot: Robot) -> Side | None:
    """The robot as such an arm, or None."""
    if (arm := turret(robot)) is None:
        return None
    R, tool = arm.T_world_base[:3, :3], robot.T_world_tool_0
    points = np.array([*robot.points[1:4], tool[:3, 3]]) - arm.T_world_base[:3, 3]
    shoulder, elbow_0, wrist, tip = points @ R[:, 0] - 1j * points @ R[:, 2]
    if min(abs(elbow_0 - shoulder), abs(wrist - elbow_0)) < NO_LINK:
        return None
    return Side(
        turret=arm,
        shoulder=complex(shoulder),
        l1=complex(elbow_0 - shoulder),
        l2=complex(wrist - elbow_0),
        l3=complex(tip - wrist),
        signs=frozen(np.sign(robot.directions[1:4] @ R[:, 1])),
        hand=frozen(R.T @ robot.directions[4]),
        home=frozen(R.T @ tool[:3, :3]),
    )


def solve(robot: Robot, T_world_tool: Array, q: Array) -> Answer:
    """Every posture for a tool pose (4, 4), m, whose pointing axis is first turned into the plane of the arm.

    q (5,), rad: θ₁ is kept where the hand stands upright over the waist, θ₂ where equal links fold onto the shoulder.
    Raises HelicoideError for a robot of another kind and for what is no pose.
    """
    if (arm := side_of(robot)) is None:
        raise HelicoideError(ELSE)
    goal, q = subspace.project(robot, T_world_tool, q), robot.check_joints(q)
    T = arm.turret.seen(goal.T_world_goal)
    M, over = arm.turret.normal(T, float(q[0]))
    heading = atan2(-M[0], M[1])
    found = [(back, steps) for back in (0, 1) for steps in _steps(arm, T, heading + back * pi, q)]
    sizes = [abs(arm.wrist(*_seen(arm, T, heading + back * pi))) for back in (0, 1)]
    nearer = min(sizes, key=arm.links.beyond)
    return Answer(
        branches=tuple(_branch(robot, arm, back, steps, T_world_tool) for back, steps in found),
        T_world_goal=goal.T_world_goal,
        words=sentences(
            goal.words,
            COUNTED.format(n=len(found)) if found else arm.links.words(nearer),
            OVER if over else None,
            FOLDED if any(map(arm.links.at_centre, sizes)) else None,
        ),
        moved=goal.moved,
        turned=goal.turned,
        short=arm.links.beyond(nearer),
        free=(0,) * over + (1,) * any(map(arm.links.at_centre, sizes)),
        values=tuple(steps for _, steps in found),
    )


def _seen(arm: Side, T: Array, theta1: float) -> tuple[complex, float]:
    """Where the tool (4, 4), m, of the base stands in the plane of θ₁, ζ_P, and how far its hand is turned there, α."""
    ahead = np.array([cos(theta1), sin(theta1), -1j])
    pointing, at_zero = T[:3, :3] @ arm.turret.hand, arm.hand[0] - 1j * arm.hand[2]
    return complex(ahead @ T[:3, 3]), phase((ahead @ pointing) / at_zero)


def _steps(arm: Side, T: Array, theta1: float, q: Array) -> Iterator[Mapping[str, float]]:
    """The steps by symbol for one θ₁, rad; angles about the y of the base, rad and m."""
    zeta, alpha = _seen(arm, T, theta1)
    wrist = arm.wrist(zeta, alpha)
    kept = phase(arm.l1) + float(arm.signs[0] * q[1])
    turn = rotation.exponential(-alpha * np.eye(3)[1]) @ rotation.exponential(-theta1 * np.eye(3)[2])
    theta5 = rotation.logarithm(turn @ T[:3, :3] @ arm.home.T) @ arm.hand
    for sign in arm.links.elbows(abs(wrist)):
        two = elbow.algebraic(wrist.real, wrist.imag, arm.links, sign, kept)
        theta2, theta3 = two.theta1 - phase(arm.l1), two.theta2 - phase(arm.l2 / arm.l1)
        yield {
            "u": zeta.real, "p_z": -zeta.imag, "α": alpha, "u_W": wrist.real, "z_W": -wrist.imag,
            "cos(θ₃ + δ)": two.c2, "θ₁": float(wrap(theta1)), "θ₂": float(wrap(theta2)), "θ₃": float(wrap(theta3)),
            "θ₄": float(wrap(alpha - theta2 - theta3)), "θ₅": float(theta5), "bend": float(sign),
        }  # fmt: skip


def _branch(robot: Robot, arm: Side, back: int, steps: Mapping[str, float], T_world_goal: Array) -> Branch:
    q = np.array([steps[symbol] for symbol in ("θ₁", "θ₂", "θ₃", "θ₄", "θ₅")])
    q[1:4] *= arm.signs
    up = (steps["bend"] > 0) == (steps["u_W"] >= 0)
    return branch_of(robot, SIDES[back].format(elbow=elbow.UP if up else elbow.DOWN), q, T_world_goal)


SIDES = (
    Text(en="waist to the front, {elbow}", pt_BR="cintura de frente, {elbow}"),
    Text(en="waist turned back, {elbow}", pt_BR="cintura virada para trás, {elbow}"),
)
ELSE = Text(
    en="This form is for five turning joints: a waist; shoulder, elbow and bend with parallel axes across it; a roll "
    "that carries the tool in the plane of the arm.",
    pt_BR="Esta forma vale para cinco juntas de revolução: cintura; ombro, cotovelo e flexão de eixos paralelos, "
    "transversais a ela; e um rolamento que leva o efetuador no plano do braço.",
)
COUNTED = Text(
    en="Postures: {n}; the waist to the front or turned back, the elbow up or down.",
    pt_BR="Posturas: {n}; a cintura de frente ou virada para trás, o cotovelo para cima ou para baixo.",
)
OVER = Text(
    en="The hand stands upright over the axis of the waist: every θ₁ serves; the present one is kept.",
    pt_BR="A mão está a prumo sobre o eixo da cintura: qualquer θ₁ serve; mantém-se o atual.",
)
FOLDED = Text(
    en="The wrist lies on the axis of the shoulder: every θ₂ serves; the present one is kept.",
    pt_BR="O punho está sobre o eixo do ombro: qualquer θ₂ serve; mantém-se o atual.",
)
