"""Optional layers: their contract, and that what they draw is where the mathematics says, for all arms."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest
import viser
from tests.kinematics.arms import NAMES, arm, postures
from tests.view.drawn import Drawn, served, showing, stage_of

from helicoide import gate, readout
from helicoide.arrays import frozen
from helicoide.confinement import Zone
from helicoide.contributions.trials import with_joints
from helicoide.geometry import rigid, rotation
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.forward import dh_frames, link_motors, link_poses, tool_by_screws
from helicoide.readout.signal import subscript
from helicoide.session.planning import plan_motion
from helicoide.session.postures import list_postures
from helicoide.state import State, initial_state
from helicoide.text import LANGUAGES, Text
from helicoide.view import layers
from helicoide.view.layers import (
    any_moves,
    dh,
    distances,
    force_ellipsoid,
    jacobian_columns,
    null_motion,
    partial_products,
    planned,
    shaft,
    slow_directions,
    twist,
    velocity_ellipsoid,
    wrench,
)
from helicoide.view.layers import postures as ghosts
from helicoide.view.requests import ForArm, ForSeat, ListPostures

SINGLE = 1e-6  # relative error of float32, with a margin
LONGEST = 260  # characters of a line that says what is seen: three or four lines of the panel
each_arm = pytest.mark.parametrize("name", NAMES)


@pytest.fixture(scope="module")
def server() -> Iterator[viser.ViserServer]:
    with served() as server:
        yield server


def at(name: str, seed: int = 1) -> State:
    """An arm in a random posture, moving."""
    robot = arm(name)
    state = with_joints(initial_state(robot), frozen(postures(robot, seed + 1)[-1]))
    velocities = np.random.default_rng(seed).uniform(-robot.speed, robot.speed)
    return replace(state, arm=replace(state.arm, velocities=frozen(velocities)))


def same(drawn: object, expected: object, size: float = 1.0) -> None:
    """Equal up to the rounding to single precision of values of this size."""
    np.testing.assert_allclose(drawn, expected, rtol=0, atol=SINGLE * max(size, 1.0))  # type: ignore[arg-type]


@pytest.mark.parametrize("layer", layers.optional(), ids=lambda layer: layer.NAME)
def test_each_optional_layer_keeps_the_contract(layer: ModuleType) -> None:
    assert isinstance(layer.SHOWN, bool)
    assert layer.KIND in layers.KINDS
    assert not layer.SHARED, "each window shows its own"
    for text in (layer.TITLE, layer.SAID):
        assert isinstance(text, Text)
        assert text.en != text.pt_BR
        assert all(text[language].strip() == text[language] and "\n" not in text[language] for language in LANGUAGES)
    assert all(layer.SAID[language].endswith(".") for language in LANGUAGES)
    assert all(len(layer.SAID[language]) <= LONGEST for language in LANGUAGES)


def test_names_and_titles_differ() -> None:
    assert len({layer.NAME for layer in layers.all_layers()}) == len(layers.all_layers())
    for language in LANGUAGES:
        assert len({layer.TITLE[language] for layer in layers.optional()}) == len(layers.optional())


@pytest.mark.parametrize("layer", layers.optional(), ids=lambda layer: layer.NAME)
def test_a_hidden_layer_sends_nothing_while_the_arm_moves(server: viser.ViserServer, layer: ModuleType) -> None:
    state = at("movemaster")
    stage = stage_of(server, state.robot)
    built = layer.build(stage)
    built.update(None, showing(state))
    before = len(server.scene._handle_from_node_name)
    built.update(showing(state), showing(at("movemaster", 2)))
    assert len(server.scene._handle_from_node_name) == before
    nodes = server.scene._handle_from_node_name
    hidden = [name for name, node in nodes.items() if not node.visible]
    own = [name for name in nodes if name.startswith(f"/{layer.NAME}/")]
    assert [name for name in own if not any(f"{name}/".startswith(f"{other}/") for other in hidden)] == []


@each_arm
def test_the_twist_axis(server: viser.ViserServer, name: str) -> None:
    state = at(name)
    drawn = Drawn(server, twist, state)
    V, tool = readout.tool_twist(state), state.T_world_tool[:3, 3]
    ((start, end),) = drawn.points("axis")
    omega, size = V[3:], float(np.abs([start, end]).max())
    middle, along = (start + end) / 2, (end - start) / np.linalg.norm(end - start)
    there = V[:3] + np.cross(omega, middle - tool)
    same(np.cross(there, along), np.zeros(3), 10 * size * float(np.linalg.norm(V)))
    same(drawn.points("way")[0], [tool, middle], size)
    assert len(drawn.names) == 1
    drawn.layer.update(drawn.view, showing(initial_state(state.robot), twist.NAME))
    assert [len(drawn.points(part)) for part in ("axis", "arrow", "way")] == [0, 0, 0]
    assert drawn.names == []


@each_arm
def test_the_wrench_and_its_torques(server: viser.ViserServer, name: str) -> None:
    state = at(name)
    drawn = Drawn(server, wrench, state)
    robot, J = state.robot, frame_jacobian(state.robot, state.arm.q)
    torques = -J.T @ np.array(drawn.view.seat.wrench)
    joints = wrench.moved_joints(robot)
    assert [int(robot.chain["driver"][joint]) for joint in joints] == list(range(len(robot.variables)))
    arrows = drawn.points("torques")
    loaded = np.abs(torques) > wrench.LEAST
    assert len(arrows) == loaded.sum()
    ways = arrows[:, 1] - arrows[:, 0]
    expected = torques[loaded] / np.abs(torques).max() if loaded.any() else torques[loaded]
    same((ways * state.axes[joints][loaded]).sum(axis=1), wrench.ARROW * drawn.stage.size * expected)
    force = drawn.points("force")[0]
    same(force, [state.T_world_tool[:3, 3], state.T_world_tool[:3, 3] - [0, 0, wrench.ARROW * drawn.stage.size]])
    assert drawn.names[0] == "10.0 N"
    assert len(drawn.points("moment")) == 0


def test_a_wrench_is_set_in_the_panel_and_what_is_no_number_is_ignored() -> None:
    state = at("movemaster")
    force, moment = wrench.rows(state.robot)
    view = showing(state, wrench.NAME)
    assert force.value(view) == (0.0, 0.0, -10.0)  # type: ignore[union-attr, arg-type]
    seat = view.seat
    for update in (gate.set_force([1, 2, 3]), gate.set_moment([1e9, 0, -1]), gate.set_force([np.nan, 0, 0])):
        seat = update(seat)
    assert seat.wrench == (1.0, 2.0, 3.0, 1000.0, 0.0, -1.0)
    request = moment.request(view, (0.0, 0.0, 2.0))  # type: ignore[union-attr, call-arg, arg-type]
    assert isinstance(request, ForSeat)
    assert request.update(seat).wrench[3:] == (0.0, 0.0, 2.0)


@each_arm
def test_the_columns_of_the_jacobian(server: viser.ViserServer, name: str) -> None:
    state = at(name)
    drawn = Drawn(server, jacobian_columns, state)
    J, tool = frame_jacobian(state.robot, state.arm.q), state.T_world_tool[:3, 3]
    for part, columns, scale in (
        ("linear", J[:3].T, jacobian_columns.LINEAR),
        ("angular", J[3:].T, jacobian_columns.ANGULAR * drawn.stage.size),
    ):
        columns = columns[np.linalg.norm(columns, axis=1) > 1e-9]
        arrows = drawn.points(part)
        same(arrows[:, 0], np.tile(tool, (len(columns), 1)))
        same(arrows[:, 1], tool + scale * columns)
    assert sorted(drawn.names) == sorted(subscript("J", i + 1) for i in range(J.shape[1]))


@pytest.mark.parametrize(
    ("layer", "semi_axes"),
    [(velocity_ellipsoid, velocity_ellipsoid.velocity_semi_axes), (force_ellipsoid, force_ellipsoid.force_semi_axes)],
    ids=["velocity", "force"],
)
@each_arm
def test_the_ellipsoids(server: viser.ViserServer, name: str, layer: ModuleType, semi_axes: object) -> None:
    """The drawn ball is the image of the unit ball: R S² Rᵀ = c² J Jᵀ, or its inverse."""
    state = at(name)
    drawn = Drawn(server, layer, state)
    ball, robot = drawn.node("ball"), state.robot
    same(ball.position, state.T_world_tool[:3, 3])
    units = np.array([robot.reach if joint.is_prismatic else 1.0 for joint in robot.variables])
    J = frame_jacobian(robot, state.arm.q)[:3] * units
    R, scale = rotation.to_matrix(np.asarray(ball.wxyz)), np.asarray(ball.scale)
    assert np.linalg.det(R) == pytest.approx(1.0)
    if layer is velocity_ellipsoid:
        same(R @ np.diag(scale**2) @ R.T, layer.SCALE**2 * J @ J.T, 10 * layer.SCALE)
    else:
        full = scale < layer.LONGEST_SHARE * robot.reach - 1e-9
        ways = R[:, full] * scale[full] / (layer.SHARE * robot.reach**2)
        same(ways.T @ J @ J.T @ ways, np.eye(full.sum()), 10)
    ends = drawn.points("semi-axes")
    same(ends.mean(axis=1), np.tile(state.T_world_tool[:3, 3], (3, 1)))
    assert len(drawn.names) == np.linalg.matrix_rank(J) if layer is velocity_ellipsoid else drawn.names


def test_singular_directions_appear_at_a_singular_posture(server: viser.ViserServer) -> None:
    robot = arm("planar2r")
    stretched = with_joints(initial_state(robot), frozen(np.zeros(2)))
    drawn = Drawn(server, slow_directions, stretched)
    ((start, end),) = drawn.points("linear")
    tool, base = stretched.T_world_tool[:3, 3], stretched.arm.poses[1, :3, 3]
    same((start + end) / 2, tool)
    same(np.cross(end - start, tool - base), np.zeros(3))
    drawn.layer.update(drawn.view, showing(initial_state(robot), slow_directions.NAME))
    assert len(drawn.points("linear")) == len(drawn.points("angular")) == 0


@each_arm
def test_distances_by_zone(server: viser.ViserServer, name: str) -> None:
    state = gate.add_obstacle()(at(name))
    drawn = Drawn(server, distances, state)
    found = readout.dimension_lines(state)
    for zone in Zone:
        same(drawn.points(zone.name), found.ends[[one is zone for one in found.zones]])
    assert drawn.names == [f"{1000 * length:z.0f} mm".replace("-", "−") for length in found.lengths]


@each_arm
def test_dh_frames_and_parts(server: viser.ViserServer, name: str) -> None:
    state = at(name)
    drawn = Drawn(server, dh, state)
    frames = np.array(dh_frames(state.robot, state.arm.q))
    same(drawn.node("frames").batched_positions, frames[:, :3, 3], state.robot.reach)
    same([rotation.to_matrix(q.astype(float)) for q in drawn.node("frames").batched_wxyzs], frames[:, :3, :3])
    lengths = sum(float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()) for ends in map(drawn.points, "da"))
    rows = dh.dh_parts(state.robot, state.arm.q, list(frames), 1.0)
    same(lengths, np.abs(rows.values[:, 1:3]).sum(), 10)
    assert len(drawn.names) == (np.abs(rows.values) > dh.NOTHING).sum()


@each_arm
def test_partial_products(server: viser.ViserServer, name: str) -> None:
    state = at(name)
    drawn = Drawn(server, partial_products, state)
    motors = link_motors(state.robot, state.arm.q)[1:]
    poses = np.array([*(rigid.pose_from_motor(motor) for motor in motors), tool_by_screws(state.robot, state.arm.q)])
    same(drawn.node("frames").batched_positions, poses[:, :3, 3], 10)
    same([rotation.to_matrix(q.astype(float)) for q in drawn.node("frames").batched_wxyzs], poses[:, :3, :3], 10)
    assert drawn.names[:3] == ["m₁", "m₁m₂", "m₁…m₃"][: len(motors)] + [drawn.names[2]] * (len(motors) < 3)
    assert drawn.names[-1].endswith("M₀")


def test_the_shaft_passes_through_the_ring(server: viser.ViserServer) -> None:
    state = initial_state(arm("dia10_rod"))
    drawn = Drawn(server, shaft, state)
    assert len(drawn.points("axis")) == len(drawn.points("ring")) == 0
    state = gate.enforce_entry(True)(state)
    entry = state.problem.entry
    assert entry is not None
    drawn.layer.update(drawn.view, view := showing(state, shaft.NAME))
    (segment,) = drawn.points("axis")
    along = state.arm.poses[entry.link][:3, :3] @ entry.shaft[1]
    same(np.cross(segment[1] - segment[0], along), np.zeros(3))
    ring = drawn.points("ring")[:, 0]
    same(np.linalg.norm(ring - entry.point, axis=1), np.full(len(ring), shaft.RING * drawn.stage.size))
    same((ring - entry.point) @ along, np.zeros(len(ring)))
    assert len(drawn.points("poses")) == 1
    moved = with_joints(state, frozen(state.arm.q + 0.1))
    drawn.layer.update(view, showing(moved, shaft.NAME))
    assert len(drawn.points("poses")) == 2
    distance = shaft.distance_to_axis(drawn.points("axis")[0], entry.point)
    assert drawn.names == [f"{1000 * distance:.2f} mm"] or abs(float(drawn.names[0][:-3]) - 1000 * distance) < 0.02


def test_the_null_space_ghost_moves_and_keeps_its_tool(server: viser.ViserServer) -> None:
    state = initial_state(arm("dia10_rod"))
    drawn = Drawn(server, null_motion, state)
    start, turned, view = drawn.layer.q, set(), drawn.view
    for frame in range(1, 200):
        after = showing(state, null_motion.NAME, time=0.05 * frame)
        drawn.layer.update(view, after)
        view = after
        turned.add(drawn.layer.way)
        T = tool_by_screws(state.robot, drawn.layer.q)
        np.testing.assert_allclose(T, state.T_world_tool, rtol=0, atol=1e-3)
        assert (drawn.layer.q >= state.robot.lower).all()
        assert (drawn.layer.q <= state.robot.upper).all()
    assert turned == {1.0, -1.0}
    assert np.abs(drawn.layer.q - start).max() > 0.01
    outline = drawn.layer.outline
    poses = link_poses(state.robot.chain, drawn.layer.q)
    for link, T_link_shape, frame in zip(
        outline.placed.links, outline.placed.Ts_link_shape, outline.frames, strict=True
    ):
        same(frame.position, (poses[link] @ T_link_shape)[:3, 3])


def test_without_a_null_space_there_is_no_ghost(server: viser.ViserServer) -> None:
    drawn = Drawn(server, null_motion, initial_state(arm("puma560")))
    assert not drawn.layer.outline.frames


def test_the_scene_is_drawn_again_by_itself_only_while_a_shown_ghost_can_move() -> None:
    redundant, other = (initial_state(arm(name)) for name in ("dia10_rod", "puma560"))
    assert any_moves(showing(redundant, null_motion.NAME))
    assert not any_moves(showing(redundant))
    assert not any_moves(replace(showing(redundant, null_motion.NAME), ready=False))
    assert not any_moves(showing(other, null_motion.NAME)), "it has no null space"
    assert not any_moves(showing(other, planned.NAME)), "it has no plan"


def test_a_small_negative_number_is_shown_without_a_sign(server: viser.ViserServer) -> None:
    state = initial_state(arm("puma560"))
    drawn = Drawn(server, wrench, state)
    seat = gate.set_force([-1e-3, 2e-3, 1e-3])(drawn.view.seat)
    drawn.layer.update(drawn.view, replace(drawn.view, seat=seat))
    assert (readout.balancing_torques(state, seat.wrench) < -wrench.LEAST).any()
    assert [name for name in drawn.names if name.startswith("−0.0")] == []


@pytest.mark.parametrize("name", ["puma560", "movemaster", "planar2r", "scara"])
def test_ghosts_of_all_postures_have_the_tool_at_the_target(server: viser.ViserServer, name: str) -> None:
    state = initial_state(arm(name))
    drawn = Drawn(server, ghosts, state)
    assert ghosts.needs(drawn.view) == ListPostures()
    listed = list_postures(state)(state)
    view = showing(listed, ghosts.NAME)
    assert ghosts.needs(view) is None
    drawn.layer.update(drawn.view, view)
    bars = drawn.node("bars")
    listing = listed.postures.listing
    assert listing is not None
    count = 0
    for place, row in enumerate(listing.rows):
        expected = ghosts.ghost_bars(state.robot, link_poses(state.robot.chain, row.q))
        mine = [k for k, of in enumerate(drawn.layer.places) if of == place]
        same(np.asarray(bars.batched_positions)[mine], expected.mean(axis=1))
        axes = np.array([rotation.to_matrix(np.asarray(bars.batched_wxyzs)[k].astype(float))[:, 2] for k in mine])
        way = (expected[:, 1] - expected[:, 0]) / 2
        half = axes * np.asarray(bars.batched_scales)[mine, 2:] / 2
        same(half, way)
        count += len(mine)
    assert count == len(drawn.layer.places)
    drawn.layer._clicked(drawn.layer.places.index(len(listing.rows) - 1))
    (request,) = drawn.asked
    assert isinstance(request, ForArm)
    drawn.layer._clicked(10**6)
    assert len(drawn.asked) == 1


def test_no_list_is_needed_while_the_arm_moves_or_is_parked() -> None:
    state = at("movemaster")
    assert ghosts.needs(showing(state, ghosts.NAME)) is None
    parked = initial_state(state.robot)
    parked = replace(parked, arm=replace(parked.arm, parked=True))
    assert ghosts.needs(showing(parked, ghosts.NAME)) is None


def test_the_planned_motion_is_drawn_and_the_ghost_repeats_it(server: viser.ViserServer) -> None:
    state = initial_state(arm("movemaster"))
    drawn = Drawn(server, planned, state)
    assert not drawn.layer.outline.frames
    title = Text(en="there", pt_BR="lá")
    state = plan_motion(state, gate.set_joint(0, float(state.arm.q[0]) + 0.4), title)(state)
    plan = state.plan
    assert plan is not None
    drawn.layer.update(drawn.view, view := showing(state, planned.NAME, time=5.0))
    way = drawn.points("way")
    same(way[0, 0], tool_by_screws(state.robot, plan.q[0])[:3, 3])
    same(way[-1, 1], tool_by_screws(state.robot, plan.q[-1])[:3, 3])
    last = showing(state, planned.NAME, time=5.0 + float(plan.times[-1]) + 0.5)
    drawn.layer.update(view, last)
    placed = drawn.layer.outline.placed
    poses = link_poses(state.robot.chain, plan.q[-1])
    for link, T_link_shape, frame in zip(placed.links, placed.Ts_link_shape, placed.frames, strict=True):
        expected = poses[link] @ T_link_shape
        if not np.abs(placed.slides).max():
            same(frame.position, expected[:3, 3])
    drawn.layer.update(last, showing(gate.clear_plan()(state), planned.NAME, time=9.0))
    assert not drawn.layer.outline.shown
    assert len(drawn.points("way")) == 0


@pytest.mark.parametrize("layer", layers.optional(), ids=lambda layer: layer.NAME)
def test_an_unchanged_view_sends_nothing(server: viser.ViserServer, layer: ModuleType) -> None:
    state = at("movemaster")
    drawn = Drawn(server, layer, state)
    again = replace(drawn.view)
    queued = server.scene._queue_scene_message
    sent: list[object] = []
    server.scene._queue_scene_message = sent.append  # type: ignore[method-assign]
    try:
        drawn.layer.update(drawn.view, again)
    finally:
        server.scene._queue_scene_message = queued  # type: ignore[method-assign]
    assert sent == []


def test_a_layer_waits_for_the_kernels(server: viser.ViserServer) -> None:
    state = at("movemaster")
    layer = dh.build(stage_of(server, state.robot))
    layer.update(None, replace(showing(state, dh.NAME), ready=False))
    assert server.scene._handle_from_node_name.keys() <= {"/WorldAxes"}
    layer.update(replace(showing(state, dh.NAME), ready=False), showing(state, dh.NAME))
    assert "/dh/d" in server.scene._handle_from_node_name
