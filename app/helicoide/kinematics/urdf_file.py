"""Reading a URDF file, and refusing a broken one with what is wrong and where."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from string import Template
from types import MappingProxyType
from xml.etree import ElementTree

import numpy as np
import yourdfpy

from helicoide.text import HelicoideError, Text

_PLAIN: Mapping[str, float] = MappingProxyType({})


def broken(path: Path, reason: str) -> HelicoideError:
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
        text = Template(path.read_text(encoding="utf-8")).safe_substitute(parameters)
        ElementTree.fromstring(text)  # says where; yourdfpy tries to mend what is broken
        urdf = _loaded(path, text, meshes=False)
        _check_tree(path, urdf.robot)
        _check_numbers(path, urdf.robot)
        if not meshes:
            return urdf
        _check_meshes(path, urdf.robot)
        return _loaded(path, text, meshes=True)
    except HelicoideError:
        raise
    except Exception as error:  # yourdfpy and lxml raise whatever a broken file makes them stumble over
        raise broken(path, str(error).splitlines()[0] if str(error) else type(error).__name__) from error


def _loaded(path: Path, text: str, meshes: bool) -> yourdfpy.URDF:
    return yourdfpy.URDF.load(
        io.BytesIO(text.encode()),
        load_meshes=meshes,
        build_scene_graph=meshes,
        filename_handler=mesh_file(path),
    )


def mesh_file(path: Path) -> Callable[[str], str]:
    """Where the mesh files that a URDF names lie: beside it, or for package:// in one of the folders above it."""
    return partial(yourdfpy.filename_handler_magic, dir=str(path.parent))


def _check_tree(path: Path, robot: yourdfpy.Robot) -> None:
    """Refuse unknown links, links with two parents, cycles, and several roots."""
    links, parents = {link.name for link in robot.links}, dict[str, str]()
    for joint in robot.joints:
        for name in (joint.parent, joint.child):
            if name not in links:
                raise broken(path, f"joint {joint.name!r} names link {name!r}, which is not there")
        if joint.child in parents:
            raise broken(path, f"link {joint.child!r} has two parents: {parents[joint.child]!r} and {joint.parent!r}")
        parents[joint.child] = joint.parent
    roots = [link.name for link in robot.links if link.name not in parents]
    if len(roots) > 1:
        raise broken(path, f"it has several roots: {', '.join(roots)}")
    for name in parents:
        seen = [name]
        while seen[-1] in parents:
            seen.append(parents[seen[-1]])
            if seen[-1] in seen[:-1]:
                raise broken(path, f"the links go in a circle: {' → '.join(seen[seen.index(seen[-1]) :])}")


def _check_numbers(path: Path, robot: yourdfpy.Robot) -> None:
    for joint in robot.joints:
        for what, value in (("origin", joint.origin), ("axis", joint.axis), ("limit", _limits(joint))):
            if value is not None and not np.isfinite(np.asarray(value, dtype=float)).all():
                raise broken(path, f"the {what} of joint {joint.name!r} is not a finite number")


def _limits(joint: yourdfpy.Joint) -> list[float]:
    limit = joint.limit
    return [] if limit is None else [v for v in (limit.lower, limit.upper, limit.velocity) if v is not None]


def _check_meshes(path: Path, robot: yourdfpy.Robot) -> None:
    for link in robot.links:
        for visual in link.visuals:
            mesh = visual.geometry.mesh
            if mesh and not Path(file := mesh_file(path)(mesh.filename)).is_file():
                raise broken(path, f"link {link.name!r} misses its mesh {mesh.filename} ({file})")
