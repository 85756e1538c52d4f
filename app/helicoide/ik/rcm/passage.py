"""The link that passes through an entry point, its forbidden directions, and its depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

# Directions in which the point of the shaft at the entry may not move, in the axes of the shaft, (r, 3).
TROCAR = frozen([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
SLIT = frozen([[1.0, 0.0, 0.0]])


@dataclass(frozen=True, eq=False)
class Passage:
    """A link whose shaft passes through an entry point with r constraints.

    link: i, the link's number; T_link_shaft (4, 4), m: the frame F_i, y along the shaft, l_a is measured from its
    origin; length: l_a + l_b, m; across (r, 3): the forbidden directions, unit vectors in F_i.
    Source: Coutinho 2015, figs. 3.1, 3.2.
    """

    link: int
    T_link_shaft: Array
    length: float
    across: Array

    @property
    def r(self) -> int:
        """The dimension of the constraint: 2 for a trocar, 1 for a slit."""
        return len(self.across)


@dataclass(frozen=True, eq=False)
class Insertion:
    """The position of a shaft relative to the entry point.

    outside: l_a, from joint i to the entry point, m; inside: l_b, from there to joint i + 1, m; forbidden: N (r, 3);
    lateral: e_r (r,), m, from the shaft to the entry point along N.
    """

    outside: float
    inside: float
    forbidden: Array
    lateral: Array


def through(robot: Robot, link: int, across: Array = TROCAR) -> Passage:
    """The passage of a link, whose shaft runs from the point of its joint to that of the next one or to the tool.

    across (r, 3): the forbidden directions in the axes of the shaft. Raises HelicoideError if there is no such link or
    if it has no length.
    """
    if not 1 <= link <= len(robot.joints):
        raise HelicoideError(
            Text(
                en="{robot} has no link {link}; its links are 1 to {last}.",
                pt_BR="{robot} não tem o elo {link}; os elos são 1 a {last}.",
            ).format(robot=robot.title, last=len(robot.joints), link=link)
        )
    ends = [*robot.points, robot.T_world_tool_0[:3, 3]]
    along = np.asarray(ends[link] - ends[link - 1])
    length = float(np.linalg.norm(along))
    if not length > 0:
        raise HelicoideError(
            Text(
                en="Link {link} of {robot} has no length: an entry point needs a link between two distinct points.",
                pt_BR="O elo {link} de {robot} não tem comprimento: um ponto de entrada requer um elo entre dois pontos"
                " distintos.",
            ).format(link=link, robot=robot.title)
        )
    T = np.eye(4)
    T[:3, :3] = _along_y(along / length)
    return Passage(link, frozen(T), length, across)


def _along_y(axis: Array) -> Array:
    """A rotation (3, 3) whose y is the axis (3,)."""
    x = np.eye(3)[np.argmin(np.abs(axis))]
    x = x - (x @ axis) * axis
    x /= np.linalg.norm(x)
    return np.column_stack([x, axis, np.cross(x, axis)])


def insertion(passage: Passage, T_world_shaft: Array, entry_world: Array) -> Insertion:
    """Depth and lateral error at a posture: c = R_0iᵀ (p_rcm − p_0i), l_a = c_y, e_r = N (c − l_a y).

    l_a changes as the shaft slides, so it is computed at each posture. Args: T_world_shaft (4, 4), m: F_i;
    entry_world: p_rcm (3,), m. Source: after Coutinho 2015, §3.4.
    """
    R = T_world_shaft[:3, :3]
    c = R.T @ (entry_world - T_world_shaft[:3, 3])
    outside = float(c[1])
    N = passage.across
    return Insertion(outside, passage.length - outside, N, N @ [c[0], 0.0, c[2]])


def passage_refusal(robot: Robot, passage: Passage) -> Text | None:
    """Why the tool cannot have six degrees of freedom while the shaft passes through the entry point; None if it can.

    At least six joints must move the restricted link and r more the tool beyond it: n − r ≥ 6, i ≥ 6, n − i ≥ r. No
    joint may follow another one.
    Source: Coutinho 2015, §1.4, §5.1.
    """
    n, i, r = len(robot.variables), passage.link, passage.r
    if any(joint.mimic for joint in robot.joints):
        return Text(
            en="{robot} has coupled joints; the entry point needs independent joints.",
            pt_BR="{robot} tem juntas acopladas; o ponto de entrada requer juntas independentes.",
        ).format(robot=robot.title)
    if n - r < 6:
        return Text(
            en="{robot} has {n} joints and the entry point takes {r} degrees of freedom: n − r = {left}, but an end "
            "effector with six degrees of freedom needs 6. Use an arm with at least {least} joints, or leave the "
            "orientation free.",
            pt_BR="{robot} tem {n} juntas e o ponto de entrada tira {r} graus de liberdade: n − r = {left}, mas um "
            "efetuador com seis graus de liberdade requer 6. Use um braço com pelo menos {least} juntas ou deixe "
            "livre a orientação.",
        ).format(robot=robot.title, n=n, r=r, left=n - r, least=6 + r)
    if i < 6 or n - i < r:
        return Text(
            en="The entry point is on link {i} of {robot}: {i} joints before it and {after} beyond it. It needs at "
            "least 6 before it and {r} beyond it: a link from 6 to {last}.",
            pt_BR="O ponto de entrada está no elo {i} de {robot}: {i} juntas antes e {after} depois. São precisas pelo"
            " menos 6 antes e {r} depois: um elo de 6 a {last}.",
        ).format(i=i, robot=robot.title, after=n - i, r=r, last=n - r)
    return None
