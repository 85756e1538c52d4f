"""Drive the arm as users do: random requests through the gate, ticks through `lived`, and a check of every promise."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from helicoide import gate
from helicoide.arrays import Array, frozen
from helicoide.foresight import advance_with_search
from helicoide.geometry import rotation
from helicoide.ik import Limits
from helicoide.ik.guard.collision import clearances
from helicoide.ik.packing import packed
from helicoide.kinematics.robot import Robot
from helicoide.readout import plane_distances
from helicoide.state import State, Update, with_joints

Random = np.random.Generator
RandomRequest = Callable[[Random, State], Update]
ROUNDING = 1e-9
ON_THE_WAY = 2e-3  # parking begins up to 1e-3 rad from `ready`


def after(state: State, seconds: float, dt: float = 0.01) -> State:
    """The state after some seconds without requests."""
    for _ in range(round(seconds / dt)):
        state = advance_with_search(state, dt)
    return state


def quaternion(rng: Random) -> Array:
    """A random orientation, wxyz."""
    wxyz = rng.normal(size=4)
    return np.asarray(wxyz / np.linalg.norm(wxyz))


def clear_posture(rng: Random, state: State, clearance: float) -> Array:
    """Random joint values within the limits, without collision, guarded points at least `clearance` m from planes."""
    limits = state.problem.limits
    while True:
        q = frozen(rng.uniform(limits.lower, limits.upper))
        if plane_distances(with_joints(state, q)).min() >= clearance and apart(with_joints(state, q)) > 0:
            return q


def apart(state: State) -> float:
    """The smallest clearance between two bodies of the arm, m; negative if they are too near."""
    left = clearances(packed(state.problem), state.arm.q)
    return float(left[len(state.monitored_points) * len(state.problem.planes.normals) :].min(initial=np.inf))


def place(rng: Random) -> Array:
    """A random position (3,), m: mostly reachable, sometimes behind planes or below the bench, sometimes far away."""
    reach = rng.choice([0.5, 1.0, 2.9], p=[0.6, 0.3, 0.1])
    centre = np.array([0, 0, 0.3 if reach < 2 else 0.0])
    return np.asarray(centre + rng.uniform(-reach, reach, 3))


def target(rng: Random, state: State) -> Update:
    return gate.set_target(place(rng), quaternion(rng))


def dragged_target(rng: Random, state: State) -> Update:
    phase = rng.choice(["start", "update", "update", "update", "end"], p=[0.3, 0.2, 0.2, 0.2, 0.1])
    return gate.drag_target("seat", phase, place(rng), quaternion(rng))


def dragged_plane(rng: Random, state: State) -> Update:
    """A drag that pushes a plane, rotates it a little, or puts it anywhere."""
    index = int(rng.integers(len(state.robot.panes)))
    planes = state.problem.planes
    wxyz = quaternion(rng)
    centre = planes.centres[index] + rng.normal(size=3) * rng.choice([0.01, 0.3])
    if rng.random() < 0.7:
        wxyz = turning_z_to(planes.normals[index] + 0.1 * rng.normal(size=3))
    return gate.drag_plane("seat", rng.choice(["start", "start", "update", "end"]), index, centre, wxyz)


def turning_z_to(direction: Array) -> Array:
    """A quaternion that rotates z to a direction by the smallest angle."""
    n = direction / np.linalg.norm(direction)
    wxyz = np.array([1 + n[2], -n[1], n[0], 0.0])
    return wxyz / np.linalg.norm(wxyz) if n[2] > -1 + 1e-9 else np.array([0.0, 1, 0, 0])


def joint(rng: Random, state: State) -> Update:
    limits = state.problem.limits
    i = int(rng.integers(len(state.arm.q)))
    return gate.set_joint(i, rng.uniform(limits.lower[i], limits.upper[i]))


def posture(rng: Random, state: State) -> Update:
    return gate.go_to(str(rng.choice([*state.robot.poses])))


def limits(rng: Random, state: State) -> Update:
    """Narrower or wider limits than the robot's own, perhaps with the arm outside; lower or higher speeds."""
    robot = state.robot
    if rng.random() < 0.3:
        changed = Limits(robot.lower, robot.upper, robot.speed)
    else:
        inward, outward = rng.uniform(-0.3, 0.8, (2, len(state.arm.q)))
        changed = Limits(
            frozen(robot.lower + inward), frozen(robot.upper - outward), frozen(robot.speed * rng.uniform(0.1, 2))
        )
        if (changed.lower >= changed.upper).any():
            return lambda state: state
    return lambda state: replace(state, problem=replace(state.problem, limits=changed))


