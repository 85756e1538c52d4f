"""What a window can ask for: the requests that its rows, its scene and its palette make."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from helicoide.kinematics.workspace import MapKind
from helicoide.perception.units import Unit
from helicoide.recorder.panel_state import RecordingPanelUpdate
from helicoide.seat import CameraPreset, SeatUpdate
from helicoide.state import Update
from helicoide.studies.panel_state import StudyPanelUpdate
from helicoide.studies.study import Motion
from helicoide.text import Text


@dataclass(frozen=True)
class ForArm:
    """A request to change the state of the arm."""

    update: Update


@dataclass(frozen=True)
class ForSeat:
    """A request to change the seat of this window."""

    update: SeatUpdate


@dataclass(frozen=True)
class ForLab:
    """A request for another robot, by name."""

    robot: str


@dataclass(frozen=True)
class ForStudyPanel:
    """A request to change the study panel."""

    update: StudyPanelUpdate


@dataclass(frozen=True, eq=False)
class Play:
    """A request to replay a recorded motion on the arm. A motion of another robot loads that robot first."""

    motion: Motion


@dataclass(frozen=True)
class Tour:
    """A request to measure the planes with the camera. real: with a RealSense, not with the simulated camera."""

    real: bool = False


@dataclass(frozen=True, eq=False)
class ReadCloud:
    """A request to find a plane in the point cloud of a file. unit: of its coordinates; None if it was not chosen."""

    name: str
    content: bytes
    plane: str
    unit: Unit | None = None


@dataclass(frozen=True)
class CountMap:
    """A request to compute a map of the workspace."""

    kind: MapKind


@dataclass(frozen=True)
class ListPostures:
    """A request to list every posture of the goal."""


@dataclass(frozen=True)
class TrySingular:
    """A request to drive the tool through a singular posture."""


@dataclass(frozen=True)
class PlanMotion:
    """A request to plan the motion that a request would cause, and to show it; title: where it leads."""

    update: Update
    title: Text


@dataclass(frozen=True)
class PlayTaught:
    """A request to follow the taught waypoints."""


@dataclass(frozen=True)
class PlayFastest:
    """A request to follow the path in the least time that the joints allow."""


@dataclass(frozen=True)
class RecordArm:
    """A request to record the arm (on), or to end its recording (off)."""

    on: bool


@dataclass(frozen=True)
class ForRecordingPanel:
    """A request to change what is shown of the open recording."""

    update: RecordingPanelUpdate


@dataclass(frozen=True, eq=False)
class OpenRecording:
    """A request to open a recording of the folder, none for an empty name, or a file with this content."""

    name: str
    content: bytes | None = None


@dataclass(frozen=True)
class DeleteRecording:
    """A request to delete a recording of the folder."""

    name: str


@dataclass(frozen=True)
class SaveRecording:
    """A request to download the open recording as a file of this kind."""

    kind: Literal["mcap", "csv"]


@dataclass(frozen=True)
class CheckLine:
    """A request to check a line that was typed for the exercise of the open step."""

    text: str


@dataclass(frozen=True)
class ResetStep:
    """A request to set up the open step of the lesson again."""


@dataclass(frozen=True)
class Stop:
    """A request to stop all motion."""


@dataclass(frozen=True)
class Undo:
    """A request to undo the last change of the scene, of a setting, or of the sheet of this window."""


@dataclass(frozen=True)
class Redo:
    """A request to make the change again that was undone last."""


@dataclass(frozen=True)
class OwnArm:
    """A request for an arm of one's own (on), or for the shared arm again (off)."""

    on: bool


@dataclass(frozen=True)
class TakeLink:
    """A request to bring an arm to the posture of a link that was opened: the shown arm, or one of one's own (own)."""

    own: bool


@dataclass(frozen=True)
class OpenLink:
    """A request to open a link to a view or a sheet: a whole address, or its fragment alone."""

    address: str


@dataclass(frozen=True)
class CloseLink:
    """A request to forget a link that was opened."""


@dataclass(frozen=True)
class Look:
    """A request to move the camera of this window to a preset."""

    preset: CameraPreset


@dataclass(frozen=True)
class CopyLink:
    """A request for a link to what this window shows."""


@dataclass(frozen=True)
class ShowTab:
    """A request to show a tab by its number, from 0."""

    index: int


@dataclass(frozen=True, eq=False)
class Save:
    """A request to download a file."""

    name: str
    content: bytes


@dataclass(frozen=True)
class SaveNotebook:
    """A request for the scene as a Jupyter notebook."""


@dataclass(frozen=True, eq=False)
class SaveClip:
    """A request for a clip of a motion, or of the last seconds if there is none."""

    motion: Motion | None = None


@dataclass(frozen=True)
class SavePicture:
    """A request for a picture of the scene, (width, height) in pixels."""

    size: tuple[int, int]


FileRequest = SaveNotebook | SaveClip | SavePicture
RecordingRequest = RecordArm | ForRecordingPanel | OpenRecording | DeleteRecording | SaveRecording
PageRequest = (
    ForArm
    | ForSeat
    | ForLab
    | ForStudyPanel
    | Play
    | Tour
    | ReadCloud
    | CountMap
    | ListPostures
    | TrySingular
    | PlanMotion
    | PlayTaught
    | PlayFastest
    | RecordingRequest
    | CheckLine
    | ResetStep
    | Stop
    | Undo
    | Redo
    | OwnArm
    | TakeLink
    | OpenLink
    | CloseLink
    | Look
    | CopyLink
    | ShowTab
    | Save
    | FileRequest
)
Act = Callable[[PageRequest], None]
"""Sends a request."""
Ask = Callable[[Callable[[], PageRequest | None]], None]
"""Makes a request and sends it, unless it is None."""
