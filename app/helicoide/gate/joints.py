"""Joints, named postures and the gripper, and the way home with the planes off."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from helicoide.arrays import frozen
from helicoide.command import GetReady, HoldPosition, MoveToJoints, Park
from helicoide.gate.check import checked, driven, finite
from helicoide.state import State, Update, with_command, with_drag
from helicoide.text import HelicoideError, Text

NO_PARKING = Text(
    en="This arm has no planes to park out of.",
    pt_BR="Este braço não tem planos dos quais sair para estacionar.",
)

IN_THE_WAY = Text(
    en="The arm parks without watching: take the obstacles away first.",
    pt_BR="O braço estaciona sem vigiar o caminho: tire os obstáculos antes.",
)


def set_joint(index: int, angle: float) -> Update:
    """One joint from its slider or number box, rad or m."""

    def change(state: State) -> State:
        (value,) = finite([angle], (1,))
        if index not in range(len(state.arm.q)):
            raise HelicoideError(
                Text(en="There are joints 1 to {n}.", pt_BR="Há juntas de 1 a {n}.").format(n=len(state.arm.q))
            )
        limits = state.problem.limits
        if not limits.lower[index] - 1e-6 <= value <= limits.upper[index] + 1e-6:
            raise HelicoideError(_outside(state, index))
        goal = state.request.command.q if isinstance(state.request.command, MoveToJoints) else state.arm.q
        q = goal.copy()
        q[index] = min(max(value, limits.lower[index]), limits.upper[index])
        return with_command(state, MoveToJoints(frozen(q), first_to_stop=index))

    return driven(change)


def _outside(state: State, index: int) -> Text:
    joint, limits = state.robot.variables[index], state.problem.limits
    scale, unit = (1000.0, " mm") if joint.is_prismatic else (180 / np.pi, "°")
    return Text(
        en="Joint {n} ({title}) takes {lower:.0f}{unit} to {upper:.0f}{unit}.",
        pt_BR="A junta {n} ({title}) aceita de {lower:.0f}{unit} a {upper:.0f}{unit}.",
    ).format(
        n=index + 1,
        title=joint.title,
        lower=scale * limits.lower[index],
        upper=scale * limits.upper[index],
        unit=unit,
    )


def go_to(name: str) -> Update:
    """A named posture of the robot; with planes `home` is parking, and `ready` is getting ready."""

    def change(state: State) -> State:
        poses = state.robot.poses
        if name not in poses:
            raise HelicoideError(
                Text(
                    en="There is no pose {name!r}; there is: {known}.",
                    pt_BR="Não existe a pose {name!r}; existe: {known}.",
                ).format(name=name, known=", ".join(poses))
            )
        return with_command(state, MoveToJoints(poses[name]))

    def update(state: State) -> State:
        parking = name == "home" and state.robot.panes
        return park()(state) if parking else driven(change)(state)

    return get_ready() if name == "ready" else update


def park() -> Update:
    """To `ready` inside the planes, then home with the planes off."""

    def change(state: State) -> State:
        if not state.robot.panes:
            raise HelicoideError(NO_PARKING)
        if state.problem.obstacles.radii.size:
            raise HelicoideError(IN_THE_WAY)
        return with_command(with_drag(state, None), Park())

    return checked(change)


def get_ready() -> Update:
    """To `ready`; from home with the planes off."""
    return lambda state: with_command(with_drag(state, None), GetReady())


def set_gripper(opening: float) -> Update:
    """The gripper, 0 closed to 1 open."""

    def change(state: State) -> State:
        (value,) = finite([opening], (1,))
        if not 0.0 <= value <= 1.0:
            raise HelicoideError(Text(en="The gripper takes 0 to 100 %.", pt_BR="A garra aceita de 0 a 100 %."))
        released = HoldPosition() if state.request.command == HoldPosition(stopped=True) else state.request.command
        return replace(state, request=replace(state.request, gripper=value, command=released))

    return checked(change)
