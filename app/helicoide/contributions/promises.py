"""Check that a method gives usable answers, and that it keeps each of its promises, on one arm."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from helicoide.arrays import frozen
from helicoide.contributions.trials import (
    bare_state,
    clear_of_singularities,
    closed_loop_to,
    controller_step,
    far_poses,
    missing,
    singular_starts,
)
from helicoide.ik.controller import Controller, step
from helicoide.ik.method import Promise
from helicoide.ik.methods import named
from helicoide.ik.postures.branch import tool_at
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.state import with_joints
from helicoide.text import Text

DTS = (0.001, 0.003, 0.01, 0.02, 0.05)
# Arms for which the first of `singular_starts` is the stretched posture.
STRETCHED = ("planar2r", "planar3r", "movemaster", "puma560", "zebra_zero")
CHANGED, STAYED, ROUNDING = 1e-3, 1e-6, 1e-9
NOT_FINITE = Text(en="an answer is not finite", pt_BR="uma resposta não é finita")
NO_FIGURE = Text(en="figures without a title in FIGURES: {names}", pt_BR="valores sem título em FIGURES: {names}")
NOTHING = Text(en="its answer is zero for every asked velocity", pt_BR="a resposta é zero para toda velocidade pedida")
BROKEN = Text(en="it does not keep {promise}: {what}", pt_BR="não cumpre {promise}: {what}")
LEFT = Text(en="{left:.3g} of {way:.3g} is left of the way", pt_BR="do caminho de {way:.3g} ainda falta {left:.3g}")
MISSED = Text(en="J q̇ differs from ν by {off:.1e}", pt_BR="J q̇ difere de ν em {off:.1e}")
FAST = Text(en="‖q̇‖ is {times:.0f} times ‖ν‖", pt_BR="‖q̇‖ é {times:.0f} vezes ‖ν‖")
BEYOND = Text(en="a joint is beyond a limit or its speed", pt_BR="uma junta passa de um limite ou da sua velocidade")
MOVED = Text(en="the joints moved by {moved:.1e}", pt_BR="as juntas se moveram {moved:.1e}")


def answers(name: str, robot: str, with_orientation: bool) -> Text | None:
    """For targets that jump by metres, answers are finite and not all zero, and every figure has a title."""
    state, rng, most = bare_state(robot), np.random.default_rng(1), 0.0
    drive, q = Controller().with_method(name), state.arm.q
    for T in far_poses(state.robot, rng):
        for _ in range(10):
            displacement, drive = controller_step(
                with_joints(state, q), T, with_orientation, drive, float(rng.choice(DTS))
            )
            if drive.solution is None or not np.isfinite(displacement).all():
                return NOT_FINITE
            if untitled := set(drive.solution.figures) - set(named(name).FIGURES):
                return NO_FIGURE.format(names=", ".join(sorted(untitled)))
            most = max(most, float(np.abs(displacement).max()))
            q = frozen(np.clip(q + np.clip(displacement, -0.2, 0.2), state.robot.lower, state.robot.upper))
    return None if most > 0 else NOTHING


def keeps_limits(name: str, robot: str, with_orientation: bool) -> Text | None:
    """KEEPS_LIMITS: joints stay inside their limits and speeds for targets that jump."""
    state, rng = bare_state(robot), np.random.default_rng(7)
    drive, q = Controller().with_method(name), state.arm.q
    for T in far_poses(state.robot, rng):
        for _ in range(40):
            dt = float(rng.choice(DTS))
            displacement, drive = controller_step(with_joints(state, q), T, with_orientation, drive, dt)
            q = frozen(q + displacement)
            beyond = np.maximum(state.robot.lower - q, q - state.robot.upper).max()
            if not max(beyond, (np.abs(displacement) / dt - state.robot.speed).max()) <= ROUNDING:
                return broken(Promise.KEEPS_LIMITS, BEYOND)
    return None


def converges(name: str, robot: str, with_orientation: bool) -> Text | None:
    """CONVERGES: from a near posture, `missing` falls below 0.001, or below a fiftieth of its first value."""
    state, rng = bare_state(robot), np.random.default_rng(2)
    q, goal = clear_of_singularities(state.robot, rng, with_orientation)
    T, drive = tool_at(state.robot, goal), Controller().with_method(name)
    way = missing(with_joints(state, q), T, with_orientation)
    for _ in range(200):
        displacement, drive = controller_step(with_joints(state, q), T, with_orientation, drive, 0.02)
        q = frozen(q + displacement)
    left = missing(with_joints(state, q), T, with_orientation)
    return None if left < max(1e-3, 0.02 * way) else broken(Promise.CONVERGES, LEFT.format(left=left, way=way))


def exact(name: str, robot: str, with_orientation: bool) -> Text | None:
    """EXACT: J q̇ = ν for every ν in the range of J, away from singular postures."""
    state, rng = bare_state(robot), np.random.default_rng(4)
    for _ in range(10):
        q, _ = clear_of_singularities(state.robot, rng, with_orientation)
        task = closed_loop_to(with_joints(state, q), state.T_world_tool, with_orientation)
        task = replace(task, rate=task.J @ rng.normal(size=len(q)))
        _, drive = step(state.problem, task, state.arm.poses, Controller().with_method(name))
        off = np.inf if drive.solution is None else float(np.abs(task.J @ drive.solution.rates - task.rate).max())
        if not off <= 1e-9:
            return broken(Promise.EXACT, MISSED.format(off=off))
    return None


def bounded(name: str, robot: str, with_orientation: bool) -> Text | None:
    """BOUNDED: ‖q̇‖ ≤ 100 ‖ν‖ in every step of a motion that begins in a singular posture."""
    state, rng = bare_state(robot), np.random.default_rng(6)
    for start in singular_starts(state, with_orientation):
        q, drive = start, Controller().with_method(name)
        T = tool_at(state.robot, start + 0.3 * rng.normal(size=len(start)))
        for _ in range(40):
            task = closed_loop_to(with_joints(state, q), T, with_orientation)
            displacement, drive = step(state.problem, task, state.arm.poses, drive)
            rates = np.inf if drive.solution is None else float(np.linalg.norm(drive.solution.rates))
            size = float(np.linalg.norm(task.rate))
            if not rates <= 100 * size + 1e-12:
                return broken(Promise.BOUNDED, FAST.format(times=rates / max(size, 1e-12)))
            q = frozen(q + displacement)
    return None


def leaves_singular(name: str, robot: str, with_orientation: bool) -> Text | None:
    """LEAVES_SINGULAR: the stretched arm moves if the task asks for the lost direction."""
    if robot not in STRETCHED or with_orientation:
        return None
    moved = moved_from_singular(name, robot)
    return broken(Promise.LEAVES_SINGULAR, MOVED.format(moved=moved)) if not moved > CHANGED else None


def stays_singular(name: str, robot: str, with_orientation: bool) -> Text | None:
    """STAYS_SINGULAR: the stretched arm does not move if the task asks for the lost direction."""
    if robot not in STRETCHED or with_orientation:
        return None
    moved = moved_from_singular(name, robot)
    return broken(Promise.STAYS_SINGULAR, MOVED.format(moved=moved)) if not moved < STAYED else None


def moved_from_singular(name: str, robot: str) -> float:
    """The largest joint displacement, rad or m, of the stretched arm in 200 steps that ask for the lost direction."""
    state = bare_state(robot)
    start = singular_starts(state, with_orientation=False)[0]
    lost = analyse_jacobian(closed_loop_to(with_joints(state, start), state.T_world_tool, False).J).lost_velocities[
        :, -1
    ]
    drive, q = Controller().with_method(name), start
    for _ in range(200):
        task = closed_loop_to(with_joints(state, q), state.T_world_tool, False)
        displacement, drive = step(state.problem, replace(task, rate=-0.1 * lost), state.arm.poses, drive)
        q = frozen(q + displacement)
    return float(np.abs(q - start).max())


def broken(promise: Promise, what: Text) -> Text:
    """The fault that a promise is not kept, with details."""
    return BROKEN.format(promise=promise.name, what=what)


HELD: Mapping[Promise, Callable[[str, str, bool], Text | None]] = MappingProxyType(
    {
        Promise.CONVERGES: converges,
        Promise.EXACT: exact,
        Promise.BOUNDED: bounded,
        Promise.KEEPS_LIMITS: keeps_limits,
        Promise.LEAVES_SINGULAR: leaves_singular,
        Promise.STAYS_SINGULAR: stays_singular,
    }
)
