"""Closed forms, a file for each family of arms; `postures.answer.Form` says what such a file holds."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from types import MappingProxyType
from typing import cast

from helicoide import content
from helicoide.arrays import Array
from helicoide.ik.postures.answer import Answer, Form, as_found
from helicoide.ik.postures.branch import check_pose
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError


@cache
def found() -> dict[str, Form]:
    """Every closed form by the name of its file."""
    return cast(dict[str, Form], content.modules(__name__))


@lru_cache(maxsize=64)
def of(robot: Robot) -> Mapping[str, Form]:
    """The closed forms that apply to a robot, the one that is chosen first."""
    known = {name: form for name, form in found().items() if form.applies(robot) is None}
    return MappingProxyType(dict(sorted(known.items(), key=lambda one: (one[1].RANK, one[0]))))


def solve(form: Form, robot: Robot, T_world_tool: Array, q: Array) -> Answer:
    """Every posture of one closed form for a tool pose (4, 4), m, in the order in which it finds them.

    q (n,), rad or m: kept where a joint is free. Raises HelicoideError where the form does not apply, for what is no
    pose, and unless q has n finite values.
    """
    if (reason := form.applies(robot)) is not None:
        raise HelicoideError(reason)
    T = check_pose(T_world_tool)
    return as_found(robot, form.find(robot, T, robot.check_joints(q)), T)
