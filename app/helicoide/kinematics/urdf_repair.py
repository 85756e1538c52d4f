"""A URDF's joints put right: those that cannot move are fixed, those that follow follow one that moves by itself."""

from __future__ import annotations

import numpy as np
import yourdfpy

from helicoide.arrays import Array
from helicoide.geometry import rotation

MOVING = ("revolute", "continuous", "prismatic")


def repair_joints(robot: yourdfpy.Robot) -> list[str]:
    """Fix the joints whose range is one value, compose what follows a follower, and fix what follows a fixed joint.

    A follower stands at x = r y + s of a joint at y, which may stand at y = r′ z + s′ of another one itself:
    x = r r′ z + r s′ + s. One that follows itself, or none that is there, is left as it is. Returns the joints that
    their limits hold at one value.
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
    """Where a joint stands whose lower limit is its upper one."""
    limit = joint.limit
    if joint.type == "continuous" or limit is None or limit.lower is None or limit.lower != limit.upper:
        return None
    return float(limit.lower) if np.isfinite(limit.lower) else None


def _composed(joint: yourdfpy.Joint, known: dict[str, yourdfpy.Joint]) -> yourdfpy.Mimic | None:
    """Whom a joint follows in the end, and how; None where that is nobody, or itself."""
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
    """Make a joint one that stands at a value, rad or m, for good."""
    origin = np.eye(4) if joint.origin is None else joint.origin
    joint.origin = origin @ joint_transform(joint, value)
    joint.type, joint.mimic = "fixed", None


def joint_transform(joint: yourdfpy.Joint, value: float) -> Array:
    """How a joint moves what it carries, (4, 4), m, from zero to a value, rad or m."""
    T, axis = np.eye(4), np.asarray(joint.axis, dtype=np.float64)
    if joint.type == "prismatic":
        T[:3, 3] = value * axis
    elif axis.any():
        half = value / 2
        T[:3, :3] = rotation.to_matrix(np.array([np.cos(half), *(np.sin(half) * axis)]))
    return T
