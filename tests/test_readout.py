"""The readout of a state: multivectors, distances, status texts, instruments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from tests.driving import after, clear_posture, with_joints

from helicoide import gate, readout
from helicoide.arrays import Array
from helicoide.command import MoveToJoints, MoveToPose
from helicoide.confinement import Zone
from helicoide.geometry import rigid, rotation
from helicoide.geometry.clifford import CL031
from helicoide.ik import Contact, methods
from helicoide.ik.goal import goal_at_joints, goal_at_pose
from helicoide.kinematics.library import load_robot
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.urdf_chain import robot_from_urdf
from helicoide.seat import Selection, SelectionKind
from helicoide.state import State, initial_state

ALL_ROWS = "x, y, z, ωx, ωy, ωz"
UP = [1.0, 0.0, 0.0, 0.0]


def foreseen(state: State) -> State:
    """The state with the goal of its command, as the clock computes it."""
    match state.request.command:
        case MoveToPose(T):
            goal = goal_at_pose(state.problem, state.arm.q, T, state.request.with_orientation)
        case MoveToJoints(q):
            goal = goal_at_joints(state.problem, state.arm.q, q)
        case _:
            goal = None
    return replace(state, request=replace(state.request, goal=goal))


# Recomputed from the planes of Cerbaro 2022, §6.2.1: shoulder, elbow, wrist, tool in mm, for each wall.
DISTANCES = {
    "zero": [
        [257.47, 244.42, 233.98, 220.93],
        [318.85, 304.43, 292.89, 278.46],
        [291.83, 303.80, 313.38, 325.36],
    ],
    "example": [
        [257.68, 35.18, 126.31, 336.21],
        [260.06, 175.08, 87.85, 35.91],
        [350.87, 404.63, 504.48, 585.69],
    ],
    "home": [
        [257.47, 21.09, 69.49, 130.00],
        [318.85, 304.49, 297.92, 289.70],
        [291.83, 273.29, 286.16, 302.25],
    ],
    "reading_ceiling": [
        [257.47, 370.99, 476.99, 254.27],
        [318.85, 315.90, 315.20, 291.47],
        [291.83, 310.12, 325.24, 317.51],
    ],
}  # fmt: skip


@pytest.mark.parametrize("name", DISTANCES)
def test_plane_distances_in_four_postures(state: State, name: str) -> None:
    """To 0.03 mm: the table uses the printed normals, whose length differs from 1 by up to 4e-5. The robot's normals
    are unit vectors, which changes a distance l by up to 4e-5 l (0.02 mm), and the table is rounded."""
    table = 1000 * readout.plane_distances(with_joints(state, state.robot.poses[name]))
    np.testing.assert_allclose(table[1:, :3].T, DISTANCES[name], rtol=0, atol=0.03)
    printed = np.array([[-0.0522, -0.0104, -0.9986], [-0.0577, -0.9954, -0.0763], [0.0479, 0.9968, -0.0634]])
    np.testing.assert_allclose(
        table[1:, :3].T * np.linalg.norm(printed, axis=1)[:, None], DISTANCES[name], rtol=0, atol=0.0051
    )


def values_of(state: State, kind: SelectionKind, index: int = 0) -> Array:
    """The multivector of an object of the scene."""
    element = readout.element_of(state, Selection(kind, index))
    assert element is not None
    return element.values(state)


@pytest.fixture(params=range(5))
def anywhere(state: State, request: pytest.FixtureRequest) -> State:
    rng = np.random.default_rng(request.param)
    return with_joints(state, clear_posture(rng, state, 0.0))


def test_the_tool_motor_brings_the_frame_at_the_base_to_the_tool(anywhere: State) -> None:
    """M moves points, lines and planes from tool coordinates to the world's."""
    motor, T = values_of(anywhere, "tool"), anywhere.T_world_tool
    np.testing.assert_allclose(rigid.coordinates(rigid.move(motor, rigid.point([0, 0, 0]))), T[:3, 3], atol=1e-12)
    np.testing.assert_allclose(rigid.pose_from_motor(motor), T, atol=1e-12)
    along_x = rigid.move(motor, rigid.line([1, 0, 0], [0, 0, 0]))
    np.testing.assert_allclose(along_x, rigid.line(T[:3, 0], T[:3, 3]), atol=1e-12)
    np.testing.assert_allclose(CL031.product(motor, CL031.conjugate(motor)), CL031.blade("1"), atol=1e-12)


