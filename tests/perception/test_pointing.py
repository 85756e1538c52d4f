"""What a ray points at: measured points before all, then the nearest thing, then the floor."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType

import numpy as np
import pytest

from helicoide import gate
from helicoide.arrays import Array
from helicoide.kinematics.library import load_robot
from helicoide.perception.pointing import point_under_ray
from helicoide.state import FittedCloud, State, initial_state
from helicoide.text import untranslated

EYE = np.array([1.5, 0.05, 0.35])


def towards(point: Array) -> Array:
    return 3.0 * (point - EYE)


def test_the_nearest_pane_is_meant(state: State) -> None:
    planes = state.problem.planes
    for k in (0, 1):
        on_it = planes.centres[k] + 0.05 * np.cross(planes.normals[k], [1.0, 0.0, 0.0])
        point = point_under_ray(state, EYE, towards(on_it))
        assert point is not None
        np.testing.assert_allclose(point, on_it, atol=1e-9)


def test_an_obstacle_in_front_is_meant(state: State) -> None:
    held = gate.add_obstacle()(state)
    centre, radius = held.problem.obstacles.ends[0, 0], held.problem.obstacles.radii[0]
    point = point_under_ray(held, EYE, towards(centre))
    assert point is not None
    assert np.linalg.norm(point - EYE) == pytest.approx(np.linalg.norm(centre - EYE) - radius)


def test_a_pane_is_looked_through_from_behind(state: State) -> None:
    """From outside the right wall the left one is meant."""
    planes = state.problem.planes
    left, outside = planes.names.index("+y"), np.array([0.5, -1.5, 0.5])
    point = point_under_ray(state, outside, planes.centres[left] - outside)
    assert point is not None
    np.testing.assert_allclose(point, planes.centres[left], atol=1e-9)


def test_a_measured_point_is_meant_also_before_a_pane(state: State) -> None:
    points = state.problem.planes.centres[0] + np.array([[0.0, 0.0, -0.004], [0.1, 0.0, 0.003], [5.0, 5.0, 5.0]])
    seen = FittedCloud(points, np.ones(3, dtype=bool), untranslated("seen"))
    seeing = replace(state, clouds=MappingProxyType({"+z": seen}))
    for k in (0, 1):
        point = point_under_ray(seeing, EYE, towards(points[k] + 0.001))
        assert point is not None
        np.testing.assert_array_equal(point, points[k])
    assert not np.allclose(point_under_ray(seeing, EYE, towards(points[0] + [0.0, 0.05, 0.0])), points[0])


def test_without_anything_else_the_floor_is_meant() -> None:
    state = initial_state(load_robot("puma560"))
    down = point_under_ray(state, EYE, np.array([-1.0, 0.0, -0.5]))
    assert down is not None
    assert down[2] == pytest.approx(state.robot.floor)
    assert point_under_ray(state, EYE, np.array([0.0, 0.0, 1.0])) is None


@pytest.mark.parametrize("ray", [[np.nan, 0.0, 1.0], [np.inf, 0.0, 0.0], [0.0, 0.0, 0.0]])
def test_a_ray_that_is_none_means_nothing(state: State, ray: list[float]) -> None:
    assert point_under_ray(state, EYE, np.array(ray)) is None
    assert point_under_ray(state, np.array([np.nan, 0.0, 0.0]), np.array([-1.0, 0.0, 0.0])) is None
