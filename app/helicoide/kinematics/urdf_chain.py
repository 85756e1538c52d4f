"""A robot from any URDF file: the chain from its base to a link, with screw axes from the joints at zero."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

import numpy as np
import yourdfpy

from helicoide.arrays import Array, frozen
from helicoide.kinematics import dh
from helicoide.kinematics.chain import Joint, JointVariable, Mimic
from helicoide.kinematics.ready_posture import find_ready_posture
from helicoide.kinematics.robot import Robot, default_monitored_points, in_link_frame
from helicoide.kinematics.robot_parts import Frame
from helicoide.kinematics.urdf_file import read_urdf, root_of
from helicoide.kinematics.urdf_limits import SLIDE_SPEED, SPEED, joint_range, joint_speed
from helicoide.kinematics.urdf_path import LEADER_OUTSIDE_CHAIN, joints_between, outside_leaders
from helicoide.kinematics.urdf_repair import MOVING
from helicoide.kinematics.urdf_tip import default_tip
from helicoide.kinematics.urdf_xml import urdf_error
from helicoide.text import Text, join_texts, untranslated

AnyVariable = TypeVar("AnyVariable", bound=JointVariable)

MOST_JOINTS = 30
MEETING = 1e-6
LARGEST_REACH = 100.0
CONTRADICTED = Text(
    en="the limits of {joint} leave no range for {leader}, which it follows; they are ignored",
    pt_BR="os limites de {joint} não deixam faixa alguma para {leader}, que ela segue; são ignorados",
)
IN_MILLIMETRES = Text(
    en="it reaches {reach} m: lengths of a URDF are metres, these may be millimetres",
    pt_BR="alcança {reach} m: comprimentos de um URDF são em metros, estes talvez sejam milímetros",
)
NO_LIMITS = Text(
    en="the file gives no limits for these joints; assumed ranges: {ranges}",
    pt_BR="o arquivo não limita estas juntas; faixas adotadas: {ranges}",
)


def robot_from_urdf(path: Path, tip: str | None = None, base: str | None = None) -> Robot:
    """The chain from the root of a URDF, or another base, to a link, as a Robot; its base frame is that of the base.

    Without `tip` the chain ends where the moving joints branch or end. DH rows are recovered from the screws. What the
    file does not say is assumed: speeds that are missing or zero, ranges without bounds, and the posture `ready`.
    Raises HelicoideError when the file is broken or has no such link.
    """
    reading = read_urdf(path)
    robot = reading.robot
    if tip is None:
        known = base in {link.name for link in robot.links}
        link = default_tip(path, robot, base if base is not None and known else root_of(robot), reading.fixed_by_limits)
    else:
        link = tip
    begun, way, said = joints_between(path, robot, base, link)
    followed = outside_leaders(path, robot, way)
    said += [LEADER_OUTSIDE_CHAIN.format(leader=name, joints=", ".join(joints)) for name, joints in followed.items()]
    beside = [joint for name in followed for joint in robot.joints if joint.name == name]
    joints, led_by, T_world_tool_0 = _chain(path, way, beside, link)
    joints, led_by, contradicted = _within_limits_of_mimics(joints, led_by)
    variables = [*(joint for joint in joints if joint.mimic is None), *led_by]
    guarded, guarded_points, guarded_joints = default_monitored_points(joints, T_world_tool_0)
    found = Robot(
        name=path.stem,
        title=untranslated(robot.name or path.stem),
        source=f"{path.name}: {link}",
        urdf=path,
        joints=joints,
        tool_link=link,
        T_world_tool_0=T_world_tool_0,
        dh=dh.dh_from_screws(joints, T_world_tool_0),
        frames=MappingProxyType(_frames(joints, T_world_tool_0)),
        monitored=guarded,
        monitored_points=guarded_points,
        monitored_links=guarded_joints,
        poses=MappingProxyType({}),
        pose_titles=MappingProxyType({"ready": Text(en="ready pose", pt_BR="pose inicial")}),
        assumed=_assumed([*way, *beside], variables),
        base=begun,
        leaders=led_by,
        remarks=(*reading.remarks, *said, *contradicted, *_unlimited([*way, *beside], variables)),
    )
    if found.stretched_length > LARGEST_REACH:
        found = replace(found, remarks=(*found.remarks, IN_MILLIMETRES.format(reach=f"{found.stretched_length:.0f}")))
    return replace(found, poses=MappingProxyType({"ready": find_ready_posture(found)}))


def _assumed(given: Sequence[yourdfpy.Joint], variables: Sequence[JointVariable]) -> tuple[str, ...]:
    """What the file does not give of the variables: limits, speeds."""
    speeds = {joint.name: joint_speed(joint) for joint in given}
    limits = any(variable.assumed for variable in variables)
    return (*["limits"] * limits, *["speeds"] * any(speeds[variable.name] is None for variable in variables))


def _unlimited(given: Sequence[yourdfpy.Joint], variables: Sequence[JointVariable]) -> list[Text]:
    """A remark on assumed ranges, except those of continuous joints."""
    continuous = {joint.name for joint in given if joint.type == "continuous"}
    assumed = [variable for variable in variables if variable.assumed and variable.name not in continuous]
    return [NO_LIMITS.format(ranges=join_texts([_range(one) for one in assumed]))] if assumed else []


def _range(variable: JointVariable) -> Text:
    scale, unit = (1.0, " m") if variable.is_prismatic else (180 / np.pi, "°")
    return untranslated("{name} {lower:g}…{upper:g}{unit}").format(
        name=variable.name, lower=float(scale * variable.lower), upper=float(scale * variable.upper), unit=unit
    )


def _frames(joints: tuple[Joint, ...], T_world_tool_0: Array) -> dict[str, Frame]:
    wrist = np.eye(4)
    wrist[:3, 3] = _meeting_point(joints[-3:])
    return {
        "station": Frame("station", 0, frozen(np.eye(4))),
        "wrist": Frame("wrist", len(joints), in_link_frame(wrist, joints[-1].point)),
        "tool": Frame("tool", len(joints), in_link_frame(T_world_tool_0, joints[-1].point)),
    }


def _meeting_point(joints: tuple[Joint, ...]) -> Array:
    """The point where the axes of revolute joints meet at zero, (3,), m; else the point of the last joint."""
    across = [np.eye(3) - np.outer(joint.direction, joint.direction) for joint in joints]
    sides = np.concatenate([P @ joint.point for P, joint in zip(across, joints, strict=True)])
    point, *_ = np.linalg.lstsq(np.vstack(across), sides)
    apart = np.abs(np.vstack(across) @ point - sides).max()
    return point if apart < MEETING and not any(joint.is_prismatic for joint in joints) else joints[-1].point


def _chain(
    path: Path, way: Sequence[yourdfpy.Joint], sibling: Sequence[yourdfpy.Joint], tip: str
) -> tuple[tuple[Joint, ...], tuple[JointVariable, ...], Array]:
    """The moving joints up to a link, the leaders outside the chain, and the pose of the link at zero, base frame."""
    free = [joint.name for joint in (*way, *sibling) if joint.type in MOVING and joint.mimic is None]
    if not 0 < (count := len(free)) <= MOST_JOINTS:
        raise urdf_error(
            path,
            Text(
                en=f"the chain to {tip!r} has {count} moving joints; an arm has 1 to {MOST_JOINTS}",
                pt_BR=f"a cadeia até {tip!r} tem {count} juntas móveis; um braço tem de 1 a {MOST_JOINTS}",
            ),
        )
    size = sum(float(np.linalg.norm(joint.origin[:3, 3])) for joint in way)
    T, joints = np.eye(4), list[Joint]()
    for joint in way:
        T = T @ joint.origin
        if joint.type in MOVING:
            joints.append(_joint(path, joint, T, size, free))
    led_by = [_variable(path, joint, size) for joint in sibling]
    return tuple(joints), tuple(led_by), frozen(T)


def _variable(path: Path, joint: yourdfpy.Joint, size: float) -> JointVariable:
    slides = joint.type == "prismatic"
    lower, upper, assumed = joint_range(path, joint, size)
    return JointVariable(
        name=joint.name,
        title=untranslated(joint.name),
        kind="prismatic" if slides else "revolute",
        lower=lower,
        upper=upper,
        speed=joint_speed(joint) or (SLIDE_SPEED if slides else SPEED),
        assumed=assumed,
    )


def _joint(path: Path, joint: yourdfpy.Joint, T: Array, size: float, free: list[str]) -> Joint:
    direction = T[:3, :3] @ np.asarray(joint.axis, dtype=float)
    if not np.linalg.norm(direction) > 0:
        raise urdf_error(
            path, Text(en=f"the axis of joint {joint.name!r} is zero", pt_BR=f"o eixo da junta {joint.name!r} é nulo")
        )
    mimic = joint.mimic
    return Joint(
        **vars(_variable(path, joint, size)),
        link=joint.child,
        direction=frozen(direction / np.linalg.norm(direction)),
        point=frozen(T[:3, 3]),
        mimic=None if mimic is None else Mimic(free.index(mimic.joint), mimic.multiplier, mimic.offset),
    )


def _within_limits_of_mimics(
    joints: Sequence[Joint], led_by: Sequence[JointVariable]
) -> tuple[tuple[Joint, ...], tuple[JointVariable, ...], list[Text]]:
    """The joints and leaders, with each variable's range narrowed to the limits of the joints that follow it.

    Limits of a follower that leave its leader no range are ignored with a remark: in some grippers their sign is wrong.
    """
    variables = [*(joint for joint in joints if joint.mimic is None), *led_by]
    followers = [(joint, joint.mimic) for joint in joints if joint.mimic is not None and joint.lower < joint.upper]
    ranges = {variable.name: (variable.lower, variable.upper) for variable in variables}
    contradicted = list[Text]()
    for joint, mimic in followers:
        name = variables[mimic.driver].name
        ends = sorted((end - mimic.offset) / mimic.multiplier for end in (joint.lower, joint.upper))
        lower, upper = max(ranges[name][0], ends[0]), min(ranges[name][1], ends[1])
        if lower < upper:
            ranges[name] = lower, upper
        else:
            contradicted.append(CONTRADICTED.format(joint=joint.name, leader=name))
    return (
        tuple(joint if joint.mimic else _within(joint, *ranges[joint.name]) for joint in joints),
        tuple(_within(leader, *ranges[leader.name]) for leader in led_by),
        contradicted,
    )


def _within(variable: AnyVariable, lower: float, upper: float) -> AnyVariable:
    """A variable with a narrower range, which is no longer assumed if both ends come from joints that follow it."""
    assumed = variable.assumed and (lower == variable.lower or upper == variable.upper)
    return replace(variable, lower=lower, upper=upper, assumed=assumed)
