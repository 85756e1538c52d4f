"""An arm in a notebook: three formulations agree, every posture reaches its pose, the numbers are those of the lab."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from tests.kinematics.arms import MIXED, NAMES

import helicoide
from helicoide import readout
from helicoide.geometry import rigid
from helicoide.ik.postures.branch import between, tool_at
from helicoide.kinematics.library import load_robot
from helicoide.state import initial_state
from helicoide.teaching.arm import TeachingArm
from helicoide.text import HelicoideError

ROBOTS = [name for name in NAMES if name != MIXED]


@pytest.fixture(scope="module")
def movemaster() -> TeachingArm:
    return helicoide.robot("movemaster", "en")


@pytest.mark.parametrize("name", ROBOTS)
def test_formulations_agree_and_stand_side_by_side(name: str) -> None:
    here = helicoide.robot(name, "en").at("ready")
    for T in (here.forward.dh, here.forward.screws, helicoide.pose(here.forward.motor)):
        np.testing.assert_allclose(T, here.T, atol=1e-9)
    assert here.forward.difference < 1e-9
    page = here.forward._repr_html_()
    assert all(page.count(joint.name) == 1 for joint in here.state.robot.joints)
    assert all(len(here.forward.stages(kind)) == len(here.state.robot.joints) for kind in ("dh", "screws", "products"))


@pytest.mark.parametrize("name", ROBOTS)
def test_the_jacobian_is_the_derivative_of_the_position(name: str) -> None:
    arm, h = helicoide.robot(name, "en"), 1e-6
    here = arm.at("ready")
    for i, step in enumerate(h * np.eye(len(here.q))):
        ahead, back = arm.at(here.q + step).T[:3, 3], arm.at(here.q - step).T[:3, 3]
        np.testing.assert_allclose((ahead - back) / (2 * h), here.J[:3, i], atol=1e-6)


def test_every_posture_reaches_the_pose() -> None:
    arm = helicoide.robot("puma560", "en")
    here = arm.at("ready")
    found = arm.inverse(here.motor)
    assert len(found) == 8
    for branch in found:
        missed, turned = between(tool_at(arm.robot, branch.q), here.T)
        assert max(missed, turned) < 1e-9
    np.testing.assert_allclose(found[0].q, here.q, atol=1e-9)
    page = found._repr_html_()
    assert page.count("<tr>") == 9
    assert all(branch.name.en in page and branch.name.en in repr(found) for branch in found)
    assert [branch.name for branch in arm.inverse(here.T, by="screws")[:2]]


def test_a_position_alone_and_a_pose_out_of_reach(movemaster: TeachingArm) -> None:
    here = movemaster.at("ready")
    turned = helicoide.motor(here.T) * helicoide.rotor((1, 0, 0), 1.0)
    assert movemaster.inverse(turned, orientation=False)[0].missed < 1e-6
    away = here.T.copy()
    away[0, 3] += 5.0
    assert "out of reach" in repr(movemaster.inverse(away))


def test_the_numbers_are_those_of_the_lab(movemaster: TeachingArm) -> None:
    state, here = initial_state(load_robot("movemaster")), movemaster.at("ready")
    np.testing.assert_array_equal(here.motor.values, rigid.canonical(rigid.motor_from_pose(state.T_world_tool)))
    for i, axis in enumerate(state.axes):
        line = rigid.line(axis, state.arm.poses[i + 1, :3, 3])
        np.testing.assert_array_equal(here.multivectors[f"L{i + 1}"].values, line)
    assert here.instruments == {one.symbol: one.value for one in readout.instruments(state)}
    np.testing.assert_array_equal(here.distances, readout.plane_distances(state))
    np.testing.assert_allclose(here.quaternion @ here.quaternion, 1.0)


def test_planes_of_ones_own_and_a_target(movemaster: TeachingArm) -> None:
    here = movemaster.at("ready", {"roof": helicoide.plane((0, 0, -2), -0.8)})
    points = [helicoide.point(*point) for point in here.state.monitored_points]
    expected = [helicoide.distance(here.multivectors["roof"], point) for point in points]
    np.testing.assert_allclose(here.distances[:, 0], expected, atol=1e-12)
    there = here.towards(helicoide.translator((0, 0, 0.05)) * here.motor, "damped", {"damping": 0.2})
    assert there.instruments["e_p"] == pytest.approx(50.0)
    assert there.state.request.controller.options("damped").damping == 0.2
    assert here.instruments["e_p"] == 0.0


def test_an_arm_among_obstacles_goes_to_its_target(movemaster: TeachingArm) -> None:
    here = movemaster.at("ready")
    ball = helicoide.point(0.5, 0.5, 0.5)
    scene = here.among([(ball, 0.05), ((0.5, -0.5, 0.5), 0.07)], zones=(0.08, 0.12))
    np.testing.assert_allclose(scene.state.problem.obstacles.ends[:, 0], [[0.5, 0.5, 0.5], [0.5, -0.5, 0.5]])
    assert here.state.problem.obstacles.radii.size == 0
    there = scene.towards(helicoide.translator((0, 0, 0.03)) * here.motor, "damped").with_gains(4, 4, 4, 4)
    assert scene.among().state.problem.obstacles.radii.size == 0
    assert there.after(4).instruments["e_p"] < 0.5 < there.after(0.1).instruments["e_p"]
    np.testing.assert_array_equal(there.after(0).q, here.q)
    np.testing.assert_array_equal(there.after(0.05).after(0.05).q, there.after(0.1).q)


def test_lengths_are_parameters() -> None:
    arm = helicoide.robot("planar3r", "en", parameters={"l1": 1500})
    assert arm.robot.parameters["l1"] == 1.5


def test_tables_follow_the_language() -> None:
    arm = helicoide.robot("movemaster", "pt_BR")
    assert "junta" in arm._repr_html_()
    assert "0,0000" in arm.at("ready").forward._repr_html_()
    assert "alcançado" in arm.inverse(arm.at("ready").T)._repr_html_()
    assert "3R" in repr(helicoide.robot("planar3r", "pt_BR"))


@pytest.mark.parametrize(
    ("bad", "said"),
    [
        (lambda arm: arm.at("nowhere"), "postures: home, ready"),
        (lambda arm: arm.at([0.0, np.nan, 0, 0, 0]), "5 finite joint values"),
        (lambda arm: arm.at([0.0]), "5 finite joint values"),
        (lambda arm: arm.at("ready", {"A": helicoide.point(0, 0, 0)}), "is no plane"),
        (lambda arm: arm.at("ready").towards(np.full((4, 4), np.inf)), "4 × 4 pose"),
        (lambda arm: arm.at("ready").towards(np.eye(4), "magic"), "there is: damped"),
        (lambda arm: arm.at("ready").towards(np.eye(4), "damped", {"x": 1}), "settings: "),
        (lambda arm: arm.at("ready").among([((0, 0, np.nan), 0.1)]), "3 finite numbers"),
        (lambda arm: arm.at("ready").among([((0, 0, 1), -0.1)]), "radius is positive"),
        (lambda arm: arm.at("ready").among([((0, 0, 1), np.inf)]), "1 finite numbers"),
        (lambda arm: arm.at("ready").among(entry=(0, 0, 1)), "no frame rcm"),
        (lambda arm: arm.at("ready").among(zones=(0.01, 0.02)), "safety distance"),
        (lambda arm: arm.at("ready").among(zones=(0.01, np.nan)), "finite"),
        (lambda arm: arm.at("ready").with_gains(1, 2, 3, 1e9), "Gains 1 to 4"),
        (lambda arm: arm.at("ready").with_gains(1, 2, 3, np.nan), "finite"),
        (lambda arm: arm.at("ready").with_objective("magic"), "manipulability"),
        (lambda arm: arm.at("ready").with_objective("manipulability", {"x": 1}), "settings"),
        (lambda arm: arm.at("ready").with_objective("manipulability", weight=-1), "weight"),
        (lambda arm: arm.at("ready").after(np.nan), "finite"),
        (lambda arm: arm.at("ready").after(1e9), "600 seconds"),
        (lambda arm: arm.at("ready").after(-1), "600 seconds"),
        (lambda arm: arm.inverse(np.eye(3)), "4 × 4 pose"),
        (lambda arm: arm.inverse(np.eye(4), by="magic"), "Forms for movemaster"),
        (lambda arm: helicoide.robot("magic"), "movemaster"),
    ],
)
def test_what_is_wrong_is_refused_in_words(
    movemaster: TeachingArm, bad: Callable[[TeachingArm], object], said: str
) -> None:
    with pytest.raises(HelicoideError) as refusal:
        bad(movemaster)
    assert said in refusal.value.text.en
    assert refusal.value.text.pt_BR
