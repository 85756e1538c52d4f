"""Feedback inverse kinematics: an internal controller reduces the velocity error ν − J q̇ without inverting J."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import Problem
from helicoide.ik.method import Promise, Quantity, Solution, Task
from helicoide.text import Text

TITLE = Text(en="feedback inverse", pt_BR="inversa realimentada")
SOURCE = "Vargas 2013, eqs. 3.15–3.25 (FIK, Pechev 2008)"
EQUATION = (
    r"\dot z = -\alpha z + (\nu - J \dot q), \quad \dot q = J^T G z, \quad "
    r"G = g \left(I + c (\mathbf{1}\mathbf{1}^T - I)\right)"
)
REMEMBERS: Text | None = Text(en="the integrated velocity error z", pt_BR="o erro de velocidade integrado z")
PROMISES: frozenset[Promise] = frozenset({Promise.CONVERGES, Promise.LEAVES_SINGULAR})
FIGURES: Mapping[str, Text] = {
    "‖z‖": Text(en="integrated error ‖z‖", pt_BR="erro integrado ‖z‖"),
    "‖ν − Jq̇‖": Text(en="velocity error", pt_BR="erro de velocidade"),
}


@dataclass(frozen=True)
class Options:
    """gain: g, in units of rad²/(ℓ² s); leak: α, the decay rate of z, 1/s; coupling: c, between the rows.

    The arm leaves a singular posture only if c > 0. G is positive definite for 0 ≤ c < 1.
    """

    gain: Annotated[float, Quantity(Text(en="gain g", pt_BR="ganho g"), 1.0, 1e5, "1/s", decades=True)] = 300.0
    coupling: Annotated[float, Quantity(Text(en="row coupling c", pt_BR="acoplamento das linhas c"), 0.0, 0.9)] = 0.3
    leak: Annotated[float, Quantity(Text(en="leak α", pt_BR="fuga α"), 0.0, 10.0, "1/s")] = 0.5


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> Array:
    """z = 0, (r,), so that the arm starts at rest."""
    return frozen(np.zeros(len(task.J)))


def compensator(rows: int, options: Options) -> Array:
    """G = g (I + c (11ᵀ − I)), (r, r)."""
    return options.gain * ((1 - options.coupling) * np.eye(rows) + options.coupling)


def step(problem: Problem, task: Task, memory: Array, options: Options) -> tuple[Solution, Array]:
    """q̇ = Jᵀ G z. Then z is integrated by backward Euler, because its equation is stiff:

    (I + dt (α I + J Jᵀ G)) z⁺ = z + dt ν. z restarts from zero if the number of rows has changed.
    """
    J, one = task.J, np.eye(len(task.J))
    z = memory if len(memory) == len(J) else start(task, options)
    G = compensator(len(J), options)
    rates = J.T @ G @ z
    following = np.linalg.solve(one + task.dt * (options.leak * one + J @ J.T @ G), z + task.dt * task.rate)
    figures = {"‖z‖": float(np.linalg.norm(z)), "‖ν − Jq̇‖": float(np.linalg.norm(task.rate - J @ rates))}
    return Solution(rates, figures), frozen(following)
