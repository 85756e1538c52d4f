"""Faults of a robot: contradictions of its files, links that are not drawn, and the content of its folder."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType

import numpy as np
import trimesh

from helicoide import content
from helicoide.contributions.loading import where_raised
from helicoide.contributions.words import missing_words
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_faults import remarks_and_faults
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.text import LANGUAGES, HelicoideError, Text, untranslated

HEAVIEST = 1_000_000
SAME_TITLE = Text(en="robot {other} has the same title", pt_BR="o robô {other} tem o mesmo título")
HEAVY = Text(
    en="its folder holds {kb:.0f} kB, at most {most:.0f}", pt_BR="a pasta tem {kb:.0f} kB, no máximo {most:.0f}"
)
LEFT_OVER = Text(en="meshes that the URDF does not name: {names}", pt_BR="malhas que o URDF não cita: {names}")
NORMALS = Text(
    en="the normals of mesh {file} are not of unit length", pt_BR="as normais da malha {file} não têm comprimento um"
)
NOT_DRAWN = Text(
    en="build.py draws other meshes than those in meshes/: {names}; run it again and keep what it writes",
    pt_BR="build.py desenha malhas diferentes das de meshes/: {names}; execute-o de novo e guarde o que ele grava",
)


def faults(name: str) -> tuple[Text, ...]:
    """The faults of a robot, by the name of its folder."""
    folder = content.content_folder("robots", name)
    try:
        robot = robot_from_folder(folder)
        return (*_titles(robot), *remarks_and_faults(robot), *_folder(folder, robot), *_drawing(folder))
    except HelicoideError as error:
        return (error.text,)


def _titles(robot: Robot) -> Iterator[Text]:
    yield from missing_words(untranslated("title"), robot.title)
    for title in (*robot.pose_titles.values(), *(joint.title for joint in robot.joints)):
        yield from missing_words(untranslated("title"), title)
    for folder in content.content_folders("robots").values():
        if folder.name != robot.name and _alike(_title_of(folder), robot.title):
            yield SAME_TITLE.format(other=folder.name)


def _title_of(folder: Path) -> Text:
    try:
        return robot_from_folder(folder).title
    except HelicoideError:  # the fault of another robot, which its own check reports
        return untranslated("")


def _alike(one: Text, other: Text) -> bool:
    return any(one[language].strip() == other[language].strip() for language in LANGUAGES)


def _folder(folder: Path, robot: Robot) -> Iterator[Text]:
    files = [file for file in folder.rglob("*") if file.is_file() and file.suffix != ".pyc"]
    if (size := sum(file.stat().st_size for file in files)) >= HEAVIEST:
        yield HEAVY.format(kb=size / 1000, most=HEAVIEST / 1000)
    urdf = robot.urdf.read_text("utf-8")
    meshes = sorted(file for file in (folder / "meshes").glob("*") if file.is_file())
    if names := [file.name for file in meshes if not re.search(rf"meshes/{re.escape(file.name)}\b", urdf)]:
        yield LEFT_OVER.format(names=", ".join(names))
    for file in meshes:
        lengths = [np.linalg.norm(part.vertex_normals, axis=1) for part in surfaces(file.read_bytes(), file.suffix)]
        if not all(np.allclose(length, 1, atol=1e-5) for length in lengths):
            yield NORMALS.format(file=file.name)


def _drawing(folder: Path) -> Iterator[Text]:
    """The faults of build.py, if there is one: it must make the files in meshes/, and the same each time."""
    if not (folder / "build.py").is_file():
        return
    committed = {file.name: file.read_bytes() for file in (folder / "meshes").glob("*")}
    try:
        build = ModuleType(f"{folder.name}_build")
        SourceFileLoader(build.__name__, str(folder / "build.py")).exec_module(build)
        drawn, again = build.files(), build.files()
    except Exception as error:  # any error of a contributed file is a fault
        yield where_raised(folder / "build.py", error)
        return
    names = sorted(committed.keys() | drawn.keys())
    other = [name for name in names if not _same_surfaces(committed.get(name, b""), drawn.get(name, b""))]
    other += [name for name in drawn if drawn[name] != again.get(name)]
    if other:
        yield NOT_DRAWN.format(names=", ".join(dict.fromkeys(other)))


def _same_surfaces(committed: bytes, drawn: bytes) -> bool:
    """Whether two meshes have the same surfaces; other versions of packages may write other bytes."""
    if not (committed and drawn):
        return False
    pairs = [*zip(surfaces(committed, ".glb"), surfaces(drawn, ".glb"), strict=False)]
    return len(surfaces(committed, ".glb")) == len(surfaces(drawn, ".glb")) and all(
        np.array_equal(one.faces, other.faces) and np.allclose(one.vertices, other.vertices, atol=1e-6)
        for one, other in pairs
    )


def surfaces(data: bytes, suffix: str) -> list[trimesh.Trimesh]:
    """The surfaces in a mesh file."""
    scene = trimesh.load_scene(io.BytesIO(data), file_type=suffix.lstrip("."))
    return [part for part in scene.geometry.values() if isinstance(part, trimesh.Trimesh)]
