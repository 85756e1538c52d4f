"""Range and speed of a URDF's joint; they are assumed if the file gives none, or none that limits the joint."""

from __future__ import annotations

import math
from pathlib import Path

import yourdfpy

from helicoide.kinematics.urdf_xml import urdf_error
from helicoide.text import Text

SPEED, SLIDE_SPEED = math.pi / 3, 0.25
MAX_SPEED = 1e3
# What a file means by no limit: turns, rad, and slides, m or as many times what the links give, whichever is more. And
# the range that is taken instead, to both sides.
BOUNDLESS_TURN, TURN = 1e3, 2 * math.pi
BOUNDLESS_SLIDE, SLIDE = 100.0, 10.0


def joint_speed(joint: yourdfpy.Joint) -> float | None:
    """Speed limit of a joint, rad/s or m/s; None if the file does not give it."""
    speed = joint.limit.velocity if joint.limit is not None else None
    return float(speed) if speed and 0 < speed <= MAX_SPEED else None


def joint_range(path: Path, joint: yourdfpy.Joint, size: float) -> tuple[float, float, bool]:
    """Lower and upper limit of a joint, rad or m, and whether one of them is assumed.

    What is left out beside one that is given is zero, as the format says. Raises HelicoideError for limits in falling
    order. A follower is unbounded where its file bounds it nowhere. Args: size: m, what the links of the chain add to.
    """
    slides, limit = joint.type == "prismatic", joint.limit
    assumed = SLIDE * max(size, 1.0) if slides else TURN
    most = BOUNDLESS_SLIDE * max(size, 1.0) if slides else BOUNDLESS_TURN
    free = joint.type == "continuous" or limit is None or (limit.lower is None and limit.upper is None)
    if joint.mimic is not None and (free or limit.lower == limit.upper):
        return -math.inf, math.inf, False
    if free:
        return -assumed, assumed, True
    lower, upper = limit.lower or 0.0, limit.upper or 0.0
    if lower > upper:
        raise urdf_error(path, wrong_limits(joint.name, lower, upper))
    below, above = lower < -most, upper > most
    if joint.mimic is not None:
        return -math.inf if below else float(lower), math.inf if above else float(upper), False
    if below and above:
        return -assumed, assumed, True
    if above:
        upper = max(assumed, lower + assumed)
    elif below:
        lower = min(-assumed, upper - assumed)
    if not lower < upper:
        raise urdf_error(path, wrong_limits(joint.name, lower, upper))
    return float(lower), float(upper), below or above


def wrong_limits(name: str, lower: float, upper: float) -> Text:
    """The error for a lower limit that is not below the upper one."""
    return Text(
        en="the limits of joint {name!r} are {lower:g} to {upper:g}; lower must be below upper",
        pt_BR="os limites da junta {name!r} são {lower:g} a {upper:g}; lower deve ser menor que upper",
    ).format(name=name, lower=lower, upper=upper)
