"""What the simulated depth camera sees."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.perception.views import READINGS, pane, reading

from helicoide.arrays import Array
from helicoide.confinement import Obstacles, pane_axes, segment_distances
from helicoide.kinematics.robot import Robot
from helicoide.perception.camera import D435, SimulatedCamera, hand_camera_pose
from helicoide.perception.rays import ray_to_capsule, ray_to_pane
from helicoide.state import State
from helicoide.text import HelicoideError

seeds = st.integers(0, 2**32 - 1)


def with_obstacles(state: State, obstacles: Obstacles) -> State:
    return replace(state, problem=replace(state.problem, obstacles=obstacles))


def distances(state: State, points: Array) -> Array:
    """Of points from the planes, (k, p), m."""
    planes = state.problem.planes
    return np.abs(points @ planes.normals.T - planes.offsets)


@settings(max_examples=100)
@given(seed=seeds)
def test_rays_meet_a_pane_where_its_plane_is(seed: int) -> None:
    rng = np.random.default_rng(seed)
    eye, centre, rays = rng.normal(size=3), rng.normal(size=3), rng.normal(size=(200, 3))
    axes, size = pane_axes(rng.normal(size=3)), (rng.uniform(0.5, 3), rng.uniform(0.5, 3))
    t = ray_to_pane(eye, rays, centre, axes, size)
    met = np.isfinite(t)
    inside = (eye + t[met, None] * rays[met] - centre) @ axes
    assert (t[met] > 0).all()
    np.testing.assert_allclose(inside[:, 2], 0, atol=1e-9)
    assert (np.abs(inside[:, :2]) <= np.array(size) / 2 + 1e-9).all()
    aimed = centre + rng.uniform(-0.499, 0.499, (200, 2)) * size @ axes[:, :2].T - eye
    np.testing.assert_allclose(ray_to_pane(eye, aimed, centre, axes, size), 1, atol=1e-9)
    outwards = centre + np.array([[0.501 * size[0], 0], [0, -0.501 * size[1]]]) @ axes[:, :2].T - eye
    assert np.isinf(ray_to_pane(eye, outwards, centre, axes, size)).all()
    assert np.isinf(ray_to_pane(eye, -aimed, centre, axes, size)).all()


def test_a_ray_along_a_pane_does_not_meet_it() -> None:
    along = np.array([[1.0, 0, 0], [0, 1, 0]])
    assert np.isinf(ray_to_pane(np.zeros(3), along, np.array([1.0, 0, 0]), np.eye(3), (1, 1))).all()


@settings(max_examples=100)
@given(seed=seeds, ball=st.booleans(), inside=st.booleans())
def test_rays_meet_a_capsule_where_its_surface_is(seed: int, ball: bool, inside: bool) -> None:
    """Against steps along the ray: on the surface where it is met, and on one side of it before."""
    rng = np.random.default_rng(seed)
    ends, radius = rng.normal(size=(2, 3)), rng.uniform(0.1, 0.5)
    if ball:
        ends[1] = ends[0]
    eye = ends[0] + (0.3 * radius if inside else 4) * rng.normal(size=3) / 2
    rays = rng.normal(size=(100, 3))
    rays[:50] = ends[0] + rng.uniform(size=(50, 1)) * (ends[1] - ends[0]) + radius * rng.normal(size=(50, 3)) - eye
    rays[0] = ends[1] - ends[0] if not ball else rays[0]
    t = ray_to_capsule(eye, rays, ends, radius)
    within = segment_distances(eye[None], ends[None])[0, 0] < radius
    met = np.isfinite(t)
    np.testing.assert_allclose(segment_distances(eye + t[met, None] * rays[met], ends[None])[:, 0], radius, atol=1e-7)
    steps = np.where(met, t, 20.0)[:, None] * np.linspace(0, 0.999, 300)
    way = segment_distances((eye + steps[..., None] * rays[:, None]).reshape(-1, 3), ends[None]).reshape(steps.shape)
    assert ((way < radius) == within).all()


def test_a_ray_along_the_axis_of_a_capsule_meets_its_ball() -> None:
    ends = np.array([[1.0, 0, 0], [2, 0, 0]])
    t = ray_to_capsule(np.zeros(3), np.array([[1.0, 0, 0], [-1, 0, 0], [0, 1, 0]]), ends, 0.25)
    np.testing.assert_allclose(t, [0.75, np.inf, np.inf])
    beside = ray_to_capsule(np.array([0, 0.2, 0]), np.array([[1.0, 0, 0]]), ends, 0.25)
    np.testing.assert_allclose(beside, 1 - 0.15)


@pytest.mark.parametrize("name", READINGS)
def test_from_each_reading_pose_the_plane_is_seen_that_is_read(state: State, name: str) -> None:
    """At least a sixth of all points, from 0.3 to 0.7 m deep, on its pane; none anywhere but on a pane."""
    here = reading(state, name)
    cloud = SimulatedCamera().cloud(here)
    index = [pane.name for pane in state.robot.panes].index(name)
    apart = distances(here, cloud.points)
    assert (apart.min(axis=1) < 1e-12).all()
    assert (apart[:, index] < 1e-12).mean() > 1 / 6
    assert len(cloud.points) > 5000
    assert len(cloud.points) + cloud.dropped == 212 * 120
    eye = (here.T_world_tool @ D435.T_tool_camera)[:3]
    depths = (cloud.points - eye[:, 3]) @ eye[:, 2]
    assert depths.min() >= 0.3
    assert depths.max() <= 0.7
    true = pane(state, name)
    on_it = (cloud.points[apart[:, index] < 1e-12] - true.centre) @ pane_axes(true.normal)
    assert (np.abs(on_it[:, :2]) <= np.array(true.size) / 2 + 1e-6).all()


def test_the_picture_has_the_field_of_view_of_the_camera() -> None:
    rays = D435.directions((871, 581)).reshape(581, 871, 3)
    pixel = 1 + 1e-2
    assert np.degrees(np.arctan(rays[290, -1, 0])) == pytest.approx(87 / 2, abs=0.1)
    assert np.degrees(np.arctan(rays[-1, 435, 1])) == pytest.approx(58 / 2, abs=0.1)
    np.testing.assert_allclose(rays[290, 435], [0, 0, 1], atol=1e-12)
    assert rays[0, 0, 0] < 0 < rays[0, -1, 0] * pixel
    assert rays[0, 0, 1] < 0 < rays[-1, 0, 1]


def test_the_camera_looks_along_the_tool_with_its_picture_upright(robot: Robot) -> None:
    """At q = 0 it looks along x, the right of the picture is −y, down is −z; 200 mm behind the tool, 70 mm above."""
    T = robot.T_world_tool_0 @ D435.T_tool_camera
    np.testing.assert_allclose(T[:3, :3], np.array([[0, -1, 0], [0, 0, -1], [1, 0, 0]]).T, atol=1e-12)
    np.testing.assert_allclose(T[:3, 3], [0.62, 0, 0.47], atol=1e-12)
    np.testing.assert_allclose(hand_camera_pose(0.1, 0.2)[:3, 3], [-0.1, 0, 0.2])


def test_an_obstacle_hides_what_is_behind_it(state: State) -> None:
    here = reading(state, "+z")
    clear = SimulatedCamera().cloud(here)
    middle = (here.T_world_tool @ D435.T_tool_camera) @ [0, 0, 0.4, 1]
    ball = with_obstacles(here, Obstacles().with_sphere(middle[:3], 0.05))
    cloud = SimulatedCamera().cloud(ball)
    on_ball = np.abs(np.linalg.norm(cloud.points - middle[:3], axis=1) - 0.05) < 1e-9
    assert on_ball.sum() > 100
    assert (distances(here, cloud.points[~on_ball]).min(axis=1) < 1e-12).all()
    assert (distances(here, clear.points)[:, 0] < 1e-12).sum() > (distances(here, cloud.points)[:, 0] < 1e-12).sum()


def test_planes_are_seen_where_they_have_been_put(state: State) -> None:
    here = reading(state, "+z")
    planes = here.problem.planes.with_plane(0, np.array([0.0, 0, -1]), np.array([0.52, 0, 0.6]))
    cloud = SimulatedCamera().cloud(replace(here, problem=replace(here.problem, planes=planes)))
    assert (np.abs(cloud.points[:, 2] - 0.6) < 1e-12).mean() > 0.8


def test_noise_and_outliers_are_as_many_as_asked_for(state: State) -> None:
    here = reading(state, "+z")
    true = SimulatedCamera().cloud(here)
    eye = (here.T_world_tool @ D435.T_tool_camera)[:3]
    noisy = SimulatedCamera(noise=0.002, seed=1).cloud(here)
    np.testing.assert_allclose(((noisy.points - true.points) @ eye[:, 2]).std(), 0.002, rtol=0.03)
    wrong = SimulatedCamera(outliers=0.3, seed=1).cloud(here)
    moved = np.linalg.norm(wrong.points - true.points, axis=1) > 1e-9
    assert moved.mean() == pytest.approx(0.3, abs=0.02)
    depths = (wrong.points[moved] - eye[:, 3]) @ eye[:, 2]
    assert depths.min() >= 0.3
    assert depths.max() <= 0.7
    assert depths.mean() == pytest.approx(0.5, abs=0.01)


def test_the_same_seed_gives_the_same_cloud(state: State) -> None:
    here = reading(state, "+y")
    one, two, other = (SimulatedCamera(noise=0.002, outliers=0.3, seed=s).cloud(here) for s in (3, 3, 4))
    np.testing.assert_array_equal(one.points, two.points)
    assert (one.points != other.points).any()


def test_a_camera_that_sees_nothing_gives_an_empty_cloud(state: State) -> None:
    blind = replace(D435, clip=0.301)
    cloud = SimulatedCamera(blind, (20, 10)).cloud(state)
    assert (len(cloud.points), cloud.dropped) == (0, 200)
    assert cloud.description.en.startswith("0 points")


@pytest.mark.parametrize(
    "wrong",
    [
        {"resolution": (0, 10)},
        {"resolution": (1281, 10)},
        {"resolution": (10, 721)},
        {"noise": -1.0},
        {"noise": float("nan")},
        {"noise": 0.2},
        {"outliers": 1.1},
        {"outliers": float("nan")},
    ],
)
def test_what_no_camera_has_is_refused_in_words(wrong: dict[str, float]) -> None:
    with pytest.raises(HelicoideError, match="1 × 1 to 1280 × 720 pixels, noise of 0 to 100 mm"):
        SimulatedCamera(**wrong)  # type: ignore[arg-type]
