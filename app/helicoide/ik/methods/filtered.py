"""The filtered inverse: a matrix Θ follows the inverse of J at a finite rate and stays bounded at singularities."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Annotated

import numpy as np

from helicoide.arrays import Array, frozen
from helicoide.ik import Problem, filtered_inverse
from helicoide.ik.filtered_inverse import Parts, Step, Update
from helicoide.ik.method import OnDemand, OneOf, Promise, Quantity, Solution, Task, YesNo
from helicoide.ik.modal import ModalDiagnosis, diagnosed
from helicoide.text import Text

TITLE = Text(en="filtered inverse", pt_BR="inversa filtrada")
SOURCE = "Vargas 2013, eqs. 4.18–4.38, 4.60, 4.61, tab. 4.1; ch. 5 (feed-forward)"
EQUATION = r"\dot q = \Theta \nu, \quad \dot\Theta = -\gamma \left(J^T (J\Theta - I) + (\Theta J - I) J^T\right)"
REMEMBERS: Text | None = Text(en="the filtered inverse Θ", pt_BR="a inversa filtrada Θ")
PROMISES: frozenset[Promise] = frozenset({Promise.CONVERGES, Promise.BOUNDED})
FIGURES: Mapping[str, Text] = {
    "V_c": Text(en="inversion error", pt_BR="erro de inversão"),
    "‖Θ‖": Text(en="norm of Θ, ‖q̇‖ ≤ ‖Θ‖ ‖ν‖", pt_BR="norma de Θ, ‖q̇‖ ≤ ‖Θ‖ ‖ν‖"),
    "dt_max": Text(en="largest stable Euler step, s", pt_BR="maior passo de Euler estável, s"),
}

# Θ restarts when an entry exceeds this. It grows without bound if Euler's step is too long or if feed-forward acts
# at a singularity.
LARGEST = 1e6

UPDATES = OneOf(
    Text(en="inversion error", pt_BR="erro de inversão"),
    {
        "composite": Text(en="right and left", pt_BR="à direita e à esquerda"),
        "right": Text(en="right, JΘ − I", pt_BR="à direita, JΘ − I"),
        "left": Text(en="left, ΘJ − I", pt_BR="à esquerda, ΘJ − I"),
    },
)
STEPS = OneOf(
    Text(en="integration", pt_BR="integração"),
    {
        "exact": Text(en="exact for constant J", pt_BR="exata com J constante"),
        "sylvester": Text(en="backward Euler (Sylvester)", pt_BR="Euler implícito (Sylvester)"),
        "euler": Text(en="explicit Euler", pt_BR="Euler explícito"),
    },
)
STARTS = OneOf(
    Text(en="initial Θ", pt_BR="Θ inicial"),
    {
        "zero": Text(en="zero: starts from rest", pt_BR="zero: parte do repouso"),
        "ones": Text(
            en="0.1 in every entry: leaves singular postures", pt_BR="0,1 em todos os elementos: sai de singularidades"
        ),
    },
)


@dataclass(frozen=True)
class Options:
    """gain: γ, in units of rad²/(ℓ² s). A direction with singular value σ converges with time constant 1/(2γσ²), s.

    update, step, start: see their choices. ahead: add −Θ J̇ Θ, which keeps Θ an inverse while J changes. It diverges at
    a singularity, so it acts only where the smallest singular value, in ℓ/rad, is above `above`.
    ratio: Γ_ℓ/Γ_r, the gain of the left inversion error over that of the right one (Coutinho 2015, tab. 4.3).
    """

    gain: Annotated[
        float,
        Quantity(Text(en="update gain γ", pt_BR="ganho γ"), 1.0, 1e6, "1/s", decades=True),
    ] = 40.0
    update: Annotated[Update, UPDATES] = "composite"
    step: Annotated[Step, STEPS] = "exact"
    start: Annotated[str, STARTS] = "zero"
    ahead: Annotated[bool, YesNo(Text(en="feed-forward of J̇", pt_BR="antecipação de J̇"))] = False
    above: Annotated[
        float,
        Quantity(
            Text(en="feed-forward above σₚ", pt_BR="antecipação acima de σₚ"), 0.01, 1.0, "mm/rad", 1, decades=True
        ),
    ] = 0.1
    ratio: Annotated[
        float,
        Quantity(
            Text(en="gain ratio Γₗ/Γᵣ", pt_BR="razão dos ganhos Γₗ/Γᵣ"),
            0.01,
            100.0,
            decades=True,
        ),
    ] = 1.0

    @property
    def parts(self) -> Parts:
        """The weights of the right and of the left inversion error."""
        right, left = filtered_inverse.parts(self.update)
        return right, self.ratio * left


@dataclass(frozen=True, eq=False)
class Memory:
    """Theta: Θ (n, r); before: the Jacobian (r, n) of the previous step, None before the first."""

    Theta: Array
    before: Array | None = None


def applies(task: Task) -> Text | None:
    """Applies to every task."""
    return None


def start(task: Task, options: Options) -> Memory:
    """Θ(0): zero, or 0.1 in every entry. Source: Vargas 2013, §4.5 (zero)."""
    return Memory(frozen(np.full(task.J.T.shape, 0.1 if options.start == "ones" else 0.0)))


def recalled(task: Task, memory: Memory, options: Options) -> Memory:
    """The memory, or a new one if the shape of the task has changed."""
    return memory if memory.Theta.shape == task.J.T.shape else start(task, options)


def updated(task: Task, memory: Memory, options: Options) -> Memory:
    """The memory after this step, or that of `start` if Θ has diverged.

    Source: Vargas 2013, eq. 4.61; ch. 5 for the feed-forward.
    """
    J, Theta = task.J, memory.Theta
    following = filtered_inverse.filter_step(J, Theta, options.gain, task.dt, options.parts, options.step)
    if options.ahead and memory.before is not None and np.linalg.svd(J, compute_uv=False)[-1] > options.above:
        following = following - Theta @ (J - memory.before) @ Theta
    if np.abs(following).max() > LARGEST:
        return start(task, options)
    return Memory(frozen(following), J)


def filter_modes(memory: Memory, options: Options) -> ModalDiagnosis | None:
    """Θ in the singular directions of the previous Jacobian; None before the first step. Source: Vargas 2013, §4.4."""
    if memory.before is None:
        return None
    return diagnosed(memory.before, memory.Theta, options.gain, options.parts)


def figures(task: Task, Theta: Array, options: Options) -> OnDemand:
    """The inversion error of Θ, its norm, and the longest stable step of Euler's rule, s."""
    return OnDemand(
        {
            "V_c": partial(_inversion_error, task.J, Theta),
            "‖Θ‖": partial(_size, Theta),
            "dt_max": partial(filtered_inverse.step_limit, task.J, options.gain, options.parts),
        }
    )


def _inversion_error(J: Array, Theta: Array) -> float:
    return sum(filtered_inverse.lyapunov(J, Theta))


def _size(Theta: Array) -> float:
    return float(np.linalg.norm(Theta, 2))


def step(problem: Problem, task: Task, memory: Memory, options: Options) -> tuple[Solution, Memory]:
    """q̇ = Θ ν with the present Θ; then Θ is updated."""
    memory = recalled(task, memory, options)
    Theta = memory.Theta
    return Solution(Theta @ task.rate, figures(task, Theta, options), Theta), updated(task, memory, options)
