"""Damped least squares with damping only near singular postures, where the manipulability is below a threshold."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from helicoide.ik import Problem
from helicoide.ik.method import OneOf, Promise, Quantity, Solution, Task
from helicoide.kinematics.manipulability import RANK_TOLERANCE
from helicoide.text import Text

TITLE = Text(en="DLS, manipulability-based damping", pt_BR="MQA, amortecimento pela manipulabilidade")
SOURCE = "Vargas 2013, eqs. 3.10–3.14; Nakamura and Hanafusa 1986 (exponent 2); Coutinho 2015, eq. 3.44 (4)"
EQUATION = r"\dot q = J^T (J J^T + \delta I)^{-1} \nu, \quad \delta = \delta_0 (1 - w/w_0)^k, \quad w < w_0"
REMEMBERS: Text | None = None
PROMISES = frozenset({Promise.CONVERGES, Promise.BOUNDED, Promise.STAYS_SINGULAR})
FIGURES: Mapping[str, Text] = {
    "w": Text(en="manipulability w", pt_BR="manipulabilidade w"),
    "δ": Text(en="damping δ", pt_BR="amortecimento δ"),
}


@dataclass(frozen=True)
class Options:
    """damping: δ₀, in units of ℓ² per rad². threshold: w₀, compared with w, the product of the singular values of J.

    Lengths in J are divided by ℓ, so w has no length unit. For the position in space, w ℓ³ is the manipulability of
    the sources. A row that no joint can move, such as the height of a planar arm, gives w = 0 and δ = δ₀.
    """

    damping: Annotated[
        float,
        Quantity(Text(en="damping δ₀", pt_BR="amortecimento δ₀"), 1e-6, 1.0, "mm²/rad²", lengths=2, decades=True),
    ] = 0.01
    threshold: Annotated[float, Quantity(Text(en="threshold w₀", pt_BR="limiar w₀"), 1e-4, 1.0, decades=True)] = 0.02
    exponent: Annotated[
        str,
        OneOf(
            Text(en="δ below w₀", pt_BR="δ abaixo de w₀"),
            {
                "1": Text(en="linear, (1 − w/w₀)", pt_BR="linear, (1 − w/w₀)"),
                "2": Text(en="quadratic, (1 − w/w₀)²", pt_BR="quadrático, (1 − w/w₀)²"),
                "4": Text(en="fourth power, (1 − w/w₀)⁴", pt_BR="quarta potência, (1 − w/w₀)⁴"),
            },
        ),
    ] = "1"


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> None:
    """This method has no memory."""


def damping(w: float, options: Options) -> float:
    """δ = δ₀ (1 − w/w₀)^k below w₀, 0 above. Source: Vargas 2013, eq. 3.11."""
    return float(options.damping * max(0.0, 1 - w / options.threshold) ** int(options.exponent))


def step(problem: Problem, task: Task, memory: None, options: Options) -> tuple[Solution, None]:
    """q̇ = Σ σᵢ/(σᵢ² + δ) vᵢ uᵢᵀ ν."""
    U, sigma, Vt = np.linalg.svd(task.J, full_matrices=False)
    # Without this, rounding errors could move the arm out of an exact singularity.
    sigma = np.where(sigma > RANK_TOLERANCE * sigma[0], sigma, 0.0)
    w = float(np.prod(sigma))
    delta = damping(w, options)
    B = Vt.T * (sigma / (sigma**2 + delta)) @ U.T
    return Solution(B @ task.rate, {"w": w, "δ": delta}, inverse=B), None
