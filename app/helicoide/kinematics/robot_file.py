"""The format of `robots/<name>/robot.toml`: what a robot says of itself, in millimetres and degrees."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

import msgspec

from helicoide.kinematics.actuator_file import ActuatorsFile
from helicoide.text import HelicoideError, Text

Triple = tuple[float, float, float]
Matrix = tuple[Triple, Triple, Triple]
IDENTITY: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


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
    """A Denavit-Hartenberg row; the joint's variable is added to theta, or to d where the joint slides.

    a and α are those of the same joint in the standard convention, those of the joint before in the modified one.
    """

    theta_deg: float
    d_mm: float
    a_mm: float
    alpha_deg: float


class JointFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A joint and the URDF link that it carries; limits in degrees or, where it slides, mm; acceleration if limited."""

    name: str
    title: Title
    link: str
    screw: Screw
    dh: DhRow
    kind: Literal["revolute", "prismatic"] = "revolute"
    limits_deg: tuple[float, float] | None = None
    speed_deg_s: float | None = None
    acceleration_deg_s2: float | None = None
    limits_mm: tuple[float, float] | None = None
    speed_mm_s: float | None = None
    acceleration_mm_s2: float | None = None


class ToolFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The tool frame at q = 0, and the same frame as the last DH frame sees it."""

    position_mm: Triple
    link: str
    R_dh_tool: Matrix
    R_world_tool: Matrix = IDENTITY
    p_dh_tool_mm: Triple = (0, 0, 0)


class FrameFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """Another frame at q = 0; `joint` is the last joint that moves it, "" for none."""

    joint: str
    position_mm: Triple
    R_world_frame: Matrix = IDENTITY


class FramesFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """Where goals are given (station), where the wrist axes meet (wrist), the remote centre of motion (rcm)."""

    station: FrameFile | None = None
    wrist: FrameFile | None = None
    rcm: FrameFile | None = None


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


class CapsuleFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A body of the arm, at q = 0: what lies within the radius of a straight piece; `joint` as in `PointFile`."""

    name: str
    title: Title
    joint: str
    from_mm: Triple
    to_mm: Triple
    radius_mm: float


class CameraFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """From where the arm is seen first."""

    position_mm: Triple
    look_at_mm: Triple


class PoseFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A named posture: degrees, millimetres where a joint slides."""

    title: Title
    joints: tuple[float, ...]


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
    """The whole file.

    parameters: lengths, mm, that the file may use by name: any length may be a sum such as "l1 + l2", and the URDF may
    hold ${l1}, in metres. ours: what the source does not give. floor_mm: where the floor is drawn, under the base.
    self_collision: pairs of capsules, by name, that must not touch each other.
    """

    title: Title
    source: str
    urdf: str
    tool: ToolFile
    joints: tuple[JointFile, ...]
    poses: dict[str, PoseFile]
    parameters: dict[str, float] = {}
    ours: tuple[Literal["lengths", "limits", "speeds"], ...] = ()
    convention: Literal["standard", "modified"] = "standard"
    floor_mm: float = 0
    camera: CameraFile | None = None
    frames: FramesFile = FramesFile()
    guarded_points: tuple[PointFile, ...] = ()
    capsules: tuple[CapsuleFile, ...] = ()
    self_collision: tuple[tuple[str, str], ...] = ()
    gripper: GripperFile | None = None
    planes: tuple[PlaneFile, ...] = ()
    actuators: ActuatorsFile | None = None


def read(path: Path, parameters: Mapping[str, float] | None = None) -> RobotFile:
    """Read a robot file, with some of its parameters (mm) changed; raises HelicoideError with place and reason."""
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"), parse_float=_finite)
        file = msgspec.convert(_with_parameters(table, parameters or {}), RobotFile)
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


def _with_parameters(table: dict[str, Any], changed: Mapping[str, float]) -> dict[str, Any]:
    """The table with sums of parameters worked out wherever a list or a length holds one."""
    known = table.get("parameters", {})
    if not isinstance(known, dict) or not all(isinstance(value, int | float) for value in known.values()):
        return table
    for name, value in changed.items():
        if name not in known:
            raise ValueError(f"there is no parameter {name}; there is: {', '.join(known) or 'none'}")
        if not (math.isfinite(value) and value > 0):
            raise ValueError(f"parameter {name} must be a positive number of millimetres, not {value}")
    known = {**known, **changed}
    return {**_summed(table, known), "parameters": known}


def _summed(part: Any, known: Mapping[str, float]) -> Any:
    """The same part of a file with each "l1 + l2" of known names as its sum."""
    match part:
        case dict():
            return {key: _summed(value, known) for key, value in part.items()}
        case list():
            return [_summed(value, known) for value in part]
        case str() if known and all(name.strip() in known for name in part.split("+")):
            return sum(known[name.strip()] for name in part.split("+"))
        case _:
            return part


def _check(file: RobotFile) -> None:
    """What types alone cannot say: references, counts, axes and limits."""
    names = [joint.name for joint in file.joints]
    for joint in file.joints:
        _check_joint(joint)
    parts: list[PointFile | FrameFile | CapsuleFile] = [*file.guarded_points, *_given(file.frames), *file.capsules]
    for carrier in [part.joint for part in parts]:
        if carrier not in ("", *names):
            raise ValueError(f"{carrier!r} is no joint; there is: {', '.join(names)}")
    if file.guarded_points and not any(
        point.joint == names[-1] and point.point_mm == file.tool.position_mm for point in file.guarded_points
    ):
        raise ValueError(f"no guarded point of joint {names[-1]} lies at the tool, {file.tool.position_mm} mm")
    _check_capsules(file)
    if file.actuators:
        if sliding := [joint.name for joint in file.joints if joint.kind == "prismatic"]:
            raise ValueError(f"actuators are for joints that turn, and these slide: {', '.join(sliding)}")
        file.actuators.check(names)
    for name, pose in file.poses.items():
        if len(pose.joints) != len(names):
            raise ValueError(f"pose {name} has {len(pose.joints)} values for {len(names)} joints")
    for plane in file.planes:
        if not any(plane.normal):
            raise ValueError(f"the normal of plane {plane.name} is zero")
    if "ready" not in file.poses:
        raise ValueError("pose ready is missing")
    if file.planes and "home" not in file.poses:
        raise ValueError("pose home is missing: with planes, the arm parks there")


def _check_capsules(file: RobotFile) -> None:
    names = [capsule.name for capsule in file.capsules]
    for capsule in file.capsules:
        if not capsule.radius_mm > 0:
            raise ValueError(f"capsule {capsule.name} needs a positive radius")
    for pair in file.self_collision:
        if missing := [name for name in pair if name not in names]:
            raise ValueError(f"{missing[0]!r} is no capsule; there is: {', '.join(names) or 'none'}")
        if pair[0] == pair[1]:
            raise ValueError(f"self_collision pairs {pair[0]} with itself")


def _check_joint(joint: JointFile) -> None:
    if not any(joint.screw.direction):
        raise ValueError(f"the axis of joint {joint.name} is zero")
    limits, speed = limits_of(joint)
    if not limits[0] < limits[1] or not speed > 0:
        raise ValueError(f"joint {joint.name} needs limits in rising order and a positive speed")
    if not acceleration_of(joint) > 0:
        raise ValueError(f"joint {joint.name} needs a positive acceleration")


def limits_of(joint: JointFile) -> tuple[tuple[float, float], float]:
    """Limits and speed of a joint in the unit of its kind; raises ValueError when they are given in another, or not."""
    turning, sliding = (joint.limits_deg, joint.speed_deg_s), (joint.limits_mm, joint.speed_mm_s)
    (limits, speed), other, unit = (turning, sliding, "deg") if joint.kind == "revolute" else (sliding, turning, "mm")
    if limits is None or speed is None or other != (None, None):
        raise ValueError(
            f"joint {joint.name} is {joint.kind} and needs limits_{unit} and speed_{unit}_s, in no other unit"
        )
    return limits, speed


def acceleration_of(joint: JointFile) -> float:
    """Acceleration limit in the unit of the joint's kind, infinite where there is none; raises as `limits_of`."""
    given, other, unit = joint.acceleration_deg_s2, joint.acceleration_mm_s2, "deg"
    if joint.kind == "prismatic":
        given, other, unit = other, given, "mm"
    if other is not None:
        raise ValueError(f"joint {joint.name} is {joint.kind} and takes acceleration_{unit}_s2")
    return math.inf if given is None else given


def _given(frames: FramesFile) -> list[FrameFile]:
    return [frame for frame in (frames.station, frames.wrist, frames.rcm) if frame is not None]
