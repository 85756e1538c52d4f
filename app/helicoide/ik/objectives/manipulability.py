"""Manipulability: the arm avoids singular postures, where the tool cannot move in some direction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.method import OneOf
from helicoide.ik.objective import Cost, Posture
from helicoide.kinematics import jacobian
from helicoide.kinematics.generic_rank import counted_rows, generic_rank
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.kinematics.robot import Robot
from helicoide.text import Text

TITLE = Text(en="manipulability", pt_BR="manipulabilidade")
SOURCE = "Cerbaro 2022, eqs. 10–11; Vargas 2013, eq. 3.5; Yoshikawa 1985"
EQUATION = r"f = -w, \quad w = \sqrt{\det(J J^T)} = \sigma_1 \sigma_2 \cdots \sigma_r"
AUGMENTS = False


@dataclass(frozen=True)
class Options:
    """of: whether w is that of the tool's position or of its whole pose."""

    of: Annotated[
        str,
        OneOf(
            Text(en="manipulability of", pt_BR="manipulabilidade de"),
            {
                "position": Text(en="position", pt_BR="posição"),
                "pose": Text(en="position and orientation", pt_BR="posição e orientação"),
            },
        ),
    ] = "position"


def applies(robot: Robot) -> Text | None:
    """Applies to every robot."""
    return None


def cost(problem: Problem, posture: Posture, options: Options) -> Cost:
    """f = −w, ∂w/∂q_k = Σᵢ (Πⱼ≠ᵢ σⱼ) uᵢᵀ (∂J/∂q_k) vᵢ.

    The product has as many factors as the generic rank r of J, so that a planar arm does not count as always singular.
    At a singular posture w is not differentiable; the one-sided gradient given there leads out of it.
    """
    turns = counted_rows(problem.robot, options.of == "pose")[3:].any()
    J, rates = tool_jacobian_and_rates(problem, posture.poses, 6 if turns else 3)
    found, r = analyse_jacobian(J), generic_rank(problem.robot, len(J))
    sigma, U, V = found.sigma[:r], found.U[:, :r], found.V[:, :r]
    others = np.array([np.prod(np.delete(sigma, i)) for i in range(r)])
    return Cost(-float(np.prod(sigma)), -np.einsum("i,ai,abk,bi->k", others, U, rates, V, optimize=True))


def tool_jacobian_and_rates(problem: Problem, poses: Array, rows: int) -> tuple[Array, Array]:
    """The tool's J (rows, n), lengths divided by ℓ as in `clik.tool_task_error`, and ∂J/∂q (rows, n, n).

    Column i of J is (vᵢ, ωᵢ). ∂vᵢ/∂qⱼ = ω_min(i,j) × v_max(i,j); ∂ωᵢ/∂qⱼ = ωⱼ × ωᵢ for j < i, else 0.
    """
    chain = problem.robot.chain
    tool = poses[-1, :3, :3] @ problem.robot.T_link_tool[:3, 3] + poses[-1, :3, 3]
    axes, slides = jacobian.joint_axes(poses, chain), chain["slides"][:, None]
    v = np.where(slides, axes, np.cross(axes, tool - poses[1:, :3, 3])) / problem.length
    spin = np.where(slides, 0.0, axes)
    i, j = np.indices((len(chain), len(chain)))
    v_rate = np.cross(spin[np.minimum(i, j)], v[np.maximum(i, j)])
    spin_rate = np.where((j < i)[..., None], np.cross(spin[j], spin[i]), 0.0)
    drives = _drives(problem)
    J = np.concatenate([v, spin], axis=1).T[:rows]
    rates = np.concatenate([v_rate, spin_rate], axis=2).transpose(2, 0, 1)[:rows]
    return J @ drives, drives.T @ rates @ drives


def _drives(problem: Problem) -> Array:
    """The velocity of each chain joint for a unit velocity of each variable, (m, n); variables in `joint_units`."""
    chain = problem.robot.chain
    drives = np.zeros((len(chain), len(problem.robot.variables)))
    drives[np.arange(len(chain)), chain["driver"]] = chain["ratio"]
    return drives * problem.joint_units
