"""A URDF reduced to the parts in use: links with their visuals, and joints.

Errors in inertia, collisions, transmissions, extensions of other programs or visuals do not prevent loading an arm.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from xml.etree.ElementTree import Element, SubElement

import numpy as np
from numpy.typing import NDArray

from helicoide.geometry import euler
from helicoide.kinematics.urdf_numbers import MOST, format_numbers, parse_numbers
from helicoide.text import Text, untranslated

URDF = euler.EXTRINSIC + "xyz"
SOLIDS = {"box": {"size": 3}, "cylinder": {"radius": 1, "length": 1}, "sphere": {"radius": 1}}
ROUND = {"radius": 1, "length": 1}
ZERO_NUMBER = format_numbers([0.0])
NO_GEOMETRY = Text(en="no geometry", pt_BR="sem geometria")
WRONG_PLACE = Text(en="its pose is not made of finite numbers", pt_BR="a pose não é de números finitos")
WRONG_SIZE = Text(en="its {tag} has no size in finite numbers", pt_BR="o {tag} não tem tamanho em números finitos")
UNKNOWN = Text(en="{tag} is unknown", pt_BR="{tag} é desconhecido")


class NotDrawn(Exception):
    """The reason why a visual of a link is left out."""

    def __init__(self, why: Text) -> None:
        super().__init__(why.en)
        self.why = why


def cleaned_urdf(root: Element, name: str) -> tuple[Element, list[tuple[str, Text]]]:
    """The robot with only these parts, and the links with omitted visuals, each with the reason.

    name: used if the robot has none. The joints must have been checked.
    """
    robot, left_out = Element("robot", name=root.get("name") or name), list[tuple[str, Text]]()
    for part in root:
        if part.tag == "link":
            link = SubElement(robot, "link", name=part.get("name", ""))
            for visual in part.findall("visual"):
                try:
                    link.extend(list(_visuals(visual)))
                except NotDrawn as error:
                    left_out.append((part.get("name", ""), error.why))
        elif part.tag == "joint":
            robot.append(_joint(part))
        elif part.tag == "material" and (material := _material(part)) is not None:
            robot.append(material)
    return robot, left_out


def _joint(part: Element) -> Element:
    kind = part.get("type", "").strip().lower()
    joint = Element("joint", name=part.get("name", ""), type=kind)
    for tag in ("parent", "child"):
        SubElement(joint, tag, link=part.find(tag).get("link", ""))  # type: ignore[union-attr]  # it was checked
    joint.append(_with_origin(part))
    if kind == "fixed":
        return joint
    if (axis := part.find("axis")) is not None:
        SubElement(joint, "axis", xyz=format_numbers(_unit(np.array(parse_numbers(axis.get("xyz", "1 0 0"), 3)))))
    if (limit := part.find("limit")) is not None:
        given = {key: parse_numbers(limit.get(key), 1, math.inf) for key in ("lower", "upper", "velocity")}
        SubElement(joint, "limit", {key: format_numbers(value) for key, value in given.items() if value})
    if (mimic := part.find("mimic")) is not None:
        factors = {key: mimic.get(key, usual) for key, usual in (("multiplier", "1"), ("offset", "0"))}
        SubElement(joint, "mimic", {"joint": mimic.get("joint", ""), **factors})
    return joint


def _unit(axis: NDArray[np.float64]) -> list[float]:
    """The unit vector along an axis; zero for a zero axis."""
    largest = float(np.abs(axis).max())
    if not largest > 0:
        return [0.0, 0.0, 0.0]
    scaled = axis / largest
    return [float(x) for x in scaled / np.linalg.norm(scaled)]


def _with_origin(part: Element) -> Element:
    """The origin of a joint or a visual; zero if none is given."""
    given = part.find("origin")
    found = {
        key: parse_numbers("0 0 0" if given is None else given.get(key, "0 0 0"), 3, MOST) for key in ("xyz", "rpy")
    }
    if not all(found.values()):
        raise NotDrawn(WRONG_PLACE)
    return Element("origin", {key: format_numbers(values) for key, values in found.items()})


def _visuals(visual: Element) -> Iterator[Element]:
    """The visual itself, or a capsule as a cylinder between two spheres."""
    geometry = visual.find("geometry")
    if geometry is None or len(geometry) == 0:
        raise NotDrawn(NO_GEOMETRY)
    solid, origin = geometry[0], _with_origin(visual)
    if solid.tag == "capsule":
        yield from _capsule(visual, origin, solid)
    elif solid.tag == "mesh":
        yield _visual(visual, origin, "mesh", _mesh(solid))
    elif solid.tag in SOLIDS:
        sizes = _sizes(solid, SOLIDS[solid.tag])
        if ZERO_NUMBER not in sizes.values():
            yield _visual(visual, origin, solid.tag, sizes)
    else:
        raise NotDrawn(UNKNOWN.format(tag=untranslated(str(solid.tag))))


def _visual(visual: Element, origin: Element, tag: str, sizes: dict[str, str]) -> Element:
    drawn = Element("visual", {"name": visual.get("name", "")} if visual.get("name") else {})
    drawn.append(origin)
    SubElement(SubElement(drawn, "geometry"), tag, sizes)
    if (material := visual.find("material")) is not None and (kept := _material(material)) is not None:
        drawn.append(kept)
    return drawn


def _capsule(visual: Element, origin: Element, solid: Element) -> Iterator[Element]:
    """A capsule as three solids; its length is that of the cylinder, as in SDFormat and MuJoCo."""
    sizes = _sizes(solid, ROUND)
    if sizes["radius"] == ZERO_NUMBER:
        return
    if sizes["length"] != ZERO_NUMBER:
        yield _visual(visual, origin, "cylinder", sizes)
    xyz, rpy = (np.array(parse_numbers(origin.get(key), 3)) for key in ("xyz", "rpy"))
    up = euler.euler_matrix(rpy, URDF)[:, 2] * float(sizes["length"]) / 2
    for end in (xyz + up, xyz - up):
        yield _visual(
            visual, Element("origin", xyz=format_numbers(end.tolist())), "sphere", {"radius": sizes["radius"]}
        )


def _sizes(solid: Element, wanted: dict[str, int]) -> dict[str, str]:
    found = {key: parse_numbers(solid.get(key), count, MOST) for key, count in wanted.items()}
    if not all(values and min(values) >= 0 for values in found.values()):
        raise NotDrawn(WRONG_SIZE.format(tag=untranslated(str(solid.tag))))
    return {key: format_numbers(values) for key, values in found.items()}


def _mesh(solid: Element) -> dict[str, str]:
    words, filename = solid.get("scale"), solid.get("filename", "").strip()
    if not filename:
        raise NotDrawn(NO_GEOMETRY)
    if words is None:
        return {"filename": filename}
    scale = parse_numbers(words, 3, MOST) or 3 * parse_numbers(words, 1, MOST)
    if not scale or 0 in scale:
        raise NotDrawn(WRONG_SIZE.format(tag=untranslated("mesh")))
    return {"filename": filename, "scale": format_numbers(scale)}


def _material(material: Element) -> Element | None:
    """Name and colour of a material; None if it has neither."""
    kept = Element("material", {"name": material.get("name", "")} if material.get("name") else {})
    colour = material.find("color")
    words = "" if colour is None else colour.get("rgba", "")
    if rgba := parse_numbers(words, 4) or (parse_numbers(words, 3) and [*parse_numbers(words, 3), 1.0]):
        SubElement(kept, "color", rgba=format_numbers([min(max(channel, 0.0), 1.0) for channel in rgba]))
    return kept if len(kept) or kept.attrib else None
