"""The RealSense camera, with a package of the tests' own in the place of pyrealsense2."""

from __future__ import annotations

import sys
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.perception.views import INSIDE, READINGS, reading

from helicoide.arrays import Array
from helicoide.perception import realsense
from helicoide.perception.camera import D435, SimulatedCamera, ray_depths
from helicoide.perception.planes import FoundPlane, find_plane
from helicoide.state import State
from helicoide.text import HelicoideError

FLOAT3 = np.dtype([("f0", "<f4"), ("f1", "<f4"), ("f2", "<f4")])


def picture(points: Array) -> np.ndarray[Any, Any]:
    """Points as the package hands them out: one record of three floats each."""
    return points.astype("<f4").view(FLOAT3).ravel()


class Package:
    """What `realsense` uses of pyrealsense2: each picture is that of the scene when it is asked for."""

    stream = SimpleNamespace(depth="depth")
    format = SimpleNamespace(z16="z16")

    def __init__(self) -> None:
        self.points = np.zeros((1, 3))
        self.started: Any = None
        self.taken = self.stopped = 0
        self.fails: str | None = None

    def config(self) -> Any:
        return SimpleNamespace(enable_stream=lambda *requested: setattr(self, "requested", requested))

    def pipeline(self) -> Any:
        return self

    def start(self, config: Any) -> None:
        self._answer("start")
        self.started = config

    def stop(self) -> None:
        self.stopped += 1

    def wait_for_frames(self, patience_ms: int) -> Any:
        self._answer("frames")
        self.taken += 1
        return SimpleNamespace(get_depth_frame=lambda: self.points)

    def pointcloud(self) -> Any:
        return SimpleNamespace(calculate=lambda points: SimpleNamespace(get_vertices=lambda: picture(points)))

    def _answer(self, what: str) -> None:
        if self.fails == what:
            raise RuntimeError("No device connected")


@pytest.fixture
def package(monkeypatch: pytest.MonkeyPatch) -> Package:
    package = Package()
    monkeypatch.setitem(sys.modules, realsense.PACKAGE, package)  # type: ignore[arg-type]
    return package


def seen(state: State, resolution: tuple[int, int]) -> Array:
    """The points of a scene in the frame of the camera, zero where there are none, as the real one gives them."""
    T = state.T_world_tool @ D435.T_tool_camera
    rays = D435.directions(resolution)
    depths = ray_depths(state, T[:3, 3], rays @ T[:3, :3].T)
    return np.where(np.isfinite(depths), depths, 0.0)[:, None] * rays


def test_it_gives_what_the_simulated_camera_gives(package: Package, state: State) -> None:
    here = reading(state, "+y")
    package.points = seen(here, (106, 60))
    with realsense.connected(resolution=(106, 60)) as camera:
        cloud = camera.cloud(here)
        assert package.stopped == 0
    expected = SimulatedCamera(resolution=(106, 60)).cloud(here)
    assert cloud.dropped == expected.dropped
    np.testing.assert_allclose(cloud.points, expected.points, atol=1e-6)
    answer = find_plane(cloud.points, READINGS["+y"][1], INSIDE)
    assert isinstance(answer, FoundPlane)
    assert package.stopped == 1
    assert package.requested == ("depth", 106, 60, "z16", 30)  # type: ignore[attr-defined]


def test_pictures_from_before_the_arm_came_to_rest_are_passed_over(package: Package, state: State) -> None:
    package.points = np.array([[0.0, 0, 0.5]])
    with realsense.connected() as camera:
        settled = package.taken
        camera.cloud(state)
    assert settled == realsense.SETTLING
    assert package.taken == settled + 2


def test_pixels_without_a_depth_in_reach_are_dropped(package: Package, state: State) -> None:
    package.points = np.array([[0.0, 0, 0], [0, 0, 0.29], [0, 0, 0.5], [0, 0, 0.71], [0, 0, np.nan]])
    with realsense.connected() as camera:
        cloud = camera.cloud(state)
    assert cloud.dropped == 4
    middle = (state.T_world_tool @ D435.T_tool_camera) @ [0, 0, 0.5, 1]
    np.testing.assert_allclose(cloud.points, [middle[:3]], atol=1e-7)


def test_without_the_package_it_is_said_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, realsense.PACKAGE, None)
    with (
        pytest.raises(HelicoideError, match="`pip install pyrealsense2`") as refused,
        realsense.connected(),
    ):
        pass
    assert "`pip install pyrealsense2`" in refused.value.text.pt_BR


def test_without_a_camera_it_is_said_what_to_do(package: Package) -> None:
    package.fails = "start"
    said = r"848 × 480 pixels at 30 Hz: plug"
    with pytest.raises(HelicoideError, match=said), realsense.connected():
        pass
    assert package.stopped == 0


def test_a_camera_that_is_pulled_out_is_let_go(package: Package, state: State) -> None:
    package.points = np.array([[0.0, 0, 0.5]])
    with realsense.connected() as camera:
        package.fails = "frames"
        with pytest.raises(HelicoideError, match="sends no picture: check its cable"):
            camera.cloud(state)
    assert package.stopped == 1
