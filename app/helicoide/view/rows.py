"""What a panel is made of: rows that say what they show of a State and a Seat, and what they wish."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Literal, TypeVar

from markupsafe import Markup
from viser import IconName

from helicoide.kinematics.workspace import MapKind
from helicoide.perception.units import Unit
from helicoide.seat import Seat, SeatUpdate
from helicoide.state import State, Update
from helicoide.studies.panel_state import NO_STUDY, StudyPanelState, StudyPanelUpdate
from helicoide.studies.study import Chart, Motion
from helicoide.text import Text

Key = TypeVar("Key", bound=Hashable)


@dataclass(frozen=True, eq=False)
class View:
    """What one window shows: its arm, its person, and what that person has of the studies.

    ready: whether the kernels are there, so that numbers can be worked out at once; own: whether the arm is the
    person's own, and not the one that all share.
    """

    state: State
    seat: Seat
    desk: StudyPanelState = NO_STUDY
    ready: bool = True
    own: bool = False

    def handles_moved(self, old: View | None) -> bool:
        """Whether what can be dragged may stand elsewhere than in an older view, or be in another hand."""
        before, now = None if old is None else old.state, self.state
        return before is None or before.problem is not now.problem or before.request.drag is not now.request.drag


@dataclass(frozen=True)
class ForArm:
    """A wish about the arm."""

    update: Update


@dataclass(frozen=True)
class ForSeat:
    """A wish about the window itself."""

    update: SeatUpdate


@dataclass(frozen=True)
class ForLab:
    """A wish for another robot, by name."""

    robot: str


@dataclass(frozen=True)
class ForDesk:
    """A wish about the studies."""

    update: StudyPanelUpdate


@dataclass(frozen=True, eq=False)
class Play:
    """A wish to see what an arm did on the arm; it is put up first where another one stands there."""

    motion: Motion


@dataclass(frozen=True)
class Tour:
    """A wish that the arm reads every plane that it can; real: with a RealSense, and not the simulated camera."""

    real: bool = False


@dataclass(frozen=True, eq=False)
class ReadCloud:
    """A wish to look for a plane in the cloud of a file; plane: its name; unit: as it was chosen, if it was."""

    name: str
    content: bytes
    plane: str
    unit: Unit | None = None


@dataclass(frozen=True)
class CountMap:
    """A wish for a map of the workspace."""

    kind: MapKind


@dataclass(frozen=True)
class ListPostures:
    """A wish to see every posture of the goal."""


@dataclass(frozen=True)
class PlayTaught:
    """A wish to go through the waypoints that were taught."""


@dataclass(frozen=True)
class PlayFastest:
    """A wish to follow the path in the least time that the joints allow."""


@dataclass(frozen=True)
class Stop:
    """A wish that nothing moves."""


@dataclass(frozen=True)
class OwnArm:
    """A wish for an arm of one's own, or, off, for the shared one again."""

    on: bool


@dataclass(frozen=True)
class ShowTab:
    """A wish to see the tab of that number, from 0."""

    index: int


@dataclass(frozen=True, eq=False)
class Save:
    """A wish to have a file."""

    name: str
    content: bytes


PageRequest = (
    ForArm
    | ForSeat
    | ForLab
    | ForDesk
    | Play
    | Tour
    | ReadCloud
    | CountMap
    | ListPostures
    | PlayTaught
    | PlayFastest
    | Stop
    | OwnArm
    | ShowTab
    | Save
)
Act = Callable[[PageRequest], None]
"""Hands on a wish."""
Ask = Callable[[Callable[[], PageRequest | None]], None]
"""Makes a wish and hands it on, unless it comes to none."""


def always(view: View) -> bool:
    """The row can be used at any time."""
    return True


@dataclass(frozen=True)
class HtmlRow:
    """HTML made from the view; computed: with kernels, so that it waits until they are there."""

    html: Callable[[View], Markup]
    computed: bool = False


@dataclass(frozen=True)
class Slider:
    """A number with a slider and a box; its label may say more of the number than the slider does."""

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
    """A press; weight: whether it is the first thing to do there, one among others, or takes something away."""

    label: Callable[[View], Text]
    request: Callable[[View], PageRequest]
    icon: IconName | None = None
    enabled: Callable[[View], bool] = always
    shown: Callable[[View], bool] = always
    weight: Weight = "plain"


@dataclass(frozen=True)
class Checkbox:
    """A choice between yes and no."""

    label: Text
    value: Callable[[View], bool]
    request: Callable[[bool], PageRequest]


@dataclass(frozen=True)
class Dropdown:
    """One of several; `options` are keys with what is shown for them, and may change with the view."""

    label: Text
    options: Sequence[tuple[str, Text]] | Callable[[View], Sequence[tuple[str, Text]]]
    value: Callable[[View], str]
    request: Callable[[str], PageRequest]


@dataclass(frozen=True)
class VectorRow:
    """Three numbers, such as a position."""

    label: Text
    step: float
    value: Callable[[View], tuple[float, float, float]]
    request: Callable[[View, tuple[float, float, float]], PageRequest]


@dataclass(frozen=True)
class TextEntry:
    """A line to type in, and a button that hands on what stands there."""

    label: Text
    shown: Callable[[View], str]
    button: Text
    request: Callable[[str], PageRequest]


@dataclass(frozen=True)
class Upload:
    """A button that takes a file from the person: its name and its content, and what the window showed then."""

    label: Text
    request: Callable[[View, str, bytes], PageRequest]


@dataclass(frozen=True)
class Bar:
    """How far something is, 0 to 1; hidden while it is None."""

    share: Callable[[View], float | None]


@dataclass(frozen=True)
class Plot:
    """The chart of that number among those of the view; hidden where there is none."""

    charts: Callable[[View], Sequence[Chart]]
    index: int


@dataclass(frozen=True)
class DependentRows(Generic[Key]):
    """Rows that hang on a key of the view, such as a tuple of names, and are placed anew when that changes."""

    key: Callable[[View], Key]
    rows: Callable[[Key], Sequence[Row]]


@dataclass(frozen=True)
class Folder:
    """Rows under a heading."""

    label: Text
    rows: Sequence[Row] | DependentRows[Any]
    open: bool = True


Row = HtmlRow | Slider | Button | Checkbox | Dropdown | VectorRow | TextEntry | Upload | Bar | Plot | Folder
