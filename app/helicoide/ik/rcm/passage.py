"""The link that passes an entry point, what the entry point forbids it, and how far it is in."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.kinematics.robot import Robot
from helicoide.text import HelicoideError, Text

# What of a point of the shaft may not move sideways, in the axes of the shaft, (r, 3).
TROCAR = frozen([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
SLIT = frozen([[1.0, 0.0, 0.0]])


@dataclass(frozen=True, eq=False)
class Passage:
    """A link whose shaft passes an entry point of r constraints.

    link: i, the link's number; T_link_shaft (4, 4), m: its frame F_i, y along the shaft, from where l_a is measured;
    length: l_a + l_b, m; across (r, 3): the forbidden directions, unit, in F_i.
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
    """How a shaft stands in the entry point.

    outside: l_a, from joint i to the entry point, m; inside: l_b, from there to joint i + 1, m; forbidden: N (r, 3);
    lateral: e_r (r,), m, from the shaft to the entry point along N.
    """

    outside: float
    inside: float
    forbidden: Array
    lateral: Array


def through(robot: Robot, link: int, across: Array = TROCAR) -> Passage:
    """The passage of a link: its shaft runs from the point of its joint to that of the next one, or to the tool.

    Raises HelicoideError where there is no such link, or where it has no length.
    """
    if not 1 <= link <= len(robot.joints):
        raise HelicoideError(
            Text(
                en="{robot} has links 1 to {last}; {link} is none of them.",
                pt_BR="{robot} tem os elos 1 a {last}; {link} não é um deles.",
            ).format(robot=robot.title, last=len(robot.joints), link=link)
        )
    ends = [*robot.points, robot.T_world_tool_0[:3, 3]]
    along = np.asarray(ends[link] - ends[link - 1])
    length = float(np.linalg.norm(along))
    if not length > 0:
        raise HelicoideError(
            Text(
                en="Link {link} of {robot} has no length: an entry point needs a link that two distinct points span.",
                pt_BR="O elo {link} de {robot} não tem comprimento: um ponto de entrada requer um elo entre dois pontos"
                " distintos.",
            ).format(link=link, robot=robot.title)
        )
    T = np.eye(4)
    T[:3, :3] = _along_y(along / length)
    return Passage(link, frozen(T), length, across)


def _along_y(axis: Array) -> Array:
    """A rotation whose y is the axis; that of a shaft along y is the identity."""
    x = np.eye(3)[np.argmin(np.abs(axis))]
    x = x - (x @ axis) * axis
    x /= np.linalg.norm(x)
    return np.column_stack([x, axis, np.cross(x, axis)])


def insertion(passage: Passage, T_world_shaft: Array, entry_world: Array) -> Insertion:
    """Depth and lateral error from the posture: c = R_0iᵀ (p_rcm − p_0i), l_a = c_y, e_r = N (c − l_a y).

    Args: T_world_shaft (4, 4), m: F_i; entry_world: p_rcm (3,), m. Without it l_a would be the one of the start, though
    the shaft slides. Source: after Coutinho 2015, §3.4.
    """
    R = T_world_shaft[:3, :3]
    c = R.T @ (entry_world - T_world_shaft[:3, 3])
    outside = float(c[1])
    N = passage.across
    return Insertion(outside, passage.length - outside, N, N @ [c[0], 0.0, c[2]])


def refusal(robot: Robot, passage: Passage) -> Text | None:
    """Why the tool cannot be moved in all six ways while the shaft passes the entry point; None where it can.

    Six joints must move the restricted link and r more the tool beyond it: n − r ≥ 6, with i ≥ 6 and n − i ≥ r.
    Source: Coutinho 2015, §1.4, §5.1.
    """
    n, i, r = len(robot.variables), passage.link, passage.r
    if any(joint.mimic for joint in robot.joints):
        return Text(
            en="{robot} has joints that follow others; the entry point needs joints that move alone.",
            pt_BR="{robot} tem juntas que seguem outras; o ponto de entrada requer juntas que se movem sozinhas.",
        ).format(robot=robot.title)
    if n - r < 6:
        return Text(
            en="{robot} has {n} joints and the entry point takes {r}: n − r = {left}, but a tool that moves in all six"
            " ways needs 6. Use an arm with at least {least} joints, or leave the tool's orientation free.",
            pt_BR="{robot} tem {n} juntas e o ponto de entrada tira {r}: n − r = {left}, mas um efetuador que se move"
            " nos seis graus de liberdade requer 6. Use um braço com pelo menos {least} juntas ou deixe livre a"
            " orientação do efetuador.",
        ).format(robot=robot.title, n=n, r=r, left=n - r, least=6 + r)
    if i < 6 or n - i < r:
        return Text(
            en="The entry point is on link {i} of {robot}: {i} joints before it and {after} beyond. It takes at least 6"
            " before it and {r} beyond: a link from 6 to {last}.",
            pt_BR="O ponto de entrada está no elo {i} de {robot}: {i} juntas antes e {after} depois. São precisas pelo"
            " menos 6 antes e {r} depois: um elo de 6 a {last}.",
        ).format(i=i, robot=robot.title, after=n - i, r=r, last=n - r)
    return None
