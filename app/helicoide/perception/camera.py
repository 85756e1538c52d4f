"""A depth camera on the arm: its interface, its geometry, and a simulated one."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import radians, tan
from typing import Protocol

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.confinement import pane_axes
from helicoide.perception.cloud import PointCloud, cloud_from_rows
from helicoide.perception.rays import ray_to_capsule, ray_to_pane
from helicoide.state import State
from helicoide.text import HelicoideError, Text


class DepthCamera(Protocol):
    """A camera that measures a point cloud from the arm, simulated or real."""

    def cloud(self, state: State) -> PointCloud:
        """The points seen in the posture of the state, base frame."""


@dataclass(frozen=True, eq=False)
class Camera:
    """Geometry of a camera; its x axis points to the right of the picture, y down, z forward.

    T_tool_camera (4, 4), m; view: horizontal and vertical field of view, rad; nearest, farthest: range of measurable
    depths (along z), m; clip: larger depths are dropped, m.
    """

    T_tool_camera: Array
    view: tuple[float, float]
    nearest: float
    farthest: float
    clip: float

    def directions(self, resolution: tuple[int, int]) -> Array:
        """Rays through the centres of the pixels, row by row from the top, (w h, 3), camera frame, each with z = 1."""
        across, down = (
            tan(full / 2) * (np.arange(count) + 0.5 - count / 2) * 2 / count
            for full, count in zip(self.view, resolution, strict=True)
        )
        x, y = np.meshgrid(across, down)
        return np.stack([x.ravel(), y.ravel(), np.ones(x.size)], axis=1)

    def valid_depths(self, depths: Array) -> Array:
        """The depths (k,), m; nan if too near, too far, or clipped."""
        seen = (depths >= self.nearest) & (depths <= min(self.farthest, self.clip))
        return np.where(seen, depths, np.nan)


def hand_camera_pose(behind: float, above: float) -> Array:
    """T_tool_camera (4, 4), m, of a camera that looks along the tool, `behind` its origin and `above` its axis, m."""
    T = np.eye(4)
    T[:3, :3] = [[0, 0, 1], [-1, 0, 0], [0, -1, 0]]
    T[:3, 3] = -behind, 0.0, above
    return frozen(T)


# The field of view and the range are those of the D435, the clip that of Cerbaro 2022, §3.2. The source does not give
# the position of the camera: a bracket behind the gripper, above the wrist, is assumed.
D435 = Camera(
    hand_camera_pose(behind=0.200, above=0.070), (radians(87), radians(58)), nearest=0.3, farthest=3.0, clip=0.7
)


@dataclass(frozen=True, eq=False)
class SimulatedCamera:
    """A camera that sees the panes and obstacles of a state, exactly except for noise and outliers, but not the arm.

    resolution: width and height in pixels; noise: σ of the depth, m; outliers: share of readings that are random within
    the range of the camera; seed: of both, the same seed gives the same cloud.
    """

    camera: Camera = field(default_factory=lambda: D435)
    resolution: tuple[int, int] = (212, 120)
    noise: float = 0.0
    outliers: float = 0.0
    seed: int = 0

    def __post_init__(self) -> None:
        """Raise HelicoideError for impossible values."""
        width, height = self.resolution
        if not (1 <= width <= 1280 and 1 <= height <= 720 and 0 <= self.noise <= 0.1 and 0 <= self.outliers <= 1):
            raise HelicoideError(
                Text(
                    en="A camera has 1 × 1 to 1280 × 720 pixels, noise of 0 to 100 mm and a share of outliers 0 to 1.",
                    pt_BR="Uma câmera tem de 1 × 1 a 1280 × 720 pixels, ruído de 0 a 100 mm e fração de leituras "
                    "erradas de 0 a 1.",
                )
            )

    def cloud(self, state: State) -> PointCloud:
        """The points seen in the posture of the state, base frame; pixels without a depth are counted as dropped."""
        T = state.T_world_tool @ self.camera.T_tool_camera
        rays = self.camera.directions(self.resolution) @ T[:3, :3].T
        depths = self._measured(self.camera.valid_depths(ray_depths(state, T[:3, 3], rays)))
        return cloud_from_rows(T[:3, 3] + depths[:, None] * rays)

    def _measured(self, depths: Array) -> Array:
        """Depths with noise and outliers."""
        rng, camera = np.random.default_rng(self.seed), self.camera
        noisy = depths + self.noise * rng.normal(size=len(depths))
        anywhere = rng.uniform(camera.nearest, min(camera.farthest, camera.clip), len(depths))
        wrong = (rng.random(len(depths)) < self.outliers) & np.isfinite(depths)
        return np.where(wrong, anywhere, noisy)


def ray_depths(state: State, eye: Array, rays: Array) -> Array:
    """Distance to the first pane or obstacle along each ray, in lengths of the ray, (k,); inf if there is none.

    Args: eye (3,), m, world; rays (k, 3), world.
    """
    planes, obstacles = state.problem.planes, state.problem.obstacles
    panes = zip(planes.normals, planes.centres, planes.panes, strict=True)
    nearest = np.full(len(rays), np.inf)
    for normal, centre, pane in panes:
        nearest = np.minimum(nearest, ray_to_pane(eye, rays, centre, pane_axes(normal), pane.size))
    for ends, radius in zip(obstacles.ends, obstacles.radii, strict=True):
        nearest = np.minimum(nearest, ray_to_capsule(eye, rays, ends, float(radius)))
    return nearest
