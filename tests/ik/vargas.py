"""Arms, trajectories and runs of the simulations of Vargas 2013 (App. B, App. C, §5); t in s, q in rad.

A scale of 0.01 keeps the centimetres of the source: γ, δ₀ and w₀ then have its numbers, and errors come out in cm.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import islice
from math import cos, pi, sin
from typing import Any

import numpy as np

from helicoide.confinement import Planes
from helicoide.ik import Limits, Problem, methods
from helicoide.ik.clik import Aim, Aiming, OrientationError, followed, tool_aim
from helicoide.kinematics.chain import Array
from helicoide.kinematics.forward import link_poses
from helicoide.kinematics.library import load
from helicoide.kinematics.robot import Robot

Path = Callable[[float], tuple[Any, Any]]

IN_PLANE, WITH_ANGLE, IN_SPACE, POSE = [0, 1], [0, 1, 5], [0, 1, 2], [0, 1, 2, 3, 4, 5]
FOLDED = np.array([0, pi / 2, -pi])
REACH = 67.30


def problem(robot: Robot, scale: float) -> Problem:
    """An arm without planes."""
    return Problem(robot, Limits(robot.lower, robot.upper, robot.speed), Planes(np.zeros((0, 3)), ()), scale=scale)


def planar() -> Problem:
    """Planar 3R, l = (2, 1, 1), its lengths as they are."""
    return problem(load("planar3r"), 1.0)


def zebra_arm() -> Problem:
    """Zebra-ZERO with its last three joints fixed at 0, in cm."""
    robot = load("zebra_zero")
    return problem(replace(robot, joints=robot.joints[:3]), 0.01)


def zebra_wrist() -> Problem:
    """Zebra-ZERO with the wrist point for its tool, in cm."""
    robot = load("zebra_zero")
    T = np.eye(4)
    T[:3, 3] = 0.2794, 0, 0.2286
    return problem(replace(robot, T_world_tool_0=T), 0.01)


def zebra(scale: float) -> Problem:
    """Zebra-ZERO, the effector for its tool."""
    return problem(load("zebra_zero"), scale)


# Trajectories 1 to 11: position and velocity, in lengths of the arm (1 to 4) or in cm.


def path_1(t: float) -> tuple[Any, Any]:
    return (2 + 0.5 * sin(0.4 * t), 0.5 * cos(0.2 * t), 0), (0.2 * cos(0.4 * t), -0.1 * sin(0.2 * t), 0)


def path_2(t: float) -> tuple[Any, Any]:
    return (2.5 + 0.5 * sin(0.2 * t), 0.5 * cos(0.2 * t), 0), (0.1 * cos(0.2 * t), -0.1 * sin(0.2 * t), 0)


def path_3(t: float) -> tuple[Any, Any]:
    return (2.26 - t / 11, 3.23 - t / 8, 0), (-1 / 11, -1 / 8, 0)


def path_4(t: float) -> tuple[Any, Any]:
    return (0, 4 - t / 8, 0), (0, -1 / 8, 0)


def _swept(across: float, along: float) -> Path:
    """Trajectories 6 and 8: (a + 5 sin 0.2πt, 7.5 sin 0.1πt) in two axes, cm."""

    def at(t: float) -> tuple[Any, Any]:
        return (5 * sin(0.2 * pi * t) + across, 7.5 * sin(0.1 * pi * t), along), (
            pi * cos(0.2 * pi * t),
            0.75 * pi * cos(0.1 * pi * t),
            0,
        )

    return at


path_6, path_8 = _swept(45.86, 0), _swept(63.36, 0)


def path_7(t: float) -> tuple[Any, Any]:
    return (0, 5 * sin(0.2 * pi * t), 7.5 * sin(0.1 * pi * t) + 53.86), (
        0,
        pi * cos(0.2 * pi * t),
        0.75 * pi * cos(0.1 * pi * t),
    )


def _ellipse(centre: float) -> Path:
    """Trajectories 10 and 11, cm."""
    return lambda t: (
        (14.6 * sin(0.2 * t) + centre, 7 * cos(0.2 * t), 20),
        (2.92 * cos(0.2 * t), -1.4 * sin(0.2 * t), 0),
    )


path_10, path_11 = _ellipse(15.5), _ellipse(30.5)


def faster(path: Path, times: float) -> Path:
    """The same way at a multiple of the speed."""
    return lambda t: (path(times * t)[0], np.multiply(times, path(times * t)[1]))


def turned(axis: int, angle: float) -> Array:
    """Rotation about y (axis 1) or z (axis 2), (3, 3)."""
    c, s = cos(angle), sin(angle)
    return np.array([[[c, 0, s], [0, 1, 0], [-s, 0, c]], [[c, -s, 0], [s, c, 0], [0, 0, 1]]][axis - 1])


def tracking(
    task: Problem,
    path: Path,
    rows: list[int],
    R_target: Array | None = None,
    unit: float = 0.01,
    measure: OrientationError = "quaternion",
) -> Aiming:
    """Aim at a trajectory, in units of metres, with some rows of the twist of the tool."""

    def aiming(q: Array, t: float) -> Aim:
        T, ahead = np.eye(4), np.zeros(6)
        x, v = path(t)
        T[:3, 3], ahead[:3] = np.multiply(unit, x), np.multiply(unit, v)
        if R_target is not None:
            T[:3, :3] = R_target
        poses = link_poses(task.robot.chain, q)
        aim = tool_aim(task, poses, T, R_target is not None, ahead, measure)
        return Aim(aim.J[rows], aim.error[rows], aim.ahead[rows])

    return aiming


def record(
    task: Problem,
    name: str,
    options: dict[str, Any],
    aiming: Aiming,
    gains: Array | float,
    q: Any,
    dt: float,
    seconds: float,
) -> tuple[Array, Array, Array, Array]:
    """A run of a method by its name: t (k,), q (k, n), e (k, r), q̇ (k, n)."""
    method = methods.named(name)
    moments = followed(task, method, method.Options(**options), aiming, gains, np.array(q, float), dt)
    kept = [(m.t, m.q, m.aim.error, m.solution.rates) for m in islice(moments, round(seconds / dt) + 1)]
    t, at, e, rates = (np.array(column) for column in zip(*kept, strict=True))
    return t, at, e, rates


def largest(values: Array, when: Array | slice = slice(None)) -> float:
    """The largest absolute entry over the chosen instants."""
    return float(np.abs(values[when]).max())


def sizes(vectors: Array) -> Array:
    """‖e‖ at every instant."""
    return np.asarray(np.linalg.norm(vectors, axis=1))


def rms(values: Array) -> float:
    """√(mean of squares)."""
    return float(np.sqrt(np.mean(values**2)))


def left_at(q: Array, t: Array, by: float = 0.01) -> float:
    """When some joint has first moved by an angle from where it began, s; infinite when none has."""
    moved = np.abs(q - q[0]).max(axis=1) > by
    return float(t[moved.argmax()]) if moved.any() else np.inf


# The simulations themselves.

DAMPED = {"damping": 300.0, "threshold": 1e3}
DAMPED_PLANAR = {"damping": 0.1, "threshold": 1.0}
FEEDBACK = {"gain": 60.0, "coupling": 0.3, "leak": 0.5}
# the arms and trajectories of Sims. 4 to 7 and 10 to 13
PLANAR_SIMS = {
    4: (path_2, [pi / 6] * 3),
    5: (path_3, [0.5, 0.6, 0.6]),
    6: (path_4, [pi / 2, 0, 0]),
    7: (path_4, [pi / 2, 0.1, 0.1]),
}
ARM_SIMS = {"10": (path_6, FOLDED), "11": (path_7, FOLDED), "12": (path_8, FOLDED)}
ARM_SIMS["11b"] = path_7, np.array([0, pi / 2 - 0.1, 0.1 - pi / 2])


def planar_sim(sim: int, name: str, options: dict[str, Any], dt: float, seconds: float) -> tuple[Array, ...]:
    """Sims. 4 to 7 with λ = 2; the parameters are those of the digest of the source, which gives none."""
    path, start = PLANAR_SIMS[sim]
    arm = planar()
    return record(arm, name, options, tracking(arm, path, IN_PLANE, unit=1.0), 2.0, start, dt, seconds)


def arm_sim(sim: str, name: str, options: dict[str, Any], dt: float, seconds: float) -> tuple[Array, ...]:
    """Sims. 10 to 13 with λ = 2: the position of the Zebra-ZERO."""
    path, start = ARM_SIMS[sim]
    arm = zebra_arm()
    return record(arm, name, options, tracking(arm, path, IN_SPACE), 2.0, start, dt, seconds)


def wrist_sim(name: str, options: dict[str, Any], dt: float, seconds: float, speed: float = 1.0) -> tuple[Array, ...]:
    """Sim. 3 with λ = 5: the wrist on trajectory 10, R_d = R_y(π/2)."""
    arm, start = zebra_wrist(), [0, pi / 2, -pi, 0, -pi / 2, 0]
    aiming = tracking(arm, faster(path_10, speed), POSE, turned(1, pi / 2))
    return record(arm, name, options, aiming, 5.0, start, dt, seconds)


def weighted_sim(gains: list[float], dt: float, seconds: float) -> tuple[Array, ...]:
    """Sim. 14: the effector on trajectory 11, R_d = R_y(π), modified law with γ = 25 in dm; a gain for each row."""
    arm, start = zebra(0.1), [0, pi / 2, -pi, 0, -pi / 2, 0]
    aiming = tracking(arm, path_11, POSE, turned(1, pi))
    return record(arm, "filtered_modified", {"gain": 25.0}, aiming, np.array(gains), start, dt, seconds)


def effector(q: Array) -> Array:
    """Where the effector of the Zebra-ZERO is while its last three joints are at 0, cm. Args: q (k, 3)."""
    q1, q2, q3 = q.T
    r = 27.94 * np.cos(q2) - 39.36 * np.sin(q2 + q3)
    return np.stack([r * np.cos(q1), r * np.sin(q1), 27.94 * np.sin(q2) + 39.36 * np.cos(q2 + q3)], axis=1)


def unreachable(t: Array) -> Array:
    """When trajectory 8 leaves the workspace."""
    return np.array([np.linalg.norm(path_8(at)[0]) > REACH for at in t])


def dips(t: Array, q: Array) -> tuple[Array, Array]:
    """When, and how far, the effector draws back from the border of the workspace while trajectory 8 is beyond it, cm.

    Dips of less than 1e-3 cm do not count. Args: t (k,), q (k, 3).
    """
    outside = (t > 11.41) & (t < 13.2)
    depth = REACH - sizes(effector(q[outside]))
    inner = np.flatnonzero((depth[1:-1] > depth[:-2]) & (depth[1:-1] >= depth[2:]) & (depth[1:-1] > 1e-3)) + 1
    return t[outside][inner], depth[inner]


def re_entry(t: Array, e: Array) -> tuple[float, ...]:
    """‖e‖ a quarter, half and a whole second after trajectory 8 has come back at 13.73 s."""
    return tuple(float(np.interp(13.73 + after, t, sizes(e))) for after in (0.25, 0.5, 1.0))


def manipulability(q: Array) -> Array:
    """w of the position of the Zebra-ZERO, cm³: that of J by central differences of `effector`. Args: q (k, 3)."""
    columns = [(effector(q + way) - effector(q - way)) / 2e-5 for way in 1e-5 * np.eye(3)]
    return np.abs(np.linalg.det(np.stack(columns, axis=-1)))
