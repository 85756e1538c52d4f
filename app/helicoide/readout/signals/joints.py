"""The joints: where they are in their ranges, and how fast they move against their limits."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.readout.signal import Band, PhasePlane, Signal, scalar, subscript
from helicoide.state import State
from helicoide.text import Text, untranslated

TITLE = Text(en="Joints", pt_BR="Juntas")
ORDER = 1
PRESET = ("positions", "speeds")
PHASES: tuple[PhasePlane, ...] = ()

LIMIT = Text(en="limit", pt_BR="limite")
SHARES = {
    "positions": (Text(en="Joints in their ranges", pt_BR="Juntas em suas faixas"), "(q − q₋) / (q₊ − q₋)", 0.0),
    "speeds": (
        Text(en="Joint velocities over their limits", pt_BR="Velocidades de junta sobre os limites"),
        "q̇ / q̇₊",
        -100.0,
    ),
}


def signals(problem: Problem, with_orientation: bool) -> Iterator[Signal]:
    """All joints in percent of their limits; then each joint in its own unit."""
    joints = problem.robot.variables
    curves = tuple(untranslated(subscript("q", i + 1)) for i in range(len(joints)))
    for (name, (title, symbol, lowest)), values in zip(SHARES.items(), (position_shares, speed_shares), strict=True):
        yield Signal(name, title, symbol, "%", curves, values, partial(_beyond, lowest, 100.0))
    for i, joint in enumerate(joints):
        scale, unit = (1000.0, "mm") if joint.is_prismatic else (180 / np.pi, "°")
        where, speed = subscript("q", i + 1), subscript("q̇", i + 1)
        title = Text(en="Joint {n} ({joint})", pt_BR="Junta {n} ({joint})").format(n=i + 1, joint=joint.title)
        fast = Text(en="Velocity of joint {n} ({joint})", pt_BR="Velocidade da junta {n} ({joint})")
        yield Signal(
            f"position {i}",
            title,
            where,
            unit,
            (untranslated(where),),
            partial(_at, i, scale),
            partial(_range, i, scale),
        )
        yield Signal(
            f"speed {i}",
            fast.format(n=i + 1, joint=joint.title),
            speed,
            f"{unit}/s",
            (untranslated(speed),),
            partial(_speed, i, scale),
            partial(_speed_range, i, scale),
        )


def position_shares(state: State) -> Array:
    """Each joint in its range, (n,), %: 0 at the lower limit, 100 at the upper one."""
    limits = state.problem.limits
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(100 * (state.arm.q - limits.lower) / (limits.upper - limits.lower))


def speed_shares(state: State) -> Array:
    """Each joint velocity over its limit, (n,), %."""
    return np.asarray(100 * state.arm.velocities / state.problem.limits.speed)


def _at(i: int, scale: float, state: State) -> Array:
    return scalar(scale * state.arm.q[i])


def _speed(i: int, scale: float, state: State) -> Array:
    return scalar(scale * state.arm.velocities[i])


def _range(i: int, scale: float, state: State) -> tuple[Band, ...]:
    limits = state.problem.limits
    return _beyond(scale * float(limits.lower[i]), scale * float(limits.upper[i]), state)


def _speed_range(i: int, scale: float, state: State) -> tuple[Band, ...]:
    most = scale * float(state.problem.limits.speed[i])
    return _beyond(-most, most, state)


def _beyond(lower: float, upper: float, state: State) -> tuple[Band, ...]:
    """The bands below and above two limits."""
    return Band(LIMIT, -np.inf, lower), Band(LIMIT, upper, np.inf)
