"""Closed forms, one module for each family of arms; `postures.answer.Form` describes such a module."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from types import MappingProxyType
from typing import cast

from helicoide import content
from helicoide.arrays import Array
from helicoide.ik.postures.answer import Answer, Form, answer_as_found
from helicoide.ik.postures.branch import check_pose
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError


@cache
def closed_forms() -> dict[str, Form]:
    """Every closed form by its module name."""
    return cast(dict[str, Form], content.modules(__name__))


@lru_cache(maxsize=64)
def of(robot: Robot) -> Mapping[str, Form]:
    """The closed forms that apply to a robot; the first is the default."""
    known = {name: form for name, form in closed_forms().items() if form.applies(robot) is None}
    return MappingProxyType(dict(sorted(known.items(), key=lambda one: (one[1].RANK, one[0]))))


def solve_closed_form(form: Form, robot: Robot, T_world_tool: Array, q: Array) -> Answer:
    """Every posture of one closed form for a tool pose (4, 4), m, in the order in which the form gives them.

    q (n,), rad or m: a joint that the pose leaves free keeps its value. Raises HelicoideError if the form does not
    apply, if T_world_tool is not a pose, or if q does not have n finite values.
    """
    if (reason := form.applies(robot)) is not None:
        raise HelicoideError(reason)
    T = check_pose(T_world_tool)
    return answer_as_found(robot, form.find(robot, T, robot.check_joints(q)), T)
