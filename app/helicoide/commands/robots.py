"""Every robot there is: joints, limits, where it comes from, and how well its roads agree."""

from __future__ import annotations

import json as json_format
from typing import Annotated, Any

import numpy as np
import tyro

from helicoide import content
from helicoide.kinematics.chain import Joint
from helicoide.kinematics.forward import disagreement
from helicoide.kinematics.library import load, packaged
from helicoide.kinematics.robot import Robot

POSTURES = 100


def described(robot: Robot) -> dict[str, Any]:
    """What is said of a robot; limits in rad and m; the largest disagreement of its roads over random postures."""
    random = np.random.default_rng(0)
    postures = random.uniform(robot.lower, robot.upper, (POSTURES, len(robot.variables)))
    return {
        "name": robot.name,
        "title": robot.title.en,
        "source": robot.source,
        "ours": list(robot.ours),
        "reach": robot.reach,
        "disagreement": max(disagreement(robot, q) for q in postures),
        "joints": [
            {"name": joint.name, "kind": joint.kind, "lower": joint.lower, "upper": joint.upper, "speed": joint.speed}
            for joint in robot.variables
        ],
    }


def run(
    names: Annotated[
        tyro.conf.Positional[tuple[str, ...]], tyro.conf.arg(help="robots to describe; all that have a folder if none")
    ] = (),
    json: bool = False,
) -> None:
    """List the robots: joints, types, limits, source, and the largest disagreement of the three roads (m).

    Args:
        names: names of robots or paths of URDF files.
        json: print JSON (SI units).
    """
    robots = [load(name) for name in names or sorted(content.found("robots"))]
    if json:
        print(json_format.dumps([described(robot) for robot in robots], indent=1))
        return
    for robot in robots:
        table = described(robot)
        print(f"{robot.name}: {robot.title.en}; {len(robot.variables)} joints; reach {robot.reach:.3f} m")
        print("   " + ", ".join(map(_limits, robot.variables)))
        ours = f" (ours: {', '.join(robot.ours)})" if robot.ours else ""
        print(f"   from {robot.source}{ours}")
        print(f"   the roads agree to {table['disagreement']:.1e} over {POSTURES} random postures")
    if not names:
        print(f"by name from installed packages: {', '.join(sorted(packaged())) or 'none'}")


def _limits(joint: Joint) -> str:
    scale, unit = (1000.0, " mm") if joint.slides else (180 / np.pi, "°")
    return f"{joint.name} {scale * joint.lower:.0f}…{scale * joint.upper:.0f}{unit}"
