"""Motions: motors, rotors, translators and screws, their exponentials and logarithms, and interpolation."""

from __future__ import annotations

import math

import numpy as np

from helicoide.console.functions import Example, console_function
from helicoide.console.parameters import ANYTHING, BIVECTOR, INCIDENT, LINE, MOTOR, NUMBER, POINT, UNIT_QUATERNION
from helicoide.console.values import NOT_FINITE, Value, multivector_value, quaternion_value
from helicoide.geometry import motor, pga, quaternion_paths, rigid, rotation
from helicoide.geometry.clifford import CL031, PGA, QUATERNIONS, Array
from helicoide.geometry.multivector import Multivector
from helicoide.text import HelicoideError, Text

POSITIVE = Text(en="log takes numbers above 0", pt_BR="log recebe números maiores que 0")
NO_AXIS = Text(
    en="a translation has no axis of rotation; direction(x, y, z) and log(M) describe it",
    pt_BR="uma translação não tem eixo de rotação; direction(x, y, z) e log(M) a descrevem",
)


@console_function(
    "translator(x, y, z)", (NUMBER, NUMBER, NUMBER),
    Text(en="motor of a translation by (x, y, z), m", pt_BR="motor de uma translação por (x, y, z), m"),
    Example("translator(1, 0, 0) >> point(0, 2, 0)", "point(1, 2, 0)"),
)  # fmt: skip
def _translator(x: float, y: float, z: float) -> Value:
    return multivector_value(rigid.translator((x, y, z)))


@console_function(
    "rotor(x, y, z, angle)", (NUMBER, NUMBER, NUMBER, NUMBER),
    Text(
        en="motor of a rotation about an axis (x, y, z) through the origin",
        pt_BR="motor de uma rotação em torno de um eixo (x, y, z) pela origem",
    ),
    Example("rotor(0, 0, 1, pi/2) >> point(1, 0, 0)", "point(0, 1, 0)"),
)  # fmt: skip
def _rotor(x: float, y: float, z: float, angle: float) -> Value:
    return multivector_value(rigid.rotor((x, y, z), angle))


@console_function(
    "screw(L, angle, shift)", (LINE, NUMBER, NUMBER),
    Text(
        en="motor of a rotation about a line and a translation along it, m",
        pt_BR="motor de uma rotação em torno de uma reta e uma translação ao longo dela, m",
    ),
    Example("screw(e12, pi/2, 3) >> point(1, 0, 0)", "point(0, 1, 3)"),
    least=2, work=5,
)  # fmt: skip
def _screw(L: Array, angle: float, shift: float = 0.0) -> Value:
    direction, _ = rigid.direction_and_moment(L)
    return multivector_value(CL031.product(rigid.translator(shift * direction), motor.exp(angle / 2 * L)))


@console_function(
    "motor(q, p)", (UNIT_QUATERNION, POINT),
    Text(
        en="motor of a pose: the rotation q, then the translation to p; without p the rotation alone",
        pt_BR="motor de uma pose: a rotação q e depois a translação a p; sem p, só a rotação",
    ),
    Example("motor(k, point(1, 0, 0))", "translator(1, 0, 0)*e12"),
    least=1,
)  # fmt: skip
def _motor(q: Array, p: Array | None = None) -> Value:
    turn = _rotation(q)
    return multivector_value(turn if p is None else CL031.product(rigid.translator(rigid.coordinates(p)), turn))


def _rotation(q: Array) -> Array:
    """The motor of a unit quaternion: a rotation about an axis through the origin."""
    return rigid.motor_from_dual_quaternion(np.concatenate([q, np.zeros(4)]))


@console_function(
    "rotate(M, X)", (ANYTHING, INCIDENT),
    Text(
        en="X moved by a motor or rotated by a unit quaternion about the origin",
        pt_BR="X movido por um motor ou girado por um quatérnio unitário em torno da origem",
    ),
    Example("rotate(cos(pi/4) + sin(pi/4)*k, point(1, 0, 0))", "point(0, 1, 0)"),
    work=4,
)  # fmt: skip
def _rotate(M: Value, X: Array) -> Value:
    is_quaternion = isinstance(M, Multivector) and M.algebra is QUATERNIONS
    mover = _rotation(UNIT_QUATERNION(M)) if is_quaternion else MOTOR(M)
    return multivector_value(rigid.move(mover, X))


