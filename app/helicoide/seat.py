"""One person at the lab: language, lesson and view settings, independent of the arm."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Literal

from helicoide.arrays import Array
from helicoide.geometry import rotation
from helicoide.geometry.notation import BladeNaming
from helicoide.kinematics.stages import StageKind as Stages
from helicoide.kinematics.workspace import MapKind
from helicoide.sheet import Sheet
from helicoide.text import Language

SMALLEST_AXIS = 1e-9  # length below which three numbers give no direction
LARGEST_ANGLE = 4 * math.pi

SelectionKind = Literal["tool", "target", "link", "joint", "plane", "point", "frame", "entry", "path"]
ShownAlgebra = Literal["Cl(0,3,1)", "Cl(3,0,1)"]
"""The algebra of the sources, or that of modern texts."""


@dataclass(frozen=True)
class Selection:
    """An object of the scene that a person inspects. index: its number among those of its kind, from 0."""

    kind: SelectionKind
    index: int = 0


@dataclass(frozen=True)
class Notation:
    """How multivectors and orientations are written. euler: one of `geometry.euler.CONVENTIONS`."""

    algebra: ShownAlgebra = "Cl(0,3,1)"
    naming: BladeNaming = "factors"
    euler: str = "zyx"


def is_finite_number(value: object) -> bool:
    """Whether a value, as a page may send it, is a finite number."""
    return isinstance(value, int | float) and math.isfinite(value)


@dataclass(frozen=True)
class AxisAngle:
    """A rotation by an angle, rad, about an axis (not zero)."""

    axis: tuple[float, float, float]
    angle: float

    def about(self, axis: tuple[float, float, float]) -> AxisAngle:
        """The same angle about another axis, scaled to length one; unchanged if the numbers give no direction."""
        if not all(map(is_finite_number, axis)) or (length := math.hypot(*axis)) < SMALLEST_AXIS:
            return self
        x, y, z = (value / length for value in axis)
        return replace(self, axis=(x, y, z)) if math.isfinite(length) else self

    def turned_by(self, angle: float) -> AxisAngle:
        """Another angle, rad, about the same axis; unchanged unless it is a number of at most two turns."""
        return replace(self, angle=float(angle)) if is_finite_number(angle) and abs(angle) < LARGEST_ANGLE else self


@dataclass(frozen=True)
class Playground:
    """Two rotations to compare and compose. t: fraction of the way from the first to the second, 0 to 1.

    opposite: whether the first one is written −q, which is the same rotation.
    """

    first: AxisAngle = AxisAngle((0.0, 0.0, 1.0), 1.5)
    second: AxisAngle = AxisAngle((1.0, 0.0, 0.0), 2.0)
    t: float = 0.5
    opposite: bool = False

    @property
    def quaternions(self) -> tuple[Array, Array]:
        """The quaternions of the two rotations, wxyz (4,), the first with the chosen sign."""
        p, q = (rotation.from_axis_angle(one.axis, one.angle) for one in (self.first, self.second))
        return -p if self.opposite else p, q

    def at(self, t: float) -> Playground:
        """The same rotations at another fraction of the way, 0 to 1; unchanged unless it is one."""
        return replace(self, t=float(t)) if is_finite_number(t) and 0 <= t <= 1 else self


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
    effector that a layer balances; charts: what the charts show;
    picture: the chosen size of pictures, a key of `export_rows.PICTURES`; sheet: the lines of the console.
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
    notation: Notation = Notation()
    playground: Playground = Playground()
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
    charts: ChartChoice = ChartChoice()
    picture: str = "page"
    sheet: Sheet = field(default=Sheet())

    def with_layer(self, name: str, on: bool) -> Seat:
        """The same seat with one layer of the scene shown or hidden."""
        return replace(self, visible_layers=MappingProxyType({**self.visible_layers, name: on}))

    def inspecting(self, selection: Selection | None) -> Seat:
        """The same seat with another object inspected, or none; no coefficient of it is chosen yet."""
        return replace(self, selected=selection, coefficient=None, term_joint=None)


SeatUpdate = Callable[[Seat], Seat]
