"""Reading a URDF file, with errors that say what is wrong and where."""

from __future__ import annotations

import io
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import yourdfpy

from helicoide.kinematics.urdf_check import check_parts, check_tree
from helicoide.kinematics.urdf_clean import cleaned
from helicoide.kinematics.urdf_mend import MOVING, mend
from helicoide.kinematics.urdf_mesh import mesh_file, without_meshes
from helicoide.kinematics.urdf_xml import PLAIN, broken, tree
from helicoide.text import Text, joined, same

LOOSE = Text(
    en="links that no joint holds are left out: {names}", pt_BR="elos que nenhuma junta segura ficam de fora: {names}"
)
HELD = Text(
    en="joints whose lower limit is their upper one are fixed: {names}",
    pt_BR="juntas cujo limite inferior é igual ao superior ficam fixas: {names}",
)
NOT_UNDERSTOOD = Text(en="it cannot be understood as a URDF", pt_BR="não dá para entendê-lo como URDF")
MOST_SAID = 3
NOT_DRAWN = Text(en="not drawn: {listed}{more}", pt_BR="não desenhado: {listed}{more}")
NOT_DRAWN_OF = Text(en="of link {link}, {why}", pt_BR="do elo {link}, {why}")
MORE = Text(en="; and {n} more", pt_BR="; e mais {n}")


@dataclass(frozen=True, eq=False)
class Reading:
    """The links and joints of a URDF, remarks on omitted parts, and links with undrawn visuals and the reasons.

    held: the joints that are fixed because their lower and upper limits are equal.
    """

    robot: yourdfpy.Robot
    remarks: tuple[Text, ...]
    not_drawn: tuple[tuple[str, Text], ...]
    held: tuple[str, ...]


def read(path: Path, parameters: Mapping[str, float] = PLAIN) -> Reading:
    """Read a URDF, with ${name} replaced by parameters (m).

    Raises HelicoideError if it cannot be read, is not a tree, or has a number that is not finite.
    """
    root = tree(path, parameters)
    check_parts(path, root)
    clean, undrawn = cleaned(root, path.stem)
    clean_bytes = io.BytesIO(ElementTree.tostring(clean))
    try:
        robot = yourdfpy.URDF.load(clean_bytes, load_meshes=False, build_scene_graph=False).robot
    except Exception as error:  # yourdfpy and lxml may raise anything; common errors were checked before
        raise broken(path, NOT_UNDERSTOOD) from error
    loose = _without_loose_links(robot)
    check_tree(path, robot)
    held = mend(robot)
    remarks = [text.format(names=", ".join(names)) for text, names in ((LOOSE, loose), (HELD, held)) if names]
    return Reading(robot, tuple(remarks), tuple(undrawn), tuple(held))


def parsed(path: Path, parameters: Mapping[str, float] = PLAIN, meshes: bool = False) -> yourdfpy.URDF:
    """The URDF with ${name} replaced by parameters (m), with or without its meshes. Raises as `read`."""
    robot = read(path, parameters).robot
    if not meshes:
        return yourdfpy.URDF(robot, build_scene_graph=False, load_meshes=False)
    return with_meshes(path, robot)


def not_drawn(path: Path, parameters: Mapping[str, float] = PLAIN) -> Text | None:
    """A sentence on links that cannot be drawn, with the reasons; None if all can be drawn. Reads the meshes.

    Raises as `read`.
    """
    reading = read(path, parameters)
    missing = [*reading.not_drawn, *without_meshes(path, reading.robot)]
    if not missing:
        return None
    said = [NOT_DRAWN_OF.format(link=link, why=why) for link, why in missing[:MOST_SAID]]
    more = MORE.format(n=len(missing) - MOST_SAID) if len(missing) > MOST_SAID else same("")
    return NOT_DRAWN.format(listed=joined(said), more=more)


def with_meshes(path: Path, robot: yourdfpy.Robot) -> yourdfpy.URDF:
    """The URDF with its scene and all readable meshes. In `robot`, fixes unusable joints and removes bad meshes."""
    for joint in robot.joints:  # outside the arm there may be joints that the scene cannot handle
        if joint.type not in MOVING or not np.any(joint.axis):
            joint.type, joint.mimic = "fixed", None
    leaders = {joint.name for joint in robot.joints if joint.mimic is None and joint.type != "fixed"}
    for joint in robot.joints:
        if joint.mimic is not None and joint.mimic.joint not in leaders:
            joint.mimic = None
    without_meshes(path, robot)  # one unreadable mesh would make loading fail
    return yourdfpy.URDF(robot, build_scene_graph=True, load_meshes=True, filename_handler=mesh_file(path))


def root_of(robot: yourdfpy.Robot) -> str:
    """The root link, which is no joint's child."""
    children = {joint.child for joint in robot.joints}
    return next(str(link.name) for link in robot.links if link.name not in children)


def _without_loose_links(robot: yourdfpy.Robot) -> list[str]:
    """Remove the links that no joint names, unless there are no others; returns their names."""
    held = {name for joint in robot.joints for name in (joint.parent, joint.child)}
    loose = [str(link.name) for link in robot.links if link.name not in held] if held else []
    robot.links = [link for link in robot.links if link.name not in loose]
    return loose
