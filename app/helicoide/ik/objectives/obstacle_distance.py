"""Distance from a point: the point of the arm that is nearest to the obstacle moves away from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.arm_points import PER_LINK, WATCHED, coordinate, watched
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="distance to an obstacle point", pt_BR="distância a um ponto de obstáculo")
SOURCE = "Cerbaro 2022, eq. 13"
EQUATION = r"f = -\min_p \|p(q) - o\|"
AUGMENTS = False


@dataclass(frozen=True)
class Options:
    """x, y, z: the obstacle o, ℓ, base frame; where: which points p of the arm count; per_link: how many per link."""

    x: Annotated[float, coordinate("x")] = 0.5
    y: Annotated[float, coordinate("y")] = 0.3
    z: Annotated[float, coordinate("z")] = 0.5
    where: Annotated[str, WATCHED] = "guarded"
    per_link: Annotated[int, PER_LINK] = 8


def applies(robot: Robot) -> Text | None:
    """Applies to every robot."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = −‖p − o‖ of the nearest p; ∂f/∂q = −uᵀ J_p, u = (p − o)/‖p − o‖, and 0 where p = o."""
    points, J = watched(problem.robot, options.where, round(options.per_link)).moving(problem, posture.poses)
    offsets = points - (options.x, options.y, options.z)
    distances = np.linalg.norm(offsets, axis=1)
    nearest = int(np.argmin(distances))
    distance = float(distances[nearest])
    away = offsets[nearest] / distance if distance > 0 else np.zeros(3)
    return Cost(-distance, -away @ J[nearest])
