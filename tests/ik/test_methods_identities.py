"""What each differential method is, by identities: minima, limits, and what two methods share."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from helicoide.arrays import Array
from helicoide.ik import Problem, filtered_inverse, methods
from helicoide.ik.method import Solution, Task
from helicoide.studies.vargas.arms import planar_problem

FILTERED = ["filtered", "filtered_modified", "filtered_normal"]
NAMES = [
    "pseudoinverse", "damped", "inverse", "transpose", "damped_by_manipulability", "damped_by_singular_value",
    "feedback", *FILTERED,
]  # fmt: skip


@pytest.fixture(scope="module")
def problem() -> Problem:
    return planar_problem()


def asked(r: int = 3, n: int = 4, seed: int = 0, dt: float = 0.01) -> Task:
    """A random task."""
    rng = np.random.default_rng(seed)
    return Task(np.zeros(n), rng.normal(size=(r, n)), rng.normal(size=r), dt)


def with_sigma(sigma: list[float], seed: int = 1) -> Task:
    """A random square task with given singular values."""
    p = len(sigma)
    task = asked(p, p, seed)
    U, _, Vt = np.linalg.svd(task.J)
    return replace(task, J=U * sigma @ Vt)


def one(name: str, problem: Problem, task: Task, memory: Any = None, **options: Any) -> Solution:
    """The first answer of a method."""
    method = methods.named(name)
    chosen = method.Options(**options)
    memory = method.start(task, chosen) if memory is None else memory
    solution, _ = method.step(problem, task, memory, chosen)
    return solution


def last(name: str, problem: Problem, task: Task, steps: int, **options: Any) -> Solution:
    """The answer after some steps of one and the same task."""
    method = methods.named(name)
    chosen = method.Options(**options)
    memory = method.start(task, chosen)
    for _ in range(steps):
        solution, memory = method.step(problem, task, memory, chosen)
    return solution


# what all have in common


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("shape", [(3, 3), (2, 3), (6, 5), (6, 7), (3, 1)])
def test_finite_and_linear(name: str, shape: tuple[int, int], problem: Problem) -> None:
    """q̇ = B ν where a method gives its B; a lost row, J = 0 and ν = 0 give finite rates; figures are named."""
    method = methods.named(name)
    for task in (
        asked(*shape),
        replace(asked(*shape), J=np.zeros(shape)),
        replace(asked(*shape), rate=np.zeros(shape[0])),
    ):
        assert (method.applies(task) is None) == (name != "inverse" or (shape == (3, 3) and bool(task.J.any())))
        memory = method.start(task, method.Options())
        for _ in range(3):
            solution, memory = method.step(problem, task, memory, method.Options())
            assert solution.rates.shape == shape[1:]
            assert np.isfinite(solution.rates).all()
            assert set(solution.figures) == set(method.FIGURES)
            if solution.inverse is not None:
                np.testing.assert_allclose(solution.inverse @ task.rate, solution.rates, atol=1e-12)


@pytest.mark.parametrize("name", ["feedback", *FILTERED])
def test_memory_survives_another_number_of_rows(name: str, problem: Problem) -> None:
    """When orientation is switched off, and on again, what does not fit begins anew, what fits goes on."""
    method = methods.named(name)
    chosen, memory = method.Options(), None
    for rows in (6, 6, 3, 3, 6):
        task = asked(rows, 5)
        memory = method.start(task, chosen) if memory is None else memory
        solution, memory = method.step(problem, task, memory, chosen)
        assert np.isfinite(solution.rates).all()
    fresh, _ = method.step(problem, asked(3, 5), method.start(asked(3, 5), chosen), chosen)
    gone_on, _ = method.step(problem, asked(3, 5), memory, chosen)
    if name == "filtered_normal":  # JᵀJ keeps its shape
        assert np.abs(gone_on.rates).max() > 0
    else:
        np.testing.assert_array_equal(gone_on.rates, fresh.rates)


# without memory


def test_the_inverse_is_the_pseudoinverse_of_square_tasks(problem: Problem) -> None:
    task = asked(4, 4)
    np.testing.assert_allclose(one("inverse", problem, task).rates, one("pseudoinverse", problem, task).rates)
    np.testing.assert_allclose(task.J @ one("inverse", problem, task).rates, task.rate)
    assert one("inverse", problem, task).figures["|det J|"] == pytest.approx(abs(np.linalg.det(task.J)))


@pytest.mark.parametrize("smallest", [0.0, 1e-13])
def test_the_inverse_stands_still_where_there_is_none(smallest: float, problem: Problem) -> None:
    for task in (with_sigma([2, 1, smallest]), asked(3, 5), asked(6, 5)):
        solution = one("inverse", problem, task)
        assert not solution.rates.any()
        assert solution.figures["|det J|"] == 0


def test_the_inverse_says_where_it_does_not_apply() -> None:
    inverse = methods.named("inverse")
    said = inverse.applies(asked(3, 4))
    assert said is not None
    assert "3" in said.en
    assert "4" in said.pt_BR
    lost = asked(3, 3)
    lost.J[2] = 0
    assert inverse.applies(lost) is not None
    assert inverse.applies(asked(3, 3)) is None


@pytest.mark.parametrize("name", NAMES[:6])
def test_nothing_is_asked_of_lost_directions(name: str, problem: Problem) -> None:
    """ν in Nul(Jᵀ) of an exactly singular J moves no joint."""
    task = with_sigma([2, 1, 0])
    u = np.linalg.svd(task.J)[0][:, 2]
    assert np.abs(one(name, problem, replace(task, rate=u)).rates).max() < 1e-12


@pytest.mark.parametrize("seed", range(5))
def test_the_best_step_of_the_transpose(seed: int, problem: Problem) -> None:
    """α J Jᵀν is as near to ν as α can bring it: the rest is square to J Jᵀν; and α is no more than allowed."""
    task = asked(3, 4, seed)
    rates = one("transpose", problem, task, alpha=1e9).rates
    moved = task.J @ rates
    assert moved @ (task.rate - moved) == pytest.approx(0, abs=1e-12)
    np.testing.assert_allclose(one("transpose", problem, task, alpha=1e-3).rates, 1e-3 * task.J.T @ task.rate)
    constant = one("transpose", problem, task, step="constant", alpha=7.0)
    np.testing.assert_allclose(constant.rates, 7 * task.J.T @ task.rate)


@pytest.mark.parametrize(("step", "alpha", "stable"), [
    ("best", 30.0, True), ("constant", 0.99, True), ("constant", 1.01, False),
])  # fmt: skip
def test_where_the_transpose_is_stable(step: str, alpha: float, stable: bool, problem: Problem) -> None:
    """e ← e − dt λ α J Jᵀe at dt λ = 1.9: the best α never lets ‖e‖ grow, a constant one up to dt λ α σ₁² = 2."""
    task, e = asked(3, 4, dt=0.05), np.ones(3)
    limit = 2 / (1.9 * np.linalg.norm(task.J, 2) ** 2)
    sizes = []
    for _ in range(1500):
        rates = one("transpose", problem, replace(task, rate=38 * e), step=step,
                    alpha=alpha if step == "best" else alpha * limit).rates  # fmt: skip
        e = e - 0.05 * task.J @ rates
        sizes.append(float(np.linalg.norm(e)))
    assert (sizes[-1] < 1e-6) == stable
    assert (sizes[-1] > 1e3) != stable
    assert not stable or all(later <= earlier * (1 + 1e-12) for earlier, later in pairwise(sizes))


@pytest.mark.parametrize("exponent", ["1", "2"])
def test_damping_by_manipulability(exponent: str, problem: Problem) -> None:
    """δ = δ₀ (1 − w/w₀)^k, zero from w₀ on; then damped least squares with δ, that minimises ‖ν − Jq̇‖² + δ‖q̇‖²."""
    task = asked(3, 4)
    w = np.sqrt(np.linalg.det(task.J @ task.J.T))
    found = one("damped_by_manipulability", problem, task, damping=0.3, threshold=4 * w, exponent=exponent)
    delta = 0.3 * 0.75 ** int(exponent)
    assert found.figures == pytest.approx({"w": w, "δ": delta})
    np.testing.assert_allclose(found.rates, one("damped", problem, task, damping=np.sqrt(delta)).rates)
    gradient = task.J.T @ (task.J @ found.rates - task.rate) + delta * found.rates
    assert np.abs(gradient).max() < 1e-12
    calm = one("damped_by_manipulability", problem, task, damping=0.3, threshold=w)
    assert calm.figures["δ"] == 0
    np.testing.assert_allclose(calm.rates, one("pseudoinverse", problem, task).rates)


def test_damping_by_singular_value(problem: Problem) -> None:
    """Each direction by itself: above ε as the pseudoinverse, below it σ/(σ² + λ²), continuous at ε."""
    task = with_sigma([2, 0.05, 0.02, 0])
    U, sigma, Vt = np.linalg.svd(task.J)
    found = one("damped_by_singular_value", problem, task, threshold=0.1, damping=0.03)
    assert found.inverse is not None
    squares = 0.03**2 * (1 - (np.array([0.05, 0.02]) / 0.1) ** 2)
    expected = [1 / 2, *(sigma[1:3] / (sigma[1:3] ** 2 + squares)), 0]
    np.testing.assert_allclose(Vt @ found.inverse @ U, np.diag(expected), atol=1e-10)
    assert found.figures == pytest.approx({"σₚ": 0, "λₚ": 0.03, "damped": 3}, abs=1e-9)
    near = [
        one("damped_by_singular_value", problem, with_sigma([2, s, s]), threshold=0.1).rates for s in (0.1 - 1e-9, 0.1)
    ]
    np.testing.assert_allclose(*near, rtol=1e-5)


# with memory


def test_feedback_comes_to_rest_as_damped_least_squares(problem: Problem) -> None:
    """q̇ = JᵀQ (JJᵀQ + I)⁻¹ ν, Q = G/α; with c = 0 this is damped least squares with λ² = α/g."""
    task = asked(3, 4)
    G = 40 * (0.7 * np.eye(3) + 0.3 * np.ones((3, 3)))
    end = last("feedback", problem, task, 500, gain=40.0, coupling=0.3, leak=0.5)
    Q = G / 0.5
    expected = task.J.T @ Q @ np.linalg.solve(task.J @ task.J.T @ Q + np.eye(3), task.rate)
    np.testing.assert_allclose(end.rates, expected, rtol=1e-9)
    plain = last("feedback", problem, task, 500, gain=40.0, coupling=0.0, leak=0.5)
    np.testing.assert_allclose(plain.rates, one("damped", problem, task, damping=np.sqrt(0.5 / 40)).rates, rtol=1e-9)


def test_feedback_takes_a_step_of_backward_euler(problem: Problem) -> None:
    """(z⁺ − z)/dt = −α z⁺ + ν − J Jᵀ G z⁺, stable at any dt."""
    feedback, task = methods.named("feedback"), asked(3, 4, dt=10.0)
    options = feedback.Options(gain=1e4, coupling=0.3, leak=0.5)
    z = np.array([1.0, -2, 3])
    _, following = feedback.step(problem, task, z, options)
    G = 1e4 * (0.7 * np.eye(3) + 0.3 * np.ones((3, 3)))
    slope = -0.5 * following + task.rate - task.J @ task.J.T @ G @ following
    np.testing.assert_allclose((following - z) / 10, slope, atol=1e-9)


@pytest.mark.parametrize("name", FILTERED)
@pytest.mark.parametrize("shape", [(2, 3), (3, 3), (3, 2)])
@pytest.mark.parametrize("step", ["exact", "sylvester"])
def test_filtered_methods_come_to_the_pseudoinverse(
    name: str, shape: tuple[int, int], step: str, problem: Problem
) -> None:
    task = replace(asked(*shape), dt=0.05)
    end = last(name, problem, task, 800, gain=1e3, step=step)
    np.testing.assert_allclose(end.rates, one("pseudoinverse", problem, task).rates, atol=1e-9)
    inverted = task.J.T @ task.J if name == "filtered_normal" else task.J
    assert end.figures["V_c"] == pytest.approx(sum(inverted.shape) / 2 - min(shape))


def test_filtered_methods_start_from_rest_or_from_ones(problem: Problem) -> None:
    task = asked(2, 3)
    assert not one("filtered", problem, task).rates.any()
    np.testing.assert_allclose(one("filtered", problem, task, start="ones").rates, 0.1 * np.sum(task.rate))
    np.testing.assert_allclose(
        one("filtered_modified", problem, task, start="ones").rates, 0.02 * np.sum(task.J.T @ task.rate)
    )
    np.testing.assert_allclose(
        one("filtered_normal", problem, task, start="ones").rates, 0.1 * np.sum(task.J.T @ task.rate)
    )


@pytest.mark.parametrize("seed", range(4))
def test_the_modified_law_never_pushes_back_and_drops_what_is_lost(seed: int, problem: Problem) -> None:
    """J q̇ = M ν with M = Mᵀ ≥ 0 for any Θ, and what lies in Nul(Jᵀ) does not count."""
    modified = methods.named("filtered_modified")
    task = with_sigma([2, 1, 0], seed)
    memory = replace(modified.start(task, modified.Options()), Theta=np.random.default_rng(seed).normal(size=(3, 3)))
    found = one("filtered_modified", problem, task, memory)
    assert found.inverse is not None
    M = task.J @ found.inverse
    np.testing.assert_allclose(M, M.T, atol=1e-12)
    assert np.linalg.eigvalsh((M + M.T) / 2).min() > -1e-12
    U = np.linalg.svd(task.J)[0]
    along = replace(task, rate=task.rate - U[:, 2] * (U[:, 2] @ task.rate))
    np.testing.assert_allclose(one("filtered_modified", problem, along, memory).rates, found.rates, atol=1e-12)


def crossing(t: float) -> Array:
    """A Jacobian that moves and stays well conditioned."""
    return np.array([[1, 0.3 * np.sin(t)], [0.2 * np.cos(2 * t), 0.8]])


def inversion_error(problem: Problem, **options: Any) -> float:
    """The largest V_c after the first second, at 10 ms, J moving."""
    method = methods.named("filtered")
    chosen = method.Options(gain=10.0, **options)
    memory, worst = None, 0.0
    for t in np.arange(0, 5, 0.01):
        task = Task(np.zeros(2), crossing(t), np.ones(2), 0.01)
        memory = method.start(task, chosen) if memory is None else memory
        solution, memory = method.step(problem, task, memory, chosen)
        worst = max(worst, solution.figures["V_c"]) if t > 1 else 0.0
    return worst


def test_feed_forward_holds_the_inverse_where_it_is_well_conditioned(problem: Problem) -> None:
    without, with_it = inversion_error(problem), inversion_error(problem, ahead=True)
    assert with_it < without / 100
    assert inversion_error(problem, ahead=True, above=2.0) == without


@pytest.mark.parametrize("name", FILTERED)
def test_explicit_euler_beyond_its_limit_stays_finite(name: str, problem: Problem) -> None:
    """It works up to the step that its figure names, and grows and begins anew beyond."""
    task = replace(with_sigma([2, 1.8, 1.5]), dt=0.05)
    limit = one(name, problem, task, gain=1.0).figures["dt_max"]
    calm = last(name, problem, task, 300, step="euler", gain=0.95 * limit / 0.05)
    assert np.abs(calm.rates - one("pseudoinverse", problem, task).rates).max() < 1e-3
    method = methods.named(name)
    wild = method.Options(step="euler", gain=50 * limit / 0.05)
    memory, largest = method.start(task, wild), 0.0
    for _ in range(500):
        solution, memory = method.step(problem, task, memory, wild)
        assert np.isfinite(solution.rates).all()
        largest = max(largest, np.abs(solution.rates).max())
    assert largest > 1e3


@pytest.mark.parametrize("name", FILTERED)
def test_figures_are_computed_when_they_are_read(name: str, problem: Problem, monkeypatch: pytest.MonkeyPatch) -> None:
    asked_for = []

    def lyapunov(J: Array, Theta: Array) -> tuple[float, float]:
        asked_for.append(J)
        return 1.0, 2.0

    monkeypatch.setattr(filtered_inverse, "lyapunov", lyapunov)
    found = one(name, problem, asked())
    assert asked_for == []
    assert found.figures["V_c"] == 3
    assert len(asked_for) == 1
    assert list(found.figures) == list(methods.named(name).FIGURES)
    assert len(found.figures) == 3
