"""Signals of every arm and method: finite or undefined, as computed independently, with the bands of the state."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tests.driving import after, with_joints

from helicoide import gate
from helicoide.confinement import Zone, segment_distances
from helicoide.ik import methods
from helicoide.kinematics.differential import frame_jacobian
from helicoide.kinematics.generic_rank import counted_rows
from helicoide.kinematics.library import load_robot, robot_titles
from helicoide.readout.matrices import TITLES, named_matrix
from helicoide.readout.signals import needed_signals, phase_planes, signal_groups, signals_of
from helicoide.state import State, initial_state

ROBOTS = tuple(robot_titles())


def read(state: State, name: str) -> np.ndarray:
    return signals_of(state)[name].read(state)


def moved(state: State, seconds: float = 0.3) -> State:
    """The arm on its way to a target beside it."""
    place = state.T_world_tool[:3, 3] + 0.05 * state.robot.reach * np.array([-1.0, 1.0, 0.5])
    return after(gate.set_target(place, [1.0, 0.0, 0.0, 0.0])(state), seconds)


@pytest.fixture(params=ROBOTS)
def arm(request: pytest.FixtureRequest) -> State:
    return initial_state(load_robot(request.param))


@pytest.mark.parametrize("method", methods.names())
def test_every_signal_is_finite_or_nan_with_every_arm(arm: State, method: str) -> None:
    state = moved(gate.compare_with("filtered")(gate.choose_method(method)(arm)))
    assert state.compared_state is not None
    for one in (arm, state, state.compared_state):
        for signal in signals_of(one).values():
            values = signal.read(one)
            assert values.shape == (len(signal.curves),), signal.name
            assert not np.isinf(values).any(), signal.name
            assert not signal.positive or not (values < 0).any(), signal.name
            assert all(band.lower <= band.upper for band in signal.bands(one)), signal.name


def test_what_always_exists_is_finite(arm: State) -> None:
    names = {"positions", "speeds", "speed", "planes", "own bodies", "singular values", "manipulability"}
    state = moved(arm)
    for name in names & signals_of(state).keys():
        assert np.isfinite(read(state, name)).all(), name


def test_presets_and_phase_planes_name_signals() -> None:
    state = gate.add_obstacle()(initial_state(load_robot("dia10_rod")))
    state = gate.enforce_entry(True)(state)
    planes = signals_of(initial_state(load_robot("movemaster")))
    known = {*signals_of(state), *planes, *phase_planes()}
    assert {name for group in signal_groups() for name in group.PRESET} <= known
    assert not phase_planes().keys() & {*signals_of(state), *planes}
    for phase in phase_planes().values():
        assert [signal.name for signal in needed_signals(state, (phase.name,))] == [phase.across, phase.up]


def test_joints_against_their_limits(arm: State) -> None:
    limits = arm.problem.limits
    middle = with_joints(arm, (limits.lower + limits.upper) / 2)
    np.testing.assert_allclose(read(middle, "positions"), 50)
    np.testing.assert_allclose(read(with_joints(arm, limits.upper), "positions"), 100)
    for i, joint in enumerate(arm.robot.variables):
        signal = signals_of(arm)[f"position {i}"]
        scale = 1000.0 if joint.is_prismatic else 180 / np.pi
        (value,) = signal.read(arm)
        assert value == pytest.approx(scale * arm.arm.q[i])
        below, above = signal.bands(arm)
        assert (below.upper, above.lower) == pytest.approx((scale * limits.lower[i], scale * limits.upper[i]))
        assert below.upper <= value <= above.lower


def test_speeds_are_the_slopes_of_the_positions(state: State) -> None:
    before = moved(state)
    later = after(before, 0.01)
    for i in range(len(state.arm.q)):
        slope = (read(later, f"position {i}") - read(before, f"position {i}")) / 0.01
        np.testing.assert_allclose(read(later, f"speed {i}"), slope, atol=1e-6)


def test_errors_agree_with_scipy(state: State) -> None:
    state = moved(state, 0.05)
    T, target = state.T_world_tool, state.request.command.T_world_target  # type: ignore[union-attr]
    np.testing.assert_allclose(read(state, "position error by axis"), 1000 * (target - T)[:3, 3], atol=1e-9)
    np.testing.assert_allclose(read(state, "position error"), 1000 * np.linalg.norm((target - T)[:3, 3]))
    angle = (Rotation.from_matrix(target[:3, :3]) * Rotation.from_matrix(T[:3, :3]).inv()).magnitude()
    np.testing.assert_allclose(read(state, "orientation error"), np.degrees(angle))
    assert np.isnan(read(gate.stop()(state), "position error")).all()


def test_distances_to_planes_and_obstacles_and_their_bands(state: State) -> None:
    state = gate.set_zones(0.09, 0.14)(gate.add_obstacle()(state))
    planes, zones = state.problem.planes, state.problem.zones
    table = np.array([planes.normals @ (p - c) for p in state.monitored_points for c in [np.zeros(3)]]) - planes.offsets
    np.testing.assert_allclose(read(state, "planes"), 1000 * table.min(axis=0))
    np.testing.assert_allclose(read(state, "plane 1"), 1000 * table[:, 1])
    warning, critical = signals_of(state)["planes"].bands(state)
    assert (critical.upper, warning.lower, warning.upper) == (1000 * zones.critical,) * 2 + (1000 * zones.warning,)
    assert zones.zone_of(critical.upper / 1000) is Zone.CRITICAL
    assert zones.zone_of(warning.upper / 1000 - 1e-4) is Zone.WARNING
    assert zones.zone_of(warning.upper / 1000 + 1e-4) is Zone.FREE
    (band,) = signals_of(state)["obstacles"].bands(state)
    assert band.upper == pytest.approx(1000 * zones.body_clearance)
    bodies = [body for body in state.robot.bodies if max(body.links) > 0]
    shares = np.linspace(0, 1, 2001)[:, None]
    least = []
    for body in bodies:
        a, b = body.axis_at(state.arm.poses)
        away = segment_distances(a + shares * (b - a), state.problem.obstacles.ends)
        least.append(away.min(axis=0) - body.radius - state.problem.obstacles.radii)
    np.testing.assert_allclose(read(state, "obstacles"), 1000 * np.min(least, axis=0), atol=0.05)


def test_singular_values_agree_with_numpy(arm: State) -> None:
    state = moved(arm)
    J = frame_jacobian(state.robot, state.arm.q) * state.problem.joint_units
    J[:3] /= state.problem.length
    rows = counted_rows(state.robot, state.request.with_orientation)
    if rows.any():
        sigma = np.linalg.svd(J[rows], compute_uv=False)
        np.testing.assert_allclose(read(state, "singular values"), sigma, atol=1e-12)
        np.testing.assert_allclose(read(state, "manipulability"), np.prod(sigma))
        np.testing.assert_allclose(read(state, "condition number"), sigma[0] / sigma[-1], rtol=1e-6)


def test_the_filter_agrees_with_its_definitions() -> None:
    state = moved(gate.choose_method("filtered_modified")(initial_state(load_robot("zebra_zero"))))
    memory, solution = state.request.controller.memory, state.request.controller.solution
    J, Theta = memory.before, memory.Theta
    assert J.shape == (6, 6)
    np.testing.assert_allclose(read(state, "norm of Θ"), solution.figures["‖Θ‖"])
    U, sigma, Vt = np.linalg.svd(J)
    Psi = Vt @ Theta @ U
    np.testing.assert_allclose(read(state, "filter d"), np.diag(Psi), atol=1e-9)
    np.testing.assert_allclose(read(state, "filter σd"), sigma * np.diag(Psi), atol=1e-9)
    np.testing.assert_allclose(read(state, "residuals"), np.linalg.norm(Psi - np.diag(np.diag(Psi))), atol=1e-9)
    k, theta, theta_m = (read(state, name)[0] for name in ("filter k", "filter θ", "filter θ_M"))
    assert abs(k) == pytest.approx(sigma[-1])
    assert np.sign(k) == np.sign(np.linalg.det(J))
    assert (k * theta, theta_m) == pytest.approx((sigma[-1] * Psi[-1, -1], theta**2 * k))
    modified = Vt @ (Theta @ Theta.T @ J.T) @ U
    if np.allclose(Psi, np.diag(np.diag(Psi)), atol=1e-6):
        assert abs(theta_m) == pytest.approx(abs(modified[-1, -1]), rel=1e-3)


def test_the_inversion_error_is_that_of_the_matrices(state: State) -> None:
    before = moved(gate.choose_method("filtered")(state))
    Theta = before.request.controller.memory.Theta
    state = after(before, 0.01)
    J = state.request.controller.memory.before
    right, left = J @ Theta - np.eye(len(J)), Theta @ J - np.eye(len(Theta))
    np.testing.assert_allclose(read(state, "inversion error"), (np.sum(right**2) + np.sum(left**2)) / 2)


def test_a_state_that_is_not_finite_is_undefined_and_raises_nothing(state: State) -> None:
    poses = np.full_like(state.arm.poses, np.nan)
    broken = replace(state, arm=replace(state.arm, q=np.full_like(state.arm.q, np.nan), poses=poses))
    for signal in signals_of(broken).values():
        assert not np.isinf(signal.read(broken)).any()
    assert np.isnan(read(broken, "singular values")).all()


@pytest.mark.parametrize("method", methods.names())
def test_every_matrix_has_a_name_for_each_row_and_column(arm: State, method: str) -> None:
    state = moved(gate.choose_method(method)(arm), 0.05)
    for name in TITLES:
        matrix = named_matrix(state, name)
        if matrix is not None:
            assert matrix.values.shape == (len(matrix.rows), len(matrix.columns)), name


def test_matrices_have_the_units_that_their_names_say(state: State) -> None:
    state = moved(gate.choose_method("damped")(state))
    J, B, H = (named_matrix(state, name) for name in "JBH")
    assert J is not None
    assert B is not None
    assert H is not None
    np.testing.assert_allclose(H.values[:3, 3], 1000 * state.T_world_tool[:3, 3])
    assert [name.en for name in B.columns] == ["x", "y", "z", "ωx", "ωy", "ωz"]
    damping = named_matrix(state, "λ")
    assert damping is not None
    assert damping.values[0, 0] == pytest.approx(0.02 * 1000 * state.problem.length)


@pytest.mark.parametrize("name", ["movemaster", "scara", "polar_rp"])
def test_the_jacobian_has_the_units_that_its_names_say(name: str) -> None:
    """A small motion of the tool, in mm and rad, for joint motions in rad or mm."""
    arm = initial_state(load_robot(name))
    joints = np.array([1000.0 if joint.is_prismatic else 1.0 for joint in arm.robot.variables])
    J = named_matrix(arm, "J")
    assert J is not None
    assert [("mm/s" in column.en) for column in J.columns] == [joint.is_prismatic for joint in arm.robot.variables]
    dq = 1e-6 * np.random.default_rng(0).normal(size=len(joints))
    T, moved = arm.T_world_tool, with_joints(arm, arm.arm.q + dq).T_world_tool
    turned = Rotation.from_matrix(moved[:3, :3] @ T[:3, :3].T).as_rotvec()
    found = np.append(1000 * (moved - T)[:3, 3], turned)
    np.testing.assert_allclose(J.values @ (joints * dq), found, atol=1e-8)
