"""Objectives at work: in the null space (Cerbaro 2022, §4.4) and as a row of the task (Vargas 2013, §4.7)."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest
from tests.ik.secondary_runs import PINV, PLAIN, chosen, position, problem, ran, standing, tool
from tests.ik.vargas_runs import barrier, in_a_slab, obstacle_at_the_links, obstacle_at_the_tool, planar, two_arms, wave

from helicoide.ik import methods, objectives
from helicoide.ik.arm_points import watched
from helicoide.ik.clik import answered, asked, followed, to_pose
from helicoide.ik.objective import posture
from helicoide.ik.secondary import augmented, augmented_gains, push, total
from helicoide.kinematics.chain import Array, frozen
from helicoide.kinematics.forward import link_poses
from helicoide.studies.cerbaro_runs.arms import movemaster, with_heading
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
    aim = position(here, standing(0.3, 0.2, 0.3))(q, 0.0)
    task = asked(aim, 1.0, q, 0.01)
    with_it, _ = answered(here, PINV, task, None, PLAIN, pushed(q, 0.0))
    without, _ = answered(here, PINV, task, None, PLAIN)
    np.testing.assert_allclose(task.J @ (with_it.rates - without.rates), 0, rtol=0, atol=1e-12)


BESIDE = np.array([0.06, 0.08, 0.02])
GAINS = {"manipulability": 2.0, "limit_distance": 20.0, "obstacle_distance": 0.1}


@pytest.mark.parametrize(
    ("robot_name", "pose", "elbow"), [("orca", "example", 2), ("movemaster", "example", 2), ("dia10", "start", 4)]
)
@pytest.mark.parametrize("name", GAINS)
def test_what_is_wanted_grows_while_the_tool_stands_still(robot_name: str, pose: str, elbow: int, name: str) -> None:
    """Cerbaro 2022, eqs. 11–13; digest §7: w grows and the tool moves by less than 0.01 mm.

    The obstacle stands beside a joint in the middle of the arm.
    """
    here = problem(robot_name)
    q = here.robot.poses[pose]
    x, y, z = watched(here.robot, "guarded").at(link_poses(here.robot.chain, q))[elbow] / here.length + BESIDE
    some = chosen(name, x=x, y=y, z=z) if name == "obstacle_distance" else chosen(name)
    aiming = position(here, standing(*tool(here, q)))
    moments = followed(here, PINV, PLAIN, aiming, 90.0, q, 0.01, push(here, some, GAINS[name]))
    way = [moment.q for moment in islice(moments, 300)]
    w = np.array([-total(here, some, posture(here, one)).value for one in way])
    assert w[-1] > w[0] + 3e-4
    assert np.diff(w).min() > -1e-9
    assert max(np.linalg.norm(tool(here, one) - tool(here, q)) for one in way) < 1e-5


def test_several_objectives_are_summed() -> None:
    here = movemaster()
    at = posture(here, here.robot.poses["example"])
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
        expected = -2 * total(here, some, posture(here, q, others(t))).gradient
        np.testing.assert_allclose(pushed(q, t), expected, rtol=1e-14)
    assert np.abs(pushed(q, 3.0) - pushed(q, 0.0)).max() > 1e-3


# As a row of the task.


def test_the_row_asks_for_minus_f_whatever_the_gains() -> None:
    here = planar()
    some = chosen("slab", azimuth=np.pi / 2, elevation=0.0, offset=0.0, half=0.3)
    q = np.array([0.2, 0.3, 0.1])
    plain, f = position(here, wave, 2), total(here, some, posture(here, q))
    aim = augmented(here, some, plain)(q, 1.0)
    np.testing.assert_array_equal(aim.J, np.vstack([plain(q, 1.0).J, f.gradient]))
    by_rows = np.array([3.0, 7.0])
    for gains in (5.0, by_rows):
        task = asked(aim, augmented_gains(gains), q, 0.01)
        np.testing.assert_array_equal(task.rate, [*asked(plain(q, 1.0), gains, q, 0.01).rate, -f.value])


@pytest.mark.parametrize("name", sorted(set(objectives.names()) - {"ellipsoid", "joint_barrier", "second_arm", "slab"}))
def test_what_does_not_rest_at_zero_cannot_be_a_row(name: str) -> None:
    with pytest.raises(HelicoideError, match="null space"):
        augmented(planar(), chosen(name), position(planar(), wave))


@pytest.mark.parametrize("name", ["pseudoinverse", "damped", "filtered_modified"])
def test_where_f_is_flat_the_law_is_the_plain_one(name: str) -> None:
    """J_f = 0, f = 0: an obstacle far away. Also with more rows than joints."""
    here, method = planar(), methods.named(name)
    far = chosen("ellipsoid", x=90.0, y=90.0, z=90.0)
    for plain in (position(here, wave, 2), with_heading(here, wave)):
        runs = [
            ran(followed(here, method, method.Options(), aiming, 5.0, np.array([0.5, -0.8, 0.9]), 0.01), 0.5)
            for aiming in (plain, augmented(here, far, plain))
        ]
        np.testing.assert_allclose(runs[1].q, runs[0].q, rtol=0, atol=1e-9)


def test_with_more_rows_than_joints_the_obstacle_is_traded_against_the_pose() -> None:
    """x, y, φ and f of a planar 3R: the tool keeps farther from an obstacle at its goal, at the price of the pose."""
    here = planar()
    q = np.array([0.5, -0.8, 0.9])
    goal = to_pose(here, link_poses(here.robot.chain, q)[-1] @ here.robot.T_link_tool)
    x, y, _ = tool(here, q) + np.array([0.05, 0, 0])
    hill = chosen("ellipsoid", x=x, y=y, z=0.0, a=0.2, b=0.2, c=0.2, where="tool")
    method = methods.named("filtered_modified")
    options = replace(method.Options(), gain=5.0)
    run = ran(followed(here, method, options, augmented(here, hill, goal), 5.0, q, 0.01), 10.0)
    clearance = [np.linalg.norm(tool(here, one) - [x, y, 0]) for one in run.q]
    assert clearance[0] == pytest.approx(0.05)
    assert clearance[-1] > 0.15
    assert run.error[-1] > 0.1


# Vargas 2013, Sims. 15, 16 and figs. 4.42–4.44 with the modified law; digest §6.7, with steps of
# 10 ms; with those of the digest in the soak tests.


@pytest.mark.parametrize(
    ("half", "lowest", "highest", "error", "speed"),
    [(None, -1.623, -1.121, 2e-4, 0.097), (0.5, -1.290, -0.590, 5e-4, 0.144), (0.2, -1.156, -0.843, 0.055, 0.474)],
)
def test_a_joint_is_kept_in_its_range(
    half: float | None, lowest: float, highest: float, error: float, speed: float
) -> None:
    run = barrier(half, 1e-2)
    late = run.since(3.0)
    assert (late.q[:, 1].min(), late.q[:, 1].max()) == pytest.approx((lowest, highest), abs=1.5e-3)
    assert late.error.max() == pytest.approx(error, abs=2e-4)
    assert late.fastest.max() == pytest.approx(speed, abs=4e-3)
    if half is not None:
        assert np.abs(run.q[:, 1] + 1).max() < half


@pytest.mark.parametrize(("weight", "closest", "error"), [(1.0, 0.294, 0.046), (10.0, 0.399, 0.152)])
def test_the_tool_goes_round_an_obstacle(weight: float, closest: float, error: float) -> None:
    found = obstacle_at_the_tool(weight, 1e-2)
    assert found == pytest.approx((closest, error), abs=1.2e-3)


def test_the_links_make_way_for_an_obstacle() -> None:
    """Eight points on a link see it, one does not."""
    mu = (0.6, 1.15)
    assert obstacle_at_the_links(mu, 0, 1e-2, 16)[0] == pytest.approx(0.084, abs=1e-3)
    distance, error = obstacle_at_the_links(mu, 8, 1e-2, 16)
    assert distance == pytest.approx(0.413, abs=2e-3)
    assert error == pytest.approx(0.0075, abs=3e-4)
    assert obstacle_at_the_links(mu, 1, 1e-2, 16)[0] == pytest.approx(0.084, abs=1e-3)


def test_a_second_arm_is_given_way() -> None:
    """Without the term they touch; with it they do not. The figures of the digest are in the soak tests."""
    assert two_arms(0.0, 1e-2, 16)[0] < 0.02
    assert two_arms(5.0, 5e-3, 16)[0] > 0.1


@pytest.mark.parametrize(
    ("weight", "steepness", "widest", "at_start"),
    [(5.0, 10, 0.249, 0.249), (5.0, 3, 0.178, 0.198)],
)
def test_the_tool_stays_in_a_slab(weight: float, steepness: int, widest: float, at_start: float) -> None:
    y, run = in_a_slab(weight, steepness, 1e-2, 17)
    assert np.abs(y[run.t >= 3]).max() == pytest.approx(widest, abs=6e-4)
    assert np.abs(y).max() == pytest.approx(at_start, abs=6e-4)
