"""The filtered inverse: a matrix Θ follows the inverse of the Jacobian at a finite speed, also across singularities."""

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
from helicoide.ik.modal import Diagnosis, diagnosed
from helicoide.text import Text

TITLE = Text(en="filtered inverse", pt_BR="inversa filtrada")
SOURCE = "Vargas 2013, eqs. 4.18–4.38, 4.60, 4.61, tab. 4.1; ch. 5 (feed-forward)"
EQUATION = r"\dot q = \Theta \nu, \quad \dot\Theta = -\gamma \left(J^T (J\Theta - I) + (\Theta J - I) J^T\right)"
REMEMBERS: Text | None = Text(en="the filtered inverse Θ", pt_BR="a inversa filtrada Θ")
PROMISES: frozenset[Promise] = frozenset({Promise.CONVERGES, Promise.BOUNDED})
FIGURES: Mapping[str, Text] = {
    "V_c": Text(en="inversion error V_c", pt_BR="erro de inversão V_c"),
    "‖Θ‖": Text(en="size of Θ: at most ‖Θ‖ ‖ν‖ moves the joints", pt_BR="tamanho de Θ: as juntas recebem até ‖Θ‖ ‖ν‖"),
    "dt_max": Text(en="longest stable step of Euler's rule, s", pt_BR="maior passo estável da regra de Euler, s"),
}

# Euler's rule beyond its longest step, and feed-forward into a singularity, let Θ grow without end: it begins anew.
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
        "exact": Text(en="exact while J stands still", pt_BR="exata com J parado"),
        "sylvester": Text(en="backward Euler (Sylvester)", pt_BR="Euler implícito (Sylvester)"),
        "euler": Text(en="explicit Euler", pt_BR="Euler explícito"),
    },
)
STARTS = OneOf(
    Text(en="Θ at the start", pt_BR="Θ inicial"),
    {
        "zero": Text(en="zero: from rest", pt_BR="zero: parte do repouso"),
        "ones": Text(en="0.1 everywhere: leaves singular postures", pt_BR="0,1 em toda parte: sai de singularidades"),
    },
)


@dataclass(frozen=True)
class Options:
    """gain: γ, in units of rad²/(ℓ² s); a direction with the singular value σ is learnt in 1/(2γσ²) seconds.

    update, step, start: see their choices. ahead: add −Θ J̇ Θ, which holds the inverse while J moves but forbids the
    crossing of a singularity, and therefore acts only where the smallest singular value, in ℓ/rad, is above `above`.
    ratio: Γ_ℓ over Γ_r, the gain of the left inversion error over that of the right one (Coutinho 2015, tab. 4.3).
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
            Text(en="ratio of the gains Γₗ/Γᵣ", pt_BR="razão dos ganhos Γₗ/Γᵣ"),
            0.01,
            100.0,
            decades=True,
        ),
    ] = 1.0

    @property
    def parts(self) -> Parts:
        """How much of the right and of the left error acts."""
        right, left = filtered_inverse.parts(self.update)
        return right, self.ratio * left


@dataclass(frozen=True, eq=False)
class Memory:
    """Θ (n, r), and the Jacobian (r, n) of the instant before, None at the first."""

    Theta: Array
    before: Array | None = None


def applies(task: Task) -> Text | None:
    """To every task."""
    return None


def start(task: Task, options: Options) -> Memory:
    """Θ(0): zero, or 0.1 in every entry. Source: Vargas 2013, §4.5 (zero)."""
    return Memory(frozen(np.full(task.J.T.shape, 0.1 if options.start == "ones" else 0.0)))


def recalled(task: Task, memory: Memory, options: Options) -> Memory:
    """The memory, or a fresh one when the task has changed its shape."""
    return memory if memory.Theta.shape == task.J.T.shape else start(task, options)


def updated(task: Task, memory: Memory, options: Options) -> Memory:
    """Θ after this instant. Source: Vargas 2013, eq. 4.61, and ch. 5 for the feed-forward."""
    J, Theta = task.J, memory.Theta
    following = filtered_inverse.stepped(J, Theta, options.gain, task.dt, options.parts, options.step)
    if options.ahead and memory.before is not None and np.linalg.svd(J, compute_uv=False)[-1] > options.above:
        following = following - Theta @ (J - memory.before) @ Theta
    if np.abs(following).max() > LARGEST:
        return start(task, options)
    return Memory(frozen(following), J)


def modes(memory: Memory, options: Options) -> Diagnosis | None:
    """Θ in the axes of the Jacobian of the instant before; None at the first. Source: Vargas 2013, §4.4."""
    if memory.before is None:
        return None
    return diagnosed(memory.before, memory.Theta, options.gain, options.parts)


def figures(task: Task, Theta: Array, options: Options) -> OnDemand:
    """How well Θ inverts J, how large it is, and what Euler's rule would bear."""
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
    """q̇ = Θ ν, with the Θ of before; then Θ takes its step."""
    memory = recalled(task, memory, options)
    Theta = memory.Theta
    return Solution(Theta @ task.rate, figures(task, Theta, options), Theta), updated(task, memory, options)
