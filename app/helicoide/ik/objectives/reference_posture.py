"""A reference posture: the joints stay as near to it as the task allows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="reference posture", pt_BR="postura de referência")
SOURCE = "Siciliano et al. 2009, Robotics, §3.5 (a distance in the joint space as the objective)"
EQUATION = r"f = \tfrac12 \|q - q_{ref}\|^2"
AUGMENTS = False


@dataclass(frozen=True)
class Options:
    """reference: q_ref (n,), rad or m; None for the `ready` posture of the robot."""

    reference: tuple[float, ...] | None = None


def applies(robot: Robot) -> Text | None:
    """Applies to every robot."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = ½ ‖q − q_ref‖², ∂f/∂q = q − q_ref. Rotations in rad, displacements of sliding joints divided by ℓ."""
    given = options.reference
    reference = problem.robot.poses["ready"] if given is None else np.array(given)
    off = (posture.q - reference) / problem.joint_units
    return Cost(float(off @ off) / 2, off)
