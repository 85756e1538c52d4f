"""One person at the lab: language, lesson and view settings, independent of the arm."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from helicoide.kinematics.stages import StageKind as Stages
from helicoide.kinematics.workspace import MapKind
from helicoide.seat.chart_choice import ChartChoice
from helicoide.seat.inspection import Notation, Selection
from helicoide.seat.lesson_progress import LessonProgress
from helicoide.seat.playground import Playground
from helicoide.sheet import Sheet, SheetHistory
from helicoide.text import Language


@dataclass(frozen=True)
class LinkedPosture:
    """The posture that a link shows: the name of an arm, and its joint values q, rad or m."""

    robot: str
    q: tuple[float, ...]


@dataclass(frozen=True)
class Seat:
    """One person: language, place in a lesson, selection and view settings.

    done: the steps whose goal has been reached; selected: the inspected object; coefficient: the blade of `CL031` whose
    coefficient is explained; term_joint: the joint highlighted in “Why this number”, from 0; picked_points: the points,
    m, world frame, clicked for a plane, None while no plane is picked; map_kind: the chosen map of the workspace; cut:
    where maps are cut, −1 to 1 in units of the reach; stages: the formulation that is shown joint by joint, None for
    none; cloud_unit: the length unit of cloud files, "" to detect it; projector: whether text and handles are large;
    dark: whether the page is dark; transparent: whether the arm is; linked: the posture of a link that was opened;
    move_type: how the next waypoint is reached from the one before; wrench: force, N, and moment, N·m, on the end
    effector that a layer balances; charts: what the charts show; picture: the chosen size of pictures, a key of
    `export_rows.PICTURES`; sheet: the lines of the console; sheet_history: their changes; progress: how far this
    person is in each lesson begun.
    """

    token: str
    language: Language
    lesson: str | None = None
    step: int = 0
    done: frozenset[str] = frozenset()
    hint_open: bool = False
    selected: Selection | None = None
    coefficient: str | None = None
    term_joint: int | None = None
    notation: Notation = field(default=Notation())
    playground: Playground = field(default=Playground())
    picked_points: tuple[tuple[float, ...], ...] | None = None
    visible_layers: Mapping[str, bool] = field(default_factory=lambda: MappingProxyType({}))
    map_kind: MapKind = "reachable"
    cut: float = 0.0
    stages: Stages | None = None
    cloud_unit: str = ""
    projector: bool = False
    wrench: tuple[float, ...] = (0.0, 0.0, -10.0, 0.0, 0.0, 0.0)
    dark: bool = False
    transparent: bool = False
    linked: LinkedPosture | None = None
    move_type: str = "joints"
    charts: ChartChoice = field(default=ChartChoice())
    picture: str = "page"
    sheet: Sheet = field(default=Sheet())
    sheet_history: SheetHistory = field(default=SheetHistory())
    progress: Mapping[str, LessonProgress] = field(default_factory=lambda: MappingProxyType({}))

    def with_layer(self, name: str, on: bool) -> Seat:
        """The same seat with one layer of the scene shown or hidden."""
        return replace(self, visible_layers=MappingProxyType({**self.visible_layers, name: on}))

    def inspecting(self, selection: Selection | None) -> Seat:
        """The same seat with another object inspected, or none; no coefficient of it is chosen yet."""
        return replace(self, selected=selection, coefficient=None, term_joint=None)


SeatUpdate = Callable[[Seat], Seat]
