"""What a click in the scene means: the nearest object, with points and axes before the link that hides them."""

from __future__ import annotations

import numpy as np
import pytest
from tests.kinematics.arms import NAMES, arm

from helicoide import gate
from helicoide.arrays import Array
from helicoide.perception.selecting import selection_under_ray
from helicoide.seat import Selection
from helicoide.state import State, initial_state

EYE = np.array([0.6, -2.2, 0.7])


def clicked(state: State, point: Array, eye: Array = EYE) -> Selection | None:
    return selection_under_ray(state, eye, 3.0 * (point - eye))


def test_the_tool_the_target_and_a_link_are_clicked(state: State) -> None:
    assert clicked(state, state.T_world_tool[:3, 3]) == Selection("tool")
    moved = gate.set_target([0.45, -0.25, 0.2], [1.0, 0.0, 0.0, 0.0])(state)
    assert clicked(moved, np.array([0.45, -0.25, 0.2])) == Selection("target")
    upper_arm = 0.5 * state.monitored_points[1] + 0.5 * state.monitored_points[2]
    assert clicked(state, upper_arm) == Selection("link", 1)


def test_a_joint_axis_is_clicked_where_it_comes_out_of_the_arm(state: State) -> None:
    for i in (1, 2):
        side = -np.sign(state.axes[i, 1]) * state.axes[i]  # towards the eye
        out = state.arm.poses[i + 1, :3, 3] + 0.13 * state.robot.reach * side
        eye = out + np.array([0.3, -1.5, 0.8])
        assert clicked(state, out, eye) == Selection("joint", i)


def test_a_plane_is_clicked_from_its_inner_side_only(state: State) -> None:
    planes = state.problem.planes
    k = planes.names.index("+y")
    corner = planes.centres[k] + [0.2, 0.0, 0.2]
    assert clicked(state, corner, np.array([0.5, 0.0, 0.6])) == Selection("plane", k)
    outside = corner - 1.0 * planes.normals[k]
    assert clicked(state, corner, outside) != Selection("plane", k)


def test_nothing_is_clicked_in_the_sky_or_by_broken_rays(state: State) -> None:
    assert selection_under_ray(state, EYE, np.array([0.0, -1.0, 1.0])) is None
    for eye, ray in (
        (EYE, np.zeros(3)),
        (EYE, np.array([np.nan, 0.0, 1.0])),
        (np.full(3, np.inf), np.ones(3)),
        (EYE, np.full(3, np.inf)),
    ):
        assert selection_under_ray(state, eye, ray) is None


@pytest.mark.parametrize("name", NAMES)
def test_every_tool_can_be_clicked_from_where_nothing_is_before_it(name: str) -> None:
    state = initial_state(arm(name))
    tool = state.T_world_tool[:3, 3]
    eye = tool + 3 * state.robot.reach * np.array([0.3, -1.0, 0.6])
    found = clicked(state, tool, eye)
    assert found is not None
    assert found.kind in ("tool", "link", "joint", "point")
