"""Joint values, named postures, parking and the gripper."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import frozen
from helicoide.command import GetReady, HoldPosition, MoveToJoints, Park
from helicoide.gate.check import checked, driven, finite
from helicoide.state import State, Update, with_command, with_drag
from helicoide.text import HelicoideError, Text

ROUNDED = 1e-4  # rad or m, by which joint values of a link may lie outside the limits
NO_PARKING = Text(
    en="This arm has no planes, so there is nothing to park for.",
    pt_BR="Este braço não tem planos, portanto não precisa estacionar.",
)
COUNT = Text(
    en="The posture does not fit: {robot} has {n} joint values.",
    pt_BR="A postura não serve: {robot} tem {n} valores de junta.",
)
IN_THE_WAY = Text(
    en="Parking does not check for obstacles: remove them first.",
    pt_BR="O estacionamento não verifica obstáculos: remova-os antes.",
)


def set_joint(index: int, angle: float) -> Update:
    """Set the target of one joint, rad or m; the other joints keep their targets."""

    def change(state: State) -> State:
        (value,) = finite([angle], (1,))
        if index not in range(len(state.arm.q)):
            raise HelicoideError(
                Text(en="The joints are 1 to {n}.", pt_BR="As juntas são de 1 a {n}.").format(n=len(state.arm.q))
            )
        limits = state.problem.limits
        if not limits.lower[index] - 1e-6 <= value <= limits.upper[index] + 1e-6:
            raise HelicoideError(_outside(state, index))
        goal = state.request.command.q if isinstance(state.request.command, MoveToJoints) else state.arm.q
        q = goal.copy()
        q[index] = min(max(value, limits.lower[index]), limits.upper[index])
        return with_command(state, MoveToJoints(frozen(q), first_to_stop=index))

    return driven(change)


def set_joints(q: ArrayLike) -> Update:
    """Set the targets of all joints, (n,), rad or m. Refused if one is outside its limits."""

    def change(state: State) -> State:
        n, limits = len(state.arm.q), state.problem.limits
        if np.shape(q) != (n,):
            raise HelicoideError(COUNT.format(robot=state.robot.title, n=n))
        values = finite(q, (n,))
        outside = (values < limits.lower - ROUNDED) | (values > limits.upper + ROUNDED)
        if outside.any():
            raise HelicoideError(_outside(state, int(outside.argmax())))
        return with_command(state, MoveToJoints(frozen(np.clip(values, limits.lower, limits.upper))))

    return driven(change)


def _outside(state: State, index: int) -> Text:
    joint, limits = state.robot.variables[index], state.problem.limits
    scale, unit = (1000.0, " mm") if joint.is_prismatic else (180 / np.pi, "°")
    return Text(
        en="Joint {n} ({title}) moves from {lower:.0f}{unit} to {upper:.0f}{unit}.",
        pt_BR="A junta {n} ({title}) vai de {lower:.0f}{unit} a {upper:.0f}{unit}.",
    ).format(
        n=index + 1,
        title=joint.title,
        lower=scale * limits.lower[index],
        upper=scale * limits.upper[index],
        unit=unit,
    )


def go_to(name: str) -> Update:
    """Go to a named posture of the robot. `ready` means `get_ready`; `home` means `park` if the robot has planes."""

    def change(state: State) -> State:
        poses = state.robot.poses
        if name not in poses:
            raise HelicoideError(
                Text(
                    en="There is no pose {name!r}; poses: {known}.",
                    pt_BR="Não existe a pose {name!r}; poses: {known}.",
                ).format(name=name, known=", ".join(poses))
            )
        return with_command(state, MoveToJoints(poses[name]))

    def update(state: State) -> State:
        parking = name == "home" and state.robot.panes
        return park()(state) if parking else driven(change)(state)

    return get_ready() if name == "ready" else update


def park() -> Update:
    """Go to `ready` inside the planes, then to `home` with the planes off. Refused while there are obstacles."""

    def change(state: State) -> State:
        if not state.robot.panes:
            raise HelicoideError(NO_PARKING)
        if state.problem.obstacles.radii.size:
            raise HelicoideError(IN_THE_WAY)
        return with_command(with_drag(state, None), Park())

    return checked(change)


def get_ready() -> Update:
    """Go to `ready`; if the arm is parked, with the planes off."""
    return lambda state: with_command(with_drag(state, None), GetReady())


def set_gripper(opening: float) -> Update:
    """Set the target opening of the gripper, 0 closed to 1 open. This ends a stop."""

    def change(state: State) -> State:
        (value,) = finite([opening], (1,))
        if not 0.0 <= value <= 1.0:
            raise HelicoideError(
                Text(en="The gripper opening is 0 to 100 %.", pt_BR="A abertura da garra vai de 0 a 100 %.")
            )
        released = HoldPosition() if state.request.command == HoldPosition(stopped=True) else state.request.command
        return replace(state, request=replace(state.request, gripper=value, command=released))

    return checked(change)
