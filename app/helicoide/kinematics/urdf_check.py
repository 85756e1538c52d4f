"""Checks of a URDF. Errors name the link or joint. Parts that the kinematics does not use are not checked."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from xml.etree.ElementTree import Element

import yourdfpy

from helicoide.kinematics.urdf_numbers import MOST, parse_numbers
from helicoide.kinematics.urdf_xml import urdf_error
from helicoide.text import Text

PART_TITLES = {"link": Text(en="link", pt_BR="elo"), "joint": Text(en="joint", pt_BR="junta")}
# Xacro elements that change no link and no joint.
IGNORED_XACRO = ("xacro:property", "xacro:arg")
UNRESOLVED = ("${", "$(")
XACRO = Text(
    en="it is xacro ({what}); make a URDF of it with xacro", pt_BR="é xacro ({what}); gere um URDF com o xacro"
)
# For each attribute of a joint: how many numbers it must have, and their largest allowed absolute value.
REQUIRED_NUMBERS = {
    "origin": {"xyz": (3, MOST), "rpy": (3, MOST)},
    "axis": {"xyz": (3, MOST)},
    "limit": {"lower": (1, math.inf), "upper": (1, math.inf)},
    "mimic": {"multiplier": (1, MOST), "offset": (1, MOST)},
}


def check_parts(path: Path, root: Element) -> None:
    """Raise HelicoideError for a file that is no URDF, for missing or repeated names, and for invalid joints."""
    if root.tag != "robot":
        raise urdf_error(
            path, Text(en=f"it starts with {root.tag!r}, not 'robot'", pt_BR=f"começa com {root.tag!r}, não 'robot'")
        )
    for element in root.iter():
        if element.tag.startswith("xacro:") and element.tag not in IGNORED_XACRO:
            raise urdf_error(path, XACRO.format(what=f"<{element.tag}>"))
    if root.find("link") is None:
        raise urdf_error(path, Text(en="it has no links", pt_BR="não tem elos"))
    known = set[tuple[str, str]]()
    for part in (part for part in root if part.tag in PART_TITLES):
        which = (part.tag, part.get("name", ""))
        if _is_unresolved(which[1]):
            raise urdf_error(path, XACRO.format(what=which[1]))
        if not which[1] or which in known:
            raise urdf_error(path, _of(part, "needs a name of its own", "precisa de um nome só seu"))
        known.add(which)
        if part.tag == "joint":
            _check_joint(path, part)


def _is_unresolved(words: str) -> bool:
    return any(sign in words for sign in UNRESOLVED)


def _of(part: Element, en: str, pt_BR: str) -> Text:
    kind, name = PART_TITLES[part.tag], part.get("name", "")
    return Text(en=f"{kind.en} {name!r} {en}", pt_BR=f"{kind.pt_BR} {name!r} {pt_BR}")


def _check_joint(path: Path, joint: Element) -> None:
    for end in ("parent", "child"):
        if (element := joint.find(end)) is None or not element.get("link"):
            raise urdf_error(path, _of(joint, f"has no {end} link", f"não tem o elo {end}"))
    fixed = joint.get("type", "").strip().lower() == "fixed"
    for tag, attributes in REQUIRED_NUMBERS.items():
        if (element := joint.find(tag)) is None or (fixed and tag != "origin"):
            continue
        for attribute, (count, most) in attributes.items():
            words = element.get(attribute)
            if words is not None and not parse_numbers(words, count, most):
                raise urdf_error(path, _wrong_number(joint, f'{tag} {attribute}="{words}"', count))


def _wrong_number(joint: Element, given: str, count: int) -> Text:
    given = " ".join(given.split())
    if _is_unresolved(given):
        return _of(joint, f"has {given}: {XACRO['en'].format(what='${}')}", f"tem {given}: {XACRO.pt_BR}")
    return _of(
        joint,
        f"has {given}: give finite numbers, {count}, of at most {MOST:g}",
        f"tem {given}: dê números finitos, {count}, de até {MOST:g}",
    )


def check_tree(path: Path, robot: yourdfpy.Robot) -> None:
    """Raise HelicoideError for unknown links, links with two parents, cycles, and several roots."""
    links, parents = {link.name for link in robot.links}, dict[str, str]()
    for joint in robot.joints:
        for name in (joint.parent, joint.child):
            if name not in links:
                en, pt_BR = (
                    "joint {!r} names link {!r}, which is not there",
                    "a junta {!r} cita o elo {!r}, que não existe",
                )
                raise urdf_error(path, Text(en=en.format(joint.name, name), pt_BR=pt_BR.format(joint.name, name)))
        if joint.child in parents:
            two = f"{joint.child!r}: {parents[joint.child]!r}, {joint.parent!r}"
            raise urdf_error(path, Text(en=f"two parents of link {two}", pt_BR=f"dois pais do elo {two}"))
        parents[joint.child] = joint.parent
    roots = [link.name for link in robot.links if link.name not in parents]
    _check_cycles(path, parents, set(roots))
    if len(roots) > 1:
        several = ", ".join(roots)
        raise urdf_error(path, Text(en=f"it has several roots: {several}", pt_BR=f"tem várias raízes: {several}"))


def _check_cycles(path: Path, parents: Mapping[str, str], sound: set[str]) -> None:
    """Raise HelicoideError if the links form a cycle. sound: links known to descend from a root; others are added."""
    for name in parents:
        way, on_it = [name], {name}
        while way[-1] not in sound:
            above = parents[way[-1]]
            if above in on_it:
                circle = " → ".join([*way[way.index(above) :], above])
                raise urdf_error(
                    path, Text(en=f"the links go in a circle: {circle}", pt_BR=f"os elos formam um ciclo: {circle}")
                )
            way.append(above)
            on_it.add(above)
        sound.update(way)
