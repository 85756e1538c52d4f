"""Every posture of the goal that an arm has, found before it is shown."""

from __future__ import annotations

from helicoide import gate, readout
from helicoide.ik.postures.solve import solve
from helicoide.state import State, Update


def list_postures(state: State) -> Update:
    """The wish to show every posture for the pose that is asked of the arm, or for where its tool is."""
    T, with_orientation, q = readout.target_pose(state), state.request.with_orientation, state.arm.q
    answer = solve(state.robot, T, q, every=True, with_orientation=with_orientation)
    return gate.show_postures(T, with_orientation, q, answer)
