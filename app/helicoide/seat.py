"""One person in front of an arm: what is theirs, whatever the arm does."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from helicoide.kinematics.stages import StageKind as Stages
from helicoide.kinematics.workspace import MapKind
from helicoide.text import Language


@dataclass(frozen=True)
class Seat:
    """One person: language, where they are in a lesson, what they selected and what they want to see.

    done: the steps whose goal has been reached; picked_points: the points, m, world, that they have clicked for a
    plane, None while they do not pick; map_kind: which map of the workspace is chosen; cut: where maps are cut, −1 to 1
    of the arm's reach; stages: in which way the arm is written joint by joint, None in none; cloud_unit: what the
    numbers in files of clouds count, "" as it looks; projector: whether words and handles are large enough for the back
    row; way: how the next waypoint is reached from the one before.
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
    way: str = "joints"

    def with_layer(self, name: str, on: bool) -> Seat:
        """The same seat with one layer of the scene shown or hidden."""
        return replace(self, visible_layers=MappingProxyType({**self.visible_layers, name: on}))


SeatUpdate = Callable[[Seat], Seat]
