"""The closed loop of position and orientation: the theorem of its convergence, and its formulas as they are printed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik.method import Quantity
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.follow import RcmReference, RcmState, RcmStep, body_velocity, pose_error, rcm_loop
from helicoide.ik.rcm.passage import through
from helicoide.studies._coutinho_rows import TIME
from helicoide.studies._coutinho_runs import (
    DEPTH,
    LINK,
    ROBOT,
    START,
    angle_deg,
    dia10,
    entry_on,
    problem_without_planes,
    source_control,
)
from helicoide.studies.study import Chart, ChartLine, Interpretation, Motion, Progress, Result, Row, Statement
from helicoide.text import Text, untranslated

TITLE = Text(en="The loop closes, in the right axes", pt_BR="A malha fecha, nos eixos certos")
SOURCE = "Coutinho 2015, §2.4, §3.1, eqs. 2.16, 2.59–2.69, 3.19"
ABOUT = Text(
    en="Behind a trocar the end effector starts 20 mm and 30° from a target that stands still, and comes to it as the "
    "theorem says. The error of orientation of eqs. 2.62–2.63 is in the axes of the base, while the command is a "
    "velocity in those of the body: with it three of four random poses are missed; with the error as the body sees it "
    "none is.",
    pt_BR="Atrás de um trocarte, o efetuador parte a 20 mm e 30° de um alvo parado e chega a ele como diz o teorema. O "
    "erro de orientação das eqs. 2.62–2.63 está nos eixos da base, enquanto o comando é uma velocidade nos do corpo: "
    "com ele três de cada quatro poses aleatórias não são alcançadas; com o erro como o corpo o vê, todas são.",
)
__all__ = ["ABOUT", "ROBOT", "SOURCE", "TITLE", "Options", "run"]

# s and s, of the arm; s, 1/s and s, of the body alone; of bodies at random: how many, their error, rad, and step, s.
STEP, SECONDS = 0.001, 2.0
BODY_STEP, BODY_GAIN, BODY_SECONDS = 0.005, 2.0, 10.0
BODIES, AWAY, COARSE = 40, 0.2, 0.05
# Of what a formula gives.
CLOSE = 5e-4
STILL = np.zeros(6)
Error = Callable[[Array, Array], Array]
POSITION = Text(en="gain Kp", pt_BR="ganho Kp")
ORIENTATION = Text(en="gain Ko", pt_BR="ganho Ko")


@dataclass(frozen=True)
class Options:
    """Kp and Ko, 1/s: those of table 4.2."""

    position: Annotated[float, Quantity(POSITION, 1.0, 20.0, "1/s")] = 5.0
    orientation: Annotated[float, Quantity(ORIENTATION, 1.0, 20.0, "1/s")] = 10.0


def run(options: Options, short: bool, progress: Progress) -> Result:
    """Two seconds of the arm at 1 ms and ten of the body; a quick run is the same."""
    found = []
    steps = round(SECONDS / STEP) + 1
    for done, moment in enumerate(islice(_approach(options), steps)):
        found.append((moment.t, moment.q, np.linalg.norm(moment.error[:3]), angle_deg(moment.error)))
        progress((done + 1) / steps)
    t, q, position, angle = (np.array(column) for column in zip(*found, strict=True))
    turns = {SEEN: body_rotation_errors(pose_error), PRINTED: body_rotation_errors(printed_error)}
    rows = (*_arrived(t, position, angle), *_missed(), *_formulas(), *_turned(turns))
    return Result(
        rows=rows,
        charts=_charts(t, position, angle, turns),
        motions=(Motion(ROBOT, t[::20], q[::20]),),
    )


def _approach(options: Options) -> Iterator[RcmStep]:
    """The arm at its start behind a trocar, and a target beside its tool."""
    robot = dia10()
    T = tool_at(robot, START)
    target = T.copy()
    target[:3, 3] += [0.012, -0.016, 0.0]
    target[:3, :3] = T[:3, :3] @ rotation.exponential(np.radians(30) * rotation.unit_vector([1.0, 2.0, -1.0]))
    gained = source_control(position=options.position, orientation=options.orientation)
    reference = RcmReference(target, STILL, np.zeros(2))
    entry = entry_on(robot, START, DEPTH)
    problem, start = problem_without_planes(robot), RcmState(START, entry)
    return rcm_loop(problem, through(robot, LINK), gained, lambda t: reference, start, STEP)


def printed_error(T_world_target: Array, T_world_tool: Array) -> Array:
    """The error of orientation as printed: ε̃ of Q_d ⊗ Q⁻¹, in the axes of the base. Source: eqs. 2.62–2.63."""
    vector = rotation.from_matrix(T_world_target[:3, :3] @ T_world_tool[:3, :3].T)[1:]
    return np.concatenate([np.zeros(3), vector])


def body_rotation_errors(error: Error) -> Array:
    """The rotation angle still to go, degrees, step by step, of a body that starts at 180° about x.

    Its target is turned by 20° more, about its own z.
    """
    return _turning(rotation.exponential([np.pi, 0.0, 0.0]), np.array([0.0, 0.0, np.radians(20)]), error, BODY_STEP)


def unconverged_bodies(error: Error) -> int:
    """The number of bodies at random poses that are more than 1° from their targets after 10 s."""
    draw, count = np.random.default_rng(2), 0
    for wxyz in draw.normal(size=(BODIES, 4)):
        away = AWAY * rotation.unit_vector(draw.normal(size=3))
        count += bool(_turning(rotation.to_matrix(wxyz), away, error, COARSE)[-1] > 1.0)
    return count


def _turning(R: Array, away: Array, error: Error, dt: float) -> Array:
    """The rotation angle still to go, degrees, step by step, of a body that rotates by ω = Ko ε̃ in its own axes.

    Args: R (3, 3); away: of its target in its axes (3,), rad; dt, s.
    """
    target, left = _posed(R @ rotation.exponential(away)), []
    for _ in range(round(BODY_SECONDS / dt) + 1):
        left.append(angle_deg(pose_error(target, _posed(R))))
        R = R @ rotation.exponential(body_velocity(R, STILL, error(target, _posed(R)), 0.0, BODY_GAIN)[3:] * dt)
    return np.array(left)


def _posed(R: Array) -> Array:
    T = np.eye(4)
    T[:3, :3] = R
    return T


def _arrived(t: Array, position: Array, angle: Array) -> list[Row]:
    """How the errors of the arm's tool fall: over the first second, and what is left after two."""
    half = len(t) // 2
    quarter = np.tan(np.radians(angle) / 4)
    rates = [float(np.log(error[half] / error[0]) / t[half]) for error in (position, quarter)]
    return [
        Row(
            POSITION_RATE,
            rates[0],
            "1/s",
            Statement(untranslated("ė_p = −Kp e_p, Kp = 5"), "eqs. 2.61, 2.66", -5.0, "=", 0.05),
        ),
        Row(LEFT, float(angle[-1]), "°", Statement(untranslated("ε̃ → 0"), "§2.4", 0.0, "=", 0.01), (AS_SEEN,)),
        Row(ANGLE_RATE, rates[1], "1/s"),
    ]


