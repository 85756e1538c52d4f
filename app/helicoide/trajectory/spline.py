"""The cubic spline through sampled joint values."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helicoide.arrays import Array
from helicoide.text import HelicoideError, Text


@dataclass(frozen=True, eq=False)
class JointSpline:
    """Cubic spline through all samples, twice differentiable; its end slopes are those of cubics through four samples.

    knots (k,), s, ascending from 0; samples (k, n), rad or m. Raises HelicoideError for other arrays.
    """

    knots: Array
    samples: Array

    def __post_init__(self) -> None:
        s, q = self.knots, self.samples
        if not (
            s.ndim == 1
            and q.ndim == 2
            and len(s) == len(q) >= 2
            and s[0] == 0
            and np.isfinite(q).all()
            and np.isfinite(s).all()
            and (np.diff(s) > 0).all()
        ):
            raise HelicoideError(
                Text(
                    en="A sampled path needs two or more times that rise from 0 and as many rows of finite joint "
                    "values; it has shapes {s} and {q}.",
                    pt_BR="Uma trajetória amostrada precisa de dois ou mais instantes crescentes a partir de 0 e do "
                    "mesmo número de linhas de valores finitos de junta; ela tem os formatos {s} e {q}.",
                ).format(s=s.shape, q=q.shape)
            )

    @property
    def duration(self) -> float:
        """The last knot, s."""
        return float(self.knots[-1])

    @property
    def is_closed(self) -> bool:
        """Whether the last sample equals the first."""
        return np.array_equal(self.samples[0], self.samples[-1])

    @cached_property
    def second_derivatives(self) -> Array:
        """Second derivatives at the knots, (k, n): hᵢ₋₁ mᵢ₋₁ + 2 (hᵢ₋₁ + hᵢ) mᵢ + hᵢ mᵢ₊₁ = 6 (Δᵢ − Δᵢ₋₁).

        h: steps; Δ: slopes of the chords; the end slopes take the place of chords before and after.
        """
        h = np.diff(self.knots)
        chords = np.diff(self.samples, axis=0) / h[:, None]
        first = _slope(self.knots[:4], self.samples[:4])
        last = -_slope(-self.knots[::-1][:4], self.samples[::-1][:4])
        right = 6 * np.diff(np.vstack([first, chords, last]), axis=0)
        return _tridiagonal(np.append(0.0, h) + np.append(h, 0.0), h, right)

    def q(self, s: ArrayLike) -> Array:
        """Joint values (..., n), rad or m, at any array of parameters (...)."""
        a, b, h, i = self._within(s)
        m0, m1 = self.second_derivatives[i], self.second_derivatives[i + 1]
        return np.asarray(
            a * self.samples[i] + b * self.samples[i + 1] + ((a**3 - a) * m0 + (b**3 - b) * m1) * h**2 / 6
        )

    def rates(self, s: ArrayLike) -> Array:
        """dq/ds (..., n), rad/s or m/s."""
        a, b, h, i = self._within(s)
        m0, m1 = self.second_derivatives[i], self.second_derivatives[i + 1]
        return np.asarray(
            (self.samples[i + 1] - self.samples[i]) / h + ((1 - 3 * a**2) * m0 + (3 * b**2 - 1) * m1) * h / 6
        )

    def accelerations(self, s: ArrayLike) -> Array:
        """d²q/ds² (..., n), rad/s² or m/s²."""
        a, b, _, i = self._within(s)
        return np.asarray(a * self.second_derivatives[i] + b * self.second_derivatives[i + 1])

    def _within(self, s: ArrayLike) -> tuple[Array, Array, Array, NDArray[np.int64]]:
        """Weights of both ends of the piece that contains s, its length, and its number."""
        at = np.asarray(s, dtype=float)
        i = np.clip(np.searchsorted(self.knots, at, side="right") - 1, 0, len(self.knots) - 2).astype(np.int64)
        h = (self.knots[i + 1] - self.knots[i])[..., None]
        b = (at - self.knots[i])[..., None] / h
        return 1 - b, b, h, i


def _slope(s: Array, q: Array) -> Array:
    """Slope at the first of up to four samples of the polynomial through them, (n,)."""
    powers = np.vander(s - s[0], increasing=True)
    return np.asarray(np.linalg.solve(powers, q)[1])


def _tridiagonal(half_diagonal: Array, off_diagonal: Array, right: Array) -> Array:
    """Solve a symmetric system for (k, n): diagonal 2 · half_diagonal (k,), off-diagonal `beside` (k − 1,) (Thomas)."""
    diagonal, right = 2 * half_diagonal, right.copy()
    for i in range(1, len(diagonal)):
        share = off_diagonal[i - 1] / diagonal[i - 1]
        diagonal[i] -= share * off_diagonal[i - 1]
        right[i] -= share * right[i - 1]
    right[-1] /= diagonal[-1]
    for i in reversed(range(len(diagonal) - 1)):
        right[i] = (right[i] - off_diagonal[i] * right[i + 1]) / diagonal[i]
    return right
