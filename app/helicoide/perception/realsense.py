"""A RealSense depth camera on the arm, with the optional package pyrealsense2."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from helicoide.arrays import Array
from helicoide.perception.camera import D435, Camera
from helicoide.perception.cloud import PointCloud, cloud_from_rows
from helicoide.state import State
from helicoide.text import HelicoideError, Text

PACKAGE = "pyrealsense2"
# Pictures to skip: until the exposure has settled, depths are missing or wrong.
SETTLING = 30
PATIENCE_MS = 5000
NO_PICTURE = Text(
    en="The RealSense camera sends no picture: check its cable, then connect it again.",
    pt_BR="A câmera RealSense não envia imagem: verifique o cabo e conecte-a de novo.",
)
NO_CAMERA = Text(
    en="No RealSense camera answers with {w} × {h} pixels at {rate} Hz: plug it into a USB 3 port, close other "
    "programs that use it, or ask for 848 × 480 or 640 × 480 at 30 Hz.",
    pt_BR="Nenhuma câmera RealSense responde com {w} × {h} pixels a {rate} Hz: ligue-a a uma porta USB 3, feche outros "
    "programas que a usam, ou peça 848 × 480 ou 640 × 480 a 30 Hz.",
)
NO_PACKAGE = Text(
    en="A RealSense camera needs the package {package}, which cannot be loaded: install it with "
    "`pip install {package}`. Without a camera, use the simulated one or a file of points.",
    pt_BR="Uma câmera RealSense precisa do pacote {package}, que não pôde ser carregado: instale-o com "
    "`pip install {package}`. Sem câmera, use a simulada ou um arquivo de pontos.",
)


def installed() -> bool:
    """Whether the package is installed."""
    return PACKAGE in sys.modules or importlib.util.find_spec(PACKAGE) is not None


class RealSense:
    """An open camera; `cloud` is that of `camera.DepthCamera`."""

    def __init__(self, package: Any, pipeline: Any, camera: Camera) -> None:
        self._package, self._pipeline, self._camera = package, pipeline, camera

    def cloud(self, state: State) -> PointCloud:
        """The points of the next picture, base frame; pixels without a depth in reach are counted as dropped.

        Raises HelicoideError when no picture comes, as from a camera that was pulled out.
        """
        T = state.T_world_tool @ self._camera.T_tool_camera
        self.points_in_view()  # discard one picture, which may date from before the arm came to rest
        seen = self.points_in_view()
        points = T[:3, 3] + seen @ T[:3, :3].T
        points[np.isnan(self._camera.valid_depths(seen[:, 2]))] = np.nan
        return cloud_from_rows(points)

    def points_in_view(self) -> Array:
        """The points of the next picture, camera frame, (k, 3), m; zero where there is no depth."""
        try:
            depths = self._pipeline.wait_for_frames(PATIENCE_MS).get_depth_frame()
            vertices = self._package.pointcloud().calculate(depths).get_vertices()
        except RuntimeError as error:
            raise HelicoideError(NO_PICTURE) from error
        return np.asarray(np.asanyarray(vertices).view(np.float32).reshape(-1, 3), dtype=np.float64)


@contextmanager
def connected(camera: Camera = D435, resolution: tuple[int, int] = (848, 480), rate: int = 30) -> Iterator[RealSense]:
    """The first connected RealSense camera, which streams depths until the block ends.

    camera: its pose and clipping; resolution: pixels; rate: pictures a second. Raises HelicoideError if the package or
    the camera is missing, or the camera has no such resolution.
    """
    package = _package()
    pipeline, config = package.pipeline(), package.config()
    config.enable_stream(package.stream.depth, *resolution, package.format.z16, rate)
    try:
        pipeline.start(config)
    except RuntimeError as error:
        raise HelicoideError(NO_CAMERA.format(w=resolution[0], h=resolution[1], rate=rate)) from error
    try:
        sensor = RealSense(package, pipeline, camera)
        for _ in range(SETTLING):
            sensor.points_in_view()
        yield sensor
    finally:
        pipeline.stop()


def _package() -> Any:
    try:
        return importlib.import_module(PACKAGE)
    except ImportError as error:
        raise HelicoideError(NO_PACKAGE.format(package=PACKAGE)) from error
