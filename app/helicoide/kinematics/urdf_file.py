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
from helicoide.kinematics.urdf_clean import cleaned_urdf
from helicoide.kinematics.urdf_mesh import mesh_file, remove_unreadable_meshes
from helicoide.kinematics.urdf_repair import MOVING, repair_joints
from helicoide.kinematics.urdf_xml import NO_PARAMETERS, parse_xml, urdf_error
from helicoide.text import Text, join_texts, untranslated

UNCONNECTED_LINKS = Text(
    en="links that no joint holds are left out: {names}", pt_BR="elos que nenhuma junta segura ficam de fora: {names}"
)
FIXED_BY_LIMITS = Text(
    en="joints whose lower limit is their upper one are fixed: {names}",
    pt_BR="juntas cujo limite inferior é igual ao superior ficam fixas: {names}",
)
NOT_UNDERSTOOD = Text(en="it cannot be understood as a URDF", pt_BR="não dá para entendê-lo como URDF")
MAX_LISTED = 3
NOT_DRAWN = Text(en="not drawn: {listed}{more}", pt_BR="não desenhado: {listed}{more}")
NOT_DRAWN_OF = Text(en="of link {link}, {why}", pt_BR="do elo {link}, {why}")
MORE = Text(en="; and {n} more", pt_BR="; e mais {n}")


@dataclass(frozen=True, eq=False)
class UrdfReading:
    """What was read from a URDF: the robot, and what was changed or left out.

    robot: links and joints; remarks: sentences on omitted links and on joints that became fixed; not_drawn: each link
    with a visual that is left out, and the reason; fixed_by_limits: names of the joints that became fixed because their
    lower and upper limits are equal.
    """

    robot: yourdfpy.Robot
    remarks: tuple[Text, ...]
    not_drawn: tuple[tuple[str, Text], ...]
    fixed_by_limits: tuple[str, ...]


def read_urdf(path: Path, parameters: Mapping[str, float] = NO_PARAMETERS) -> UrdfReading:
    """Read a URDF, with ${name} replaced by parameters (m).

    Raises HelicoideError if it cannot be read, is not a tree, or has a number that is not finite.
    """
    root = parse_xml(path, parameters)
    check_parts(path, root)
    clean, undrawn = cleaned_urdf(root, path.stem)
    clean_bytes = io.BytesIO(ElementTree.tostring(clean))
    try:
        robot = yourdfpy.URDF.load(clean_bytes, load_meshes=False, build_scene_graph=False).robot
    except Exception as error:  # yourdfpy and lxml may raise anything; common errors were checked before
        raise urdf_error(path, NOT_UNDERSTOOD) from error
    loose = _without_loose_links(robot)
    check_tree(path, robot)
    held = repair_joints(robot)
    remarks = [
        text.format(names=", ".join(names))
        for text, names in ((UNCONNECTED_LINKS, loose), (FIXED_BY_LIMITS, held))
        if names
    ]
    return UrdfReading(robot, tuple(remarks), tuple(undrawn), tuple(held))


def parse_urdf(path: Path, parameters: Mapping[str, float] = NO_PARAMETERS, meshes: bool = False) -> yourdfpy.URDF:
    """The URDF with ${name} replaced by parameters (m), with or without its meshes. Same errors as `read_urdf`."""
    robot = read_urdf(path, parameters).robot
    if not meshes:
        return yourdfpy.URDF(robot, build_scene_graph=False, load_meshes=False)
    return with_meshes(path, robot)


def undrawn_remark(path: Path, parameters: Mapping[str, float] = NO_PARAMETERS) -> Text | None:
    """A sentence that lists visuals that cannot be drawn, at most `MAX_LISTED`, with the reasons; None without any.

    Opens the mesh files. Same errors as `read_urdf`.
    """
    reading = read_urdf(path, parameters)
    missing = [*reading.not_drawn, *remove_unreadable_meshes(path, reading.robot)]
    if not missing:
        return None
    said = [NOT_DRAWN_OF.format(link=link, why=why) for link, why in missing[:MAX_LISTED]]
    more = MORE.format(n=len(missing) - MAX_LISTED) if len(missing) > MAX_LISTED else untranslated("")
    return NOT_DRAWN.format(listed=join_texts(said), more=more)


def with_meshes(path: Path, robot: yourdfpy.Robot) -> yourdfpy.URDF:
    """The URDF with its scene and all readable meshes.

    Changes `robot`: joints that the scene cannot move become fixed, mimic joints that follow no independent joint
    become independent, and unreadable meshes are removed.
    """
    for joint in robot.joints:  # outside the arm there may be joints that the scene cannot handle
        if joint.type not in MOVING or not np.any(joint.axis):
            joint.type, joint.mimic = "fixed", None
    leaders = {joint.name for joint in robot.joints if joint.mimic is None and joint.type != "fixed"}
    for joint in robot.joints:
        if joint.mimic is not None and joint.mimic.joint not in leaders:
            joint.mimic = None
    remove_unreadable_meshes(path, robot)  # one unreadable mesh would make loading fail
    return yourdfpy.URDF(robot, build_scene_graph=True, load_meshes=True, filename_handler=mesh_file(path))


def root_of(robot: yourdfpy.Robot) -> str:
    """The name of the root link: the link that is not the child of any joint."""
    children = {joint.child for joint in robot.joints}
    return next(str(link.name) for link in robot.links if link.name not in children)


def _without_loose_links(robot: yourdfpy.Robot) -> list[str]:
    """Remove the links that no joint connects, and return their names. A robot without joints keeps all links."""
    held = {name for joint in robot.joints for name in (joint.parent, joint.child)}
    loose = [str(link.name) for link in robot.links if link.name not in held] if held else []
    robot.links = [link for link in robot.links if link.name not in loose]
    return loose
