"""One person at the lab: language, lesson and view settings, independent of the arm."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from helicoide.kinematics.stages import StageKind as Stages
from helicoide.kinematics.workspace import MapKind
from helicoide.text import Language


@dataclass(frozen=True)
class ChartChoice:
    """What the charts of live signals show.

    shown: the names of their signals or phase planes, "" for no chart; span: the time that they show, s; log: whether
    the axis is logarithmic where the signal is positive; paused: whether no samples are taken; loop: whether the
    control loop is drawn; matrix: the name of the matrix that is shown, "" for none.
    """

    shown: tuple[str, ...] = ()
    span: float = 20.0
    log: bool = False
    paused: bool = False
    loop: bool = False
    matrix: str = ""


@dataclass(frozen=True)
class Seat:
    """One person: language, place in a lesson, selection and view settings.

    done: the steps whose goal has been reached; picked_points: the points, m, world frame, clicked for a plane, None
    while no plane is picked; map_kind: the chosen map of the workspace; cut: where maps are cut, −1 to 1 in units of
    the reach; stages: the formulation that is shown joint by joint, None for none; cloud_unit: the length unit of cloud
    files, "" to detect it; projector: whether text and handles are large; way: how the next waypoint is reached from
    the one before; charts: what the charts show.
    """

    token: str
    language: Language
    lesson: str | None = None
    step: int = 0
    done: frozenset[str] = frozenset()
    hint_open: bool = False
    selected: str | None = None
    picked_points: tuple[tuple[float, ...], ...] | None = None
    visible_layers: Mapping[str, bool] = field(default_factory=lambda: MappingProxyType({}))
    map_kind: MapKind = "reachable"
    cut: float = 0.0
    stages: Stages | None = None
    cloud_unit: str = ""
    projector: bool = False
    move_type: str = "joints"
    charts: ChartChoice = ChartChoice()

    def with_layer(self, name: str, on: bool) -> Seat:
        """The same seat with one layer of the scene shown or hidden."""
        return replace(self, visible_layers=MappingProxyType({**self.visible_layers, name: on}))


SeatUpdate = Callable[[Seat], Seat]
