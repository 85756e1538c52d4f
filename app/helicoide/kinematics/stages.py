"""Forward kinematics joint by joint, as its sources print it: the factor of each joint and the partial product."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.kinematics.chain import Joint, joint_positions
from helicoide.kinematics.forward import dh_frames, link_motors, screw_displacements
from helicoide.kinematics.robot import Robot

StageKind = Literal["dh", "screws", "products"]
SOURCE_LENGTH, SOURCE_ANGLE = 1000.0, float(np.degrees(1.0))


@dataclass(frozen=True, eq=False)
class JointStage:
    """A joint, its parameters, and the product of the transforms up to it.

    angles, rad, and lengths, m, numbers or (3,), by their symbols; direction (3,): unit axis of a screw, else None.
    partial: T₀ A₁ … Aᵢ or H₁ … Hᵢ, (4, 4), m; or h₁ … hᵢ, (8,), the coefficients 1, i, j, k, ε, iε, jε, kε, m.
    """

    joint: str
    angles: dict[str, float]
    lengths: dict[str, Array]
    direction: Array | None
    partial: Array


def dh_stages(robot: Robot, q: Array) -> list[JointStage]:
    """DH rows with the joint values q (n,), rad or m, and the DH frames in the base frame.

    The last stage is the last DH frame, not the tool. Source: Cerbaro 2022, eqs. 4, 57 and 59; Campos 1998, s.40.
    """
    stages = []
    values = joint_positions(robot.chain, q)
    for row, joint, value, T in zip(robot.dh.rows, robot.joints, values, dh_frames(robot, q)[1:], strict=True):
        theta, d = (row.theta, row.d + value) if joint.is_prismatic else (row.theta + value, row.d)
        angles, lengths = {"θ": float(theta), "α": row.alpha}, {"d": np.asarray(d), "a": np.asarray(row.a)}
        stages.append(JointStage(joint.name, angles, lengths, None, T))
    return stages


def screw_stages(robot: Robot, q: Array) -> list[JointStage]:
    """Screw axes at q = 0, and the displacements H₁ … Hᵢ from there, base frame; q (n,), rad or m.

    Source: Cerbaro 2022, App. D, eqs. 7 and 8.
    """
    return _of_screws(robot, q, screw_displacements(robot, q)[1:])


def product_stages(robot: Robot, q: Array) -> list[JointStage]:
    """Screw axes at q = 0, and the displacements from there as dual quaternions, h₁ … hᵢ; q (n,), rad or m.

    Source: Cerbaro 2022, eqs. 15 and 103, with joint n innermost.
    """
    return _of_screws(robot, q, [rigid.dual_quaternion(motor) for motor in link_motors(robot, q)[1:]])


STAGES: dict[StageKind, Callable[[Robot, Array], list[JointStage]]] = {
    "dh": dh_stages,
    "screws": screw_stages,
    "products": product_stages,
}


def _of_screws(robot: Robot, q: Array, partial: list[Array]) -> list[JointStage]:
    values = zip(robot.joints, joint_positions(robot.chain, q), partial, strict=True)
    return [_of_screw(joint, float(value), reached) for joint, value, reached in values]


def _of_screw(joint: Joint, value: float, partial: Array) -> JointStage:
    angles = {} if joint.is_prismatic else {"θ": value}
    lengths = {"t": np.asarray(value)} if joint.is_prismatic else {}
    return JointStage(joint.name, angles, lengths | {"s₀": joint.point}, joint.direction, partial)


def in_source_units(stage: JointStage) -> JointStage:
    """The stage in millimetres and degrees, as the sources print it."""
    partial = stage.partial.copy()
    partial[(slice(4, None),) if partial.ndim == 1 else (slice(0, 3), 3)] *= SOURCE_LENGTH
    angles = {name: SOURCE_ANGLE * value for name, value in stage.angles.items()}
    lengths = {name: SOURCE_LENGTH * value for name, value in stage.lengths.items()}
    return replace(stage, angles=angles, lengths=lengths, partial=partial)
