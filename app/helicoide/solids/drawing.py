"""A machine drawn part by part, in millimetres: its solids by surface, and its GLB files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from trimesh import Trimesh
from trimesh.visual.material import PBRMaterial

from helicoide import solids as cad

MILLIMETRE = 0.001
Parts = dict[str, list[Trimesh]]


def both(solid: Trimesh) -> list[Trimesh]:
    """The part and its mirror image on the other side of the arm."""
    return [solid, cad.mirrored(solid)]


def merged(surfaces: Iterable[str], *parts: Parts) -> Parts:
    """The solids of several drawings by surface, in the order of the surfaces."""
    together = {name: [solid for part in parts for solid in part.get(name, [])] for name in surfaces}
    return {name: solids for name, solids in together.items() if solids}


def painted(drawings: Iterable[Callable[[], Parts]], surfaces: Mapping[str, PBRMaterial]) -> dict[str, bytes]:
    """The GLB of every drawing, by file name."""
    parts = {
        drawing.__name__: {name: (surfaces[name], solids) for name, solids in drawing().items()} for drawing in drawings
    }
    return {f"{name}.glb": cad.glb(part, MILLIMETRE) for name, part in parts.items()}


def write_meshes(build: str, files: Mapping[str, bytes]) -> None:
    """Write the files into meshes/, beside the build.py at that path."""
    folder = Path(build).parent / "meshes"
    folder.mkdir(exist_ok=True)
    for name, data in files.items():
        (folder / name).write_bytes(data)