@console_function(
    "exp(B)", (ANYTHING,),
    Text(
        en="exponential: of angle/2 times a line the motor that rotates about it; of a number; of a quaternion",
        pt_BR="exponencial: de ângulo/2 vezes uma reta, o motor que gira em torno dela; de número; de quatérnio",
    ),
    Example("exp(pi/4*e12)", "cos(pi/4) + sin(pi/4)*e12"),
    work=4,
)  # fmt: skip
def _exp(B: Value) -> Value:
    if not isinstance(B, Multivector):
        return _exp_of_number(B)
    if B.algebra is QUATERNIONS:
        real, *_ = B.values.tolist()
        return quaternion_value(_exp_of_number(real) * rotation.from_rotation_vector(2 * B.values[1:]))
    if B.algebra is PGA:
        inner = BIVECTOR(multivector_value(pga.motor_from_modern(B.values)))
        return Multivector(pga.motor_to_modern(motor.exp(inner)), PGA)
    return multivector_value(motor.exp(BIVECTOR(B)))


def _exp_of_number(x: float) -> float:
    try:
        return math.exp(x)
    except OverflowError:
        raise HelicoideError(NOT_FINITE) from None


@console_function(
    "log(M)", (ANYTHING,),
    Text(
        en="logarithm: of a motor, half its angle and translation along the screw axis; of a number; of a quaternion",
        pt_BR="logaritmo: de um motor, metade do ângulo e da translação no eixo helicoidal; de número; de quatérnio",
    ),
    Example("log(rotor(0, 0, 1, pi/2))", "pi/4*e12"),
    work=6,
)  # fmt: skip
def _log(M: Value) -> Value:
    if not isinstance(M, Multivector):
        if M <= 0:
            raise HelicoideError(POSITIVE)
        return math.log(M)
    if M.algebra is QUATERNIONS:
        half = rotation.rotation_vector(UNIT_QUATERNION(M)) / 2
        return quaternion_value(np.concatenate([[0.0], half]))
    if M.algebra is PGA:
        inner = MOTOR(multivector_value(pga.motor_from_modern(M.values)))
        return Multivector(pga.motor_to_modern(motor.log(inner)), PGA)
    return multivector_value(motor.log(MOTOR(M)))


@console_function(
    "axis(M)", (MOTOR,),
    Text(en="screw axis of a motor, as a line", pt_BR="eixo helicoidal de um motor, como reta"),
    Example("axis(translator(0, 0, 2)*rotor(0, 0, 1, 1))", "e12"),
    work=10,
)  # fmt: skip
def _axis(M: Array) -> Value:
    found = motor.screw_from_motor(M)
    if found.angle == 0:
        raise HelicoideError(NO_AXIS)
    return multivector_value(rigid.line(found.direction, found.point))


@console_function(
    "turn(M)", (MOTOR,),
    Text(en="angle by which a motor rotates, 0 to pi", pt_BR="ângulo de rotação de um motor, de 0 a pi"),
    Example("turn(rotor(0, 0, 1, -1))", "1"),
    work=10,
)  # fmt: skip
def _turn(M: Array) -> Value:
    return float(motor.screw_from_motor(M).angle)


@console_function(
    "shift(M)", (MOTOR,),
    Text(
        en="translation of a motor along its screw axis, m", pt_BR="translação de um motor ao longo do seu eixo, m"
    ),
    Example("shift(translator(0, 0, 2)*rotor(0, 0, 1, 1))", "2"),
    work=10,
)  # fmt: skip
def _shift(M: Array) -> Value:
    return float(motor.screw_from_motor(M).displacement)


@console_function(
    "sclerp(M, N, s)", (MOTOR, MOTOR, NUMBER),
    Text(
        en="screw motion from M (s = 0) to N (s = 1): M exp(s log(M* N))",
        pt_BR="movimento helicoidal de M (s = 0) a N (s = 1): M exp(s log(M* N))",
    ),
    Example("sclerp(translator(0, 0, 0), translator(2, 0, 0), 0.5)", "translator(1, 0, 0)"),
    work=10,
)  # fmt: skip
def _sclerp(M: Array, N: Array, s: float) -> Value:
    return multivector_value(motor.sclerp(M, N, s))


@console_function(
    "slerp(p, q, s)", (UNIT_QUATERNION, UNIT_QUATERNION, NUMBER),
    Text(
        en="rotation from p (s = 0) to q or −q (s = 1), the shorter way, at constant speed",
        pt_BR="rotação de p (s = 0) a q ou −q (s = 1), pelo caminho mais curto, com velocidade constante",
    ),
    Example("slerp(quaternion(1, 0, 0, 0), k, 0.5)", "cos(pi/4) + sin(pi/4)*k"),
    work=6,
)  # fmt: skip
def _slerp(p: Array, q: Array, s: float) -> Value:
    return quaternion_value(quaternion_paths.slerp(p, q if p @ q >= 0 else -q, s))
