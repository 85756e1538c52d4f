"""Finds the mesh files of a URDF, and removes those that cannot be drawn."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache, partial
from pathlib import Path

import trimesh
import yourdfpy

from helicoide.text import Text

# What other programs write for package://
PACKAGE = re.compile(r"^(?:package://|model://|\$\(find\s+([^)]+)\)/)")
NO_MESH = Text(en="there is no mesh {file}", pt_BR="não há malha {file}")
BROKEN_MESH = Text(en="the mesh {file} cannot be read", pt_BR="não dá para ler a malha {file}")
EMPTY_MESH = Text(en="there is no surface in the mesh {file}", pt_BR="não há superfície na malha {file}")


def mesh_file(path: Path) -> Callable[[str], str]:
    """A function from mesh names in a URDF to paths: relative to the URDF; package:// is searched in folders above."""
    return partial(_mesh_file, path.absolute().parent)


def _mesh_file(folder: Path, fname: str) -> str:
    name = fname.replace("\\", "/")
    package = PACKAGE.match(name)
    inside = name if package is None else f"{package[1] or ''}/{name[package.end() :]}".lstrip("/")
    if package is None:
        inside = inside.rpartition("://")[2]
        return str(_ignoring_case(folder / inside) or folder / inside)
    if ".." in inside.split("/"):
        return fname
    ways = (inside, inside.partition("/")[2].lstrip("/"))
    places = (above / way for above in (folder, *folder.parents) for way in ways if way)
    return str(next((found for place in places if (found := _ignoring_case(place))), fname))


def _ignoring_case(place: Path) -> Path | None:
    """The file of that name, with its suffix in either case; None if there is none."""
    try:
        names = (place, *(place.with_suffix(way(place.suffix)) for way in (str.lower, str.upper) if place.suffix))
        return next((name for name in names if name.is_file()), None)
    except (OSError, ValueError):  # names that no file can have
        return None


def remove_unreadable_meshes(path: Path, robot: yourdfpy.Robot) -> list[tuple[str, Text]]:
    """Remove the meshes that cannot be drawn; returns their links and the reasons."""
    found = list[tuple[str, Text]]()
    for link in robot.links:
        for visual in [visual for visual in link.visuals if visual.geometry.mesh]:
            name = visual.geometry.mesh.filename
            if (why := _why_not(Path(mesh_file(path)(name)))) is not None:
                link.visuals.remove(visual)
                found.append((str(link.name), why.format(file=name)))
    return found


def _why_not(file: Path) -> Text | None:
    there = _ignoring_case(file)
    return NO_MESH if there is None else _read(there, there.stat().st_mtime_ns)


@lru_cache(maxsize=1024)
def _read(file: Path, changed: int) -> Text | None:
    """The reason why a mesh file cannot be drawn, or None; `changed`, its time of change in ns, is for the cache."""
    try:
        scene = trimesh.load_scene(file, ignore_broken=True)
    except Exception:  # readers may raise anything for a broken file
        return BROKEN_MESH
    surfaces = (mesh for mesh in scene.geometry.values() if isinstance(mesh, trimesh.Trimesh))
    return None if any(mesh.area > 0 for mesh in surfaces) else EMPTY_MESH