def _turned(rotations: dict[Text, Array]) -> list[Row]:
    """The remaining rotation angle of the body alone, for each definition of the orientation error."""
    return [Row(ANGLE_LEFT.format(which=which), float(left[-1]), "°") for which, left in rotations.items()]


def _missed() -> list[Row]:
    """The number of bodies that do not converge, for each definition of the orientation error."""
    return [
        Row(MISSED.format(which=SEEN), unconverged_bodies(pose_error), "", Statement(ARRIVES, "§2.4", 0.0), (AS_SEEN,)),
        Row(
            MISSED.format(which=PRINTED),
            unconverged_bodies(printed_error),
            "",
            Statement(ARRIVES, "eqs. 2.62–2.66", 0.0),
            erratum="coutinho-4",
        ),
    ]


def _formulas() -> list[Row]:
    """Differences between printed and correct formulas, for turns of 40° and 60° about x, and Ko = 10."""
    small, large = (np.radians(degrees) for degrees in (40.0, 60.0))
    Q, P = (rotation.from_axis_angle(np.array([1.0, 0.0, 0.0]), angle) for angle in (small, large))
    added = Statement(untranslated("η₁η₂ + ε₁ᵀε₂"), "eq. 2.16", float(Q[0] * P[0] + Q[1:] @ P[1:]), "=", CLOSE)
    whole = Statement(
        untranslated("√(r₁₁ − r₂₂ − r₃₃ + 1)"), "eq. 2.13", float(np.sqrt(2 - 2 * np.cos(small))), "=", CLOSE
    )
    falls = Statement(untranslated("−ε̃ᵀ Ko ε̃"), "eq. 2.69", float(-10 * Q[1:] @ Q[1:]), "=", CLOSE)
    return [
        Row(SCALAR, float(rotation.multiply(Q, P)[0]), "", added, erratum="coutinho-6"),
        Row(VECTOR, float(rotation.from_matrix(rotation.to_matrix(Q))[1]), "", whole, erratum="coutinho-6"),
        Row(LYAPUNOV, _falling(small), "1/s", falls, erratum="coutinho-5"),
    ]


