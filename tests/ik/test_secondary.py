"""Objectives at work: in the null space (Cerbaro 2022, §4.4) and as a row of the task (Vargas 2013, §4.7).

The simulations of Vargas 2013 are studies: tests/studies/test_vargas.py.
"""

from __future__ import annotations

from itertools import islice

import numpy as np
import pytest
from tests.ik.secondary_runs import PINV, chosen, collected, fixed_point, position_task, problem, tool_position

from helicoide.arrays import Array, frozen
from helicoide.ik import objectives
from helicoide.ik.arm_points import watched
from helicoide.ik.clik import ControlLaw, closed_loop, solve_with_null_space, task_from, to_pose
from helicoide.ik.methods import configured_method
from helicoide.ik.objective import posture_at
from helicoide.ik.secondary import augmented, push, total
from helicoide.kinematics.forward import link_poses
from helicoide.studies.cerbaro_runs.setups import heading_task, movemaster
from helicoide.studies.vargas.arms import planar_problem
from helicoide.studies.vargas.paths import path_1
from helicoide.text import HelicoideError

# In the null space.


@pytest.mark.parametrize("name", objectives.names())
@pytest.mark.parametrize("robot_name", ["movemaster", "planar3r", "dia10", "scara", "puma560"])
def test_the_task_does_not_feel_an_objective(robot_name: str, name: str) -> None:
    """J (I − J† J) q̇₀ = 0."""
    here = problem(robot_name)
    others = frozen(np.random.default_rng(6).normal(size=(3, 3)) * here.robot.reach)
    pushed = push(here, chosen(name), 3.0, lambda t: others)
    q = here.robot.poses["ready"] + 0.05
    aim = position_task(here, fixed_point(0.3, 0.2, 0.3))(q, 0.0)
    task = task_from(aim, 1.0, q, 0.01)
    with_it, _ = solve_with_null_space(here, PINV, task, None, pushed(q, 0.0))
    without, _ = solve_with_null_space(here, PINV, task, None)
    np.testing.assert_allclose(task.J @ (with_it.rates - without.rates), 0, rtol=0, atol=1e-12)


BESIDE = np.array([0.06, 0.08, 0.02])
GAINS = {"manipulability": 2.0, "limit_distance": 20.0, "obstacle_distance": 0.1}


@pytest.mark.parametrize(
    ("robot_name", "pose", "elbow"), [("orca", "example", 2), ("movemaster", "example", 2), ("dia10", "start", 4)]
)
@pytest.mark.parametrize("name", GAINS)
def test_what_is_wanted_grows_while_the_tool_stands_still(robot_name: str, pose: str, elbow: int, name: str) -> None:
    """Cerbaro 2022, eqs. 11–13: w grows and the tool moves by less than 0.01 mm.

    The obstacle stands beside a joint in the middle of the arm.
    """
    here = problem(robot_name)
    q = here.robot.poses[pose]
    x, y, z = watched(here.robot, "guarded").at(link_poses(here.robot.chain, q))[elbow] / here.length + BESIDE
    some = chosen(name, x=x, y=y, z=z) if name == "obstacle_distance" else chosen(name)
    aiming = position_task(here, fixed_point(*tool_position(here, q)))
    moments = closed_loop(here, ControlLaw(PINV, 90.0, 0.01), aiming, q, push(here, some, GAINS[name]))
    way = [moment.q for moment in islice(moments, 300)]
    w = np.array([-total(here, some, posture_at(here, one)).value for one in way])
    assert w[-1] > w[0] + 3e-4
    assert np.diff(w).min() > -1e-9
    assert max(np.linalg.norm(tool_position(here, one) - tool_position(here, q)) for one in way) < 1e-5


def test_several_objectives_are_summed() -> None:
    here = movemaster()
    at = posture_at(here, here.robot.poses["example"])
    first, second = chosen("limit_distance"), chosen("manipulability")
    one, other, both = (total(here, some, at) for some in (first, second, [*first, *second]))
    assert both.value == one.value + other.value
    np.testing.assert_array_equal(both.gradient, one.gradient + other.gradient)
    nothing = total(here, [], at)
    assert nothing.value == 0
    np.testing.assert_array_equal(nothing.gradient, np.zeros(5))


