"""What the source's shortcut overlooks: the adaptation of Cerbaro 2022, section 6.1, guarded by it alone."""

from __future__ import annotations

import numpy as np
import pytest
from tests.ik.secondary_runs import DAMPED, chosen, position, problem, standing

from helicoide.confinement import Zones, distances, planes_of, watched_by_source
from helicoide.ik import Problem
from helicoide.ik.clik import followed
from helicoide.ik.limit_gains import clipped
from helicoide.ik.secondary import push
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.robot import Robot
from helicoide.state import points_on
from helicoide.trajectory import Ellipse

CIRCLE = Ellipse(centre=(0.48, 0.1, 0.2), radii=(0.22, 0.22, 0), pitch=0, roll=0)
ZONES = Zones()
CEILING, LEFT, WRIST, TOOL = 0, 1, 3, 4
STEP, DT = 0.5, 1e-3


@pytest.fixture(scope="module")
def arm() -> Problem:
    return problem("movemaster", scale=1e-3)


def table(arm: Problem, q: Array) -> Array:
    """Every point against every plane of the file, (5, 4), m."""
    planes, points = planes_of(arm.robot.panes), points_on(arm.robot, link_poses(arm.robot.chain, q))
    return distances(planes.normals, planes.offsets, points)


def trimmed(arm: Problem, point: Array) -> Array:
    """The point, or where the tool is at the warning distance from the walls and the bench."""
    planes = planes_of(arm.robot.panes)
    for normal, offset in zip(planes.normals[1:], planes.offsets[1:], strict=True):
        point = point + max(0.0, ZONES.warning - (normal @ point - offset)) * normal
    return point


def converged(arm: Problem, q: Array, gains: Array, point: Array) -> tuple[Array, Array]:
    """Step 3: to within 1 mm, under Algorithm 1."""
    aiming, limits = position(arm, standing(*point)), arm.limits
    for _ in range(300):
        pushed = push(arm, chosen("limit_distance"), gains)
        moment = next(followed(arm, DAMPED, DAMPED.Options(0.1), aiming, STEP / DT, q, DT, pushed))
        if np.linalg.norm(moment.aim.error) * arm.length < 1e-3:
            return q, gains
        q, gains = clipped(q + arm.joint_units * moment.solution.rates * DT, limits.lower, limits.upper, gains)
    raise AssertionError(f"{point} is not reached")


def along_the_circle(arm: Problem, samples: int) -> list[Array]:
    """Tables of the first samples of 601 (experiment 3, case 3), where the ceiling alone is kept from all points."""
    ceiling = planes_of(arm.robot.panes).normals[CEILING]
    q, gains, before, found = arm.robot.poses["home"], np.full(5, 500.0), None, []
    for s in np.linspace(0, CIRCLE.period, 601)[:samples]:
        point = trimmed(arm, CIRCLE.point(s))
        if before is not None and table(arm, q)[:, CEILING].min() < ZONES.warning:
            point = point - min(0.0, float((point - before) @ ceiling)) * ceiling
        q, gains = converged(arm, q, gains, point)
        while (least := table(arm, q)[:, CEILING].min()) < ZONES.critical:
            point = point + (1.1 * ZONES.critical - least) * ceiling
            q, gains = converged(arm, q, gains, point)
        before = point
        found.append(table(arm, q))
    return found


def test_the_shortcut_lets_the_wrist_near_a_wall(arm: Problem) -> None:
    """All that the source looks at keeps 80 mm, and yet the folded wrist is at 35 to 41 mm."""
    tables = along_the_circle(arm, 61)
    seen = watched_by_source(planes_of(arm.robot.panes).normals, len(tables[0]))
    assert min(found[seen].min() for found in tables) >= ZONES.critical
    assert min(found[TOOL, LEFT] for found in tables) >= ZONES.warning
    wrist = min(found[WRIST, LEFT] for found in tables)
    assert 0.035 < wrist < 0.041
    assert min(found.min() for found in tables) == wrist


def test_it_watches_all_points_under_the_ceiling_and_the_tool_elsewhere(robot: Robot) -> None:
    seen = watched_by_source(planes_of(robot.panes).normals, len(robot.guarded))
    assert seen.tolist() == [[True, False, False, False]] * 4 + [[True] * 4]
