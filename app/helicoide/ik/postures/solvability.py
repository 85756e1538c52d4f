"""Whether an arm has a closed form, by Pieper's test, and how many postures it can have for one tool pose."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik.postures.branch import sentences
from helicoide.kinematics import dh
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

# Below this distance, m, axes meet and a link length is zero; below this sine axes are parallel.
MEETING, PARALLEL = 1e-6, 1e-9


class Ground(Enum):
    """Why there is a closed form or not, in words; the axes or the number of joints are filled in."""

    MEETING = Text(
        en="Closed form: axes {axes} intersect at a point (Pieper).",
        pt_BR="Forma fechada: os eixos {axes} se cruzam num ponto (Pieper).",
    )
    PARALLEL = Text(
        en="Closed form: axes {axes} are parallel (Pieper).",
        pt_BR="Forma fechada: os eixos {axes} são paralelos (Pieper).",
    )
    FEW = Text(
        en="Closed form: with {joints} joints an equation of degree at most 4 remains.",
        pt_BR="Forma fechada: com {joints} juntas resta uma equação de grau no máximo 4.",
    )
    REDUNDANT = Text(
        en="Numerically only: {joints} joints have infinitely many postures for one pose.",
        pt_BR="Só numericamente: {joints} juntas têm infinitas posturas para uma mesma pose.",
    )
    NONE = Text(
        en="Numerically only: no three adjacent axes intersect at a point or are parallel.",
        pt_BR="Só numericamente: não há três eixos vizinhos que se cruzem num ponto ou sejam paralelos.",
    )


@dataclass(frozen=True, eq=False)
class Solvability:
    """The result of Pieper's test.

    ground; axes: the three axes, counted from 0; point: where they meet at q = 0, (3,), m; bound: the largest number of
    postures for one pose, and row: the same by the table of the source, both None unless the arm has six revolute
    joints; words: the result in sentences.
    """

    ground: Ground
    axes: tuple[int, ...]
    point: Array | None
    bound: int | None
    row: int | None
    words: Text

    @property
    def closed(self) -> bool:
        """Whether there is a closed form: formulas, or a polynomial of degree 4 at most."""
        return self.ground in (Ground.MEETING, Ground.PARALLEL, Ground.FEW)


def verdict(robot: Robot) -> Solvability:
    """Pieper's test: three adjacent revolute axes that meet at a point, or three that are parallel, suffice.

    With n ≤ 4 joints the missing axes can be chosen through a point of the last one, so that three meet.
    Source: Campos 1998, s.22–26; Pieper 1968.
    """
    ground, joints = Ground.NONE, len(robot.variables)
    axes: tuple[int, ...] = ()
    point: Array | None = None
    if joints > 6:
        ground = Ground.REDUNDANT
    elif (meeting := meeting_axes(robot)) is not None:
        ground, (axes, point) = Ground.MEETING, meeting
    elif (parallel := parallel_axes(robot)) is not None:
        ground, axes = Ground.PARALLEL, parallel
    elif joints <= 4:
        ground = Ground.FEW
    bound, row = solution_bound(robot), table_row(robot)
    shown = ", ".join(str(axis + 1) for axis in axes)
    said = ground.value.format(axes=shown, joints=joints)
    if bound is not None:
        said = sentences(said, AT_MOST.format(bound=bound, row=row))
    return Solvability(ground, axes, point, bound, row, said)


def meeting_axes(robot: Robot) -> tuple[tuple[int, ...], Array] | None:
    """The last three adjacent axes that meet in every posture, counted from 0, and their point at q = 0, (3,), m."""
    for first in reversed(range(len(robot.joints) - 2)):
        axes = (first, first + 1, first + 2)
        if (point := meeting_point(robot, axes)) is not None:
            return axes, point
    return None


def meeting_point(robot: Robot, axes: tuple[int, ...]) -> Array | None:
    """The point where revolute axes meet at q = 0, (3,), m, by least squares; None where they do not.

    Three adjacent axes then meet in every posture: the middle joint rotates the last axis about their common point.
    """
    if not _all_turn(robot, axes):
        return None
    across = np.concatenate([np.eye(3) - np.outer(s, s) for s in robot.directions[list(axes)]])
    sides = np.concatenate([robot.points[i] - (robot.points[i] @ s) * s for i in axes for s in [robot.directions[i]]])
    point, *_ = np.linalg.lstsq(across, sides)
    apart = np.linalg.norm((across @ point - sides).reshape(-1, 3), axis=1)
    return frozen(point) if apart.max() < MEETING else None


def parallel_axes(robot: Robot) -> tuple[int, ...] | None:
    """The first three adjacent revolute axes that are parallel, counted from 0."""
    for first in range(len(robot.joints) - 2):
        axes = (first, first + 1, first + 2)
        sines = np.linalg.norm(np.cross(robot.directions[first], robot.directions[list(axes)]), axis=1)
        if _all_turn(robot, axes) and sines.max() < PARALLEL:
            return axes
    return None


def _all_turn(robot: Robot, axes: tuple[int, ...]) -> bool:
    return not any(robot.joints[axis].is_prismatic or robot.joints[axis].mimic for axis in axes)


def link_lengths(robot: Robot) -> Array:
    """a₁ … aₙ₋₁: the common normals of neighbouring axes, (n − 1,), m."""
    rows = dh.dh_from_screws(robot.joints, robot.T_world_tool_0).rows
    return frozen([row.a for row in rows[:-1]])


def table_row(robot: Robot) -> int | None:
    """What the table of the source prints: a₁ = a₃ = a₅ = 0 ≤ 4, a₃ = a₅ = 0 ≤ 8, else ≤ 16; six revolute joints only.

    Its first two rows do not hold for every arm: the PUMA with a₃ = 0 has eight postures, and arms with a₃ = a₅ = 0,
    a₁ zero or not, right-angled twists and offsets d can have sixteen. Source: Campos 1998, s.22, after Craig.
    """
    if not _has_six(robot):
        return None
    a1, _, a3, _, a5 = link_lengths(robot) < MEETING
    return 4 if a1 and a3 and a5 else 8 if a3 and a5 else 16


def solution_bound(robot: Robot) -> int | None:
    """The largest number of postures for a pose: 8 if the first or last three axes meet, else 16; six revolute joints.

    A quartic and two postures of the wrist give 8. Source: Pieper 1968; Primrose 1986; Lee and Liang 1988.
    """
    if not _has_six(robot):
        return None
    return 8 if any(meeting_point(robot, end) is not None for end in ((0, 1, 2), (3, 4, 5))) else 16


def _has_six(robot: Robot) -> bool:
    return len(robot.joints) == 6 and _all_turn(robot, tuple(range(6)))


AT_MOST = Text(
    en="At most {bound} postures for one pose; the table of Campos 1998, s.22, prints {row}.",
    pt_BR="No máximo {bound} posturas para uma pose; a tabela de Campos 1998, s.22, traz {row}.",
)