def test_the_tool_point_is_the_moved_reference_point(anywhere: State) -> None:
    """The displacement from q = 0 takes the reference tool point (820, 0, 400) mm to the tool."""
    robot = anywhere.robot
    displacement = CL031.product(
        values_of(anywhere, "tool"), CL031.conjugate(rigid.motor_from_pose(robot.T_world_tool_0))
    )
    moved = rigid.coordinates(rigid.move(displacement, rigid.point(robot.T_world_tool_0[:3, 3])))
    np.testing.assert_allclose(moved, anywhere.T_world_tool[:3, 3], atol=1e-12)
    np.testing.assert_allclose(moved, rigid.coordinates(values_of(anywhere, "point", 4)), atol=1e-12)


def test_the_line_of_a_joint_is_its_axis_moved_by_the_joints_before_it(anywhere: State) -> None:
    motor = CL031.blade("1")
    for i, (joint, angle) in enumerate(zip(anywhere.robot.joints, anywhere.arm.q, strict=True)):
        moved = rigid.move(motor, rigid.line(joint.direction, joint.point))
        np.testing.assert_allclose(values_of(anywhere, "joint", i), moved, atol=1e-12)
        motor = CL031.product(motor, rigid.screw_motor(joint.direction, joint.point, angle))


def test_planes_and_points_of_the_algebra_have_the_distances_of_the_table(anywhere: State) -> None:
    table = readout.plane_distances(anywhere)
    for j, k in np.ndindex(table.shape):
        pi, p = values_of(anywhere, "plane", k), values_of(anywhere, "point", j)
        assert rigid.point_plane_distance(pi, p) == pytest.approx(table[j, k], abs=1e-12)
        product = readout.distance_product(anywhere, j, k)
        np.testing.assert_allclose(product, 2 * table[j, k] * CL031.blade("e1e2e3e"), atol=1e-12)


def test_the_nearest_point_and_the_zones(state: State) -> None:
    """At home the elbow is 21.09 mm from the ceiling, so only the ceiling is critical."""
    home = with_joints(state, state.robot.poses["home"])
    assert readout.nearest_point_and_plane(home) == Contact(plane=0, point=2)
    assert readout.zones(home) == (Zone.CRITICAL, Zone.FREE, Zone.FREE, Zone.FREE)
    assert readout.zones(state) == (Zone.FREE,) * 4


def rests(update: Callable[[State], State]) -> Callable[[State], State]:
    return lambda state: foreseen(after(update(state), 8))


def with_position_only(update: Callable[[State], State]) -> Callable[[State], State]:
    return lambda state: update(gate.keep_orientation(False)(state))


