"""The format of `robots/<name>/robot.toml`: what a robot says of itself, in millimetres and degrees."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import msgspec

from helicoide.text import HelicoideError, Text

Triple = tuple[float, float, float]


class Title(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A name in both languages."""

    en: str
    pt_BR: str

    @property
    def text(self) -> Text:
        """The same as a Text."""
        return Text(en=self.en, pt_BR=self.pt_BR)


class Screw(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A joint's axis at q = 0, in the base frame."""

    direction: Triple
    point_mm: Triple


class DhRow(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A standard Denavit-Hartenberg row (Cerbaro 2022, eq. 57); the joint's angle is added to theta."""

    theta_deg: float
    d_mm: float
    a_mm: float
    alpha_deg: float


class JointFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A revolute joint and the URDF link that it carries."""

    name: str
    title: Title
    link: str
    screw: Screw
    dh: DhRow
    limits_deg: tuple[float, float]
    speed_deg_s: float


class ToolFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The tool frame at q = 0, axes parallel to the base, and its rotation in the last DH frame."""

    position_mm: Triple
    link: str
    R_dh_tool: tuple[Triple, Triple, Triple]


class GripperFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The URDF joint that opens the gripper, and the opening between the fingers."""

    joint: str
    opening_mm: float


class PointFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A point that planes keep away from, at q = 0; `joint` is the last joint that moves it, "" for none."""

    name: str
    title: Title
    joint: str
    point_mm: Triple


class PoseFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A named posture."""

    title: Title
    joints_deg: tuple[float, ...]


class PlaneFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A confinement plane n·r = d with inward normal, and the pane that shows it."""

    name: str
    title: Title
    normal: Triple
    offset_mm: float
    centre_mm: Triple
    size_mm: tuple[float, float]
    movable: bool


class RobotFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file."""

    title: Title
    source: str
    urdf: str
    tool: ToolFile
    joints: tuple[JointFile, ...]
    guarded_points: tuple[PointFile, ...]
    poses: dict[str, PoseFile]
    gripper: GripperFile | None = None
    planes: tuple[PlaneFile, ...] = ()


def read(path: Path) -> RobotFile:
    """Read a robot file; raises HelicoideError with the place and the reason of the first mistake."""
    try:
        file = msgspec.convert(tomllib.loads(path.read_text(encoding="utf-8"), parse_float=_finite), RobotFile)
        _check(file)
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError, msgspec.ValidationError, ValueError) as error:
        raise HelicoideError(
            Text(en="{path} is not a valid robot: {error}", pt_BR="{path} não é um robô válido: {error}").format(
                path=path, error=error
            )
        ) from error
    return file


def _finite(number: str) -> float:
    if not math.isfinite(value := float(number)):
        raise ValueError(f"{number} is not a finite number")
    return value


def _check(file: RobotFile) -> None:
    """What types alone cannot say: references, counts, axes and limits."""
    names = [joint.name for joint in file.joints]
    for joint in file.joints:
        if not any(joint.screw.direction):
            raise ValueError(f"the axis of joint {joint.name} is zero")
        if not joint.limits_deg[0] < joint.limits_deg[1] or not joint.speed_deg_s > 0:
            raise ValueError(f"joint {joint.name} needs limits in rising order and a positive speed")
    for point in file.guarded_points:
        if point.joint not in ("", *names):
            raise ValueError(f"guarded point {point.name} names joint {point.joint!r}; there is: {', '.join(names)}")
    if not any(point.joint == names[-1] and point.point_mm == file.tool.position_mm for point in file.guarded_points):
        raise ValueError(f"no guarded point of joint {names[-1]} lies at the tool, {file.tool.position_mm} mm")
    for name, pose in file.poses.items():
        if len(pose.joints_deg) != len(names):
            raise ValueError(f"pose {name} has {len(pose.joints_deg)} angles for {len(names)} joints")
    for plane in file.planes:
        if not any(plane.normal):
            raise ValueError(f"the normal of plane {plane.name} is zero")
    for pose_name in {"home", "ready"} - file.poses.keys():
        raise ValueError(f"pose {pose_name} is missing")
