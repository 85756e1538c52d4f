"""Checks that all requests share: finite numbers, valid poses, an arm that may move."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.geometry import rotation
from helicoide.state import State, Update
from helicoide.text import HelicoideError, Text

FARTHEST = 3.7
PARKED = Text(
    en="The arm is parked with its planes off: press “Ready pose” first.",
    pt_BR="O braço está estacionado, com os planos desligados: aperte “Ir à pose inicial” primeiro.",
)
NOT_A_NUMBER = Text(en="That is not a finite number.", pt_BR="Isso não é um número finito.")


def finite(values: ArrayLike, shape: tuple[int, ...]) -> Array:
    """The values as an array of this shape. Raises HelicoideError unless all are finite numbers of this shape."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise HelicoideError(NOT_A_NUMBER) from error
    if array.shape != shape or not np.isfinite(array).all():
        raise HelicoideError(NOT_A_NUMBER)
    return frozen(array)


def checked(update: Update) -> Update:
    """The update; if it raises HelicoideError, the state stays the same with the reason as its notice."""

    def with_notice(state: State) -> State:
        try:
            return update(state)
        except HelicoideError as refusal:
            return replace(state, notice=refusal.text)

    return with_notice


def driven(update: Update) -> Update:
    """An update that moves the arm: as `checked`, and refused while the arm is parked."""

    def unless_parked(state: State) -> State:
        if state.arm.parked:
            raise HelicoideError(PARKED)
        return update(state)

    return checked(unless_parked)


def pose(state: State, position: ArrayLike, wxyz: ArrayLike) -> Array:
    """T (4, 4), m, from a position (3,), m, and a quaternion (4,), which is normalized.

    Raises HelicoideError for values that are not finite or too large and for a zero quaternion.
    """
    p, q, far = finite(position, (3,)), finite(wxyz, (4,)), FARTHEST * state.robot.maximum_reach
    if np.abs(p).max() > far or np.abs(q).max() > FARTHEST or np.linalg.norm(q) < 1e-6:
        raise HelicoideError(
            Text(
                en="The target must be within {far:.1f} m of the base and have an orientation.",
                pt_BR="O alvo deve ficar a até {far:.1f} m da base e ter uma orientação.",
            ).format(far=far)
        )
    T = np.eye(4)
    T[:3, :3] = rotation.to_matrix(q / np.linalg.norm(q))
    T[:3, 3] = p
    return frozen(T)


def while_asked(before: State, update: Update) -> Update:
    """The update; the state stays unchanged if the command or the robot is no longer that of `before`."""

    def if_unchanged(state: State) -> State:
        unchanged = state.request.command is before.request.command and state.robot is before.robot
        return update(state) if unchanged else state

    return if_unchanged


def while_there(before: State, update: Update) -> Update:
    """The update; the state stays unchanged if the robot is no longer that of `before`."""
    return lambda state: update(state) if state.robot is before.robot else state
