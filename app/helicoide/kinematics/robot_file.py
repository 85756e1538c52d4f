"""The format of `robots/<name>/robot.toml`, in millimetres and degrees."""

from __future__ import annotations

from typing import Literal

import msgspec

from helicoide.kinematics.actuator_file import ActuatorsFile
from helicoide.text import Text

Triple = tuple[float, float, float]
Matrix = tuple[Triple, Triple, Triple]
Assumed = Literal["lengths", "limits", "speeds"]
IDENTITY: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


class TitleFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A name in both languages."""

    en: str
    pt_BR: str

    @property
    def text(self) -> Text:
        """The name as a `Text`."""
        return Text(en=self.en, pt_BR=self.pt_BR)


class ScrewFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A joint's axis at q = 0, in the base frame."""

    direction: Triple
    point_mm: Triple


class DhRowFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A Denavit-Hartenberg row; the joint's variable is added to theta, or to d where the joint slides.

    In the standard convention a and α belong to the same joint; in the modified one, to the joint before.
    """

    theta_deg: float
    d_mm: float
    a_mm: float
    alpha_deg: float


class JointFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A joint and the URDF link that it moves; limits in degrees, or mm if prismatic; acceleration if limited."""

    name: str
    title: TitleFile
    link: str
    screw: ScrewFile
    dh: DhRowFile
    kind: Literal["revolute", "prismatic"] = "revolute"
    limits_deg: tuple[float, float] | None = None
    speed_deg_s: float | None = None
    acceleration_deg_s2: float | None = None
    limits_mm: tuple[float, float] | None = None
    speed_mm_s: float | None = None
    acceleration_mm_s2: float | None = None


class ToolFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The tool frame at q = 0, in the base frame and in the last DH frame."""

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
    """Other frames: where goals are given (station), where the wrist axes meet, remote centre of motion (rcm)."""

    station: FrameFile | None = None
    wrist: FrameFile | None = None
    rcm: FrameFile | None = None


class GripperFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The URDF joint that opens the gripper, and the full opening between the fingers."""

    joint: str
    opening_mm: float


class PointFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A point that planes keep away from, at q = 0; `joint` is the last joint that moves it, "" for none."""

    name: str
    title: TitleFile
    joint: str
    point_mm: Triple


class CapsuleFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A body of the arm at q = 0: all points within the radius of a segment; `joint` as in `PointFile`."""

    name: str
    title: TitleFile
    joint: str
    from_mm: Triple
    to_mm: Triple
    radius_mm: float


class CameraFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The first view of the arm."""

    position_mm: Triple
    look_at_mm: Triple


class PoseFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A named posture: degrees, or mm for prismatic joints."""

    title: TitleFile
    joints: tuple[float, ...]


class PlaneFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """A confinement plane n·r = d with inward normal, and the pane that shows it; printed: as its source prints it."""

    name: str
    title: TitleFile
    normal: Triple
    offset_mm: float
    centre_mm: Triple
    size_mm: tuple[float, float]
    movable: bool
    printed: str = ""


class RobotFile(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The whole file.

    parameters: lengths, mm, that the file may use by name: any length may be a sum such as "l1 + l2", and the URDF may
    hold ${l1}, in metres. assumed: what the source does not give; ours: its former name. floor_mm: where the floor is
    drawn, under the base. self_collision: pairs of capsules, by name, that must not touch each other.
    """

    title: TitleFile
    source: str
    urdf: str
    tool: ToolFile
    joints: tuple[JointFile, ...]
    poses: dict[str, PoseFile]
    parameters: dict[str, float] = {}
    assumed: tuple[Assumed, ...] = ()
    ours: tuple[Assumed, ...] = ()
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
