"""The joints of a URDF between the base and the tip of an arm, and the leaders of its mimic joints."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import yourdfpy

from helicoide.kinematics.urdf_repair import MOVING
from helicoide.kinematics.urdf_tip import is_moving
from helicoide.kinematics.urdf_xml import urdf_error
from helicoide.text import Text

LOOSE_BASE = ("planar", "floating")
BASE_MOVED = Text(
    en="joint {joint} is {kind}: the arm begins at link {base}, which is fixed here",
    pt_BR="a junta {joint} é {kind}: o braço começa no elo {base}, que aqui fica parado",
)
LEADER_OUTSIDE_CHAIN = Text(
    en="the variable is {leader}, which is not between base and tip; it is followed by {joints}",
    pt_BR="a variável é {leader}, que não está entre a base e a ponta; quem a segue: {joints}",
)


def joints_between(
    path: Path, robot: yourdfpy.Robot, base: str | None, tip: str
) -> tuple[str, list[yourdfpy.Joint], list[Text]]:
    """The base, the joints from there to a tip, and remarks.

    The default base is the root, or the child of the last planar or floating joint. Raises HelicoideError for unknown
    links, a base that is not above the tip, and joints of unknown type.
    """
    for link in (tip, base):
        if link is not None and link not in (names := [link.name for link in robot.links]):
            there = ", ".join(names)
            raise urdf_error(
                path,
                Text(en=f"there is no link {link!r}; there is: {there}", pt_BR=f"não há elo {link!r}; há: {there}"),
            )
    way, above = _way_up(robot, base, tip)
    if base not in (None, above):
        links = ", ".join([above, *(joint.child for joint in way)])
        raise urdf_error(
            path,
            Text(
                en=f"link {base!r} is not above {tip!r}; on its way are: {links}",
                pt_BR=f"o elo {base!r} não está acima de {tip!r}; no caminho estão: {links}",
            ),
        )
    begun, remarks = above, list[Text]()
    for i, joint in enumerate(way):
        if joint.type in LOOSE_BASE and base is None and not any(map(is_moving, way[:i])):
            begun = joint.child
            remarks = [BASE_MOVED.format(joint=joint.name, kind=joint.type, base=begun)]
        elif joint.type not in (*MOVING, "fixed"):
            raise urdf_error(path, _unknown(joint))
    start = next((i + 1 for i, joint in enumerate(way) if joint.child == begun), 0)
    return begun, way[start:], remarks


def _way_up(robot: yourdfpy.Robot, base: str | None, tip: str) -> tuple[list[yourdfpy.Joint], str]:
    """The joints from a base, or from the root, to a tip, and the link at which they begin."""
    parents = {joint.child: joint for joint in robot.joints}
    way, link = list[yourdfpy.Joint](), tip
    while link in parents and link != base:
        way.append(parents[link])
        link = way[-1].parent
    return way[::-1], link


def _unknown(joint: yourdfpy.Joint) -> Text:
    kinds = ", ".join((*MOVING, "fixed"))
    if joint.type in LOOSE_BASE:
        return Text(
            en=f"joint {joint.name!r} is of type {joint.type!r}, which only a base has; begin below it with "
            f"--base, at link {joint.child!r}, or use one of: {kinds}",
            pt_BR=f"a junta {joint.name!r} é do tipo {joint.type!r}, que só uma base tem; comece abaixo dela com "
            f"--base, no elo {joint.child!r}, ou use um destes: {kinds}",
        )
    kinds = ", ".join((*MOVING, "fixed", *LOOSE_BASE))
    return Text(
        en=f"joint {joint.name!r} is of type {joint.type!r}; use one of: {kinds}",
        pt_BR=f"a junta {joint.name!r} é do tipo {joint.type!r}; use um destes: {kinds}",
    )


def outside_leaders(path: Path, robot: yourdfpy.Robot, way: Sequence[yourdfpy.Joint]) -> dict[str, list[str]]:
    """The joints outside a chain that joints of the chain follow, each with its followers, by name.

    Raises HelicoideError for a joint that follows itself, or a joint that does not move.
    """
    known, on_way = {joint.name: joint for joint in robot.joints}, {joint.name for joint in way}
    found: dict[str, list[str]] = {}
    for joint in (joint for joint in way if joint.mimic is not None):
        leader = known.get(joint.mimic.joint)
        if leader is None or leader.type not in MOVING or leader.mimic is not None:
            raise urdf_error(path, _no_leader(joint))
        if leader.name not in on_way:
            found.setdefault(str(leader.name), []).append(str(joint.name))
    return found


def _no_leader(joint: yourdfpy.Joint) -> Text:
    return Text(
        en=f"joint {joint.name!r} follows {joint.mimic.joint!r}, which is no joint that moves by itself",
        pt_BR=f"a junta {joint.name!r} segue {joint.mimic.joint!r}, que não é uma junta que se move por si",
    )