def _falling(angle: float) -> float:
    """V̇ of 2V = (η̃ − 1)² + ε̃ᵀε̃, by differences, when a body turns towards its target by ω = Ko ε̃, Ko = 10."""

    def V(left: float) -> float:
        return 1 - float(np.cos(left / 2))

    step = 1e-6
    return (V(angle - 10 * np.sin(angle / 2) * step) - V(angle)) / step


def _charts(t: Array, position: Array, angle: Array, rotations: dict[Text, Array]) -> tuple[Chart, ...]:
    own = np.linspace(0.0, BODY_SECONDS, round(BODY_SECONDS / BODY_STEP) + 1)
    of_body = tuple(ChartLine(which, own[::10], left[::10]) for which, left in rotations.items())
    return (
        Chart(TIP, TIME, untranslated("|e_p|, mm"), (ChartLine(TIP, t[::10], 1e3 * position[::10]),), log=True),
        Chart(ANGLE, TIME, untranslated("°"), (ChartLine(ANGLE, t[::10], angle[::10]),), log=True),
        Chart(ALONE, TIME, untranslated("°"), of_body, log=True),
    )


SEEN = Text(en="Q⁻¹ ⊗ Q_d, as the body sees it", pt_BR="Q⁻¹ ⊗ Q_d, como o corpo o vê")
PRINTED = Text(en="Q_d ⊗ Q⁻¹, in its printed form", pt_BR="Q_d ⊗ Q⁻¹, na forma impressa")
AS_SEEN = Interpretation(
    Text(en="the error of orientation as the body sees it", pt_BR="o erro de orientação como o corpo o vê"),
    Text(
        en="with Q_d ⊗ Q⁻¹, as printed, 31 of 40 random poses are missed",
        pt_BR="com Q_d ⊗ Q⁻¹, como impresso, 31 de 40 poses aleatórias não são alcançadas",
    ),
)
POSITION_RATE = Text(en="rate of ln |e_p|", pt_BR="taxa de ln |e_p|")
ANGLE_RATE = Text(en="rate of ln tan(φ/4), which is −Ko/2", pt_BR="taxa de ln tan(φ/4), que é −Ko/2")
LEFT = Text(en="angle that is left after 2 s", pt_BR="ângulo que resta após 2 s")
ANGLE_LEFT = Text(
    en="angle after 10 s of a body that is turned by 180°, error {which}",
    pt_BR="ângulo, após 10 s, de um corpo girado de 180°, erro {which}",
)
MISSED = Text(
    en="random poses out of 40 that a body misses, error {which}",
    pt_BR="poses aleatórias, de 40, que um corpo não alcança, erro {which}",
)
ARRIVES = Text(
    en="η̃ → ±1 from all states but a set of measure zero",
    pt_BR="η̃ → ±1 de todos os estados, salvo um conjunto de medida nula",
)
SCALAR = Text(en="scalar part of Q₁ ⊗ Q₂", pt_BR="parte escalar de Q₁ ⊗ Q₂")
VECTOR = Text(en="ε₁ of a turn by 40° about x", pt_BR="ε₁ de um giro de 40° em torno de x")
LYAPUNOV = Text(en="V̇ at e_p = 0 and an error of 40°", pt_BR="V̇ com e_p = 0 e erro de 40°")
TIP = Text(en="Error of the tip", pt_BR="Erro da ponta")
ANGLE = Text(en="Error of orientation", pt_BR="Erro de orientação")
ALONE = Text(en="Angle of a body that is turned by 180°", pt_BR="Ângulo de um corpo girado de 180°")