# how the state is made; the tone; words that the status must contain in English and in Portuguese
CASES: dict[str, tuple[Callable[[State], State], readout.Tone, list[str], list[str]]] = {
    "at rest": (lambda state: state, "ok", ["Ready"], ["Pronto"]),
    "moving": (
        lambda state: foreseen(after(gate.go_to("zero")(state), 0.1)), "ok", ["Moving"], ["movimento"]
    ),
    "there": (rests(gate.go_to("path_start")), "ok", ["Goal reached"], ["Objetivo alcançado"]),
    "beyond the ceiling": (
        rests(with_position_only(gate.set_target([0.45, 0.0, 0.75], UP))),
        "blocked",
        ["+z", "ceiling", "80 mm", "mm from the target"],
        ["+z", "teto", "80 mm", "mm do alvo"],
    ),
    "beyond the left wall": (
        rests(with_position_only(gate.set_target([0.5, 0.6, 0.3], UP))),
        "blocked",
        ["+y", "left wall", "end effector at 80 mm", "mm from the target"],
        ["+y", "parede esquerda", "efetuador a 80 mm", "mm do alvo"],
    ),
    "below the bench": (
        rests(with_position_only(gate.set_target([0.5, 0.0, -0.1], UP))),
        "blocked",
        ["-z", "bench", "end effector at 80 mm", "180 mm from the target"],
        ["-z", "bancada", "efetuador a 80 mm", "a 180 mm do alvo"],
    ),
    "out of reach": (
        rests(with_position_only(gate.set_target([0.9, 0.0, 0.4], UP))),
        "blocked",
        ["Out of reach by 80 mm", "closest reachable point shown"],
        ["Fora do alcance por 80 mm", "ponto alcançável mais próximo"],
    ),
    "turned too far": (
        rests(gate.set_target([0.6, 0.0, 0.3], [np.cos(np.pi / 12), 0, 0, np.sin(np.pi / 12)])),
        "warn",
        ["Position reached", "30° from target", "with 5 joints the position fixes the yaw"],
        ["Posição alcançada", "a 30° do alvo", "com 5 juntas a posição determina a guinada"],
    ),
    "refused": (gate.go_to("nowhere"), "warn", ["nowhere", "ready"], ["nowhere", "ready"]),
    "stopped": (lambda state: gate.stop()(gate.play()(state)), "stopped", ["Stopped"], ["Parado"]),
    "parking": (lambda state: after(gate.park()(state), 0.5), "ok", ["park"], ["estacionar"]),
    "parked": (lambda state: after(gate.park()(state), 15), "warn", ["Parked", "off"], ["Estacionado", "desligados"]),
    "getting ready": (
        lambda state: after(gate.get_ready()(after(gate.park()(state), 15)), 0.5),
        "ok", ["ready pose"], ["pose inicial"],
    ),
}  # fmt: skip


def test_an_entry_point_is_the_reason_of_an_orientation_that_is_not_reached() -> None:
    """With seven joints the position fixes no orientation; with an entry point it does."""
    held = gate.enforce_entry(True)(initial_state(load_robot("dia10_rod")))
    turned = held.T_world_tool[:3, :3] @ rotation.to_matrix(np.array([np.cos(0.1), np.sin(0.1), 0.0, 0.0]))
    asked = gate.set_target(held.T_world_tool[:3, 3], rotation.from_matrix(turned))(held)
    said = readout.status(foreseen(asked)).text
    assert "the shaft must pass through its entry point" in said.en
    assert "a haste tem de passar pelo ponto de entrada" in said.pt_BR
    assert "yaw" not in said.en


@pytest.mark.parametrize("case", CASES)
def test_the_words_of_the_status(state: State, case: str) -> None:
    made, tone, english, portuguese = CASES[case]
    status = readout.status(made(state))
    assert [word for word in english if word not in status.text.en] == []
    assert [word for word in portuguese if word not in status.text.pt_BR] == []
    assert status.tone == tone
    assert "{" not in status.text.en + status.text.pt_BR


CHANGES = {
    "every plane is taken away": gate.clear_planes(),
    "one plane is taken away": gate.remove_plane(0),
    "an obstacle comes": gate.add_obstacle(),
    "an obstacle goes": gate.remove_obstacle(0),
    "the zones are others": gate.set_zones(0.09, 0.2),
}


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("case", CASES)
def test_the_status_can_be_read_whatever_is_around_the_arm_now(state: State, case: str, change: str) -> None:
    """A goal that was computed for other planes and obstacles does not refer to the current ones."""
    made, *_ = CASES[case]
    changed = CHANGES[change](made(gate.add_obstacle()(state)))
    for _ in range(2):
        assert readout.status(changed).text.en
        changed = foreseen(after(changed, 0.01))


