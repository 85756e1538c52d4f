"""Builds a robot from its folder: `robots/<name>/robot.toml`, converted to SI units."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide.arrays import Array, frozen
from helicoide.kinematics import robot_file, robot_reading
from helicoide.kinematics.chain import Joint
from helicoide.kinematics.dh import DhRow, DhTable
from helicoide.kinematics.robot import Robot, default_monitored_points, in_link_frame
from helicoide.kinematics.robot_check import acceleration_of, limits_of
from helicoide.kinematics.robot_parts import Capsule, Frame, Gripper, MonitoredPoint, PlanePane
from helicoide.text import Text

RENAMED = Text(
    en="in robot.toml the key ours is now called assumed: please rename it",
    pt_BR="em robot.toml a chave ours agora se chama assumed: troque o nome",
)


def _metres(triple: ArrayLike) -> Array:
    return frozen(np.asarray(triple, dtype=np.float64) / 1000)


def _pose(R: ArrayLike, position_mm: ArrayLike) -> Array:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, _metres(position_mm)
    return frozen(T)


def _joint(file: robot_file.JointFile) -> Joint:
    direction = np.asarray(file.screw.direction, dtype=np.float64)
    limits, speed = limits_of(file)
    scale = np.radians(1.0) if file.kind == "revolute" else 1e-3
    return Joint(
        name=file.name,
        title=file.title.text,
        link=file.link,
        kind=file.kind,
        direction=frozen(direction / np.linalg.norm(direction)),
        point=_metres(file.screw.point_mm),
        lower=limits[0] * scale,
        upper=limits[1] * scale,
        speed=speed * scale,
        acceleration=acceleration_of(file) * scale,
    )


def _dh(file: robot_file.RobotFile) -> DhTable:
    rows = tuple(
        DhRow(np.radians(row.theta_deg), row.d_mm / 1000, row.a_mm / 1000, np.radians(row.alpha_deg))
        for row in (joint.dh for joint in file.joints)
    )
    return DhTable(file.convention, rows, frozen(np.eye(4)), _pose(file.tool.R_dh_tool, file.tool.p_dh_tool_mm))


def _pane(file: robot_file.PlaneFile) -> PlanePane:
    """The plane with a unit normal: normal and offset are divided by the same norm, which keeps the plane."""
    norm = float(np.linalg.norm(file.normal))
    return PlanePane(
        name=file.name,
        title=file.title.text,
        normal=frozen(np.asarray(file.normal) / norm),
        offset=file.offset_mm / 1000 / norm,
        centre=_metres(file.centre_mm),
        size=(file.size_mm[0] / 1000, file.size_mm[1] / 1000),
        movable=file.movable,
        as_printed=file.printed,
    )


def _frames(file: robot_file.RobotFile, joints: tuple[Joint, ...]) -> dict[str, Frame]:
    """The frames of the file; by default the station is the base, and the wrist the point of the last joint."""
    last = joints[-1]
    given: dict[str, robot_file.FrameFile] = {
        "station": file.frames.station or robot_file.FrameFile("", (0, 0, 0)),
        "wrist": file.frames.wrist or robot_file.FrameFile(last.name, file.joints[-1].screw.point_mm),
        "tool": robot_file.FrameFile(last.name, file.tool.position_mm, file.tool.R_world_tool),
    }
    if file.frames.rcm:
        given["rcm"] = file.frames.rcm
    return {name: _frame(name, frame, joints) for name, frame in given.items()}


def _frame(name: str, file: robot_file.FrameFile, joints: tuple[Joint, ...]) -> Frame:
    link = ["", *(joint.name for joint in joints)].index(file.joint)
    origin = joints[link - 1].point if link else np.zeros(3)
    return Frame(name, link, in_link_frame(_pose(file.R_world_frame, file.position_mm), origin))


def _guarded(
    file: robot_file.RobotFile, joints: tuple[Joint, ...], T_world_tool_0: Array
) -> tuple[tuple[MonitoredPoint, ...], Array, NDArray[np.int64]]:
    if not file.guarded_points:
        return default_monitored_points(joints, T_world_tool_0)
    order = ["", *(joint.name for joint in joints)]
    origins = np.array([(0.0, 0.0, 0.0), *(joint.point for joint in joints)])
    carriers = np.array([order.index(point.joint) for point in file.guarded_points])
    points = _metres([point.point_mm for point in file.guarded_points]) - origins[carriers]
    return (
        tuple(MonitoredPoint(point.name, point.title.text) for point in file.guarded_points),
        frozen(points),
        carriers,
    )


def _capsules(file: robot_file.RobotFile, joints: tuple[Joint, ...]) -> tuple[Capsule, ...]:
    order = ["", *(joint.name for joint in joints)]
    origins = np.array([(0.0, 0.0, 0.0), *(joint.point for joint in joints)])
    carriers = [order.index(capsule.joint) for capsule in file.capsules]
    return tuple(
        Capsule(
            name=capsule.name,
            title=capsule.title.text,
            ends=frozen(_metres([capsule.from_mm, capsule.to_mm]) - origins[carrier]),
            links=(carrier, carrier),
            radius=capsule.radius_mm / 1000,
        )
        for capsule, carrier in zip(file.capsules, carriers, strict=True)
    )


def _pairs(file: robot_file.RobotFile) -> tuple[tuple[int, int], ...]:
    names = [capsule.name for capsule in file.capsules]
    return tuple((names.index(a), names.index(b)) for a, b in file.self_collision)


def robot_from_folder(folder: Path, parameters: Mapping[str, float] | None = None) -> Robot:
    """The robot described by a folder's robot.toml, with some of its parameters (mm) changed.

    Raises HelicoideError if the file is invalid or has no such parameter.
    """
    file = robot_reading.read_robot_file(folder / "robot.toml", parameters)
    joints = tuple(map(_joint, file.joints))
    T_world_tool_0 = _pose(file.tool.R_world_tool, file.tool.position_mm)
    units = [1e-3 if joint.is_prismatic else np.radians(1.0) for joint in joints]
    guarded, guarded_points, guarded_joints = _guarded(file, joints, T_world_tool_0)
    return Robot(
        name=folder.name,
        title=file.title.text,
        source=file.source,
        urdf=folder / file.urdf,
        joints=joints,
        tool_link=file.tool.link,
        T_world_tool_0=T_world_tool_0,
        dh=_dh(file),
        frames=MappingProxyType(_frames(file, joints)),
        monitored=guarded,
        monitored_points=guarded_points,
        monitored_links=guarded_joints,
        poses=MappingProxyType({name: frozen(np.multiply(pose.joints, units)) for name, pose in file.poses.items()}),
        pose_titles=MappingProxyType({name: pose.title.text for name, pose in file.poses.items()}),
        assumed=(*file.assumed, *file.ours),
        remarks=(RENAMED,) if file.ours else (),
        stated=True,
        parameters=MappingProxyType({name: value / 1000 for name, value in file.parameters.items()}),
        floor=file.floor_mm / 1000,
        camera=(_metres(file.camera.position_mm), _metres(file.camera.look_at_mm)) if file.camera else None,
        gripper=Gripper(file.gripper.joint, file.gripper.opening_mm / 1000) if file.gripper else None,
        panes=tuple(map(_pane, file.planes)),
        capsules=_capsules(file, joints),
        self_collision=_pairs(file),
        actuators=file.actuators.actuators([joint.name for joint in joints]) if file.actuators else None,
    )
