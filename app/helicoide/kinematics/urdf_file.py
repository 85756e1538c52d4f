"""Reading a URDF file, and refusing a broken one with what is wrong and where."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from string import Template
from types import MappingProxyType
from xml.etree import ElementTree

import yourdfpy

from helicoide.files import written
from helicoide.text import HelicoideError, Text

MOST_BYTES = 20_000_000
_PLAIN: Mapping[str, float] = MappingProxyType({})
_KINDS = {"link": Text(en="link", pt_BR="elo"), "joint": Text(en="joint", pt_BR="junta")}
_NUMBERS = {"xyz": 3, "rpy": 3, "lower": 1, "upper": 1, "velocity": 1, "multiplier": 1, "offset": 1}
_SHAPES = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}
_SIZES = {"size": 3, "radius": 1, "length": 1}


def broken(path: Path, reason: Text | str) -> HelicoideError:
    """The error of a URDF that cannot be used."""
    return HelicoideError(
        Text(en="The URDF {path} cannot be used: {reason}", pt_BR="Não dá para usar o URDF {path}: {reason}").format(
            path=path, reason=reason
        )
    )


def parsed(path: Path, parameters: Mapping[str, float] = _PLAIN, meshes: bool = False) -> yourdfpy.URDF:
    """The URDF with ${name} replaced by parameters (m), with its meshes if asked.

    Raises HelicoideError when it cannot be read, is no tree, has a number that is not finite, or misses a mesh.
    """
    try:
        text = Template(_text(path)).safe_substitute(parameters)
        _check_elements(path, ElementTree.fromstring(text))  # yourdfpy tries to mend what is broken
        urdf = _loaded(path, text, meshes=False)
        _check_tree(path, urdf.robot)
        if not meshes:
            return urdf
        _check_meshes(path, urdf.robot)
        return _loaded(path, text, meshes=True)
    except HelicoideError:
        raise
    except ElementTree.ParseError as error:
        line, column = error.position
        place = Text(
            en="line {line}, column {column} is no XML, of which a URDF is made",
            pt_BR="a linha {line}, coluna {column} não é XML, de que um URDF é feito",
        )
        raise broken(path, place.format(line=line, column=column + 1)) from error
    except Exception as error:  # yourdfpy and lxml raise whatever a broken file makes them stumble over
        raise broken(path, str(error).splitlines()[0] if str(error) else type(error).__name__) from error


def _text(path: Path) -> str:
    try:
        words = written.text(path, MOST_BYTES)
    except HelicoideError as error:
        raise broken(path, error.text) from error
    if not words.strip():
        raise broken(path, Text(en="it is empty", pt_BR="está vazio"))
    return words


def _loaded(path: Path, text: str, meshes: bool) -> yourdfpy.URDF:
    return yourdfpy.URDF.load(
        io.BytesIO(text.encode()),
        load_meshes=meshes,
        build_scene_graph=meshes,
        filename_handler=mesh_file(path),
    )


def mesh_file(path: Path) -> Callable[[str], str]:
    """Where the mesh files that a URDF names lie: seen from it, or for package:// in or as a folder above it."""
    return partial(_mesh_file, path.absolute().parent)


def _mesh_file(folder: Path, fname: str) -> str:
    scheme, _, inside = fname.rpartition("://")
    if scheme != "package":
        return str(folder / inside)
    places = (above / way for above in (folder, *folder.parents) for way in (inside, inside.partition("/")[2]))
    return str(next((place for place in places if place.is_file()), fname))


def _check_elements(path: Path, root: ElementTree.Element) -> None:
    """Refuse what is no URDF, names that are missing or there twice, and what is wrong in a link or a joint."""
    if root.tag != "robot":
        raise broken(
            path, Text(en=f"it starts with {root.tag!r}, not 'robot'", pt_BR=f"começa com {root.tag!r}, não 'robot'")
        )
    if any("xacro" in element.tag for element in root.iter()):
        raise broken(
            path, Text(en="it is xacro; make a URDF of it with xacro", pt_BR="é xacro; gere um URDF com o xacro")
        )
    if root.find("link") is None:
        raise broken(path, Text(en="it has no links", pt_BR="não tem elos"))
    if not root.get("name"):
        raise broken(path, Text(en="its robot has no name", pt_BR="o robot dele não tem nome"))
    known = set[tuple[str, str]]()
    for part in (part for part in root if part.tag in _KINDS):
        which = (part.tag, part.get("name", ""))
        if not which[1] or which in known:
            raise broken(path, _of(part, "needs a name of its own", "precisa de um nome só seu"))
        known.add(which)
        _check_part(path, part)
        _check_sizes(path, part)


