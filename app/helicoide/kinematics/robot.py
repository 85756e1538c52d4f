"""A robot arm as the rest of the program sees it: SI units, radians, arrays ready for the kernels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide import content
from helicoide.kinematics import robot_file
from helicoide.text import HelicoideError, Text

Array = NDArray[np.float64]


def frozen(values: ArrayLike) -> Array:
    """A read-only array of float64."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


@dataclass(frozen=True)
class DhRow:
    """Standard Denavit-Hartenberg row in rad and m; the joint angle is added to theta (Cerbaro 2022, eq. 57)."""

    theta: float
    d: float
    a: float
    alpha: float


@dataclass(frozen=True, eq=False)
class Joint:
    """A revolute joint: its axis at q = 0 in the base frame, its DH row, limits in rad and rad/s."""

    name: str
    title: Text
    link: str
    direction: Array
    point: Array
    dh: DhRow
    lower: float
    upper: float
    speed: float


@dataclass(frozen=True)
class GuardedPoint:
    """A point of the arm that keeps its distance from planes."""

    name: str
    title: Text


@dataclass(frozen=True, eq=False)
class Pane:
    """A confinement plane n·r = d (m, inward normal) as the robot's file gives it, with the pane that shows it."""

    name: str
    title: Text
    normal: Array
    offset: float
    centre: Array
    size: tuple[float, float]
    movable: bool


@dataclass(frozen=True)
class Gripper:
    """The URDF joint of the gripper and its full opening between the fingers, in m."""

    joint: str
    opening: float


@dataclass(frozen=True, eq=False)
class Robot:
    """An arm with n revolute joints.

    The frame of link i lies at the point of joint i, its axes parallel to the base at q = 0; link 0 is the base.
    guarded_points (m, 3), m, are given in the frames of the links guarded_joints (m,) that carry them.
    Successive screws, DH rows and the URDF are separate statements: none is derived from another.
    """

    name: str
    title: Text
    source: str
    urdf: Path
    joints: tuple[Joint, ...]
    tool_link: str
    T_world_tool_0: Array
    R_dh_tool: Array
    gripper: Gripper | None
    guarded: tuple[GuardedPoint, ...]
    guarded_points: Array
    guarded_joints: NDArray[np.int64]
    poses: Mapping[str, Array]
    pose_titles: Mapping[str, Text]
    panes: tuple[Pane, ...]

    @cached_property
    def directions(self) -> Array:
        """Joint axes at q = 0, (n, 3), unit, base frame."""
        return frozen([joint.direction for joint in self.joints])

    @cached_property
    def points(self) -> Array:
        """A point on each joint axis at q = 0, (n, 3), m, base frame."""
        return frozen([joint.point for joint in self.joints])

    @cached_property
    def lower(self) -> Array:
        """Lower joint limits, (n,), rad."""
        return frozen([joint.lower for joint in self.joints])

    @cached_property
    def upper(self) -> Array:
        """Upper joint limits, (n,), rad."""
        return frozen([joint.upper for joint in self.joints])

    @cached_property
    def speed(self) -> Array:
        """Joint speed limits, (n,), rad/s."""
        return frozen([joint.speed for joint in self.joints])

    def check_joints(self, q: ArrayLike) -> Array:
        """The joint values as a read-only array (n,); raises HelicoideError unless there are n finite numbers."""
        values = np.atleast_1d(np.asarray(q, dtype=np.float64))
        if values.shape != (len(self.joints),) or not np.isfinite(values).all():
            raise HelicoideError(
                Text(
                    en="{robot} takes {n} finite joint values ({names}), not {given}.",
                    pt_BR="{robot} recebe {n} valores finitos de junta ({names}), não {given}.",
                ).format(
                    robot=self.name,
                    n=len(self.joints),
                    names=", ".join(joint.name for joint in self.joints),
                    given=", ".join(f"{value:g}" for value in values.ravel()),
                )
            )
        return frozen(values)


def _metres(triple: ArrayLike) -> Array:
    return frozen(np.asarray(triple, dtype=np.float64) / 1000)


def _joint(file: robot_file.JointFile) -> Joint:
    direction = np.asarray(file.screw.direction, dtype=np.float64)
    dh = file.dh
    lower, upper, speed = np.radians([*file.limits_deg, file.speed_deg_s])
    return Joint(
        name=file.name,
        title=file.title.text,
        link=file.link,
        direction=frozen(direction / np.linalg.norm(direction)),
        point=_metres(file.screw.point_mm),
        dh=DhRow(np.radians(dh.theta_deg), dh.d_mm / 1000, dh.a_mm / 1000, np.radians(dh.alpha_deg)),
        lower=lower,
        upper=upper,
        speed=speed,
    )


def _pane(file: robot_file.PlaneFile) -> Pane:
    """The plane as measured: normal and offset are divided by the same norm, so that the plane stays where it is."""
    norm = float(np.linalg.norm(file.normal))
    return Pane(
        name=file.name,
        title=file.title.text,
        normal=frozen(np.asarray(file.normal) / norm),
        offset=file.offset_mm / 1000 / norm,
        centre=_metres(file.centre_mm),
        size=(file.size_mm[0] / 1000, file.size_mm[1] / 1000),
        movable=file.movable,
    )


def _tool(file: robot_file.ToolFile) -> Array:
    pose = np.eye(4)
    pose[:3, 3] = _metres(file.position_mm)
    return frozen(pose)


def from_folder(folder: Path) -> Robot:
    """The robot that a folder with a robot.toml describes; raises HelicoideError when the file is wrong."""
    file = robot_file.read(folder / "robot.toml")
    order = ["", *(joint.name for joint in file.joints)]
    origins = np.array([(0.0, 0.0, 0.0), *(joint.screw.point_mm for joint in file.joints)])
    carriers = np.array([order.index(point.joint) for point in file.guarded_points])
    return Robot(
        name=folder.name,
        title=file.title.text,
        source=file.source,
        urdf=folder / file.urdf,
        joints=tuple(map(_joint, file.joints)),
        tool_link=file.tool.link,
        T_world_tool_0=_tool(file.tool),
        R_dh_tool=frozen(file.tool.R_dh_tool),
        gripper=Gripper(file.gripper.joint, file.gripper.opening_mm / 1000) if file.gripper else None,
        guarded=tuple(GuardedPoint(point.name, point.title.text) for point in file.guarded_points),
        guarded_points=_metres(np.array([point.point_mm for point in file.guarded_points]) - origins[carriers]),
        guarded_joints=carriers,
        poses=MappingProxyType({name: frozen(np.radians(pose.joints_deg)) for name, pose in file.poses.items()}),
        pose_titles=MappingProxyType({name: pose.title.text for name, pose in file.poses.items()}),
        panes=tuple(map(_pane, file.planes)),
    )


def load(name: str) -> Robot:
    """A robot by name; raises HelicoideError that lists the names there are, or says what is wrong in its file."""
    return from_folder(content.folder("robots", name))
