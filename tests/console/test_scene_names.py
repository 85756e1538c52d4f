"""The names of the scene: identifiers made of any names, and values that agree with the state, all arms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.console.lines import numbers, results, value
from tests.hostile import NAMES

from helicoide import gate
from helicoide.arrays import frozen
from helicoide.command import MoveToPose
from helicoide.confinement import plane_file
from helicoide.console import free_names, scene_names
from helicoide.console.names import is_reserved
from helicoide.geometry import rigid, rotation
from helicoide.kernels import python_function
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.sheet import Sheet, SheetLine
from helicoide.state import State, initial_state, with_command


def moved(state: State, seed: int) -> State:
    """The arm in a posture at random within its limits."""
    robot = state.robot
    q = frozen(np.random.default_rng(seed).uniform(robot.lower, robot.upper))
    poses = frozen(python_function(link_poses)(robot.chain, q))
    return replace(state, arm=replace(state.arm, q=q, poses=poses))


@pytest.mark.parametrize("name", robot_titles())
def test_the_names_of_every_arm_are_what_the_state_says(name: str) -> None:
    state = moved(initial_state(load_robot(name)), 4)
    T = state.T_world_tool
    np.testing.assert_allclose(numbers("M_tool >> point(0,0,0)", state=state), rigid.point(T[:3, 3]), atol=1e-12)
    np.testing.assert_allclose(numbers("q_tool", state=state), rotation.from_matrix(T[:3, :3]), atol=1e-12)
    for i in range(len(state.robot.joints)):
        line = rigid.line(state.axes[i], state.arm.poses[i + 1, :3, 3])
        np.testing.assert_allclose(numbers(f"L{i + 1}", state=state), line, atol=1e-12)
        origin = numbers(f"M_link{i + 1} >> point(0,0,0)", state=state)
        np.testing.assert_allclose(origin, rigid.point(state.arm.poses[i + 1, :3, 3]), atol=1e-12)
    for k, q in enumerate(state.arm.q):
        assert value(f"theta{k + 1}", state=state) == q
    assert results(f"theta{len(state.arm.q) + 1}", state=state)[0].error is not None


def test_points_and_planes_have_their_own_names(state: State) -> None:
    assert {"elbow", "wrist", "tool", "ceiling", "left_wall", "bench", "target", "M_target"} <= scene_names(
        state
    ).keys()
    planes = state.problem.planes
    expected = rigid.plane(planes.normals[0], planes.offsets[0])
    np.testing.assert_allclose(numbers("ceiling", state=state), expected)
    np.testing.assert_allclose(numbers("elbow", state=state), rigid.point(state.monitored_points[2]))


@pytest.mark.parametrize("name", [*NAMES, "", "north wall", "north-wall", "pi", "e1", "join", "L1", "+z", "9", "á b"])
def test_any_name_of_a_plane_becomes_an_identifier(state: State, name: str) -> None:
    planes = state.problem.planes
    two = replace(planes, normals=planes.normals[:2], centres=planes.centres[:2])
    file = plane_file.encode_planes([name, "a plane"], two)
    scene = gate.take_planes_of(file.encode(), "file")(state)
    names = scene_names(scene)
    assert len(names) == len(scene_names(state)) + len(scene.problem.planes.panes) - len(planes.panes)
    for one in names:
        assert one.isidentifier()
        assert one.isascii()
        assert not is_reserved(one)
        assert results(one, state=scene)[0].error is None


def test_a_definition_hides_a_name_of_the_scene_below_it(state: State) -> None:
    first, _, second = results("elbow", "elbow = 3", "elbow", state=state)
    assert first.value != 3
    assert second.value == 3


def test_the_target_is_where_it_was_asked_for(state: State) -> None:
    T = rigid.pose_from_motor(rigid.translator([0.3, 0.1, 0.2]))
    asked = with_command(state, MoveToPose(frozen(T)))
    np.testing.assert_allclose(numbers("target", state=asked), rigid.point([0.3, 0.1, 0.2]), atol=1e-12)
    np.testing.assert_allclose(numbers("M_target", state=asked), rigid.translator([0.3, 0.1, 0.2]), atol=1e-12)


def test_free_names_are_those_that_nothing_defines(state: State) -> None:
    lines = ("a = b + pi", "c*a + e1 + elbow + b", "L9", "theta9 + theta + M_x", "1 + ", "sin")
    sheet = Sheet(tuple(SheetLine(line) for line in lines))
    assert free_names(sheet, scene_names(state)) == ("b", "c", "theta")
