"""A robot from any URDF file: the chain from its root to a link, screws read from the joints at zero."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import numpy as np
import yourdfpy

from helicoide.kinematics import dh
from helicoide.kinematics.chain import Array, Joint, Mimic, frozen
from helicoide.kinematics.readiness import ready
from helicoide.kinematics.robot import Frame, Robot, guarded_centres, on_link
from helicoide.kinematics.urdf_file import broken, parsed
from helicoide.text import Text, same

MOVING = ("revolute", "continuous", "prismatic")
MOST_JOINTS = 30
MEETING = 1e-6
SPEED, SLIDE_SPEED = math.pi / 3, 0.25
TOOLS = ("tool", "tool0", "tcp", "ee", "hand", "flange")


def from_urdf(path: Path, tip: str | None = None) -> Robot:
    """The chain from the root of a URDF to a link, as a Robot.

    Without `tip` the chain ends where the moving joints branch or end. DH rows are recovered from the screws. What the
    file does not say is ours: speeds that are missing or zero, limits of continuous joints, and the posture `ready`.
    Raises HelicoideError when the file is broken or has no such link.
    """
    robot = parsed(path).robot
    link = _default_tip(path, robot) if tip is None else tip
    if link not in (names := [link.name for link in robot.links]):
        there = ", ".join(names)
        raise broken(
            path, Text(en=f"there is no link {link!r}; there is: {there}", pt_BR=f"não há elo {link!r}; há: {there}")
        )
    joints, T_world_tool_0 = _chain(path, robot, link)
    guarded, guarded_points, guarded_joints = guarded_centres(joints, T_world_tool_0)
    found = Robot(
        name=path.stem,
        title=same(robot.name or path.stem),
        source=f"{path.name}: {link}",
        urdf=path,
        joints=joints,
        tool_link=link,
        T_world_tool_0=T_world_tool_0,
        dh=dh.recovered(joints, T_world_tool_0),
        frames=MappingProxyType(_frames(joints, T_world_tool_0)),
        guarded=guarded,
        guarded_points=guarded_points,
        guarded_joints=guarded_joints,
        poses=MappingProxyType({}),
        pose_titles=MappingProxyType({"ready": Text(en="ready", pt_BR="pronto")}),
    )
    return replace(found, poses=MappingProxyType({"ready": ready(found)}))


def _frames(joints: tuple[Joint, ...], T_world_tool_0: Array) -> dict[str, Frame]:
    wrist = np.eye(4)
    wrist[:3, 3] = _meeting_point(joints[-3:])
    return {
        "station": Frame("station", 0, frozen(np.eye(4))),
        "wrist": Frame("wrist", len(joints), on_link(wrist, joints[-1].point)),
        "tool": Frame("tool", len(joints), on_link(T_world_tool_0, joints[-1].point)),
    }


def _meeting_point(joints: tuple[Joint, ...]) -> Array:
    """Where the axes of turning joints meet, (3,), m, at zero; the point of the last joint where they do not."""
    across = [np.eye(3) - np.outer(joint.direction, joint.direction) for joint in joints]
    sides = np.concatenate([P @ joint.point for P, joint in zip(across, joints, strict=True)])
    point, *_ = np.linalg.lstsq(np.vstack(across), sides)
    apart = np.abs(np.vstack(across) @ point - sides).max()
    return point if apart < MEETING and not any(joint.slides for joint in joints) else joints[-1].point


def _is_free(joint: yourdfpy.Joint) -> bool:
    return joint.type in MOVING and joint.mimic is None


def _default_tip(path: Path, robot: yourdfpy.Robot) -> str:
    """The link where the arm ends: follow the longest moving branch until two are alike, such as fingers."""
    below: dict[str, list[yourdfpy.Joint]] = {}
    for joint in robot.joints:
        below.setdefault(joint.parent, []).append(joint)

    root = next(link.name for link in robot.links if link.name not in {joint.child for joint in robot.joints})
    beyond = _moving_beyond(root, below)
    if not beyond[root]:
        raise broken(path, Text(en="it has no moving joints", pt_BR="não tem juntas móveis"))

    def moves(joint: yourdfpy.Joint) -> int:
        return (joint.type in MOVING) + beyond[joint.child]

    link = root
    joints = 0
    while branches := [joint for joint in below.get(link, []) if moves(joint)]:
        best = max(branches, key=moves)
        if sum(moves(joint) == moves(best) for joint in branches) > 1:
            break
        joints, link = joints + _is_free(best), best.child
    if not joints:
        ends = ", ".join(link.name for link in robot.links if link.name not in below)
        raise broken(
            path,
            Text(
                en=f"choose the link where the arm ends with --tip; the ends are: {ends}",
                pt_BR=f"escolha com --tip o elo onde o braço termina; as pontas são: {ends}",
            ),
        )
    return _tool_of(link, below)


def _moving_beyond(root: str, below: Mapping[str, list[yourdfpy.Joint]]) -> dict[str, int]:
    """How many moving joints the longest branch beyond each link has."""
    order = [root]
    for link in order:
        order += [joint.child for joint in below.get(link, [])]
    beyond: dict[str, int] = {}
    for link in reversed(order):
        beyond[link] = max(((j.type in MOVING) + beyond[j.child] for j in below.get(link, [])), default=0)
    return beyond


def _tool_of(link: str, below: Mapping[str, list[yourdfpy.Joint]]) -> str:
    """The fixed link beyond the last moving one that is called a tool, else the link itself."""
    fixed, found = [link], link
    while fixed:
        name = fixed.pop()
        if set(name.lower().split("_")) & set(TOOLS):
            found = name
        fixed += [joint.child for joint in below.get(name, []) if joint.type == "fixed"]
    return found


def _chain(path: Path, robot: yourdfpy.Robot, tip: str) -> tuple[tuple[Joint, ...], Array]:
    """The moving joints from the root to a link, and the pose of that link at zero, base frame."""
    above = {joint.child: joint for joint in robot.joints}
    way: list[yourdfpy.Joint] = []
    link = tip
    while link in above:
        way.insert(0, above[link])
        link = way[0].parent
    if not 0 < (count := sum(map(_is_free, way))) <= MOST_JOINTS:
        raise broken(
            path,
            Text(
                en=f"the chain to {tip!r} has {count} moving joints; an arm has 1 to {MOST_JOINTS}",
                pt_BR=f"a cadeia até {tip!r} tem {count} juntas móveis; um braço tem de 1 a {MOST_JOINTS}",
            ),
        )
    free = [joint.name for joint in way if _is_free(joint)]
    T, joints = np.eye(4), list[Joint]()
    for joint in way:
        T = T @ (np.eye(4) if joint.origin is None else joint.origin)
        if joint.type in MOVING:
            joints.append(_joint(path, joint, T, free))
        elif joint.type != "fixed":
            kinds = ", ".join((*MOVING, "fixed"))
            raise broken(
                path,
                Text(
                    en=f"joint {joint.name!r} is of type {joint.type!r}; use one of: {kinds}",
                    pt_BR=f"a junta {joint.name!r} é do tipo {joint.type!r}; use um destes: {kinds}",
                ),
            )
    return tuple(_within_limits_of_mimics(path, joints)), frozen(T)


def _joint(path: Path, joint: yourdfpy.Joint, T: Array, free: list[str]) -> Joint:
    slides = joint.type == "prismatic"
    direction = T[:3, :3] @ np.asarray(joint.axis, dtype=float)
    if not np.linalg.norm(direction) > 0:
        raise broken(
            path, Text(en=f"the axis of joint {joint.name!r} is zero", pt_BR=f"o eixo da junta {joint.name!r} é nulo")
        )
    lower, upper = (-2 * math.pi, 2 * math.pi) if joint.type == "continuous" else _range(path, joint)
    speed = joint.limit.velocity if joint.limit is not None else None
    return Joint(
        name=joint.name,
        title=same(joint.name),
        link=joint.child,
        kind="prismatic" if slides else "revolute",
        direction=frozen(direction / np.linalg.norm(direction)),
        point=frozen(T[:3, 3]),
        lower=lower,
        upper=upper,
        speed=speed if speed and speed > 0 else SLIDE_SPEED if slides else SPEED,
        mimic=None if joint.mimic is None else _mimic(path, joint, free),
    )


def _range(path: Path, joint: yourdfpy.Joint) -> tuple[float, float]:
    limit = joint.limit
    if limit is None or limit.lower is None or limit.upper is None:
        raise broken(
            path,
            Text(
                en=f"joint {joint.name!r} is {joint.type} and has no limit: lower and upper are needed",
                pt_BR=f"a junta {joint.name!r} é {joint.type} e não tem limit: lower e upper são necessários",
            ),
        )
    if not limit.lower < limit.upper:
        raise broken(path, _wrong_limits(joint.name, limit.lower, limit.upper))
    return float(limit.lower), float(limit.upper)


def _wrong_limits(name: str, lower: float, upper: float) -> Text:
    return Text(
        en=f"the limits of joint {name!r} are {lower:g} to {upper:g}; lower must be below upper",
        pt_BR=f"os limites da junta {name!r} são {lower:g} a {upper:g}; lower deve ser menor que upper",
    )


def _mimic(path: Path, joint: yourdfpy.Joint, free: list[str]) -> Mimic:
    if joint.mimic.joint not in free:
        raise broken(
            path,
            Text(
                en=f"joint {joint.name!r} follows {joint.mimic.joint!r}, which is no free joint of the chain",
                pt_BR=f"a junta {joint.name!r} segue {joint.mimic.joint!r}, que não é uma junta livre da cadeia",
            ),
        )
    ratio, shift = joint.mimic.multiplier, joint.mimic.offset
    return Mimic(free.index(joint.mimic.joint), 1.0 if ratio is None else ratio, 0.0 if shift is None else shift)


def _within_limits_of_mimics(path: Path, joints: list[Joint]) -> list[Joint]:
    """The joints, with the limits of each variable narrowed to what the joints that follow it allow."""
    free = [i for i, joint in enumerate(joints) if joint.mimic is None]
    narrowed = list(joints)
    for joint in joints:
        if (mimic := joint.mimic) is not None and mimic.ratio != 0:
            i = free[mimic.driver]
            ends = sorted((end - mimic.shift) / mimic.ratio for end in (joint.lower, joint.upper))
            lower, upper = max(narrowed[i].lower, ends[0]), min(narrowed[i].upper, ends[1])
            if not lower < upper:
                raise broken(path, _wrong_limits(narrowed[i].name, lower, upper))
            narrowed[i] = replace(narrowed[i], lower=lower, upper=upper)
    return narrowed
