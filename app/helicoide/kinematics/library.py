"""All robots by name: shipped ones, the user's, those of installed packages, and any URDF file."""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import cache, lru_cache
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from helicoide import content
from helicoide.kinematics.robot import Robot
from helicoide.kinematics.robot_folder import robot_from_folder
from helicoide.text import HelicoideError, Text

log = logging.getLogger("helicoide")

PACKAGES = ("example-robot-data", "rtb-data")


@cache
def packaged_urdfs() -> Mapping[str, Path]:
    """The URDF files of installed packages by name, such as "panda"; the first package wins."""
    found: dict[str, Path] = {}
    for file in (file for package in PACKAGES for file in _files(package)):
        found.setdefault(_name_of(file), file)
    return found


def _name_of(file: Path) -> str:
    return file.stem.removesuffix("_robot")


def _from_package(name: str, tip: str | None, base: str | None) -> Robot:
    """The robot of the first usable file of that name; if none is usable, raises the error of the first."""
    first = packaged_urdfs()[name]
    try:
        return _of_package(first, tip, base)
    except HelicoideError:
        every = (file for package in PACKAGES for file in _files(package))
        for file in (file for file in every if _name_of(file) == name and file != first):
            with suppress(HelicoideError):
                return _of_package(file, tip, base)
        raise


@lru_cache(maxsize=32)
def _of_package(file: Path, tip: str | None, base: str | None) -> Robot:
    return _from_urdf(file, tip, base)


def _from_urdf(file: Path, tip: str | None, base: str | None) -> Robot:
    """A robot from a URDF. Imports the reader here, as it takes as long to import as all else that `fk` needs."""
    from helicoide.kinematics.urdf_chain import robot_from_urdf

    return robot_from_urdf(file, tip, base)


def _files(package: str) -> list[Path]:
    """The URDF files of a package; empty if it is not installed."""
    try:
        files = distribution(package).files or []
    except PackageNotFoundError:
        return []
    return sorted(Path(str(file.locate())) for file in files if file.suffix == ".urdf")


def robot_names() -> list[str]:
    """Names of all robots: those in folders, then those of packages."""
    folders = content.content_folders("robots")
    return [*sorted(folders), *sorted(set(packaged_urdfs()) - set(folders))]


_registered: dict[str, Robot] = {}


def register_robot(robot: Robot) -> None:
    """Register a robot from a file, or one with changed parameters, under its name while the program runs."""
    _registered[robot.name] = robot


def robot_titles() -> dict[str, Text]:
    """Titles by name of the robots with a folder and of registered ones; the name is added to a title used twice."""
    found = {**_titles_of_folders(), **{name: robot.title for name, robot in _registered.items()}}
    shown = [title.en for title in found.values()]
    double = Text(en="{title} ({name})", pt_BR="{title} ({name})")
    return {
        name: title if shown.count(title.en) == 1 else double.format(title=title, name=name)
        for name, title in found.items()
    }


@cache
def _titles_of_folders() -> Mapping[str, Text]:
    """The titles of the robots that have a folder; broken ones are left out, and the log says so."""
    found: dict[str, Text] = {}
    for name, folder in sorted(content.content_folders("robots").items()):
        try:
            found[name] = robot_from_folder(folder).title
        except HelicoideError as error:
            log.warning("%s", error)
    return found


def load_robot(robot: str, tip: str | None = None, settings: Sequence[str] = (), base: str | None = None) -> Robot:
    """A robot by name or by the path of a URDF file.

    tip and base: the links of a URDF where the arm ends and begins; settings: parameters of a robot's file to change,
    mm, such as "l1=1500".
    Raises HelicoideError that lists the names there are, or says what is wrong in a file.
    """
    if robot in _registered and tip is None and base is None and not settings:
        return _registered[robot]
    folders = content.content_folders("robots")
    is_file = robot.lower().endswith((".urdf", ".xml", ".xacro"))
    if is_file or (robot not in folders and robot in packaged_urdfs()):
        _refuse(settings, robot, "--set")
        return _from_urdf(Path(robot), tip, base) if is_file else _from_package(robot, tip, base)
    if robot in folders:
        _refuse(tip, robot, "--tip")
        _refuse(base, robot, "--base")
        folder = folders[robot]
        changed = max(file.stat().st_mtime_ns for file in folder.rglob("*") if file.is_file())
        return _from_folder(folder, tuple(settings), changed)
    raise _unknown(robot)


@lru_cache(maxsize=32)
def _from_folder(folder: Path, settings: tuple[str, ...], changed: int) -> Robot:
    """A robot from its folder, cached while its files do not change, with its cached properties."""
    return robot_from_folder(folder, dict(map(_setting, settings)))


def _setting(words: str) -> tuple[str, float]:
    name, _, value = words.partition("=")
    try:
        return name, float(value)
    except ValueError as error:
        raise HelicoideError(
            Text(
                en="{words!r} sets nothing: write a parameter and millimetres, such as l1=1500.",
                pt_BR="{words!r} não define nada: escreva um parâmetro e milímetros, como l1=1500.",
            ).format(words=words)
        ) from error


def _refuse(given: object, robot: str, option: str) -> None:
    if given:
        raise HelicoideError(
            Text(
                en="{option} does not go with {robot}: --tip and --base are for URDF files, --set for robots with "
                "parameters.",
                pt_BR="{option} não serve para {robot}: --tip e --base são para arquivos URDF, --set para robôs com "
                "parâmetros.",
            ).format(option=option, robot=robot)
        )


def _unknown(robot: str) -> HelicoideError:
    return HelicoideError(
        Text(
            en="There is no robot named {robot!r}; robots: {names}. {more}",
            pt_BR="Não existe robô de nome {robot!r}; robôs: {names}. {more}",
        ).format(robot=robot, names=", ".join(robot_names()), more=_more())
    )


def _more() -> Text:
    """A sentence on how to get more robots: a URDF file, or packages that are not installed."""
    missing = [package for package in PACKAGES if not _files(package)]
    if not missing:
        return Text(en="Or give the path of a URDF file.", pt_BR="Ou dê o caminho de um arquivo URDF.")
    return Text(
        en="Or give the path of a URDF file. More come with: pip install {missing}.",
        pt_BR="Ou dê o caminho de um arquivo URDF. Outros vêm com: pip install {missing}.",
    ).format(missing=" ".join(missing))
