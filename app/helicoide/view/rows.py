"""The kinds of rows in a panel. A row says what it shows of a State and a Seat, and which request it makes."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Literal, TypeVar

from markupsafe import Markup
from viser import IconName

from helicoide.kinematics.workspace import MapKind
from helicoide.perception.units import Unit
from helicoide.readout.signal_history import NO_SIGNAL_HISTORY, SignalHistory
from helicoide.recorder.panel_state import NO_RECORDINGS, RecordingPanelState, RecordingPanelUpdate
from helicoide.recorder.recorder import RecorderStatus
from helicoide.seat import Seat, SeatUpdate
from helicoide.state import State, Update
from helicoide.studies.panel_state import NO_STUDY, StudyPanelState, StudyPanelUpdate
from helicoide.studies.study import Chart, Motion
from helicoide.text import Text
from helicoide.view.file_requests import FileRequest

CameraPreset = Literal["front", "side", "top", "tool", "first"]
Key = TypeVar("Key", bound=Hashable)


@dataclass(frozen=True, eq=False)
class View:
    """What one window shows: the state of its arm, its seat, and the seat's study panel.

    ready: whether the kernels are compiled; own: whether the arm belongs to this seat alone, and is not the shared one;
    recordings: the recordings that the seat looks at; recorder: the state of the arm's recorder, None if it has none;
    history: the last samples of the charted signals; time: s, for layers that move while the arm is at rest.
    """

    state: State
    seat: Seat
    study_panel: StudyPanelState = NO_STUDY
    ready: bool = True
    own: bool = False
    recordings: RecordingPanelState = NO_RECORDINGS
    recorder: RecorderStatus | None = None
    history: SignalHistory = NO_SIGNAL_HISTORY
    time: float = 0.0

    def linked_here(self) -> tuple[float, ...] | None:
        """The joint values (n,), rad or m, of a link about the arm that is shown; None without such a link."""
        linked, robot = self.seat.linked, self.state.robot
        fits = linked is not None and linked.robot == robot.name and len(linked.q) == len(self.state.arm.q)
        return linked.q if linked is not None and fits else None

    def handles_moved(self, old: View | None) -> bool:
        """Whether handles may have moved since an older view, or another pointer may hold one."""
        before, now = None if old is None else old.state, self.state
        return before is None or before.problem is not now.problem or before.request.drag is not now.request.drag


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
class Stop:
    """A request to stop all motion."""


@dataclass(frozen=True)
class Undo:
    """A request to undo the last change of the scene or of a setting."""


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
    | Stop
    | Undo
    | Redo
    | OwnArm
    | TakeLink
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


def always(view: View) -> bool:
    """The row can be used at any time."""
    return True


@dataclass(frozen=True)
class HtmlRow:
    """HTML made from the view. computed: it needs the kernels, so it stays empty until they are compiled."""

    html: Callable[[View], Markup]
    computed: bool = False


@dataclass(frozen=True)
class Slider:
    """A number with a slider and a box. A label that depends on the view may show the number in another form."""

    label: Text | Callable[[View], Text]
    lower: float
    upper: float
    step: float
    value: Callable[[View], float]
    request: Callable[[float], PageRequest]
    enabled: Callable[[View], bool] = always


Weight = Literal["primary", "plain", "destructive"]


@dataclass(frozen=True)
class Button:
    """A button. weight: whether it is the main action, one among others, or removes something."""

    label: Callable[[View], Text]
    request: Callable[[View], PageRequest]
    icon: IconName | None = None
    enabled: Callable[[View], bool] = always
    shown: Callable[[View], bool] = always
    weight: Weight = "plain"


@dataclass(frozen=True)
class ButtonGroup:
    """Small buttons in a row, each with its key."""

    label: Text
    options: Sequence[tuple[Any, Text]]
    request: Callable[[Any], PageRequest]


@dataclass(frozen=True)
class Checkbox:
    """A choice between yes and no."""

    label: Text
    value: Callable[[View], bool]
    request: Callable[[bool], PageRequest]


@dataclass(frozen=True)
class Dropdown:
    """A choice of one of several options. `options`: keys with their titles, which may depend on the view."""

    label: Text
    options: Sequence[tuple[Hashable, Text]] | Callable[[View], Sequence[tuple[Hashable, Text]]]
    value: Callable[[View], Hashable]
    request: Callable[[Any], PageRequest]


@dataclass(frozen=True)
class VectorRow:
    """Three numbers, such as a position."""

    label: Text
    step: float
    value: Callable[[View], tuple[float, float, float]]
    request: Callable[[View, tuple[float, float, float]], PageRequest]


@dataclass(frozen=True)
class TextEntry:
    """A text field, and a button that sends its content.

    typed: the request that each change of the text makes; such a field is emptied when its content is sent.
    """

    label: Text
    shown: Callable[[View], str]
    button: Text
    request: Callable[[str], PageRequest]
    typed: Callable[[str], PageRequest] | None = None


@dataclass(frozen=True)
class Upload:
    """A button that uploads a file. `request` takes the view at that time, the file's name and its content."""

    label: Text
    request: Callable[[View, str, bytes], PageRequest]


@dataclass(frozen=True)
class Bar:
    """A progress bar, 0 to 1; hidden while `share` is None."""

    share: Callable[[View], float | None]


@dataclass(frozen=True)
class Plot:
    """Chart number `index` of the view, from 0; hidden if there is none."""

    charts: Callable[[View], Sequence[Chart]]
    index: int


@dataclass(frozen=True)
class DependentRows(Generic[Key]):
    """Rows that depend on a key of the view, such as a tuple of names. They are replaced when the key changes."""

    key: Callable[[View], Key]
    rows: Callable[[Key], Sequence[Row]]


@dataclass(frozen=True)
class Folder:
    """Rows under a heading."""

    label: Text
    rows: Sequence[Row] | DependentRows[Any]
    open: bool = True


Row = (
    HtmlRow | Slider | Button | ButtonGroup | Checkbox | Dropdown | VectorRow | TextEntry | Upload | Bar | Plot | Folder
)