def test_a_joint_at_its_limit_is_named(state: State) -> None:
    """With the waist limited to 10°, a target at 20° is missed, although every plane allows it."""
    robot = state.robot
    upper = robot.upper.copy()
    upper[0] = np.radians(10)
    upper.flags.writeable = False
    state = replace(state, problem=replace(state.problem, limits=replace(state.problem.limits, upper=upper)))
    far = [0.55 * np.cos(np.radians(20)), 0.55 * np.sin(np.radians(20)), 0.25]
    status = readout.status(rests(with_position_only(gate.set_target(far, UP)))(state))
    assert "Joint 1 (waist) at its limit" in status.text.en
    assert "Junta 1 (cintura) no limite" in status.text.pt_BR
    assert status.tone == "blocked"


def test_a_singular_posture_is_named_in_the_readout(state: State) -> None:
    assert readout.near_singular(state) is None
    stretched = readout.near_singular(with_joints(state, np.array([0.2, 0.3, 0.0, 0.4, 0.1])))
    assert stretched is not None
    assert "4 of its 5" in stretched.en
    assert "4 das suas 5" in stretched.pt_BR


@pytest.mark.parametrize(("name", "rows"), [("planar2r", "x, y"), ("planar3r", "x, y, ωz"), ("movemaster", ALL_ROWS)])
def test_the_rows_that_count_are_named(name: str, rows: str) -> None:
    state = initial_state(load_robot(name))
    assert readout.counted_names(state) == rows
    assert readout.counted_names(gate.keep_orientation(False)(state)) == ("x, y" if "planar" in name else "x, y, z")


@pytest.mark.parametrize("with_orientation", [True, False])
def test_a_stretched_arm_of_two_joints_reads_singular(with_orientation: bool) -> None:
    """Its orientation follows from its position: task rows that it cannot follow do not hide the singularity."""
    state = with_joints(initial_state(load_robot("planar2r")), np.array([0.4, 0.0]))
    state = gate.keep_orientation(with_orientation)(state)
    values = {instrument.symbol: instrument.value for instrument in readout.instruments(state)}
    assert values["w"] < 1e-9
    assert values[r"\kappa"] > 1e9
    assert "e_o" not in values
    assert "1 of its 2" in readout.status(state).text.en
    assert "1 das suas 2" in readout.status(state).text.pt_BR


@pytest.mark.parametrize("method", methods.names())
@pytest.mark.parametrize("with_orientation", [True, False])
def test_a_camera_on_two_crossing_axes_is_driven_by_every_method(method: str, with_orientation: bool) -> None:
    """Its joints rotate the tool but cannot move it: without orientation no task row is left, which the status says."""
    state = gate.keep_orientation(with_orientation)(initial_state(pan_tilt()))
    state = gate.set_target([0.1, 0.0, 0.3], [0.9, 0.1, 0.3, 0.2])(gate.choose_method(method)(state))
    before = state.arm.q
    state = after(state, 0.3)
    assert np.isfinite(state.arm.q).all()
    symbols = {instrument.symbol for instrument in readout.instruments(state)}
    if with_orientation:
        assert readout.counted_names(state) == "ωx, ωy, ωz"
        assert symbols > {"e_p", "e_o", "w"}
    else:
        assert readout.counted_names(state) == ""
        assert symbols.isdisjoint({"e_o", "w"})
        assert (state.arm.q == before).all()
        if method != "guarded":
            assert "not asked for" in readout.status(state).text.en


@lru_cache
def pan_tilt() -> Robot:
    """A camera on two axes that intersect at the camera."""
    joint = (
        "<joint name='{name}' type='revolute'><parent link='{parent}'/><child link='{child}'/><axis xyz='{axis}'/>"
        "<limit lower='-1.5' upper='1.5' velocity='1' effort='1'/></joint>"
    )
    pan = joint.format(name="pan", parent="base", child="pan", axis="0 0 1")
    tilt = joint.format(name="tilt", parent="pan", child="camera", axis="0 1 0")
    links = "<link name='base'/><link name='pan'/><link name='camera'/>"
    with TemporaryDirectory() as folder:
        path = Path(folder) / "pan_tilt.urdf"
        path.write_text(f"<robot name='pan_tilt'>{links}{pan}{tilt}</robot>", "utf-8")
        return robot_from_urdf(path)
