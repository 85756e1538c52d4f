"""Repairs of a URDF's joints: joints that cannot move become fixed, and each mimic joint follows an independent one."""

from __future__ import annotations

import numpy as np
import yourdfpy

from helicoide.arrays import Array
from helicoide.geometry import rotation

MOVING = ("revolute", "continuous", "prismatic")


def repair_joints(robot: yourdfpy.Robot) -> list[str]:
    """Fix joints whose range is one value, compose mimics of mimics, and fix mimics of fixed joints.

    A mimic joint has x = r y + s for the value y of its leader, which may itself have y = r′ z + s′:
    x = r r′ z + r s′ + s. A joint that follows itself, or an unknown one, is left unchanged. Returns the names of the
    joints that their limits fix.
    """
    held = list[str]()
    stands = {joint.name: 0.0 for joint in robot.joints if joint.type == "fixed"}
    for joint in robot.joints:
        if joint.type in MOVING and joint.mimic is None and (value := _only_value(joint)) is not None:
            _fix(joint, value)
            stands[joint.name] = value
            held.append(str(joint.name))
    known = {joint.name: joint for joint in robot.joints}
    composed = [(joint, _composed(joint, known)) for joint in robot.joints if joint.mimic and joint.type in MOVING]
    for joint, mimic in composed:
        if mimic is not None and (mimic.joint in stands or mimic.multiplier == 0):
            _fix(joint, mimic.multiplier * stands.get(mimic.joint, 0.0) + mimic.offset)
        elif mimic is not None:
            joint.mimic = mimic
    return held


def _only_value(joint: yourdfpy.Joint) -> float | None:
    """The value of a joint whose lower and upper limits are equal; else None."""
    limit = joint.limit
    if joint.type == "continuous" or limit is None or limit.lower is None or limit.lower != limit.upper:
        return None
    return float(limit.lower) if np.isfinite(limit.lower) else None


def _composed(joint: yourdfpy.Joint, known: dict[str, yourdfpy.Joint]) -> yourdfpy.Mimic | None:
    """The mimic relation to the independent joint at the end of the chain of mimics; None if there is none."""
    ratio, shift, seen = 1.0, 0.0, {joint.name}
    while joint.mimic is not None and joint.type in MOVING:
        if joint.mimic.joint not in known or joint.mimic.joint in seen:
            return None
        shift += ratio * joint.mimic.offset
        ratio *= joint.mimic.multiplier
        joint = known[joint.mimic.joint]
        seen.add(joint.name)
    return yourdfpy.Mimic(joint=joint.name, multiplier=ratio, offset=shift)


def _fix(joint: yourdfpy.Joint, value: float) -> None:
    """Make a joint fixed at a value, rad or m."""
    origin = np.eye(4) if joint.origin is None else joint.origin
    joint.origin = origin @ joint_transform(joint, value)
    joint.type, joint.mimic = "fixed", None


def joint_transform(joint: yourdfpy.Joint, value: float) -> Array:
    """Displacement of a joint's child link, (4, 4), m, from zero to a value, rad or m."""
    T, axis = np.eye(4), np.asarray(joint.axis, dtype=np.float64)
    if joint.type == "prismatic":
        T[:3, 3] = value * axis
    elif axis.any():
        half = value / 2
        T[:3, :3] = rotation.to_matrix(np.array([np.cos(half), *(np.sin(half) * axis)]))
    return T
