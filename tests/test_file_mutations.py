"""Mutated files of robots, planes and waypoints are read, or refused with a reason, in limited time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.mutated import hold
from tests.trajectory.taught import taught

from helicoide import content
from helicoide.confinement import plane_file, planes_of
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.trajectory.waypoint_file import decode_waypoints, encode_waypoints

MOVEMASTER = load_robot("movemaster")
ROBOTS = ("movemaster", "planar3r", "scara", "dia10_rod")
GOOD = {
    "robots": [(content.SHIPPED / "robots" / name / "robot.toml").read_text("utf-8") for name in ROBOTS],
    "planes": [plane_file.encode_planes([pane.name for pane in MOVEMASTER.panes], planes_of(MOVEMASTER.panes))],
    "waypoints": [encode_waypoints(taught("movemaster")).decode()],
}


def reader(kind: str, folder: Path) -> Callable[[bytes], object]:
    """The reader of a kind of file, which also checks that all numbers are finite."""

    def robot(content: bytes) -> None:
        (folder / "robot.toml").write_bytes(content)
        arm = robot_from_folder(folder)
        for numbers in (arm.lower, arm.upper, arm.speed, arm.T_world_tool_0, arm.monitored_points, *arm.poses.values()):
            assert np.isfinite(numbers).all()
        for joint in arm.joints:
            assert np.isclose(np.linalg.norm(joint.direction), 1.0)

    def planes(content: bytes) -> None:
        _, found = plane_file.decode_planes(content, "planes.toml")
        assert np.allclose(np.linalg.norm(found.normals, axis=1), 1.0)
        assert np.isfinite(found.centres).all()

    def waypoints(content: bytes) -> None:
        assert all(np.isfinite(point.q).all() for point in decode_waypoints(content, MOVEMASTER).waypoints)

    return {"robots": robot, "planes": planes, "waypoints": waypoints}[kind]


@pytest.mark.parametrize(
    ("count", "seed"), [(1000, 1), *(pytest.param(10_000, seed, marks=pytest.mark.soak) for seed in range(2, 7))]
)
@pytest.mark.parametrize("kind", GOOD)
@pytest.mark.filterwarnings("error")
def test_a_file_that_has_gone_wrong_is_read_or_refused(tmp_path: Path, kind: str, count: int, seed: int) -> None:
    values, refusals = hold(reader(kind, tmp_path), GOOD[kind], count, seed)
    assert min(values, refusals) > count // 50
