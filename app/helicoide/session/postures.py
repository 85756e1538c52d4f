"""Searches for postures that take a while: all postures of the goal, and a singular posture."""

from __future__ import annotations

from helicoide import gate, readout
from helicoide.ik.postures.singular import singular_posture
from helicoide.ik.postures.solve import solve
from helicoide.state import State, Update


def list_postures(state: State) -> Update:
    """The update that shows every posture for the target pose, or for the tool pose if there is no target."""
    T, with_orientation, q = readout.target_pose(state), state.request.with_orientation, state.arm.q
    answer = solve(state.robot, T, q, every=True, with_orientation=with_orientation)
    return gate.show_postures(T, with_orientation, q, answer)


def to_singular_posture(state: State) -> Update:
    """The update that drives the tool through a singular posture to a target beyond it."""
    return gate.go_beyond_singular(singular_posture(state.problem, state.request.with_orientation))
