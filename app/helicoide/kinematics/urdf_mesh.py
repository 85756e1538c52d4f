"""Where the mesh files of a URDF lie, and which of them can be drawn."""

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
    """Where the mesh files that a URDF names lie: seen from it, or for package:// in or as a folder above it."""
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
    """The file of that name, be its suffix in capitals or not; None where there is none."""
    try:
        names = (place, *(place.with_suffix(way(place.suffix)) for way in (str.lower, str.upper) if place.suffix))
        return next((name for name in names if name.is_file()), None)
    except (OSError, ValueError):  # names that no file can have
        return None


def remove_unreadable_meshes(path: Path, robot: yourdfpy.Robot) -> list[tuple[str, Text]]:
    """Take away the meshes of which nothing can be drawn; returns of which links, and why."""
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
    """Why there is nothing to be drawn in a file, which was changed last at that time, ns; None where there is."""
    try:
        scene = trimesh.load_scene(file, ignore_broken=True)
    except Exception:  # readers raise whatever a broken file makes them stumble over
        return BROKEN_MESH
    surfaces = (mesh for mesh in scene.geometry.values() if isinstance(mesh, trimesh.Trimesh))
    return None if any(mesh.area > 0 for mesh in surfaces) else EMPTY_MESH
