"""The drawn DH parameters lead from each DH frame to the next, by the convention of the arm."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from tests.kinematics.arms import NAMES, arm, postures

from helicoide.kinematics.dh_parts import dh_parts
from helicoide.kinematics.forward import dh_frames

RADIUS = 0.07


@pytest.mark.parametrize("name", NAMES)
def test_segments_lead_from_frame_to_frame_and_arcs_from_axis_to_axis(name: str) -> None:
    robot = arm(name)
    standard = robot.dh.convention == "standard"
    for q in postures(robot, 5):
        frames = dh_frames(robot, q)
        parts = dh_parts(robot, q, frames, RADIUS)
        for (before, after), theta, d, a, alpha, values in zip(pairwise(frames), *parts, strict=True):
            first, second = (d, a) if standard else (a, d)
            close(first[0], before[:3, 3])
            close(first[1], second[0])
            close(second[1], after[:3, 3])
            z, x = (before[:3, 2], after[:3, 0]) if standard else (after[:3, 2], before[:3, 0])
            close(d[1] - d[0], values[1] * z)
            close(a[1] - a[0], values[2] * x)
            turns = (theta - first[1]) / RADIUS
            close(turns @ z, 0.0)
            close(np.linalg.norm(turns, axis=1), 1.0)
            if standard:
                close(turns[0], before[:3, 0])
            close(turns[-1], after[:3, 0])
            leans = (alpha - (second[1] if standard else first[1])) / RADIUS
            close(leans[0], before[:3, 2])
            close(leans[-1], after[:3, 2])


def test_the_lengths_of_the_movemaster_are_those_of_its_file() -> None:
    robot = arm("movemaster")
    q = robot.poses["ready"]
    parts = dh_parts(robot, q, dh_frames(robot, q), RADIUS)
    close(np.linalg.norm(parts.d[:, 1] - parts.d[:, 0], axis=1), [abs(row.d) for row in robot.dh.rows])
    close(np.linalg.norm(parts.a[:, 1] - parts.a[:, 0], axis=1), [abs(row.a) for row in robot.dh.rows])


def close(one: object, other: object) -> None:
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-9)  # type: ignore[arg-type]
