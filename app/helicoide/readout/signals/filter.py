"""The filtered inverse: Θ in the singular vectors of J, its inversion error, and the phase planes of Vargas.

σᵢ, dᵢ and rᵢⱼ are those of `ik.modal`. In a square J = U Σ Vᵀ the smallest singular value can be given the sign
det U det V, so that it passes through zero where the arm crosses a singularity:

    k = ±σₚ,   θ = ±dₚ,   θ_M = θ² k

As in the scalar case, θ tends to 1/k. Source: Vargas 2013, eqs. 4.44–4.54, 4.64; figs. 4.1, 4.2, 4.6, 4.28.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache

import numpy as np

from helicoide.arrays import Array
from helicoide.ik import Problem
from helicoide.ik.methods import filtered
from helicoide.ik.modal import ModalDiagnosis
from helicoide.kinematics.manipulability import analyse_jacobian
from helicoide.readout.instruments import method_modes
from helicoide.readout.signal import PhasePlane, Signal, scalar, subscript
from helicoide.state import State
from helicoide.text import Text, untranslated

TITLE = Text(en="Filter", pt_BR="Filtro")
ORDER = 5
PHASES = (
    PhasePlane("phase d", Text(en="Phase plane dᵢ × σᵢ", pt_BR="Plano de fase dᵢ × σᵢ"), "filter σ", "filter d", True),
    PhasePlane("phase θ", Text(en="Phase plane θ × k", pt_BR="Plano de fase θ × k"), "filter k", "filter θ", True),
    PhasePlane(
        "phase θ_M",
        Text(en="Phase plane, modified θ × k", pt_BR="Plano de fase, θ modificada × k"),
        "filter k",
        "filter θ_M",
    ),
)
PRESET = ("inversion error", "norm of Θ", "filter σd", "phase d")


@lru_cache(maxsize=8)  # the signals of one state share it
def _modes(state: State) -> ModalDiagnosis | None:
    return method_modes(state)


def signals(problem: Problem, with_orientation: bool) -> Iterator[Signal]:
    """All of them are NaN while another method moves the arm."""
    error = Text(en="Inversion error of Θ", pt_BR="Erro de inversão de Θ")
    yield Signal("inversion error", error, "V_c", "", (Text(en="error", pt_BR="erro"),), _figure("V_c"), positive=True)
    norm = Text(en="Norm of Θ", pt_BR="Norma de Θ")
    yield Signal("norm of Θ", norm, "‖Θ‖", "", (untranslated("‖Θ‖"),), _figure("‖Θ‖"), positive=True)
    yield from _modal(len(problem.robot.variables))
    residuals = Text(en="Residuals of Θ", pt_BR="Resíduos de Θ")
    yield Signal("residuals", residuals, "‖R‖", "", (untranslated("‖R‖"),), _residuals, positive=True)
    signed = {
        "filter k": (Text(en="Signed smallest singular value k", pt_BR="Menor valor singular com sinal k"), "k"),
        "filter θ": (Text(en="Its filtered inverse θ", pt_BR="Sua inversa filtrada θ"), "θ"),
        "filter θ_M": (
            Text(en="Its modified filtered inverse", pt_BR="Sua inversa filtrada modificada"),
            "θ_M",
        ),
    }
    for place, (name, (title, symbol)) in enumerate(signed.items()):
        yield Signal(name, title, symbol, "", (untranslated(symbol),), _signed(place))


def _modal(n: int) -> Iterator[Signal]:
    """σᵢ, dᵢ and σᵢdᵢ, with as many curves as joints; those beyond min(r, n) are NaN."""
    modes: dict[str, tuple[Text, str, Callable[[ModalDiagnosis], Array]]] = {
        "filter σ": (Text(en="Singular values in the filter", pt_BR="Valores singulares no filtro"), "σ", _sigma),
        "filter d": (Text(en="Diagonal terms of Θ", pt_BR="Termos diagonais de Θ"), "d", lambda found: found.d),
        "filter σd": (
            Text(en="σᵢdᵢ, which converge to 1", pt_BR="σᵢdᵢ, que convergem para 1"),
            "σd",
            lambda found: found.sigma * found.d,
        ),
    }
    for name, (title, symbol, read) in modes.items():
        curves = tuple(untranslated(subscript(symbol, i + 1)) for i in range(n))
        yield Signal(name, title, symbol, "", curves, _padded(read, n), positive=name == "filter σ")


def _sigma(found: ModalDiagnosis) -> Array:
    return found.sigma


def _padded(read: Callable[[ModalDiagnosis], Array], n: int) -> Callable[[State], Array]:
    """A modal quantity as (n,), NaN beyond its length and without a filter."""

    def values(state: State) -> Array:
        padded, found = np.full(n, np.nan), _modes(state)
        if found is not None:
            here = read(found)[:n]
            padded[: len(here)] = here
        return padded

    return values


def _figure(symbol: str) -> Callable[[State], Array]:
    """A figure of the last solution of a filtered inverse, (1,)."""

    def values(state: State) -> Array:
        controller = state.request.controller
        if not isinstance(controller.memory, filtered.Memory) or controller.solution is None:
            return scalar(np.nan)
        return scalar(controller.solution.figures[symbol])

    return values


def _residuals(state: State) -> Array:
    found = _modes(state)
    return scalar(np.nan if found is None else float(np.linalg.norm(found.R)))


@lru_cache(maxsize=8)
def signed_mode(state: State) -> Array:
    """k, θ and θ_M, (3,); NaN without a filter, if the matrix that it inverts is not square, or is not finite."""
    found, memory = _modes(state), state.request.controller.memory
    if found is None or memory.before.shape[0] != memory.before.shape[1]:
        return np.full(3, np.nan)
    axes = analyse_jacobian(memory.before)
    sign = np.sign(np.linalg.det(axes.U) * np.linalg.det(axes.V))
    k, theta = sign * found.sigma[-1], sign * found.d[-1]
    return np.array([k, theta, theta**2 * k])


def _signed(place: int) -> Callable[[State], Array]:
    return lambda state: scalar(signed_mode(state)[place])
