"""Where the arm of a URDF ends when nobody says it."""

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
# What a link is called that is the tool: the first row of which there is one counts.
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
    """The joints that hang on each link."""
    found: dict[str, list[yourdfpy.Joint]] = {}
    for joint in robot.joints:
        found.setdefault(joint.parent, []).append(joint)
    return found


def is_moving(joint: yourdfpy.Joint) -> bool:
    """Whether a joint counts as moving; one of a type that nobody knows does, so that it is not passed over."""
    return joint.type not in RIGID


def default_tip(path: Path, robot: yourdfpy.Robot, base: str, held: Sequence[str]) -> str:
    """The link where the arm ends: follow the longest moving branch until two are alike, such as fingers.

    held: the joints that would move if their limits let them.
    """
    joints_below = child_joints(robot)
    beyond = _moving_beyond(base, joints_below)
    if not beyond[base]:
        raise urdf_error(path, NONE_MOVES.format(joints=", ".join(held)) if held else NOTHING_MOVES.format(base=base))

    def count(joint: yourdfpy.Joint) -> int:
        return is_moving(joint) + beyond[joint.child]

    link, above, held, free = base, base, base, 0
    while branches := [joint for joint in joints_below.get(link, []) if count(joint)]:
        best = max(branches, key=count)
        if free and count(best) == 1 and _is_gripper_joint(best, above, held, joints_below):
            break
        if sum(count(joint) == count(best) for joint in branches) > 1:
            break
        free += is_moving(best) and best.mimic is None
        link = best.child
        above, held = (held, link) if best.type != "fixed" else (above, held)
    if not free:
        ends = ", ".join(link.name for link in robot.links if link.name not in joints_below)
        raise urdf_error(
            path,
            Text(
                en=f"choose the link where the arm ends with --tip; the ends are: {ends}",
                pt_BR=f"escolha com --tip o elo onde o braço termina; as pontas são: {ends}",
            ),
        )
    return _tool_of(link, held, joints_below)


def _is_gripper_joint(joint: yourdfpy.Joint, above: str, held: str, joints_below: ChildJoints) -> bool:
    """Whether the last moving joint closes a gripper: it slides or turns by at most half a turn, and the tool begins at
    the link that the joint before it moves.

    It begins where what is fixed to that link is called a tool, what is above it is not, or by a name that says it less
    plainly, and what lies beyond is by none that says it more plainly.
    """
    limit = joint.limit
    half = joint.type == "revolute" and limit is not None and (limit.upper or 0.0) - (limit.lower or 0.0) <= np.pi
    before, here, beyond = (_rank(_fixed_to(start, joints_below)) for start in (above, held, joint.child))
    return (half or joint.type == "prismatic") and before > here <= beyond


def _rank(links: Sequence[str]) -> int:
    """The first row of names of tools that one of these links has; how many rows there are where none has any."""
    words = set[str]().union(*map(_words, links))
    return next((i for i, names in enumerate(TOOL_NAMES) if words & names), len(TOOL_NAMES))


def _moving_beyond(root: str, joints_below: ChildJoints) -> dict[str, int]:
    """How many moving joints the longest branch beyond each link has."""
    order = [root]
    for link in order:
        order += [joint.child for joint in joints_below.get(link, [])]
    beyond: dict[str, int] = {}
    for link in reversed(order):
        beyond[link] = max((is_moving(j) + beyond[j.child] for j in joints_below.get(link, [])), default=0)
    return beyond


def _tool_of(link: str, held: str, joints_below: ChildJoints) -> str:
    """The link called a tool that is fixed beyond a link, else anywhere on what the last joint holds, else the link."""
    for names in TOOL_NAMES:
        for start in (link, held):
            if named := [name for name in _fixed_to(start, joints_below) if _words(name) & names]:
                return named[-1]
    return link


def _fixed_to(start: str, joints_below: ChildJoints) -> list[str]:
    """A link and all that is fixed to it and lies beyond it."""
    fixed, found = [start], list[str]()
    while fixed:
        found.append(fixed.pop())
        fixed += [joint.child for joint in joints_below.get(found[-1], []) if joint.type == "fixed"]
    return found


def _words(name: str) -> set[str]:
    """The words of a name: of left_EndEffector-2 left, end and effector; and, as they stand together, endeffector."""
    words = [word.lower() for word in WORD.findall(name)]
    return {*words, *("".join(pair) for pair in pairwise(words))}
