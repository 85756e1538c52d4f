"""List robots: joints, limits, source, and how well the three formulations agree."""

from __future__ import annotations

import json as json_format
from typing import Annotated, Any

import numpy as np
import tyro

from helicoide import content
from helicoide.commands import chain_ends, chain_ends_json, language, print_remarks
from helicoide.kinematics.chain import JointVariable
from helicoide.kinematics.forward import formulation_difference
from helicoide.kinematics.library import load_robot, packaged_urdfs
from helicoide.kinematics.robot import Robot
from helicoide.readout import WHY_PRINTED_DIFFERS, printed_planes
from helicoide.text import Language, Text

POSTURES = 100
HEAD = Text(
    en="{name}: {title}; {n} joints; reach {reach:.3f} m", pt_BR="{name}: {title}; {n} juntas; alcance {reach:.3f} m"
)
SOURCE = Text(en="   from {source}{assumed}", pt_BR="   de {source}{assumed}")
ASSUMED = Text(en=" (assumed: {fields})", pt_BR=" (adotados: {fields})")
ASSUMED_HERE = Text(en=" (assumed)", pt_BR=" (adotado)")
AGREEMENT = Text(
    en="   the formulations agree to {error:.1e} over {n} random postures",
    pt_BR="   as três formulações diferem no máximo em {error:.1e}, em {n} posturas aleatórias",
)
PACKAGED = Text(en="by name from installed packages: {names}", pt_BR="pelo nome, de pacotes instalados: {names}")
NONE = Text(en="none", pt_BR="nenhum")


def robot_json(robot: Robot) -> dict[str, Any]:
    """A robot as JSON; limits in rad or m; disagreement: the largest between formulations, over random postures."""
    random = np.random.default_rng(0)
    postures = random.uniform(robot.lower, robot.upper, (POSTURES, len(robot.variables)))
    return {
        "name": robot.name,
        "title": robot.title.en,
        "source": robot.source,
        **chain_ends_json(robot, with_visuals=True),
        "assumed": list(robot.assumed),
        "reach": robot.stretched_length,
        "disagreement": max(formulation_difference(robot, q) for q in postures),
        "planes": [
            {"name": pane.name, "normal": [*pane.normal], "offset": pane.offset, "printed": pane.as_printed or None}
            for pane in robot.panes
        ],
        "joints": [
            {
                "name": joint.name,
                "kind": joint.kind,
                "lower": joint.lower,
                "upper": joint.upper,
                "speed": joint.speed,
                "assumed": joint.assumed,
            }
            for joint in robot.variables
        ],
    }


def run(
    names: Annotated[
        tyro.conf.Positional[tuple[str, ...]], tyro.conf.arg(help="robots to describe; all that have a folder if none")
    ] = (),
    tip: str | None = None,
    base: str | None = None,
    json: bool = False,
) -> None:
    """List the robots: joints, types, limits, source, and the largest disagreement of the three formulations (m).

    Args:
        names: names of robots or paths of URDF files.
        tip: the link of the URDF files where the arm ends.
        base: the link of the URDF files where the arm begins; the root if none.
        json: print JSON (SI units).
    """
    robots = [load_robot(name, tip, (), base) for name in names or sorted(content.content_folders("robots"))]
    if json:
        print(json_format.dumps([robot_json(robot) for robot in robots], indent=1))
        return
    spoken = language()
    for robot in robots:
        print_remarks(robot, with_visuals=True)
        print("\n".join(_lines(robot, spoken)))
    if not names:
        print(PACKAGED.format(names=", ".join(sorted(packaged_urdfs())) or NONE)[spoken])


def _lines(robot: Robot, spoken: Language) -> list[str]:
    """The description of a robot as lines of text."""
    head = HEAD.format(name=robot.name, title=robot.title, n=len(robot.variables), reach=robot.stretched_length)
    assumed = ASSUMED.format(fields=", ".join(robot.assumed)) if robot.assumed else ""
    planes = printed_planes(robot)
    agreement = AGREEMENT.format(error=robot_json(robot)["disagreement"], n=POSTURES)
    return [
        head[spoken],
        chain_ends(robot)[spoken],
        "   " + ", ".join(map(_limits, robot.variables)),
        SOURCE.format(source=robot.source, assumed=assumed)[spoken],
        agreement[spoken],
        *(f"   {line[spoken]}" for line in (*planes, *([WHY_PRINTED_DIFFERS] if planes else []))),
    ]


def _limits(joint: JointVariable) -> str:
    scale, unit = (1000.0, " mm") if joint.is_prismatic else (180 / np.pi, "°")
    assumed = ASSUMED_HERE[language()] if joint.assumed else ""
    return f"{joint.name} {scale * joint.lower:.0f}…{scale * joint.upper:.0f}{unit}{assumed}"
