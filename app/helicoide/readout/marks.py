"""What a coefficient means in the scene: arrows, segments, an area or an arc, rebuilt from the coefficients alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from helicoide.arrays import Array
from helicoide.geometry import rigid
from helicoide.readout.elements import Nature
from helicoide.readout.roles import Part, Role, role_of
from helicoide.readout.screws import screw_of_values

# Length of an arrow that shows a direction, as a fraction of the reach.
ARROW = 0.35
# An arrow shorter than this, m, is a component that is zero: it has no direction, and the page would draw its head.
NO_ARROW = 1e-6


def _none(*shape: int) -> Callable[[], Array]:
    return lambda: np.zeros((0, *shape))


@dataclass(frozen=True, eq=False)
class Marks:
    """Arrows (k, 2, 3), segments (k, 2, 3), and the corners (4, 3) of an area, m, world frame; each may be empty."""

    arrows: Array = field(default_factory=_none(2, 3))
    segments: Array = field(default_factory=_none(2, 3))
    area: Array = field(default_factory=_none(3))


def coefficient_marks(nature: Nature, values: Array, blade: str | None, reach: float) -> Marks:
    """What the coefficient of a blade of `CL031` means, from the coefficients (16,), m; reach: of the arm, m.

    A direction: an arrow, and its component. A moment: the area between the lever arm from the origin and the
    direction. A distance: a segment. The cosine of half an angle: the arc of this half.
    """
    role = role_of(nature, blade)
    if role is None:
        return Marks()
    marks = _of_motor(values, role, reach) if nature == "motor" else _OF_PART[role.part](values, role, reach)
    lengths = np.linalg.norm(marks.arrows[:, 1] - marks.arrows[:, 0], axis=1)
    return replace(marks, arrows=marks.arrows[lengths > NO_ARROW])


def _of_motor(values: Array, role: Role, reach: float) -> Marks:
    drawn = screw_of_values(values)
    screw, centre = drawn.screw, drawn.centre
    if screw.angle == 0:  # a translation: it has a direction and a length only
        way = np.array([np.zeros(3), screw.displacement * screw.direction])
        component = role.axis is not None and role.part == "dual"
        return Marks(arrows=np.array([way, *([_component(way, role.axis)] if component else [])]))
    axis = np.array([centre, centre + ARROW * reach * screw.direction])
    match role.part:
        case "cosine":
            return Marks(segments=drawn.sector(0.5))
        case "sine":
            return Marks(arrows=np.array([axis, _component(axis, role.axis)]))
        case "slide":
            return Marks(segments=drawn.slide[None])
        case _:
            return _lever(screw.direction, screw.point, reach, drawn.slide[None])


def _direction(values: Array, role: Role, reach: float) -> Marks:
    v, u = rigid.direction_and_moment(values)
    foot = np.cross(v, u)
    arrow = np.array([foot, foot + ARROW * reach * v])
    return Marks(arrows=np.array([arrow, _component(arrow, role.axis)]))


def _moment(values: Array, role: Role, reach: float) -> Marks:
    v, u = rigid.direction_and_moment(values)
    return _lever(v, np.cross(v, u), reach, np.zeros((0, 2, 3)))


def _lever(direction: Array, foot: Array, reach: float, segments: Array) -> Marks:
    """The lever arm from the origin to the line, and the area that it spans with the direction."""
    along = ARROW * reach * direction
    return Marks(
        arrows=np.array([[foot, foot + along]]),
        segments=np.array([[np.zeros(3), foot], *segments]),
        area=np.array([np.zeros(3), foot, foot + along, along]),
    )


def _normal(values: Array, role: Role, reach: float) -> Marks:
    n, d = rigid.normal_and_offset(values)
    arrow = np.array([d * n, d * n + ARROW * reach * n])
    return Marks(arrows=np.array([arrow, _component(arrow, role.axis)]))


def _offset(values: Array, role: Role, reach: float) -> Marks:
    n, d = rigid.normal_and_offset(values)
    return Marks(segments=np.array([[np.zeros(3), d * n]]))


def _coordinate(values: Array, role: Role, reach: float) -> Marks:
    point = rigid.coordinates(values)
    way = np.zeros((2, 3))
    way[:] = point
    way[0, role.axis or 0] = 0.0
    return Marks(segments=np.array([[np.zeros(3), way[0]]]), arrows=way[None])


def _weight(values: Array, role: Role, reach: float) -> Marks:
    return Marks(segments=np.array([[np.zeros(3), rigid.coordinates(values)]]))


_OF_PART: dict[Part, Callable[[Array, Role, float], Marks]] = {
    "direction": _direction,
    "moment": _moment,
    "normal": _normal,
    "offset": _offset,
    "coordinate": _coordinate,
    "weight": _weight,
}


def _component(arrow: Array, axis: int | None) -> Array:
    """The component of an arrow (2, 3) along a coordinate axis, from the same start."""
    way = np.zeros(3)
    if axis is not None:
        way[axis] = (arrow[1] - arrow[0])[axis]
    return np.array([arrow[0], arrow[0] + way])
