"""The kinds of rows in a panel. A row says what it shows of a `View`, and which request it makes."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Literal, TypeVar

from markupsafe import Markup
from viser import IconName

from helicoide.studies.study import Chart
from helicoide.text import Text
from helicoide.view.requests import PageRequest
from helicoide.view.window_view import View

Key = TypeVar("Key", bound=Hashable)


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
