"""Joint space and actuator space: the encoder pulses of the motors for joint angles q, and back.

There are two steps. The mechanism drives sums of joint angles, φ = C q: a forearm that is pushed from the base is
driven by q₂ + q₃, a wrist roll that follows the pitch by q₅ − q₄. Each actuator then converts one driven angle into
pulses of its encoder, through a gear or through a ball screw that closes a triangle.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from helicoide.arrays import Array, frozen
from helicoide.text import HelicoideError, Text, join_texts

UNIT = Text(en="pulses", pt_BR="pulsos")
ACTUATORS = Text(en="actuators: {told}", pt_BR="atuadores: {told}")
GEAR_READING = Text(en="{label} {n} pulses", pt_BR="{label} {n} pulsos")
SCREW_READING = Text(en="{label} {n} pulses, screw {mm:.1f} mm long", pt_BR="{label} {n} pulsos, fuso com {mm:.1f} mm")
ANGLE_OUT_OF_RANGE = Text(
    en="The ball screw of {label} allows {low:.4g}° to {high:.4g}°, not {given:.4g}°.",
    pt_BR="O fuso de esferas de {label} permite de {low:.4g}° a {high:.4g}°, não {given:.4g}°.",
)
PULSES_OUT_OF_RANGE = Text(
    en="The ball screw of {label} closes its triangle from {low:.0f} to {high:.0f} {unit}, not at {given:.0f}.",
    pt_BR="O fuso de esferas de {label} fecha o triângulo de {low:.0f} a {high:.0f} {unit}, não em {given:.0f}.",
)
# Tolerance for rounding at either end of a ball screw's range, as a fraction of the range.
ROUNDING = 1e-9


@dataclass(frozen=True)
class Gear:
    """A motor whose pulses are proportional to the driven angle.

    pulses_per_rad: negative if it counts against the angle; zero: the driven angle at zero pulses, rad.
    """

    pulses_per_rad: float
    zero: float

    @property
    def angles(self) -> tuple[float, float]:
        """Range of the driven angle, rad: unlimited."""
        return -math.inf, math.inf

    def pulses(self, angle: ArrayLike) -> Array:
        """Pulses at a driven angle, A = r (φ − φ₀); angle (...), rad. Source: Cerbaro 2022, tabs. 1 and 4."""
        return self.pulses_per_rad * (np.asarray(angle) - self.zero)

    def angle(self, pulses: ArrayLike) -> Array:
        """The driven angle, φ = φ₀ + A / r, (...), rad; pulses (...). Source: Craig, chapter 3 (θ1, θ4 and θ5)."""
        return self.zero + np.asarray(pulses) / self.pulses_per_rad


@dataclass(frozen=True)
class BallScrew:
    """A screw as the third side of a triangle with two fixed sides, m, that opens the angle ψ between them.

    pulses_per_m: negative if rising counts shorten the screw; length_at_zero, m; zero: driven angle at ψ = 0, rad.
    """

    sides: tuple[float, float]
    pulses_per_m: float
    length_at_zero: float
    zero: float

    @property
    def angles(self) -> tuple[float, float]:
        """Range of the driven angle, rad, from the folded triangle, L = |α − β|, to the flat one, L = α + β."""
        return self.zero, self.zero + math.pi

    def length(self, angle: ArrayLike) -> Array:
        """Length of the screw at a driven angle, L = √(α² + β² − 2αβ cos(φ − δ)), (...), m, with δ the zero.

        Args: angle (...), rad. Source: Campos 1998, s.55 (names the arm); Craig, chapter 3.
        """
        a, b = self.sides
        # with the half angle, rounding cannot make the radicand of a folded triangle negative
        return np.sqrt((a - b) ** 2 + 4 * a * b * np.sin((np.asarray(angle) - self.zero) / 2) ** 2)

    def pulses(self, angle: ArrayLike) -> Array:
        """Pulses at a driven angle, A = (L − λ) / k, k in m per pulse, (...); angle (...), rad.

        Source: Campos 1998, s.55 (names the arm); Craig, chapter 3.
        """
        return np.asarray((self.length(angle) - self.length_at_zero) * self.pulses_per_m)

    def angle(self, pulses: ArrayLike) -> Array:
        """The driven angle, φ = acos((α² + β² − L²) / 2αβ) + δ with L = k A + λ, (...), rad.

        Args: pulses (...). Source: Campos 1998, s.55 (names the arm); Craig, chapter 3.
        """
        a, b = self.sides
        length = self.length_at_zero + np.asarray(pulses) / self.pulses_per_m
        cosine = (a**2 + b**2 - length**2) / (2 * a * b)
        return np.arccos(np.clip(cosine, -1, 1)) + self.zero


@dataclass(frozen=True, eq=False)
class Actuators:
    """The actuators A1 … An of an arm with the named joints.

    coupling C (n, n), integers: driven angles φ = C q. drives: the gear or ball screw of each driven angle.
    """

    joints: tuple[str, ...]
    coupling: Array
    drives: tuple[Gear | BallScrew, ...]

    @cached_property
    def inverse_coupling(self) -> Array:
        """C⁻¹, (n, n): joint angles q = C⁻¹ φ."""
        return frozen(np.linalg.inv(self.coupling))

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """What each actuator drives, such as "A3 (J2 + J3)"."""
        return tuple(f"A{i + 1} ({_sum(row, self.joints)})" for i, row in enumerate(self.coupling))

    def from_joints(self, q: ArrayLike) -> Array:
        """Pulses of the actuators at joint angles, Aᵢ = pulsesᵢ((C q)ᵢ), (..., n).

        Args: q (..., n), rad. Raises HelicoideError if an angle is outside the range of its ball screw.
        Source: Cerbaro 2022, fig. 20 and tab. 4; Campos 1998, s.55.
        """
        angles = self._values(q) @ self.coupling.T
        for label, drive, angle in self._each(angles):
            _check(ANGLE_OUT_OF_RANGE, label, np.degrees(angle), np.degrees(drive.angles))
        return np.stack([drive.pulses(angle) for _, drive, angle in self._each(angles)], axis=-1)

    def to_joints(self, pulses: ArrayLike) -> Array:
        """Joint angles at the pulses of the actuators, q = C⁻¹ φ with φᵢ = angleᵢ(Aᵢ), (..., n), rad.

        Args: pulses (..., n). Raises HelicoideError if a ball screw is too short or too long for its triangle.
        Source: Cerbaro 2022, fig. 20 and tab. 4; Campos 1998, s.55.
        """
        values = self._values(pulses)
        for label, drive, counted in self._each(values):
            _check(PULSES_OUT_OF_RANGE, label, counted, drive.pulses(drive.angles))
        angles = np.stack([drive.angle(counted) for _, drive, counted in self._each(values)], axis=-1)
        return np.asarray(angles @ self.inverse_coupling.T)

    def lengths(self, q: ArrayLike) -> Array:
        """Lengths of the ball screws at joint angles, (..., n), m; NaN for gears. Args: q (..., n), rad."""
        angles = self._values(q) @ self.coupling.T
        return np.stack(
            [
                drive.length(angle) if isinstance(drive, BallScrew) else np.full_like(angle, np.nan)
                for _, drive, angle in self._each(angles)
            ],
            axis=-1,
        )

    def description(self, q: ArrayLike) -> Text:
        """A sentence with the pulses and screw lengths at joint angles (n,), rad; or with the reason there are none."""
        try:
            counted = self.from_joints(q)
        except HelicoideError as error:
            return error.text
        told = [
            (SCREW_READING if length == length else GEAR_READING).format(
                label=label, n=round(float(n)), mm=1000 * length
            )
            for label, n, length in zip(self.labels, counted, self.lengths(q), strict=True)
        ]
        return ACTUATORS.format(told=join_texts(told))

    def _each(self, values: Array) -> list[tuple[str, Gear | BallScrew, Array]]:
        return list(zip(self.labels, self.drives, np.moveaxis(values, -1, 0), strict=True))

    def _values(self, given: ArrayLike) -> Array:
        values = np.atleast_1d(np.asarray(given, dtype=np.float64))
        if values.shape[-1] != len(self.joints) or not np.isfinite(values).all():
            raise HelicoideError(
                Text(
                    en="The actuators {labels} need {n} finite values, not {given}.",
                    pt_BR="Os atuadores {labels} precisam de {n} valores finitos, não {given}.",
                ).format(
                    labels=", ".join(self.labels),
                    n=len(self.joints),
                    given=np.array2string(values, separator=", ", threshold=6).replace("\n", ""),
                )
            )
        return values


def _sum(row: Array, joints: Sequence[str]) -> str:
    """A row of the coupling in words: "J2 + J3"."""
    terms = [
        f"{'+' if factor > 0 else '−'} {'' if abs(factor) == 1 else f'{abs(factor):g} '}{joint}"
        for factor, joint in zip(row, joints, strict=True)
        if factor
    ]
    return " ".join(terms).removeprefix("+ ")


def _check(refusal: Text, label: str, values: Array, ends: Array) -> None:
    """Raise the error if a value lies outside the ends by more than rounding."""
    low, high = sorted(ends.tolist())
    slack = ROUNDING * (high - low)
    given = np.atleast_1d(values)
    outside = given[(given < low - slack) | (given > high + slack)]
    if outside.size:
        raise HelicoideError(refusal.format(label=label, low=low, high=high, given=outside[0], unit=UNIT))