def _of(part: ElementTree.Element, en: str, pt_BR: str) -> Text:
    kind, name = _KINDS[part.tag], part.get("name", "")
    return Text(en=f"{kind.en} {name!r} {en}", pt_BR=f"{kind.pt_BR} {name!r} {pt_BR}")


def _check_part(path: Path, part: ElementTree.Element) -> None:
    for end in ("parent", "child") if part.tag == "joint" else ():
        if (element := part.find(end)) is None or not element.get("link"):
            raise broken(path, _of(part, f"has no {end} link", f"não tem o elo {end}"))
    for element in part.iter():
        for attribute, count in (_NUMBERS | _SIZES).items():
            if not _are_numbers(words := element.get(attribute, "0 " * count), count):
                given = f'{element.tag} {attribute}="{words}"'
                raise broken(
                    path,
                    _of(
                        part, f"has {given}: give finite numbers, {count}", f"tem {given}: dê números finitos, {count}"
                    ),
                )


def _check_sizes(path: Path, part: ElementTree.Element) -> None:
    """A box, a cylinder or a sphere has each of its sizes, and none is zero or less."""
    for element in part.iter():
        for attribute in _SHAPES.get(element.tag, ()):
            sizes = [float(word) for word in element.get(attribute, "").split()]
            if not sizes or min(sizes) <= 0:
                given = f'{element.tag} {attribute}="{element.get(attribute, "")}"'
                raise broken(
                    path, _of(part, f"has {given}: give positive metres", f"tem {given}: dê metros maiores que zero")
                )


def _are_numbers(words: str, count: int) -> bool:
    try:
        values = list(map(float, words.split()))
    except ValueError:
        return False
    return len(values) == count and all(map(math.isfinite, values))


def _check_tree(path: Path, robot: yourdfpy.Robot) -> None:
    """Refuse unknown links, links with two parents, cycles, and several roots."""
    links, parents = {link.name for link in robot.links}, dict[str, str]()
    for joint in robot.joints:
        for name in (joint.parent, joint.child):
            if name not in links:
                en, pt_BR = (
                    "joint {!r} names link {!r}, which is not there",
                    "a junta {!r} cita o elo {!r}, que não existe",
                )
                raise broken(path, Text(en=en.format(joint.name, name), pt_BR=pt_BR.format(joint.name, name)))
        if joint.child in parents:
            two = f"{joint.child!r}: {parents[joint.child]!r}, {joint.parent!r}"
            raise broken(path, Text(en=f"two parents of link {two}", pt_BR=f"dois pais do elo {two}"))
        parents[joint.child] = joint.parent
    roots = [link.name for link in robot.links if link.name not in parents]
    if len(roots) > 1:
        several = ", ".join(roots)
        raise broken(path, Text(en=f"it has several roots: {several}", pt_BR=f"tem várias raízes: {several}"))
    _check_cycles(path, parents, set(roots))


def _check_cycles(path: Path, parents: Mapping[str, str], sound: set[str]) -> None:
    """Refuse links whose way up ends in none that is sound."""
    for name in parents:
        way = [name]
        while way[-1] not in sound:
            above = parents[way[-1]]
            if above in way:
                circle = " → ".join([*way[way.index(above) :], above])
                raise broken(
                    path, Text(en=f"the links go in a circle: {circle}", pt_BR=f"os elos formam um ciclo: {circle}")
                )
            way.append(above)
        sound.update(way)


def _check_meshes(path: Path, robot: yourdfpy.Robot) -> None:
    for link in robot.links:
        for mesh in (visual.geometry.mesh for visual in link.visuals if visual.geometry.mesh):
            if not Path(mesh_file(path)(mesh.filename)).is_file():
                which = f"{link.name!r}: {mesh.filename}"
                raise broken(path, Text(en=f"no mesh for link {which}", pt_BR=f"falta a malha do elo {which}"))