REQUESTS: list[tuple[float, RandomRequest]] = [
    (6, target),
    (5, dragged_target),
    (5, dragged_plane),
    (3, joint),
    (2, posture),
    (2, limits),
    (1, lambda rng, state: gate.restore_planes()),
    (2, lambda rng, state: gate.keep_orientation(rng.random() < 0.5)),
    (1, lambda rng, state: gate.stop()),
    (2, lambda rng, state: gate.play()),
    (1, lambda rng, state: gate.scrub(rng.uniform(0, 1))),
    (1, lambda rng, state: gate.pause()),
    (1, lambda rng, state: gate.park()),
    (2, lambda rng, state: gate.get_ready()),
    (1, lambda rng, state: gate.set_gripper(rng.random())),
]
SHARES = np.array([weight for weight, _ in REQUESTS]) / sum(weight for weight, _ in REQUESTS)


@dataclass
class Worst:
    """The worst value of each checked quantity so far."""

    ticks: int = 0
    clearance: float = np.inf
    beyond: float = -np.inf
    too_fast: float = -np.inf
    beside: float = 0.0


def beyond(state: State, q: Array) -> Array:
    """By how much each joint is outside the limits, (n,), rad; zero inside."""
    return np.maximum(0, np.maximum(state.problem.limits.lower - q, q - state.problem.limits.upper))


def beside(robot: Robot, q: Array) -> float:
    """Distance of joint values from the straight path between `home` and `ready`, rad."""
    home, ready = robot.poses["home"], robot.poses["ready"]
    share = np.clip((q - home) @ (ready - home) / np.sum((ready - home) ** 2), 0, 1)
    return float(np.abs(q - home - share * (ready - home)).max())


def watch(worst: Worst, old: State, new: State, dt: float) -> None:
    """Check every promise for one tick."""
    worst.ticks += 1
    arrays = (new.arm.q, new.arm.velocities, new.arm.poses, new.problem.planes.normals, new.problem.planes.centres)
    assert all(np.isfinite(array).all() and not array.flags.writeable for array in arrays)
    np.testing.assert_allclose(new.arm.q - old.arm.q, new.arm.velocities * dt, rtol=0, atol=1e-12)
    worst.too_fast = max(worst.too_fast, float((np.abs(new.arm.velocities) - new.problem.limits.speed).max()))
    if old.arm.parked or new.arm.parked:
        worst.beside = max(worst.beside, beside(new.robot, new.arm.q))
        assert worst.beside <= ON_THE_WAY
    else:
        worst.beyond = max(worst.beyond, float((beyond(new, new.arm.q) - beyond(new, old.arm.q)).max()))
    if not new.arm.parked:
        worst.clearance = min(
            worst.clearance, float(plane_distances(new).min(initial=np.inf)) - new.problem.zones.critical
        )
    assert worst.too_fast <= ROUNDING
    assert worst.beyond <= ROUNDING
    assert worst.clearance >= -ROUNDING


def rough_ride(state: State, rng: Random, ticks: int) -> Worst:
    """Requests at random times, ticks of random length, and a check of every promise."""
    worst = Worst()
    while worst.ticks < ticks:
        _, request = REQUESTS[rng.choice(len(REQUESTS), p=SHARES)]
        state = request(rng, state)(state)
        dt = float(np.exp(rng.uniform(np.log(0.001), np.log(0.05))))
        for _ in range(int(rng.integers(1, rng.choice([5, 50, 300])))):
            new = advance_with_search(state, dt)
            watch(worst, state, new, dt)
            state = new
    return worst


def clear_goal(rng: Random, state: State, clearance: float = 0.110) -> tuple[State, Array]:
    """The arm in a clear posture, and the tool pose of another one; the straight path between them is clear too."""
    start = with_joints(state, clear_posture(rng, state, clearance))
    return start, with_joints(state, clear_posture(rng, state, clearance)).T_world_tool


def misses(start: State, T_world_target: Array, with_orientation: bool, seconds: float = 12.0) -> float:
    """The distance of the tool from a target after at most `seconds`, m; it ends early at 0.1 mm."""
    position = T_world_target[:3, 3]
    state = gate.keep_orientation(with_orientation)(start)
    state = gate.set_target(position, rotation.from_matrix(T_world_target[:3, :3]))(state)
    for _ in range(round(10 * seconds)):
        state = after(state, 0.1)
        if np.linalg.norm(state.T_world_tool[:3, 3] - position) < 1e-4:
            break
    return float(np.linalg.norm(state.T_world_tool[:3, 3] - position))
