"""The loop around the constrained Jacobian: error of pose, drift feedback, moving entry point, any method."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import islice

import numpy as np
import pytest
from tests.ik.rcm.runs import START

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.ik import methods
from helicoide.ik.method import ConfiguredMethod, Promise
from helicoide.ik.methods import configured_method
from helicoide.ik.postures.branch import tool_at
from helicoide.ik.rcm.constrained import constrained
from helicoide.ik.rcm.follow import (
    RcmControl,
    RcmReference,
    RcmState,
    RcmStep,
    body_velocity,
    pose_error,
    rcm_loop,
)
from helicoide.ik.rcm.passage import SLIT, TROCAR, through
from helicoide.kinematics import differential
from helicoide.studies._coutinho_runs import LINK, angle_deg, dia10, entry_on, problem_without_planes
from helicoide.text import HelicoideError

STILL = np.zeros(6)
Error = Callable[[Array, Array], Array]


def pose(R: Array) -> Array:
    T = np.eye(4)
    T[:3, :3] = R
    return T


def literal_error(T_world_target: Array, T_world_tool: Array) -> Array:
    """Eqs. 2.62–2.63 as printed: Q_d ⊗ Q⁻¹ in the base frame."""
    vector = rotation.from_matrix(T_world_target[:3, :3] @ T_world_tool[:3, :3].T)[1:]
    return np.concatenate([np.zeros(3), vector])


def turned_to(R: Array, R_target: Array, error: Error, Ko: float, seconds: float, dt: float) -> float:
    """The angle that is left, deg, when a body turns by ω = Ko ε̃ in its own axes."""
    for _ in range(round(seconds / dt)):
        nu = body_velocity(R, STILL, error(pose(R_target), pose(R)), 0.0, Ko)
        R = R @ rotation.exponential(nu[3:] * dt)
    return angle_deg(pose_error(pose(R_target), pose(R)))


def test_the_printed_error_of_orientation_does_not_close_the_loop() -> None:
    """From Rot(x, 180°) to a target turned by 20° about its z, Ko = 2, 10 s at 5 ms: 179.9° against 0.0009°."""
    R = rotation.exponential([np.pi, 0.0, 0.0])
    target = R @ rotation.exponential([0.0, 0.0, np.radians(20)])
    assert turned_to(R, target, literal_error, 2.0, 10.0, 0.005) == pytest.approx(179.9, abs=0.1)
    assert turned_to(R, target, pose_error, 2.0, 10.0, 0.005) == pytest.approx(0.0009, abs=5e-5)


def test_the_printed_error_fails_in_most_postures() -> None:
    """Of 40 random poses with errors of about 0.2 rad it fails in most; the error seen by the body never does."""
    rng = np.random.default_rng(2)
    failures = 0
    for wxyz in rng.normal(size=(40, 4)):
        R = rotation.to_matrix(wxyz)
        target = R @ rotation.exponential(0.2 * rotation.unit_vector(rng.normal(size=3)))
        failures += turned_to(R, target, literal_error, 2.0, 10.0, 0.1) > 1.0
        assert turned_to(R, target, pose_error, 2.0, 10.0, 0.1) < 0.01
    assert 30 <= failures < 40


def test_angles_fall_by_their_quarter_tangent() -> None:
    """φ̇ = −Ko sin(φ/2), so tan(φ/4) = tan(φ₀/4) e^{−Ko t/2}, from 170° at Ko = 4: within 0.04° at 1 ms."""
    R, target, dt = np.eye(3), rotation.exponential(np.radians(170) * rotation.unit_vector([1.0, 2.0, -0.5])), 1e-3
    worst = 0.0
    for step in range(2000):
        error = pose_error(pose(target), pose(R))
        expected = 4 * np.arctan(np.tan(np.radians(170) / 4) * np.exp(-4 * step * dt / 2))
        worst = max(worst, abs(angle_deg(error) - np.degrees(expected)))
        R = R @ rotation.exponential(body_velocity(R, STILL, error, 0.0, 4.0)[3:] * dt)
    assert worst == pytest.approx(0.04, abs=0.01)


def test_it_turns_the_shorter_way() -> None:
    """Targets of 200° are reached by 160° the other way; both signs of a quaternion are one rotation."""
    target = rotation.exponential([0.0, 0.0, np.radians(200)])
    error = pose_error(pose(target), np.eye(4))
    np.testing.assert_allclose(error[3:], [0, 0, -np.sin(np.radians(80))], atol=1e-12)


def test_the_error_is_what_the_tool_sees() -> None:
    R = rotation.exponential([0.3, -1.1, 0.6])
    T, target = pose(R), pose(R @ rotation.exponential([0.0, 0.2, 0.0]))
    T[:3, 3], target[:3, 3] = [0.1, 0.2, 0.3], T[:3, 3] + [0.1, 0.2, 0.3] + R @ [0.01, 0.02, 0.03]
    error = pose_error(target, T)
    np.testing.assert_allclose(error, [0.01, 0.02, 0.03, 0, np.sin(0.1), 0], atol=1e-12)


def test_the_position_error_falls_while_the_tool_turns() -> None:
    """ė_p = −Kp e_p with the term −ω × e_p: without it a turning tool would see its error turn. Eqs. 2.61, 2.66."""
    rng = np.random.default_rng(3)
    T, target, ahead = pose(rotation.exponential([0.3, -1.1, 0.6])), np.eye(4), rng.normal(size=6)
    T[:3, 3] = [0.1, 0.2, -0.1]
    h = 1e-6
    error = pose_error(target, T)
    nu = body_velocity(T[:3, :3], ahead, error, 5.0, 10.0)
    later, target_later = T.copy(), target.copy()
    later[:3, 3] += T[:3, :3] @ nu[:3] * h
    later[:3, :3] = T[:3, :3] @ rotation.exponential(nu[3:] * h)
    target_later[:3, 3] += ahead[:3] * h
    rate = (pose_error(target_later, later)[:3] - error[:3]) / h
    np.testing.assert_allclose(rate, -5.0 * error[:3], atol=1e-4)


def still(T: Array, r: int = 2, entry_rate: Array | None = None) -> Callable[[float], RcmReference]:
    rate = np.zeros(r) if entry_rate is None else entry_rate
    return lambda t: RcmReference(T, STILL, rate)


def loop(
    control: RcmControl, reference: Callable[[float], RcmReference], entry: Array, dt: float = 0.002
) -> Iterator[RcmStep]:
    start = RcmState(START, entry)
    return rcm_loop(problem_without_planes(dia10()), through(dia10(), LINK), control, reference, start, dt)


def at_step(moments: Iterator[RcmStep], step: int) -> RcmStep:
    return next(islice(moments, step, None))


def test_errors_of_the_tool_fall_as_the_gains_say() -> None:
    """e_p as e^{−Kp t} and the angle by its quarter tangent, behind a trocar: Kp = 5, Ko = 10, after 0.4 s."""
    T = tool_at(dia10(), START)
    target = T.copy()
    target[:3, 3] += [0.01, -0.015, 0.01]
    target[:3, :3] = T[:3, :3] @ rotation.exponential([0.0, 0.15, -0.1])
    dt, steps = 1e-3, 400
    one = at_step(loop(RcmControl(), still(target), entry_on(dia10(), START, 0.15), dt), steps)
    first = pose_error(target, T)
    np.testing.assert_allclose(one.error[:3], first[:3] * np.exp(-5 * 0.4), rtol=0.006, atol=1e-5)
    quarter = np.tan(np.radians(angle_deg(first)) / 4) * np.exp(-10 * 0.4 / 2)
    assert angle_deg(one.error) == pytest.approx(np.degrees(4 * np.arctan(quarter)), rel=0.01)


def test_drift_feedback_brings_the_shaft_back() -> None:
    """5 mm beside the entry point fall to 5 e^{−5} = 0.034 mm in 1 s at Kr = 5 (0.033 by Euler at 2 ms)."""
    T, R = tool_at(dia10(), START), constrained_at_start().R_world_shaft
    entry = entry_on(dia10(), START, 0.15) + R @ [0.003, 0.0, 0.004]
    one = at_step(loop(RcmControl(entry=5.0), still(T), entry), 500)
    assert 1e3 * np.linalg.norm(one.at.place.lateral) == pytest.approx(0.033, abs=1e-3)
    without = at_step(loop(RcmControl(), still(T), entry), 50)
    assert 1e3 * np.linalg.norm(without.at.place.lateral) == pytest.approx(5.0, abs=1e-9)


def constrained_at_start():
    return constrained(problem_without_planes(dia10()), through(dia10(), LINK), START, entry_on(dia10(), START, 0.15))


@pytest.mark.parametrize("basis", ["source", "scaled"])
def test_the_shaft_follows_a_moving_entry_point(basis) -> None:
    """§3.4: the material point of the shaft at the entry moves with v_rd along x and z of F_r, to 1e-10 m/s."""
    rate = np.array([0.004, -0.003])
    moments = loop(RcmControl(basis=basis), still(tool_at(dia10(), START), 2, rate), entry_on(dia10(), START, 0.15))
    for one in islice(moments, 20):
        point_link = [0.0, one.at.place.outside, 0.0]
        velocity = differential.point_jacobian(dia10(), one.q, point_link, LINK)[:3] @ one.rates
        np.testing.assert_allclose((one.at.R_world_shaft.T @ velocity)[[0, 2]], rate, atol=1e-14)
        np.testing.assert_allclose(one.entry_slip, 0.0, atol=1e-14)
        assert np.linalg.norm(one.error[:3]) < 1e-6


def test_the_entry_point_moves_with_the_shaft_s_axes() -> None:
    """p_rcm ← p_rcm + R_0i (v_x, 0, v_z) Δt."""
    entry, rate = entry_on(dia10(), START, 0.15), np.array([0.004, -0.003])
    first, second = islice(loop(RcmControl(), still(tool_at(dia10(), START), 2, rate), entry), 2)
    expected = first.at.R_world_shaft @ [0.004, 0.0, -0.003] * 0.002
    np.testing.assert_allclose(second.entry_world - first.entry_world, expected, atol=1e-15)
    np.testing.assert_allclose(second.q, first.q + 0.002 * first.rates, atol=1e-15)
    assert (first.t, second.t) == (0.0, 0.002)


@pytest.mark.parametrize("basis", ["source", "scaled"])
@pytest.mark.parametrize("across", [TROCAR, SLIT], ids=["trocar", "slit"])
@pytest.mark.parametrize("name", methods.names())
def test_any_method_may_invert_it(name: str, across: Array, basis) -> None:
    """Whatever a method answers to J^r u = ν − Jc v, the entry point is kept exactly and the tool comes nearer.

    A method that wants J square may refuse the slit, and one that knows the limits of joints every such task.
    """
    method = methods.named(name)
    passage = through(dia10(), LINK, across)
    target = tool_at(dia10(), START)
    target[:3, 3] += [0.002, -0.003, 0.002]
    reference = still(target, passage.r, np.full(passage.r, 1e-4))
    chosen = ConfiguredMethod(method, method.Options())
    entry = entry_on(dia10(), START, 0.15)
    at = constrained(problem_without_planes(dia10()), passage, START, entry, basis)
    if method.applies(at.task(np.zeros(6), np.zeros(passage.r), 0.01)) is not None:
        assert at.J.shape == (6, 7) or Promise.KEEPS_LIMITS in method.PROMISES
        return
    control = RcmControl(of_tool=chosen, basis=basis, entry=5.0)
    start = RcmState(START, entry)
    moments = list(islice(rcm_loop(problem_without_planes(dia10()), passage, control, reference, start, 0.01), 100))
    assert max(np.abs(one.entry_slip).max() for one in moments) < 1e-13
    assert np.linalg.norm(moments[-1].error[:3]) < np.linalg.norm(moments[0].error[:3])


def test_what_a_method_remembers_is_carried_along() -> None:
    """The filtered inverse starts once, and each step begins with the memory that the last one left."""
    filtered = configured_method("filtered_modified")
    reference = still(tool_at(dia10(), START) @ pose(rotation.exponential([0.0, 0.1, 0.0])))
    control = RcmControl(of_tool=filtered, of_arm=filtered)
    moments = list(islice(loop(control, reference, entry_on(dia10(), START, 0.15)), 3))
    problem = problem_without_planes(dia10())
    memory = None
    for one in moments:
        task = one.at.task(
            body_velocity(one.at.T_world_tool[:3, :3], STILL, one.error, control.position, control.orientation),
            one.task,
            0.002,
        )
        solution, memory = filtered.answered(problem, task, memory)
        np.testing.assert_array_equal(solution.rates, one.tool.rates)
    anew, _ = filtered.answered(problem, task, None)
    assert not np.array_equal(anew.rates, moments[-1].tool.rates)


def test_methods_go_by_their_names() -> None:
    assert configured_method("damped", damping=0.05).options.damping == 0.05
    with pytest.raises(HelicoideError, match="pseudoinverse"):
        configured_method("guess")