def test_the_push_knows_where_the_second_arm_is_now() -> None:
    here, some = problem("puma560"), chosen("second_arm", radius=0.5)
    q = here.robot.poses["ready"]

    def others(t: float) -> Array:
        return np.array([[0.3, 0.1 * t, 0.2]])

    pushed = push(here, some, 2.0, others)
    for t in (0.0, 3.0):
        expected = -2 * total(here, some, posture_at(here, q, others(t))).gradient
        np.testing.assert_allclose(pushed(q, t), expected, rtol=1e-14)
    assert np.abs(pushed(q, 3.0) - pushed(q, 0.0)).max() > 1e-3


# As a row of the task.


def test_the_row_asks_for_minus_f_whatever_the_gains() -> None:
    here = planar_problem()
    some = chosen("slab", azimuth=np.pi / 2, elevation=0.0, offset=0.0, half=0.3)
    q = np.array([0.2, 0.3, 0.1])
    plain, f = position_task(here, path_1, 2), total(here, some, posture_at(here, q))
    aim = augmented(here, some, plain)(q, 1.0)
    np.testing.assert_array_equal(aim.J, np.vstack([plain(q, 1.0).J, f.gradient]))
    for gains, of_plain in ((5.0, 5.0), (np.array([3.0, 7.0, 1.0]), np.array([3.0, 7.0]))):
        task = task_from(aim, gains, q, 0.01)
        np.testing.assert_array_equal(task.rate, [*task_from(plain(q, 1.0), of_plain, q, 0.01).rate, -f.value])


@pytest.mark.parametrize("name", sorted(set(objectives.names()) - {"ellipsoid", "joint_barrier", "second_arm", "slab"}))
def test_what_does_not_rest_at_zero_cannot_be_a_row(name: str) -> None:
    with pytest.raises(HelicoideError, match="null space"):
        augmented(planar_problem(), chosen(name), position_task(planar_problem(), path_1))


@pytest.mark.parametrize("name", ["pseudoinverse", "damped", "filtered_modified"])
def test_where_f_is_flat_the_law_is_the_plain_one(name: str) -> None:
    """J_f = 0, f = 0: an obstacle far away. Also with more rows than joints."""
    here, law = planar_problem(), ControlLaw(configured_method(name), 5.0, 0.01)
    far = chosen("ellipsoid", x=90.0, y=90.0, z=90.0)
    for plain in (position_task(here, path_1, 2), heading_task(here, path_1)):
        runs = [
            collected(closed_loop(here, law, aiming, np.array([0.5, -0.8, 0.9])), 0.5)
            for aiming in (plain, augmented(here, far, plain))
        ]
        np.testing.assert_allclose(runs[1].q, runs[0].q, rtol=0, atol=1e-9)


def test_with_more_rows_than_joints_the_obstacle_is_traded_against_the_pose() -> None:
    """x, y, φ and f of a planar 3R: the tool keeps farther from an obstacle at its goal, at the price of the pose."""
    here = planar_problem()
    q = np.array([0.5, -0.8, 0.9])
    goal = to_pose(here, link_poses(here.robot.chain, q)[-1] @ here.robot.T_link_tool)
    x, y, _ = tool_position(here, q) + np.array([0.05, 0, 0])
    hill = chosen("ellipsoid", x=x, y=y, z=0.0, a=0.2, b=0.2, c=0.2, where="tool")
    law = ControlLaw(configured_method("filtered_modified", gain=5.0), 5.0, 0.01)
    run = collected(closed_loop(here, law, augmented(here, hill, goal), q), 10.0)
    clearance = [np.linalg.norm(tool_position(here, one) - [x, y, 0]) for one in run.q]
    assert clearance[0] == pytest.approx(0.05)
    assert clearance[-1] > 0.15
    assert run.position_error[-1] > 0.1
