"""The default tip of an arm in a URDF, used if none is given."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
import yourdfpy

from helicoide.kinematics.urdf_xml import urdf_error
from helicoide.text import Text

ChildJoints = Mapping[str, list[yourdfpy.Joint]]

RIGID = ("fixed", "planar", "floating")
WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
# Words in the names of tool links; earlier rows take precedence.
TOOL_NAMES = (
    {"tool", "tcp", "ee", "hand", "flange"},
    {"eef", "effector", "endeffector", "eff"},
    {"gripper", "grasp", "grasping", "grip", "palm"},
    {"tip", "fingertip", "nozzle", "probe", "end"},
)
NOTHING_MOVES = Text(en="it has no moving joints beyond link {base}", pt_BR="não tem juntas móveis além do elo {base}")
NONE_MOVES = Text(
    en="it has no moving joints: lower and upper of {joints} are the same",
    pt_BR="não tem juntas móveis: lower e upper de {joints} são iguais",
)


def child_joints(robot: yourdfpy.Robot) -> ChildJoints:
    """The joints whose parent is each link."""
    found: dict[str, list[yourdfpy.Joint]] = {}
    for joint in robot.joints:
        found.setdefault(joint.parent, []).append(joint)
    return found


def is_moving(joint: yourdfpy.Joint) -> bool:
    """Whether a joint counts as moving; a joint of unknown type does, so that it is reported."""
    return joint.type not in RIGID


def default_tip(path: Path, robot: yourdfpy.Robot, base: str, grippers: Sequence[str]) -> str:
    """The link where the arm ends: the longest moving branch is followed until two are equally long, such as fingers.

    held: joints that would move if their limits were not equal. Raises HelicoideError if the end is ambiguous or
    nothing moves.
    """
    joints_below = child_joints(robot)
    beyond = _moving_beyond(base, joints_below)
    if not beyond[base]:
        raise urdf_error(
            path, NONE_MOVES.format(joints=", ".join(grippers)) if grippers else NOTHING_MOVES.format(base=base)
        )

    def count(joint: yourdfpy.Joint) -> int:
        return is_moving(joint) + beyond[joint.child]

    link, above, grippers, free = base, base, base, 0
    while branches := [joint for joint in joints_below.get(link, []) if count(joint)]:
        best = max(branches, key=count)
        if free and count(best) == 1 and _is_gripper_joint(best, above, grippers, joints_below):
            break
        if sum(count(joint) == count(best) for joint in branches) > 1:
            break
        free += is_moving(best) and best.mimic is None
        link = best.child
        above, grippers = (grippers, link) if best.type != "fixed" else (above, grippers)
    if not free:
        ends = ", ".join(link.name for link in robot.links if link.name not in joints_below)
        raise urdf_error(
            path,
            Text(
                en=f"choose the link where the arm ends with --tip; the ends are: {ends}",
                pt_BR=f"escolha com --tip o elo onde o braço termina; as pontas são: {ends}",
            ),
        )
    return _tool_of(link, grippers, joints_below)


def _is_gripper_joint(joint: yourdfpy.Joint, above: str, grippers: str, joints_below: ChildJoints) -> bool:
    """Whether the last moving joint closes a gripper and so does not belong to the arm.

    It must slide or rotate by at most half a turn, and the tool must begin at the link that the joint before it moves:
    the names of the links fixed there rank higher as tools than those above, and no lower than those beyond.
    """
    limit = joint.limit
    half = joint.type == "revolute" and limit is not None and (limit.upper or 0.0) - (limit.lower or 0.0) <= np.pi
    before, here, beyond = (_rank(_fixed_to(start, joints_below)) for start in (above, grippers, joint.child))
    return (half or joint.type == "prismatic") and before > here <= beyond


def _rank(links: Sequence[str]) -> int:
    """Number of the first row of `TOOL_NAMES` that matches one of the links; the number of rows if none matches."""
    words = set[str]().union(*map(_words, links))
    return next((i for i, names in enumerate(TOOL_NAMES) if words & names), len(TOOL_NAMES))


def _moving_beyond(root: str, joints_below: ChildJoints) -> dict[str, int]:
    """Number of moving joints in the longest branch beyond each link."""
    order = [root]
    for link in order:
        order += [joint.child for joint in joints_below.get(link, [])]
    beyond: dict[str, int] = {}
    for link in reversed(order):
        beyond[link] = max((is_moving(j) + beyond[j.child] for j in joints_below.get(link, [])), default=0)
    return beyond


def _tool_of(link: str, grippers: str, joints_below: ChildJoints) -> str:
    """The link named as a tool that is fixed beyond a link, else one fixed to the last joint, else the link itself."""
    for names in TOOL_NAMES:
        for start in (link, grippers):
            if named := [name for name in _fixed_to(start, joints_below) if _words(name) & names]:
                return named[-1]
    return link


def _fixed_to(start: str, joints_below: ChildJoints) -> list[str]:
    """A link and all links beyond it that are fixed to it."""
    fixed, found = [start], list[str]()
    while fixed:
        found.append(fixed.pop())
        fixed += [joint.child for joint in joints_below.get(found[-1], []) if joint.type == "fixed"]
    return found


def _words(name: str) -> set[str]:
    """The words of a name and their neighbouring pairs: left_EndEffector-2 has left, end, effector, endeffector …"""
    words = [word.lower() for word in WORD.findall(name)]
    return {*words, *("".join(pair) for pair in pairwise(words))}
